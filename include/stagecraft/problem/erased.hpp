// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <stagecraft/break_points.hpp>
#include <stagecraft/jacobian/automatic.hpp>
#include <stagecraft/owned_value.hpp>
#include <stagecraft/problem/capabilities.hpp>
#include <stagecraft/problem/with.hpp>
#include <stagecraft/refuse/problem/checked_call.hpp>

namespace stagecraft {

/// What writes f(t, y), and what writes df/dy, of any problem.
using erased_function = std::function<void(double, const Eigen::VectorXd&, Eigen::VectorXd&)>;
using erased_jacobian = std::function<void(double, const Eigen::VectorXd&, Eigen::MatrixXd&)>;
/// y' = f(t, y) with its Jacobian, and M y' = f(t, y) with M and index besides: what erased(problem) mostly returns.
using erased_ode = detail::rhs_with_jacobian<erased_function, erased_jacobian>;
using erased_dae =
    detail::rhs_with_index<detail::rhs_with_mass<erased_ode, Eigen::MatrixXd>, std::vector<int>>;

namespace detail {

/// call(y, out) in the sizes of State, where these are known at compile time.
template <class State, class Own, class Out, class Call>
void in_sizes_of(const Eigen::VectorXd& y, Out& out, Call&& call) {
    if constexpr (State::SizeAtCompileTime == Eigen::Dynamic) {
        call(y, out);
    } else {
        const State own_y = of_size(y, State::SizeAtCompileTime);
        Own own = out;
        call(own_y, own);
        out = own;
    }
}

/// Its Jacobian, or that of its automatic differentiation, added to f; none where there is neither.
template <class State, class Problem>
auto erased_with_jacobian(const std::shared_ptr<Problem>& problem, erased_function f) {
    constexpr int n = State::SizeAtCompileTime;
    using matrix = Eigen::Matrix<double, n, n>;
    constexpr bool given = has_jacobian<Problem, State, matrix>;
    if constexpr (given || automatically_differentiable<Problem, double, n>) {
        return erased_ode(std::move(f), [problem](double t, const Eigen::VectorXd& y, Eigen::MatrixXd& J) {
            in_sizes_of<State, matrix>(y, J, [&](const State& own_y, matrix& own) {
                if constexpr (given)
                    problem->jacobian(t, own_y, own);
                else
                    automatic_jacobian<double, n>(own_y.size())(*problem, t, own_y, own_y, own);
            });
        });
    } else {
        return f;
    }
}

template <class Problem>
std::vector<int> indices_of(Problem& problem, Eigen::Index n) {
    std::vector<int> indices(static_cast<std::size_t>(n), 1);
    if constexpr (has_index<Problem>) {
        const auto given = problem.index();
        indices.resize(static_cast<std::size_t>(given.size()));
        for (std::size_t i = 0; i < indices.size(); ++i)
            indices[i] = static_cast<int>(given[static_cast<decltype(given.size())>(i)]);
    }
    return indices;
}

template <class Problem>
Eigen::MatrixXd mass_of(Problem& problem) {
    if constexpr (has_mass<Problem>) {
        static_assert(std::constructible_from<Eigen::MatrixXd, decltype(problem.mass())>,
                      "erased(problem): mass() must return a matrix of Eigen's");
        return Eigen::MatrixXd(problem.mass());
    } else {
        const auto n = static_cast<Eigen::Index>(problem.index().size());
        return Eigen::MatrixXd::Identity(n, n);
    }
}

}  // namespace detail

/// The problem behind one type, whatever its own: `integrate(method, erased(problem), y0, ...)` is compiled once for all
/// problems of a program, in one file of it that the others call (and that a foreign language may call as well):
///
///     stagecraft::result<Eigen::VectorXd> run(const stagecraft::erased_ode& problem, const Eigen::VectorXd& y0, double t1) {
///         return stagecraft::integrate(stagecraft::radau_iia<3>(), problem, y0, 0.0, t1);
///     }
///
/// problem  As integrate() takes it, with dense matrices: f written or returned, jacobian(), mass(), index(). Kept as one
///          copy that all copies of the result share. constant_jacobian() and second_order_components, which only save
///          time, are left out; bandwidth(), sparsity(), matrix(), a linear_solver and add_up(), which choose another
///          linear algebra, do not compile.
/// State    The type of y that the problem is written for: erased<Eigen::Vector3d>(problem). y0 is an Eigen::VectorXd
///          always; one of another size ends the run with status::size_changed.
///
/// Returns an erased_ode; an erased_dae where there is mass() or index(); either of them without jacobian() (its functions
/// are erased_function then) where the problem has none and is not generic, so that integrate() takes differences.
/// Costs an indirect call per evaluation and sizes that are not known at compile time. A generic problem is differentiated
/// here, and its dual evaluations are not counted in result.report.
template <class State = Eigen::VectorXd, class Problem>
requires std::same_as<typename State::Scalar, double>
auto erased(Problem problem) {
    static_assert(!in_parts<Problem>,
                  "erased(problem): of split(f_explicit, f_implicit) one part would be lost: erase both, "
                  "split(erased(f_explicit), erased(f_implicit))");
    static_assert(
        !has_bandwidth<Problem> && !has_sparsity<Problem> && !has_matrix<Problem> &&
            !has_linear_solver<Problem> && !has_add_up<Problem, double>,
        "erased(problem): the problem chooses its linear algebra by bandwidth(), sparsity(), matrix(), "
        "linear_solver or add_up(), and an erased one is dense: give it to integrate() as it is");
    static_assert(!has_break_points<Problem> && !has_domain<Problem, State>,
                  "erased(problem): break_points() and domain() of the problem would be lost: give "
                  "options.break_points, and with_domain(erased(problem), inside)");
    if constexpr (detail::returning_right_hand_side<Problem, State>) {
        return erased<State>(detail::writes_returned<Problem>{std::move(problem)});
    } else {
        static_assert(
            checked_call<Problem, State>::good,
            "erased(problem): integrate(method, problem, y0, ...) would refuse it, with a y0 of the type "
            "State, and says why: for a problem that is written for Eigen::Vector3d, say, "
            "erased<Eigen::Vector3d>(problem)");
        const auto shared = std::make_shared<Problem>(std::move(problem));
        auto ode = detail::erased_with_jacobian<State>(
            shared, [shared](double t, const Eigen::VectorXd& y, Eigen::VectorXd& f) {
                detail::in_sizes_of<State, State>(
                    y, f, [&](const State& own_y, State& own) { (*shared)(t, own_y, own); });
            });
        if constexpr (has_mass<Problem> || has_index<Problem>) {
            const Eigen::MatrixXd mass = detail::mass_of(*shared);
            return with_index(with_mass(std::move(ode), mass), detail::indices_of(*shared, mass.rows()));
        } else {
            return ode;
        }
    }
}

}  // namespace stagecraft
