// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <concepts>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
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
    multinomial(const rational& q) {                // NOLINT: so are rationals
        if (q != 0) terms_[{}] = q;
    }
    template <std::floating_point F>
    multinomial(F) = delete;
    /// The unknown x_i, i >= 0.
    static multinomial unknown(int i) {
        monomial m(static_cast<std::size_t>(i) + 1, 0);
        m.back() = 1;
        multinomial p;
        p.terms_[std::move(m)] = 1;
        return p;
    }

    const std::map<monomial, rational>& terms() const { return terms_; }
    bool is_zero() const { return terms_.empty(); }
    rational constant() const { return coefficient({}); }
    /// The coefficient of a monomial without trailing zeros.
    rational coefficient(const monomial& m) const {
        const auto found = terms_.find(m);
        return found == terms_.end() ? rational(0) : found->second;
    }
    /// Total degree; -1 for the zero polynomial.
    int degree() const {
        int d = -1;
        for (const auto& [m, a] : terms_) d = std::max(d, std::accumulate(m.begin(), m.end(), 0));
        return d;
    }
    bool depends_on(int i) const {
        return std::any_of(terms_.begin(), terms_.end(),
                           [i](const auto& t) { return exponent(t.first, i) > 0; });
    }
    static int exponent(const monomial& m, int i) {
        return static_cast<std::size_t>(i) < m.size() ? m[static_cast<std::size_t>(i)] : 0;
    }

    multinomial& operator+=(const multinomial& o) {
        for (const auto& [m, a] : o.terms_) add(m, a);
        return *this;
    }
    multinomial operator-() const { return *this * multinomial(-1); }
    multinomial& operator-=(const multinomial& o) { return *this += -o; }
    multinomial& operator*=(const multinomial& o) { return *this = *this * o; }
    /// By a constant. Throws std::invalid_argument for any other divisor: f is no polynomial then.
    multinomial& operator/=(const multinomial& o) {
        if (o.degree() != 0)
            throw std::invalid_argument("multinomial: f divides by something that is not a constant");
        return *this *= multinomial(1 / o.constant());
    }
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
    multinomial derivative(int i) const {
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
    polynomial<rational> in_one_unknown(int i = 0) const {
        polynomial<rational> p;
        for (const auto& [m, a] : terms_) {
            if (std::accumulate(m.begin(), m.end(), 0) != exponent(m, i))
                throw std::invalid_argument("multinomial: more than one unknown");
            p += polynomial<rational>::monomial(exponent(m, i), a);
        }
        return p;
    }
    /// "x1^2*x3 - 1/2", unknowns counted from 1.
    std::string str() const {
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

  private:
    void add(const monomial& m, const rational& a) {
        const auto [place, fresh] = terms_.try_emplace(m, a);
        if (!fresh) place->second += a;
        if (place->second == 0) terms_.erase(place);
    }
    std::map<monomial, rational> terms_;
};

}  // namespace stagecraft::theory

template <>
struct Eigen::NumTraits<stagecraft::theory::multinomial>
    : stagecraft::tableaux::number_traits<stagecraft::theory::multinomial> {};
