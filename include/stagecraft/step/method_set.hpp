// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <tuple>
#include <utility>

#include <stagecraft/step/collocation_step.hpp>
#include <stagecraft/step/tableau_step.hpp>

namespace stagecraft {

/// Several methods of one family, by increasing number of stages: the run chooses among them step by step.
template <class... Methods>
struct variable_order {
    std::tuple<Methods...> methods;
};

template <class... Methods>
variable_order(std::tuple<Methods...>) -> variable_order<Methods...>;

/// A method and the guards that watch its steps: what guarded() and without() return (run/guarded.hpp).
template <class Method, class Guards>
struct guarded_method {
    Method method;
    Guards guards;
};

namespace detail {

/// The step that serves a method, and the columns its continuous solution may need.
template <class Method>
struct step_for;

template <class Scalar, int Stages>
std::tuple<transformed_tableau<Scalar, Stages>> as_tuple(const transformed_tableau<Scalar, Stages>& m) {
    return std::tuple<transformed_tableau<Scalar, Stages>>(m);
}
template <class Scalar, int Stages>
std::tuple<tableau<Scalar, Stages>> as_tuple(const tableau<Scalar, Stages>& m) {
    return std::tuple<tableau<Scalar, Stages>>(m);
}
/// A method that brings its own step_for, with a name of its own.
template <class Method>
concept named_method = requires {
    step_for<Method>::named;
};
template <named_method Method>
std::tuple<Method> as_tuple(const Method& m) {
    return std::tuple<Method>(m);
}
template <class... Methods>
const std::tuple<Methods...>& as_tuple(const variable_order<Methods...>& m) {
    return m.methods;
}
template <class Method, class Guards>
decltype(auto) as_tuple(const guarded_method<Method, Guards>& m) {
    return as_tuple(m.method);
}

template <class Scalar, int Stages>
struct step_for<transformed_tableau<Scalar, Stages>> {
    static constexpr int columns = Stages;
    template <class Space>
    using type = collocation_step<Stages, Space>;
};
template <class Scalar, int Stages>
struct step_for<tableau<Scalar, Stages>> {
    static constexpr int columns = Stages < 0 || Stages > 3 ? Stages : 3;
    template <class Space>
    using type = tableau_step<Stages, Space>;
};

template <class Tuple, class Vector, class Blocks>
struct steps_of;
template <class First, class... Rest, class Vector, class Blocks>
struct steps_of<std::tuple<First, Rest...>, Vector, Blocks> {
    using scalar = typename First::scalar;
    static constexpr bool any_dynamic =
        step_for<First>::columns < 0 || ((step_for<Rest>::columns < 0) || ...);
    static constexpr int max_stages =
        any_dynamic ? dynamic : std::max({step_for<First>::columns, step_for<Rest>::columns...});
    using space = step_space<Vector, max_stages, Blocks>;
    using type = std::tuple<typename step_for<First>::template type<space>,
                            typename step_for<Rest>::template type<space>...>;
    static type make(const std::tuple<First, Rest...>& methods, int n) {
        return std::apply([n](const auto&... m) { return type(make_one(m, n)...); }, methods);
    }

  private:
    template <class Method>
    static auto make_one(const Method& m, int n) {
        return typename step_for<Method>::template type<space>(m, n);
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

/// The columns that the continuous solutions of all need.
template <class Tuple>
int largest_columns(const Tuple& steps) {
    return std::apply([](const auto&... m) { return std::max({m.columns()...}); }, steps);
}

/// True of additive methods, which take a problem in two parts.
template <class Method>
inline constexpr bool takes_parts = requires {
    step_for<std::tuple_element_t<
        0, std::decay_t<decltype(detail::as_tuple(std::declval<const Method&>()))>>>::takes_parts;
};

/// An additive method and a problem in two parts, or neither.
template <class Method, class Problem>
inline constexpr bool fit_in_parts = takes_parts<Method> == in_parts<Problem>;

}  // namespace detail

/// How many methods a run chooses from: those of a variable_order, otherwise 1.
template <class Method>
inline constexpr int method_count = static_cast<int>(
    std::tuple_size_v<std::decay_t<decltype(detail::as_tuple(std::declval<const Method&>()))>>);

}  // namespace stagecraft
