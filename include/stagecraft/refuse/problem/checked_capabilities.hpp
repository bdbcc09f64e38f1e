// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/break_points.hpp>
#include <stagecraft/problem/capabilities.hpp>
#include <stagecraft/refuse/detect/named_member.hpp>

namespace stagecraft {

namespace detail {

struct jacobian_member {
    int jacobian;
    template <class T>
    static constexpr bool visible_in = requires {
        &T::jacobian;
    };
};
struct bandwidth_member {
    int bandwidth;
    template <class T>
    static constexpr bool visible_in = requires {
        &T::bandwidth;
    };
};
struct sparsity_member {
    int sparsity;
    template <class T>
    static constexpr bool visible_in = requires {
        &T::sparsity;
    };
};
struct linear_solver_member {
    int linear_solver;
    template <class T>
    static constexpr bool visible_in = requires {
        &T::linear_solver;
    };
};
struct mass_member {
    int mass;
    template <class T>
    static constexpr bool visible_in = requires {
        &T::mass;
    };
};
struct index_member {
    int index;
    template <class T>
    static constexpr bool visible_in = requires {
        &T::index;
    };
};
struct constant_jacobian_member {
    int constant_jacobian;
    template <class T>
    static constexpr bool visible_in = requires {
        &T::constant_jacobian;
    };
};
struct second_order_components_member {
    int second_order_components;
    template <class T>
    static constexpr bool visible_in = requires {
        &T::second_order_components;
    };
};
struct add_up_member {
    int add_up;
    template <class T>
    static constexpr bool visible_in = requires {
        &T::add_up;
    };
};
struct matrix_member {
    int matrix;
    template <class T>
    static constexpr bool visible_in = requires {
        &T::matrix;
    };
};
struct precondition_member {
    int precondition;
    template <class T>
    static constexpr bool visible_in = requires {
        &T::precondition;
    };
};
struct domain_member {
    int domain;
    template <class T>
    static constexpr bool visible_in = requires {
        &T::domain;
    };
};
struct break_points_member {
    int break_points;
    template <class T>
    static constexpr bool visible_in = requires {
        &T::break_points;
    };
};
template <class T>
concept has_type_named_matrix = requires {
    typename T::matrix;
};
struct measure_member {
    int measure;
    template <class T>
    static constexpr bool visible_in = requires {
        &T::measure;
    };
};

}  // namespace detail

/// Refuses a Problem (const where the run is given a const one) with an optional member that is there by its
/// name but cannot be used: it would be passed over in silence, and a problem with a mass matrix solved as one
/// without. Matrix is what jacobian() writes into. The first complaint comes first.
template <class Problem, class Vector, class Matrix>
struct checked_capabilities {
    template <class Name>
    static constexpr bool absent = !detail::has_member_named<Problem, Name>;

    static_assert(
        absent<detail::mass_member> || has_mass<Problem>,
        "problem.mass must be a member function `auto mass() const` that returns the n x n matrix M (an "
        "M(t, y) that depends on t or y, `auto mass(double t, const Vector& y) const`, of which integrate() "
        "knows); give a member that means something else another name");
    static_assert(
        absent<detail::index_member> || has_owned_index<Problem>,
        "problem.index must be a member function `auto index() const` that returns the index of every "
        "component, e.g. a std::array<int, n>; give a member that means something else another name");
    static_assert(absent<detail::bandwidth_member> || has_bandwidth<Problem>,
                  "problem.bandwidth must be a member function `stagecraft::bandwidth bandwidth() const`");
    static_assert(absent<detail::sparsity_member> || has_sparsity<Problem>,
                  "problem.sparsity must be a member function `auto sparsity() const` that returns an "
                  "Eigen::SparseMatrix with the pattern of df/dy");
    static_assert(
        absent<detail::jacobian_member> || has_jacobian<Problem, Vector, Matrix>,
        "problem.jacobian must be a member function `void jacobian(const Scalar& t, const Vector& y, "
        "Matrix& J) const`, Vector the type of y0, Matrix n x n of the same sizes (at compile time), "
        "a banded_matrix with bandwidth(), the type of sparsity() with that");
    static_assert(absent<detail::constant_jacobian_member> || has_constant_jacobian<Problem>,
                  "problem.constant_jacobian must be a member function `bool constant_jacobian() const`");
    static_assert(absent<detail::second_order_components_member> || has_second_order_components<Problem>,
                  "problem.second_order_components must be a `static constexpr int`");
    static_assert(absent<detail::linear_solver_member> || has_linear_solver<Problem>,
                  "Problem::linear_solver must be a type with member types `real` and `complex`");
    static_assert(
        absent<detail::add_up_member> || has_add_up<Problem, typename Vector::Scalar>,
        "problem.add_up must be a member function `void add_up(Scalar* x, int k) const` that replaces "
        "k numbers by their sums over all processes");
    static_assert(
        absent<detail::matrix_member> || detail::has_type_named_matrix<Problem> || has_matrix<Problem>,
        "problem.matrix must be a member function `auto matrix() const` that returns what jacobian(t, "
        "y, J) writes into, with rows() and cols(); give a member that means something else another "
        "name");
    static_assert(
        absent<detail::precondition_member> || has_matrix<Problem> || has_linear_solver<Problem>,
        "problem.precondition is used without a Jacobian only: leave jacobian out and give "
        "matrix_free(problem, n) (stagecraft/problem/matrix_free.hpp) in place of the problem; give a "
        "member that means something else another name");
    static_assert(absent<detail::domain_member> || has_domain<Problem, Vector>,
                  "problem.domain must be a member function `bool domain(double t, const Vector& y) const` "
                  "that is false outside of the domain, Vector the type of y0; give a member that means "
                  "something else another name");
    static_assert(
        absent<detail::break_points_member> || has_break_points<Problem>,
        "problem.break_points must be a member function `auto break_points() const` that returns a "
        "std::vector of times, or every(period, first) (break_points.hpp); give a member that means "
        "something else another name");
    static_assert(absent<detail::measure_member> || has_stopwatch<Problem>,
                  "problem.measure must be a member function `auto measure(stagecraft::work) const`");
};

}  // namespace stagecraft
