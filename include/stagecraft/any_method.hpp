// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>

#include <stagecraft/additive.hpp>
#include <stagecraft/dense_method.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/low_storage.hpp>
#include <stagecraft/tableau.hpp>

namespace stagecraft {

/// A method whose kind is known at run time, that of a file, say (tableaux::read_method): a tableau, with its published
/// continuous solution where it has one, an additive method, or one of low storage.
template <class Scalar>
using any_method =
    std::variant<tableau<Scalar>, dense_method<Scalar>, additive_method<Scalar>, low_storage_method<Scalar>>;

/// integrate() with the kind that the method is. The problem is of one kind, known at compile time: where the method is another,
/// it is std::invalid_argument. Costs no more than the integrators for the kinds that fit.
template <class... Kinds, class Problem, class Derived, class Observer = no_observer>
result<typename Derived::PlainObject> integrate(const std::variant<Kinds...>& method, Problem&& problem,
                                                const Eigen::MatrixBase<Derived>& y0,
                                                std::type_identity_t<typename Derived::Scalar> t0,
                                                std::type_identity_t<typename Derived::Scalar> t1,
                                                const options<typename Derived::Scalar>& o = {},
                                                Observer&& observer = {}) {
    using problem_type = std::remove_reference_t<Problem>;
    return std::visit(
        [&](const auto& one) -> result<typename Derived::PlainObject> {
            if constexpr (detail::fit_in_parts<std::decay_t<decltype(one)>, problem_type>)
                return integrate(one, problem, y0, t0, t1, o, observer);
            else if constexpr (in_parts<problem_type>)
                throw std::invalid_argument(
                    "integrate: the method is one tableau, and the problem split(f_explicit, f_implicit): "
                    "write the sum as one f");
            else
                throw std::invalid_argument(
                    "integrate: the method is additive, and takes a problem split(f_explicit, f_implicit)");
        },
        method);
}

}  // namespace stagecraft
