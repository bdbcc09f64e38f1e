// SPDX-License-Identifier: BSL-1.0
#include <iostream>
#include <stagecraft/tableaux/family.hpp>
#include <string>

#include "command.hpp"

namespace {

using namespace stagecraft::tableaux;

std::string_view nodes(family f) {
    switch (f) {
        case family::gauss:
            return "Gauss nodes";
        case family::radau_i:
        case family::radau_ia:
            return "Radau nodes with c_1 = 0";
        case family::radau_ii:
        case family::radau_iia:
            return "Radau nodes with c_s = 1";
        default:
            return "Lobatto nodes";
    }
}

std::string_view rule(family f) {
    switch (construction_of(f)) {
        case construction::collocation:
            return "collocation, C(s)";
        case construction::adjoint:
            return "D(s)";
        default:
            return "C(s-1), a_i1 = b_1";
    }
}

const stagecraft::tool::command families{[](CLI::App& app) {
    app.add_subcommand("families", "List the families: name, least number of stages, nodes, rule for A")
        ->callback([] {
            for (const family f : all_families) {
                std::cout << name(f) << std::string(14 - name(f).size(), ' ') << "s >= " << least_stages(f)
                          << "  " << nodes(f) << std::string(25 - nodes(f).size(), ' ') << rule(f) << '\n';
            }
        });
}};

}  // namespace
