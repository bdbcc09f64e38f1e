// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include <stagecraft/dae/constraints.hpp>
#include <stagecraft/dae/gauss_newton.hpp>

namespace stagecraft {

namespace detail {

/// The block that determines the algebraic components, by index.
inline const char* determining_block(int depth) {
    return depth <= 1   ? "g_z (constraints by algebraic components)"
           : depth == 2 ? "g_y f_z (hidden constraints by algebraic components)"
                        : "g_y f_z k_u (twice differentiated constraints by algebraic components)";
}

template <class Scalar>
std::string singular_text(int depth, int rank, Eigen::Index full, const Scalar& t) {
    std::ostringstream text;
    text << determining_block(depth) << " is singular, rank " << rank << " of " << full << ", at t = " << t;
    return text.str();
}

}  // namespace detail

/// Solves constraints near a state, in the two parts they fall into: those that do not see the algebraic
/// components bind the differential ones (0 = g(t, y) of index 2 and 3, and its derivative of index 3); those
/// that do determine the algebraic ones. Newton's iteration with damping. `what` begins the messages.
///
/// Both throw std::domain_error naming the block that is singular, std::runtime_error if the iteration does
/// not converge.
template <class Problem, class Vector>
class constraint_newton {
  public:
    using system_type = constraint_system<Problem, Vector>;
    using scalar = typename Vector::Scalar;
    using vector = typename system_type::vector;
    using matrix = typename system_type::matrix;

    constraint_newton(Problem& problem, Eigen::Index n, const scalar& time_scale, int iterations,
                      std::string what)
        : system_(problem, n, time_scale), iterations_(iterations), what_(std::move(what)) {}

    system_type& system() { return system_; }
    /// Chooses at (t, x) what is differentiated; before the other two.
    void select(const scalar& t, const Vector& x) { chosen_ = system_.select(t, x); }
    const typename system_type::selection& chosen() const { return chosen_; }
    bool binds_differential() const { return chosen_.once.rows() > 0; }

    /// Moves the differential components onto their constraints: by least change in the 2-norm, or along the
    /// directions in which the algebraic components act (f_z of an index-2 problem). Returns the iterations.
    int bind(const scalar& t, Vector& x, bool along_algebraic) {
        if (!binds_differential()) return 0;
        const auto residual = [&](const Vector& at) -> vector {
            vector r(chosen_.once.rows() + chosen_.twice.rows());
            r.head(chosen_.once.rows()) = chosen_.once * system_.constraints(t, at);
            if (chosen_.twice.rows() > 0)
                r.tail(chosen_.twice.rows()) = chosen_.twice * system_.hidden(t, at, chosen_);
            return r;
        };
        const auto step = [&](const Vector& at, const vector& r) {
            const auto linear = system_.linearise(t, at);
            matrix rows(r.size(), at.size());
            rows.topRows(chosen_.once.rows()) =
                detail::product(chosen_.once, system_.constraint_jacobian(linear));
            if (chosen_.twice.rows() > 0)
                rows.bottomRows(chosen_.twice.rows()) =
                    detail::product(chosen_.twice, system_.hidden_jacobian(t, at, chosen_));
            // The algebraic directions are seen through rounding only, and must not be used.
            const matrix& N = system_.algebraic_directions();
            rows -= detail::product(detail::product(rows, N), N.transpose());
            const matrix along = along_algebraic ? system_.slope_by_algebraic(linear) : matrix(0, 0);
            const detail::row_scaled<matrix> block(along_algebraic ? detail::product(rows, along) : rows,
                                                   rows, zero());
            if (block.rank() < rows.rows()) {
                std::ostringstream text;
                text << what_ << ": "
                     << (along_algebraic ? "g_y f_z (constraints along the algebraic components)"
                                         : "g_y (constraints by differential components)")
                     << " is singular, rank " << block.rank() << " of " << rows.rows() << ", at t = " << t;
                throw std::domain_error(text.str());
            }
            vector change = block.solve(r);
            if (along_algebraic) change = along * change;
            return std::pair<Vector, vector>(-change, block.scale());
        };
        return detail::gauss_newton<scalar>(x, residual, step, iterations_, what_.c_str());
    }

    /// Moves the algebraic components so that all constraints hold. Returns the iterations.
    int determine(const scalar& t, Vector& x) {
        const matrix& N = system_.algebraic_directions();
        const auto residual = [&](const Vector& at) { return system_.all(t, at, chosen_); };
        const auto step = [&](const Vector& at, const vector& r) {
            const matrix by_x = system_.all_jacobian(t, at, chosen_);
            const detail::row_scaled<matrix> block(detail::product(by_x, N), by_x, zero());
            if (block.rank() < N.cols())
                throw std::domain_error(what_ + ": " +
                                        detail::singular_text(system_.depth(), block.rank(), N.cols(), t));
            return std::pair<Vector, vector>(-(N * block.solve(r)), block.scale());
        };
        return detail::gauss_newton<scalar>(x, residual, step, iterations_, what_.c_str());
    }

    /// Moves exactly the components in `free`, by least change, so that all constraints hold.
    template <class Components>
    int solve_for(const scalar& t, Vector& x, const Components& free) {
        const auto residual = [&](const Vector& at) { return system_.all(t, at, chosen_); };
        const auto step = [&](const Vector& at, const vector& r) {
            const matrix by_x = system_.all_jacobian(t, at, chosen_);
            matrix by_free(by_x.rows(), static_cast<Eigen::Index>(free.size()));
            for (std::size_t j = 0; j < free.size(); ++j) by_free.col(j) = by_x.col(free[j]);
            const detail::row_scaled<matrix> block(by_free, by_x, zero());
            if (block.rank() < by_free.rows()) {
                std::ostringstream text;
                text << what_ << ": the free components do not determine the constraints, rank "
                     << block.rank() << " of " << by_free.rows() << " at t = " << t;
                throw std::domain_error(text.str());
            }
            const vector moved = block.solve(r);
            Vector change = Vector::Zero(at.size());
            for (std::size_t j = 0; j < free.size(); ++j) change[free[j]] = -moved[j];
            return std::pair<Vector, vector>(change, block.scale());
        };
        return detail::gauss_newton<scalar>(x, residual, step, iterations_, what_.c_str());
    }

    /// Entries below it, relative to their rows, count as zero.
    scalar zero() const { return system_.depth() > 1 ? system_type::difference_zero() : system_type::zero(); }

  private:
    system_type system_;
    typename system_type::selection chosen_{matrix(0, 0), matrix(0, 0)};
    int iterations_;
    std::string what_;
};

}  // namespace stagecraft
