// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/stability/embedded_collocation.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/precision.hpp"
#include "stagecraft/tableaux/range.hpp"
#include "stagecraft/theory/stability/a_stability.hpp"

namespace stagecraft::theory {

namespace detail {

using tableaux::integer, tableaux::rational;
using rational_polynomial = polynomial<rational>;

/// 1, 1/2, ..., 1/s: the moments of b.
STAGECRAFT_INLINE std::vector<rational> moments_of_method(int s) {
    std::vector<rational> m;
    for (int k = 0; k < s; ++k) m.emplace_back(integer(1), integer(k + 1));
    return m;
}

STAGECRAFT_INLINE rational factorial_of(int n) {
    rational f = 1;
    for (int k = 2; k <= n; ++k) f *= rational(k);
    return f;
}

/// The whole number m >= 1 that is nearest to the d-th root of x.
STAGECRAFT_INLINE int nearest_root(const rational& x, int d) {
    for (int m = 1;; ++m) {
        rational power = 1;
        for (int k = 0; k < d; ++k) power *= rational(2 * m + 1);
        for (int k = 0; k < d; ++k) power = power / rational(2);
        if (power >= x) return m;
    }
}

/// 1/m next to the geometric mean of the eigenvalues of A other than 0. Their product is that of the nodes other than 0, over s!.
STAGECRAFT_INLINE rational scale_of_estimate(const rational_polynomial& w, int d) {
    rational product = w[w.degree() - d];
    if (product < 0) product = -product;
    return rational(integer(1), integer(nearest_root(factorial_of(w.degree()) / product, d)));
}

/// The functional with these moments, of a polynomial of degree < s.
STAGECRAFT_INLINE rational applied(const std::vector<rational>& moments, const rational_polynomial& p) {
    rational sum = 0;
    for (int k = 0; k <= p.degree(); ++k) sum += p[k] * moments[static_cast<std::size_t>(k)];
    return sum;
}

/// M, M', ..., M^(s) of M = w/s!.
STAGECRAFT_INLINE std::vector<rational_polynomial> derivatives_of_m(const tableaux::nodal_polynomial& w) {
    const int s = w.degree();
    std::vector<rational_polynomial> m{tableaux::monic(w.monomial()) *
                                       rational_polynomial(rational(1) / factorial_of(s))};
    for (int k = 0; k < s; ++k) m.push_back(derivative(m.back()));
    return m;
}

/// The moments whose stability function has this numerator: those of j < s + 1 follow one after the other.
STAGECRAFT_INLINE std::vector<rational> moments_of_numerator(const tableaux::nodal_polynomial& w,
                                                             const rational_polynomial& p) {
    const auto m = derivatives_of_m(w);
    const int s = w.degree();
    std::vector<rational> moments;
    for (int j = 1; j <= s; ++j) {
        const auto& of = m[static_cast<std::size_t>(s - j + 1)];  // degree j - 1
        rational rest = p[j] - m[static_cast<std::size_t>(s - j)](rational(0));
        for (int k = 0; k < j - 1; ++k) rest = rest - of[k] * moments[static_cast<std::size_t>(k)];
        moments.push_back(rest / of.leading());
    }
    return moments;
}

/// The terms of Q e^z to z^n.
STAGECRAFT_INLINE rational_polynomial beginning(const rational_polynomial& q, int n) {
    std::vector<rational> p;
    for (int k = 0; k <= n; ++k) {
        rational sum = 0;
        for (int j = 0; j <= k; ++j) sum += q[j] / factorial_of(k - j);
        p.push_back(sum);
    }
    return rational_polynomial(std::move(p));
}

/// |Q(iy)|^2 - |P_0(iy) + tau (iy)^m|^2 = x^low (a - 2 tau b - tau^2 x^(m-low)) with x = y^2: what has to be >= 0.
struct excess_in_tau {
    rational_polynomial a, b;
    int m = 0, low = 0;

    excess_in_tau(const rational_polynomial& q, const rational_polynomial& p0, int power) : m(power) {
        low = (m + 1) / 2;  // below, the order makes it 0
        const auto whole = in_square(e_polynomial(stability_function<rational>{p0, q}));
        std::vector<rational> above, mixed(static_cast<std::size_t>(m) + 1, rational(0));
        for (int k = low; k <= whole.degree(); ++k) above.push_back(whole[k]);
        for (int k = 0; k <= p0.degree(); ++k)
            if ((m - k) % 2 == 0)
                mixed[static_cast<std::size_t>((k + m) / 2 - low)] += (m - k) / 2 % 2 == 0 ? p0[k] : -p0[k];
        a = rational_polynomial(std::move(above));
        b = rational_polynomial(std::move(mixed));
    }
    rational power_of(const rational& x) const {
        rational p = 1;
        for (int k = 0; k < m - low; ++k) p *= x;
        return p;
    }
    rational value(const rational& tau, const rational& x) const {
        return a(x) - rational(2) * tau * b(x) - tau * tau * power_of(x);
    }
    rational slope(const rational& tau, const rational& x) const { return -b(x) - tau * power_of(x); }
};

/// The same in doubles, at fixed points x, scaled so that values have the size of 1.
class sampled_excess {
  public:
    sampled_excess(const excess_in_tau& e, double radius) {
        const auto in_double = [](const rational& r) { return r.to<double>(); };
        points_.emplace_back(0);
        for (int k = 0; k <= 400; ++k) {
            const double x = radius * radius * std::pow(10.0, -6 + k / 40.0);
            points_.push_back(tableaux::scaled(rational(static_cast<long long>(std::ldexp(x, 40))), -40));
        }
        for (const rational& x : points_) {
            rational size = 0, power = 1;
            for (int k = 0; k <= e.a.degree(); ++k, power *= x)
                size += (e.a[k] < 0 ? -e.a[k] : e.a[k]) * power;
            if (size == rational(0)) size = 1;
            a_.push_back(in_double(e.a(x) / size));
            b_.push_back(in_double(e.b(x) / size));
            c_.push_back(in_double(e.power_of(x) / size));
        }
    }
    double at(std::size_t k, double tau) const { return a_[k] - 2 * tau * b_[k] - tau * tau * c_[k]; }
    double least(double tau) const {
        double g = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < points_.size(); ++k) g = std::min(g, at(k, tau));
        return g;
    }
    /// Where every tau outside of [-bound, bound] is excluded.
    double bound() const {
        double most = std::numeric_limits<double>::infinity();
        for (std::size_t k = 1; k < points_.size(); ++k)
            most = std::min(most,
                            (std::abs(b_[k]) + std::sqrt(b_[k] * b_[k] + std::abs(a_[k]) * c_[k])) / c_[k]);
        return most;
    }
    const std::vector<rational>& points() const { return points_; }

  private:
    std::vector<rational> points_;
    std::vector<double> a_, b_, c_;
};

/// The tau with the largest least value; the least value is concave in tau.
STAGECRAFT_INLINE double best_tau(const sampled_excess& g) {
    double left = -g.bound(), right = g.bound();
    for (int k = 0; k < 120; ++k) {
        const double x = left + (right - left) / 3, y = right - (right - left) / 3;
        (g.least(x) < g.least(y) ? left : right) = g.least(x) < g.least(y) ? x : y;
    }
    return (left + right) / 2;
}

/// The number of least denominator in the middle third of the interval around `best` on which the least value is >= 0.
STAGECRAFT_INLINE rational simple_tau(const sampled_excess& g, double best) {
    const auto end = [&](double outside) {
        double inside = best;
        for (int k = 0; k < 60; ++k) {
            const double middle = (inside + outside) / 2;
            (g.least(middle) >= 0 ? inside : outside) = middle;
        }
        return inside;
    };
    const double low = end(-2 * g.bound()), high = end(2 * g.bound());
    return tableaux::simplest_between(tableaux::exactly(low + (high - low) / 3),
                                      tableaux::exactly(high - (high - low) / 3));
}

/// Whether some x excludes all tau >= t and some x all tau <= t: exactly.
STAGECRAFT_INLINE bool none_is_proved(const excess_in_tau& e, const sampled_excess& g, const rational& t) {
    bool above = false, below = false;
    for (const rational& x : g.points()) {
        if (above && below) break;
        if (!(e.value(t, x) < 0)) continue;
        const rational slope = e.slope(t, x);
        above = above || !(slope > 0);
        below = below || !(slope < 0);
    }
    return above && below;
}

/// The numerator of an L-stable function over q of order d - 2; nothing where there is none.
STAGECRAFT_INLINE std::optional<rational_polynomial> l_stable_numerator(const rational_polynomial& q, int d) {
    const auto p0 = beginning(q, d - 2);
    const excess_in_tau e(q, p0, d - 1);
    const double radius = std::pow(std::abs(q.leading().to<double>()), -1.0 / d);
    const sampled_excess g(e, radius);
    const double best = best_tau(g);
    if (none_is_proved(e, g, tableaux::exactly(best))) return {};
    if (g.least(best) > 0) {
        std::vector<rational> p = p0.coefficients();
        p.resize(static_cast<std::size_t>(d), rational(0));
        p[static_cast<std::size_t>(d) - 1] = simple_tau(g, best);
        rational_polynomial found(std::move(p));
        if (l_stable(stability_function<rational>::reduced(found, q)).is_proved()) return found;
    }
    throw tableaux::undecided("--embedded: whether there is an L-stable formula of order " +
                              std::to_string(d - 2));
}

STAGECRAFT_INLINE std::string of_order(int q) { return "of order " + std::to_string(q); }

}  // namespace detail

STAGECRAFT_INLINE stability_function<tableaux::rational> function_of_moments(
    const tableaux::nodal_polynomial& w, const std::vector<tableaux::rational>& moments) {
    const auto m = detail::derivatives_of_m(w);
    const int s = w.degree();
    std::vector<tableaux::rational> p, q;
    for (int j = 0; j <= s; ++j) {
        q.push_back(m[static_cast<std::size_t>(s - j)](tableaux::rational(0)));
        p.push_back(q.back());
        if (j > 0) p.back() += detail::applied(moments, m[static_cast<std::size_t>(s - j + 1)]);
    }
    return {polynomial<tableaux::rational>(std::move(p)), polynomial<tableaux::rational>(std::move(q))};
}

STAGECRAFT_INLINE std::optional<embedded_weights_of_nodes> highest_embedded(
    const tableaux::nodal_polynomial& nodes) {
    using tableaux::rational;
    const auto w = tableaux::monic(nodes.monomial());
    const int s = w.degree();
    embedded_weights_of_nodes out{detail::moments_of_method(s), {}, s, {}};
    if (w[0] == rational(0)) {
        if (s == 1) return {};
        const rational g = detail::scale_of_estimate(w, s - 1);
        out.order = s - 1;
        out.moments.back() += g * w[1];
        out.why = "order " + std::to_string(s - 1) + ": b + " + g.str() +
                  " (f(t_0, y_0) - its extrapolation from the other stages); no weights on " +
                  std::to_string(s) + " nodes but b have order " + std::to_string(s);
        return out;
    }
    const rational g = integral(w)(rational(1)) / w[0];
    if (g != rational(0)) {
        out.order = s + 1;
        out.at_zero = g;
        out.moments[0] = out.moments[0] - g;
        out.why =
            "order " + std::to_string(s + 1) + " or more: the one formula of this order on 0 and the nodes";
        return out;
    }
    const rational scale = detail::scale_of_estimate(w, s);
    out.at_zero = scale;
    out.moments[0] = out.moments[0] - scale;
    out.why = "order " + std::to_string(s) + ": b + " + scale.str() +
              " (f(t_0, y_0) - its extrapolation from the stages); no weights on 0 and the nodes but b have "
              "order " +
              std::to_string(s + 1);
    return out;
}

STAGECRAFT_INLINE l_stable_embedded_formula l_stable_embedded(const tableaux::nodal_polynomial& nodes) {
    using tableaux::rational;
    const auto method = function_of_moments(nodes, detail::moments_of_method(nodes.degree()));
    const auto& q = method.denominator;
    const int d = q.degree();
    const auto formula = [&](const polynomial<rational>& p, int order, std::string why) {
        return l_stable_embedded_formula{
            embedded_weights_of_nodes{detail::moments_of_numerator(nodes, p), {}, order, std::move(why)}, {}};
    };
    const std::string begin = "there is no L-stable embedded formula ";
    if (d < 2) return {{}, begin + "of order 1 or more: the stages have no other weights of order 1"};
    const auto only = detail::beginning(q, d - 1);
    std::string why = "the one candidate of order " + std::to_string(d - 1) + " is the method itself";
    if (!(only == method.numerator)) {
        const verdict v = l_stable(stability_function<rational>::reduced(only, q));
        if (v.is_proved())
            return formula(only, d - 1,
                           "order " + std::to_string(d - 1) + ": R = P/Q with P the terms of Q e^z to z^" +
                               std::to_string(d - 1));
        why = "for the one candidate of order " + std::to_string(d - 1) + " " + v.reason();
    }
    if (d == 2) return {{}, begin + "of order 1 or more: " + why};
    const std::string orders = detail::of_order(d - 2) + " or more";
    if (const auto zeros = count_half_planes(q); zeros.left + zeros.axis > 0)
        return {{},
                begin + orders +
                    " with det(I - zA) as its denominator, whose zeros are not all in the right "
                    "half-plane: " +
                    why};
    if (const auto p = detail::l_stable_numerator(q, d))
        return formula(*p, d - 2,
                       "order " + std::to_string(d - 2) + ": R = P/Q with P the terms of Q e^z to z^" +
                           std::to_string(d - 2) + " and " + (*p)[d - 1].str() + " z^" +
                           std::to_string(d - 1) + "; " + why);
    return {{},
            begin + orders + ": " + why + ", and of order " + std::to_string(d - 2) +
                " every formula has |R(iy)| > 1 at some y"};
}

STAGECRAFT_INLINE tableaux::column<tableaux::quadratic> weights_at(
    const std::vector<tableaux::rational>& moments, const std::vector<tableaux::quadratic>& nodes) {
    using tableaux::quadratic;
    tableaux::column<quadratic> b(static_cast<Eigen::Index>(nodes.size()));
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        polynomial<quadratic> lagrange(quadratic(1));
        for (std::size_t k = 0; k < nodes.size(); ++k)
            if (k != i) {
                const quadratic gap = nodes[i] - nodes[k];
                lagrange *= polynomial<quadratic>{-nodes[k] / gap, quadratic(1) / gap};
            }
        quadratic sum(0);
        for (int k = 0; k <= lagrange.degree(); ++k)
            sum += lagrange[k] * quadratic(moments[static_cast<std::size_t>(k)]);
        b[static_cast<Eigen::Index>(i)] = sum;
    }
    return b;
}

STAGECRAFT_INLINE std::vector<tableaux::ball> weights_at(const std::vector<tableaux::rational>& moments,
                                                         const std::vector<tableaux::ball>& nodes, int bits) {
    using tableaux::ball;
    std::vector<ball> b;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        std::vector<ball> lagrange{ball(1).with_bits(bits)};  // ascending
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            if (k == i) continue;
            const ball gap = nodes[i] - nodes[k];
            lagrange.push_back(ball(0).with_bits(bits));
            for (std::size_t j = lagrange.size(); j-- > 0;)
                lagrange[j] =
                    ((j > 0 ? lagrange[j - 1] : ball(0).with_bits(bits)) - nodes[k] * lagrange[j]) / gap;
        }
        ball sum = ball(0).with_bits(bits);
        for (std::size_t k = 0; k < lagrange.size(); ++k) sum += lagrange[k] * ball(moments[k], bits);
        b.push_back(sum);
    }
    return b;
}

}  // namespace stagecraft::theory
