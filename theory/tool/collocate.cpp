// SPDX-License-Identifier: BSL-1.0
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>

#include "command.hpp"
#include "given_nodes.hpp"
#include "tableau_text.hpp"

namespace {

using namespace stagecraft;

struct request {
    std::string nodes;
    std::string polynomial;
    bool json = false;
};

void run(const request& r) {
    if (r.nodes.empty() == r.polynomial.empty())
        throw std::invalid_argument("collocate: give either --nodes or --polynomial");
    const auto w =
        r.nodes.empty() ? tool::nodes_from_polynomial(r.polynomial) : tool::nodes_from_list(r.nodes);
    const auto t = tool::written(w);
    const auto certificate = theory::certify(w, tableaux::construction::collocation);
    if (!r.json) {
        tool::print_text(t);
        std::cout << certificate.text();
        return;
    }
    std::cout << tool::to_json(w, t, certificate).dump(2) << '\n';
}

const tool::command collocate{[](CLI::App& app) {
    const auto r = std::make_shared<request>();
    auto* sub =
        app.add_subcommand("collocate", "Tableau and certificate of the collocation method on given nodes");
    sub->add_option("--nodes", r->nodes, "distinct exact nodes in [0, 1]: 0,1/3,1 or 0.5,1.0");
    sub->add_option("--polynomial", r->polynomial, "or the polynomial in x whose roots they are");
    sub->add_flag("--json", r->json, "print JSON instead of text");
    sub->callback([r] { run(*r); });
}};

}  // namespace
