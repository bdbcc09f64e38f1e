// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <type_traits>
#include <utility>

#include <stagecraft/mechanics/derivatives.hpp>
#include <stagecraft/mechanics/model.hpp>
#include <stagecraft/refuse/mechanics/given_energies.hpp>

namespace stagecraft {

/// What kinetic energy T(q, v), potential energy V(q) and generalised forces Q(q, v, t) give: M and F of the equations
/// of Lagrange
///
///     d/dt dT/dv - dT/dq = -dV/dq + Q - G^T lambda,
///
/// as M(q) a = F(q, v) - G^T lambda. T is a quadratic polynomial in v (any mechanical system at rest or in moving
/// frames), so that its second derivative M, and dT/dv, are differences of values of T without any error but rounding
/// (polarisation). The derivatives with respect to q are taken by automatic differentiation. One F costs 2 n + 2
/// evaluations of T in dual numbers. By itself a model without constraints, for `free_motion`.
template <int Coordinates, class Parts>
class lagrangian_energies {
    using Forces = decltype(Parts::Q);
    template <class S>
    using vector = Eigen::Matrix<S, Coordinates, 1>;

  public:
    static constexpr int coordinates = Coordinates;

    explicit lagrangian_energies(Parts parts) : parts_(std::move(parts)) {}

    template <class S>
    Eigen::Matrix<S, Coordinates, Coordinates> M(const vector<S>& q) const {
        Eigen::Matrix<S, Coordinates, Coordinates> M;
        const S least = parts_.T(q, zero<S>());
        vector<S> single;
        for (int i = 0; i < Coordinates; ++i) single[i] = parts_.T(q, unit<S>(i));
        for (int i = 0; i < Coordinates; ++i) {
            for (int j = 0; j <= i; ++j) {
                vector<S> both = unit<S>(i);
                both[j] += S(1);
                M(i, j) = M(j, i) = parts_.T(q, both) - single[i] - single[j] + least;
            }
        }
        return M;
    }

    /// False if T is no quadratic polynomial in v, so that M(q) would not be its second derivative: seen at one v.
    template <class S>
    bool quadratic_in_v(const vector<S>& q) const {
        using std::abs;
        vector<S> w, twice;
        for (int i = 0; i < Coordinates; ++i) w[i] = S(6 + i) / S(4), twice[i] = S(2) * w[i];
        const vector<S> Mw = detail::times(M<S>(q), w);
        const S far = parts_.T(q, twice), near = S(2) * parts_.T(q, w), least = parts_.T(q, zero<S>());
        S by_mass(0);
        for (int i = 0; i < Coordinates; ++i) by_mass += w[i] * Mw[i];
        const S size = abs(far) + abs(near) + abs(least) + abs(by_mass);
        return abs(far - near + least - by_mass) <= S(1000) * Eigen::NumTraits<S>::epsilon() * size;
    }

    template <class S>
    vector<S> F(const vector<S>& q, const vector<S>& v, const S& t) const {
        return balance<S>(q, v, zero<S>(), t);
    }

    /// F(q, v) - M(q) a at the cost of F: the equations of Lagrange along q' = v, v' = a. Derivatives of the motion
    /// need no derivative of M where a model has this member.
    template <class S>
    vector<S> balance(const vector<S>& q, const vector<S>& v, const vector<S>& a, const S& t) const {
        using rate = dual_number<S, 1>;
        using dual = dual_number<S, Coordinates>;
        const Eigen::Matrix<dual, Coordinates, 1> moving = detail::variables<dual>(q);
        const dual lagrange = parts_.T(moving, detail::constants<dual>(v)) - parts_.V(moving);
        vector<S> F = lagrange.derivatives();
        // d/dt of dT/dv along q' = v, v' = a: dT/dv_i = (T(v + e_i) - T(v - e_i)) / 2.
        Eigen::Matrix<rate, Coordinates, 1> along, w;
        for (int i = 0; i < Coordinates; ++i) {
            along[i].value() = q[i];
            along[i].derivatives()[0] = v[i];
            w[i].value() = v[i];
            w[i].derivatives()[0] = a[i];
        }
        for (int i = 0; i < Coordinates; ++i) {
            w[i].value() = v[i] + S(1);
            const rate up = parts_.T(along, w);
            w[i].value() = v[i] - S(1);
            const rate down = parts_.T(along, w);
            w[i].value() = v[i];
            F[i] -= (up.derivatives()[0] - down.derivatives()[0]) / S(2);
        }
        if constexpr (!std::is_same_v<Forces, no_forces>) {
            const vector<S> force = detail::of_size(parts_.Q(q, v, t), Coordinates);
            for (int i = 0; i < Coordinates; ++i) F[i] += force[i];
        }
        return F;
    }

    template <class S>
    S potential(const vector<S>& q) const {
        return parts_.V(q);
    }

  protected:
    Parts parts_;

  private:
    template <class S>
    static vector<S> zero() {
        vector<S> x;
        detail::fill(x, S(0));
        return x;
    }
    template <class S>
    static vector<S> unit(int i) {
        vector<S> e = zero<S>();
        e[i] = S(1);
        return e;
    }
};

/// A mechanical model from its energies and a constraint of position or of velocity. Made by `lagrangian`.
template <int Coordinates, int Constraints, class Parts>
class lagrangian_model : public lagrangian_energies<Coordinates, Parts> {
    using base = lagrangian_energies<Coordinates, Parts>;
    using base::parts_;
    using Constraint = decltype(Parts::constraint);
    template <class S>
    using vector = Eigen::Matrix<S, Coordinates, 1>;
    /// True if the constraint depends on t as well (a temporary, which none that writes takes); what it returns, a number as
    /// 1 x 1.
    static constexpr bool moves = std::is_invocable_v<const Constraint&, const vector<double>&, double>;
    static constexpr auto shape = [] {
        using returned = typename detail::returned_by<Constraint, vector<double>, moves>::type;
        if constexpr (std::is_arithmetic_v<returned>)
            return std::array{1, 1};
        else
            return std::array{int(returned::RowsAtCompileTime), int(returned::ColsAtCompileTime)};
    }();
    static constexpr int columns = shape[1];
    static constexpr bool of_position = columns == 1, affine = columns == Coordinates + 1;

  public:
    /// `constraints` is what the constraint returns where that is known, so that a call with another number is
    /// refused by these alone.
    static constexpr int constraints = shape[0] < 0 ? Constraints : shape[0];
    static constexpr bool columns_fit = of_position || affine || columns == Coordinates,
                          rows_fit = constraints == Constraints;

    using base::base;

    /// The gradient of the position constraints, or the matrix that was given.
    template <class S>
    Eigen::Matrix<S, constraints, Coordinates> G(const vector<S>& q, const S& t) const {
        if constexpr (of_position) {
            using dual = dual_number<S, Coordinates>;
            const auto g = constraint(detail::variables<dual>(q), detail::constant<dual>(t));
            Eigen::Matrix<S, constraints, Coordinates> G;
            for (int k = 0; k < constraints; ++k)
                for (int i = 0; i < Coordinates; ++i) G(k, i) = g[k].derivatives()[i];
            return G;
        } else {
            return constraint(q, t).template leftCols<Coordinates>();
        }
    }

    /// The position constraints.
    template <class S>
    Eigen::Matrix<S, constraints, 1> g(const vector<S>& q, const S& t) const requires(of_position) {
        return constraint(q, t);
    }
    /// Their derivative by t; the last column of an affine constraint.
    template <class S>
    Eigen::Matrix<S, constraints, 1> b(const vector<S>& q, const S& t) const
        requires(affine || (of_position && moves)) {
        if constexpr (affine) {
            return constraint(q, t).col(Coordinates);
        } else {
            using rate = dual_number<S, 1>;
            rate time = detail::constant<rate>(t);
            time.derivatives()[0] = S(1);
            const auto g = constraint(detail::constants<rate>(q), time);
            Eigen::Matrix<S, constraints, 1> b;
            for (int k = 0; k < constraints; ++k) b[k] = g[k].derivatives()[0];
            return b;
        }
    }

  private:
    template <class S>
    Eigen::Matrix<S, constraints, columns> constraint(const vector<S>& q, [[maybe_unused]] const S& t) const {
        const auto value = [&] {
            if constexpr (moves)
                return parts_.constraint(q, t);
            else
                return parts_.constraint(q);
        }();
        if constexpr (std::is_convertible_v<decltype(value), S>)
            return Eigen::Matrix<S, 1, 1>(S(value));
        else
            return detail::of_size(value, constraints, columns);
    }
};

/// The model with kinetic energy T(q, v), potential energy V(q) and constraint(q) or constraint(q, t), all
/// generic callables on Eigen vectors (`[](const auto& q, const auto& v) { return 0.5 * m * v.squaredNorm();
/// }`) and in t (`const auto& t`). What they return is a number, or a matrix (`.eval()`), not an expression of Eigen's, which
/// refers to what may be gone. The constraint returns either a number or column of m position constraints,
/// 0 = g, whose gradient is taken automatically (the model is then holonomic), or the m x n matrix G of velocity
/// constraints 0 = G v, or the m x (n + 1) matrix (G, b) of affine ones, 0 = G v + b.
/// M must be positive definite: where it is not, but is on the velocities that the constraints admit (Euler parameters
/// with their length), add a multiple of (G v + b)^2 to T, which makes M regular and changes neither motion nor lambda.
/// Q(q, v, t), if given, returns the generalised forces besides the potential: damping, drives, friction. No
/// derivative is written by hand, so that none can be wrong. Vectors of second derivatives lie on the stack, which limits
/// n to 24 (EIGEN_STACK_ALLOCATION_LIMIT); beyond, write a mechanical_model of a size known at run time.
template <int Coordinates, int Constraints, class Kinetic, class Potential, class Constraint,
          class Forces = no_forces>
requires(Constraints > 0 && detail::given_energies<Coordinates, Constraints, Kinetic, Potential, Constraint,
                                                   Forces>::usable) auto lagrangian(Kinetic T, Potential V,
                                                                                    Constraint constraint,
                                                                                    Forces Q = {}) {
    using parts = detail::lagrangian_parts<Kinetic, Potential, Constraint, Forces>;
    return lagrangian_model<Coordinates, Constraints, parts>(
        parts{std::move(T), std::move(V), std::move(constraint), std::move(Q)});
}

/// The model without constraints that these energies give, and with the forces Q(q, v, t): M and F for `free_motion`,
/// where the coordinates are as many as the degrees of freedom (angles, say). Constraints, if given, is 0.
template <int Coordinates, int Constraints = 0, class Kinetic, class Potential, class Forces = no_forces>
requires(Constraints == 0 && detail::given_energies<Coordinates, 0, Kinetic, Potential, no_constraint,
                                                    Forces>::usable) auto lagrangian(Kinetic T, Potential V,
                                                                                     Forces Q = {}) {
    using parts = detail::lagrangian_parts<Kinetic, Potential, no_constraint, Forces>;
    return lagrangian_energies<Coordinates, parts>(parts{std::move(T), std::move(V), {}, std::move(Q)});
}

}  // namespace stagecraft

// The same name with what cannot be meant.
#include <stagecraft/refuse/mechanics/lagrangian.hpp>
