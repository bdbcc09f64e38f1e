// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableau.hpp>
#include <stagecraft/theory/models/stage_algebra.hpp>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace stagecraft::theory {

/// The stage algebra of a tableau as it stands: stage vectors are s numbers, the product is pointwise, A is a
/// matrix. K is any commutative ring (double, wide floats, enclosures, exact fields). With `Stages` fixed
/// everything is `constexpr` and lives in arrays; otherwise in std::vector.
/// Rows are s numbers too.
template <class K, int Stages = dynamic>
class matrix_model {
    static constexpr bool fixed = Stages != dynamic;
    template <std::size_t N>
    using storage = std::conditional_t<fixed, std::array<K, N>, std::vector<K>>;
    static constexpr std::size_t size_hint = fixed ? static_cast<std::size_t>(Stages) : 1;

  public:
    using scalar = K;
    using element = storage<size_hint>;

    /// From rows of A, weights and nodes; `constexpr`, for proofs by static_assert.
    constexpr matrix_model(const std::array<std::array<K, size_hint>, size_hint>& rows,
                           const std::array<K, size_hint>& b,
                           const std::array<K, size_hint>& c) requires(Stages != dynamic)
        : b_(b), c_(c) {
        for (std::size_t i = 0; i < size_hint; ++i)
            for (std::size_t j = 0; j < size_hint; ++j) A_[j * size_hint + i] = rows[i][j];
        bA_ = apply_transposed(b_);
    }

    /// From a tableau. Throws std::invalid_argument when A, b and c do not fit together.
    explicit matrix_model(const tableau<K, Stages>& t) : matrix_model(t, t.b) {}

    /// From a tableau with other weights than its b, e.g. its embedded ones. Throws std::invalid_argument
    /// when A, c and `weights` do not fit together.
    template <class Weights>
    matrix_model(const tableau<K, Stages>& t, const Weights& weights) {
        const auto s = weights.size();
        if (s < 1) throw std::invalid_argument("weights: a method needs at least one stage");
        if (t.A.rows() != s || t.A.cols() != s)
            throw std::invalid_argument("A: has " + std::to_string(t.A.rows()) + " rows and " +
                                        std::to_string(t.A.cols()) + " columns, but there are " +
                                        std::to_string(s) + " weights");
        if (t.c.size() != s)
            throw std::invalid_argument("c: has " + std::to_string(t.c.size()) + " entries, but there are " +
                                        std::to_string(s) + " weights");
        if constexpr (!fixed) {
            A_.resize(static_cast<std::size_t>(s * s));
            b_.resize(static_cast<std::size_t>(s));
            c_.resize(static_cast<std::size_t>(s));
        }
        for (int i = 0; i < s; ++i) {
            b_[i] = weights(i);
            c_[i] = t.c(i);
            for (int j = 0; j < s; ++j) A_[j * s + i] = t.A(i, j);
        }
        bA_ = apply_transposed(b_);
    }

    constexpr int stages() const { return static_cast<int>(b_.size()); }
    constexpr element one() const {
        element r = zero();
        for (K& x : r) x = K(1);
        return r;
    }
    constexpr const element& c() const { return c_; }
    constexpr element multiply(element u, const element& v) const {
        for (std::size_t i = 0; i < u.size(); ++i) u[i] *= v[i];
        return u;
    }
    /// A v.
    constexpr element apply(const element& v) const {
        const std::size_t s = v.size();
        element r = zero();
        for (std::size_t i = 0; i < s; ++i) r[i] = A_[i] * v[0];
        for (std::size_t j = 1; j < s; ++j)  // by columns: the inner loop runs over contiguous rows
            for (std::size_t i = 0; i < s; ++i) r[i] += A_[j * s + i] * v[j];
        return r;
    }
    constexpr K dot_b(const element& v) const { return pair(b_, v); }
    constexpr K dot_b_apply(const element& v) const { return pair(bA_, v); }
    constexpr K inner(const element& u, const element& v) const {
        K r = b_[0] * u[0] * v[0];
        for (std::size_t i = 1; i < u.size(); ++i) r += b_[i] * u[i] * v[i];
        return r;
    }

    /// The row b^T; the row u -> f^T (v u); A^T f; f^T v; the value in the last stage.
    constexpr const element& weights() const { return b_; }
    constexpr element weigh(element f, const element& v) const { return multiply(std::move(f), v); }
    constexpr element apply_transposed(const element& f) const {
        const std::size_t s = f.size();
        element r = zero();
        for (std::size_t j = 0; j < s; ++j) {
            r[j] = A_[j * s] * f[0];
            for (std::size_t i = 1; i < s; ++i) r[j] += A_[j * s + i] * f[i];
        }
        return r;
    }
    constexpr K pair(const element& f, const element& v) const {
        K r = f[0] * v[0];
        for (std::size_t i = 1; i < v.size(); ++i) r += f[i] * v[i];
        return r;
    }
    constexpr K at_last(const element& v) const { return v[v.size() - 1]; }
    /// The stages in reverse order, so that c_i and c_{s+1-i} change places.
    constexpr element reflect(const element& v) const {
        element r = v;
        for (std::size_t i = 0; i < v.size(); ++i) r[i] = v[v.size() - 1 - i];
        return r;
    }

  private:
    constexpr element zero() const {
        if constexpr (fixed) {
            element r{};
            for (K& x : r) x = K(0);
            return r;
        } else {
            return element(b_.size());  // value-initialised: zeros
        }
    }

    storage<size_hint * size_hint> A_{};  // by columns
    element b_{};
    element c_{};
    element bA_{};
};

template <class K, int Stages>
matrix_model(const tableau<K, Stages>&) -> matrix_model<K, Stages>;
template <class K, int Stages, class Weights>
matrix_model(const tableau<K, Stages>&, const Weights&) -> matrix_model<K, Stages>;
template <class K, std::size_t S>
matrix_model(const std::array<std::array<K, S>, S>&, const std::array<K, S>&, const std::array<K, S>&)
    -> matrix_model<K, static_cast<int>(S)>;

}  // namespace stagecraft::theory
