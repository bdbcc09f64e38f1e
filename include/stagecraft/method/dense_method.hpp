// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>

#include <stagecraft/tableau.hpp>

namespace stagecraft {

/// A tableau with its published continuous solution u(t + theta h) = y + h sum_i b_i(theta) k_i. Further stages, all explicit,
/// may stand behind those of the method: they serve u alone. A regular value; stagecraft/dense_method.hpp runs it.
template <class Scalar, int Stages = dynamic>
struct dense_method {
    using scalar = Scalar;
    using matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

    tableau<Scalar, Stages> method;
    matrix A_more;                                    ///< rows of the further stages, over all stages
    Eigen::Matrix<Scalar, Eigen::Dynamic, 1> c_more;  ///< their nodes
    matrix b_theta;  ///< a row for each stage, further ones included: the coefficients of theta, theta^2, ...
    int dense_order = 0;  ///< of u at every theta; 0: not known

    int stages() const { return method.stages(); }
    int further_stages() const { return static_cast<int>(c_more.size()); }
    int degree() const { return static_cast<int>(b_theta.cols()); }
    /// b_i(theta) of stage i.
    Scalar weight(int i, const Scalar& theta) const {
        Scalar sum(0);
        for (int k = degree() - 1; k >= 0; --k) sum = theta * (sum + b_theta(i, k));
        return sum;
    }
};

}  // namespace stagecraft
