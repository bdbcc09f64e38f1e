// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include <stagecraft/mechanics/another_size.hpp>
#include <stagecraft/mechanics/contact.hpp>
#include <stagecraft/mechanics/derivatives.hpp>
#include <stagecraft/mechanics/free_motion.hpp>
#include <stagecraft/mechanics/start.hpp>
#include <stagecraft/refuse/detect/refused_call.hpp>

namespace stagecraft {

/// The index-2 system of a mechanical model in the state (q, v, lambda):
///
///     q' = v,   v' = M(q)^-1 (F - G(q)^T lambda),   0 = G(q) v + b
///
/// (HLR89, section 1; thesis (1.10); a Hessenberg form: q and v have index 1, lambda index 2). M is factored
/// once per evaluation, or never where the model brings `solve_mass`. Made by `index_2`.
template <mechanical_model Model, class Scalar = double>
class index_2_dae : detail::start_of_another_size<Model, 1> {
  public:
    static constexpr int n = Model::coordinates, m = Model::constraints, size = 2 * n + m;
    static constexpr int second_order_components = n;

    explicit index_2_dae(Model model) : model_(std::move(model)) {}

    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, 1>& f) const {
        const coordinate_vector<S, Model> q = detail::part<n>(y, 0);
        const Eigen::Matrix<S, m, n> G = constraint_gradient<S>(model_, q, t);
        detail::motion<S, Model>(model_, t, y, G, detail::part<m>(y, 2 * n), f);
        detail::put(velocity_constraint<S>(model_, G, q, detail::part<n>(y, n), t), f, 2 * n);
    }

    template <class S>
    void jacobian(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, size>& J) const {
        const acceleration_jacobian<S, Model> d(model_, detail::part<n>(y, 0), detail::part<n>(y, n),
                                                detail::part<m>(y, 2 * n), t);
        detail::motion_jacobian(d, 2 * n, J);
        detail::put(d.Gv_q, J, 2 * n, 0);
        detail::put(d.G, J, 2 * n, n);
    }

    /// diag(1, ..., 1, 0, ..., 0): singular in the rows of the constraint.
    Eigen::Matrix<Scalar, size, size> mass() const { return detail::leading_identity<Scalar, size>(2 * n); }
    std::array<int, size> index() const { return detail::index_flags<size>(2 * n); }

    /// (q, v, lambda) with the multiplier consistent with q and v at time t. Throws std::invalid_argument
    /// with the size of each violation if the constraints do not hold to rounding, std::domain_error as
    /// consistent_multiplier does.
    Eigen::Matrix<Scalar, size, 1> initial_state(const coordinate_vector<Scalar, Model>& q,
                                                 const coordinate_vector<Scalar, Model>& v,
                                                 const Scalar& t = Scalar(0)) const {
        detail::check_start(model_, q, v, t);
        return detail::joined<size>(q, v, consistent_multiplier(model_, q, v, t));
    }
    using detail::start_of_another_size<Model, 1>::initial_state;
    /// The multiplier in a state.
    multiplier_vector<Scalar, Model> multiplier(const Eigen::Matrix<Scalar, size, 1>& y,
                                                const Scalar& = Scalar(0)) const {
        return detail::part<m>(y, 2 * n);
    }

    const Model& model() const { return model_; }

  private:
    Model model_;
};

/// The index-2 system q' = v, v' = M^-1 (F - G^T lambda), 0 = G v of a model, ready for `integrate`.
template <class Scalar = double, mechanical_model Model>
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
template <mechanical_model Model, class Scalar = double>
class index_reduced_ode : detail::start_of_another_size<Model, 0> {
  public:
    static constexpr int n = Model::coordinates, m = Model::constraints, size = 2 * n;
    static constexpr int second_order_components = n;

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
template <class Scalar = double, mechanical_model Model>
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
template <class Scalar = double, holonomic_model Model, class Beta>
index_reduced_ode<Model, detail::real_scalar<Scalar, Beta>> baumgarte(Model model, Scalar alpha, Beta beta) {
    using real = detail::real_scalar<Scalar, Beta>;
    const real a = static_cast<real>(alpha), b = static_cast<real>(beta);
    if (!(a >= real(0)) || !(b >= real(0)))
        throw std::invalid_argument("baumgarte: alpha and beta must not be negative");
    return {std::move(model), real(real(2) * a), real(b * b)};
}

/// Of constraints of velocity there is no beta.
template <class Scalar = double, mechanical_model Model, class... Rates>
requires(!holonomic_model<Model>) index_reduced_ode<Model, double> baumgarte(Model model, const Rates&...) {
    static_assert(detail::never<Model>,
                  "baumgarte: the model has constraints of velocity only, G v = 0, no g(q): take "
                  "index_reduced(model, r), by which G v decays as exp(-r t)");
    return index_reduced<double>(std::move(model));
}

/// One of the two rates is missing, or both.
template <class Scalar = double, holonomic_model Model, class... Alpha>
requires(sizeof...(Alpha) < 2) index_reduced_ode<Model, double> baumgarte(Model model, const Alpha&...) {
    static_assert(
        detail::never<Model>,
        "baumgarte(model, alpha, beta): give both rates of g'' + 2 alpha g' + beta^2 g = 0; the usual "
        "choice alpha = beta damps critically: baumgarte(model, 10, 10)");
    return index_reduced<double>(std::move(model));
}

/// Without constraints there is nothing to choose a formulation for.
template <class Scalar = double, free_model Model>
free_motion_ode<Model, Scalar> index_2(Model model) {
    static_assert(detail::never<Model>, "index_2: the model has no constraints: take free_motion(model)");
    return free_motion_ode<Model, Scalar>(std::move(model));
}
template <class Scalar = double, free_model Model, class... Rate>
free_motion_ode<Model, double> index_reduced(Model model, const Rate&...) {
    static_assert(detail::never<Model>,
                  "index_reduced: the model has no constraints: take free_motion(model)");
    return free_motion_ode<Model, double>(std::move(model));
}

}  // namespace stagecraft
