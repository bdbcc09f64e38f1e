// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/quadratic.hpp"

#include <numeric>

#include "stagecraft/compiled.hpp"

namespace stagecraft::tableaux {

STAGECRAFT_INLINE square_split split_square(std::uint64_t n) {
    if (n == 0) throw std::invalid_argument("split_square: n must be positive");
    if (n > largest_radicand) throw std::overflow_error("split_square: n exceeds 2^48");
    square_split s{1, 1};
    for (std::uint64_t p = 2; p * p * p <= n; ++p) {
        for (; n % (p * p) == 0; n /= p * p) s.root *= p;
        if (n % p == 0) {
            s.core *= p;
            n /= p;
        }
    }
    const integer r = sqrt(integer(n));
    if (r * r == n)
        s.root *= static_cast<std::uint64_t>(r);
    else
        s.core *= n;
    return s;
}

STAGECRAFT_INLINE square_split product_of_surds(std::uint64_t d, std::uint64_t e) {
    const std::uint64_t g = std::gcd(d, e);
    if (d / g > largest_radicand / (e / g)) throw mixed_surds("quadratic: too large a radicand");
    return {g, (d / g) * (e / g)};
}

STAGECRAFT_INLINE bool in_one_field(const std::vector<std::uint64_t>& radicands) {
    if (radicands.size() < 2) return true;
    if (radicands.size() > 3) return false;
    const std::uint64_t g = std::gcd(radicands[0], radicands[1]);
    if (radicands[0] / g > largest_radicand / (radicands[1] / g)) return false;
    return radicands.size() == 2 || product_of_surds(radicands[0], radicands[1]).core == radicands[2];
}

STAGECRAFT_INLINE quadratic::quadratic(rational a, rational b, std::uint64_t d) : a_(std::move(a)) {
    if (b == 0 || d == 0) return;
    const auto [root, core] = split_square(d);
    b *= rational(root);
    if (core == 1) {
        a_ += b;
    } else {
        b_ = std::move(b);
        d_ = core;
    }
}

STAGECRAFT_INLINE std::vector<quadratic::surd> quadratic::surds() const {
    std::vector<surd> all;
    if (d_ != 0) all.push_back({b_, d_});
    all.insert(all.end(), more_.begin(), more_.end());
    return all;
}

STAGECRAFT_INLINE integer quadratic::denominator() const {
    integer n = lcm(a_.denominator(), b_.denominator());
    for (const surd& x : more_) n = lcm(n, x.factor.denominator());
    return n;
}

STAGECRAFT_INLINE quadratic quadratic::conjugate() const {
    if (more_.empty()) return {a_, -b_, d_, {}};
    quadratic x = *this;
    for (surd& y : x.more_) y.factor = -y.factor;
    return x;
}

STAGECRAFT_INLINE quadratic quadratic::norm() const {
    if (more_.empty()) return a_ * a_ - rational(d_) * b_ * b_;
    return *this * conjugate();
}

STAGECRAFT_INLINE quadratic quadratic::operator-() const {
    quadratic x{-a_, -b_, d_, more_};
    for (surd& y : x.more_) y.factor = -y.factor;
    return x;
}

STAGECRAFT_INLINE quadratic& quadratic::operator+=(const quadratic& o) {
    if (!one_field(o)) return *this = from_terms(sum(terms(), o.terms()));
    a_ += o.a_;
    if (o.d_ == 0) return *this;
    b_ += o.b_;
    d_ = b_ == 0 ? 0 : o.d_;
    return *this;
}

STAGECRAFT_INLINE quadratic& quadratic::operator-=(const quadratic& o) {
    if (!one_field(o)) return *this += -o;
    a_ -= o.a_;
    if (o.d_ == 0) return *this;
    b_ -= o.b_;
    d_ = b_ == 0 ? 0 : o.d_;
    return *this;
}

STAGECRAFT_INLINE quadratic& quadratic::operator*=(const quadratic& o) {
    if (!one_field(o)) return *this = from_terms(product(terms(), o.terms()));
    if (o.d_ == 0) {  // rational numbers pay for rational arithmetic only
        a_ *= o.a_;
        if (d_ != 0) b_ *= o.a_;
        d_ = b_ == 0 ? 0 : d_;
        return *this;
    }
    rational a = a_ * o.a_ + (d_ == 0 ? rational(0) : rational(d_) * b_ * o.b_);
    b_ = a_ * o.b_ + b_ * o.a_;
    a_ = std::move(a);
    d_ = b_ == 0 ? 0 : o.d_;
    return *this;
}

STAGECRAFT_INLINE quadratic& quadratic::operator/=(const quadratic& o) {
    if (o.is_rational()) {
        a_ /= o.a_;
        if (d_ != 0) b_ /= o.a_;
        for (surd& x : more_) x.factor /= o.a_;
        return *this;
    }
    const quadratic n = o.norm();
    *this *= o.conjugate();
    return *this /= n;
}

STAGECRAFT_INLINE std::string quadratic::str() const {
    std::string s = a_ == 0 && d_ != 0 ? "" : a_.str();
    for (const surd& x : surds()) {
        const std::string root = "sqrt(" + std::to_string(x.radicand) + ")";
        const rational size = abs(x.factor);
        if (x.factor < 0)
            s += "-";
        else if (!s.empty())
            s += "+";
        s += size == 1 ? root : size.str() + "*" + root;
    }
    return s;
}

STAGECRAFT_INLINE bool quadratic::one_field(const quadratic& o) const {
    return more_.empty() && o.more_.empty() && (d_ == 0 || o.d_ == 0 || d_ == o.d_);
}

STAGECRAFT_INLINE quadratic::components quadratic::terms() const {
    components all{{1, a_}};
    for (const surd& x : surds()) all[x.radicand] = x.factor;
    return all;
}

STAGECRAFT_INLINE quadratic::components quadratic::sum(components x, const components& y) {
    for (const auto& [radicand, factor] : y) x[radicand] += factor;
    return x;
}

STAGECRAFT_INLINE quadratic::components quadratic::product(const components& x, const components& y) {
    components all;
    for (const auto& [d, p] : x)
        for (const auto& [e, q] : y) {
            const auto [root, core] = product_of_surds(d, e);
            all[core] += rational(root) * p * q;
        }
    return all;
}

STAGECRAFT_INLINE quadratic quadratic::from_terms(const components& all) {
    quadratic x;
    std::vector<std::uint64_t> radicands;
    for (const auto& [radicand, factor] : all) {
        if (factor == 0) continue;
        if (radicand == 1) {
            x.a_ = factor;
            continue;
        }
        radicands.push_back(radicand);
        if (x.d_ == 0)
            x.b_ = factor, x.d_ = radicand;
        else
            x.more_.push_back({factor, radicand});
    }
    if (!in_one_field(radicands)) throw mixed_surds("quadratic: three independent surds meet");
    return x;
}

STAGECRAFT_INLINE quadratic::step_of_tower quadratic::tower() const {
    if (more_.empty()) return {a_, b_, d_};
    const auto [factor, e] = more_.front();
    quadratic v = factor;
    if (more_.size() == 2)  // sqrt(d) sqrt(e) = root sqrt(core)
        v += quadratic(0, more_.back().factor / rational(product_of_surds(d_, e).root), d_);
    return {{a_, b_, d_, {}}, std::move(v), e};
}

STAGECRAFT_INLINE int quadratic::sign_() const {
    if (is_rational()) return stagecraft::tableaux::sign(a_);
    const auto [u, v, d] = tower();
    const int su = u.sign_(), sv = v.sign_();
    if (su == 0 || sv == 0 || su == sv) return su != 0 ? su : sv;
    return su * norm().sign_();  // |u| > |v| sqrt(d) exactly when the norm is positive
}

STAGECRAFT_INLINE std::optional<quadratic> exact_sqrt(const rational& r) {
    if (r < 0) return std::nullopt;
    const integer p = r.numerator();
    const integer q = r.denominator();
    const integer root_p = sqrt(p);
    const integer root_q = sqrt(q);
    if (root_p * root_p == p && root_q * root_q == q) return quadratic(rational(root_p, root_q));
    const integer n = p * q;  // sqrt(p/q) = sqrt(pq)/q
    if (n > largest_radicand) return std::nullopt;
    return quadratic(0, rational(integer(1), q), static_cast<std::uint64_t>(n));
}

STAGECRAFT_INLINE std::optional<quadratic> exact_sqrt(const quadratic& x) {
    if (x.is_rational()) return exact_sqrt(x.rational_part());
    if (!x.has_one_surd() || sign(x) < 0) return std::nullopt;
    const auto n = exact_sqrt(x.norm().rational_part());
    if (!n || !n->is_rational()) return std::nullopt;
    const auto p = exact_sqrt((x.rational_part() + n->rational_part()) / rational(2));
    const auto q = exact_sqrt((x.rational_part() - n->rational_part()) / rational(2));
    if (!p || !q) return std::nullopt;
    return x.surd_part() > 0 ? *p + *q : *p - *q;
}

}  // namespace stagecraft::tableaux
