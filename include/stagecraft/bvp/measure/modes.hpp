// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <vector>

#include <stagecraft/bvp/measure/conditioning.hpp>

namespace stagecraft::detail {

/// The answers to combinations of conditions that are orthogonal to each other, y at the mesh points and p one above the other,
/// relative to the sizes of the components and of the terms of the conditions. Where M is singular in several directions, each
/// of them is one of these, whatever the errors of the mesh make of the others.
template <class Equations>
class modes_of {
  public:
    using wide = typename Equations::wide;
    using scalar = typename wide::Scalar;
    using column = Eigen::Matrix<scalar, Eigen::Dynamic, 1>;

    /// `sizes` are those of the components of y.
    template <class Iterate>
    modes_of(const Equations& equations, conditioning_of<Equations>& conditioning, const Iterate& x,
             const typename Equations::state& sizes, const scalar& threshold)
        : sizes_(sizes), sizes_of_p_(x.p.cwiseAbs()) {
        using std::abs;
        conditioning.fundamental();
        const int n = equations.n(), m = n + equations.np(), points = x.intervals() + 1;
        const auto& B = equations.conditions();
        sizes_of_p_.array() += threshold;
        all_.resize(n * points + m - n, m);
        for (int k = 0; k < m; ++k) {
            scalar terms(0);
            for (int c = 0; c < n; ++c) terms += (abs(B(k, c)) + abs(B(k, n + c))) * sizes_[c];
            for (int j = 0; j < m - n; ++j) terms += abs(B(k, 2 * n + j)) * sizes_of_p_[j];
            all_.col(k) = terms * scaled(conditioning.response(k), conditioning.parameters().col(k));
        }
        make_orthogonal(all_);
    }

    int count() const { return static_cast<int>(all_.cols()); }
    /// The largest part of mode k.
    scalar size(int k) const { return all_.col(k).cwiseAbs().maxCoeff(); }
    scalar largest() const { return all_.cwiseAbs().maxCoeff(); }
    /// Its y and p.
    template <class Parameters>
    void get(int k, wide& y, Parameters& p) const {
        const Eigen::Index n = sizes_.size(), np = sizes_of_p_.size(), points = (all_.rows() - np) / n;
        y.resize(n, points), p.resize(np);
        for (Eigen::Index i = 0; i < points; ++i)
            for (Eigen::Index c = 0; c < n; ++c) y(c, i) = sizes_[c] * all_(i * n + c, k);
        for (Eigen::Index j = 0; j < np; ++j) p[j] = sizes_of_p_[j] * all_(n * points + j, k);
    }
    /// The conditions to which e is the answer, in units of those of the modes.
    template <class Parameters>
    column conditions(const wide& e, const Parameters& p) const {
        const column v = scaled(e, p);
        column parts = column::Zero(count());
        for (int k = 0; k < count(); ++k) {
            const scalar square = all_.col(k).squaredNorm();
            if (square > scalar(0)) parts[k] = all_.col(k).dot(v) / square;
        }
        return parts;
    }

  private:
    template <class Parameters>
    column scaled(const wide& y, const Parameters& p) const {
        const Eigen::Index n = sizes_.size(), np = sizes_of_p_.size();
        column v(n * y.cols() + np);
        for (Eigen::Index i = 0; i < y.cols(); ++i)
            for (Eigen::Index c = 0; c < n; ++c) v[i * n + c] = y(c, i) / sizes_[c];
        for (Eigen::Index j = 0; j < np; ++j) v[n * y.cols() + j] = p[j] / sizes_of_p_[j];
        return v;
    }

    typename Equations::state sizes_;
    column sizes_of_p_;
    Eigen::Matrix<scalar, Eigen::Dynamic, Eigen::Dynamic> all_;
};

/// About the spectral radius of the rows `of` of the columns E >= 0, from above (Collatz).
template <class Column>
typename Column::Scalar spectral_radius(const std::vector<int>& of, const std::vector<Column>& E) {
    using scalar = typename Column::Scalar;
    const std::size_t m = of.size();
    std::vector<scalar> v(m, scalar(1)), next(m);
    scalar most(0);
    for (int pass = 0; pass < 30; ++pass) {
        most = scalar(0);
        scalar sum(0);
        for (std::size_t j = 0; j < m; ++j) {
            next[j] = scalar(0);
            for (std::size_t k = 0; k < m; ++k) next[j] += E[k][of[j]] * v[k];
            most = std::max(most, scalar(next[j] / v[j]));
            sum += next[j];
        }
        if (!(sum > scalar(0)) || !(sum - sum == scalar(0))) return sum;
        for (std::size_t j = 0; j < m; ++j) v[j] = next[j] / sum + std::numeric_limits<scalar>::epsilon();
    }
    return most;
}

}  // namespace stagecraft::detail
