// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <concepts>
#include <map>
#include <string>
#include <vector>

#include "stagecraft/tableaux/number_traits.hpp"
#include "stagecraft/tableaux/polynomial.hpp"
#include "stagecraft/tableaux/rational.hpp"

namespace stagecraft::theory {

using tableaux::polynomial;
using tableaux::rational;

/// A polynomial in any number of unknowns over the rationals, sparse: monomial -> coefficient != 0. What a
/// right-hand side becomes when it is evaluated at the unknowns themselves; statements on it hold everywhere.
class multinomial {
  public:
    /// Exponents of the unknowns, trailing zeros left out: {2, 0, 1} is x_0^2 x_2.
    using monomial = std::vector<int>;

    multinomial() = default;
    template <std::integral I>
    multinomial(I n) : multinomial(rational(n)) {}  // NOLINT: integers are polynomials
    multinomial(const rational& q);
    template <std::floating_point F>
    multinomial(F) = delete;
    /// The unknown x_i, i >= 0.
    static multinomial unknown(int i);

    const std::map<monomial, rational>& terms() const { return terms_; }
    bool is_zero() const { return terms_.empty(); }
    rational constant() const { return coefficient({}); }
    /// The coefficient of a monomial without trailing zeros.
    rational coefficient(const monomial& m) const;
    /// Total degree; -1 for the zero polynomial.
    int degree() const;
    bool depends_on(int i) const;
    static int exponent(const monomial& m, int i);

    multinomial& operator+=(const multinomial& o);
    multinomial operator-() const { return *this * multinomial(-1); }
    multinomial& operator-=(const multinomial& o) { return *this += -o; }
    multinomial& operator*=(const multinomial& o) { return *this = *this * o; }
    /// By a constant. Throws std::invalid_argument for any other divisor: f is no polynomial then.
    multinomial& operator/=(const multinomial& o);
    friend multinomial operator+(multinomial a, const multinomial& b) { return a += b; }
    friend multinomial operator-(multinomial a, const multinomial& b) { return a -= b; }
    friend multinomial operator/(multinomial a, const multinomial& b) { return a /= b; }
    friend multinomial operator*(const multinomial& a, const multinomial& b) {
        multinomial p;
        for (const auto& [m, x] : a.terms_) {
            for (const auto& [n, y] : b.terms_) {
                monomial k = m.size() < n.size() ? n : m;
                const monomial& shorter = m.size() < n.size() ? m : n;
                for (std::size_t i = 0; i < shorter.size(); ++i) k[i] += shorter[i];
                p.add(k, x * y);
            }
        }
        return p;
    }
    friend bool operator==(const multinomial&, const multinomial&) = default;

    /// d/dx_i.
    multinomial derivative(int i) const;
    /// Value at x, entries of any ring X that is built from rationals.
    template <class X>
    X operator()(const std::vector<X>& x) const {
        X sum(rational(0));
        for (const auto& [m, a] : terms_) {
            X term(a);
            for (std::size_t i = 0; i < m.size(); ++i)
                for (int k = 0; k < m[i]; ++k) term = term * x[i];
            sum = sum + term;
        }
        return sum;
    }
    /// The polynomial in x_i alone. Throws std::invalid_argument where another unknown occurs.
    polynomial<rational> in_one_unknown(int i = 0) const;
    /// "x1^2*x3 - 1/2", unknowns counted from 1.
    std::string str() const;

  private:
    void add(const monomial& m, const rational& a);
    std::map<monomial, rational> terms_;
};

}  // namespace stagecraft::theory

template <>
struct Eigen::NumTraits<stagecraft::theory::multinomial>
    : stagecraft::tableaux::number_traits<stagecraft::theory::multinomial> {};

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/dynamics/multinomial-inl.hpp"
#endif
