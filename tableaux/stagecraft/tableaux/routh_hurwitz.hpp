// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stdexcept>
#include <vector>

#include "stagecraft/tableaux/sturm.hpp"

namespace stagecraft::tableaux {

/// How many roots (with multiplicity) lie in the open left half-plane, on the imaginary axis, and in the open
/// right half-plane.
struct half_plane_count {
    int left = 0;
    int axis = 0;
    int right = 0;
    friend constexpr bool operator==(const half_plane_count&, const half_plane_count&) = default;
};

/// With p(iy) = u(y) + i v(y): the real and the imaginary part on the imaginary axis, polynomials in y.
template <class K>
struct axis_parts {
    polynomial<K> real;
    polynomial<K> imaginary;
};
template <class K>
constexpr axis_parts<K> on_imaginary_axis(const polynomial<K>& p) {
    std::vector<K> u;
    std::vector<K> v;
    for (int k = 0; k <= p.degree(); ++k) {
        const K a = k % 4 < 2 ? p[k] : K(0) - p[k];
        u.push_back(k % 2 == 0 ? a : K(0));
        v.push_back(k % 2 == 0 ? K(0) : a);
    }
    return {polynomial<K>(std::move(u)), polynomial<K>(std::move(v))};
}

/// Exact count of the roots of a real polynomial in both half-planes (Routh-Hurwitz, by Cauchy indices):
/// roots that come with their mirror image -z (those on the axis among them) are split off as the common
/// divisor of the even and the odd part; for the rest left - right is an index. Throws std::domain_error for
/// p = 0.
template <class K>
constexpr half_plane_count count_half_planes(const polynomial<K>& p) {
    if (p.is_zero()) throw std::domain_error("count_half_planes: the zero polynomial");
    half_plane_count n;
    const auto parts = on_imaginary_axis(p);
    const auto common = gcd(parts.real, parts.imaginary);  // in y; its roots: the mirrored roots of p, z = iy
    for (const auto& [factor, multiplicity] : squarefree_split(common)) {
        n.axis += multiplicity * sturm_chain<K>(factor).count();
    }
    n.left = n.right = (common.degree() - n.axis) / 2;
    const auto u = parts.real / common;
    const auto v = parts.imaginary / common;
    const int rest = p.degree() - common.degree();
    // arg p(iy) grows by pi (left - right): tan(arg) = v/u jumps down, cot(arg) = u/v jumps up on the way.
    int difference = 0;
    if (u.degree() > v.degree()) {
        difference = -remainder_chain<K>(u, v).index();
    } else {
        difference = remainder_chain<K>(v, u).index();
    }
    n.left += (rest + difference) / 2;
    n.right += (rest - difference) / 2;
    return n;
}

}  // namespace stagecraft::tableaux
