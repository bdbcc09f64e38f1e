// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <stagecraft/tableaux/claims.hpp>
#include <stagecraft/tableaux/reading.hpp>
#include <stagecraft/tableaux/rough_ball.hpp>
#include <stagecraft/theory/judging/file_certificate.hpp>
#include <stagecraft/theory/judging/judge_claims.hpp>
#include <stagecraft/theory/judging/subject.hpp>
#include <string>
#include <utility>
#include <vector>

namespace stagecraft::theory {

/// An entry and the value that would restore every claim.
template <class K>
struct repair {
    theory::place place;
    K value;
};

namespace detail {

/// The elementary weight of one row of the table, minus 1/gamma.
template <class K, class Weights>
K residual_of_row(const subject<K>& s, const Weights& weights, const tree_view& trees, std::uint32_t row) {
    const matrix_model<K> model(s.t, weights);
    const auto vector = [&](const auto& self, std::uint32_t i) -> typename matrix_model<K>::element {
        const tree_row& t = trees.rows[i];
        if (t.order == 1) return model.one();
        return model.multiply(self(self, t.left), model.apply(self(self, t.right)));
    };
    return (model.dot_b(vector(vector, row)) * K(trees.rows[row].density) - K(1)) /
           K(trees.rows[row].density);
}

/// The first order condition up to `most` that, as a function of one entry, is affine and not constant:
/// judged from its residuals with the entry set to 0, 1 and 2.
template <class K, class Weights>
std::optional<std::uint32_t> affine_condition(const std::array<subject<K>, 3>& probes, Weights weights,
                                              const tree_view& trees, int most) {
    const std::array<matrix_model<K>, 3> models{matrix_model<K>(probes[0].t, weights(probes[0])),
                                                matrix_model<K>(probes[1].t, weights(probes[1])),
                                                matrix_model<K>(probes[2].t, weights(probes[2]))};
    std::array<tree_weights<matrix_model<K>>, 3> walks{tree_weights<matrix_model<K>>(models[0], trees, most),
                                                       tree_weights<matrix_model<K>>(models[1], trees, most),
                                                       tree_weights<matrix_model<K>>(models[2], trees, most)};
    while (walks[0].advance() && walks[1].advance() && walks[2].advance())
        for (std::size_t i = 0; i < walks[0].weights().size(); ++i) {
            const K step = walks[1].weights()[i] - walks[0].weights()[i];
            const K bend = walks[2].weights()[i] - walks[1].weights()[i] - step;
            if (certainly_nonzero(step) && !certainly_nonzero(bend))
                return walks[0].first_row() + static_cast<std::uint32_t>(i);
        }
    return std::nullopt;
}

/// What determines the value of an entry, given all others.
struct determination {
    enum class kind { row_sum, node_quadrature, order_condition, embedded_condition, stiff_accuracy } by;
    std::uint32_t tree = 0;  ///< row of the table, for conditions
};

template <class K>
const auto& weights_of(const subject<K>& s, determination::kind by) {
    using vector = Eigen::Matrix<K, Eigen::Dynamic, 1>;
    const vector& b = s.t.b;
    const vector& b_embedded = s.t.b_embedded;
    return by == determination::kind::embedded_condition ? b_embedded : b;
}

/// The statement that determines the entry: its row sum where the nodes are claimed to be row sums, else the
/// first order condition of b, of b_embedded, else stiff accuracy. Each is affine in the entry, so at most
/// one value satisfies it.
template <class K>
std::optional<determination> determined_by(const subject<K>& s, const place& p,
                                           const tableaux::claims& claims, const tree_view& trees) {
    using kind = determination::kind;
    if (claims_row_sums(s, claims) && (p.part == part::A || p.part == part::c))
        return determination{kind::row_sum};
    if (p.part == part::c) {  // only non-autonomous problems see it, first by b^T c = 1/2
        if (claims.order.value_or(0) < 2 || !certainly_nonzero(s.t.b(p.row))) return std::nullopt;
        return determination{kind::node_quadrature};
    }
    std::array<subject<K>, 3> probes{s, s, s};
    for (int x = 0; x < 3; ++x) put(probes[static_cast<std::size_t>(x)], p, K(x));
    for (const auto& [by, claimed] : {std::pair(kind::order_condition, claims.order),
                                      std::pair(kind::embedded_condition, claims.embedded_order)}) {
        if (claimed.value_or(0) < 1 || (p.part == part::b && by == kind::embedded_condition) ||
            (p.part == part::b_embedded && by == kind::order_condition))
            continue;
        const auto weights = [by = by](const subject<K>& x) -> const auto& { return weights_of(x, by); };
        if (const auto row = affine_condition(probes, weights, trees, *claimed))
            return determination{by, *row};
    }
    const bool last_row = p.part == part::A && p.row == s.stages() - 1;
    if (claims.stiffly_accurate.value_or(false) && (last_row || p.part == part::b))
        return determination{kind::stiff_accuracy};
    return std::nullopt;
}

/// The value that the statement gives the entry; empty where an enclosure cannot divide.
template <class K>
std::optional<K> determined_value(const subject<K>& s, const place& p, const determination& d,
                                  const tree_view& trees) {
    using kind = determination::kind;
    if (d.by == kind::stiff_accuracy)
        return p.part == part::A ? s.t.b(p.column) : s.t.A(s.stages() - 1, p.row);
    subject<K> changed = s;
    put(changed, p, K(0));
    if (d.by == kind::row_sum) {
        const K defect = row_sum_defects(changed)[static_cast<std::size_t>(p.row)];
        return p.part == part::c ? defect : -defect;
    }
    if (d.by == kind::node_quadrature) {
        K twice = K(1);
        for (int i = 0; i < s.stages(); ++i) twice = twice - K(2) * changed.t.b(i) * changed.t.c(i);
        return twice / (K(2) * s.t.b(p.row));
    }
    const K at_zero = residual_of_row(changed, weights_of(changed, d.by), trees, d.tree);
    put(changed, p, K(1));
    const K slope = residual_of_row(changed, weights_of(changed, d.by), trees, d.tree) - at_zero;
    if (!certainly_nonzero(slope)) return std::nullopt;
    return -at_zero / slope;
}

}  // namespace detail

/// Single entries, among `candidates`, whose change alone restores every claim, with their repaired values.
/// For each entry the claims leave at most one value possible (row sums and the lower order conditions are
/// affine in it); that value is put in and every claim is judged again. Over exact fields all of this is done
/// modulo 2^61 - 1 first, which throws out wrong candidates in microseconds, and then exactly; enclosures of
/// many digits come after those of a few.
template <class K>
std::vector<repair<K>> find_repairs(const subject<K>& s, const tableaux::claims& claims,
                                    const std::vector<place>& candidates) {
    std::vector<repair<K>> repairs;
    const bool row_sums = !s.nodes_given || mostly_row_sums(s);
    const tree_table table(std::max({claims.order.value_or(1), claims.embedded_order.value_or(1), 1}));
    const tree_view& trees = table.view();
    const auto try_in = [&](auto probe, const place& p, const detail::determination& d) {
        const auto value = detail::determined_value(probe, p, d, trees);
        if (!value) return false;
        put(probe, p, *value);
        return !refutes_a_condition(probe, claims, row_sums);
    };
    const auto residues = exact_scalar<K> ? reduced_modulo_prime(s) : std::nullopt;
    subject<tableaux::rough_ball> rough;
    if constexpr (!exact_scalar<K>)
        rough = mapped<tableaux::rough_ball>(s, [](const K& x) { return tableaux::rough_ball(x); });
    for (const place& p : candidates) {
        tableaux::time_share::check_now();
        const auto d = residues ? detail::determined_by(*residues, p, claims, trees)
                                : detail::determined_by(s, p, claims, trees);
        if (!d || (residues && !try_in(*residues, p, *d))) continue;
        auto value = detail::determined_value(s, p, *d, trees);
        if (!value) continue;
        if (!certainly_nonzero(*value - value_at(s, p))) continue;  // nothing to repair
        if constexpr (!exact_scalar<K>) {
            auto probe = rough;
            put(probe, p, tableaux::rough_ball(*value));
            if (refutes_a_condition(probe, claims, row_sums)) continue;
        }
        subject<K> changed = s;
        put(changed, p, *value);
        if (!refutes_a_claim(changed, claims, row_sums)) repairs.push_back({p, std::move(*value)});
    }
    return repairs;
}

/// The rational with the smallest denominator in the interval.
tableaux::rational simplest_in(const tableaux::range& r);

namespace detail {

/// The repaired value as text: exactly; or, for an enclosure, with the digits that the entry had, or the
/// simplest fraction inside where the entry was one and the enclosure leaves hardly another.
inline std::string suggestion(const tableaux::rational& x, const tableaux::entry&) { return x.str(); }
inline std::string suggestion(const tableaux::quadratic& x, const tableaux::entry&) { return x.str(); }
std::string suggestion(const tableaux::ball& x, const tableaux::entry& old);

/// Edit distance with a swap of neighbours counting one: how a misprint differs from what it should be.
int misprint_distance(const std::string& x, const std::string& y);

/// Whether the change from the entry to `value` is at the level of rounding.
bool only_rounding(const tableaux::tableau_file& file, const place& p, const tableaux::range& value,
                   bool rounded_fractions);
inline tableaux::range range_of(const tableaux::ball& x) { return to_range(x); }
inline tableaux::range range_of(const tableaux::quadratic& x) { return tableaux::to_range(x); }

/// Appends the repairs as suspects, but those at the level of rounding; whether there were such.
template <class K>
bool append_suspects(const tableaux::tableau_file& file, const std::vector<repair<K>>& repairs,
                     std::vector<suspect>& suspects) {
    const bool rounded_fractions = tableaux::has_rounded_fractions(file);
    bool dropped = false;
    for (const auto& [p, value] : repairs) {
        const auto& old = entry_at(file, p);
        if (only_rounding(file, p, range_of(value), rounded_fractions)) {
            dropped = true;
            continue;
        }
        suspects.push_back({p.name(), old.text, suggestion(value, old)});
    }
    return dropped;
}

/// A decimal as sign, digits and exponent, so that 1.25e-1, .125 and 0.1250 differ in nothing; anything else as it is.
std::string without_notation(const std::string& text);

/// The likelier misprint first: not a lone zero, then the smaller difference in print.
void rank(std::vector<suspect>& suspects);

/// Whether a changed tableau keeps every claim.
template <class K>
bool keeps_claims(const subject<K>& changed, const tableaux::claims& claims) {
    const bool row_sums = changed.nodes_given;
    if constexpr (exact_scalar<K>) {  // a residue says no at once
        const auto quick = reduced_modulo_prime(changed);
        if (quick && refutes_a_condition(*quick, claims, row_sums)) return false;
    } else {
        const auto quick =
            mapped<tableaux::rough_ball>(changed, [](const K& x) { return tableaux::rough_ball(x); });
        if (refutes_a_condition(quick, claims, row_sums)) return false;
    }
    return !refutes_a_claim(changed, claims, row_sums);
}

/// What is said of several single faults, each of which explains everything, and of none but rounding.
inline constexpr const char* several_repairs =
    "any one of these changes restores every claim; the claims do not tell which is meant";
inline constexpr const char* undone = ": undone, every claim is restored";
inline const std::string only_rounding_fails =
    std::string("what fails is at the level of rounding: no entry is suspected; ") + larger_errors;

}  // namespace detail

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/suspects-inl.hpp"
#endif
