// SPDX-License-Identifier: BSL-1.0
#include <stagecraft/tableaux/read_partitioned.hpp>
#include <stagecraft/tableaux/rounded.hpp>
#include <stagecraft/tableaux/tableau_from_file.hpp>
#include <stagecraft/theory/plot/coupled_region.hpp>
#include <stagecraft/theory/plot/method_data.hpp>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "command.hpp"
#include "error_picture.hpp"
#include "method_argument.hpp"
#include "reading_options.hpp"

namespace {

using namespace stagecraft;
namespace plot = theory::plot;

struct arguments {
    std::string kind, method, stages, output, problem;
    std::vector<std::string> methods;
    std::vector<double> window;
    std::optional<double> implicit;
    tool::reading_options entries;
    bool script_only = false;
};

std::optional<plot::window> window_of(const arguments& a) {
    if (a.window.empty()) return std::nullopt;
    if (a.window.size() != 4) throw std::invalid_argument("window: needs LEFT,RIGHT,BOTTOM,TOP");
    const plot::window view{a.window[0], a.window[1], a.window[2], a.window[3]};
    plot::require_window(view);
    return view;
}

/// The region of the explicit part of an additive pair, the implicit one being at a fixed point.
plot::script coupled_picture(const arguments& a, const tableaux::partitioned_file& file) {
    if (a.kind != "region") throw std::invalid_argument("kind: of several tableaux only region is drawn");
    const double z = a.implicit.value_or(0);
    const auto r = plot::coupled_stability_function(file, z);
    const auto view = window_of(a);
    char at[64];
    std::snprintf(at, sizeof at, "explicit part, implicit part at z = %g", z);
    return plot::region_picture(file.name, r, view ? *view : plot::region_window(r), at);
}

plot::script picture_of(const arguments& a, const plot::subject& m) {
    if (a.implicit) throw std::invalid_argument("implicit: only an additive pair has that part");
    const std::optional<plot::window> view = window_of(a);
    if (a.kind == "region")
        return plot::region_picture(m.name, m.data.r, view ? *view : plot::region_window(m.data.r), m.r_text);
    if (a.kind == "order-star")
        return plot::order_star_picture(m.name, m.data, view ? *view : m.data.natural_window(), m.r_text);
    if (view) throw std::invalid_argument("window: only region and order-star have one");
    if (a.kind == "E-polynomial")
        return plot::e_polynomial_picture(m.name, m.data.r, m.e_polynomial, m.e_text);
    if (a.kind == "tableau") return plot::tableau_picture(m.name, m.tableau);
    throw std::invalid_argument("kind: unknown '" + a.kind +
                                "', allowed: region, order-star, E-polynomial, tableau, error");
}

plot::script picture_of_family(const arguments& a) {
    const auto [family, s] = tool::member_of_family(a.method, a.stages, 30);
    return picture_of(a, plot::subject_of_family(family, s));
}

plot::script picture_of_file(const arguments& a) {
    tool::require_no_stages(a.stages);
    const auto file = tableaux::read_method_file(a.method, a.entries.reading());
    if (const auto* several = std::get_if<tableaux::partitioned_file>(&file))
        return coupled_picture(a, *several);
    return picture_of(a, plot::subject_of_file(std::get<tableaux::tableau_file>(file)));
}

tool::named_method runnable(const std::string& method, const std::string& stages) {
    if (tool::is_family(method)) {
        const auto [family, s] = tool::member_of_family(method, stages, 20);
        return {method + ", s = " + stages, tableaux::rounded<double>(family, s)};
    }
    const auto file = tableaux::read_method_file(method);
    const auto* one = std::get_if<tableaux::tableau_file>(&file);
    if (!one) throw std::invalid_argument(method + ": error is drawn of methods of one tableau");
    return {one->name.empty() ? method : one->name, tableaux::rounded<double>(*one)};
}

/// METHOD [S] METHOD [S] ...
plot::script error_picture(const arguments& a) {
    if (!a.window.empty()) throw std::invalid_argument("window: only region and order-star have one");
    std::vector<tool::named_method> all;
    for (std::size_t k = 0; k < a.methods.size(); ++k) {
        const std::string method = a.methods[k];
        const bool counted = tool::is_family(method) && k + 1 < a.methods.size();
        all.push_back(runnable(method, counted ? a.methods[++k] : ""));
    }
    return tool::error_picture(all, a.problem.empty() ? "smooth" : a.problem);
}

plot::script picture_of(arguments a) {
    if (a.kind == "error") return error_picture(a);
    if (!a.problem.empty()) throw std::invalid_argument("problem: only error has one");
    if (a.methods.size() > 2) throw std::invalid_argument("METHOD: only error takes several");
    a.method = a.methods[0];
    if (a.methods.size() > 1) a.stages = a.methods[1];
    return tool::is_family(a.method) ? picture_of_family(a) : picture_of_file(a);
}

void run(const arguments& a) {
    const plot::script picture = picture_of(a);
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
    auto* sub =
        app.add_subcommand("plot", "Draw a method: region, order-star, E-polynomial, tableau or error");
    const auto a = std::make_shared<arguments>();
    sub->add_option("KIND", a->kind, "region, order-star, E-polynomial, tableau or error")->required();
    sub->add_option("METHOD", a->methods,
                    "a family (see `families`) and its number of stages, or a tableau file; of error several")
        ->required()
        ->expected(1, -1);
    sub->add_option("--problem", a->problem, "of error: " + tool::error_problems() + " (default smooth)");
    sub->add_option("-o,--output", a->output, "file to write: .svg, .png or .pdf")->required();
    sub->add_option("-w,--window", a->window, "LEFT,RIGHT,BOTTOM,TOP in the complex plane")->delimiter(',');
    sub->add_option("--implicit", a->implicit,
                    "of an additive pair: where on the real axis the implicit part is (default 0)");
    a->entries.add_to(*sub);
    sub->add_flag("--script", a->script_only, "write the gnuplot script instead of the picture");
    sub->callback([a] { run(*a); });
}};

}  // namespace
