// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "stagecraft/tableaux/integer.hpp"
#include "stagecraft/tableaux/polynomial.hpp"

namespace stagecraft::tableaux {

/// Sign of an element of an ordered field: -1, 0, 1.
template <class K>
constexpr int sign_of(const K& a) {
    return a < K(0) ? -1 : K(0) < a ? 1 : 0;
}

/// Sign of p just before +infinity (side = 1) or -infinity (side = -1).
template <class K>
constexpr int sign_at_infinity(const polynomial<K>& p, int side) {
    if (p.is_zero()) return 0;
    return p.degree() % 2 != 0 ? side * sign_of(p.leading()) : sign_of(p.leading());
}

namespace detail {

/// Fractions of big integers: their polynomials are kept primitive, with coprime integer coefficients.
template <class K>
concept big_fraction = requires(const K& a) {
    K(gcd(a.numerator(), a.numerator()));
    K(lcm(a.denominator(), a.denominator()));
};

/// p times a positive number that keeps the coefficients small; p must not be zero.
template <class K>
constexpr polynomial<K> positively_scaled(const polynomial<K>& p) {
    if constexpr (big_fraction<K>) {
        auto common = p.leading().denominator();
        for (const K& a : p.coefficients()) common = lcm(common, a.denominator());
        auto content = K(p.leading() * K(common)).numerator();
        for (const K& a : p.coefficients()) content = gcd(content, K(a * K(common)).numerator());
        const K factor = K(common) / K(content);
        return p * polynomial<K>(sign_of(factor) < 0 ? K(0) - factor : factor);
    } else {
        const K size = sign_of(p.leading()) < 0 ? K(0) - p.leading() : p.leading();
        return p * polynomial<K>(K(1) / size);
    }
}

/// A positive multiple of -(f mod g); for big fractions by pseudo-division, which needs no fractions.
template <class K>
constexpr polynomial<K> negative_remainder(const polynomial<K>& f, const polynomial<K>& g) {
    if constexpr (big_fraction<K>) {
        std::vector<K> r = f.coefficients();
        const K head = sign_of(g.leading()) < 0 ? K(0) - g.leading() : g.leading();
        const bool flip = sign_of(g.leading()) < 0;
        for (int k = f.degree() - g.degree(); k >= 0; --k) {
            const K top = r[static_cast<std::size_t>(k + g.degree())];
            for (int j = 0; j < k + g.degree(); ++j) {
                auto& a = r[static_cast<std::size_t>(j)];
                a = a * head;
                if (j < k) continue;
                const K product = top * g.coefficients()[static_cast<std::size_t>(j - k)];
                if (flip) {
                    a = a + product;
                } else {
                    a = a - product;
                }
            }
        }
        if (f.degree() >= g.degree()) r.resize(static_cast<std::size_t>(g.degree()), K(0));
        return -polynomial<K>(std::move(r));
    } else {
        return -(f % g);
    }
}

}  // namespace detail

/// The signed remainder sequence f, g, -(f mod g), ..., every member scaled by a positive number: the
/// Cauchy index of g/f over (a, b) is variations(a) - variations(b).
template <class K>
class remainder_chain {
  public:
    constexpr remainder_chain(const polynomial<K>& first, const polynomial<K>& second) {
        if (!first.is_zero()) chain_.push_back(detail::positively_scaled(first));
        if (first.is_zero() || second.is_zero()) return;
        chain_.push_back(detail::positively_scaled(second));
        for (;;) {
            const auto next =
                detail::negative_remainder(chain_[chain_.size() - 2], chain_[chain_.size() - 1]);
            if (next.is_zero()) return;
            chain_.push_back(detail::positively_scaled(next));
        }
    }

    /// Sign variations of the chain at x, zeros dropped.
    constexpr int variations(const K& x) const {
        return count([&](const polynomial<K>& p) { return sign_of(p(x)); });
    }
    /// Sign variations at +infinity (side = 1) or -infinity (side = -1).
    constexpr int variations_at_infinity(int side) const {
        return count([&](const polynomial<K>& p) { return sign_at_infinity(p, side); });
    }
    /// Cauchy index of g/f over the real line.
    constexpr int index() const { return variations_at_infinity(-1) - variations_at_infinity(1); }

    constexpr const std::vector<polynomial<K>>& members() const { return chain_; }

  private:
    template <class Sign>
    constexpr int count(Sign sign) const {
        int variations = 0;
        int last = 0;
        for (const auto& p : chain_) {
            const int s = sign(p);
            if (s != 0 && last != 0 && s != last) ++variations;
            if (s != 0) last = s;
        }
        return variations;
    }
    std::vector<polynomial<K>> chain_;
};

/// Counts distinct real roots of a non-zero polynomial exactly (Sturm's theorem on the squarefree part).
/// Throws std::domain_error for p = 0.
template <class K>
class sturm_chain {
  public:
    constexpr explicit sturm_chain(const polynomial<K>& p)
        : squarefree_(squarefree(p)), chain_(squarefree_, derivative(squarefree_)) {
        if (p.is_zero()) throw std::domain_error("sturm_chain: the zero polynomial");
    }

    /// Distinct roots on the real line.
    constexpr int count() const { return chain_.index(); }
    /// Distinct roots in (a, b].
    constexpr int count(const K& a, const K& b) const { return chain_.variations(a) - chain_.variations(b); }
    /// Distinct roots in (a, infinity).
    constexpr int count_above(const K& a) const {
        return chain_.variations(a) - chain_.variations_at_infinity(1);
    }
    /// Distinct roots in (-infinity, a].
    constexpr int count_up_to(const K& a) const {
        return chain_.variations_at_infinity(-1) - chain_.variations(a);
    }
    /// The monic polynomial with the same roots, each simple.
    constexpr const polynomial<K>& squarefree_part() const { return squarefree_; }

  private:
    polynomial<K> squarefree_;
    remainder_chain<K> chain_;
};

/// A power of two that exceeds the modulus of every complex root (Cauchy's bound).
template <class K>
constexpr K root_bound(const polynomial<K>& p) {
    K reach(1);
    for (int k = 0; k < p.degree(); ++k) {
        const K q = p[k] / p.leading();
        const K size = sign_of(q) < 0 ? K(0) - q : q;
        while (reach < size + K(1)) reach = reach + reach;
    }
    return reach;
}

/// One real root of a polynomial: it is the only one in (low, high), or low = high is the root itself.
template <class K>
struct isolated_root {
    K low;
    K high;
    int multiplicity = 1;
    constexpr bool exact() const { return low == high; }
};

/// Halves the interval of a simple root of p until high - low <= width (or the root is met exactly).
/// Needs only the sign at the upper end, so that `low` may be a neighbouring root.
template <class K>
constexpr isolated_root<K> refine(const polynomial<K>& p, isolated_root<K> root, const K& width) {
    if (root.exact()) return root;
    if (sign_of(p(root.high)) == 0) throw std::invalid_argument("refine: a root at the end of the interval");
    const int above = sign_of(p(root.high));
    while (width < root.high - root.low) {
        const K middle = (root.low + root.high) / K(2);
        const int s = sign_of(p(middle));
        if (s == 0) return {middle, middle, root.multiplicity};
        (s == above ? root.high : root.low) = middle;
    }
    return root;
}

/// All real roots of p, increasing, in intervals that are disjoint up to end points. Cost: one Sturm chain
/// and its evaluation at O(roots * log(root_bound / distance)) points. Throws std::domain_error for p = 0.
template <class K>
constexpr std::vector<isolated_root<K>> isolate_real_roots(const polynomial<K>& p) {
    const sturm_chain<K> chain(p);
    const auto& q = chain.squarefree_part();
    const K reach = root_bound(q);
    std::vector<isolated_root<K>> found;
    std::vector<isolated_root<K>> open;  // (low, high] with `multiplicity` roots in it, rightmost first
    if (const int n = chain.count(); n > 0) open.push_back({K(0) - reach, reach, n});
    while (!open.empty()) {
        const auto [low, high, n] = open.back();
        open.pop_back();
        if (n == 1) {
            found.push_back(sign_of(q(high)) == 0 ? isolated_root<K>{high, high, 1}
                                                  : isolated_root<K>{low, high, 1});
            continue;
        }
        const K middle = (low + high) / K(2);
        const int below = chain.count(low, middle);
        if (n > below) open.push_back({middle, high, n - below});
        if (below > 0) open.push_back({low, middle, below});
    }
    for (const auto& [factor, multiplicity] : squarefree_split(p)) {
        if (multiplicity == 1) continue;
        const sturm_chain<K> repeated(factor);
        for (auto& root : found) {
            const bool here =
                root.exact() ? sign_of(factor(root.low)) == 0 : repeated.count(root.low, root.high) == 1;
            if (here) root.multiplicity = multiplicity;
        }
    }
    return found;
}

/// A point x with p(x) < 0, or nothing if p >= 0 on the whole real line: an exact decision. p may touch zero;
/// one point of every gap between neighbouring roots is looked at.
template <class K>
constexpr std::optional<K> negative_point(const polynomial<K>& p) {
    if (p.is_zero()) return {};
    const auto negative = [&](const K& x) { return sign_of(p(x)) < 0; };
    const K reach = root_bound(p);
    if (negative(K(0) - reach)) return K(0) - reach;
    if (negative(reach)) return reach;
    const auto roots = isolate_real_roots(p);
    const auto q = squarefree(p);
    for (std::size_t k = 0; k + 1 < roots.size(); ++k) {
        auto a = roots[k];
        auto b = roots[k + 1];
        while (!(a.high < b.low)) {
            a = refine(q, a, (a.high - a.low) / K(4));
            b = refine(q, b, (b.high - b.low) / K(4));
        }
        const K middle = (a.high + b.low) / K(2);
        if (negative(middle)) return middle;
    }
    return {};
}

/// The product of the factors of odd multiplicity: p changes its sign at the roots of this polynomial.
template <class K>
constexpr polynomial<K> odd_part(const polynomial<K>& p) {
    polynomial<K> odd(K(1));
    for (const auto& [factor, multiplicity] : squarefree_split(p)) {
        if (multiplicity % 2 != 0) odd *= factor;
    }
    return odd;
}

/// p >= 0 on [0, infinity): an exact decision, in most cases by one remainder chain of p and p'.
template <class K>
constexpr bool is_nonnegative_from_zero(const polynomial<K>& p) {
    if (p.is_zero()) return true;
    int lowest = 0;
    while (p[lowest] == K(0)) ++lowest;
    if (sign_of(p[lowest]) < 0 || sign_of(p.leading()) < 0) return false;
    const auto rest = p / polynomial<K>::monomial(lowest);
    const remainder_chain<K> chain(rest, derivative(rest));
    if (chain.variations(K(0)) == chain.variations_at_infinity(1)) return true;  // no root beyond 0
    if (chain.members().back().degree() == 0) return false;                      // a simple one
    return sturm_chain<K>(odd_part(rest)).count_above(K(0)) == 0;
}

/// Where p, non-negative on [0, end], first becomes negative: the largest such end, as an isolated root of p
/// (refined to `width`), low = high = 0 where p is negative right after 0; nothing where p >= 0 on all of
/// [0, infinity).
template <class K>
constexpr std::optional<isolated_root<K>> first_sign_loss(const polynomial<K>& p, const K& width) {
    if (p.is_zero()) return {};
    int lowest = 0;
    while (p[lowest] == K(0)) ++lowest;
    if (p[lowest] < K(0)) return isolated_root<K>{K(0), K(0), 1};
    auto rest = p / polynomial<K>::monomial(lowest);
    remainder_chain<K> chain(rest, derivative(rest));
    if (chain.members().back().degree() > 0) {
        rest = odd_part(rest);
        chain = remainder_chain<K>(rest, derivative(rest));
    }
    const int at_zero = chain.variations(K(0));
    if (at_zero == chain.variations_at_infinity(1)) return {};
    isolated_root<K> root{K(0), root_bound(rest), 1};
    while (at_zero - chain.variations(root.high) > 1) {  // the smallest one; none up to root.low
        const K middle = (root.low + root.high) / K(2);
        (chain.variations(middle) < at_zero ? root.high : root.low) = middle;
    }
    if (sign_of(rest(root.high)) == 0) return isolated_root<K>{root.high, root.high, 1};
    return refine(rest, root, width);
}

/// A point x >= 0 with p(x) < 0, or nothing if p >= 0 there: an exact decision.
template <class K>
constexpr std::optional<K> negative_point_from_zero(const polynomial<K>& p) {
    if (p.is_zero()) return {};
    const auto negative = [&](const K& x) { return sign_of(p(x)) < 0; };
    if (K x = root_bound(p); negative(x)) return x;
    auto loss = first_sign_loss(p, K(1));
    if (!loss) return {};
    // A sign change: right of it p < 0 up to the next root (or a touching one at its upper end).
    for (K step(1);; step = step / K(2)) {
        const K x = loss->exact() ? loss->high + step : loss->high;
        if (negative(x)) return x;
        if (!loss->exact()) loss = first_sign_loss(p, step);
    }
}

}  // namespace stagecraft::tableaux
