// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include <stagecraft/mechanics/constraint_rank.hpp>
#include <stagecraft/mechanics/contact.hpp>
#include <stagecraft/mechanics/derivatives.hpp>
#include <stagecraft/mechanics/free_motion.hpp>
#include <stagecraft/mechanics/start.hpp>
#include <stagecraft/refuse/mechanics/another_size.hpp>
#include <stagecraft/refuse/mechanics/checked_model.hpp>

namespace stagecraft {

/// On which level the constraints of a formulation stand.
enum class constraint_level { velocity, position, both };

namespace detail {

/// The positions come first and move with the velocities that follow.
template <class Model, bool Moves = true>
struct second_order {};
template <fixed_size_model Model>
struct second_order<Model, true> {
    static constexpr int second_order_components = Model::coordinates;
};

/// What every formulation in (q, v, lambda, ...) shares, with `Multipliers` vectors of the size of lambda: the rows q' = v
/// and M v' = F - G^T lambda, here as v' = M^-1 (F - G^T lambda). M is factored once per evaluation, or never where the
/// model brings `solve_mass`. The equations of the constraints are written by
///
///     derived.constrain(t, y, G, f);         // into f, after the rows of motion
///     derived.differentiate(d, y, J);        // their derivatives, after those of motion
///
/// For models whose size is known at run time see sized_formulations.hpp.
template <class Derived, class Model, class Scalar, int Multipliers>
class equations_of_motion : start_of_another_size<Model, Multipliers>, checked_model<Model> {
  public:
    static constexpr int n = Model::coordinates, m = Model::constraints, size = 2 * n + Multipliers * m;
    using state = Eigen::Matrix<Scalar, size, 1>;

    explicit equations_of_motion(Model model) : model_(std::move(model)) {}

    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, 1>& f) const {
        const Eigen::Matrix<S, m, n> G = constraint_gradient<S>(model_, position(y), t);
        motion<S, Model>(model_, t, y, G, multipliers(y), f);
        derived().constrain(t, y, G, f);
    }
    template <class S>
    void jacobian(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, size>& J) const {
        const acceleration_jacobian<S, Model> d(model_, position(y), velocity(y), multipliers(y), t);
        motion_jacobian(d, 2 * n, J);
        derived().differentiate(d, y, J);
    }

    /// diag(1, ..., 1, 0, ..., 0): singular in the rows of the constraint.
    Eigen::Matrix<Scalar, size, size> mass() const { return leading_identity<Scalar, size>(2 * n); }

    /// (q, v, lambda, 0) with the multiplier consistent with q and v at time t. Throws std::invalid_argument
    /// with the size of each violation if the constraints do not hold to rounding, std::domain_error as
    /// consistent_multiplier does.
    state initial_state(const coordinate_vector<Scalar, Model>& q, const coordinate_vector<Scalar, Model>& v,
                        const Scalar& t = Scalar(0)) const {
        check_start(model_, q, v, t);
        return joined<size>(q, v, consistent_multiplier(model_, q, v, t));
    }
    using start_of_another_size<Model, Multipliers>::initial_state;
    /// The multiplier in a state.
    multiplier_vector<Scalar, Model> multiplier(const state& y, const Scalar& = Scalar(0)) const {
        return multipliers(y);
    }
    const Model& model() const { return model_; }
    /// The rank of G in a state and the constraints that depend on others there, or nearly; empty where none does.
    std::string dependent_constraints(const Scalar& t, const state& y) const {
        return dependence_in_words(constraint_gradient<Scalar>(model_, position(y), t));
    }

  protected:
    template <class S>
    static coordinate_vector<S, Model> position(const Eigen::Matrix<S, size, 1>& y) {
        return part<n>(y, 0);
    }
    template <class S>
    static coordinate_vector<S, Model> velocity(const Eigen::Matrix<S, size, 1>& y) {
        return part<n>(y, n);
    }
    /// lambda, or the k-th vector of its size after it.
    template <class S>
    static multiplier_vector<S, Model> multipliers(const Eigen::Matrix<S, size, 1>& y, int k = 0) {
        return part<m>(y, 2 * n + k * m);
    }
    template <class S>
    static void put_position(const coordinate_vector<S, Model>& q, Eigen::Matrix<S, size, 1>& f) {
        put(q, f, 0);
    }
    template <class S>
    static void put_multipliers(const multiplier_vector<S, Model>& r, Eigen::Matrix<S, size, 1>& f,
                                int k = 0) {
        put(r, f, 2 * n + k * m);
    }
    static std::array<int, size> flags(int second, int third = size) {
        return index_flags<size>(second, third);
    }
    static constexpr int coordinates() { return n; }

    Model model_;

  private:
    const Derived& derived() const { return static_cast<const Derived&>(*this); }
};

/// 1/|G_k|.
template <class S, int m, int n>
Eigen::Matrix<S, m, 1> inverse_lengths(const Eigen::Matrix<S, m, n>& G) {
    using std::sqrt;
    Eigen::Matrix<S, m, 1> result;
    for (int k = 0; k < m; ++k) {
        S square(0);
        for (int j = 0; j < n; ++j) square += G(k, j) * G(k, j);
        result[k] = S(1) / S(sqrt(square));
    }
    return result;
}
/// x_k / |G_k|, by which the rows of G become unit vectors.
template <class S, int m, int n>
requires(m > 0) Eigen::Matrix<S, m, 1> over_lengths(Eigen::Matrix<S, m, 1> x,
                                                    const Eigen::Matrix<S, m, n>& G) {
    const Eigen::Matrix<S, m, 1> unit = inverse_lengths(G);
    for (int k = 0; k < m; ++k) x[k] *= unit[k];
    return x;
}
template <class Matrix>
requires(int(Matrix::RowsAtCompileTime) == Eigen::Dynamic) Eigen::VectorXd
    over_lengths(const Eigen::VectorXd& x, const Matrix& G) {
    const Eigen::VectorXd lengths = (G.cwiseProduct(G) * Eigen::VectorXd::Ones(G.cols())).cwiseSqrt();
    return x.cwiseQuotient(lengths);
}

/// The derivatives of -N^T mu, N with the rows of G divided by their lengths, in the rows of q; mu comes last in the state.
template <class S, class Model, int Size>
void stabilisation_jacobian(const acceleration_jacobian<S, Model>& d, multiplier_vector<S, Model> mu,
                            Eigen::Matrix<S, Size, Size>& J) {
    constexpr int n = Model::coordinates, m = Model::constraints;
    const multiplier_vector<S, Model> unit = inverse_lengths(d.G);
    for (int k = 0; k < m; ++k) mu[k] *= unit[k];
    const Eigen::Matrix<S, n, n> moved = d.force_derivative(mu);
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) J(i, j) = -moved(i, j);
    for (int k = 0; k < m; ++k)
        for (int i = 0; i < n; ++i) {
            J(i, Size - m + k) = -d.G(k, i) * unit[k];
            S turned(0);  // mu_k d log|G_k|/dq_i
            for (int j = 0; j < n; ++j) turned += d.G(k, j) * d.dG(k, j).derivatives()[i];
            turned *= unit[k] * unit[k] * mu[k];
            for (int j = 0; j < n; ++j) J(j, i) += d.G(k, j) * turned;
        }
}

}  // namespace detail

/// The equations of motion of a model with its constraints as they are, in the state (q, v, lambda):
///
///     q' = v,   v' = M(q)^-1 (F - G(q)^T lambda),   0 = G(q) v + b (velocity)  or  0 = g(q) (position)
///
/// (HLR89, section 1; thesis (1.10); a Hessenberg form). On the level of velocity q and v have index 1, lambda 2. On that
/// of position v has index 2, lambda 3: v and lambda are poor, and q accumulates their errors (measured, in
/// tolerances: four-bar linkage at 1e-10, q 4,200 and v 5e4; chain of 60 links at 1e-8, q 255). On both it is the stabilised
/// formulation of Gear, Gupta and Leimkuhler (1985; Hairer-Wanner II, (VII.1.48)), state (q, v, lambda, mu), with
///
///     q' = v - N^T mu,   0 = G v + b,   0 = g(q);
///
/// the rows of N are those of G divided by their lengths, so that mu is a velocity whatever the units of g: where G is
/// small, rounding errors of g in it would otherwise be larger than a tight tolerance. mu vanishes on the exact
/// solution, and both constraints are kept. lambda and mu have index 2. Models of a size known at run time keep M on the
/// left (sized_formulations.hpp). Made by `index_2`, `index_3` and `stabilised_index_2`.
template <mechanical_model Model, constraint_level Level, class Scalar = double>
class formulation : public detail::equations_of_motion<formulation<Model, Level, Scalar>, Model, Scalar,
                                                       Level == constraint_level::both ? 2 : 1>,
                    public detail::second_order<Model, Level == constraint_level::velocity> {
    static constexpr bool of_position = Level != constraint_level::velocity,
                          of_velocity = Level != constraint_level::position,
                          both = of_position && of_velocity;
    using base = detail::equations_of_motion<formulation, Model, Scalar, both ? 2 : 1>;
    friend base;

  public:
    explicit formulation(Model model) requires fixed_size_model<Model> : base(std::move(model)) {}
    /// q is a position that the model can be evaluated at; sizes are checked and the sparsity is found there.
    formulation(Model model, const Eigen::VectorXd& q) requires sized_mechanical_model<Model>
        : base(std::move(model), q) {
        this->find_pattern(q);
    }

    auto index() const {
        const int first = this->coordinates();
        return of_velocity ? this->flags(2 * first) : this->flags(first, 2 * first);
    }

  private:
    template <class S, class Gradient, class State>
    void constrain(const S& t, const State& y, const Gradient& G, State& f) const {
        const auto& model = this->model();
        const auto q = this->position(y);
        auto rate = this->velocity(y);
        if constexpr (of_velocity) this->put_multipliers(velocity_constraint<S>(model, G, q, rate, t), f);
        if constexpr (of_position) this->put_multipliers(position_constraint<S>(model, q, t), f, both);
        if constexpr (both) {
            detail::subtract_transposed(G, detail::over_lengths(this->multipliers(y, 1), G), rate);
            this->put_position(rate, f);
        }
    }

    template <class S, int size>
    void differentiate(const acceleration_jacobian<S, Model>& d, const Eigen::Matrix<S, size, 1>& y,
                       Eigen::Matrix<S, size, size>& J) const {
        if constexpr (both) detail::stabilisation_jacobian<S, Model>(d, this->multipliers(y, 1), J);
        if constexpr (of_velocity) {
            detail::put(d.Gv_q, J, 2 * base::n, 0);
            detail::put(d.G, J, 2 * base::n, base::n);
        }
        if constexpr (of_position) detail::put(d.G, J, size - base::m, 0);
    }
};

/// The formulations of the three levels.
template <class Model, class Scalar = double>
using index_2_dae = formulation<Model, constraint_level::velocity, Scalar>;
template <class Model, class Scalar = double>
using index_3_dae = formulation<Model, constraint_level::position, Scalar>;
template <class Model, class Scalar = double>
using stabilised_dae = formulation<Model, constraint_level::both, Scalar>;

/// The index-2 system q' = v, v' = M^-1 (F - G^T lambda), 0 = G v of a model, ready for `integrate`.
template <class Scalar = double, fixed_size_model Model>
index_2_dae<Model, Scalar> index_2(Model model) {
    return index_2_dae<Model, Scalar>(std::move(model));
}

/// The ordinary differential equation left when the multiplier is eliminated by the once differentiated
/// constraint (thesis (3.17), corrected): state (q, v), lambda = (G M^-1 G^T)^-1 (G M^-1 F + (dG/dt) v + r G
/// v). With r = 0, G v is an invariant that no method keeps exactly: its drift is the price of index
/// reduction. With r = c/d > 0 the violation obeys u' = -r u (thesis (3.45)). For a holonomic model s g(q)
/// may be added to r G v, and the violation obeys g'' + r g' + s g = 0 (Baumgarte 1972). With a nearly massless
/// coordinate take index 2 or GGL: with a mass of 1e-12 beside 1 the rounding of M^-1, of condition 1e12, makes
/// errors of 2e4 tolerances at 1e-10 here, of 0.9 there. Made by `index_reduced` and `baumgarte`.
template <fixed_size_model Model, class Scalar = double>
class index_reduced_ode : public detail::second_order<Model>,
                          detail::start_of_another_size<Model, 0>,
                          checked_model<Model> {
  public:
    static constexpr int n = Model::coordinates, m = Model::constraints, size = 2 * n;

    index_reduced_ode(Model model, Scalar r, Scalar s = Scalar(0))
        : model_(std::move(model)), r_(std::move(r)), s_(std::move(s)) {}

    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, 1>& f) const {
        const coordinate_vector<S, Model> q = detail::part<n>(y, 0), v = detail::part<n>(y, n);
        detail::put(v, f, 0);
        detail::put(constrained<S>(q, v, t).acceleration, f, n);
    }

    template <class S>
    void jacobian(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, size>& J) const {
        const coordinate_vector<S, Model> q = detail::part<n>(y, 0), v = detail::part<n>(y, n);
        const hidden_constraint_jacobian<S, Model> d(model_, q, v, multiplier(q, v, t), t);
        // 0 = Phi(q, v, lambda) + r G v gives d lambda = (G M^-1 G^T)^-1 (Phi_q + r (G v)_q, Phi_v + r G).
        multiplier_matrix<S, Model> inertia;
        for (int k = 0; k < m; ++k)
            for (int i = 0; i < m; ++i) inertia(i, k) = -d.phi_lambda(i, k);
        const small_ldlt<S, m> factors(inertia);
        const S r(r_), s(s_);
        detail::fill(J, S(0));
        for (int j = 0; j < n; ++j) {
            J(j, n + j) = S(1);
            multiplier_vector<S, Model> by_q, by_v;
            for (int k = 0; k < m; ++k) {
                by_q[k] = d.phi_q(k, j) + r * d.Gv_q(k, j);
                if constexpr (holonomic_model<Model>) by_q[k] += s * d.G(k, j);
                by_v[k] = d.phi_v(k, j) + r * d.G(k, j);
            }
            const coordinate_vector<S, Model> from_q = detail::times(d.a_lambda, factors.solve(by_q)),
                                              from_v = detail::times(d.a_lambda, factors.solve(by_v));
            for (int i = 0; i < n; ++i) {
                J(n + i, j) = d.a_q(i, j) + from_q[i];
                J(n + i, n + j) = d.a_v(i, j) + from_v[i];
            }
        }
    }

    /// The multiplier that the differential equation uses at (q, v).
    template <class S>
    multiplier_vector<S, Model> multiplier(const coordinate_vector<S, Model>& q,
                                           const coordinate_vector<S, Model>& v, const S& t) const {
        return constrained<S>(q, v, t).multiplier;
    }
    /// The same in a state (q, v).
    multiplier_vector<Scalar, Model> multiplier(const Eigen::Matrix<Scalar, size, 1>& y,
                                                const Scalar& t = Scalar(0)) const {
        return multiplier<Scalar>(detail::part<n>(y, 0), detail::part<n>(y, n), t);
    }

    /// (q, v); see index_2_dae::initial_state.
    Eigen::Matrix<Scalar, size, 1> initial_state(const coordinate_vector<Scalar, Model>& q,
                                                 const coordinate_vector<Scalar, Model>& v,
                                                 const Scalar& t = Scalar(0)) const {
        detail::check_start(model_, q, v, t);
        consistent_multiplier(model_, q, v, t);  // throws where there is none
        return detail::joined<size>(q, v);
    }
    using detail::start_of_another_size<Model, 0>::initial_state;
    const Model& model() const { return model_; }

  private:
    template <class S>
    struct motion {
        coordinate_vector<S, Model> acceleration;
        multiplier_vector<S, Model> multiplier;
    };
    // One factorisation of M for a = M^-1 F - (M^-1 G^T) lambda and for G M^-1 G^T.
    template <class S>
    motion<S> constrained(const coordinate_vector<S, Model>& q, const coordinate_vector<S, Model>& v,
                          const S& t) const {
        const mass_inverse<S, Model> solve(model_, q);
        const Eigen::Matrix<S, m, n> G = constraint_gradient<S>(model_, q, t);
        const coordinate_vector<S, Model> free = solve(force<S>(model_, q, v, t));
        const Eigen::Matrix<S, n, m> W = solve.of_transposed(G);
        const multiplier_vector<S, Model> curvature = constraint_curvature<S>(model_, q, v, t),
                                          w = velocity_constraint<S>(model_, G, q, v, t);
        multiplier_vector<S, Model> rhs = detail::times(G, free);
        for (int k = 0; k < m; ++k) rhs[k] += curvature[k] + S(r_) * w[k];
        if constexpr (holonomic_model<Model>) {
            const multiplier_vector<S, Model> g = position_constraint<S>(model_, q, t);
            for (int k = 0; k < m; ++k) rhs[k] += S(s_) * g[k];
        }
        motion<S> result{free, small_ldlt<S, m>(detail::product(G, W)).solve(rhs)};
        const coordinate_vector<S, Model> held = detail::times(W, result.multiplier);
        for (int i = 0; i < n; ++i) result.acceleration[i] -= held[i];
        return result;
    }

    Model model_;
    Scalar r_, s_;
};

/// The index-reduced differential equation of a model in (q, v); see `index_reduced_ode`. An integer r stands
/// for that double. Throws std::invalid_argument if r is negative.
template <class Scalar = double, fixed_size_model Model>
index_reduced_ode<Model, detail::real_scalar<Scalar>> index_reduced(Model model, Scalar r = Scalar(0)) {
    using real = detail::real_scalar<Scalar>;
    real rate = static_cast<real>(std::move(r));
    if (!(rate >= real(0))) throw std::invalid_argument("index_reduced: r must not be negative");
    return {std::move(model), std::move(rate)};
}

/// Baumgarte's stabilisation of a model with position constraints, an ordinary differential equation in (q,
/// v): the constraint is replaced by g'' + 2 alpha g' + beta^2 g = 0 (J. Baumgarte 1972, Comput. Methods
/// Appl. Mech. Eng. 1; alpha = beta damps critically). Large values damp the drift fast and make the equation
/// stiff. For constraints of velocity see `index_reduced` with r. Integers stand for those doubles. Throws
/// std::invalid_argument if alpha or beta is negative.
template <class Scalar = double, fixed_size_model Model, class Beta>
requires holonomic_model<Model> index_reduced_ode<Model, detail::real_scalar<Scalar, Beta>> baumgarte(
    Model model, Scalar alpha, Beta beta) {
    using real = detail::real_scalar<Scalar, Beta>;
    const real a = static_cast<real>(alpha), b = static_cast<real>(beta);
    if (!(a >= real(0)) || !(b >= real(0)))
        throw std::invalid_argument("baumgarte: alpha and beta must not be negative");
    return {std::move(model), real(real(2) * a), real(b * b)};
}

}  // namespace stagecraft

// The same names with models that they cannot be used with.
#include <stagecraft/refuse/mechanics/formulations.hpp>
