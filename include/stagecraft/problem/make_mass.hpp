// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <stdexcept>

#include <stagecraft/linear/mass.hpp>
#include <stagecraft/problem/capabilities.hpp>

namespace stagecraft {

/// The mass matrix of a problem of size n in the form that costs least; throws std::invalid_argument if its
/// size is not n x n or an entry is not finite.
template <class Scalar, class Problem>
auto make_mass(Problem& problem, Eigen::Index n) {
    if constexpr (has_mass<Problem>) {
        const auto& m = problem.mass();
        if (m.rows() != n || m.cols() != n)
            throw std::invalid_argument("integrate: problem.mass() must be n x n with n the size of y0");
        entry_mass<Scalar> result(m);
        for (const auto& e : result.entries())
            if (!(e.value - e.value == Scalar(0)))
                throw std::invalid_argument("integrate: problem.mass() must be finite");
        return result;
    } else {
        return identity_mass{};
    }
}

}  // namespace stagecraft
