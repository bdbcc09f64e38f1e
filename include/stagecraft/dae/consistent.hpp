// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <stagecraft/dae/constraint_newton.hpp>
#include <stagecraft/problem/higher_index.hpp>

namespace stagecraft {

/// The value of one constraint at one point.
template <class Scalar>
struct constraint_value {
    int row;          ///< the equation it comes from (of the combination, the one of largest coefficient)
    int derivatives;  ///< 0: constraint of the problem, 1: differentiated once (hidden), 2: twice
    Scalar value;     ///< what should be zero, in the units of that equation (per unit of time^derivatives)
};

/// The values of all constraints of a problem at one point, hidden ones included.
template <class Scalar>
struct consistency {
    std::vector<constraint_value<Scalar>> constraints;
    /// Empty if the constraints determine the algebraic components, else names the block that is singular.
    std::string singular;

    /// The largest violation of the constraints differentiated `derivatives` times, or of all of them if that
    /// is negative. 0 if there are no such constraints, NaN if one of their values is.
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
    /// The components that may change. If empty: the algebraic ones (the null space of M), and those
    /// differential ones that constraints bind, as little as possible in the 2-norm.
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

/// The value of every constraint and hidden constraint of M x' = f(t, x) at (t, x), and the equation it comes
/// from: an inconsistent start shows as a value that is not zero. With index flags up to 1 these are the
/// constraints themselves, with 2 also those differentiated once, with 3 also those differentiated twice
/// (constraint_system says how; a generic problem is differentiated automatically). None if M is regular.
/// Throws what the problem throws.
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
    typename system::selection s;
    constraints.select(t, at, s);
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
    auto by_z = detail::product(constraints.work(), by_x, N);
    const detail::row_scaled<typename system::workspace> block(
        constraints.work(), by_z, by_x, constraints.depth() > 1 ? system::difference_zero() : system::zero());
    if (block.rank() < N.cols())
        result.singular = detail::singular_text(constraints.depth(), block.rank(), N.cols(), t);
    return result;
}

/// Consistent values near x0: all constraints of check_consistent hold.
///
/// Index 1: the differential components (more precisely M x) stay as they are, the algebraic ones solve 0 =
/// g(t, y, z). Index 2: y moves onto g = 0 by the smallest change in the 2-norm, z solves 0 = g_t + g_y f.
/// Index 3: in the same way with the constraints of index 3. If options.free is given, exactly these
/// components move, all at once, and by the smallest change if there are more of them than constraints.
/// Newton's iteration is damped, but x0 must be near enough. Models of mechanics have an initial_state() that
/// needs no iteration (mechanics/formulations.hpp).
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
    const vector start = x0;
    if (!start.allFinite()) throw std::invalid_argument("consistent_initial_values: x0 must be finite");
    for (int i : options.free)
        if (i < 0 || i >= start.size())
            throw std::invalid_argument("consistent_initial_values: free holds a component out of range");
    consistent_state<vector> result{start, 0, scalar(0), {}};
    vector& x = result.y;
    constraint_newton<std::remove_reference_t<Problem>, vector> newton(
        problem, x.size(), options.time_scale, options.iterations, "consistent_initial_values");
    if (newton.system().count() == 0) return result;
    newton.select(t, x);
    if (!options.free.empty()) {
        result.iterations = newton.solve_for(t, x, options.free);
    } else {
        // Constraints on the differential components may depend weakly on the algebraic ones: two rounds.
        const int rounds = newton.binds_differential() ? 2 : 1;
        for (int round = 0; round < rounds; ++round) {
            result.iterations += newton.bind(t, x, false);
            if (round > 0) newton.select(t, x);
            result.iterations += newton.determine(t, x);
        }
    }
    for (int i = 0; i < x.size(); ++i) {
        using std::abs;
        if (abs(x[i] - start[i]) > result.change) result.change = abs(x[i] - start[i]);
    }
    result.check = check_consistent(problem, t, x, options.time_scale);
    return result;
}

/// What options.consistent_start calls for components of index 2 and 3: consistent_initial_values near y.
template <class Problem, class Vector>
Vector consistent_values(higher_index, Problem& problem, const typename Vector::Scalar& t, const Vector& y) {
    return consistent_initial_values(problem, t, y).y;
}

}  // namespace stagecraft
