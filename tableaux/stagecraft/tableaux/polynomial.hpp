// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace stagecraft::tableaux {

/// A polynomial a_0 + a_1 x + ... over a field K, coefficients ascending, no trailing zeros (the zero
/// polynomial has none). A regular value; `constexpr` for class types K with constexpr arithmetic. K needs
/// construction from int, + - * / and ==; where signs are asked for, <.
/// (Constant evaluation by g++ 12 destroys class values chosen by ?: twice: such choices are written with
/// if.)
template <class K>
class polynomial {
  public:
    using scalar = K;

    constexpr polynomial() = default;
    /// The constant polynomial.
    constexpr polynomial(K constant) : a_{std::move(constant)} {
        trim();
    }  // NOLINT: constants are polynomials
    constexpr polynomial(std::initializer_list<K> ascending) : a_(ascending) { trim(); }
    constexpr explicit polynomial(std::vector<K> ascending) : a_(std::move(ascending)) { trim(); }

    /// The polynomial a x^n.
    static constexpr polynomial monomial(int n, const K& a = K(1)) {
        std::vector<K> v(static_cast<std::size_t>(n) + 1, K(0));
        v.back() = a;
        return polynomial(std::move(v));
    }
    /// The polynomial x.
    static constexpr polynomial x() { return monomial(1); }

    /// Degree; -1 for the zero polynomial.
    constexpr int degree() const { return static_cast<int>(a_.size()) - 1; }
    constexpr bool is_zero() const { return a_.empty(); }
    /// Coefficient of x^k, zero beyond the degree.
    constexpr K operator[](int k) const {
        return k >= 0 && k <= degree() ? a_[static_cast<std::size_t>(k)] : K(0);
    }
    /// Leading coefficient. Throws std::domain_error for the zero polynomial.
    constexpr const K& leading() const {
        if (a_.empty()) throw std::domain_error("polynomial: the zero polynomial has no leading coefficient");
        return a_.back();
    }
    constexpr const std::vector<K>& coefficients() const { return a_; }

    /// Value at x by Horner's rule; X may be any ring that multiplies with itself and is built from K.
    template <class X>
    constexpr X operator()(const X& x) const {
        X value = X(K(0));
        for (auto k = a_.size(); k-- > 0;) value = value * x + X(a_[k]);
        return value;
    }

    constexpr polynomial operator-() const {
        std::vector<K> v;
        v.reserve(a_.size());
        for (const K& a : a_) v.push_back(K(0) - a);
        return polynomial(std::move(v));
    }
    constexpr polynomial& operator+=(const polynomial& o) {
        if (a_.size() < o.a_.size()) a_.resize(o.a_.size(), K(0));
        for (std::size_t k = 0; k < o.a_.size(); ++k) a_[k] = a_[k] + o.a_[k];
        trim();
        return *this;
    }
    constexpr polynomial& operator-=(const polynomial& o) { return *this += -o; }
    constexpr polynomial& operator*=(const polynomial& o) { return *this = *this * o; }

    friend constexpr polynomial operator+(polynomial a, const polynomial& b) { return a += b; }
    friend constexpr polynomial operator-(polynomial a, const polynomial& b) { return a -= b; }
    friend constexpr polynomial operator*(const polynomial& a, const polynomial& b) {
        if (a.is_zero() || b.is_zero()) return {};
        std::vector<K> v(a.a_.size() + b.a_.size() - 1, K(0));
        for (std::size_t i = 0; i < a.a_.size(); ++i) {
            for (std::size_t j = 0; j < b.a_.size(); ++j) v[i + j] = v[i + j] + a.a_[i] * b.a_[j];
        }
        return polynomial(std::move(v));
    }
    friend constexpr bool operator==(const polynomial& a, const polynomial& b) {
        if (a.a_.size() != b.a_.size()) return false;
        for (std::size_t k = 0; k < a.a_.size(); ++k) {
            if (!(a.a_[k] == b.a_[k])) return false;
        }
        return true;
    }

  private:
    constexpr void trim() {
        while (!a_.empty() && a_.back() == K(0)) a_.pop_back();
    }
    std::vector<K> a_;
};

/// Quotient and remainder: a = q b + r with deg r < deg b. Throws std::domain_error for b = 0.
template <class K>
constexpr std::pair<polynomial<K>, polynomial<K>> divmod(const polynomial<K>& a, const polynomial<K>& b) {
    if (b.is_zero()) throw std::domain_error("divmod: division by the zero polynomial");
    std::vector<K> r = a.coefficients();
    const int n = b.degree();
    std::vector<K> q;
    if (a.degree() >= n) {
        q.resize(static_cast<std::size_t>(a.degree() - n) + 1, K(0));
        for (int k = a.degree() - n; k >= 0; --k) {
            const K f = r[static_cast<std::size_t>(k + n)] / b.leading();
            q[static_cast<std::size_t>(k)] = f;
            for (int j = 0; j <= n; ++j) {
                auto& entry = r[static_cast<std::size_t>(k + j)];
                entry = entry - f * b.coefficients()[static_cast<std::size_t>(j)];
            }
        }
        r.resize(static_cast<std::size_t>(n), K(0));
    }
    return {polynomial<K>(std::move(q)), polynomial<K>(std::move(r))};
}
template <class K>
constexpr polynomial<K> operator/(const polynomial<K>& a, const polynomial<K>& b) {
    return divmod(a, b).first;
}
template <class K>
constexpr polynomial<K> operator%(const polynomial<K>& a, const polynomial<K>& b) {
    return divmod(a, b).second;
}

/// p divided by its leading coefficient; zero stays zero.
template <class K>
constexpr polynomial<K> monic(const polynomial<K>& p) {
    if (p.is_zero()) return p;
    return p * polynomial<K>(K(1) / p.leading());
}

/// Monic greatest common divisor; gcd(0, 0) = 0.
template <class K>
constexpr polynomial<K> gcd(polynomial<K> a, polynomial<K> b) {
    while (!b.is_zero()) {
        auto r = monic(a % b);
        a = std::move(b);
        b = std::move(r);
    }
    return monic(a);
}

template <class K>
constexpr polynomial<K> derivative(const polynomial<K>& p) {
    std::vector<K> v;
    for (int k = 1; k <= p.degree(); ++k) v.push_back(K(k) * p[k]);
    return polynomial<K>(std::move(v));
}

/// The antiderivative that vanishes at 0.
template <class K>
constexpr polynomial<K> integral(const polynomial<K>& p) {
    if (p.is_zero()) return p;
    std::vector<K> v(1, K(0));
    for (int k = 0; k <= p.degree(); ++k) v.push_back(p[k] / K(k + 1));
    return polynomial<K>(std::move(v));
}

/// p(q(x)).
template <class K>
constexpr polynomial<K> compose(const polynomial<K>& p, const polynomial<K>& q) {
    polynomial<K> value;
    for (int k = p.degree(); k >= 0; --k) value = value * q + polynomial<K>(p[k]);
    return value;
}

/// p(-x).
template <class K>
constexpr polynomial<K> reflected(const polynomial<K>& p) {
    std::vector<K> v = p.coefficients();
    for (std::size_t k = 1; k < v.size(); k += 2) v[k] = K(0) - v[k];
    return polynomial<K>(std::move(v));
}

template <class K>
constexpr polynomial<K> power(const polynomial<K>& p, int n) {
    polynomial<K> value(K(1));
    for (int k = 0; k < n; ++k) value *= p;
    return value;
}

/// A monic squarefree factor and how often it divides.
template <class K>
struct squarefree_factor {
    polynomial<K> factor;
    int multiplicity = 0;
};

/// Yun's squarefree split (characteristic 0): p = leading * prod factor^multiplicity, the factors monic,
/// squarefree, coprime, of positive degree, multiplicities increasing. Throws std::domain_error for p = 0.
template <class K>
constexpr std::vector<squarefree_factor<K>> squarefree_split(const polynomial<K>& p) {
    if (p.is_zero()) throw std::domain_error("squarefree_split: the zero polynomial has no split");
    std::vector<squarefree_factor<K>> split;
    auto common = gcd(p, derivative(p));
    auto b = monic(p / common);
    auto d = derivative(p) * polynomial<K>(K(1) / p.leading()) / common - derivative(b);
    for (int multiplicity = 1; b.degree() > 0; ++multiplicity) {
        auto factor = gcd(b, d);
        b = b / factor;
        d = d / factor - derivative(b);
        if (factor.degree() > 0) split.push_back({std::move(factor), multiplicity});
    }
    return split;
}

/// The monic polynomial with the roots of p, each once: p / gcd(p, p').
template <class K>
constexpr polynomial<K> squarefree(const polynomial<K>& p) {
    if (p.degree() < 1) return monic(p);
    return monic(p / gcd(p, derivative(p)));
}

/// As text, highest power first: "x^2 - 1/2*x + 3". K needs `str()` or std::to_string.
template <class K>
std::string to_string(const polynomial<K>& p, const std::string& variable = "x") {
    const auto text = [](const K& a) {
        if constexpr (requires { a.str(); }) {
            return a.str();
        } else {
            return std::to_string(a);
        }
    };
    if (p.is_zero()) return "0";
    std::string out;
    for (int k = p.degree(); k >= 0; --k) {
        if (p[k] == K(0)) continue;
        std::string a = text(p[k]);
        const bool sum = a.find_first_of("+-", 1) != std::string::npos;  // a + b*sqrt(d)
        const bool negative = !sum && a[0] == '-';
        if (negative) a.erase(0, 1);
        out += out.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
        const std::string power = k == 0 ? "" : k == 1 ? variable : variable + "^" + std::to_string(k);
        if (sum) a = "(" + a + ")";
        out += k > 0 && a == "1" ? power : k == 0 ? a : a + "*" + power;
    }
    return out;
}

}  // namespace stagecraft::tableaux
