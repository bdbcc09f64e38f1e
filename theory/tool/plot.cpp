// SPDX-License-Identifier: BSL-1.0
#include <stagecraft/tableaux/read_partitioned.hpp>
#include <stagecraft/tableaux/rounded.hpp>
#include <stagecraft/tableaux/tableau_from_file.hpp>
#include <stagecraft/theory/plot/coupled_region.hpp>
#include <stagecraft/theory/plot/method_data.hpp>
#include <stagecraft/theory/plot/region_tikz.hpp>
#include <stagecraft/theory/plot/tree_sheet.hpp>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
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
#include "whole_number.hpp"

namespace {

using namespace stagecraft;
namespace plot = theory::plot;

struct arguments {
    std::string kind, output, problem;
    std::vector<std::string> methods;
    std::vector<double> window;
    std::optional<double> implicit;
    tool::reading_options entries;
    bool script_only = false;
};

/// A script for gnuplot, or a picture that needs no other program.
using picture = std::variant<plot::script, std::string>;

bool is_tikz(const std::filesystem::path& output) { return output.extension() == ".tikz"; }

std::optional<plot::window> window_of(const arguments& a) {
    if (a.window.empty()) return std::nullopt;
    if (a.window.size() != 4) throw std::invalid_argument("window: needs LEFT,RIGHT,BOTTOM,TOP");
    const plot::window view{a.window[0], a.window[1], a.window[2], a.window[3]};
    plot::require_window(view);
    return view;
}

/// The stability function of the explicit part of an additive pair, the implicit one being at a fixed point.
plot::named_function coupled_function(const arguments& a, const tableaux::partitioned_file& file,
                                      const std::string& name) {
    char at[64];
    std::snprintf(at, sizeof at, ", implicit part at z = %g", a.implicit.value_or(0));
    return {(file.name.empty() ? name : file.name) + at,
            plot::coupled_stability_function(file, a.implicit.value_or(0))};
}

using anything = std::variant<plot::subject, plot::named_function>;

/// A method as it can be drawn: several tableaux have a stability function only.
anything read(const arguments& a, const tool::method_words& m) {
    if (tool::is_family(m.method)) {
        const auto [family, s] = tool::member_of_family(m.method, m.stages, 30);
        return plot::subject_of_family(family, s);
    }
    tool::require_no_stages(m.stages);
    const auto file = tableaux::read_method_file(m.method, a.entries.reading());
    const auto* several = std::get_if<tableaux::partitioned_file>(&file);
    const bool rosenbrock = several && several->coupling == tableaux::coupling::rosenbrock;
    if (rosenbrock && a.kind == "tableau")
        throw std::invalid_argument("kind: tableau is drawn of methods of one tableau");
    if (several && !rosenbrock) {
        if (a.kind != "region") throw std::invalid_argument("kind: of several tableaux only region is drawn");
        return coupled_function(a, *several, m.method);
    }
    plot::subject one = std::visit([](const auto& f) { return plot::subject_of_file(f); }, file);
    if (one.name.empty()) one.name = m.method;
    return one;
}

plot::named_function function_of(const anything& m) {
    if (const auto* pair = std::get_if<plot::named_function>(&m)) return *pair;
    const auto& one = std::get<plot::subject>(m);
    return {one.name, one.r};
}

/// The regions of all of them in one window; of one with zeros, poles and R in the title.
picture region_figure(const arguments& a, const std::vector<anything>& methods) {
    std::vector<plot::named_function> all;
    for (const auto& m : methods) all.push_back(function_of(m));
    plot::require_regions(all);
    const auto asked = window_of(a);
    const plot::window view = asked ? *asked : plot::common_window(all);
    if (is_tikz(a.output)) return {plot::regions_tikz(all, view)};
    if (all.size() > 1) return {plot::regions_picture(all, view)};
    const auto* one = std::get_if<plot::subject>(&methods[0]);
    return {plot::region_picture(all[0].name, all[0].r, view, one ? one->r_text : "")};
}

picture picture_of(const arguments& a, const plot::subject& m) {
    const std::optional<plot::window> view = window_of(a);
    if (a.kind == "order-star") {
        if (!m.order_star)
            throw std::invalid_argument(
                "order-star: the digits are too few to tell R from the exponential near 0");
        return {plot::order_star_picture(m.name, *m.order_star, view ? *view : m.order_star->natural_window(),
                                         m.r_text)};
    }
    if (view) throw std::invalid_argument("window: only region and order-star have one");
    if (a.kind == "E-polynomial") return {plot::e_polynomial_picture(m.name, m.r, m.e_polynomial, m.e_text)};
    return {plot::tableau_picture(m.name, m.tableau)};
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
plot::script error_figure(const arguments& a) {
    if (!a.window.empty()) throw std::invalid_argument("window: only region and order-star have one");
    std::vector<tool::named_method> all;
    for (const auto& m : tool::methods_of(a.methods)) all.push_back(runnable(m.method, m.stages));
    return tool::error_picture(all, a.problem.empty() ? "smooth" : a.problem);
}

/// plot trees N
picture tree_figure(const arguments& a) {
    if (!a.window.empty()) throw std::invalid_argument("window: only region and order-star have one");
    if (a.methods.size() != 1)
        throw std::invalid_argument("N: trees takes one number, the largest order, and no method");
    const auto sheet = plot::tree_sheet(tool::whole_number("N", a.methods[0], 1, plot::most_sheet_order));
    if (is_tikz(a.output)) return {plot::tikz(sheet)};
    if (std::filesystem::path(a.output).extension() == ".svg") return {plot::svg(sheet)};
    throw std::invalid_argument("output: '" + a.output +
                                "' must end in .svg or .tikz, which trees are written as");
}

picture picture_of(const arguments& a) {
    static constexpr std::array kinds{"region", "order-star", "E-polynomial", "tableau", "error", "trees"};
    if (std::find(kinds.begin(), kinds.end(), a.kind) == kinds.end())
        throw std::invalid_argument("kind: unknown '" + a.kind +
                                    "', allowed: region, order-star, E-polynomial, tableau, error, trees");
    if (!a.problem.empty() && a.kind != "error") throw std::invalid_argument("problem: only error has one");
    if (is_tikz(a.output) && a.kind != "region" && a.kind != "trees")
        throw std::invalid_argument("output: '" + a.output + "', only region and trees are written as .tikz");
    if (a.kind == "error") return {error_figure(a)};
    if (a.kind == "trees") return tree_figure(a);
    std::vector<anything> methods;
    for (const auto& m : tool::methods_of(a.methods)) methods.push_back(read(a, m));
    const bool pair = std::any_of(methods.begin(), methods.end(), [](const anything& m) {
        return std::holds_alternative<plot::named_function>(m);
    });
    if (a.implicit && !pair) throw std::invalid_argument("implicit: only an additive pair has that part");
    if (a.kind == "region") return region_figure(a, methods);
    if (methods.size() > 1) throw std::invalid_argument("METHOD: only region and error take several");
    return picture_of(a, std::get<plot::subject>(methods[0]));
}

void write(const std::string& text, const std::string& output) {
    std::ofstream out(output);
    if (!(out << text)) throw std::invalid_argument("output: cannot write " + output);
}

void run(const arguments& a) {
    const picture p = picture_of(a);
    if (const auto* text = std::get_if<std::string>(&p)) {
        if (a.script_only) throw std::invalid_argument("script: gnuplot does not draw this picture");
        return write(*text, a.output);
    }
    const auto& script = std::get<plot::script>(p);
    if (a.script_only) return write(script.text("picture.svg"), a.output);
    try {
        plot::draw(script, a.output);
    } catch (const plot::gnuplot_missing& e) {
        std::cerr << "stagecraft: " << e.what() << '\n';
        throw CLI::RuntimeError(2);
    }
}

const tool::command plot_command{[](CLI::App& app) {
    auto* sub = app.add_subcommand(
        "plot", "Draw methods (region, order-star, E-polynomial, tableau, error), or rooted trees");
    const auto a = std::make_shared<arguments>();
    sub->add_option("KIND", a->kind, "region, order-star, E-polynomial, tableau, error or trees")->required();
    sub->add_option(
           "METHOD", a->methods,
           "a family (see `families`) and its number of stages, `radau_iia 3` or `radau_iia:3`, or a tableau "
           "file; of region and error several; of trees the largest order")
        ->required()
        ->expected(1, -1);
    sub->add_option("--problem", a->problem, "of error: " + tool::error_problems() + " (default smooth)");
    sub->add_option("-o,--output", a->output,
                    "file to write: .svg, .png or .pdf; of region and trees also .tikz, to \\input in LaTeX")
        ->required();
    sub->add_option("-w,--window", a->window, "LEFT,RIGHT,BOTTOM,TOP in the complex plane")->delimiter(',');
    sub->add_option("--implicit", a->implicit,
                    "of an additive pair: where on the real axis the implicit part is (default 0)");
    a->entries.add_to(*sub);
    sub->add_flag("--script", a->script_only, "write the gnuplot script instead of the picture");
    sub->callback([a] { run(*a); });
}};

}  // namespace
