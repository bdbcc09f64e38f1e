// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/refuse/detect/refused_call.hpp>
#include <stagecraft/tableau.hpp>

namespace stagecraft::coefficients {

/// Copies the row-major array `from` into a vector or matrix that has its size already.
template <class To>
void unpack(const double* from, To& to) {
    for (Eigen::Index i = 0; i < to.rows(); ++i)
        for (Eigen::Index j = 0; j < to.cols(); ++j) to(i, j) = static_cast<typename To::Scalar>(*from++);
}

/// The tableau that the arrays of a generated `Data` hold: every entry the double nearest to the method's, rounded to the Scalar.
template <class Data, class Scalar, int Stages>
void unpack(tableau<Scalar, Stages>& t) {
    unpack(Data::A, t.A);
    unpack(Data::b, t.b);
    unpack(Data::c, t.c);
    t.facts = Data::facts;
}

/// Likewise with A^-1, its eigenvalues, T and T^-1.
template <class Data, class Scalar, int Stages>
void unpack(transformed_tableau<Scalar, Stages>& t) {
    unpack<Data>(static_cast<tableau<Scalar, Stages>&>(t));
    unpack(Data::A_inverse, t.A_inverse);
    unpack(Data::T, t.T);
    unpack(Data::T_inverse, t.T_inverse);
    constexpr int real = Stages - 2 * Data::pairs;
    if constexpr (real > 0) {
        t.gamma.resize(real);
        unpack(Data::gamma, t.gamma);
    }
    if constexpr (Data::pairs > 0) {
        t.alpha.resize(Data::pairs);
        t.beta.resize(Data::pairs);
        unpack(Data::alpha, t.alpha);
        unpack(Data::beta, t.beta);
    }
}

}  // namespace stagecraft::coefficients
