// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/theory/statements/statement.hpp>
#include <utility>

namespace stagecraft::theory::statements {

namespace detail {

template <int... K>
constexpr auto quadrature(std::integer_sequence<int, K...>) {
    using namespace symbols;
    return make_statement("B", sizeof...(K), "Butcher 1964; Hairer-Wanner II.IV.5",
                          (dot(b, pow<K>(c)) == exact_number(1, K + 1))...);
}
template <int... K>
constexpr auto stage_quadrature(std::integer_sequence<int, K...>) {
    using namespace symbols;
    return make_statement("C", sizeof...(K), "Butcher 1964; Hairer-Wanner II.IV.5",
                          (A * pow<K>(c) == pow<K + 1>(c) / (K + 1))...);
}
template <int K>
constexpr auto weighted_power() {  // b∘c^K
    using namespace symbols;
    if constexpr (K == 0)
        return b;
    else
        return b * pow<K>(c);
}
template <int... K>
constexpr auto adjoint_quadrature(std::integer_sequence<int, K...>) {
    using namespace symbols;
    return make_statement("D", sizeof...(K), "Butcher 1964; Hairer-Wanner II.IV.5",
                          (transposed(A) * weighted_power<K>() == b * (one - pow<K + 1>(c)) / (K + 1))...);
}

}  // namespace detail

/// B(p): the quadrature formula (b, c) is exact for polynomials of degree < p.
template <int P>
requires(P >= 0) inline constexpr auto B = detail::quadrature(std::make_integer_sequence<int, P>{});

/// C(q): each stage integrates polynomials of degree < q exactly over [0, c_i].
template <int Q>
requires(Q >= 0) inline constexpr auto C = detail::stage_quadrature(std::make_integer_sequence<int, Q>{});

/// D(r): b^T c^{k-1} A = (b^T - b^T c^k)/k for k = 1..r. In a model that keeps rows as stage vectors (the
/// Legendre ring) it is stated after division by b, so there it presumes that no weight vanishes.
template <int R>
requires(R >= 0) inline constexpr auto D = detail::adjoint_quadrature(std::make_integer_sequence<int, R>{});

/// A 1 = c: every stage has order one, and autonomous form is no restriction. The same equation as C(1).
inline constexpr auto row_sums = [] {
    using namespace symbols;
    return make_statement("row sums", -1, "Hairer-Norsett-Wanner I.II.1, (1.9)", A * one == c);
}();

}  // namespace stagecraft::theory::statements
