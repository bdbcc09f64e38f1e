// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace stagecraft {

/// How values between two knots are had: `steps` is the value of the knot before (continuous from the right), `linear` a
/// straight line, `cubic` the spline with two continuous derivatives whose third does not jump at the second knot from either end
/// (not-a-knot; de Boor 1978), `pchip` piecewise cubic and monotone where the values are (Fritsch-Carlson 1980).
enum class interpolation { steps, linear, cubic, pchip };

/// Times beyond the first and the last knot are answered by the first and the last piece.
struct extrapolate_beyond {};
inline constexpr extrapolate_beyond extrapolate{};

/// A function of time through a table:
///
///     const interpolant inflow(times, values, interpolation::linear);       // std::vectors, or vectors of Eigen's
///     [&](double t, const auto& y, auto& f) { f[0] = inflow(t) - y[0]; }
///     integrate(run, {.break_points = inflow.break_points(1e-6)})           // or the problem's own member
///
/// t may be any scalar that a double can be taken from, dual numbers of automatic differentiation too. times are strictly increasing, two at least, a
/// value each; std::invalid_argument otherwise. A t beyond them is std::out_of_range, or with a last argument `extrapolate`
/// answered by the first or last piece. A copy owns its table: 5 numbers per knot. One value costs O(1) where t is in
/// the piece asked for last or in a neighbour of it, as along a run, otherwise O(log knots). May be called from several
/// threads.
template <class Scalar>
class interpolant {
  public:
    interpolant(std::vector<Scalar> times, std::vector<Scalar> values, interpolation kind)
        : knots_(std::move(times)), kind_(kind) {
        check(values);
        make_pieces(values);
    }
    interpolant(std::vector<Scalar> times, std::vector<Scalar> values, interpolation kind, extrapolate_beyond)
        : interpolant(std::move(times), std::move(values), kind) {
        extrapolates_ = true;
    }
    interpolant(std::initializer_list<Scalar> times, std::initializer_list<Scalar> values, interpolation kind)
        : interpolant(std::vector<Scalar>(times), std::vector<Scalar>(values), kind) {}
    interpolant(std::initializer_list<Scalar> times, std::initializer_list<Scalar> values, interpolation kind,
                extrapolate_beyond)
        : interpolant(std::vector<Scalar>(times), std::vector<Scalar>(values), kind, extrapolate) {}
    /// From vectors of Eigen's.
    template <class Times, class Values, class... More>
    requires(!std::is_same_v<Times, std::vector<Scalar>> && requires { typename Times::Scalar; })
        interpolant(const Times& times, const Values& values, interpolation kind, More... more)
        : interpolant(std::vector<Scalar>(times.begin(), times.end()),
                      std::vector<Scalar>(values.begin(), values.end()), kind, more...) {}

    /// The value at t.
    template <class T>
    T operator()(const T& t) const {
        const std::size_t i = piece_of(number(t));
        if (kind_ == interpolation::steps && number(t) >= knots_.back()) return T(last_);
        const auto& c = pieces_[i];
        if constexpr (std::is_arithmetic_v<T>) {
            const Scalar x = t - knots_[i];
            return T(c[0] + x * (c[1] + x * (c[2] + x * c[3])));
        } else {
            const T x = t - knots_[i];
            T sum = x * c[3] + c[2];
            sum = x * sum + c[1];
            return T(x * sum + c[0]);
        }
    }

    /// The knots at which a step of a run has to end if what follows the table, however closely, is to be within `tolerance`
    /// (in units of the values) between the ends as well: those where the value jumps by more, or where the slope jumps by
    /// so much that over the interval beside it this makes more than 8 tolerances, the distance of a kink from all smooth
    /// functions being an eighth. With tolerance 0, all at which it jumps at all. Of `cubic` and `pchip` there are none.
    std::vector<Scalar> break_points(const Scalar& tolerance = Scalar(0)) const {
        using std::abs;
        std::vector<Scalar> found;
        if (kind_ != interpolation::steps && kind_ != interpolation::linear) return found;
        for (std::size_t i = 1; i < pieces_.size(); ++i) {
            const Scalar& before = pieces_[i - 1][kind_ == interpolation::steps ? 0 : 1];
            const Scalar& behind = pieces_[i][kind_ == interpolation::steps ? 0 : 1];
            const Scalar rounding = 8 * std::numeric_limits<Scalar>::epsilon() * (abs(before) + abs(behind));
            Scalar jump = abs(behind - before);
            if (!(jump > rounding)) continue;
            if (kind_ == interpolation::linear) {
                const Scalar left = knots_[i] - knots_[i - 1], right = knots_[i + 1] - knots_[i];
                jump *= (left < right ? right : left) / 8;
            }
            if (jump > tolerance) found.push_back(knots_[i]);
        }
        if (kind_ == interpolation::steps && knots_.size() > 1) add_last_step(tolerance, found);
        return found;
    }

  private:
    /// A place in the table, which copies do not share.
    struct remembered_place {
        std::atomic<std::size_t> at{0};
        remembered_place() = default;
        remembered_place(const remembered_place&) {}
        remembered_place& operator=(const remembered_place&) { return *this; }
    };

    template <class T>
    static Scalar number(const T& t) {
        if constexpr (requires { t.value(); })
            return static_cast<Scalar>(t.value());
        else
            return static_cast<Scalar>(t);
    }

    void check(const std::vector<Scalar>& values) const {
        const auto demand = [](bool good, const char* what) {
            if (!good) throw std::invalid_argument(std::string("interpolant: ") + what);
        };
        demand(knots_.size() >= 2, "times must be two at least");
        demand(values.size() == knots_.size(), "values must be as many as times");
        for (std::size_t i = 0; i < knots_.size(); ++i) {
            demand(knots_[i] - knots_[i] == Scalar(0), "times must be finite");
            demand(values[i] - values[i] == Scalar(0), "values must be finite");
            demand(i == 0 || knots_[i - 1] < knots_[i], "times must be strictly increasing");
        }
    }

    void make_pieces(const std::vector<Scalar>& v) {
        const std::size_t n = v.size();
        pieces_.resize(n - 1, {});
        last_ = v.back();
        std::vector<Scalar> m(n - 1), s;
        for (std::size_t i = 0; i + 1 < n; ++i) m[i] = (v[i + 1] - v[i]) / (knots_[i + 1] - knots_[i]);
        if (kind_ == interpolation::cubic) s = spline_slopes(m);
        if (kind_ == interpolation::pchip) s = monotone_slopes(m);
        for (std::size_t i = 0; i + 1 < n; ++i) {
            pieces_[i][0] = v[i];
            if (kind_ == interpolation::linear) pieces_[i][1] = m[i];
            if (s.empty()) continue;
            const Scalar d = knots_[i + 1] - knots_[i];
            pieces_[i][1] = s[i];
            pieces_[i][2] = (3 * m[i] - 2 * s[i] - s[i + 1]) / d;
            pieces_[i][3] = (s[i] + s[i + 1] - 2 * m[i]) / d / d;
        }
    }
    Scalar length(std::size_t i) const { return knots_[i + 1] - knots_[i]; }

    /// The slopes at the knots of the not-a-knot spline: one tridiagonal system; of three knots the parabola, of two the line.
    std::vector<Scalar> spline_slopes(const std::vector<Scalar>& m) const {
        const std::size_t n = knots_.size();
        if (n == 2) return {m[0], m[0]};
        if (n == 3) {
            const Scalar second = (m[1] - m[0]) / (length(0) + length(1));
            return {m[0] - second * length(0), m[0] + second * length(0), m[1] + second * length(1)};
        }
        std::vector<Scalar> diagonal(n), above(n), below(n), s(n);
        const Scalar first = length(0) + length(1), last = length(n - 2) + length(n - 3);
        diagonal[0] = length(1), above[0] = first;
        s[0] = ((length(0) + 2 * first) * length(1) * m[0] + length(0) * length(0) * m[1]) / first;
        for (std::size_t i = 1; i + 1 < n; ++i) {
            below[i] = length(i), above[i] = length(i - 1);
            diagonal[i] = 2 * (length(i - 1) + length(i));
            s[i] = 3 * (length(i) * m[i - 1] + length(i - 1) * m[i]);
        }
        below[n - 1] = last, diagonal[n - 1] = length(n - 3);
        s[n - 1] = (length(n - 2) * length(n - 2) * m[n - 3] +
                    (2 * last + length(n - 2)) * length(n - 3) * m[n - 2]) /
                   last;
        for (std::size_t i = 1; i < n; ++i) {
            const Scalar factor = below[i] / diagonal[i - 1];
            diagonal[i] -= factor * above[i - 1];
            s[i] -= factor * s[i - 1];
        }
        s[n - 1] /= diagonal[n - 1];
        for (std::size_t i = n - 1; i-- > 0;) s[i] = (s[i] - above[i] * s[i + 1]) / diagonal[i];
        return s;
    }

    /// Slopes that keep monotone data monotone: weighted harmonic means, at the ends of three points.
    std::vector<Scalar> monotone_slopes(const std::vector<Scalar>& m) const {
        const std::size_t n = knots_.size();
        if (n == 2) return {m[0], m[0]};
        std::vector<Scalar> s(n, Scalar(0));
        for (std::size_t i = 1; i + 1 < n; ++i) {
            if (!(m[i - 1] * m[i] > Scalar(0))) continue;
            const Scalar a = 2 * length(i) + length(i - 1), b = length(i) + 2 * length(i - 1);
            s[i] = (a + b) / (a / m[i - 1] + b / m[i]);
        }
        s[0] = slope_at_end(length(0), length(1), m[0], m[1]);
        s[n - 1] = slope_at_end(length(n - 2), length(n - 3), m[n - 2], m[n - 3]);
        return s;
    }
    static Scalar slope_at_end(const Scalar& near, const Scalar& far, const Scalar& m, const Scalar& next) {
        using std::abs;
        const Scalar s = ((2 * near + far) * m - near * next) / (near + far);
        if (!(s * m > Scalar(0))) return Scalar(0);
        return m * next < Scalar(0) && abs(s) > 3 * abs(m) ? 3 * m : s;
    }

    /// The last value begins at the last knot.
    void add_last_step(const Scalar& tolerance, std::vector<Scalar>& found) const {
        using std::abs;
        if (abs(last_ - pieces_.back()[0]) > tolerance) found.push_back(knots_.back());
    }

    std::size_t piece_of(const Scalar& t) const {
        if (!(t >= knots_.front() && t <= knots_.back())) beyond(t);
        const std::size_t most = pieces_.size() - 1, near = place_.at.load(std::memory_order_relaxed);
        std::size_t i = near;
        const auto holds = [&](std::size_t k) { return knots_[k] <= t && t < knots_[k + 1]; };
        if (!holds(i)) {
            if (i < most && holds(i + 1))
                ++i;
            else if (i > 0 && holds(i - 1))
                --i;
            else
                i = search(t);
            place_.at.store(i, std::memory_order_relaxed);
        }
        return i;
    }
    std::size_t search(const Scalar& t) const {
        std::size_t low = 0, high = pieces_.size();
        while (high - low > 1) {
            const std::size_t middle = low + (high - low) / 2;
            (knots_[middle] <= t ? low : high) = middle;
        }
        return low;
    }
    void beyond(const Scalar& t) const {
        if (extrapolates_ && t == t) return;
        std::ostringstream message;
        message.precision(std::numeric_limits<Scalar>::max_digits10);
        message << "interpolant: t = " << t << " is not between " << knots_.front() << " and "
                << knots_.back() << "; with `extrapolate` the first and the last piece go on";
        throw std::out_of_range(message.str());
    }

    std::vector<Scalar> knots_;
    std::vector<std::array<Scalar, 4>> pieces_;  // coefficients in t - knot
    Scalar last_{0};
    interpolation kind_;
    bool extrapolates_ = false;
    mutable remembered_place place_;
};
template <class Times, class Values, class... More>
requires requires { typename Times::Scalar; }
interpolant(const Times&, const Values&, interpolation, More...)->interpolant<typename Times::Scalar>;

}  // namespace stagecraft
