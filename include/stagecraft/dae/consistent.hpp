// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/dae/constraints.hpp>
#include <stagecraft/dae/gauss_newton.hpp>

namespace stagecraft {

/// One constraint at one point.
template <class Scalar>
struct constraint_value {
    int row;          ///< the equation it comes from (of the combination, the one of largest coefficient)
    int derivatives;  ///< 0: constraint of the problem, 1: differentiated once (hidden), 2: twice
    Scalar value;     ///< what should be zero, in the units of that equation (per unit of time^derivatives)
};

/// Every constraint of a problem at one point, hidden ones included.
template <class Scalar>
struct consistency {
    std::vector<constraint_value<Scalar>> constraints;
    /// Empty where the constraints determine the algebraic components, else the block that is singular there.
    std::string singular;

    /// The largest violation, of the constraints differentiated `derivatives` times or of all of them; 0
    /// where there is none. Not a number if one is.
    Scalar largest(int derivatives = -1) const {
        using std::abs;
        Scalar most(0);
        for (const auto& c : constraints) {
            if (derivatives >= 0 && c.derivatives != derivatives) continue;
            if (!(abs(c.value) <= most)) most = abs(c.value);
        }
        return most;
    }
    /// True if no violation exceeds the bound and no block is singular.
    bool within(const Scalar& bound) const {
        using std::abs;
        for (const auto& c : constraints)
            if (!(abs(c.value) <= bound)) return false;
        return singular.empty();
    }
};

/// What `consistent_initial_values` is told.
template <class Scalar>
struct initial_value_options {
    /// The components that may change. Empty: the algebraic ones (the null space of M), and where constraints
    /// bind differential components these as little as possible in the 2-norm.
    std::vector<int> free{};
    int iterations = 50;   ///< Newton iterations at most
    Scalar time_scale{1};  ///< see constraint_system
};

template <class Vector>
struct consistent_state {
    Vector y;
    int iterations;
    typename Vector::Scalar change;  ///< largest change of a component
    consistency<typename Vector::Scalar> check;
};

namespace detail {

/// The block that determines the algebraic components, by index.
inline const char* determining_block(int depth) {
    return depth <= 1   ? "g_z (constraints by algebraic components)"
           : depth == 2 ? "g_y f_z (hidden constraints by algebraic components)"
                        : "g_y f_z k_u (twice differentiated constraints by algebraic components)";
}

template <class Scalar>
std::string singular_text(int depth, Eigen::Index rank, Eigen::Index full, const Scalar& t) {
    std::ostringstream text;
    text << determining_block(depth) << " is singular, rank " << rank << " of " << full << ", at t = " << t;
    return text.str();
}

}  // namespace detail

/// Every constraint and hidden constraint of M x' = f(t, x) at (t, x), with its size and the equation it
/// comes from: an inconsistent start shows here as a value. For index flags up to 1 the constraints
/// themselves, up to 2 and 3 those differentiated once and twice (constraint_system says how; derivatives of
/// a generic problem are automatic). No constraints where M is regular. Throws what the problem throws.
template <class Problem, class Derived>
auto check_consistent(Problem&& problem, std::type_identity_t<typename Derived::Scalar> t,
                      const Eigen::MatrixBase<Derived>& x,
                      std::type_identity_t<typename Derived::Scalar> time_scale = 1) {
    using vector = typename Derived::PlainObject;
    using scalar = typename Derived::Scalar;
    using system = constraint_system<std::remove_reference_t<Problem>, vector>;
    const vector at = x;
    system constraints(problem, at.size(), time_scale);
    consistency<scalar> result;
    if (constraints.count() == 0) return result;
    const auto s = constraints.select(t, at);
    const auto values = constraints.all(t, at, s);
    const int first = constraints.count(), second = static_cast<int>(s.once.rows());
    for (int i = 0; i < values.size(); ++i) {
        if (i < first) {
            result.constraints.push_back({constraints.row(i), 0, values[i]});
        } else {
            const int k = i < first + second ? i - first : system::largest(s.twice.row(i - first - second));
            const int of = system::largest(s.once.row(k));
            result.constraints.push_back({constraints.row(of), i < first + second ? 1 : 2, values[i]});
        }
    }
    const auto by_x = constraints.all_jacobian(t, at, s);
    const auto& N = constraints.algebraic_directions();
    const detail::row_scaled<scalar> block(
        detail::product(by_x, N), by_x, constraints.depth() > 1 ? system::difference_zero() : system::zero());
    if (block.rank() < N.cols())
        result.singular = detail::singular_text(constraints.depth(), block.rank(), N.cols(), t);
    return result;
}

/// Consistent values near x0: all constraints of check_consistent hold.
///
/// Default, index 1: the differential components (more precisely M x) stay, the algebraic ones solve 0 = g(t,
/// y, z). Index 2: y moves onto g = 0 by the smallest change in the 2-norm, z solves 0 = g_t + g_y f; index 3
/// likewise. With options.free exactly these components move, jointly, by the smallest change if there are
/// more than constraints. Newton's iteration with damping: x0 must be near enough. Models of mechanics have
/// an initial_state() that needs no iteration (problem/mechanical_dae.hpp).
///
/// Throws std::domain_error naming the block that is singular (g_z, g_y f_z, ...) or that the free components
/// do not determine, std::runtime_error if Newton's iteration does not converge, std::invalid_argument for a
/// free component out of range.
template <class Problem, class Derived>
auto consistent_initial_values(Problem&& problem, std::type_identity_t<typename Derived::Scalar> t,
                               const Eigen::MatrixBase<Derived>& x0,
                               const initial_value_options<typename Derived::Scalar>& options = {}) {
    using vector = typename Derived::PlainObject;
    using scalar = typename Derived::Scalar;
    using system = constraint_system<std::remove_reference_t<Problem>, vector>;
    using matrix = typename system::matrix;
    using dynamic = typename system::vector;
    const char* const what = "consistent_initial_values";
    const vector start = x0;
    if (!start.allFinite()) throw std::invalid_argument("consistent_initial_values: x0 must be finite");
    for (int i : options.free)
        if (i < 0 || i >= start.size())
            throw std::invalid_argument("consistent_initial_values: free holds a component out of range");
    consistent_state<vector> result{start, 0, scalar(0), {}};
    vector& x = result.y;
    system constraints(problem, x.size(), options.time_scale);
    if (constraints.count() == 0) return result;
    const auto& N = constraints.algebraic_directions();
    const scalar zero = constraints.depth() > 1 ? system::difference_zero() : system::zero();
    auto s = constraints.select(t, x);

    if (!options.free.empty()) {
        const auto step = [&](const vector& at, const dynamic& r) {
            const matrix by_x = constraints.all_jacobian(t, at, s);
            matrix by_free(by_x.rows(), static_cast<Eigen::Index>(options.free.size()));
            for (std::size_t j = 0; j < options.free.size(); ++j) by_free.col(j) = by_x.col(options.free[j]);
            const detail::row_scaled<scalar> block(by_free, by_x, zero);
            if (block.rank() < by_free.rows()) {
                std::ostringstream text;
                text << what << ": the free components do not determine the constraints, rank "
                     << block.rank() << " of " << by_free.rows() << " at t = " << t;
                throw std::domain_error(text.str());
            }
            const dynamic moved = block.solve(r);
            vector change = vector::Zero(at.size());
            for (std::size_t j = 0; j < options.free.size(); ++j) change[options.free[j]] = -moved[j];
            return std::pair<vector, dynamic>(change, block.scale());
        };
        const auto residual = [&](const vector& at) { return constraints.all(t, at, s); };
        result.iterations = detail::gauss_newton<scalar>(x, residual, step, options.iterations, what);
    } else {
        // The constraints that do not see the algebraic components bind the differential ones; then all of
        // them determine the algebraic ones. The first may see these in higher order: two rounds.
        const auto binding = [&](const vector& at) -> dynamic {
            const dynamic r = constraints.all(t, at, s);
            dynamic part(s.once.rows() + s.twice.rows());
            part << s.once * r.head(s.once.cols()), s.twice * r.segment(constraints.count(), s.twice.cols());
            return part;
        };
        const auto bind = [&](const vector& at, const dynamic& r) {
            const matrix by_x = constraints.all_jacobian(t, at, s);
            matrix rows(s.once.rows() + s.twice.rows(), at.size());
            rows << detail::product(s.once, by_x.topRows(s.once.cols())),
                detail::product(s.twice, by_x.middleRows(constraints.count(), s.twice.cols()));
            // what a first-order step must not use: the algebraic directions, seen only through rounding
            rows -= detail::product(detail::product(rows, N), N.transpose());
            const detail::row_scaled<scalar> block(rows, rows, zero);
            if (block.rank() < rows.rows()) {
                std::ostringstream text;
                text << what << ": g_y (constraints by differential components) is singular, rank "
                     << block.rank() << " of " << rows.rows() << " at t = " << t
                     << ": they are redundant or contradictory";
                throw std::domain_error(text.str());
            }
            return std::pair<vector, dynamic>(vector(-block.solve(r)), block.scale());
        };
        const auto residual = [&](const vector& at) { return constraints.all(t, at, s); };
        const auto determine = [&](const vector& at, const dynamic& r) {
            const matrix by_x = constraints.all_jacobian(t, at, s);
            const detail::row_scaled<scalar> block(detail::product(by_x, N), by_x, zero);
            if (block.rank() < N.cols())
                throw std::domain_error(
                    std::string(what) + ": " +
                    detail::singular_text(constraints.depth(), block.rank(), N.cols(), t));
            return std::pair<vector, dynamic>(vector(-(N * block.solve(r))), block.scale());
        };
        for (int round = 0; round < (s.once.rows() > 0 ? 2 : 1); ++round) {
            if (s.once.rows() > 0)
                result.iterations += detail::gauss_newton<scalar>(x, binding, bind, options.iterations, what);
            if (round > 0) s = constraints.select(t, x);
            result.iterations +=
                detail::gauss_newton<scalar>(x, residual, determine, options.iterations, what);
        }
    }
    for (int i = 0; i < x.size(); ++i) {
        using std::abs;
        if (abs(x[i] - start[i]) > result.change) result.change = abs(x[i] - start[i]);
    }
    result.check = check_consistent(problem, t, x, options.time_scale);
    return result;
}

}  // namespace stagecraft
