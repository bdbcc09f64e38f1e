// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cmath>
#include <utility>

#include <stagecraft/linear/split_complex.hpp>

namespace stagecraft {

/// Explicit inverse of a real N x N matrix, N <= 4, by Gauss-Jordan with row pivoting: at this size a solve
/// is a product without the dependent divisions of a triangular one.
template <class Scalar, int N>
class small_inverse {
  public:
    explicit small_inverse(int) {}

    Scalar* entries() { return a_.data(); }  ///< the matrix to factor, column-major, overwritten by factor()

    /// False if the matrix is singular or not finite.
    bool factor() {
        using std::abs;
        std::array<int, N> from;
        negative_ = false;
        for (int k = 0; k < N; ++k) {
            int p = k;
            for (int i = k + 1; i < N; ++i)
                if (abs(a_[i + k * N]) > abs(a_[p + k * N])) p = i;
            if (!usable_pivot(Scalar(abs(a_[p + k * N])))) return false;
            from[k] = p;
            if (p != k)
                for (int j = 0; j < N; ++j) std::swap(a_[k + j * N], a_[p + j * N]);
            negative_ ^= (p != k) ^ (a_[k + k * N] < Scalar(0));
            const Scalar r = Scalar(1) / a_[k + k * N];
            a_[k + k * N] = Scalar(1);
            for (int j = 0; j < N; ++j) a_[k + j * N] *= r;
            for (int i = 0; i < N; ++i) {
                if (i == k) continue;
                const Scalar m = a_[i + k * N];
                a_[i + k * N] = Scalar(0);
                for (int j = 0; j < N; ++j) a_[i + j * N] -= m * a_[k + j * N];
            }
        }
        for (int k = N - 1; k >= 0; --k)
            if (from[k] != k)
                for (int i = 0; i < N; ++i) std::swap(a_[i + k * N], a_[i + from[k] * N]);
        return true;
    }

    /// Sign of the determinant of the matrix last factored.
    bool negative_determinant() const { return negative_; }

    void solve(Scalar* x) const {
        std::array<Scalar, N> r;
        for (int i = 0; i < N; ++i) r[i] = a_[i] * x[0];
        for (int j = 1; j < N; ++j)
            for (int i = 0; i < N; ++i) r[i] += a_[i + j * N] * x[j];
        for (int i = 0; i < N; ++i) x[i] = r[i];
    }

  private:
    std::array<Scalar, N * N> a_;
    bool negative_ = false;
};

/// The same for a complex matrix kept as real and imaginary part.
template <class Scalar, int N>
class small_complex_inverse {
  public:
    explicit small_complex_inverse(int) {}

    Scalar* real_entries() { return re_.data(); }
    Scalar* imaginary_entries() { return im_.data(); }

    bool factor() {
        using std::abs;
        std::array<int, N> from;
        for (int k = 0; k < N; ++k) {
            int p = k;
            Scalar largest = size(k + k * N);
            for (int i = k + 1; i < N; ++i) {
                const Scalar candidate = size(i + k * N);
                if (candidate > largest) largest = candidate, p = i;
            }
            if (!usable_pivot(largest)) return false;
            from[k] = p;
            if (p != k)
                for (int j = 0; j < N; ++j) {
                    std::swap(re_[k + j * N], re_[p + j * N]);
                    std::swap(im_[k + j * N], im_[p + j * N]);
                }
            Scalar rr, ri;
            reciprocal(re_[k + k * N], im_[k + k * N], rr, ri);
            re_[k + k * N] = Scalar(1);
            im_[k + k * N] = Scalar(0);
            for (int j = 0; j < N; ++j) {
                const Scalar x = re_[k + j * N], y = im_[k + j * N];
                re_[k + j * N] = x * rr - y * ri;
                im_[k + j * N] = x * ri + y * rr;
            }
            for (int i = 0; i < N; ++i) {
                if (i == k) continue;
                const Scalar mr = re_[i + k * N], mi = im_[i + k * N];
                re_[i + k * N] = Scalar(0);
                im_[i + k * N] = Scalar(0);
                for (int j = 0; j < N; ++j) {
                    const Scalar x = re_[k + j * N], y = im_[k + j * N];
                    re_[i + j * N] -= mr * x - mi * y;
                    im_[i + j * N] -= mr * y + mi * x;
                }
            }
        }
        for (int k = N - 1; k >= 0; --k)
            if (from[k] != k)
                for (int i = 0; i < N; ++i) {
                    std::swap(re_[i + k * N], re_[i + from[k] * N]);
                    std::swap(im_[i + k * N], im_[i + from[k] * N]);
                }
        return true;
    }

    void solve(Scalar* x, Scalar* y) const {
        std::array<Scalar, N> r, s;
        for (int i = 0; i < N; ++i) {
            r[i] = re_[i] * x[0] - im_[i] * y[0];
            s[i] = re_[i] * y[0] + im_[i] * x[0];
        }
        for (int j = 1; j < N; ++j)
            for (int i = 0; i < N; ++i) {
                r[i] += re_[i + j * N] * x[j] - im_[i + j * N] * y[j];
                s[i] += re_[i + j * N] * y[j] + im_[i + j * N] * x[j];
            }
        for (int i = 0; i < N; ++i) x[i] = r[i], y[i] = s[i];
    }

  private:
    Scalar size(int k) const {
        using std::abs;
        return abs(re_[k]) + abs(im_[k]);
    }
    std::array<Scalar, N * N> re_, im_;
};

}  // namespace stagecraft
