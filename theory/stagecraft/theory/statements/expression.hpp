// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <concepts>
#include <stagecraft/theory/statements/expression_node.hpp>
#include <type_traits>

/// A small language for statements about Runge-Kutta methods. An expression's type is its formula: it
/// evaluates in every stage algebra, prints itself (expression_text.hpp), knows its rooted tree
/// (expression_tree.hpp), and works in static_assert.
///
///     using namespace stagecraft::theory::symbols;
///     constexpr auto t53 = dot(b, c * (A * (c * c))) == 1 / 15_q;
///     static_assert(holds(t53, gauss_3));
///
/// Four sorts: maps (A, transposed(A), P), stage vectors (one, c, A*v, u*v pointwise, pow<n>(v), P*v), rows,
/// that is functionals (b, b*v, transposed(A)*b, last), and numbers (dot(row, vector)). u and v stand for
/// arbitrary stage vectors; an equation with them holds if it holds for all. An expression that could be read
/// in two ways does not compile, and the message says how to write what is meant. A_hat, b_hat and c_hat are
/// those of the second tableau of a pair_model: dot(b, A_hat*c) == 1/6_q.
namespace stagecraft::theory {

template <expression L, expression R>
constexpr auto operator*(L l, R r) {
    using enum sorts;
    if constexpr (L::sort == map && R::sort == vector) {
        static_assert(!std::is_same_v<L, map_A_transposed>,
                      "transposed(A) acts on rows: write transposed(A)*b or transposed(A)*(b*v)");
        if constexpr (std::is_same_v<L, map_A>)
            return application<R>{r};
        else if constexpr (std::is_same_v<L, map_A_hat>)
            return hat_application<R>{r};
        else if constexpr (std::is_same_v<L, map_P>)
            return reflection<R>{r};
        else
            return detail::ill_formed{};
    } else if constexpr (L::sort == map && R::sort == row) {
        static_assert(std::is_same_v<L, map_A_transposed>,
                      "a map acts on stage vectors, b is a row: write transposed(A)*b for the row b^T A, "
                      "dot(b, A*v) for the number b^T A v");
        if constexpr (std::is_same_v<L, map_A_transposed>)
            return transposed_application<R>{r};
        else
            return detail::ill_formed{};
    } else if constexpr (L::sort == map) {
        static_assert(detail::never<L>, "a map acts on stage vectors: write A*(A*v) for the square of A");
        return detail::ill_formed{};
    } else if constexpr (R::sort == map) {
        static_assert(L::sort != row,
                      "b*A is ambiguous: write dot(b, A*v) for the number b^T A v, transposed(A)*b "
                      "for the row b^T A");
        static_assert(L::sort == row, "A acts from the left on a stage vector: write A*v or u*(A*v)");
        return detail::ill_formed{};
    } else if constexpr (L::sort == vector && R::sort == vector) {
        constexpr bool ambiguous = is_application<L> && !is_application<R>;
        static_assert(!ambiguous,
                      "A*u*v is ambiguous: write v*(A*u) for the pointwise product with A*u, A*(u*v) "
                      "for A applied to the product");
        if constexpr (ambiguous)
            return detail::ill_formed{};
        else
            return product<L, R>{l, r};
    } else if constexpr (L::sort == row && R::sort == vector) {
        return weighted_row<L, R>{l, r};
    } else if constexpr (L::sort == number && R::sort != map) {
        return multiple<L, R>{l, r};
    } else {
        static_assert(detail::never<L>,
                      "a row comes first: write b*v for the weighted row, dot(b, v) for the number");
        return detail::ill_formed{};
    }
}

/// The number f^T v.
template <class F, class V>
constexpr auto dot(F row, V vector) {
    static_assert(row_expression<F>, "dot(row, vector): the first argument must be a row such as b");
    static_assert(vector_expression<V>, "dot(row, vector): the second argument must be a stage vector");
    return pairing<F, V>{row, vector};
}
/// The pointwise power; pow<0>(v) is one.
template <int N, vector_expression V>
requires(N >= 0) constexpr auto pow(V v) {
    if constexpr (N == 0)
        return unit_vector{};
    else if constexpr (N == 1)
        return v;
    else
        return power<N, V>{v};
}
constexpr map_A_transposed transposed(map_A) { return {}; }

template <expression L, expression R>
constexpr auto operator+(L l, R r) {
    static_assert(L::sort == R::sort, "a sum of unlike things: numbers, stage vectors and rows do not mix");
    return sum<L, R, 1>{l, r};
}
template <expression L, expression R>
constexpr auto operator-(L l, R r) {
    static_assert(L::sort == R::sort,
                  "a difference of unlike things: numbers, stage vectors and rows do not mix");
    return sum<L, R, -1>{l, r};
}
template <exact_constant K, expression E>
constexpr auto operator*(K k, E e) {
    return multiple<constant, E>{{exact_number(k)}, e};
}
template <std::floating_point K, expression E>
constexpr detail::ill_formed operator*(K, E) {
    static_assert(detail::never<K>, "a factor is exact: write 1/2_q*v or v/2");
    return {};
}
template <expression E, exact_constant K>
constexpr auto operator/(E e, K k) {
    return multiple<constant, E>{{exact_number(1) / exact_number(k)}, e};
}

/// A right-hand side. A plain integer is accepted, except 0: that is the value of 1/15 in C++.
struct right_hand_side {
    exact_number value;
    constexpr right_hand_side(const exact_number& q) : value(q) {}  // NOLINT: 1/15_q is a right-hand side
    template <std::integral I>
    consteval right_hand_side(I n) : value(n) {  // NOLINT
        if (n == 0) detail::zero_may_be_a_truncated_quotient_write_1_over_15_q_or_0_q();
    }
    template <std::floating_point F>
    right_hand_side(F) {
        static_assert(detail::never<F>, "a right-hand side is exact: write 1/15_q");
    }
};

template <expression L, expression R>
constexpr auto operator==(L l, R r) {
    static_assert(L::sort == R::sort,
                  "an equation of unlike things: numbers, stage vectors and rows do not mix");
    return equation<L, R>{l, r};
}
template <expression L>
constexpr auto operator==(L l, right_hand_side r) {
    static_assert(number_expression<L>,
                  "an equation of unlike things: only a number such as dot(b, v) equals one");
    return equation<L, constant>{l, {r.value}};
}

namespace symbols {
inline constexpr map_A A{};
inline constexpr map_A_hat A_hat{};
inline constexpr hat_node_vector c_hat{};
inline constexpr hat_weight_row b_hat{};
inline constexpr map_P P{};  ///< reverses the stages
inline constexpr unit_vector one{};
inline constexpr node_vector c{};
inline constexpr any_vector<0> u{};  ///< any stage vector
inline constexpr any_vector<1> v{};  ///< any other
inline constexpr weight_row b{};
inline constexpr last_stage last{};  ///< v -> v_s, as in dot(last, v)
using namespace tableaux::literals;
}  // namespace symbols

/// The value of an expression without u and v: a scalar of the model, or a stage vector.
template <expression E, stage_algebra M>
constexpr auto evaluate(const E& e, const M& m) {
    static_assert(E::free == 0,
                  "u and v stand for arbitrary stage vectors: such an expression has no one value");
    return e.in(m, bindings<M>{});
}

/// Calls f with every scalar that must vanish for the equation to hold: left - right, or the components of
/// that stage vector in the model. u and v run through a basis, which is enough because equations are linear
/// in each. The model fixes the order of the calls.
template <class L, class R, stage_algebra M, class F>
constexpr void for_each_residual(const equation<L, R>& e, const M& m, F&& f) {
    const auto visit = [&](const bindings<M>& any) {
        if constexpr (std::is_same_v<R, constant>) {  // (left d - n)/d: 1/d is not exact in every model
            const exact_number& q = e.right.value;
            const scalar_of<M> d(detail::part(q.denominator())), n(detail::part(q.numerator()));
            f((e.left.in(m, any) * d - n) / d);
        } else if constexpr (L::sort == sorts::number) {
            f(e.left.in(m, any) - e.right.in(m, any));
        } else {
            const element_of<M> difference = sum<L, R, -1>{e.left, e.right}.in(m, any);
            for (const scalar_of<M>& x : difference) f(x);
        }
    };
    constexpr unsigned free = equation<L, R>::free;
    if constexpr (free == 0) {
        visit({});
    } else {
        for (int k = 0; k < ((free & 1U) != 0 ? m.stages() : 1); ++k) {
            for (int l = 0; l < ((free & 2U) != 0 ? m.stages() : 1); ++l) {
                const element_of<M> u = basis_vector(m, k), v = basis_vector(m, l);
                visit({&u, &v});
            }
        }
    }
}

}  // namespace stagecraft::theory
