// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <type_traits>

#include <stagecraft/linear/mass.hpp>
#include <stagecraft/owned_value.hpp>
#include <stagecraft/problem/capabilities.hpp>

namespace stagecraft {

/// The entries of a mass matrix; std::invalid_argument if one is not finite.
template <class Scalar, class Matrix>
entry_mass<Scalar> finite_entries(const Matrix& m) {
    entry_mass<Scalar> result(m);
    for (const auto& e : result.entries())
        if (!(e.value - e.value == Scalar(0)))
            throw std::invalid_argument("integrate: problem.mass() must be finite");
    return result;
}

/// The mass matrix of a problem of size n in the form that costs least; throws std::invalid_argument if its
/// size is not n x n or an entry is not finite.
template <class Scalar, class Problem>
auto make_mass(Problem& problem, Eigen::Index n) {
    if constexpr (has_mass<Problem>) {
        static_assert(
            detail::owns_numbers<decltype(problem.mass())>,
            "problem.mass() returns an expression of Eigen's, whose operands may be gone before it is "
            "evaluated: write its type, `Eigen::Matrix2d mass() const`, say");
        const auto& m = problem.mass();
        if (m.rows() != n || m.cols() != n)
            throw std::invalid_argument("integrate: problem.mass() must be n x n with n the size of y0");
        if constexpr (mass_operator<std::remove_cvref_t<decltype(m)>, Scalar>)
            return mass_by_products<std::remove_cvref_t<decltype(m)>>(m);
        else
            return finite_entries<Scalar>(m);
    } else {
        return identity_mass{};
    }
}

}  // namespace stagecraft
