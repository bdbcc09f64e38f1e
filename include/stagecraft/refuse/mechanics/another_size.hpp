// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>

namespace stagecraft::detail {

/// Components of a vector where they are known at compile time, else as many as are wanted.
template <class Vector, int Wanted>
constexpr int known_size() {
    if constexpr (requires { Vector::SizeAtCompileTime; })
        return int(Vector::SizeAtCompileTime) == Eigen::Dynamic ? Wanted : int(Vector::SizeAtCompileTime);
    else
        return Wanted;
}

template <class Model, int Multipliers>
constexpr int state_size() {
    if constexpr (Multipliers == 0)
        return 2 * Model::coordinates;
    else
        return 2 * Model::coordinates + Multipliers * Model::constraints;
}

/// Base of formulations with states of q, v and Multipliers vectors of the size of lambda: the initial_state that
/// refuses q or v of another fixed size, of which Eigen would only say that sizes are mixed. Of v nothing is said where q
/// is wrong, so that the first complaint is the only one.
template <class Model, int Multipliers>
struct start_of_another_size {
    template <class Q, class V, class... Others, int n = Model::coordinates, int q_size = known_size<Q, n>(),
              int v_size = known_size<V, n>()>
    requires(q_size != n || v_size != n) auto initial_state(const Q&, const V&, const Others&...) const {
        constexpr bool q = q_size == n, v = !q || v_size == n;
        static_assert(q,
                      "initial_state(q, v): the size of q must be n, the number of coordinates of the model, "
                      "as in lagrangian<n, m>");
        static_assert(v,
                      "initial_state(q, v): the size of v must be n, the number of coordinates of the model, "
                      "as in lagrangian<n, m>");
        return Eigen::Matrix<typename Q::Scalar, state_size<Model, Multipliers>(), 1>();
    }
};

}  // namespace stagecraft::detail
