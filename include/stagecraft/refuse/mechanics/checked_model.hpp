// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <type_traits>

#include <stagecraft/mechanics/model.hpp>
#include <stagecraft/refuse/detect/named_member.hpp>

namespace stagecraft {

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

/// M, F, G, b and g of a model return objects, in whichever form there is.
template <class Model, class M = const Model&, class X = const coordinate_vector<double, Model>&>
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
    static constexpr bool at_run_time =
        detail::sizes_at_run_time<Model>;  // in doubles, and with no other members
    static_assert(
        at_run_time || (
                           !requires { &Model::M; } && !requires { &Model::F; } && !requires { &Model::G; } &&
                           !requires { requires std::is_member_function_pointer_v<decltype(&Model::g)>; } &&
                           !requires { requires std::is_member_function_pointer_v<decltype(&Model::b)>; }),
        "M, F, G, g and b of a mechanical model must accept any scalar, as they are differentiated "
        "automatically: template <class S> Eigen::Matrix<S, n, 1> F(const Eigen::Matrix<S, n, 1>& q, "
        "const Eigen::Matrix<S, n, 1>& v) const");

    static_assert(
        detail::model_of_objects<Model>,
        "M, F, G, g and b of a mechanical model must return matrices, not expressions of Eigen's, whose "
        "operands may be gone: write their types, Eigen::Matrix<S, n, 1>, say, in place of auto, or "
        ".eval()");

    template <class Name>
    static constexpr bool absent = at_run_time || !detail::has_member_named<Model, Name>;

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

}  // namespace stagecraft
