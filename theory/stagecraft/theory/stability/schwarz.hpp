// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "stagecraft/theory/models/band_matrix.hpp"

namespace stagecraft::theory {

/// Size of the leading block of a tridiagonal A, up to the first pair a_{k,k+1} a_{k+1,k} = 0, that carries
/// R(z) = det(I - z (A - e_0 e_0^T)) / det(I - z A): the rest divides both determinants (Lobatto IIIA, IIIB).
/// The two determinants of the block have no common zero, being neighbouring continuants.
template <class K>
constexpr int coupled_size(const band_matrix<K>& a) {
    int n = 1;
    while (n < a.size() && !(a(n - 1, n) * a(n, n - 1) == K(0))) ++n;
    return n;
}

constexpr bool is_tridiagonal(const auto& a) { return a.lower() <= 1 && a.upper() <= 1; }

/// R at infinity for a tridiagonal A in Legendre coordinates, empty where R has a pole there. By the
/// continued fraction of det A / det A_1 (A_1: first row and column removed), O(s) operations, exact also for
/// singular A.
template <class K>
constexpr std::optional<K> tridiagonal_r_infinity(const band_matrix<K>& a) {
    const int n = coupled_size(a);
    K ratio = a(n - 1, n - 1);
    bool infinite = false;
    for (int k = n - 2; k >= 0; --k) {
        const K coupling = a(k, k + 1) * a(k + 1, k);
        if (infinite) {
            infinite = false;
            ratio = a(k, k);
        } else if (ratio == K(0)) {
            infinite = true;
        } else {
            ratio = a(k, k) - coupling / ratio;
        }
    }
    if (infinite) return K(1);
    if (ratio == K(0)) return {};
    return K(1) - K(1) / ratio;
}

/// The Schwarz form of the coupled block of a tridiagonal A: there is a diagonal S > 0, s_0 = 1, with
/// S A + A^T S - e_0 e_0^T = corner * e e^T, e the last unit vector. Then 1 - |R(iy)|^2 = corner y^2 |v|^2
/// with v the last component of (I - iy A)^{-1} e_0, and corner >= 0 puts all poles into Re z > 0.
template <class K>
struct schwarz_form {
    int size = 0;
    K corner;
    K last_component;  ///< v det(I - zA) = last_component z^{size-1}

    /// All |R(iy)| <= 1 and all poles on the right: decided, both ways, by the sign of the corner.
    constexpr bool is_a_stable() const { return !(corner < K(0)); }
    /// E(y) = |det(I - iyA)|^2 - |det(I - iy(A - e_0 e_0^T))|^2 = leading_e() y^{2 size}.
    constexpr K leading_e() const { return corner * last_component * last_component; }
};

/// The Schwarz form, or nothing where A has none: then A-stability needs the E-polynomial. O(s) operations.
template <class K>
constexpr std::optional<schwarz_form<K>> schwarz_form_of(const band_matrix<K>& a,
                                                         bool with_component = true) {
    if (!is_tridiagonal(a)) return {};
    const int n = coupled_size(a);
    K scale(1);
    K component(1);
    for (int k = 0; k < n; ++k) {
        const K diagonal = k == 0 ? K(2) * a(0, 0) - K(1) : K(2) * scale * a(k, k);
        if (k + 1 == n) return schwarz_form<K>{n, diagonal, component};
        if (!(diagonal == K(0))) return {};
        const K quotient = K(0) - a(k, k + 1) / a(k + 1, k);
        if (!(K(0) < quotient)) return {};
        scale = scale * quotient;
        if (with_component) component = component * a(k + 1, k);
    }
    return {};
}

}  // namespace stagecraft::theory
