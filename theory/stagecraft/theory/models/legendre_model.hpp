// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "stagecraft/tableaux/family.hpp"
#include "stagecraft/tableaux/legendre.hpp"
#include "stagecraft/tableaux/nodal.hpp"
#include "stagecraft/theory/models/band_matrix.hpp"

namespace stagecraft::theory {

/// A method on the roots of w as the ring K[x]/(w), in shifted Legendre coordinates P_0, ..., P_{s-1}: exact
/// without computing a root. A model of `stage_algebra`: a stage vector is a polynomial of degree < s, its
/// product the one modulo w, A v = integral of v from 0 to x modulo w (collocation), b^T v = integral of v
/// over [0, 1] = v_0. For Gauss, Radau and Lobatto, A is tridiagonal and G diagonal, and building the model
/// takes O(s) operations. `constexpr` for class types K.
///
/// Sources: Hairer-Wanner II.IV.5 (W-transformation); Burrage 1978 for G A + A^T G - e_0 e_0^T.
template <class K>
class legendre_model {
  public:
    using scalar = K;
    using element = std::vector<K>;  ///< s coordinates in P_0, ..., P_{s-1}

    constexpr legendre_model(tableaux::family f, int s)
        : legendre_model(tableaux::nodal_legendre<K>(f, s), tableaux::construction_of(f)) {}

    /// From the Legendre coordinates w_0, ..., w_s = 1 of the nodal polynomial. Distinct real roots are the
    /// caller's claim (nodal_polynomial proves it): the ring itself does not object to repeated ones.
    /// Throws std::invalid_argument where the construction does not determine A: adjoint with a zero weight,
    /// lobatto_iiic without the node 0.
    constexpr legendre_model(std::vector<K> w, tableaux::construction rule)
        : w_(std::move(w)),
          rule_(rule),
          exactness_(leading_zeros(w_)),
          integral_(integration()),
          gram_(gram_matrix()),
          gram_integral_(gram_ * integral_) {
        if (rule == tableaux::construction::lobatto_iiic) {
            a_ = left_end_constant();
            gram_a_ = gram_ * a_;
        } else if (rule == tableaux::construction::adjoint) {
            gram_a_ = adjoint_of_integration();
            if (gram_.is_diagonal()) {  // not ?:, whose class results g++ 12 destroys twice in constexpr
                a_ = divided_by_gram();
            } else {
                a_ = solved_with_gram();
            }
        }
    }

    constexpr int stages() const { return static_cast<int>(w_.size()) - 1; }
    constexpr tableaux::construction rule() const { return rule_; }

    /// Legendre coordinates of w.
    constexpr const std::vector<K>& w() const { return w_; }
    /// How many leading Legendre coordinates of w vanish: w is orthogonal to all polynomials of lower degree,
    /// and to no more.
    constexpr int orthogonality() const { return exactness_; }
    /// Matrix of v -> integral of v from 0 to x, modulo w: A of the collocation method on the same nodes.
    constexpr const band_matrix<K>& integration_matrix() const { return integral_; }
    /// A in Legendre coordinates.
    constexpr const band_matrix<K>& A() const {
        return rule_ == tableaux::construction::collocation ? integral_ : a_;
    }
    /// Gram matrix of <u, v> = b^T(u v).
    constexpr const band_matrix<K>& gram() const { return gram_; }
    /// Matrix of <u, A v>: G A.
    constexpr const band_matrix<K>& gram_A() const {
        return rule_ == tableaux::construction::collocation ? gram_integral_ : gram_a_;
    }
    /// Matrix of <u, integral of v from 0 to x>: G times the integration matrix.
    constexpr const band_matrix<K>& gram_integration() const { return gram_integral_; }

    constexpr element one() const { return unit(0); }
    /// The nodes: x modulo w.
    constexpr element c() const { return times_x(one()); }
    constexpr element apply(const element& v) const { return A() * v; }
    constexpr K dot_b(const element& v) const { return v[0]; }
    /// b^T(u v): O(s) operations where G is diagonal.
    constexpr K inner(const element& u, const element& v) const {
        const element gv = gram_ * v;
        K sum(0);
        for (std::size_t i = 0; i < u.size(); ++i) sum += u[i] * gv[i];
        return sum;
    }
    /// u v modulo w, by the three-term recurrence of P_k(x) v. O(s^2) operations for the families, at most
    /// O(s^2) for any w.
    constexpr element multiply(const element& u, const element& v) const {
        element product(v.size(), K(0));
        element before(v.size(), K(0));
        element current = v;
        int degree = stages() - 1;
        while (degree > 0 && u[static_cast<std::size_t>(degree)] == K(0)) --degree;
        for (int k = 0;; ++k) {
            const K& f = u[static_cast<std::size_t>(k)];
            for (std::size_t i = 0; i < v.size(); ++i) product[i] += f * current[i];
            if (k == degree) return product;
            element next = times_x(current);
            for (std::size_t i = 0; i < v.size(); ++i) {
                next[i] = (K(2 * k + 1) * (K(2) * next[i] - current[i]) - K(k) * before[i]) / K(k + 1);
            }
            before = std::move(current);
            current = std::move(next);
        }
    }

    /// v_s, the value in the last stage, where that is the node 1 (P_k(1) = 1).
    /// Throws std::invalid_argument where 1 is no node: the value need not lie in K then.
    constexpr K at_last(const element& v) const {
        if (!(sum(w_) == K(0))) throw std::invalid_argument("at_last: 1 is not a node");
        return sum(v);
    }
    /// The stages in reverse order, x to 1 - x (P_k(1 - x) = (-1)^k P_k(x)).
    /// Throws std::invalid_argument where the nodes are not symmetric about 1/2.
    constexpr element reflect(element v) const {
        for (int k = stages() - 1; k >= 0; k -= 2)
            if (!(w_[at(k)] == K(0))) throw std::invalid_argument("reflect: the nodes are not symmetric");
        for (std::size_t k = 1; k < v.size(); k += 2) v[k] = -v[k];
        return v;
    }

  private:
    static constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }
    static constexpr K sum(const std::vector<K>& v) {
        K all(0);
        for (const K& x : v) all += x;
        return all;
    }
    static constexpr K fraction(int n, int d) {
        if constexpr (std::is_constructible_v<K, int, int>) {
            return K(n, d);
        } else {
            return K(n) / K(d);
        }
    }
    static constexpr int leading_zeros(const std::vector<K>& w) {
        if (w.size() < 2 || !(w.back() == K(1)))
            throw std::invalid_argument("w: degree at least 1 and leading Legendre coordinate 1 needed");
        int r = 0;
        while (w[at(r)] == K(0)) ++r;
        return r;
    }
    constexpr element unit(int k) const {
        element v(at(stages()), K(0));
        v[at(k)] = K(1);
        return v;
    }
    constexpr element times_x(const element& v) const {
        element u = tableaux::legendre_times_x(v);
        const K top = u.back();
        u.pop_back();
        for (int j = exactness_; j < stages(); ++j) u[at(j)] -= top * w_[at(j)];
        return u;
    }
    static constexpr K up(int k) { return fraction(k + 1, 2 * (2 * k + 1)); }  // of P_{k+1} in x P_k
    static constexpr K down(int k) { return fraction(k, 2 * (2 * k + 1)); }    // of P_{k-1} in x P_k

    constexpr band_matrix<K> integration() const {
        const int s = stages();
        band_matrix<K> j(s, 1, std::max(1, s - 1 - exactness_));
        for (int k = 0; k < s; ++k) {
            const K f = fraction(1, 2 * (2 * k + 1));
            if (k + 1 < s) {
                j.entry(k + 1, k) = f;
            } else {
                for (int i = exactness_; i < s; ++i) j.entry(i, k) = -(f * w_[at(i)]);
            }
            if (k > 0) j.entry(k - 1, k) -= f;
        }
        j.entry(0, 0) += fraction(1, 2);
        return j;
    }

    // Orthogonality gives the entries with i + j < s + exactness; <x u, v> = <u, x v> gives the others row by
    // row.
    constexpr band_matrix<K> gram_matrix() const {
        const int s = stages();
        const int width = std::max(0, s - 2 - exactness_);
        band_matrix<K> g(s, width, width);
        for (int i = 0; i < s; ++i) {
            if (2 * i < s + exactness_) g.entry(i, i) = fraction(1, 2 * i + 1);
            for (int j = std::max(i, s + exactness_ - i); j < s; ++j) {
                K next = g(i - 1, j - 1) * down(j);
                if (j + 1 < s) {
                    next += g(i - 1, j + 1) * up(j);
                } else {
                    for (int k = exactness_; k < s; ++k) next -= up(j) * w_[at(k)] * g(i - 1, k);
                }
                if (i > 1) next -= down(i - 1) * g(i - 2, j);
                g.entry(i, j) = next / up(i - 1);
                g.entry(j, i) = g(i, j);
            }
        }
        return g;
    }

    // D(s): <u, A v> = <integral of u from x to 1, v> = <1, u><1, v> - <integral of u from 0 to x, v>.
    constexpr band_matrix<K> adjoint_of_integration() const {
        band_matrix<K> m(stages(), gram_integral_.upper(), gram_integral_.lower());
        for (int i = 0; i < stages(); ++i)
            for (int j = gram_integral_.first_column(i); j < gram_integral_.end_column(i); ++j)
                if (!(gram_integral_.row(i)[j] == K(0))) m.entry(j, i) = -gram_integral_.row(i)[j];
        m.entry(0, 0) += K(1);
        return m;
    }

    constexpr band_matrix<K> divided_by_gram() const {
        band_matrix<K> a = gram_a_;
        for (int i = 0; i < stages(); ++i) {
            if (gram_.row(i)[i] == K(0)) throw std::invalid_argument(zero_weight);
            for (int j = a.first_column(i); j < a.end_column(i); ++j) a.entry(i, j) /= gram_.row(i)[i];
        }
        return a;
    }

    // G^{-1} G A by elimination with row exchanges, O(s^3) operations.
    constexpr band_matrix<K> solved_with_gram() const {
        const int s = stages();
        std::vector<element> rows;  // of (G | G A)
        for (int i = 0; i < s; ++i) {
            rows.emplace_back();
            for (int j = 0; j < s; ++j) rows.back().push_back(gram_(i, j));
            for (int j = 0; j < s; ++j) rows.back().push_back(gram_a_(i, j));
        }
        for (int k = 0; k < s; ++k) {
            int p = k;
            while (p < s && rows[at(p)][at(k)] == K(0)) ++p;
            if (p == s) throw std::invalid_argument(zero_weight);
            std::swap(rows[at(p)], rows[at(k)]);
            for (int i = 0; i < s; ++i) {
                if (i == k || rows[at(i)][at(k)] == K(0)) continue;
                const K f = rows[at(i)][at(k)] / rows[at(k)][at(k)];
                for (std::size_t j = at(k); j < at(2 * s); ++j) rows[at(i)][j] -= f * rows[at(k)][j];
            }
        }
        band_matrix<K> a(s, s - 1, s - 1);
        for (int i = 0; i < s; ++i)
            for (int j = 0; j < s; ++j) a.entry(i, j) = rows[at(i)][at(s + j)] / rows[at(i)][at(i)];
        return a;
    }

    // A P_k = J P_k for k < s-1 and A q = q_0 with q = w/x, which is the indicator of the node 0 up to a
    // factor.
    constexpr band_matrix<K> left_end_constant() const {
        const int s = stages();
        element q(at(s) + 2, K(0));
        for (int j = s; j > 0; --j)
            q[at(j - 1)] = (w_[at(j)] - q[at(j)] / K(2) - down(j + 1) * q[at(j + 1)]) / up(j - 1);
        if (!(q[0] / K(2) + down(1) * q[1] == w_[0]))
            throw std::invalid_argument("nodes: the construction lobatto_iiic needs the node 0");
        element last(at(s), K(0));
        last[0] = q[0];
        for (int k = 0; k + 1 < s; ++k)
            for (int i = integral_.first_row(k); i < integral_.end_row(k); ++i)
                last[at(i)] -= q[at(k)] * integral_.row(i)[k];
        int top = 0;
        while (top < s - 1 && last[at(top)] == K(0)) ++top;
        band_matrix<K> a(s, 1, std::max(1, s - 1 - top));
        for (int i = 0; i < s; ++i)
            for (int k = i > 0 ? i - 1 : 0; k < s - 1 && k <= i + 1; ++k) a.entry(i, k) = integral_.row(i)[k];
        for (int i = top; i < s; ++i) a.entry(i, s - 1) = last[at(i)] / q[at(s - 1)];
        return a;
    }

    static constexpr const char* zero_weight = "nodes: a weight is zero, so D(s) does not determine A";

    std::vector<K> w_;
    tableaux::construction rule_;
    int exactness_;
    band_matrix<K> integral_;
    band_matrix<K> gram_;
    band_matrix<K> gram_integral_;
    band_matrix<K> a_;       // empty for collocation,
    band_matrix<K> gram_a_;  // as the integration matrix is A there
};

}  // namespace stagecraft::theory
