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

/// Solves constraints near a state by damped Newton iteration, in two parts. Constraints that do not depend
/// on the algebraic components bind the differential ones (0 = g(t, y) for index 2 and 3, and its derivative
/// for index 3). Constraints that do depend on them determine the algebraic components. Messages begin with
/// `what`.
///
/// Both parts throw std::domain_error that names the block which is singular, and std::runtime_error if the
/// iteration does not converge.
template <class Problem, class Vector>
class constraint_newton {
  public:
    using system_type = constraint_system<Problem, Vector>;
    using scalar = typename Vector::Scalar;
    using workspace = typename system_type::workspace;
    using vector = typename system_type::vector;
    using matrix = typename system_type::matrix;
    using state = typename system_type::state;

    constraint_newton(Problem& problem, Eigen::Index n, const scalar& time_scale, int iterations,
                      std::string what)
        : system_(problem, n, time_scale), iterations_(iterations), what_(std::move(what)) {}

    system_type& system() { return system_; }
    Eigen::Index size() const { return system_.size(); }
    /// Chooses at (t, x) which constraints are differentiated. To be called before the other two.
    void select(const scalar& t, const Vector& x) { system_.select(t, x, chosen_); }
    const typename system_type::selection& chosen() const { return chosen_; }
    bool binds_differential() const { return chosen_.once.rows() > 0; }

    /// Moves the differential components onto their constraints, either by the smallest change in the 2-norm
    /// or along the directions in which the algebraic components act (f_z of an index-2 problem). Returns the
    /// number of iterations.
    int bind(const scalar& t, Vector& x, bool along_algebraic) {
        if (!binds_differential()) return 0;
        auto& work = system_.work();
        const auto total = chosen_.once.rows() + chosen_.twice.rows();
        const auto residual = [&](const Vector& at) {
            vector r = work.take(total);
            r.head(chosen_.once.rows()) = detail::product(work, chosen_.once, system_.constraints(t, at));
            if (chosen_.twice.rows() > 0)
                r.tail(chosen_.twice.rows()) =
                    detail::product(work, chosen_.twice, system_.hidden(t, at, chosen_));
            return r;
        };
        const auto step = [&](const Vector& at, const vector& r) {
            const auto linear = system_.linearise(t, at);
            matrix rows = work.take(total, at.size());
            rows.topRows(chosen_.once.rows()) =
                detail::product(work, chosen_.once, system_.constraint_jacobian(linear));
            if (chosen_.twice.rows() > 0)
                rows.bottomRows(chosen_.twice.rows()) =
                    detail::product(work, chosen_.twice, system_.hidden_jacobian(t, at, chosen_));
            // The algebraic directions are seen through rounding only, and must not be used.
            const auto& N = system_.algebraic_directions();
            rows -= detail::product(work, detail::product(work, rows, N), N.transpose());
            const matrix along = along_algebraic ? system_.slope_by_algebraic(linear) : work.take(0, 0);
            matrix seen = along_algebraic ? detail::product(work, rows, along) : work.take(0, 0);
            const detail::row_scaled<workspace> block(work, along_algebraic ? seen : rows, rows, zero());
            if (block.rank() < rows.rows()) {
                std::ostringstream text;
                text << what_ << ": "
                     << (along_algebraic ? "g_y f_z (constraints along the algebraic components)"
                                         : "g_y (constraints by differential components)")
                     << " is singular, rank " << block.rank() << " of " << rows.rows() << ", at t = " << t;
                throw std::domain_error(text.str());
            }
            const vector moved = block.solve(r);
            return along_algebraic ? correction(detail::product(work, along, moved), block)
                                   : correction(moved, block);
        };
        return detail::gauss_newton(system_.states(), x, residual, step, iterations_, system_.noise(),
                                    what_.c_str());
    }

    /// Moves the algebraic components so that all constraints hold. Returns the number of iterations.
    int determine(const scalar& t, Vector& x) {
        auto& work = system_.work();
        const auto& N = system_.algebraic_directions();
        const auto residual = [&](const Vector& at) { return system_.all(t, at, chosen_); };
        const auto step = [&](const Vector& at, const vector& r) {
            const matrix by_x = system_.all_jacobian(t, at, chosen_);
            matrix by_z = detail::product(work, by_x, N);
            const detail::row_scaled<workspace> block(work, by_z, by_x, zero());
            if (block.rank() < N.cols())
                throw std::domain_error(what_ + ": " +
                                        detail::singular_text(system_.depth(), block.rank(), N.cols(), t));
            return correction(detail::product(work, N, block.solve(r)), block);
        };
        return detail::gauss_newton(system_.states(), x, residual, step, iterations_, system_.noise(),
                                    what_.c_str());
    }

    /// Moves exactly the components in `free`, by least change, so that all constraints hold.
    template <class Components>
    int solve_for(const scalar& t, Vector& x, const Components& free) {
        const auto residual = [&](const Vector& at) { return system_.all(t, at, chosen_); };
        const auto step = [&](const Vector& at, const vector& r) {
            const matrix by_x = system_.all_jacobian(t, at, chosen_);
            matrix by_free = system_.work().take(by_x.rows(), static_cast<Eigen::Index>(free.size()));
            for (std::size_t j = 0; j < free.size(); ++j) by_free.col(j) = by_x.col(free[j]);
            const detail::row_scaled<workspace> block(system_.work(), by_free, by_x, zero());
            if (block.rank() < by_free.rows()) {
                std::ostringstream text;
                text << what_ << ": the free components do not determine the constraints, rank "
                     << block.rank() << " of " << by_free.rows() << " at t = " << t;
                throw std::domain_error(text.str());
            }
            const vector moved = block.solve(r);
            vector change = system_.work().take(at.size());
            change.setZero();
            for (std::size_t j = 0; j < free.size(); ++j) change[free[j]] = moved[j];
            return correction(change, block);
        };
        return detail::gauss_newton(system_.states(), x, residual, step, iterations_, system_.noise(),
                                    what_.c_str());
    }

    /// Entries below it, relative to their rows, count as zero.
    scalar zero() const { return system_.depth() > 1 ? system_type::difference_zero() : system_type::zero(); }

  private:
    /// What gauss_newton is told: the change of the state is -moved.
    std::pair<state, vector> correction(const vector& moved, const detail::row_scaled<workspace>& block) {
        std::pair<state, vector> result(system_.states().take(moved.size()),
                                        system_.work().take(block.scale().size()));
        result.first = -moved;
        result.second = block.scale();
        return result;
    }

    system_type system_;
    typename system_type::selection chosen_;
    int iterations_;
    std::string what_;
};

}  // namespace stagecraft
