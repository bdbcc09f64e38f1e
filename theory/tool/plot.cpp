// SPDX-License-Identifier: BSL-1.0
#include <stagecraft/theory/plot/method_data.hpp>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "command.hpp"

namespace {

using namespace stagecraft;
namespace plot = theory::plot;

struct arguments {
    std::string kind, method, stages, output;
    std::vector<double> window;
    bool script_only = false;
};

/// A file where one is named or exists, a family otherwise.
plot::subject subject_of(const arguments& a) {
    const bool file = a.method.ends_with(".json") || std::filesystem::exists(a.method);
    if (file) {
        if (!a.stages.empty()) throw std::invalid_argument("stages: a tableau file has its own number");
        return plot::subject_of_file(tableaux::read_tableau_file(a.method));
    }
    const auto family = tableaux::family_from_name(a.method);
    if (a.stages.empty()) throw std::invalid_argument("stages: the family " + a.method + " needs S");
    return plot::subject_of_family(family, tool::whole_number("stages", a.stages, 1, 30));
}

plot::script picture_of(const arguments& a, const plot::subject& m) {
    std::optional<plot::window> view;
    if (!a.window.empty()) {
        if (a.window.size() != 4) throw std::invalid_argument("window: needs LEFT,RIGHT,BOTTOM,TOP");
        view = plot::window{a.window[0], a.window[1], a.window[2], a.window[3]};
        plot::require_window(*view);
    }
    if (a.kind == "region")
        return plot::region_picture(m.name, m.data.r, view ? *view : plot::region_window(m.data.r), m.r_text);
    if (a.kind == "order-star")
        return plot::order_star_picture(m.name, m.data, view ? *view : m.data.natural_window(), m.r_text);
    if (view) throw std::invalid_argument("window: only region and order-star have one");
    if (a.kind == "E-polynomial")
        return plot::e_polynomial_picture(m.name, m.data.r, m.e_polynomial, m.e_text);
    if (a.kind == "tableau") return plot::tableau_picture(m.name, m.tableau);
    throw std::invalid_argument("kind: unknown '" + a.kind +
                                "', allowed: region, order-star, E-polynomial, tableau");
}

void run(const arguments& a) {
    const plot::script picture = picture_of(a, subject_of(a));
    if (a.script_only) {
        std::ofstream out(a.output);
        if (!(out << picture.text("picture.svg")))
            throw std::invalid_argument("output: cannot write " + a.output);
        return;
    }
    try {
        plot::draw(picture, a.output);
    } catch (const plot::gnuplot_missing& e) {
        std::cerr << "stagecraft: " << e.what() << '\n';
        throw CLI::RuntimeError(2);
    }
}

const tool::command plot_command{[](CLI::App& app) {
    auto* sub = app.add_subcommand("plot", "Draw a method: region, order-star, E-polynomial or tableau");
    const auto a = std::make_shared<arguments>();
    sub->add_option("KIND", a->kind, "region, order-star, E-polynomial or tableau")->required();
    sub->add_option("METHOD", a->method, "a family (see `families`) or a tableau file")->required();
    sub->add_option("S", a->stages, "number of stages of the family's member");
    sub->add_option("-o,--output", a->output, "file to write: .svg, .png or .pdf")->required();
    sub->add_option("-w,--window", a->window, "LEFT,RIGHT,BOTTOM,TOP in the complex plane")->delimiter(',');
    sub->add_flag("--script", a->script_only, "write the gnuplot script instead of the picture");
    sub->callback([a] { run(*a); });
}};

}  // namespace
