// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <optional>
#include <stagecraft/theory/judging/judge_rosenbrock.hpp>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// Which entry of a Rosenbrock method may be wrong, and what it should be.

namespace stagecraft::theory::detail {

/// An entry of one of the tableaux.
struct coupled_place {
    std::size_t partner = 0;
    theory::place place;
};

template <class K>
void put(coupled_subject<K>& s, const coupled_place& p, const K& value) {
    theory::put(s.partners[p.partner], p.place, value);
    const bool shared = p.place.part == part::c && s.nystrom();
    if (shared) theory::put(s.partners[1 - p.partner], p.place, value);
    const bool gamma = s.rosenbrock() && s.file->one_gamma && p.partner == 1 && p.place.part == part::A &&
                       p.place.row == p.place.column;
    for (int i = 0; gamma && i < s.stages(); ++i) theory::put(s.partners[1], {part::A, i, i}, value);
}

/// The entries of a Rosenbrock method that its kind leaves free.
std::vector<coupled_place> rosenbrock_places(const tableaux::partitioned_file& file);

/// As the file calls it: "Gamma[3][1]", "C[3][1]", "gamma", "m[2]", "e[1]", "d[4]".
std::string rosenbrock_name(const coupled_place& p, const tableaux::partitioned_file& file);

/// The defects of the conditions of a question with the entry set to x.
template <class K>
std::vector<K> defects_with(const coupled_subject<K>& s, const coupled_place& p, const K& x,
                            const rosenbrock_question& q, const rosenbrock_trees& trees) {
    coupled_subject<K> probe = s;
    put(probe, p, x);
    const auto m = rosenbrock_of(probe);
    std::vector<K> defects;
    visit_rosenbrock_trees(m, q.embedded ? m.b_embedded : m.b, trees,
                           [&](std::uint32_t row, const K& weight) {
                               const auto& t = trees.rows()[row];
                               defects.push_back(weight * K(t.density) - K(trees.is_zero(t) ? 0 : 1));
                               return true;
                           });
    return defects;
}

/// The value that the first condition, of those claimed, leaves possible that is affine in the entry and not constant, which the quick
/// subject finds. Of c and d the row sum; nothing where there is none.
template <class K, class Quick>
std::optional<K> rosenbrock_value(const coupled_subject<K>& s, const Quick& quick, const coupled_place& p) {
    if (p.place.part == part::c) {
        const auto i = static_cast<std::size_t>(p.place.row);
        return K(value_at(s.partners[p.partner], p.place) +
                 row_sum_defects(with_row_sums(s, rosenbrock_of(s), p.partner))[i]);
    }
    for (const auto& q : questions_of(*s.file)) {
        const bool other = (p.place.part == part::b_embedded) != q.embedded;
        if (other || q.which == rosenbrock_conditions::index_1 || q.claimed.value_or(0) < 1) continue;
        const rosenbrock_trees trees(q.which, *q.claimed);
        using Q = std::remove_cvref_t<decltype(quick.partners[0].t.b(0))>;
        std::array<std::vector<Q>, 3> at;
        for (int x = 0; x < 3; ++x) at[static_cast<std::size_t>(x)] = defects_with(quick, p, Q(x), q, trees);
        for (std::size_t k = 0; k < at[0].size(); ++k) {
            const Q step = at[1][k] - at[0][k], bend = at[2][k] - at[1][k] - step;
            if (!certainly_nonzero(step) || certainly_nonzero(bend)) continue;
            const K zero = defects_with(s, p, K(0), q, trees)[k];
            const K slope = defects_with(s, p, K(1), q, trees)[k] - zero;
            if (!certainly_nonzero(slope)) return std::nullopt;
            return K(-zero / slope);
        }
    }
    return std::nullopt;
}

}  // namespace stagecraft::theory::detail

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/rosenbrock_suspects-inl.hpp"
#endif
