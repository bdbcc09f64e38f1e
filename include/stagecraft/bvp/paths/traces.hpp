// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include <stagecraft/bvp/measure/conditioning.hpp>
#include <stagecraft/linear/almost_block_diagonal.hpp>

namespace stagecraft::detail {

/// How x = (y(a), y(b), p) answers to the values of the n + n_p conditions: one column for each, found with the factors
/// of the linearised problem. With Y the fundamental solutions of the linearised equations at a and b and M the
/// derivative of the conditions by them, this is Y M^-1. M itself would depend on how Y is scaled, and its
/// determinant be lost to rounding errors where modes grow or decay; Y M^-1 is as well scaled as the problem is.
template <class Scalar>
class solution_traces {
  public:
    using matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    using column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

    /// A direction in x, the weights of the conditions that cause it, and how strong it is.
    struct direction {
        column x, conditions;
        Scalar size;
    };

    solution_traces() = default;

    template <class Equations, class Iterate>
    solution_traces(Equations& e, const Iterate& at) {
        conditioning_of<Equations> responses(e, at);
        responses.fundamental();
        all_.resize(2 * e.n() + e.np(), e.n() + e.np());
        all_ << responses.phi(0), responses.phi(at.intervals()), responses.parameters();
        basis_ = all_;
        for (Eigen::Index k = 0; k < basis_.cols(); ++k)
            for (int twice = 0; twice < 2; ++twice) {
                for (Eigen::Index j = 0; j < k; ++j)
                    basis_.col(k) -= basis_.col(j).dot(basis_.col(k)) * basis_.col(j);
                basis_.col(k).normalize();
            }
    }

    const matrix& all() const { return all_; }
    column last() const { return all_.col(all_.cols() - 1); }
    void turn() {
        all_.col(all_.cols() - 1) *= Scalar(-1);
        basis_.col(basis_.cols() - 1) *= Scalar(-1);
    }

    /// det Q^T Q', Q and Q' being orthonormal bases of the columns with their orientation. The spaces of columns, those of
    /// Y, turn smoothly along a path, so that the sign differs from 1 where det M has changed its sign between.
    Scalar orientation(const solution_traces& other) const {
        matrix a = basis_.transpose() * other.basis_;
        const int m = static_cast<int>(a.rows());
        std::vector<int> from(static_cast<std::size_t>(m));
        row_elimination::factor(a, m, static_cast<Scalar*>(nullptr), from.data());
        Scalar product(1);
        for (int k = 0; k < m; ++k) product *= from[k] == k ? a(k, k) : Scalar(-a(k, k));
        return product;
    }

    /// The largest answer: near a point where M is singular, its kernel. By the power method, which converges where one
    /// answer is much larger than the others.
    direction largest() const {
        Eigen::Index start = 0;
        all_.colwise().squaredNorm().maxCoeff(&start);
        column w = column::Unit(all_.cols(), start), u = all_ * w;
        for (int k = 0; k < 30; ++k) {
            w = (all_.transpose() * u).normalized();
            u = all_ * w;
        }
        const Scalar size = u.norm();
        return {column(u / size), w, size};
    }

  private:
    matrix all_, basis_;
};

}  // namespace stagecraft::detail
