// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/dynamics/rational_function.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/range.hpp"
#include "stagecraft/tableaux/sturm.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE rational_function::rational_function(polynomial<rational> top, polynomial<rational> bottom,
                                                       const std::vector<polynomial<rational>>& divisors)
    : top_(std::move(top)), bottom_(std::move(bottom)) {
    if (bottom_.is_zero()) throw std::invalid_argument("rational_function: f divides by zero");
    if (bottom_.degree() > 0) {
        const auto common = gcd(top_, bottom_);
        if (common.degree() > 0) {
            top_ = top_ / common;
            bottom_ = bottom_ / common;
        }
    }
    const polynomial<rational> scale(1 / bottom_.leading());
    top_ *= scale;
    bottom_ *= scale;
    for (const auto& d : divisors)
        if (d.degree() > 0) remember(monic(d));
}

STAGECRAFT_INLINE rational rational_function::operator()(const rational& x) const {
    for (const auto& d : divisors_)
        if (d(x) == 0) throw std::domain_error("rational_function: f divides by zero at " + x.str());
    return top_(x) / bottom_(x);
}

STAGECRAFT_INLINE void rational_function::remember(polynomial<rational> divisor) {
    if (std::find(divisors_.begin(), divisors_.end(), divisor) == divisors_.end())
        divisors_.push_back(std::move(divisor));
}

STAGECRAFT_INLINE std::vector<polynomial<rational>> rational_function::both(const rational_function& a,
                                                                            const rational_function& b) {
    auto all = a.divisors_;
    all.insert(all.end(), b.divisors_.begin(), b.divisors_.end());
    return all;
}

STAGECRAFT_INLINE void require_defined_on_line(const rational_function& r) {
    for (const auto& d : r.divisors())
        if (tableaux::sturm_chain<rational>(d).count() > 0)
            throw std::invalid_argument("f: divides through zero on the real line");
}

STAGECRAFT_INLINE rational_function derivative(const rational_function& r) {
    const auto &p = r.numerator(), &q = r.denominator();
    return {derivative(p) * q - p * derivative(q), q * q, r.divisors()};
}

STAGECRAFT_INLINE std::optional<rational> point_above(const rational_function& r, const rational& level) {
    // r's denominator is monic without real roots, hence positive.
    return tableaux::negative_point(polynomial<rational>(level) * r.denominator() - r.numerator());
}

STAGECRAFT_INLINE std::optional<supremum> supremum_on_line(const rational_function& r,
                                                           const rational& width) {
    require_defined_on_line(r);
    const auto &p = r.numerator(), &q = r.denominator();
    if (p.degree() <= 0 && q.degree() == 0) return supremum{p[0], p[0], rational(0)};
    if (p.degree() > q.degree() && (p.leading() > 0 || (p.degree() - q.degree()) % 2 != 0)) return {};
    std::optional<supremum> best;
    if (p.degree() == q.degree()) best = supremum{p.leading(), p.leading(), {}};
    if (p.degree() < q.degree()) best = supremum{0, 0, {}};
    const auto slope = derivative(p) * q - p * derivative(q);
    const auto simple = squarefree(slope);
    for (auto root : tableaux::isolate_real_roots(slope)) {
        root = refine(simple, root, width * width);
        const rational c = tableaux::simplest_between(root.low, root.high);
        const rational value = r(c);
        if (!best || value > best->low || (value == best->low && !best->point))
            best = supremum{value, value, c};
    }
    for (rational slack = 0; point_above(r, best->high); slack = slack == 0 ? width : 2 * slack)
        best->high = best->low + slack;
    // A rational value at an irrational point: nothing lies above it, and it is met.
    if (best->low == best->high) return best;
    const rational v = tableaux::simplest_between(best->low, best->high);
    if (!point_above(r, v) && tableaux::sturm_chain<rational>(polynomial<rational>(v) * q - p).count() > 0)
        best->low = best->high = v;
    return best;
}

}  // namespace stagecraft::theory
