// SPDX-License-Identifier: BSL-1.0
// A mechanical model with everything that the report asks of it: its formulations behind one type, what they
// must keep, and how to compute a reference.
#pragma once

#include <array>
#include <functional>
#include <stagecraft/dae/projection.hpp>
#include <stagecraft/mechanics/holonomic.hpp>
#include <stagecraft/mechanics/invariants.hpp>
#include <stagecraft/mechanics/regularisation/regularised_position.hpp>
#include <string>
#include <utility>
#include <vector>

#include <problems/thesis/solve.hpp>

namespace mechanics {

using Eigen::VectorXd;

/// One way to write the equations of motion. States begin with (q, v).
struct formulation {
    std::string name;
    thesis::any_problem problem;
    VectorXd y0;
    std::function<VectorXd(double t, const VectorXd& y)> multiplier;
    std::function<bool(double t, VectorXd& y)> correct;  ///< projects a state; empty where nothing does
    int positions = 0;                                   ///< leading rows q' = v, which RADAU5 makes use of
};

/// The same motion by another way, without constraints: a problem in as many coordinates as there are degrees of
/// freedom, and (q, v) in its states.
struct second_way {
    std::function<thesis::setup_of<long double>()> setup;
    std::function<thesis::vector_of<long double>(const thesis::vector_of<long double>& y)> state;
};

struct body {
    std::string name;
    double end = 1;
    int n = 0, m = 0;
    std::vector<formulation> formulations;
    VectorXd published;  ///< (q, v) at the end, where it is published
    /// max |g|, max |G v + b| and the energy in a state.
    std::function<std::array<double, 3>(double t, const VectorXd& y)> look;
    /// The index-reduced equation and its start in long double, and lambda in a state at the end.
    std::function<thesis::setup_of<long double>()> wide;
    std::function<thesis::vector_of<long double>(const thesis::vector_of<long double>& y)> wide_multiplier;
    second_way alone;  ///< empty where there is none
};

/// Baumgarte's alpha = beta [1/s] and the contact of the regularised form.
struct choices {
    double rate = 20, epsilon = 1e-12;
};

body double_pendulum();
body squeezer();
body disc();
body chain();
body slider_crank();
body four_bar();

namespace detail {

template <class Problem>
formulation written(std::string name, const Problem& problem, const VectorXd& q, const VectorXd& v) {
    using state = Eigen::Matrix<double, Problem::size, 1>;
    constexpr int n = Problem::n;
    using position = Eigen::Matrix<double, n, 1>;
    return {std::move(name),
            thesis::erased(problem),
            problem.initial_state(position(q), position(v)),
            [problem](double t, const VectorXd& y) -> VectorXd { return problem.multiplier(state(y), t); },
            {},
            0};
}

/// The index-reduced equation with every state moved back onto what it has lost.
template <class Model>
formulation projected(const Model& model, const VectorXd& q, const VectorXd& v) {
    using stagecraft::invariants;
    using state = Eigen::Matrix<double, 2 * Model::coordinates, 1>;
    formulation f = written("index-reduced, projected", stagecraft::index_reduced(model), q, v);
    f.correct = [keep = stagecraft::projection_onto(invariants(model))](double t, VectorXd& y) mutable {
        state fixed = y;
        const bool moved = keep.correct(t, fixed);
        if (moved) y = fixed;
        return moved;
    };
    return f;
}

}  // namespace detail

/// A second way by the equation of `free_motion` in n coordinates from (q, v); `state` makes of such coordinates and
/// their rates those of the model.
template <int n, class Problem, class Vector, class State>
second_way alone(const Problem& problem, const Vector& q, const Vector& v, State state) {
    using coordinates = Eigen::Matrix<long double, n, 1>;
    const Eigen::Matrix<long double, 2 * n, 1> y0 = problem.initial_state(
        coordinates(q.template cast<long double>()), coordinates(v.template cast<long double>()));
    return {[=] {
                return thesis::setup_of<long double>{thesis::erased<long double>(problem), y0, {}};
            },
            [=](const auto& y) {
                return state(coordinates(y.template head<n>()), coordinates(y.template tail<n>()));
            }};
}

/// Every formulation of a model that starts at (q, v) and is asked for until `end`. `wide` is the same model
/// for long double.
template <class Model, class Wide>
body describe(std::string name, const Model& model, const Wide& wide, const VectorXd& q, const VectorXd& v,
              double end, const choices& how = {}) {
    using namespace stagecraft;
    using detail::written;
    constexpr int n = Model::coordinates, m = Model::constraints;
    constexpr bool holonomic = holonomic_model<Model>;
    body b{std::move(name), end, n, m, {}, {}, {}, {}, {}, {}};
    const auto add = [&](formulation f, int positions) {
        f.positions = positions;
        b.formulations.push_back(std::move(f));
    };
    add(written("index 2", index_2(model), q, v), n);
    if constexpr (holonomic) {
        add(written("stabilised index 2", stabilised_index_2(model), q, v), 0);
        add(written("index 3", index_3(model), q, v), n);
    }
    add(written("index-reduced", index_reduced(model), q, v), n);
    add(detail::projected(model, q, v), n);
    if constexpr (holonomic) {
        add(written("Baumgarte", baumgarte(model, how.rate, how.rate), q, v), n);
        add(written("regularised", regularised_position(model, how.epsilon, 1.0, 1.0, 1.0), q, v), n);
    } else {
        add(written("index-reduced, damped", index_reduced(model, how.rate), q, v), n);
        add(written("regularised", regularised(model, how.epsilon, 1.0, 1.0, 1.0), q, v), n);
    }
    b.look = [model](double t, const VectorXd& y) -> std::array<double, 3> {
        const coordinate_vector<double, Model> q = y.head<n>(), v = y.segment<n>(n);
        double position = 0;
        if constexpr (holonomic) position = position_constraint<double>(model, q, t).cwiseAbs().maxCoeff();
        return {position, constraint_violation<double>(model, q, v, t), total_energy<double>(model, q, v)};
    };
    using wide_state = Eigen::Matrix<long double, 2 * n, 1>;
    const auto ode = index_reduced<long double>(wide);
    b.wide = [=] {
        const wide_state y0 = (wide_state() << q.cast<long double>(), v.cast<long double>()).finished();
        return thesis::setup_of<long double>{thesis::erased<long double>(ode), y0, {}};
    };
    b.wide_multiplier = [ode, end](const auto& y) -> thesis::vector_of<long double> {
        return ode.multiplier(wide_state(y), static_cast<long double>(end));
    };
    return b;
}

}  // namespace mechanics
