// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <string>
#include <type_traits>

#include <stagecraft/linear/dense_blocks.hpp>
#include <stagecraft/linear/mass.hpp>
#include <stagecraft/run/integrator.hpp>
#include <stagecraft/sensitivity/consistent_start.hpp>
#include <stagecraft/sensitivity/stage_derivatives.hpp>
#include <stagecraft/stages/transformed.hpp>

namespace stagecraft::detail {

/// y' at points of a solution of M y' = f, M diagonal, whose zeros are algebraic equations of index 1.
template <class Problem, class Vector>
class solution_slope {
    using scalar = typename Vector::Scalar;
    using derivatives = forward_derivatives<Problem, Vector>;
    using system_type = typename derivatives::system_type;
    using mass_type = typename system_type::mass_type;
    using by = parameter_derivatives<typename Problem::original, Vector, typename Problem::parameters>;

  public:
    static constexpr bool identity = mass_type::identity;

    /// std::domain_error, which begins with `who`, where there is no such slope.
    solution_slope(const Problem& problem, const Vector& y, const options<scalar>& o, const char* who)
        : problem_(problem), at_(problem, y, o), weights_(Vector::Ones(y.size())) {
        const auto demand = [&](bool good, const char* what) {
            if (!good) throw std::domain_error(std::string(who) + what);
        };
        demand(at_.evaluations().largest_index() < 2,
               ": an event of a problem of index 2 or 3: its y' is not known from f");
        if constexpr (!identity) {
            constexpr const char* diagonal =
                ": an event of a problem whose mass() is not diagonal: write it with a diagonal one";
            if constexpr (!has_entries<mass_type>) {
                demand(false, diagonal);
            } else {
                weights_.setZero();
                for (const auto& e : at_.mass().entries()) {
                    demand(e.row == e.column, diagonal);
                    weights_[e.row] = scalar(1) / e.value;
                }
                demand(by::dual_time || weights_.cwiseAbs().minCoeff() > scalar(0),
                       ": an event of a problem with a singular mass(): f must be generic in t as well");
            }
        }
    }

    /// y' at (t, y), where the algebraic equations hold.
    void operator()(const scalar& t, const Vector& y, Vector& slope) {
        problem_(t, y, slope);
        if constexpr (!identity) {
            slope = slope.cwiseProduct(weights_).eval();
            if constexpr (by::dual_time && has_entries<mass_type>)
                if (weights_.cwiseAbs().minCoeff() == scalar(0)) add_algebraic(t, y, slope);
        }
    }

    /// Moves S by `change` along its own equation, dS/dt = f_y S + f_p; algebraic components are left.
    template <class Matrix>
    void move(const scalar& t, const Vector& y, const scalar& change, Matrix& S) {
        at_.place(0, t, y);
        at_.evaluate(0);
        Vector column = y, rate = y;
        for (Eigen::Index k = 0; k < S.cols(); ++k) {
            column = S.col(k);
            at_(0, column, static_cast<int>(k), rate);
            S.col(k) += change * rate.cwiseProduct(weights_);
        }
    }

  private:
    /// The derivative of the algebraic equations along (1, slope) vanishes by the algebraic components of the slope.
    void add_algebraic(const scalar& t, const Vector& y, Vector& slope) {
        using number = typename by::number;
        at_.place(0, t, y);
        at_.evaluate(0);
        number time(t);
        time.derivatives()[0] = scalar(1);
        const typename by::state at = promoted<number>(y);
        const typename by::values q = promoted<number>(problem_.p);
        typename by::state f(y.size());
        static_cast<const typename Problem::original&>(problem_)(std::as_const(time), at, q, f);
        Vector r = y, x = y, product = y;
        const auto add = [&](const Vector& v, Vector& out) {
            at_(0, v, -1, product);
            out += product;
        };
        for (Eigen::Index i = 0; i < y.size(); ++i) r[i] = f[i].derivatives()[0];
        add(slope, r);
        const matrix_pair<typename system_type::matrix, mass_type> pair{at_.near_jacobian(0), at_.mass()};
        if (!solve_algebraic<typename unstructured<typename system_type::blocks>::type>(pair, r, add, x))
            throw std::domain_error(
                "sensitivities: at an event the algebraic equations are not of index 1, and y' is not known");
        slope += x;
    }

    const Problem& problem_;
    derivatives at_;
    Vector weights_;  // the inverse entries of M, zero of algebraic equations
};

/// Moves y at t to where the equations without a derivative hold, those of index 1, with `other` another time of the run; std::domain_error where no such point is found.
template <class Method, class Problem, class Vector>
void move_to_constraints(const Method& method, const Problem& problem, const typename Vector::Scalar& t,
                         const typename Vector::Scalar& other, options<typename Vector::Scalar> o,
                         Vector& y) {
    if constexpr (has_index<const Problem>) {
        const auto index = problem.index();
        for (Eigen::Index i = 0; i < y.size(); ++i)
            if (index[static_cast<std::size_t>(i)] > 1) return;
    }
    if (t == other) return;
    o.consistent_start = true;
    const Vector start = y;
    integrator<Method, const Problem, Vector> run(method, problem, start, t, other, o);
    run.make_consistent();
    if (run.status() != status::success)
        throw std::domain_error(
            "sensitivities: behind a change the algebraic equations have no solution near");
    y = run.y();
}

}  // namespace stagecraft::detail
