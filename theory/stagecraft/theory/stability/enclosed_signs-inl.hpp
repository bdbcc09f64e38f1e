// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/stability/enclosed_signs.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/theory/statements/certainty.hpp"

namespace stagecraft::theory {

namespace detail {

using tableaux::ball, tableaux::bound;

/// The coefficients in Bernstein's basis on [0, 1]: sum_k a_k C(i, k) / C(n, k).
STAGECRAFT_INLINE std::vector<ball> bernstein(const std::vector<ball>& a) {
    const auto n = static_cast<std::int64_t>(a.size()) - 1;
    std::vector<ball> scaled, b;
    ball inverse = ball(1).with_bits(checker_bits);  // 1 / C(n, k)
    for (std::int64_t k = 0; k <= n; ++k) {
        scaled.push_back(a[static_cast<std::size_t>(k)] * inverse);
        if (k < n) inverse = inverse.times(k + 1).over(n - k);
    }
    for (std::int64_t i = 0; i <= n; ++i) {
        ball sum(0), choose = ball(1).with_bits(checker_bits);  // C(i, k)
        for (std::int64_t k = 0; k <= i; ++k) {
            sum += scaled[static_cast<std::size_t>(k)] * choose;
            if (k < i) choose = choose.times(i - k).over(k + 1);
        }
        b.push_back(sum);
    }
    return b;
}

/// 1 or -1 where the polynomials have that sign on the whole cell, its ends included: no coefficient has the other, and
/// the values at the ends, which are the outer ones, do not vanish. 0 otherwise.
STAGECRAFT_INLINE int common_sign(const std::vector<ball>& b) {
    if (!certainly_nonzero(b.front()) || !certainly_nonzero(b.back())) return 0;
    bool positive = false, negative = false;
    for (const ball& x : b) {
        if (x.exactly_zero()) continue;
        if (!certainly_nonzero(x)) return 0;
        (certainly_positive(x) ? positive : negative) = true;
    }
    return positive == negative ? 0 : positive ? 1 : -1;
}

/// Whether no part of the cell can have a certain sign: each coefficient is one of rounding.
STAGECRAFT_INLINE bool all_open(const std::vector<ball>& b) {
    return std::none_of(b.begin(), b.end(), [](const ball& x) { return certainly_nonzero(x); });
}

/// Walks [0, 1] or, with u for 1/u, [1, infinity) from left to right.
class sign_walk {
  public:
    explicit sign_walk(const sign_search& how) : how_(how) {}

    void cell(std::vector<ball> b, bound low, bound high, bool reversed) {
        if (ended_) return;
        const bound from = reversed ? (high == 0 ? 0 : 1 / high) : low;
        const bound to = reversed ? (low == 0 ? std::numeric_limits<bound>::infinity() : 1 / low) : high;
        const int sign = common_sign(b);
        const bool smallest = high - low <= 0x1p-44L * high;
        if (sign != 0 || smallest || all_open(b) || ++cells_ > how_.most_cells) return take(sign, from, to);
        std::vector<ball> left, right;  // de Casteljau's scheme
        for (std::size_t level = b.size(); level > 0; --level) {
            left.push_back(b.front());
            right.push_back(b[level - 1]);
            for (std::size_t i = 0; i + 1 < level; ++i) b[i] = (b[i] + b[i + 1]).scaled(-1);
        }
        std::reverse(right.begin(), right.end());
        const bound middle = (low + high) / 2;
        if (reversed) {
            cell(std::move(right), middle, high, reversed);
            cell(std::move(left), low, middle, reversed);
        } else {
            cell(std::move(left), low, middle, reversed);
            cell(std::move(right), middle, high, reversed);
        }
    }
    std::vector<sign_piece> pieces() && { return std::move(pieces_); }

  private:
    void take(int sign, bound from, bound to) {
        if (!pieces_.empty() && pieces_.back().sign == sign)
            pieces_.back().to = to;
        else
            pieces_.push_back({sign, from, to});
        ended_ = (how_.to_first_negative && sign < 0) || (how_.until >= 0 && to > how_.until);
    }

    sign_search how_;
    std::vector<sign_piece> pieces_;
    int cells_ = 0;
    bool ended_ = false;
};

}  // namespace detail

STAGECRAFT_INLINE std::vector<sign_piece> signs_on_half_line(std::vector<tableaux::ball> p,
                                                             const sign_search& how) {
    while (!p.empty() && p.back().exactly_zero()) p.pop_back();
    const auto first = std::find_if(p.begin(), p.end(), [](const auto& x) { return !x.exactly_zero(); });
    p.erase(p.begin(), first);  // a power of the variable, which is positive
    if (p.empty()) return {{0, 0, std::numeric_limits<tableaux::bound>::infinity()}};
    detail::sign_walk walk(how);
    walk.cell(detail::bernstein(p), 0, 1, false);
    std::reverse(p.begin(), p.end());
    walk.cell(detail::bernstein(p), 0, 1, true);
    return std::move(walk).pieces();
}

STAGECRAFT_INLINE bool all_positive(const std::vector<sign_piece>& pieces) {
    return pieces.size() == 1 && pieces.front().sign > 0;
}

STAGECRAFT_INLINE const sign_piece* first_with_sign(const std::vector<sign_piece>& pieces, int sign) {
    const auto at = std::find_if(pieces.begin(), pieces.end(), [=](const auto& x) { return x.sign == sign; });
    return at == pieces.end() ? nullptr : &*at;
}

}  // namespace stagecraft::theory
