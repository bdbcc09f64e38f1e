// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <concepts>
#include <limits>
#include <stagecraft/tableaux/ball.hpp>

namespace stagecraft::tableaux {

/// An enclosure middle +- radius in long double, of about 18 digits: the radius grows with every operation by
/// what its rounding may be. What it says of a number is certain; it says it fifty times faster than ball,
/// and of fewer numbers.
class rough_ball {
  public:
    rough_ball() = default;
    template <std::integral I>
    rough_ball(I n) : v_(static_cast<long double>(n)) {}  // NOLINT: integers to 2^63 are exact
    /// Contains all that x contains.
    explicit rough_ball(const ball& x) : v_(x.middle().to<long double>()), r_(x.radius()) { widen(); }

    long double middle() const { return v_; }
    long double radius() const { return r_; }
    /// At least the size of every number inside.
    long double magnitude() const { return (std::abs(v_) + r_) * (1 + epsilon); }

    rough_ball operator-() const {
        rough_ball x = *this;
        x.v_ = -x.v_;
        return x;
    }
    rough_ball& operator+=(const rough_ball& o) {
        v_ += o.v_;
        r_ += o.r_;
        return widen();
    }
    rough_ball& operator-=(const rough_ball& o) { return *this += -o; }
    rough_ball& operator*=(const rough_ball& o) {
        r_ = std::abs(v_) * o.r_ + std::abs(o.v_) * r_ + r_ * o.r_;
        v_ *= o.v_;
        return widen();
    }
    /// Of infinite radius where o may be zero.
    rough_ball& operator/=(const rough_ball& o) {
        const long double distance = std::abs(o.v_) - o.r_;
        if (!(distance > 0)) {
            r_ = std::numeric_limits<long double>::infinity();
            return *this;
        }
        v_ /= o.v_;
        r_ = (r_ + std::abs(v_) * o.r_) / (distance * (1 - 4 * epsilon));
        return widen();
    }
    friend rough_ball operator+(rough_ball a, const rough_ball& b) { return a += b; }
    friend rough_ball operator-(rough_ball a, const rough_ball& b) { return a -= b; }
    friend rough_ball operator*(rough_ball a, const rough_ball& b) { return a *= b; }
    friend rough_ball operator/(rough_ball a, const rough_ball& b) { return a /= b; }
    friend bool operator==(const rough_ball&, const rough_ball&) = default;

  private:
    static constexpr long double epsilon = std::numeric_limits<long double>::epsilon();
    static constexpr long double least = 1e-1000L;  // more than underflow loses, and far enough from it
    rough_ball& widen() {  // by the rounding of the middle, and of the few operations on the radius
        r_ = (r_ + std::abs(v_) * epsilon) * (1 + 8 * epsilon) + least;
        return *this;
    }
    long double v_ = 0, r_ = 0;
};

/// True if the enclosed number cannot be zero.
inline bool certainly_nonzero(const rough_ball& x) { return std::abs(x.middle()) > x.radius(); }

}  // namespace stagecraft::tableaux
