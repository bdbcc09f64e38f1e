// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stdexcept>
#include <utility>
#include <vector>

#include "stagecraft/theory/dynamics/evaluate.hpp"
#include "stagecraft/theory/dynamics/tableau_numbers.hpp"
#include "stagecraft/theory/stability/stability_function.hpp"
#include "stagecraft/theory/statements/verdict.hpp"

namespace stagecraft::theory {

/// A real point that the map of a method sends to itself, after one step or after two.
struct periodic_point {
    rational low, high;   ///< it is the only one in [low, high]
    interval multiplier;  ///< derivative of the map (of its square for a cycle) there
    bool equilibrium;     ///< f vanishes there; a ghost if not
    double value() const { return ((low + high) / 2).to<double>(); }
    bool attracting() const { return multiplier.magnitude() < 1; }
};

/// proved: these are all. consistent: the degree was beyond the limit, and nothing was counted.
struct periodic_points {
    theory::verdict verdict;
    std::vector<periodic_point> points;
    int ghosts() const;
};

/// The largest degree whose real roots are looked for.
inline constexpr int largest_ghost_degree = 200;

namespace detail {

/// A rational number in the arithmetic T.
template <class T>
T lifted(const rational& q) {
    if constexpr (std::is_constructible_v<T, rational>) {
        return T(q);
    } else {
        return T(interval(q));
    }
}

/// x + h sum b_j f(X_j), one step of an explicit method for a scalar f, in any arithmetic T.
template <class T, class F>
T explicit_step(const tableau<rational>& m, F&& f, const T& x, const rational& h) {
    std::vector<T> k;
    T y = x;
    for (Eigen::Index i = 0; i < m.b.size(); ++i) {
        state<T, 1> xi(x), fi;
        for (Eigen::Index j = 0; j < i; ++j)
            if (m.A(i, j) != 0) xi[0] = xi[0] + lifted<T>(h * m.A(i, j)) * k[static_cast<std::size_t>(j)];
        f(no_time{}, xi, fi);
        k.push_back(fi[0]);
        y = y + lifted<T>(h * m.b[i]) * k.back();  // also for b_i = 0: the step needs the stage defined
    }
    return y;
}

/// m(m(x)), cleared of denominators.
rational_function squared(const rational_function& m);

template <class F>
rational_function explicit_map(const tableau<rational>& m, F&& f, const rational& h) {
    require_shape(m);
    require_step(h);
    if (!is_explicit(m))
        throw std::invalid_argument("method: must be explicit; for others give a box to search (ghosts_in)");
    return explicit_step(m, f, rational_function::x(), h);
}

/// The part of p whose zeros are none of a divisor of the map, and the rest: there some stage has no value.
struct split_zeros {
    polynomial<rational> defined, excluded{rational(1)};
    split_zeros(polynomial<rational> p, const rational_function& map);
    theory::verdict verdict() const;
};

/// The real zeros of a squarefree p with the multipliers of the `period`-th power of the map there.
template <class F>
std::vector<periodic_point> points_of(const polynomial<rational>& p, const tableau<rational>& m, F&& f,
                                      const rational& h, int period) {
    using number = dual<interval, 1>;
    std::vector<periodic_point> points;
    if (p.degree() < 1) return points;
    const auto still = gcd(p, as_rational_function(f).numerator());
    for (auto root : tableaux::isolate_real_roots(p)) {
        root = refine(p, root, rational(1, 1LL << 50));
        const bool equilibrium =
            still.degree() > 0 &&
            (root.exact() ? still(root.low) == 0
                          : tableaux::sturm_chain<rational>(still).count(root.low, root.high) > 0);
        number x = dual_unknown<1>(hull(interval(root.low), interval(root.high)), 0);
        for (int k = 0; k < period; ++k) x = explicit_step(m, f, x, h);
        points.push_back({root.low, root.high, x.derivatives()[0], equilibrium});
    }
    return points;
}

verdict too_high(int degree);

}  // namespace detail

/// All real fixed points of x -> x + h sum b_j f(X_j) for an explicit method and a scalar rational f: the
/// zeros of sum b_j f(X_j), isolated by Sturm's theorem. Those at which f does not vanish are ghosts
/// (lecture, section 1.3). A zero at which some stage divides by zero is none: the verdict names it. Throws std::invalid_argument for h <= 0 and for methods that are not explicit.
template <class F>
periodic_points ghosts(const tableau<rational>& method, F&& f, const rational& h) {
    const auto map = detail::explicit_map(method, f, h);
    const auto p = (map - rational_function::x()).numerator();
    if (p.is_zero()) throw std::invalid_argument("f: every point is fixed");
    if (p.degree() > largest_ghost_degree) return {detail::too_high(p.degree()), {}};
    const detail::split_zeros zeros(p, map);
    return {zeros.verdict(), detail::points_of(zeros.defined, method, f, h, 1)};
}

/// All real points of period two (not of period one), likewise.
template <class F>
periodic_points two_cycles(const tableau<rational>& method, F&& f, const rational& h) {
    const auto map = detail::explicit_map(method, f, h);
    const int degree = std::max(map.numerator().degree(), map.denominator().degree() + 1);
    if (degree * degree > largest_ghost_degree) return {detail::too_high(degree * degree), {}};
    const auto twice = detail::squared(map);
    auto p = (twice - rational_function::x()).numerator();
    const auto fixed = (map - rational_function::x()).numerator();
    if (p.is_zero()) throw std::invalid_argument("f: every point has period two");
    for (auto common = gcd(p, fixed); common.degree() > 0; common = gcd(p, fixed)) p = p / common;
    const detail::split_zeros zeros(std::move(p), twice);
    return {zeros.verdict(), detail::points_of(zeros.defined, method, f, h, 2)};
}

/// Zeros of P - Q and of P + Q: for x' = lambda x a method with stability function R = P/Q has fixed points
/// other than 0 where R(h lambda) = 1, and cycles of period two where it is -1.
template <class K>
polynomial<K> fixed_point_equation(const stability_function<K>& r) {
    return r.numerator - r.denominator;
}
template <class K>
polynomial<K> two_cycle_equation(const stability_function<K>& r) {
    return r.numerator + r.denominator;
}

/// P - Q = c z: linear problems have no ghosts at any step size
/// (Hairer-Iserles-Sanz-Serna 1990).
template <class K>
bool no_linear_ghosts(const stability_function<K>& r) {
    const auto p = fixed_point_equation(r);
    return p.degree() == 1 && p[0] == K(0);
}

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/dynamics/ghosts-inl.hpp"
#endif
