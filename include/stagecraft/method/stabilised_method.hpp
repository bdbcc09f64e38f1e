// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace stagecraft {

/// Orthogonal polynomials p_0 = 1, p_1, p_2, ... of which stabilised methods are made, by their recurrence
/// p_j = A_j x p_{j-1} - C_j p_{j-2}: Chebyshev's of the first kind, Legendre's, Gegenbauer's with lambda = 3/2. All of them
/// satisfy |p_j(x)| <= p_j(1) for |x| <= 1 and grow beyond 1 (Szego, Orthogonal Polynomials, 7.32 and 7.33).
enum class stabilised_family { chebyshev, legendre, gegenbauer };

/// An explicit method of order 1 or 2 whose number of stages s grows with the step, so that its real stability interval
/// [-beta(s), 0] with beta ~ s^2 covers h times the spectral radius: the stability function is
///
///     R(z) = a_s + b_s p_s(w_0 + w_1 z),   w_0 = 1 + damping / s^2.
///
/// RKC: Chebyshev (van der Houwen and Sommeijer 1980; Sommeijer, Shampine and Verwer 1998); RKL: Legendre (Meyer,
/// Balsara and Aslam 2014); RKG: Gegenbauer (Skaras, Saxton, Meyer and Aslam 2021). Made by rkc2() and the others of stabilised.hpp.
template <class Scalar>
struct stabilised_method {
    using scalar = Scalar;
    stabilised_family family;
    int order;          ///< 1 or 2
    Scalar damping{0};  ///< >= 0
    int stages = 0;     ///< of every step; 0: as many as the step needs
};

/// The coefficients of the step with s stages, in any scalar, an exact one too:
///
///     Y_0 = y,  Y_1 = y + rate_1 h F_0,
///     Y_j = (1 - mu_j - nu_j) y + mu_j Y_{j-1} + nu_j Y_{j-2} + rate_j h F_{j-1} + start_j h F_0,   y1 = Y_s,
///
/// F_j = f(t + c_j h, Y_j). Every Y_j has the stability polynomial a_j + b_j p_j(w_0 + w_1 z) with the b_j that give it order 2
/// (order 1 where the method has that). Storage is kept from one number of stages to the next.
template <class Scalar>
class stabilised_recurrence {
  public:
    struct row {
        Scalar mu{0}, nu{0}, rate{0}, start{0}, c{0};
    };

    /// std::invalid_argument where the order is not 1 or 2, or the damping is negative or not finite.
    explicit stabilised_recurrence(const stabilised_method<Scalar>& m) : m_(m) {
        if (m.order != 1 && m.order != 2)
            throw std::invalid_argument("stabilised_method: order must be 1 or 2");
        if (!(m.damping >= Scalar(0)) || !(m.damping - m.damping == Scalar(0)))
            throw std::invalid_argument("stabilised_method: damping must be finite and not negative");
        if (m.stages < 0 || (m.stages > 0 && m.stages < m.order))
            throw std::invalid_argument("stabilised_method: stages must be at least the order");
    }

    int stages() const { return s_; }
    /// 1 <= j <= s.
    const row& at(int j) const { return rows_[static_cast<std::size_t>(j)]; }
    /// The length of the interval [-beta, 0] in which |R| <= 1.
    const Scalar& beta() const { return beta_; }
    /// R on the part w_0 + w_1 z <= 1 of it lies between these, and between 1 and `most` on the rest.
    const Scalar& least() const { return least_; }
    const Scalar& most() const { return most_; }
    /// b_j.
    const Scalar& weight(int j) const { return b_[static_cast<std::size_t>(j)]; }
    /// |a_j| + b_j p_j(w_0), which the stability polynomial of Y_j does not exceed on the interval.
    Scalar bound(int j) const {
        const Scalar reach = weight(j) * p_[static_cast<std::size_t>(j)], a = Scalar(1) - reach;
        return (a < Scalar(0) ? Scalar(-a) : a) + reach;
    }

    /// The coefficients for s stages, s >= order. O(s).
    void make(int s) {
        if (s == s_) return;
        s_ = s;
        const Scalar w0 = Scalar(1) + m_.damping / (Scalar(s) * Scalar(s));
        const std::size_t n = static_cast<std::size_t>(s) + 1;
        p_.resize(n), d_.resize(n), dd_.resize(n), b_.resize(n), rows_.resize(n);
        Scalar at_one[2] = {Scalar(1), Scalar(1)};  // p_{j-2}(1), p_{j-1}(1)
        p_[0] = Scalar(1), d_[0] = dd_[0] = Scalar(0);
        for (int j = 1; j <= s; ++j) {
            const std::size_t k = static_cast<std::size_t>(j);
            const Scalar A = slope(j), C = j > 1 ? back(j) : Scalar(0);
            const std::size_t two = j > 1 ? k - 2 : 0;
            p_[k] = A * w0 * p_[k - 1] - C * p_[two];
            d_[k] = A * (p_[k - 1] + w0 * d_[k - 1]) - C * d_[two];
            dd_[k] = A * (Scalar(2) * d_[k - 1] + w0 * dd_[k - 1]) - C * dd_[two];
            const Scalar one = A * at_one[1] - C * at_one[0];
            at_one[0] = at_one[1], at_one[1] = one;
        }
        weigh(s, w0);
        const std::size_t last = static_cast<std::size_t>(s);
        const Scalar a = Scalar(1) - b_[last] * p_[last], reach = b_[last] * at_one[1];
        least_ = a - reach, most_ = a + reach;
    }

    /// The smallest number of stages with beta >= x, odd without damping, where R(-beta) = 1 with an even one. At most
    /// `limit`: more where that is not enough. O(s).
    int stages_for(const Scalar& x, int limit) {
        using std::sqrt;
        int s = s_ > 0 ? s_ : 10;
        const int step = m_.damping > Scalar(0) ? 1 : 2,
                  first = m_.order == 1 && step == 2 ? 3 : m_.order + 1;
        for (int k = 0; k < 3; ++k) {  // beta ~ s^2
            make(s);
            const Scalar next = Scalar(s) * sqrt(x / beta_);
            if (!(next < Scalar(limit))) return limit + 1;
            s = static_cast<int>(next) + 1;
            if (s < first) s = first;
        }
        if (step == 2 && s % 2 == 0) ++s;
        const auto covers = [&](int k) {
            make(k);
            return beta_ >= x;
        };
        while (s > first && covers(s - step)) s -= step;
        while (!covers(s)) s += step;
        return s;
    }

  private:
    Scalar slope(int j) const {
        switch (m_.family) {
            case stabilised_family::chebyshev:
                return Scalar(j == 1 ? 1 : 2);
            case stabilised_family::legendre:
                return Scalar(2 * j - 1) / Scalar(j);
            default:
                return Scalar(2 * j + 1) / Scalar(j);
        }
    }
    Scalar back(int j) const {
        switch (m_.family) {
            case stabilised_family::chebyshev:
                return Scalar(1);
            case stabilised_family::legendre:
                return Scalar(j - 1) / Scalar(j);
            default:
                return Scalar(j + 1) / Scalar(j);
        }
    }
    /// The weights b_j, and what follows from them.
    void weigh(int s, const Scalar& w0) {
        const std::size_t last = static_cast<std::size_t>(s);
        const bool second = m_.order == 2;
        for (std::size_t j = 0; j <= last; ++j) {
            const std::size_t k = second && j < 2 ? 2 : j;  // b_0 = b_1 = b_2
            b_[j] = second ? Scalar(dd_[k] / (d_[k] * d_[k])) : Scalar(Scalar(1) / p_[k]);
        }
        const Scalar w1 = second ? Scalar(d_[last] / dd_[last]) : Scalar(p_[last] / d_[last]);
        beta_ = (w0 + Scalar(1)) / w1;
        rows_[0] = {};
        for (int j = 1; j <= s; ++j) {
            const std::size_t k = static_cast<std::size_t>(j);
            row& r = rows_[k];
            r = {};
            r.rate = slope(j) * w1 * b_[k] / b_[k - 1];
            if (j == 1) {
                r.rate = slope(1) * w1 * b_[1];
                r.c = r.rate;
                continue;
            }
            r.mu = slope(j) * w0 * b_[k] / b_[k - 1];
            r.nu = -back(j) * b_[k] / b_[k - 2];
            r.start = second ? Scalar(-(Scalar(1) - b_[k - 1] * p_[k - 1]) * r.rate) : Scalar(0);
            r.c = r.mu * rows_[k - 1].c + r.nu * rows_[k - 2].c + r.rate + r.start;
        }
    }

    stabilised_method<Scalar> m_;
    int s_ = 0;
    Scalar beta_{0}, least_{0}, most_{0};
    std::vector<Scalar> p_, d_, dd_, b_;  // p_j, its first two derivatives at w_0, and b_j
    std::vector<row> rows_;
};

}  // namespace stagecraft
