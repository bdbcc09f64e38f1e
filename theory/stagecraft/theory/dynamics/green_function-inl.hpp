// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/dynamics/green_function.hpp"

#include <stdexcept>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE scaled_conditions scaled(const Eigen::MatrixXd& B0, const Eigen::MatrixXd& BT) {
    const Eigen::Index m = B0.rows();
    Eigen::MatrixXd both(m, 2 * m);
    both << B0, BT;
    const Eigen::JacobiSVD<Eigen::MatrixXd> rows(both, Eigen::ComputeThinU | Eigen::ComputeThinV);
    if (!(rows.singularValues()[m - 1] > 1e-13 * rows.singularValues()[0]))
        throw std::invalid_argument("scaled: the rank of (B0 BT) must be m");
    const Eigen::MatrixXd orthonormal = rows.matrixV().transpose();
    const Eigen::JacobiSVD<Eigen::MatrixXd> left(orthonormal.leftCols(m), Eigen::ComputeFullU);
    scaled_conditions r;
    r.S = left.matrixU().transpose() * rows.singularValues().cwiseInverse().asDiagonal() *
          rows.matrixU().transpose();
    r.B0 = r.S * B0;
    r.BT = r.S * BT;
    r.D0 = r.B0.rowwise().norm();
    r.DT = r.BT.rowwise().norm();
    for (Eigen::Index i = 0; i < m; ++i) {
        const double larger = std::max(r.D0[i], r.DT[i]);
        r.B0.row(i) /= larger, r.BT.row(i) /= larger, r.S.row(i) /= larger;
        r.D0[i] /= larger, r.DT[i] /= larger;
    }
    return r;
}

namespace detail {

/// Orthonormal columns that span im X P for a projector P and a regular X. The singular values of a projector are 0 or at
/// least 1, so its rank is no matter of a tolerance.
STAGECRAFT_INLINE Eigen::MatrixXd image_of(const Eigen::MatrixXd& X, const Eigen::MatrixXd& P) {
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(P, Eigen::ComputeFullU);
    const Eigen::Index rank = (svd.singularValues().array() > 0.5).count();
    const Eigen::MatrixXd image = X * svd.matrixU().leftCols(rank);
    if (rank == 0) return image;
    return image.householderQr().householderQ() * Eigen::MatrixXd::Identity(X.rows(), rank);
}

}  // namespace detail

STAGECRAFT_INLINE solution_spaces dichotomy_spaces(const linear_two_point<double>& p,
                                                   const Eigen::MatrixXd& P, double t) {
    const Eigen::MatrixXd X = p.X(t);
    if (P.rows() != X.rows() || P.cols() != X.cols() ||
        !((P * P - P).cwiseAbs().maxCoeff() <= 1e-8 * (1 + P.norm() * P.norm())))
        throw std::invalid_argument("P: must be a projector, P P = P, of the size of the problem");
    const Eigen::MatrixXd rest = Eigen::MatrixXd::Identity(P.rows(), P.cols()) - P;
    return {detail::image_of(X, P), detail::image_of(X, rest)};
}

}  // namespace stagecraft::theory
