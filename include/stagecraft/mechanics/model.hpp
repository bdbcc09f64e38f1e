// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <cstddef>
#include <string>
#include <type_traits>

#include <stagecraft/jacobian/dual_functions.hpp>
#include <stagecraft/linear/small_ldlt.hpp>
#include <stagecraft/linear/small_loops.hpp>
#include <stagecraft/owned_value.hpp>

namespace stagecraft {

namespace detail {

template <class Model>
concept sizes_at_compile_time = requires {
    requires(0 < Model::constraints) && (Model::constraints < Model::coordinates);
};
template <class Model>
concept sizes_at_run_time = requires(const Model& model) {
    { model.coordinates() } -> std::convertible_to<int>;
    { model.constraints() } -> std::convertible_to<int>;
};

/// What a model states; Eigen::Dynamic where it is told at run time.
template <class Model>
requires sizes_at_run_time<Model> || requires { Model::coordinates; }
constexpr int coordinates_of() {
    if constexpr (sizes_at_run_time<Model>)
        return Eigen::Dynamic;
    else
        return Model::coordinates;
}
template <class Model>
requires sizes_at_run_time<Model> || requires { Model::constraints; }
constexpr int constraints_of() {
    if constexpr (sizes_at_run_time<Model>)
        return Eigen::Dynamic;
    else
        return Model::constraints;
}

}  // namespace detail

/// q, q', q'' and forces of a model; its multipliers; G M^-1 G^T.
template <class S, class Model>
using coordinate_vector = Eigen::Matrix<S, detail::coordinates_of<Model>(), 1>;
template <class S, class Model>
using multiplier_vector = Eigen::Matrix<S, detail::constraints_of<Model>(), 1>;
template <class S, class Model>
using multiplier_matrix = Eigen::Matrix<S, detail::constraints_of<Model>(), detail::constraints_of<Model>()>;

namespace detail {

inline constexpr auto M_of = [](const auto& m, const auto&... x) -> decltype(m.M(x...)) { return m.M(x...); };
inline constexpr auto F_of = [](const auto& m, const auto&... x) -> decltype(m.F(x...)) { return m.F(x...); };
inline constexpr auto G_of = [](const auto& m, const auto&... x) -> decltype(m.G(x...)) { return m.G(x...); };
inline constexpr auto b_of = [](const auto& m, const auto&... x) -> decltype(m.b(x...)) { return m.b(x...); };
inline constexpr auto g_of = [](const auto& m, const auto&... x) -> decltype(m.g(x...)) { return m.g(x...); };

/// That member of a model has one of these forms, with such values: without arguments, of q or of q and t.
template <class Member, class Value, class Model, class... X>
concept member_with = std::is_invocable_r_v<Value, const Member&, const Model&, const X&...> ||
    std::is_invocable_r_v<Value, const Member&, const Model&, const X&..., const double&>;
template <class Member, class Value, class Model>
concept member_at = member_with<Member, Value, Model, coordinate_vector<double, Model>>;

template <class Member, class Model, class X = const coordinate_vector<double, Model>&>
concept callable_at = std::is_invocable_v<const Member&, const Model&, X> ||
    std::is_invocable_v<const Member&, const Model&, X, const double&>;
template <class Model, int n = coordinates_of<Model>()>
concept inert_model = member_at<decltype(M_of), Eigen::Matrix<double, n, n>, Model> ||
    member_with<decltype(M_of), Eigen::Matrix<double, n, n>, Model>;
template <class Model, class Vector = coordinate_vector<double, Model>>
concept forced_model = member_with<decltype(F_of), Vector, Model, Vector, Vector>;
template <class Model, int n = coordinates_of<Model>(), int m = constraints_of<Model>()>
concept constrained_model = member_at<decltype(G_of), Eigen::Matrix<double, m, n>, Model>;
template <class Model>
concept sized_model = sizes_at_compile_time<Model> || sizes_at_run_time<Model>;

}  // namespace detail

/// A constrained mechanical system M(q) q'' = F(q, q') - G(q)^T lambda, 0 = G(q) q' (constraints on the
/// velocities, for instance rolling without slip), as a type `Model`. Its size is known at compile time:
///
///     static constexpr int coordinates = n, constraints = m;   // 0 < m < n
///     template <class S> Eigen::Matrix<S, n, n> M(const Eigen::Matrix<S, n, 1>& q) const;
///     template <class S>
///     Eigen::Matrix<S, n, 1> F(const Eigen::Matrix<S, n, 1>& q, const Eigen::Matrix<S, n, 1>& v) const;
///     template <class S> Eigen::Matrix<S, m, n> G(const Eigen::Matrix<S, n, 1>& q) const;
///
/// where all three are templates on the scalar: derivatives are taken by automatic differentiation and the same model
/// runs at any precision. Or it is known at run time, however large (chains, nets, models read from a file):
///
///     int coordinates() const;  int constraints() const;          // n >= 1, 0 <= m <= n
///     matrix M() const  or  M(const Eigen::VectorXd& q) const;    // M() is constant
///     Eigen::VectorXd F(const Eigen::VectorXd& q, const Eigen::VectorXd& v) const;
///     matrix G(const Eigen::VectorXd& q) const;
///
/// where a matrix is dense, diagonal or sparse, and derivatives are differences; a sparse G makes the linear algebra of the
/// whole system sparse, and its formulations (sized_formulations.hpp) are given a position as well. F may take the
/// time as a third argument, G as a second one. They return matrices, not expressions of Eigen's (as `auto` would),
/// which refer to what may be gone. M is symmetric positive definite and G has full rank wherever the motion goes.
/// Optional members of both kinds:
///
///     b(q, t) or b(q)     // affine and moving constraints 0 = G(q, t) v + b(q, t): a turntable, a driven wheel
///     g(q) or g(q, t)     // constraints of position, 0 = g, with G = dg/dq and b = dg/dt: a holonomic_model
///
/// and of those of a size known at compile time:
///
///     solve_mass(q, r)    // M(q)^-1 r in closed form, in place of a factorisation of M(q)
///     G_rate(q, v)        // dG/dt along q' = v, in place of automatic differentiation
///     balance(q, v, a, t) // F - M(q) a, where the two together cost less than each: derivatives take this one
///     potential(q)        // the potential energy
///     singularity(q), singular_position   // a function that vanishes where M(q) is singular, and those
///                                         // positions in words
///
/// Everything below is derived from the model without further input.
template <class Model>
concept mechanical_model = detail::sized_model<Model> && detail::inert_model<Model> &&
    detail::forced_model<Model> && detail::constrained_model<Model>;
/// One whose size is a constant, or is told at run time.
template <class Model>
concept fixed_size_model = mechanical_model<Model> && detail::sizes_at_compile_time<Model>;
template <class Model>
concept sized_mechanical_model = mechanical_model<Model> && detail::sizes_at_run_time<Model>;

/// A mechanical model whose constraint is one of position. Its velocity constraint G v + b = 0 alone makes it a
/// mechanical_model already.
template <class Model>
concept holonomic_model = mechanical_model<Model> &&
    detail::member_at<decltype(detail::g_of), multiplier_vector<double, Model>, Model>;

/// A mechanical model without constraints, M(q) q'' = F(q, q'): as `mechanical_model`, without G and `constraints`.
template <class Model>
concept free_model = Model::coordinates >
0 && !requires { Model::constraints; }
&&detail::inert_model<Model>;

template <class Model>
concept has_mass_solver = requires(const Model& m, const coordinate_vector<double, Model>& q) {
    { m.solve_mass(q, q) } -> detail::owns_numbers;
};
template <class Model>
concept has_constraint_rate = requires(const Model& m, const coordinate_vector<double, Model>& q) {
    { m.G_rate(q, q) } -> detail::owns_numbers;
};
template <class Model>
concept has_balance = requires(const Model& m, const coordinate_vector<double, Model>& q, double t) {
    { m.balance(q, q, q, t) } -> detail::owns_numbers;
};
/// True if the velocity constraint is affine, 0 = G v + b.
template <class Model>
concept has_prescribed_velocity = detail::callable_at<decltype(detail::b_of), Model>;
template <class Model>
concept has_potential = requires(const Model& m, const coordinate_vector<double, Model>& q) {
    { m.potential(q) } -> detail::owned_number;
};
template <class Model>
concept names_singular_positions = requires(const Model& m, const coordinate_vector<double, Model>& q) {
    { m.singularity(q) } -> detail::owned_number;
    { Model::singular_position } -> std::convertible_to<std::string>;
};

/// M(q), or M() where it is constant.
template <class S, class Model>
auto mass_matrix(const Model& model, [[maybe_unused]] const coordinate_vector<S, Model>& q) {
    if constexpr (requires { model.M(); })
        return model.M();
    else
        return model.M(q);
}

/// F(q, v) or F(q, v, t), whichever the model has.
template <class S, class Model, class Time>
coordinate_vector<S, Model> force(const Model& model, const coordinate_vector<S, Model>& q,
                                  const coordinate_vector<S, Model>& v, const Time& t) {
    if constexpr (requires { model.F(q, v, S(t)); })
        return model.F(q, v, S(t));
    else
        return model.F(q, v);
}

/// G(q, t) or G(q), whichever the model has: an object of whatever type it returns.
template <class S, class Model, class Time>
auto constraint_gradient(const Model& model, const coordinate_vector<S, Model>& q, const Time& t) {
    constexpr int m = detail::constraints_of<Model>(), n = detail::coordinates_of<Model>();
    const auto G = [&]() -> decltype(auto) {
        if constexpr (requires { model.G(q, S(t)); })
            return model.G(q, S(t));
        else
            return model.G(q);
    };
    using returned = std::remove_cvref_t<decltype(G())>;
    return std::conditional_t<detail::sizes_at_run_time<Model>, returned, Eigen::Matrix<S, m, n>>(G());
}

/// g(q, t) or g(q), whichever the model has.
template <class S, holonomic_model Model, class Time>
multiplier_vector<S, Model> position_constraint(const Model& model, const coordinate_vector<S, Model>& q,
                                                const Time& t) {
    if constexpr (requires { model.g(q, S(t)); })
        return model.g(q, S(t));
    else
        return model.g(q);
}

/// The velocity that an affine constraint prescribes, b of 0 = G v + b; zero unless the model has a member b.
template <class S, class Model, class Time>
multiplier_vector<S, Model> prescribed_velocity([[maybe_unused]] const Model& model,
                                                [[maybe_unused]] const coordinate_vector<S, Model>& q,
                                                [[maybe_unused]] const Time& t) {
    if constexpr (requires { model.b(q, S(t)); }) return model.b(q, S(t));
    if constexpr (requires { model.b(q); }) return model.b(q);
    multiplier_vector<S, Model> b;
    detail::fill(b, S(0));
    return b;
}

/// The velocity constraint G(q, t) v + b(q, t), which vanishes along the motion, with this G.
template <class S, class Model, class Gradient>
multiplier_vector<S, Model> velocity_constraint(const Model& model, const Gradient& G,
                                                const coordinate_vector<S, Model>& q,
                                                const coordinate_vector<S, Model>& v, const S& t) {
    multiplier_vector<S, Model> w = detail::times(G, v);
    if constexpr (has_prescribed_velocity<Model>) w += prescribed_velocity<S>(model, q, t);
    return w;
}
/// The same with G of the model at q and t.
template <class S, class Model>
multiplier_vector<S, Model> velocity_constraint(const Model& model, const coordinate_vector<S, Model>& q,
                                                const coordinate_vector<S, Model>& v,
                                                const std::type_identity_t<S>& t = S(0)) {
    return velocity_constraint<S>(model, constraint_gradient<S>(model, q, t), q, v, t);
}

/// M(q)^-1 for one q: the model's closed form, or one factorisation at construction.
template <class S, class Model>
class mass_inverse {
  public:
    mass_inverse(const Model& model, const coordinate_vector<S, Model>& q)
        : model_(model), q_(q), factors_(model, q) {}

    coordinate_vector<S, Model> operator()(const coordinate_vector<S, Model>& r) const {
        if constexpr (has_mass_solver<Model>)
            return model_.solve_mass(q_, r);
        else
            return factors_.solve(r);
    }
    /// Replaces every column of B by M^-1 times it.
    template <int Columns>
    void in_place(Eigen::Matrix<S, Model::coordinates, Columns>& B) const {
        coordinate_vector<S, Model> r;
        for (int j = 0; j < Columns; ++j) {
            for (int i = 0; i < Model::coordinates; ++i) r[i] = B(i, j);
            r = (*this)(r);
            for (int i = 0; i < Model::coordinates; ++i) B(i, j) = r[i];
        }
    }
    /// M^-1 G^T.
    template <int Rows>
    Eigen::Matrix<S, Model::coordinates, Rows> of_transposed(
        const Eigen::Matrix<S, Rows, Model::coordinates>& G) const {
        Eigen::Matrix<S, Model::coordinates, Rows> W;
        for (int k = 0; k < Rows; ++k)
            for (int i = 0; i < Model::coordinates; ++i) W(i, k) = G(k, i);
        in_place(W);
        return W;
    }

  private:
    struct closed_form {
        closed_form(const Model&, const coordinate_vector<S, Model>&) {}
    };
    struct factored : small_ldlt<S, Model::coordinates> {
        factored(const Model& model, const coordinate_vector<S, Model>& q)
            : small_ldlt<S, Model::coordinates>(model.M(q)) {}
    };
    const Model& model_;
    coordinate_vector<S, Model> q_;
    [[no_unique_address]] std::conditional_t<has_mass_solver<Model>, closed_form, factored> factors_;
};

/// What d/dt (G(q, t) v + b(q, t)) has along q' = v beside G v': (dG/dt) v + db/dt. Derivatives of `Width` directions are
/// taken, of which one is used: who has G in such numbers already compiles nothing more.
template <class S, class Model, int Width = 1>
multiplier_vector<S, Model> constraint_curvature(const Model& model, const coordinate_vector<S, Model>& q,
                                                 const coordinate_vector<S, Model>& v,
                                                 const std::type_identity_t<S>& t = S(0)) {
    if constexpr (has_constraint_rate<Model>) {
        return model.G_rate(q, v) * v;
    } else {
        using dual = dual_number<S, Width>;
        coordinate_vector<dual, Model> moving;
        for (int i = 0; i < Model::coordinates; ++i) {
            moving[i].value() = q[i];
            moving[i].derivatives()[0] = v[i];
        }
        dual time(t);
        time.derivatives()[0] = S(1);
        const Eigen::Matrix<dual, Model::constraints, Model::coordinates> G =
            constraint_gradient<dual>(model, moving, time);
        const multiplier_vector<dual, Model> b = prescribed_velocity<dual>(model, moving, time);
        multiplier_vector<S, Model> result;
        for (int i = 0; i < Model::constraints; ++i) {
            result[i] = b[i].derivatives()[0];
            for (int j = 0; j < Model::coordinates; ++j) result[i] += G(i, j).derivatives()[0] * v[j];
        }
        return result;
    }
}

/// G M^-1 G^T, which is -g_y f_lambda of the index-2 system and must be regular (thesis, model assumption 3).
template <class S, class Model>
multiplier_matrix<S, Model> constraint_inertia(const Model& model, const coordinate_vector<S, Model>& q,
                                               const std::type_identity_t<S>& t = S(0)) {
    const Eigen::Matrix<S, Model::constraints, Model::coordinates> G = constraint_gradient<S>(model, q, t);
    return detail::product(G, mass_inverse<S, Model>(model, q).of_transposed(G));
}

/// The positions where M(q) is singular, in the model's words, if q is one of them to working precision, else
/// an empty string. `singularity(q)` is to be scaled so that M is numerically singular below sqrt(eps).
template <class Model>
std::string singular_position(const Model& model, const coordinate_vector<double, Model>& q) {
    if constexpr (names_singular_positions<Model>) {
        const double s = model.singularity(q);
        if (!(s * s > Eigen::NumTraits<double>::epsilon())) return Model::singular_position;
    }
    return {};
}

/// Kinetic energy v^T M(q) v / 2.
template <class S, class Model>
S kinetic_energy(const Model& model, const coordinate_vector<S, Model>& q,
                 const coordinate_vector<S, Model>& v) {
    return v.dot(mass_matrix<S>(model, q) * v) / S(2);
}

/// Kinetic plus potential energy; constant along the motion of a conservative model.
template <class S, has_potential Model>
S total_energy(const Model& model, const coordinate_vector<S, Model>& q,
               const coordinate_vector<S, Model>& v) {
    return kinetic_energy(model, q, v) + model.potential(q);
}

/// max_i |(G v + b)_i|.
template <class S, class Model>
S constraint_violation(const Model& model, const coordinate_vector<S, Model>& q,
                       const coordinate_vector<S, Model>& v, const std::type_identity_t<S>& t = S(0)) {
    return detail::largest(velocity_constraint<S>(model, q, v, t));
}

}  // namespace stagecraft
