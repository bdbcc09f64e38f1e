// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <tuple>
#include <utility>

#include <stagecraft/step/collocation_step.hpp>

namespace stagecraft {

/// Several methods of one family, by increasing number of stages: the run chooses among them step by step.
template <class... Methods>
struct variable_order {
    std::tuple<Methods...> methods;
};

template <class... Methods>
variable_order(std::tuple<Methods...>) -> variable_order<Methods...>;

namespace detail {

template <class Scalar, int Stages>
std::tuple<transformed_tableau<Scalar, Stages>> as_tuple(const transformed_tableau<Scalar, Stages>& m) {
    return std::tuple<transformed_tableau<Scalar, Stages>>(m);
}
template <class... Methods>
const std::tuple<Methods...>& as_tuple(const variable_order<Methods...>& m) {
    return m.methods;
}

template <class Scalar, int Stages>
constexpr int stages_of(const transformed_tableau<Scalar, Stages>*) {
    return Stages;
}

template <class Tuple, int N, class Blocks>
struct steps_of;
template <class First, class... Rest, int N, class Blocks>
struct steps_of<std::tuple<First, Rest...>, N, Blocks> {
    using scalar = typename First::scalar;
    static constexpr int first_stages = stages_of(static_cast<First*>(nullptr));
    static constexpr bool any_dynamic =
        first_stages < 0 || ((stages_of(static_cast<Rest*>(nullptr)) < 0) || ...);
    static constexpr int max_stages =
        any_dynamic ? dynamic : std::max({first_stages, stages_of(static_cast<Rest*>(nullptr))...});
    using type = std::tuple<
        collocation_step<scalar, N, first_stages, max_stages, Blocks>,
        collocation_step<scalar, N, stages_of(static_cast<Rest*>(nullptr)), max_stages, Blocks>...>;
    static type make(const std::tuple<First, Rest...>& methods, int n) {
        return std::apply([n](const auto&... m) { return type(make_one(m, n)...); }, methods);
    }

  private:
    template <int Stages>
    static auto make_one(const transformed_tableau<scalar, Stages>& m, int n) {
        return collocation_step<scalar, N, Stages, max_stages, Blocks>(m, n);
    }
};

/// Calls f with element `k` of the tuple; a single method costs no branch.
template <std::size_t I = 0, class Tuple, class F>
decltype(auto) visit_at(Tuple& tuple, int k, F&& f) {
    if constexpr (I + 1 == std::tuple_size_v<std::remove_const_t<Tuple>>) {
        return f(std::get<I>(tuple));
    } else {
        if (k == static_cast<int>(I)) return f(std::get<I>(tuple));
        return visit_at<I + 1>(tuple, k, std::forward<F>(f));
    }
}

}  // namespace detail

template <class Method>
inline constexpr int method_count = static_cast<int>(
    std::tuple_size_v<std::decay_t<decltype(detail::as_tuple(std::declval<const Method&>()))>>);

}  // namespace stagecraft
