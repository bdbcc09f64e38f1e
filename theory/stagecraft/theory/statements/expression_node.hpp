// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <concepts>
#include <cstdint>
#include <limits>
#include <stagecraft/tableaux/fixed_rational.hpp>
#include <stagecraft/theory/models/stage_algebra.hpp>
#include <stdexcept>
#include <type_traits>

// The nodes of the expression language; what its user writes is in expression.hpp.
namespace stagecraft::theory {

enum class sorts { map, vector, row, number };

template <class E>
concept expression = requires {
    requires std::same_as<std::remove_cv_t<decltype(E::sort)>, sorts>;
};
template <class E>
concept vector_expression = expression<E> && E::sort == sorts::vector;
template <class E>
concept row_expression = expression<E> && E::sort == sorts::row;
template <class E>
concept number_expression = expression<E> && E::sort == sorts::number;

using exact_number = tableaux::fixed_rational;
template <class T>
concept exact_constant = std::integral<T> || std::same_as<T, exact_number>;

/// What u and v stand for while an expression is evaluated.
template <stage_algebra M>
struct bindings {
    const element_of<M>* u = nullptr;
    const element_of<M>* v = nullptr;
};

namespace detail {
template <class>
inline constexpr bool never = false;

constexpr std::int64_t part(tableaux::int128 n) {
    constexpr auto largest = std::numeric_limits<std::int64_t>::max();
    if (n > largest || n < -largest)
        throw std::overflow_error("a number in an expression needs more than 64 bits");
    return static_cast<std::int64_t>(n);
}
struct ill_formed {};  // what an ambiguous product gives, so that one mistake is reported once
template <class X>
constexpr ill_formed operator*(ill_formed, X) {
    return {};
}
template <class X>
constexpr ill_formed dot(X, ill_formed) {
    return {};
}
template <class X>
constexpr ill_formed operator==(ill_formed, X) {
    return {};
}
// Not constexpr: a compiler that must call it prints its name.
inline void zero_may_be_a_truncated_quotient_write_1_over_15_q_or_0_q() {}

// Statements about all u and v are decided on a basis, so every term must be linear in each. The nodes assert
// `free < 4` because a static member of a template is looked at only when it is used.
template <unsigned Left, unsigned Right>
constexpr unsigned free_in_product() {
    static_assert((Left & Right) == 0,
                  "u and v stand for arbitrary stage vectors: each may occur once in a term");
    return Left | Right;
}
template <unsigned Left, unsigned Right>
constexpr unsigned free_in_sum() {
    static_assert(Left == Right,
                  "u and v stand for arbitrary stage vectors: every term must be linear in the same");
    return Left;
}

// Rows by their values on the basis, where the model has no quicker way.
template <stage_algebra M>
constexpr element_of<M> weights(const M& m) {
    if constexpr (requires { m.weights(); })
        return m.weights();
    else
        return row_of(m, [&](const element_of<M>& u) { return m.dot_b(u); });
}
template <stage_algebra M>
constexpr element_of<M> weigh(const M& m, const element_of<M>& row, const element_of<M>& v) {
    if constexpr (requires { m.weigh(row, v); })
        return m.weigh(row, v);
    else
        return row_of(m, [&](const element_of<M>& u) { return pair(m, row, m.multiply(v, u)); });
}
template <stage_algebra M>
constexpr element_of<M> apply_transposed(const M& m, const element_of<M>& row) {
    if constexpr (requires { m.apply_transposed(row); })
        return m.apply_transposed(row);
    else
        return row_of(m, [&](const element_of<M>& u) { return pair(m, row, m.apply(u)); });
}
// x n/d in this order: integers are exact in every model, quotients of integers are not.
template <stage_algebra M>
constexpr void multiply_by(const M&, const exact_number& q, scalar_of<M>& x) {
    x *= scalar_of<M>(part(q.numerator()));
    if (q.denominator() != 1) x /= scalar_of<M>(part(q.denominator()));
}
template <stage_algebra M>
constexpr void multiply_by(const M& m, const exact_number& q, element_of<M>& u) {
    for (auto& x : u) multiply_by(m, q, x);
}
template <stage_algebra M>
constexpr scalar_of<M> add(const M&, const scalar_of<M>& x, const scalar_of<M>& y) {
    return x + y;
}
template <stage_algebra M>
constexpr scalar_of<M> scale(const M&, const scalar_of<M>& k, const scalar_of<M>& x) {
    return k * x;
}
using theory::add;
using theory::scale;
}  // namespace detail

// The nodes. `free`: which of u (1) and v (2) occur. `in(model, bindings)`: the value.

struct map_A {
    static constexpr sorts sort = sorts::map;
};
struct map_A_transposed {
    static constexpr sorts sort = sorts::map;
};
struct map_P {
    static constexpr sorts sort = sorts::map;
};

// A_hat, c_hat, b_hat: those of the second tableau of a pair_model, whose hat() is it.
struct map_A_hat {
    static constexpr sorts sort = sorts::map;
};

struct unit_vector {
    static constexpr sorts sort = sorts::vector;
    static constexpr unsigned free = 0;
    template <stage_algebra M>
    constexpr element_of<M> in(const M& m, const bindings<M>&) const {
        return m.one();
    }
};
struct node_vector {
    static constexpr sorts sort = sorts::vector;
    static constexpr unsigned free = 0;
    template <stage_algebra M>
    constexpr element_of<M> in(const M& m, const bindings<M>&) const {
        return m.c();
    }
};
struct hat_node_vector {
    static constexpr sorts sort = sorts::vector;
    static constexpr unsigned free = 0;
    template <stage_algebra M>
    constexpr element_of<M> in(const M& m, const bindings<M>&) const {
        return m.hat().c();
    }
};
template <int I>  // 0: u, 1: v
struct any_vector {
    static constexpr sorts sort = sorts::vector;
    static constexpr unsigned free = 1U << I;
    template <stage_algebra M>
    constexpr element_of<M> in(const M&, const bindings<M>& any) const {
        return I == 0 ? *any.u : *any.v;
    }
};
template <vector_expression V>
struct application {  // A*v
    static constexpr sorts sort = sorts::vector;
    static constexpr unsigned free = V::free;
    V argument;
    template <stage_algebra M>
    constexpr element_of<M> in(const M& m, const bindings<M>& any) const {
        return m.apply(argument.in(m, any));
    }
};
template <vector_expression V>
struct hat_application {  // A_hat*v
    static constexpr sorts sort = sorts::vector;
    static constexpr unsigned free = V::free;
    V argument;
    template <stage_algebra M>
    constexpr element_of<M> in(const M& m, const bindings<M>& any) const {
        return m.hat().apply(argument.in(m, any));
    }
};
template <vector_expression V>
struct reflection {  // P*v
    static constexpr sorts sort = sorts::vector;
    static constexpr unsigned free = V::free;
    V argument;
    template <stage_algebra M>
    constexpr element_of<M> in(const M& m, const bindings<M>& any) const {
        return m.reflect(argument.in(m, any));
    }
};
template <vector_expression U, vector_expression V>
struct product {  // pointwise
    static constexpr sorts sort = sorts::vector;
    static constexpr unsigned free = detail::free_in_product<U::free, V::free>();
    static_assert(free < 4);
    U left;
    V right;
    template <stage_algebra M>
    constexpr element_of<M> in(const M& m, const bindings<M>& any) const {
        return m.multiply(left.in(m, any), right.in(m, any));
    }
};
template <int N, vector_expression V>
struct power {  // pointwise, N >= 2
    static constexpr sorts sort = sorts::vector;
    static constexpr unsigned free = detail::free_in_product<V::free, V::free>();
    static_assert(free < 4);
    V base;
    template <stage_algebra M>
    constexpr element_of<M> in(const M& m, const bindings<M>& any) const {
        const element_of<M> x = base.in(m, any);
        element_of<M> r = x;
        for (int i = 1; i < N; ++i) r = m.multiply(r, x);
        return r;
    }
};

struct weight_row {
    static constexpr sorts sort = sorts::row;
    static constexpr unsigned free = 0;
    template <stage_algebra M>
    constexpr element_of<M> in(const M& m, const bindings<M>&) const {
        return detail::weights(m);
    }
};
struct hat_weight_row {
    static constexpr sorts sort = sorts::row;
    static constexpr unsigned free = 0;
    template <stage_algebra M>
    constexpr element_of<M> in(const M& m, const bindings<M>&) const {
        return detail::weights(m.hat());
    }
};
struct last_stage {  // v -> v_s; stands in the first place of dot only
    static constexpr sorts sort = sorts::row;
    static constexpr unsigned free = 0;
};
template <row_expression F, vector_expression V>
struct weighted_row {  // pointwise
    static constexpr sorts sort = sorts::row;
    static constexpr unsigned free = detail::free_in_product<F::free, V::free>();
    static_assert(free < 4);
    F row;
    V by;
    template <stage_algebra M>
    constexpr element_of<M> in(const M& m, const bindings<M>& any) const {
        return detail::weigh(m, row.in(m, any), by.in(m, any));
    }
};
template <row_expression F>
struct transposed_application {  // A^T f
    static constexpr sorts sort = sorts::row;
    static constexpr unsigned free = F::free;
    F argument;
    template <stage_algebra M>
    constexpr element_of<M> in(const M& m, const bindings<M>& any) const {
        return detail::apply_transposed(m, argument.in(m, any));
    }
};

struct constant {
    static constexpr sorts sort = sorts::number;
    static constexpr unsigned free = 0;
    exact_number value;
    template <stage_algebra M>
    constexpr scalar_of<M> in(const M&, const bindings<M>&) const {
        return ratio<scalar_of<M>>(detail::part(value.numerator()), detail::part(value.denominator()));
    }
};
template <row_expression F, vector_expression V>
struct pairing {  // dot(f, v)
    static constexpr sorts sort = sorts::number;
    static constexpr unsigned free = detail::free_in_product<F::free, V::free>();
    static_assert(free < 4);
    F row;
    V vector;
    template <stage_algebra M>
    constexpr scalar_of<M> in(const M& m, const bindings<M>& any) const {
        if constexpr (std::is_same_v<F, weight_row>)
            return m.dot_b(vector.in(m, any));
        else if constexpr (std::is_same_v<F, last_stage>)
            return m.at_last(vector.in(m, any));
        else
            return pair(m, row.in(m, any), vector.in(m, any));
    }
};
template <number_expression X, expression Y>
struct multiple {  // a number times a number, a vector or a row
    static constexpr sorts sort = Y::sort;
    static constexpr unsigned free = detail::free_in_product<X::free, Y::free>();
    static_assert(free < 4);
    X factor;
    Y argument;
    template <stage_algebra M>
    constexpr auto in(const M& m, const bindings<M>& any) const {
        if constexpr (std::is_same_v<X, constant>) {
            auto value = argument.in(m, any);
            detail::multiply_by(m, factor.value, value);
            return value;
        } else {
            return detail::scale(m, factor.in(m, any), argument.in(m, any));
        }
    }
};
template <expression X, expression Y, int Sign>
requires(X::sort == Y::sort) struct sum {  // X + Y or X - Y
    static constexpr sorts sort = X::sort;
    static constexpr unsigned free = detail::free_in_sum<X::free, Y::free>();
    static_assert(free < 4);
    X left;
    Y right;
    template <stage_algebra M>
    constexpr auto in(const M& m, const bindings<M>& any) const {
        if constexpr (Sign > 0)
            return detail::add(m, left.in(m, any), right.in(m, any));
        else
            return detail::add(m, left.in(m, any), detail::scale(m, scalar_of<M>(-1), right.in(m, any)));
    }
};

/// left == right, of numbers, of stage vectors or of rows; for all u and v where these occur.
template <expression L, expression R>
requires(L::sort == R::sort) struct equation {
    static constexpr unsigned free = detail::free_in_sum<L::free, R::free>();
    static_assert(free < 4);
    L left;
    R right;
};
template <class>
inline constexpr bool is_equation = false;
template <class L, class R>
inline constexpr bool is_equation<equation<L, R>> = true;
template <class>
inline constexpr bool is_application = false;
template <class V>
inline constexpr bool is_application<application<V>> = true;
template <class V>
inline constexpr bool is_application<hat_application<V>> = true;

}  // namespace stagecraft::theory
