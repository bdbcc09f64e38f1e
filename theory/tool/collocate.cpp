// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "command.hpp"
#include "embedded_collocation.hpp"
#include "given_nodes.hpp"
#include "tableau_text.hpp"

namespace {

using namespace stagecraft;

struct request {
    std::string nodes;
    std::string polynomial;
    std::string embedded;
    std::string format = "text";
    bool json = false;
};

void print(const tableaux::decimal_tableau& t, const std::optional<tool::embedded_method>& e) {
    if (!e) return tool::print_text(t);
    tool::print_text(tool::with_stage(t, *e));
    std::cout << "embedded weights:";
    for (const auto& b : e->b) std::cout << ' ' << b;
    std::cout << '\n';
}

nlohmann::ordered_json as_json(const tableaux::nodal_polynomial& w, const tableaux::decimal_tableau& t,
                               const theory::certificate& certificate,
                               const std::optional<tool::embedded_method>& e, const std::string& said) {
    auto out = tool::to_json(w, e ? tool::with_stage(t, *e) : t, certificate);
    if (!e) {
        if (!said.empty()) out["embedded_note"] = said;
        return out;
    }
    auto& file = out["tableau"];
    file["b_embedded"] = e->b;
    file["claims"]["embedded_order"] = std::min(e->order, 14);
    auto alone = tool::file_of(tool::with_stage(t, *e), *e, file["name"]);
    out["embedded_note"] = e->why;  // an ordered object is a vector: `file` is gone now
    out["embedded_tableau"] = std::move(alone);
    return out;
}

void run(const request& r) {
    if (r.nodes.empty() == r.polynomial.empty())
        throw std::invalid_argument("collocate: give either --nodes or --polynomial");
    if (r.format != "text" && r.format != "json")
        throw std::invalid_argument("--format: unknown '" + r.format + "', allowed: text, json");
    const auto w =
        r.nodes.empty() ? tool::nodes_from_polynomial(r.polynomial) : tool::nodes_from_list(r.nodes);
    const auto t = tool::written(w);
    const auto certificate = theory::certify(w, tableaux::construction::collocation);
    std::string said;
    std::optional<tool::embedded_method> e;
    if (!r.embedded.empty()) e = tool::embedded_of(w, r.embedded, said);
    if (r.json || r.format == "json") {
        std::cout << as_json(w, t, certificate, e, said).dump(2) << '\n';
    } else {
        print(t, e);
        std::cout << certificate.text();
        if (e) std::cout << "  embedded: " << e->why << '\n';
        if (!said.empty()) std::cout << "  embedded: " << said << '\n';
    }
    if (!said.empty()) throw CLI::RuntimeError(1);
}

const tool::command collocate{[](CLI::App& app) {
    const auto r = std::make_shared<request>();
    auto* sub =
        app.add_subcommand("collocate", "Tableau and certificate of the collocation method on given nodes");
    sub->add_option("--nodes", r->nodes, "distinct exact nodes in [0, 1]: 0,1/3,1 or 0.5,1.0");
    sub->add_option("--polynomial", r->polynomial, "or the polynomial in x whose roots they are");
    sub->add_option(
        "--embedded", r->embedded,
        "embedded weights: highest (of the highest order that differs from the method, with f(t_0, y_0)) "
        "or l-stable; exit code 1 where there are none");
    sub->add_option("--format", r->format, "text (default) or json");
    sub->add_flag("--json", r->json, "the same as --format json");
    sub->callback([r] { run(*r); });
}};

}  // namespace
