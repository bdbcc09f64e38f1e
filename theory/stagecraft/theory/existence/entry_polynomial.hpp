// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <concepts>
#include <cstddef>
#include <map>
#include <optional>
#include <stagecraft/tableaux/rational.hpp>
#include <utility>
#include <vector>

namespace stagecraft::theory {

/// A polynomial over Q in the unknown numbers of a table, written out: each product of numbers, sorted, with its factor.
/// One of more than `most_terms` terms is not written out, and says so.
class entry_polynomial {
  public:
    using product = std::vector<std::size_t>;
    static constexpr std::size_t most_terms = 4000;

    entry_polynomial() = default;
    template <std::integral I>
    explicit entry_polynomial(I n) : entry_polynomial(tableaux::rational(n)) {}
    explicit entry_polynomial(const tableaux::rational& x);
    static entry_polynomial unknown(std::size_t number);

    bool is_too_long() const { return too_long_; }
    bool is_zero() const { return !too_long_ && terms_.empty(); }
    const std::map<product, tableaux::rational>& terms() const { return terms_; }

    entry_polynomial& add(const entry_polynomial& o, const tableaux::rational& times);
    friend entry_polynomial operator+(entry_polynomial x, const entry_polynomial& y) {
        return x.add(y, tableaux::rational(1));
    }
    friend entry_polynomial operator-(entry_polynomial x, const entry_polynomial& y) {
        return x.add(y, tableaux::rational(-1));
    }
    friend entry_polynomial operator*(const entry_polynomial& x, const entry_polynomial& y);

    /// The number u and x where the polynomial is a constant times u - x.
    std::optional<std::pair<std::size_t, tableaux::rational>> root_of_one() const;

  private:
    std::map<product, tableaux::rational> terms_;
    bool too_long_ = false;
};

/// Polynomials that are linearly independent over Q, by leading products.
class independent_polynomials {
  public:
    /// What the others leave of the polynomial: zero exactly where it is a linear combination of them, unless something
    /// gets too long.
    entry_polynomial rest(entry_polynomial p) const;
    /// The same; it becomes one of them where that is not zero.
    entry_polynomial take(entry_polynomial p);

  private:
    std::map<entry_polynomial::product, entry_polynomial> by_leading_;
};

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/existence/entry_polynomial-inl.hpp"
#endif
