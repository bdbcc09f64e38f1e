// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <concepts>
#include <sstream>
#include <stagecraft/theory/statements/expression.hpp>
#include <stagecraft/theory/statements/expression_text.hpp>
#include <stagecraft/theory/statements/verdict.hpp>
#include <stagecraft/theory/trees/tree_order.hpp>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace stagecraft::theory {

/// A named conjunction of equations, with the places in the literature that state it.
template <class... Equations>
struct statement {
    std::string_view title;
    int parameter;  ///< the p of B(p); negative for none
    std::string_view citation;
    std::tuple<Equations...> equations;
};

/// A statement of the given equations; `parameter` as in B(p), negative for none.
template <class... Equations>
constexpr auto make_statement(std::string_view title, int parameter, std::string_view citation,
                              Equations... equations) {
    return statement<Equations...>{title, parameter, citation, {equations...}};
}

/// Name with parameter: "B(5)", "row sums".
template <class... E>
std::string name(const statement<E...>& s) {
    return std::string(s.title) + (s.parameter < 0 ? "" : "(" + std::to_string(s.parameter) + ")");
}

/// "B(2): dot(b, one) == 1; dot(b, c) == 1/2  [Butcher 1964; ...]".
template <class... E>
std::string text(const statement<E...>& s) {
    std::string all;
    std::apply([&](const auto&... e) { ((all += (all.empty() ? "" : "; ") + text(e)), ...); }, s.equations);
    return name(s) + ": " + (all.empty() ? "nothing" : all) + "  [" + std::string(s.citation) + "]";
}

/// The equations as an `aligned` block for math mode, the citation as its comment line.
template <class... E>
std::string latex(const statement<E...>& s) {
    std::string all;
    std::apply([&](const auto&... e) { ((all += (all.empty() ? "  &" : " \\\\\n  &") + latex(e)), ...); },
               s.equations);
    return "% " + name(s) + " [" + std::string(s.citation) + "]\n\\begin{aligned}\n" + all +
           "\n\\end{aligned}";
}

/// Whether an equation holds exactly in a model over an exact field; `constexpr` for models that are.
/// Over rounded scalars it does not compile: use `failures` with a criterion there.
template <class L, class R, stage_algebra M>
constexpr bool holds(const equation<L, R>& e, const M& m) {
    bool all = true;
    for_each_residual(e, m, [&all](const scalar_of<M>& r) { all = all && !not_zero{}(r); });
    return all;
}

/// Whether all equations of a statement hold exactly.
template <class... E, stage_algebra M>
constexpr bool holds(const statement<E...>& s, const M& m) {
    return std::apply([&m](const auto&... e) { return (holds(e, m) && ...); }, s.equations);
}

/// A residual that does not vanish: of which equation, and which component of it (0 for numbers; for vectors
/// the coefficient in the model, counted on through the basis for equations "for all u, v").
template <class K>
struct equation_residual {
    std::string equation;
    int component;
    K residual;
};

/// The residuals for which `fails(residual)`, by default those that certainly differ from zero.
template <class... E, stage_algebra M, class Fails = certainly_fails>
std::vector<equation_residual<scalar_of<M>>> failures(const statement<E...>& s, const M& m,
                                                      Fails fails = {}) {
    std::vector<equation_residual<scalar_of<M>>> all;
    const auto look = [&](const auto& e) {
        int component = 0;
        for_each_residual(e, m, [&](const scalar_of<M>& r) {
            if (fails(r)) all.push_back({text(e), component, r});
            ++component;
        });
    };
    std::apply([&](const auto&... e) { (look(e), ...); }, s.equations);
    return all;
}

/// Proves or refutes a statement over an exact field; the witness of a refutation is the first equation that
/// fails, with its residual left - right.
template <class... E, stage_algebra M>
requires exact_scalar<scalar_of<M>> verdict prove(const statement<E...>& s, const M& m) {
    const auto failing = failures(s, m);
    if (failing.empty()) return verdict::proved(name(s) + " by exact evaluation");
    std::ostringstream witness;
    witness << failing[0].equation << " leaves " << failing[0].residual;
    if (failing.size() > 1) witness << ", and " << failing.size() - 1 << " more residuals do not vanish";
    return verdict::refuted(witness.str());
}

}  // namespace stagecraft::theory
