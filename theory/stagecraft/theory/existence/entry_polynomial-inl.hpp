// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/existence/entry_polynomial.hpp"

#include <algorithm>
#include <iterator>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE entry_polynomial::entry_polynomial(const tableaux::rational& x) {
    if (x != tableaux::rational(0)) terms_.emplace(product{}, x);
}

STAGECRAFT_INLINE entry_polynomial entry_polynomial::unknown(std::size_t number) {
    entry_polynomial p;
    p.terms_.emplace(product{number}, tableaux::rational(1));
    return p;
}

STAGECRAFT_INLINE entry_polynomial& entry_polynomial::add(const entry_polynomial& o,
                                                          const tableaux::rational& times) {
    too_long_ = too_long_ || o.too_long_ || terms_.size() + o.terms_.size() > 2 * most_terms;
    if (too_long_) {
        terms_.clear();
        return *this;
    }
    for (const auto& [p, x] : o.terms_) {
        const auto [place, is_new] = terms_.try_emplace(p, x * times);
        if (is_new) continue;
        place->second += x * times;
        if (place->second == tableaux::rational(0)) terms_.erase(place);
    }
    return *this;
}

STAGECRAFT_INLINE entry_polynomial operator*(const entry_polynomial& x, const entry_polynomial& y) {
    entry_polynomial out;
    if (x.is_zero() || y.is_zero()) return out;
    out.too_long_ =
        x.too_long_ || y.too_long_ || x.terms_.size() * y.terms_.size() > entry_polynomial::most_terms;
    if (out.too_long_) return out;
    for (const auto& [p, a] : x.terms_)
        for (const auto& [q, b] : y.terms_) {
            entry_polynomial::product both;
            std::merge(p.begin(), p.end(), q.begin(), q.end(), std::back_inserter(both));
            const auto [place, is_new] = out.terms_.try_emplace(std::move(both), a * b);
            if (is_new) continue;
            place->second += a * b;
            if (place->second == tableaux::rational(0)) out.terms_.erase(place);
        }
    return out;
}

STAGECRAFT_INLINE std::optional<std::pair<std::size_t, tableaux::rational>> entry_polynomial::root_of_one()
    const {
    if (too_long_ || terms_.empty() || terms_.size() > 2) return std::nullopt;
    const auto& [last, by] = *terms_.rbegin();
    if (last.size() != 1) return std::nullopt;
    if (terms_.size() == 1) return std::pair(last.front(), tableaux::rational(0));
    if (!terms_.begin()->first.empty()) return std::nullopt;
    return std::pair(last.front(), -terms_.begin()->second / by);
}

STAGECRAFT_INLINE entry_polynomial independent_polynomials::rest(entry_polynomial p) const {
    for (auto from = p.terms().rbegin(); from != p.terms().rend();) {  // from the leading product downwards
        const auto lead = from->first;
        const auto found = by_leading_.find(lead);
        if (found != by_leading_.end())
            p.add(found->second, -(from->second / found->second.terms().at(lead)));
        from = std::make_reverse_iterator(p.terms().lower_bound(lead));
    }
    return p;
}

STAGECRAFT_INLINE entry_polynomial independent_polynomials::take(entry_polynomial p) {
    p = rest(std::move(p));
    if (!p.is_too_long() && !p.is_zero()) by_leading_.emplace(p.terms().rbegin()->first, p);
    return p;
}

}  // namespace stagecraft::theory
