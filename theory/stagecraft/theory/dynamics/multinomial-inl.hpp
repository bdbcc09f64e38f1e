// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/dynamics/multinomial.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE multinomial::multinomial(const rational& q) {  // NOLINT: so are rationals
    if (q != 0) terms_[{}] = q;
}

STAGECRAFT_INLINE multinomial multinomial::unknown(int i) {
    monomial m(static_cast<std::size_t>(i) + 1, 0);
    m.back() = 1;
    multinomial p;
    p.terms_[std::move(m)] = 1;
    return p;
}

STAGECRAFT_INLINE rational multinomial::coefficient(const monomial& m) const {
    const auto found = terms_.find(m);
    return found == terms_.end() ? rational(0) : found->second;
}

STAGECRAFT_INLINE int multinomial::degree() const {
    int d = -1;
    for (const auto& [m, a] : terms_) d = std::max(d, std::accumulate(m.begin(), m.end(), 0));
    return d;
}

STAGECRAFT_INLINE bool multinomial::depends_on(int i) const {
    return std::any_of(terms_.begin(), terms_.end(), [i](const auto& t) { return exponent(t.first, i) > 0; });
}

STAGECRAFT_INLINE int multinomial::exponent(const monomial& m, int i) {
    return static_cast<std::size_t>(i) < m.size() ? m[static_cast<std::size_t>(i)] : 0;
}

STAGECRAFT_INLINE multinomial& multinomial::operator+=(const multinomial& o) {
    for (const auto& [m, a] : o.terms_) add(m, a);
    return *this;
}

STAGECRAFT_INLINE multinomial& multinomial::operator/=(const multinomial& o) {
    if (o.degree() != 0)
        throw std::invalid_argument("multinomial: f divides by something that is not a constant");
    return *this *= multinomial(1 / o.constant());
}

STAGECRAFT_INLINE multinomial multinomial::derivative(int i) const {
    multinomial p;
    for (const auto& [m, a] : terms_) {
        const int k = exponent(m, i);
        if (k == 0) continue;
        monomial n = m;
        --n[static_cast<std::size_t>(i)];
        while (!n.empty() && n.back() == 0) n.pop_back();
        p.add(n, a * rational(k));
    }
    return p;
}

STAGECRAFT_INLINE polynomial<rational> multinomial::in_one_unknown(int i) const {
    polynomial<rational> p;
    for (const auto& [m, a] : terms_) {
        if (std::accumulate(m.begin(), m.end(), 0) != exponent(m, i))
            throw std::invalid_argument("multinomial: more than one unknown");
        p += polynomial<rational>::monomial(exponent(m, i), a);
    }
    return p;
}

STAGECRAFT_INLINE std::string multinomial::str() const {
    if (terms_.empty()) return "0";
    std::string out;
    for (auto t = terms_.rbegin(); t != terms_.rend(); ++t) {
        const auto& [m, a] = *t;
        out += out.empty() ? (a < 0 ? "-" : "") : (a < 0 ? " - " : " + ");
        std::string factors;
        for (std::size_t i = 0; i < m.size(); ++i) {
            if (m[i] == 0) continue;
            factors += (factors.empty() ? "x" : "*x") + std::to_string(i + 1);
            if (m[i] > 1) factors += "^" + std::to_string(m[i]);
        }
        const rational size = abs(a);
        out += factors.empty() ? size.str() : size == 1 ? factors : size.str() + "*" + factors;
    }
    return out;
}

STAGECRAFT_INLINE void multinomial::add(const monomial& m, const rational& a) {
    const auto [place, fresh] = terms_.try_emplace(m, a);
    if (!fresh) place->second += a;
    if (place->second == 0) terms_.erase(place);
}

}  // namespace stagecraft::theory
