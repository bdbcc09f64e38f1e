// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <stagecraft/jacobian/reverse_functions.hpp>
#include <stagecraft/jacobian/unconverted.hpp>
#include <stagecraft/sensitivity/parameters.hpp>

namespace stagecraft::detail {

/// The value of call(t, y, p), a vector, and its derivatives at one point. A Call that takes reverse_numbers as y and p is
/// called once, and its derivatives are exact. Of any other they are central differences, extrapolated once, with four calls
/// for each of t, y_i and p_k; error() says how good those are. Where only t has to be a plain number its part is.
template <class Vector, class Parameters>
class call_derivatives {
    using scalar = typename Vector::Scalar;
    using number = reverse_number<scalar>;
    using state = Eigen::Matrix<number, Vector::RowsAtCompileTime, 1>;
    using values = Eigen::Matrix<number, Parameters::RowsAtCompileTime, 1>;
    using column = Eigen::Matrix<scalar, Eigen::Dynamic, 1>;
    using dense = Eigen::Matrix<scalar, Eigen::Dynamic, Eigen::Dynamic>;

  public:
    template <class Call>
    static constexpr bool generic_in_time = Call::template takes<number, state, values>;
    template <class Call>
    static constexpr bool generic = generic_in_time<Call> || Call::template takes<scalar, state, values>;

    /// Evaluates all; `time_moves`: derivatives by t are wanted, and `span` is what is long in t.
    template <class Call>
    void at(const Call& call, const scalar& t, const Vector& y, const Parameters& p, bool time_moves,
            const scalar& span) {
        n_ = y.size();
        by_tape_ = generic<Call>;
        time_taped_ = generic_in_time<Call>;
        error_ = scale_ = scalar(0);
        if constexpr (generic<Call>) {
            record(call, t, y, p);
        } else {
            value_ = call(t, y, p);
            J_.resize(value_.size(), 1 + n_ + p.size());
            J_.setZero();
            Vector at = y;
            const auto by_state = [&](const Vector& x) { return column(call(t, x, p)); };
            for (Eigen::Index j = 0; j < n_; ++j) difference(by_state, at, j, 1 + j, size_of(y, j));
            Parameters q = p;
            const auto by_parameters = [&](const Parameters& x) { return column(call(t, y, x)); };
            for (Eigen::Index k = 0; k < p.size(); ++k)
                difference(by_parameters, q, k, 1 + n_ + k, size_of(p, k));
        }
        if constexpr (!generic_in_time<Call>) {
            if (generic<Call>) J_.setZero(value_.size(), 1);
            Eigen::Matrix<scalar, 1, 1> time(t);
            const auto by_time = [&](const auto& x) { return column(call(x[0], y, p)); };
            if (time_moves) difference(by_time, time, 0, 0, span);
        }
    }

    const column& value() const { return value_; }
    /// The largest error of a difference, relative to the largest value or change; zero where there is none.
    scalar error() const { return error_ == scalar(0) ? error_ : scalar(error_ / scale_); }

    /// The derivative along (dt, dy) and, where k is not negative, parameter k.
    template <class Direction>
    column along(const scalar& dt, const Direction& dy, Eigen::Index k) {
        column result = column::Zero(value_.size());
        if (by_tape_) {
            operations_.clear_adjoints();
            operations_.tangent(0) = dt;
            for (Eigen::Index i = 0; i < n_; ++i) operations_.tangent(static_cast<int>(1 + i)) = dy[i];
            if (k >= 0) operations_.tangent(static_cast<int>(1 + n_ + k)) = scalar(1);
            operations_.push();
            for (Eigen::Index i = 0; i < result.size(); ++i) {
                const int from = results_[static_cast<std::size_t>(i)];
                if (from >= 0) result[i] = operations_.tangent(from);
            }
            if (!time_taped_) result += dt * J_.col(0);
            return result;
        }
        result = dt * J_.col(0) + J_.middleCols(1, n_) * dy;
        if (k >= 0) result += J_.col(1 + n_ + k);
        return result;
    }

    /// Adds factor times v^T of the derivatives by y and p, and returns that by t. Of generic calls.
    template <class Adjoint>
    scalar transposed(const Adjoint& v, const scalar& factor, Vector& by_y, Parameters& by_p) {
        operations_.clear_adjoints();
        for (Eigen::Index i = 0; i < value_.size(); ++i)
            operations_.seed(results_[static_cast<std::size_t>(i)], factor * v[i]);
        operations_.sweep();
        for (Eigen::Index j = 0; j < n_; ++j) by_y[j] += operations_.adjoint(static_cast<int>(1 + j));
        for (Eigen::Index k = 0; k < by_p.size(); ++k)
            by_p[k] += operations_.adjoint(static_cast<int>(1 + n_ + k));
        scalar by_t = operations_.adjoint(0);
        if (!time_taped_)
            for (Eigen::Index i = 0; i < value_.size(); ++i) by_t += factor * v[i] * J_(i, 0);
        return by_t;
    }

  private:
    template <class Call>
    void record(const Call& call, const scalar& t, const Vector& y, const Parameters& p) {
        const int n = static_cast<int>(n_), m = static_cast<int>(p.size());
        operations_.start(1 + n + m);
        state at(n);
        values q(m);
        for (int i = 0; i < n; ++i) at[i] = number(y[i], &operations_, 1 + i);
        for (int k = 0; k < m; ++k) q[k] = number(p[k], &operations_, 1 + n + k);
        const auto taken = [&] {
            if constexpr (generic_in_time<Call>)
                return call(number(t, &operations_, 0), std::as_const(at), std::as_const(q));
            else
                return call(t, std::as_const(at), std::as_const(q));
        }();
        value_.resize(taken.size());
        results_.resize(static_cast<std::size_t>(taken.size()));
        for (Eigen::Index i = 0; i < taken.size(); ++i) {
            value_[i] = taken[i].value();
            results_[static_cast<std::size_t>(i)] = taken[i].number();
        }
    }

    template <class X>
    static scalar size_of(const X& x, Eigen::Index j) {
        using std::abs;
        const scalar own = abs(x[j]), least = x.cwiseAbs().maxCoeff() / 1000;
        const scalar size = own > least ? own : least;
        return size > scalar(0) ? size : scalar(1);
    }
    /// Column number `to` of J from calls at x with component j moved. Its error is about what the differences of two lengths
    /// are apart, what a kink at x would leave of their bends, and their rounding.
    template <class Value, class X>
    void difference(const Value& value, X& x, Eigen::Index j, Eigen::Index to, const scalar& size) {
        using std::abs;
        using std::cbrt;
        const scalar eps = std::numeric_limits<scalar>::epsilon(), own = x[j], h = cbrt(eps) * size;
        column slope[2], bend[2];
        for (int k = 0; k < 2; ++k) {
            const scalar step = scalar(k + 1) * h;
            x[j] = own + step;
            const column up = value(x);
            const scalar right = x[j] - own;
            x[j] = own - step;
            const column down = value(x);
            const scalar left = own - x[j];
            slope[k] = (up - down) / (right + left);
            bend[k] = (up - value_) / right - (value_ - down) / left;
        }
        x[j] = own;
        J_.col(to) = (4 * slope[0] - slope[1]) / scalar(3);
        const auto largest = [](const column& v) {
            return v.size() > 0 ? v.cwiseAbs().maxCoeff() : scalar(0);
        };
        const scalar rounding = eps * largest(value_) / h, kink = largest(2 * bend[0] - bend[1]);
        const scalar error =
            size * (largest(slope[0] - slope[1]) + rounding + (kink > 16 * rounding ? kink : scalar(0)));
        if (!(error <= error_)) error_ = error;
        const scalar changes = size * largest(slope[0]) + largest(value_);
        if (changes > scale_) scale_ = changes;
    }

    Eigen::Index n_ = 0;
    bool by_tape_ = false, time_taped_ = false;
    tape<scalar> operations_;
    std::vector<int> results_;
    column value_;
    dense J_;  // by (t, y, p), or by t alone beside a tape
    scalar error_{0}, scale_{0};
};

}  // namespace stagecraft::detail
