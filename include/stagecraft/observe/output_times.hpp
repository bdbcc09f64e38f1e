// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <utility>
#include <vector>

#include <stagecraft/refuse/detect/refused_call.hpp>

namespace stagecraft {

/// An observer that keeps the solution at given times:
///
///     output_times<Vector3d> table({0, 0.1, 1, 10});
///     integrate(method, problem, y0, 0, 10, options, table);     // then table.y(i) at table.time(i)
///
/// Where the run changes y at one of the times (observe/at.hpp), this time given once has the value behind the change; given
/// twice or more often, its first has the value before. Where a step ends at one of the times the value is the accepted state, elsewhere it is that of the
/// continuous solution, whose order dense_output.hpp gives. The run takes the same steps as without this
/// observer. Storage: n numbers per time, twice that with derivatives, allocated before the first step.
template <class Vector>
class output_times {
  public:
    using scalar = typename Vector::Scalar;
    using matrix = Eigen::Matrix<scalar, Vector::RowsAtCompileTime, Eigen::Dynamic>;

    /// The times in the order of the run (decreasing when time runs backwards; equal ones are allowed).
    /// with_derivatives keeps y' as well. Throws std::invalid_argument if they are not in order or one of
    /// them is not finite.
    explicit output_times(std::vector<scalar> times, bool with_derivatives = false)
        : times_(std::move(times)), with_derivatives_(with_derivatives) {
        bool up = true, down = true;
        for (std::size_t i = 0; i < times_.size(); ++i) {
            if (!(times_[i] - times_[i] == scalar(0)))
                throw std::invalid_argument("output_times: times must be finite");
            up = up && (i == 0 || times_[i - 1] <= times_[i]);
            down = down && (i == 0 || times_[i - 1] >= times_[i]);
        }
        if (!up && !down) throw std::invalid_argument("output_times: times must be in order");
    }

    /// The same from a vector of Eigen's, VectorXd::LinSpaced(11, 0, 1), say.
    template <class Derived>
    explicit output_times(const Eigen::MatrixBase<Derived>& times, bool with_derivatives = false)
        : output_times(std::vector<scalar>(times.begin(), times.end()), with_derivatives) {}

    /// How many of the times the run has reached: all of them after a success, fewer where it ended early.
    /// Times equal to t0 always count.
    int filled() const { return filled_; }
    const scalar& time(int i) const { return times_.at(static_cast<std::size_t>(i)); }
    /// y at time(i). Throws std::out_of_range unless 0 <= i < filled().
    auto y(int i) const { return y_.col(checked(i)); }
    /// y' at time(i). Throws std::out_of_range like y(i), and also where no derivatives were asked for or no
    /// step was taken.
    auto derivative(int i) const {
        if (!with_derivatives_) throw std::out_of_range("output_times: no derivatives were asked for");
        if (i >= slopes_) throw std::out_of_range("output_times: the derivative is not known");
        return derivatives_.col(checked(i));
    }
    /// One column per time reached.
    auto values() const { return y_.leftCols(filled_); }

    /// Throws std::invalid_argument if a time lies outside of [t0, t1], if the times are not in the order of
    /// the run, or if derivatives are asked for in a run with t0 = t1.
    void start(const scalar& t0, const Vector& y0, const scalar& t1) {
        backwards_ = t1 < t0;
        filled_ = slopes_ = 0;
        for (std::size_t i = 0; i < times_.size(); ++i) {
            if (after(t0, times_[i]) || after(times_[i], t1))
                throw std::invalid_argument("output_times: times must be between t0 and t1");
            if (i > 0 && after(times_[i - 1], times_[i]))
                throw std::invalid_argument("output_times: times must be in the order of the run");
        }
        if (with_derivatives_ && t0 == t1 && !times_.empty())
            throw std::invalid_argument("output_times: a run from t0 to t0 has no derivatives");
        const auto columns = static_cast<Eigen::Index>(times_.size());
        y_.resize(y0.size(), columns);
        derivatives_.resize(y0.size(), with_derivatives_ ? columns : 0);
        for (; filled_ < columns && time(filled_) == t0; ++filled_) y_.col(filled_) = y0;
    }

    template <class Output>
    void operator()(const scalar& t, const Vector& y, const scalar&, const Output& output) {
        for (; filled_ < static_cast<int>(times_.size()) && !after(time(filled_), t); ++filled_) {
            const scalar& at = time(filled_);
            y_.col(filled_) = at == t ? y : output(at);
        }
        if (with_derivatives_)
            for (; slopes_ < filled_; ++slopes_) derivatives_.col(slopes_) = output.derivative(time(slopes_));
    }

    void changed(const scalar& t, const Vector& y) {
        int first = filled_;
        while (first > 0 && time(first - 1) == t) --first;
        for (int i = filled_ - first > 1 ? first + 1 : first; i < filled_; ++i) y_.col(i) = y;
    }
    /// A run that an event has ended earlier reaches fewer times.
    template <class Result>
    void conclude(const Result& r) {
        while (filled_ > 0 && after(time(filled_ - 1), r.t)) --filled_;
    }

  private:
    bool after(const scalar& t, const scalar& u) const { return backwards_ ? t < u : t > u; }
    Eigen::Index checked(int i) const {
        if (i < 0 || i >= filled_) throw std::out_of_range("output_times: the run has not reached this time");
        return i;
    }

    std::vector<scalar> times_;
    bool with_derivatives_, backwards_ = false;
    int filled_ = 0, slopes_ = 0;  // how many values and derivatives there are
    matrix y_, derivatives_;
};

/// Not of states: of numbers, or of none.
template <class Vector>
requires(!requires { typename Vector::Scalar; }) class output_times<Vector> final {
  public:
    explicit output_times(std::vector<double>, bool = false) {}
    template <class... Arguments>
    void operator()(const Arguments&...) const;
    Eigen::VectorXd y(int) const;
    static_assert(detail::never<Vector>,
                  "write output_times<Eigen::Vector3d> table({0, 1}), with the type of the state");
};
output_times(std::vector<double>, bool = false)->output_times<detail::unstated>;

}  // namespace stagecraft
