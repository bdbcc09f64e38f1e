// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/coefficients/unpack_one.hpp>
#include <stagecraft/method/dense_method.hpp>

namespace stagecraft::coefficients {

/// The tableau that the arrays of a generated `Data` hold, with its continuous solution.
template <class Scalar, class Data>
dense_method<Scalar, Data::stages> unpack_dense() {
    dense_method<Scalar, Data::stages> m;
    m.method = unpack_one<tableau<Scalar, Data::stages>, Data>();
    m.A_more.resize(Data::further_stages, Data::stages + Data::further_stages);
    m.c_more.resize(Data::further_stages);
    m.b_theta.resize(Data::stages + Data::further_stages, Data::degree);
    unpack(Data::b_theta, m.b_theta);
    if constexpr (Data::further_stages > 0) {
        unpack(Data::A_more, m.A_more);
        unpack(Data::c_more, m.c_more);
    }
    m.dense_order = Data::dense_order;
    return m;
}

}  // namespace stagecraft::coefficients
