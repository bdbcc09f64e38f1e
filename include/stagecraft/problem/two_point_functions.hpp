// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>

#include <stagecraft/linear/optional_mass.hpp>
#include <stagecraft/report.hpp>

namespace stagecraft {

namespace detail {

template <int A, int B>
inline constexpr int added = A >= 0 && B >= 0 ? A + B : Eigen::Dynamic;

}  // namespace detail

/// A two-point problem as the collocation sees it, of whatever types f and r are: evaluations of f and r, their derivatives
/// with respect to (y, p) and (left, right, p), the mass matrix. N components and P parameters, Eigen::Dynamic where these
/// are known at run time. What is compiled with it is compiled once for all problems of these sizes, and a call through it
/// costs a few nanoseconds. two_point_system (problem/two_point.hpp) makes one of a two_point_problem.
template <class Scalar, int Components, int Unknowns>
class two_point_functions {
  public:
    using scalar = Scalar;
    static constexpr int N = Components, P = Unknowns;
    static constexpr int Z = detail::added<N, P>, X = detail::added<detail::added<N, N>, P>;
    using joint = Eigen::Matrix<scalar, Z, 1>;  ///< (y, p)
    using ends = Eigen::Matrix<scalar, X, 1>;   ///< (left, right, p)
    using joint_square = Eigen::Matrix<scalar, Z, Z>;
    using ends_square = Eigen::Matrix<scalar, X, X>;
    using parameters_type = Eigen::Matrix<scalar, P, 1>;

    /// differences: df/dy comes from them, and is no better than the square root of epsilon. conditions_by_differences: and
    /// so are the derivatives of r.
    two_point_functions(int n, int parameters, const report<scalar>& counts, bool f_by_differences,
                        bool r_by_differences)
        : differences(f_by_differences),
          conditions_by_differences(r_by_differences),
          n_(n),
          parameters_(parameters),
          counts_(counts),
          out_(n + parameters),
          z_(n + parameters),
          negligible_(joint::Constant(n + parameters, scalar(1) / 1000)),
          x_(2 * n + parameters),
          end_values_(2 * n + parameters),
          small_(ends::Constant(2 * n + parameters, scalar(1) / 1000)) {}
    two_point_functions(const two_point_functions&) = delete;
    virtual ~two_point_functions() = default;

    const bool differences, conditions_by_differences;

    int size() const { return n_; }
    int parameters() const { return parameters_; }
    /// The evaluations so far.
    const report<scalar>& counts() const { return counts_; }

    /// M; throws std::invalid_argument where it is not n x n and finite.
    virtual optional_mass<scalar> mass() const = 0;

    /// f(t, y, p) as n + n_p numbers, the last n_p zero.
    template <class Y>
    const joint& f(const scalar& t, const Y& y, const parameters_type& p) {
        const int n = N > 0 ? N : n_, np = P >= 0 ? P : parameters_;
        for (int c = 0; c < n; ++c) z_[c] = y[c];
        for (int k = 0; k < np; ++k) z_[n + k] = p[k];
        evaluate(t, z_, out_);
        return out_;
    }
    /// df/d(y, p) where f was evaluated last, n + n_p square.
    const joint_square& jacobian(const scalar& t) { return differentiate(t, z_, out_, negligible_); }
    /// r(left, right, p) in the first n + n_p numbers.
    template <class Y, class Z2>
    const ends& conditions(const Y& left, const Z2& right, const parameters_type& p) {
        x_.head(n_) = left;
        x_.segment(n_, n_) = right;
        x_.tail(parameters_) = p;
        evaluate_conditions(x_, end_values_);
        return end_values_;
    }
    /// dr/d(left, right, p) where r was evaluated last, in the first n + n_p rows. Differences are so large that they show
    /// beside r.
    const ends_square& conditions_jacobian() {
        const scalar size = end_values_.head(n_ + parameters_).cwiseAbs().maxCoeff();
        if (size - size == scalar(0)) small_.setConstant((scalar(1) + size) / 1000);
        return differentiate_conditions(x_, end_values_, small_);
    }

  private:
    virtual void evaluate(const scalar& t, const joint& z, joint& out) = 0;
    virtual const joint_square& differentiate(const scalar& t, const joint& z, const joint& f,
                                              const joint& negligible) = 0;
    virtual void evaluate_conditions(const ends& x, ends& out) = 0;
    virtual const ends_square& differentiate_conditions(const ends& x, const ends& r,
                                                        const ends& negligible) = 0;

    int n_, parameters_;
    const report<scalar>& counts_;
    joint out_, z_, negligible_;
    ends x_, end_values_, small_;
};

}  // namespace stagecraft
