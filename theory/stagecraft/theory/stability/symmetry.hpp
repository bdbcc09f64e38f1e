// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stagecraft/theory/stability/algebraic_stability.hpp"

namespace stagecraft::theory {

/// Conserves every quadratic invariant: M = 0 (Cooper; Sanz-Serna; Hairer-Lubich-Wanner, section IV.2). For
/// irreducible methods M = 0 is also necessary, so it is decided on the equivalent irreducible method.
template <class K>
verdict symplectic(const tableau<K>& t) {
    const auto r = reduced(t);
    const auto m = stability_matrix(r);
    const auto note = detail::reduction_note(t, r);
    for (Eigen::Index i = 0; i < m.rows(); ++i) {
        for (Eigen::Index j = 0; j <= i; ++j) {
            if (m(i, j) == K(0)) continue;
            return verdict::refuted("M[" + std::to_string(i + 1) + "][" + std::to_string(j + 1) +
                                    "] = " + m(i, j).str() + note);
        }
    }
    return verdict::proved("M = 0" + note);
}

namespace detail {

/// Extends sigma (stage i of the method = stage sigma[i] of its adjoint) by one stage at a time.
template <class K>
bool match_adjoint(const tableau<K>& t, std::vector<int>& sigma, std::vector<bool>& taken) {
    const int s = t.stages();
    const int i = static_cast<int>(sigma.size());
    if (i == s) return true;
    for (int k = 0; k < s; ++k) {
        if (taken[static_cast<std::size_t>(k)] || !(t.b[i] == t.b[k]) || !(t.c[i] + t.c[k] == K(1))) continue;
        sigma.push_back(k);
        taken[static_cast<std::size_t>(k)] = true;
        bool fits = true;
        for (int j = 0; j <= i && fits; ++j) {
            const int l = sigma[static_cast<std::size_t>(j)];
            fits = t.A(i, j) + t.A(k, l) == t.b[j] && t.A(j, i) + t.A(l, k) == t.b[i];
        }
        if (fits && match_adjoint(t, sigma, taken)) return true;
        taken[static_cast<std::size_t>(k)] = false;
        sigma.pop_back();
    }
    return false;
}

}  // namespace detail

/// The permutation sigma (0-based) with b_sigma(i) = b_i, c_i + c_sigma(i) = 1 and
/// a_ij + a_sigma(i)sigma(j) = b_j: the method equals its adjoint with the stages renumbered. Empty where
/// there is none. Distinct nodes leave one candidate; equal ones are searched with pruning.
template <class K>
std::optional<std::vector<int>> symmetry_permutation(const tableau<K>& t) {
    require_shape(t);
    std::vector<int> sigma;
    std::vector<bool> taken(static_cast<std::size_t>(t.stages()));
    if (!detail::match_adjoint(t, sigma, taken)) return {};
    return sigma;
}

/// Equal to its adjoint (Hairer-Norsett-Wanner I, section II.8). Decided on the equivalent irreducible
/// method, where different tableaux (up to numbering) are different methods.
template <class K>
verdict symmetric(const tableau<K>& t) {
    const auto r = reduced(t);
    const auto note = detail::reduction_note(t, r);
    const auto sigma = symmetry_permutation(r);
    if (sigma) {
        std::string order;
        for (const int k : *sigma) order += (order.empty() ? "" : ", ") + std::to_string(k + 1);
        return verdict::proved("equals its adjoint with stages numbered " + order + note);
    }
    const int s = r.stages();
    for (int i = 0; i < s; ++i) {  // the simplest witness: a node or weight without a mirror image
        bool mirrored = false;
        for (int k = 0; k < s; ++k) mirrored = mirrored || (r.c[i] + r.c[k] == K(1) && r.b[i] == r.b[k]);
        if (!mirrored) {
            return verdict::refuted("no stage mirrors c = " + r.c[i].str() + ", b = " + r.b[i].str() + note);
        }
    }
    return verdict::refuted("a_ij + a_sigma(i)sigma(j) = b_j for no numbering sigma" + note);
}

}  // namespace stagecraft::theory
