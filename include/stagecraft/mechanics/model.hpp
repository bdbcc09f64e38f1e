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
#include <stagecraft/refuse/detect/named_member.hpp>

namespace stagecraft {

/// A constrained mechanical system M(q) q'' = F(q, q') - G(q)^T lambda, 0 = G(q) q' (constraints on the
/// velocities, for instance rolling without slip), as a type `Model` with
///
///     static constexpr int coordinates = n, constraints = m;   // m < n
///     template <class S> Eigen::Matrix<S, n, n> M(const Eigen::Matrix<S, n, 1>& q) const;
///     template <class S>
///     Eigen::Matrix<S, n, 1> F(const Eigen::Matrix<S, n, 1>& q, const Eigen::Matrix<S, n, 1>& v) const;
///     template <class S> Eigen::Matrix<S, m, n> G(const Eigen::Matrix<S, n, 1>& q) const;
///
/// F may take the time as a third argument, G as a second one. All three are templates on the scalar:
/// derivatives are taken by automatic differentiation and the same model runs at any precision. They return matrices, not
/// expressions of Eigen's (as `auto` would), which refer to what may be gone. M is
/// symmetric positive definite and G has full rank wherever the motion goes. Optional members:
///
///     b(q, t) or b(q)     // affine and moving constraints 0 = G(q, t) v + b(q, t): a turntable, a driven wheel
///     solve_mass(q, r)    // M(q)^-1 r in closed form, in place of a factorisation of M(q)
///     G_rate(q, v)        // dG/dt along q' = v, in place of automatic differentiation
///     balance(q, v, a, t) // F - M(q) a, where the two together cost less than each: derivatives take this one
///     potential(q)        // the potential energy
///     singularity(q), singular_position   // a function that vanishes where M(q) is singular, and those
///                                         // positions in words
///
/// Everything below is derived from the model without further input.
template <class Model>
concept mechanical_model = Model::coordinates >
0 && Model::constraints > 0 &&
    Model::constraints <
        Model::coordinates&& requires(const Model& model,
                                      const Eigen::Matrix<double, Model::coordinates, 1>& q) {
    { model.M(q) } -> std::convertible_to<Eigen::Matrix<double, Model::coordinates, Model::coordinates>>;
}
&&(
    requires(const Model& model, const Eigen::Matrix<double, Model::coordinates, 1>& q) {
        { model.G(q) } -> std::convertible_to<Eigen::Matrix<double, Model::constraints, Model::coordinates>>;
    } ||
    requires(const Model& model, const Eigen::Matrix<double, Model::coordinates, 1>& q, double t) {
        {
            model.G(q, t)
            } -> std::convertible_to<Eigen::Matrix<double, Model::constraints, Model::coordinates>>;
    }) &&
    (
        requires(const Model& model, const Eigen::Matrix<double, Model::coordinates, 1>& q) {
            { model.F(q, q) } -> std::convertible_to<Eigen::Matrix<double, Model::coordinates, 1>>;
        } ||
        requires(const Model& model, const Eigen::Matrix<double, Model::coordinates, 1>& q, double t) {
            { model.F(q, q, t) } -> std::convertible_to<Eigen::Matrix<double, Model::coordinates, 1>>;
        });

/// A mechanical model without constraints, M(q) q'' = F(q, q'): as `mechanical_model`, without G and `constraints`.
template <class Model>
concept free_model = Model::coordinates >
0 && !requires { Model::constraints; }
&&requires(const Model& model, const Eigen::Matrix<double, Model::coordinates, 1>& q) {
    { model.M(q) } -> std::convertible_to<Eigen::Matrix<double, Model::coordinates, Model::coordinates>>;
};

/// q, q', q'' and forces of a model; its multipliers; its state (q, q') and (q, q', lambda).
template <class S, class Model>
using coordinate_vector = Eigen::Matrix<S, Model::coordinates, 1>;
template <class S, class Model>
using multiplier_vector = Eigen::Matrix<S, Model::constraints, 1>;
template <class S, class Model>
using multiplier_matrix = Eigen::Matrix<S, Model::constraints, Model::constraints>;

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
concept has_prescribed_velocity = requires(const Model& m, const coordinate_vector<double, Model>& q) {
    m.b(q);
}
|| requires(const Model& m, const coordinate_vector<double, Model>& q, double t) { m.b(q, t); };
template <class Model>
concept has_potential = requires(const Model& m, const coordinate_vector<double, Model>& q) {
    { m.potential(q) } -> detail::owned_number;
};
template <class Model>
concept names_singular_positions = requires(const Model& m, const coordinate_vector<double, Model>& q) {
    { m.singularity(q) } -> detail::owned_number;
    { Model::singular_position } -> std::convertible_to<std::string>;
};

namespace detail {

/// True if Eigen takes a matrix of so many bytes in place.
constexpr bool fits_on_the_stack(std::size_t bytes) {
    return EIGEN_STACK_ALLOCATION_LIMIT == 0 || bytes <= EIGEN_STACK_ALLOCATION_LIMIT;
}

struct solve_mass_member {
    int solve_mass;
    template <class T>
    static constexpr bool visible_in = requires {
        &T::solve_mass;
    };
};
struct constraint_rate_member {
    int G_rate;
    template <class T>
    static constexpr bool visible_in = requires {
        &T::G_rate;
    };
};
struct balance_member {
    int balance;
    template <class T>
    static constexpr bool visible_in = requires {
        &T::balance;
    };
};
struct potential_member {
    int potential;
    template <class T>
    static constexpr bool visible_in = requires {
        &T::potential;
    };
};
struct singularity_member {
    int singularity;
    template <class T>
    static constexpr bool visible_in = requires {
        &T::singularity;
    };
};
struct singular_position_member {
    int singular_position;
    template <class T>
    static constexpr bool visible_in = requires {
        &T::singular_position;
    };
};

inline constexpr auto M_of = [](const auto& m, const auto&... x) -> decltype(m.M(x...)) { return m.M(x...); };
inline constexpr auto F_of = [](const auto& m, const auto&... x) -> decltype(m.F(x...)) { return m.F(x...); };
inline constexpr auto G_of = [](const auto& m, const auto&... x) -> decltype(m.G(x...)) { return m.G(x...); };
inline constexpr auto b_of = [](const auto& m, const auto&... x) -> decltype(m.b(x...)) { return m.b(x...); };
inline constexpr auto g_of = [](const auto& m, const auto&... x) -> decltype(m.g(x...)) { return m.g(x...); };

/// M, F, G, b and g of a model with positions of the type V return objects, in whichever form there is.
template <class Model, class V, class M = const Model&, class X = const V&>
concept model_of_objects = owned_or_none<decltype(M_of), M> && owned_or_none<decltype(M_of), M, X> &&
    owned_or_none<decltype(F_of), M, X, X> && owned_or_none<decltype(F_of), M, X, X, double> &&
    owned_or_none<decltype(G_of), M, X> && owned_or_none<decltype(G_of), M, X, double> &&
    owned_or_none<decltype(b_of), M, X> && owned_or_none<decltype(b_of), M, X, double> &&
    owned_or_none<decltype(g_of), M, X> && owned_or_none<decltype(g_of), M, X, double>;

}  // namespace detail

/// Refuses a Model whose functions take one scalar only (the address of a template cannot be taken), or with an
/// optional member that is there by its name but cannot be used.
template <class Model>
struct checked_model {
    static_assert(
        !requires { &Model::M; } && !requires { &Model::F; } && !requires { &Model::G; } &&
            !requires { requires std::is_member_function_pointer_v<decltype(&Model::g)>; } &&
            !requires { requires std::is_member_function_pointer_v<decltype(&Model::b)>; },
        "M, F, G, g and b of a mechanical model must accept any scalar, as they are differentiated "
        "automatically: template <class S> Eigen::Matrix<S, n, 1> F(const Eigen::Matrix<S, n, 1>& q, "
        "const Eigen::Matrix<S, n, 1>& v) const");

    static_assert(
        detail::model_of_objects<Model, coordinate_vector<double, Model>>,
        "M, F, G, g and b of a mechanical model must return matrices, not expressions of Eigen's, whose "
        "operands may be gone: write their types, Eigen::Matrix<S, n, 1> say, in place of auto, or "
        ".eval()");

    template <class Name>
    static constexpr bool absent = !detail::has_member_named<Model, Name>;

    static_assert(absent<detail::solve_mass_member> || has_mass_solver<Model>,
                  "model.solve_mass must be callable as solve_mass(q, r) on a const model, in any scalar, "
                  "and return a vector (no expression)");
    static_assert(absent<detail::constraint_rate_member> || has_constraint_rate<Model>,
                  "model.G_rate must be callable as G_rate(q, v) on a const model, in any scalar, and "
                  "return a matrix (no expression)");
    static_assert(absent<detail::balance_member> || has_balance<Model>,
                  "model.balance must be callable as balance(q, v, a, t) on a const model, in any scalar, "
                  "and return a vector (no expression)");
    static_assert(absent<detail::potential_member> || has_potential<Model>,
                  "model.potential must be callable as potential(q) on a const model, in any scalar, and "
                  "return a number (no product of Eigen's: .value())");
    static_assert((absent<detail::singularity_member> && absent<detail::singular_position_member>) ||
                      names_singular_positions<Model>,
                  "model.singularity must be callable as singularity(q) on a const model, and "
                  "model.singular_position be a static string: give both or neither");
};

/// F(q, v) or F(q, v, t), whichever the model has.
template <class S, class Model, class Time>
coordinate_vector<S, Model> force(const Model& model, const coordinate_vector<S, Model>& q,
                                  const coordinate_vector<S, Model>& v, const Time& t) {
    if constexpr (requires { model.F(q, v, S(t)); })
        return model.F(q, v, S(t));
    else
        return model.F(q, v);
}

/// G(q, t) or G(q), whichever the model has.
template <class S, class Model, class Time>
Eigen::Matrix<S, Model::constraints, Model::coordinates> constraint_gradient(
    const Model& model, const coordinate_vector<S, Model>& q, const Time& t) {
    if constexpr (requires { model.G(q, S(t)); })
        return model.G(q, S(t));
    else
        return model.G(q);
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
template <class S, class Model>
multiplier_vector<S, Model> velocity_constraint(
    const Model& model, const Eigen::Matrix<S, Model::constraints, Model::coordinates>& G,
    const coordinate_vector<S, Model>& q, const coordinate_vector<S, Model>& v, const S& t) {
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
class mass_inverse : checked_model<Model> {
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
    return v.dot(model.M(q) * v) / S(2);
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
