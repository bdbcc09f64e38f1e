// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cmath>

#include <stagecraft/linear/banded_matrix.hpp>
#include <stagecraft/linear/mass.hpp>
#include <stagecraft/sensitivity/parameters.hpp>

namespace stagecraft::detail {

template <class Scalar, class F>
void for_each_entry(const banded_matrix<Scalar>& J, F&& f) {
    for (int j = 0; j < J.size(); ++j)
        for (int i = j > J.upper() ? j - J.upper() : 0; i < J.size() && i <= j + J.lower(); ++i)
            f(i, j, J(i, j));
}

/// r += J x.
template <class Matrix, class Vector>
void add_product(const Matrix& J, const Vector& x, Vector& r) {
    r.noalias() += J * x;
}
template <class Scalar, class Vector>
void add_product(const banded_matrix<Scalar>& J, const Vector& x, Vector& r) {
    for_each_entry(J, [&](int i, int j, const Scalar& entry) { r[i] += entry * x[j]; });
}

/// r += J^T x.
template <class Matrix, class Vector>
void add_transposed_product(const Matrix& J, const Vector& x, Vector& r) {
    r.noalias() += J.transpose() * x;
}
template <class Scalar, class Vector>
void add_transposed_product(const banded_matrix<Scalar>& J, const Vector& x, Vector& r) {
    for_each_entry(J, [&](int i, int j, const Scalar& entry) { r[j] += entry * x[i]; });
}

template <class Matrix>
requires requires(const Matrix& J) { J.transpose(); }
Matrix transposed(const Matrix& J) { return J.transpose(); }
template <class Scalar>
banded_matrix<Scalar> transposed(const banded_matrix<Scalar>& J) {
    banded_matrix<Scalar> result(J.size(), {J.upper(), J.lower()});
    for_each_entry(J, [&](int i, int j, const Scalar& entry) { result(j, i) = entry; });
    return result;
}
inline identity_mass transposed(const identity_mass& M) { return M; }
template <class Scalar>
entry_mass<Scalar> transposed(const entry_mass<Scalar>& M) {
    return M.transposed();
}

/// The sums of |J_ij| along the rows.
template <class Matrix>
auto row_sums(const Matrix& J, int n) {
    using vector = Eigen::Matrix<typename Matrix::Scalar, Eigen::Dynamic, 1>;
    return vector(J.cwiseAbs() * vector::Ones(n));
}
template <class Scalar>
auto row_sums(const banded_matrix<Scalar>& J, int n) {
    using std::abs;
    Eigen::Matrix<Scalar, Eigen::Dynamic, 1> sums = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>::Zero(n);
    for_each_entry(J, [&](int i, int, const Scalar& entry) { sums[i] += abs(entry); });
    return sums;
}

template <class Matrix>
Matrix zero_matrix(Eigen::Index rows, Eigen::Index columns) {
    Matrix result(rows, columns);
    result.setZero();
    return result;
}

/// F := df/dp, and where M depends on p the derivative of f - M slope. A given F is zero at the first call.
template <class By, class Problem, class Scalar, class Vector, class Matrix>
void differentiate_by_parameters(const Problem& problem, const Scalar& t, const Vector& y,
                                 const Vector& slope, Matrix& F) {
    constexpr bool by_duals = !By::given, mass = Problem::mass_depends;
    if constexpr (By::given) problem.parameter_jacobian(t, y, problem.p, F);
    if constexpr (by_duals || mass) {
        using number = typename By::number;
        using vector = typename By::state;
        constexpr int width = dual_width<By::M>;
        [[maybe_unused]] const vector at = promoted<number>(y);
        typename By::values q = promoted<number>(problem.p);
        vector f(y.size());
        for (Eigen::Index first = 0; first < q.size(); first += width) {
            const Eigen::Index end = first + width < q.size() ? first + width : q.size();
            for (Eigen::Index k = first; k < end; ++k) q[k].derivatives()[k - first] = Scalar(1);
            if constexpr (by_duals)
                problem.template residual<By>(t, at, q, slope, f);
            else
                f = -vector(problem.Problem::original::mass(q) * promoted<number>(slope));
            for (Eigen::Index k = first; k < end; ++k) {
                for (Eigen::Index i = 0; i < y.size(); ++i) {
                    const Scalar& entry = f[i].derivatives()[k - first];
                    if constexpr (by_duals)
                        F(i, k) = entry;
                    else if (!(entry == Scalar(0)))
                        F.coeffRef(i, k) += entry;
                }
                q[k].derivatives().setZero();
            }
        }
    }
}

}  // namespace stagecraft::detail
