// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <utility>

#include <stagecraft/mechanics/model.hpp>
#include <stagecraft/refuse/detect/refused_call.hpp>

// Formulations of models that they do not suit: each says in one sentence which to take.

namespace stagecraft {

namespace detail {

/// In place of a formulation that has been refused, so that the sentence is all that is said.
struct refused_formulation {
    int size() const { return 0; }
    template <class T, class Y, class F>
    void operator()(const T&, const Y&, F&) const {}
    template <class Q, class... Others>
    auto initial_state(const Q&, const Others&...) const {
        constexpr int n = Q::SizeAtCompileTime;
        return Eigen::Matrix < typename Q::Scalar, n == Eigen::Dynamic ? n : 2 * n, 1 > ();
    }
};

template <class Model>
concept of_velocity = fixed_size_model<Model> && !holonomic_model<Model>;
template <class Model>
concept without_position = of_velocity<Model> || free_model<Model>;

}  // namespace detail

/// Of constraints of velocity there is no position; without constraints there is nothing to choose a formulation for.
template <class Scalar = double, detail::without_position Model>
detail::refused_formulation stabilised_index_2(const Model&) {
    static_assert(!free_model<Model>,
                  "stabilised_index_2: the model has no constraints: take free_motion(model)");
    static_assert(!detail::of_velocity<Model>,
                  "stabilised_index_2: the model has constraints of velocity only, G v = 0, no g(q): take "
                  "index_2(model), which keeps these");
    return {};
}
template <class Scalar = double, detail::without_position Model>
detail::refused_formulation index_3(const Model&) {
    static_assert(!free_model<Model>, "index_3: the model has no constraints: take free_motion(model)");
    static_assert(!detail::of_velocity<Model>,
                  "index_3: the model has constraints of velocity only, G v = 0, no g(q): take "
                  "index_2(model)");
    return {};
}
template <class Scalar = double, free_model Model>
detail::refused_formulation index_2(const Model&) {
    static_assert(detail::never<Model>, "index_2: the model has no constraints: take free_motion(model)");
    return {};
}
template <class Scalar = double, free_model Model, class... Rate>
detail::refused_formulation index_reduced(const Model&, const Rate&...) {
    static_assert(detail::never<Model>,
                  "index_reduced: the model has no constraints: take free_motion(model)");
    return {};
}
template <detail::of_velocity Model, class Eps, class Kappa, class C, class D>
detail::refused_formulation regularised_position(const Model&, Eps, Kappa, C, D) {
    static_assert(detail::never<Model>,
                  "regularised_position: the model has constraints of velocity only, G v = 0, no g(q): take "
                  "regularised(model, eps, kappa, c, d)");
    return {};
}

/// Of constraints of velocity there is no beta; or one of the two rates is missing, or both.
template <class Scalar = double, fixed_size_model Model, class... Rates>
requires(!holonomic_model<Model> || sizeof...(Rates) < 2) detail::refused_formulation
    baumgarte(const Model&, const Rates&...) {
    constexpr bool position = holonomic_model<Model>;
    static_assert(position,
                  "baumgarte: the model has constraints of velocity only, G v = 0, no g(q): take "
                  "index_reduced(model, r), by which G v decays as exp(-r t)");
    static_assert(
        !position,
        "baumgarte(model, alpha, beta): give both rates of g'' + 2 alpha g' + beta^2 g = 0; the usual "
        "choice alpha = beta damps critically: baumgarte(model, 10, 10)");
    return {};
}

/// A constraint would be passed over.
template <class Scalar = double, mechanical_model Model>
detail::refused_formulation free_motion(const Model&) {
    static_assert(detail::never<Model>,
                  "free_motion: the model has constraints: take index_2(model), stabilised_index_2(model) or "
                  "index_reduced(model)");
    return {};
}

/// Of models of a size known at run time these are not formed: without a scalar to differentiate by, dG/dt would be a
/// difference, and its derivative in the Jacobian a difference of differences.
template <sized_mechanical_model Model, class... Numbers>
detail::refused_formulation index_reduced(const Model&, const Numbers&...) {
    static_assert(
        detail::never<Model>,
        "index_reduced, baumgarte and invariants need a mechanical_model of fixed size; for a size known at "
        "run time take stabilised_index_2(model, q), which does not drift, or index_2(model, q)");
    return {};
}
template <sized_mechanical_model Model, class... Numbers>
auto baumgarte(const Model& model, const Numbers&... numbers) {
    return index_reduced(model, numbers...);
}
template <sized_mechanical_model Model>
auto invariants(const Model& model) {
    return index_reduced(model);
}
template <sized_mechanical_model Model, class... Numbers>
detail::refused_formulation regularised(const Model&, const Numbers&...) {
    static_assert(detail::never<Model>,
                  "regularised needs a mechanical_model of fixed size; for a size known at run time take "
                  "regularised_position(model, q, eps, kappa, c, d), or index_2(model, q), its limit");
    return {};
}

}  // namespace stagecraft
