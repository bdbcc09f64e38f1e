// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <stagecraft/bvp/measure/conditioning.hpp>

namespace stagecraft::theory {

template <class Scalar>
using square_matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

/// The largest singular value, any scalar.
template <class Scalar>
Scalar two_norm(const square_matrix<Scalar>& a) {
    return stagecraft::detail::spectral_norm(a);
}

/// The linear problem x' = A(t) x + q, B0 x(t0) + BT x(T) = d, from its fundamental matrix X(t), m x m, with
/// X(t0) = 1 (lecture, sections 4.1 and 4.2). Scalars with enough digits keep what X(T) loses where solutions grow.
template <class Scalar>
struct linear_two_point {
    using matrix = square_matrix<Scalar>;

    std::function<matrix(const Scalar&)> X;
    Scalar t0, T;
    matrix B0, BT;

    /// M = B0 X(t0) + BT X(T); the problem has one solution for every q and d where M is regular.
    matrix solvability() const { return B0 * X(t0) + BT * X(T); }
    /// Phi(t) = X(t) M^-1.
    matrix phi(const Scalar& t) const { return X(t) * inverse(solvability()); }
    /// Green's function (4.5): s <= t, or s > t; at s = t this is the value from the left, G(t, t^-).
    matrix green(const Scalar& t, const Scalar& s) const {
        return s <= t ? from_left(t, s) : from_right(t, s);
    }
    matrix from_left(const Scalar& t, const Scalar& s) const { return phi(t) * B0 * X(t0) * inverse(X(s)); }
    matrix from_right(const Scalar& t, const Scalar& s) const { return -phi(t) * BT * X(T) * inverse(X(s)); }

    /// The condition numbers (4.6) as maxima over `points` + 1 equal parts of [t0, T], in the 2-norm.
    Scalar kappa1(int points) const {
        Scalar most(0);
        const matrix inverse_of_M = inverse(solvability());
        for (int i = 0; i <= points; ++i)
            most = std::max(most, two_norm<Scalar>(X(at(i, points)) * inverse_of_M));
        return most;
    }
    Scalar kappa2(int points) const {
        const matrix Mi = inverse(solvability()), left = Mi * B0 * X(t0), right = Mi * BT * X(T);
        std::vector<matrix> x, xi;
        for (int i = 0; i <= points; ++i) {
            x.push_back(X(at(i, points)));
            xi.push_back(inverse(x.back()));
        }
        Scalar most(0);
        for (int i = 0; i <= points; ++i)
            for (int j = 0; j <= points; ++j) {
                if (j <= i) most = std::max(most, two_norm<Scalar>(x[i] * left * xi[j]));
                if (j >= i) most = std::max(most, two_norm<Scalar>(x[i] * right * xi[j]));
            }
        return most;
    }
    Scalar at(int i, int points) const { return t0 + (T - t0) * Scalar(i) / Scalar(points); }

    static matrix inverse(const matrix& a) { return a.partialPivLu().inverse(); }
};

/// How little K may be in Definition 4.5 for the projector P and given alpha, beta: the largest of
/// |X(t) P X(s)^-1| e^{alpha (t - s)} for s <= t and |X(t) (1 - P) X(s)^-1| e^{beta (s - t)} for s >= t, over
/// `points` + 1 equal parts of the problem's interval.
template <class Scalar>
Scalar dichotomy_constant(const linear_two_point<Scalar>& p, const square_matrix<Scalar>& P,
                          const Scalar& alpha, const Scalar& beta, int points) {
    using std::exp;
    const square_matrix<Scalar> rest = square_matrix<Scalar>::Identity(P.rows(), P.cols()) - P;
    Scalar most(0);
    for (int i = 0; i <= points; ++i)
        for (int j = 0; j <= points; ++j) {
            const Scalar t = p.at(i, points), s = p.at(j, points);
            const square_matrix<Scalar> xi = p.inverse(p.X(s));
            if (s <= t)
                most = std::max(most, Scalar(two_norm<Scalar>(p.X(t) * P * xi) * exp(alpha * (t - s))));
            if (s >= t)
                most = std::max(most, Scalar(two_norm<Scalar>(p.X(t) * rest * xi) * exp(beta * (s - t))));
        }
    return most;
}

/// Bases of S_-(t) = im X(t) P and S_+(t) = im X(t) (1 - P), orthonormal columns (lecture, after Definition 4.5): the values at
/// t of the solutions that do not grow, |x(t)| <= K e^{-alpha (t - s)} |x(s)| for s <= t, and of those that do not fall,
/// |x(s)| >= e^{beta (s - t)} |x(t)|/K for s >= t. Together they span R^m.
struct solution_spaces {
    Eigen::MatrixXd minus, plus;
};

/// Throws std::invalid_argument where P is no projector of the size of the problem, to 1e-8 of its norm. Two factorisations.
solution_spaces dichotomy_spaces(const linear_two_point<double>& p, const Eigen::MatrixXd& P, double t);

/// Conditions in the form of Definition 4.3: B0 = D0 Q0^T, BT = DT QT^T with orthogonal Q, diagonal D,
/// entries in [0, 1], of which one of each pair (D0_i, DT_i) is 1. S (B0 BT) is that of the given conditions.
struct scaled_conditions {
    Eigen::MatrixXd B0, BT, S;
    Eigen::VectorXd D0, DT;
};

/// Brings conditions of rank m to scaled form: their rows are made orthonormal, then the CS decomposition of the
/// two halves, then every row is divided by its larger part. Throws std::invalid_argument where the rank is less.
scaled_conditions scaled(const Eigen::MatrixXd& B0, const Eigen::MatrixXd& BT);

/// The matrix of multiple shooting S'(z) (lecture, section 5.1) with nodes t_0 < ... < t_N = T: blocks X_j(t_{j+1})
/// = X(t_{j+1}) X(t_j)^-1, -1, and in the last row B0 and BT X_{N-1}(T); m N x m N.
template <class Scalar>
square_matrix<Scalar> shooting_matrix(const linear_two_point<Scalar>& p, const std::vector<Scalar>& t) {
    const auto N = static_cast<Eigen::Index>(t.size()) - 1, m = p.B0.rows();
    square_matrix<Scalar> S = square_matrix<Scalar>::Zero(m * N, m * N);
    for (Eigen::Index j = 0; j < N; ++j) {
        const square_matrix<Scalar> step = p.X(t[j + 1]) * p.inverse(p.X(t[j]));
        if (j + 1 < N) {
            S.block(m * j, m * j, m, m) = step;
            S.block(m * j, m * (j + 1), m, m) = -square_matrix<Scalar>::Identity(m, m);
        } else {
            S.block(m * j, m * j, m, m) += p.BT * step;
        }
    }
    S.block(m * (N - 1), 0, m, m) += p.B0;
    return S;
}

/// Its inverse by Green's function (section 5.1, with the sign that is missing there): block (i, j) is
/// -G(t_i, t_{j+1}) for j < N - 1, and Phi(t_i) in the last column.
template <class Scalar>
square_matrix<Scalar> shooting_inverse(const linear_two_point<Scalar>& p, const std::vector<Scalar>& t) {
    const auto N = static_cast<Eigen::Index>(t.size()) - 1, m = p.B0.rows();
    square_matrix<Scalar> R(m * N, m * N);
    for (Eigen::Index i = 0; i < N; ++i) {
        for (Eigen::Index j = 0; j + 1 < N; ++j) R.block(m * i, m * j, m, m) = -p.green(t[i], t[j + 1]);
        R.block(m * i, m * (N - 1), m, m) = p.phi(t[i]);
    }
    return R;
}

/// The norm of Satz 5.1: the largest sum over a row of blocks of the 2-norms of its m x m blocks.
template <class Scalar>
Scalar block_row_norm(const square_matrix<Scalar>& a, Eigen::Index m) {
    Scalar most(0);
    for (Eigen::Index i = 0; i < a.rows(); i += m) {
        Scalar sum(0);
        for (Eigen::Index j = 0; j < a.cols(); j += m) sum += two_norm<Scalar>(a.block(i, j, m, m));
        most = std::max(most, sum);
    }
    return most;
}

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/dynamics/green_function-inl.hpp"
#endif
