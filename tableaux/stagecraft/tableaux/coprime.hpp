// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <stdexcept>
#include <vector>

#include "stagecraft/tableaux/polynomial.hpp"
#include "stagecraft/tableaux/residue.hpp"

namespace stagecraft::tableaux {

namespace detail {

template <class K>
std::optional<polynomial<residue>> residue_of(const polynomial<K>& p) {
    std::vector<residue> images;
    for (const K& a : p.coefficients()) {
        const auto image = tableaux::residue_of(a);
        if (!image) return {};
        images.push_back(*image);
    }
    return polynomial<residue>(std::move(images));
}

}  // namespace detail

/// True only where p and q have no common root, shown by Euclid's algorithm modulo 2^61 - 1: a common factor
/// of p and q would divide both images, as long as the leading coefficient of p keeps an inverse. False means
/// "not shown". Costs O(deg^2) word operations, where Euclid's algorithm over the field meets fractions
/// thousands of digits long.
template <class K>
requires requires(const K& a) { residue_of(a); }
bool coprime_by_residues(const polynomial<K>& p, const polynomial<K>& q) {
    if (p.is_zero() || q.is_zero()) return false;
    if (p.degree() == 0 || q.degree() == 0) return true;
    auto a = detail::residue_of(p), b = detail::residue_of(q);
    if (!a || !b || a->degree() < p.degree()) return false;
    try {
        static_cast<void>(residue(1) / a->leading());
        return gcd(*a, *b).degree() == 0;
    } catch (const std::domain_error&) {  // the leading coefficient vanishes modulo p
        return false;
    }
}

}  // namespace stagecraft::tableaux
