// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/theory/statements/statement.hpp>
#include <tuple>

namespace stagecraft::theory::statements {

namespace detail {

template <class Equation>
constexpr auto order_condition(std::string_view tree, Equation e) {
    return make_statement(tree, -1, "Butcher 1963; Hairer-Norsett-Wanner I.II.2, tables 2.1 and 2.2", e);
}

}  // namespace detail

// The order conditions to order five, under the names that their trees have in Hairer-Norsett-Wanner I.II.2,
// tables 2.1 and 2.2. They presume the row sums c = A*one.
namespace conditions {
using namespace symbols;
inline constexpr auto tau = detail::order_condition("tau", dot(b, one) == 1);
inline constexpr auto t21 = detail::order_condition("t21", dot(b, c) == 1 / 2_q);
inline constexpr auto t31 = detail::order_condition("t31", dot(b, c* c) == 1 / 3_q);
inline constexpr auto t32 = detail::order_condition("t32", dot(b, A* c) == 1 / 6_q);
inline constexpr auto t41 = detail::order_condition("t41", dot(b, pow<3>(c)) == 1 / 4_q);
inline constexpr auto t42 = detail::order_condition("t42", dot(b, c*(A* c)) == 1 / 8_q);
inline constexpr auto t43 = detail::order_condition("t43", dot(b, A*(c* c)) == 1 / 12_q);
inline constexpr auto t44 = detail::order_condition("t44", dot(b, A*(A* c)) == 1 / 24_q);
inline constexpr auto t51 = detail::order_condition("t51", dot(b, pow<4>(c)) == 1 / 5_q);
inline constexpr auto t52 = detail::order_condition("t52", dot(b, c* c*(A* c)) == 1 / 10_q);
inline constexpr auto t53 = detail::order_condition("t53", dot(b, c*(A*(c* c))) == 1 / 15_q);
inline constexpr auto t54 = detail::order_condition("t54", dot(b, c*(A*(A* c))) == 1 / 30_q);
inline constexpr auto t55 = detail::order_condition("t55", dot(b, pow<2>(A* c)) == 1 / 20_q);
inline constexpr auto t56 = detail::order_condition("t56", dot(b, A* pow<3>(c)) == 1 / 20_q);
inline constexpr auto t57 = detail::order_condition("t57", dot(b, A*(c*(A* c))) == 1 / 40_q);
inline constexpr auto t58 = detail::order_condition("t58", dot(b, A*(A*(c* c))) == 1 / 60_q);
inline constexpr auto t59 = detail::order_condition("t59", dot(b, A*(A*(A* c))) == 1 / 120_q);

/// All of them, as statements of one equation each, by order.
inline constexpr auto all =
    std::make_tuple(tau, t21, t31, t32, t41, t42, t43, t44, t51, t52, t53, t54, t55, t56, t57, t58, t59);
}  // namespace conditions

namespace detail {

template <class... E>
constexpr auto conjunction(int order, const statement<E>&... one_each) {
    return make_statement("order conditions to order", order,
                          "Butcher 1963; Hairer-Norsett-Wanner I.II.2, Theorem 2.13",
                          std::get<0>(one_each.equations)...);
}
template <int P>
constexpr auto conditions_to_order() {
    constexpr int count[] = {0, 1, 2, 4, 8, 17};
    return []<std::size_t... I>(std::index_sequence<I...>) {
        return conjunction(P, std::get<I>(conditions::all)...);
    }
    (std::make_index_sequence<static_cast<std::size_t>(count[P])>{});
}

}  // namespace detail

/// The order conditions to order P <= 5: equivalent to order P where the row sums hold. Beyond five,
/// conditions are values: `failing_conditions`, `order_of`, `has_order` (tree_order.hpp).
template <int P>
requires(P >= 0 && P <= 5) inline constexpr auto order_conditions = detail::conditions_to_order<P>();

}  // namespace stagecraft::theory::statements
