// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cmath>
#include <utility>

#include <stagecraft/linear/packet.hpp>
#include <stagecraft/linear/split_lu.hpp>

namespace stagecraft {

/// LU of several complex matrices of one small fixed size at once, matrix l in lane l of every number, so
/// that the arithmetic is vectorised over matrices: at n = 3 or 8 the loops within one matrix are too short
/// for that, and their dependent steps leave the processor waiting. Each lane pivots for itself (its rows are
/// exchanged in its own lane). The blocks of a step, one per pair of eigenvalues and the real one, are such
/// matrices. (Flattened: a pack is two or four numbers, and a call for each sum of two takes longer than the
/// sum.)
template <class Scalar, int N, int Lanes>
class lane_lu {
  public:
    using pack = number_per_lane<Scalar, Lanes>;

    pack& real(int i, int j) { return re_[i + j * N]; }
    pack& imaginary(int i, int j) { return im_[i + j * N]; }

    /// False if the matrix in one of the lanes is singular or not finite.
    [[gnu::flatten]] bool factor() {
        for (int l = 0; l < Lanes; ++l)
            for (int i = 0; i < N; ++i) from_[i][l] = i;
        bool good = true;
        negative_ = false;
        // Beyond 8 a loop takes no longer than N copies of its body, which take most of a second to compile.
        unrolled<(N <= 8 ? N : -1)>(N, [&](auto step) {
            const int k = step;
            pack size = re_[k + k * N].abs() + im_[k + k * N].abs();
            if (k + 1 < N) {
                std::array<int, Lanes> pivot;
                pivot.fill(k);
                for (int i = k + 1; i < N; ++i) {
                    const pack candidate = re_[i + k * N].abs() + im_[i + k * N].abs();
                    for (int l = 0; l < Lanes; ++l)
                        if (candidate[l] > size[l]) size[l] = candidate[l], pivot[l] = i;
                }
                for (int l = 0; l < Lanes; ++l)
                    if (pivot[l] != k) exchange(k, pivot[l], l);
                negative_ ^= pivot[0] != k;
            }
            negative_ ^= re_[k + k * N][0] < Scalar(0);
            for (int l = 0; l < Lanes; ++l) good = good && usable_pivot(size[l]);
            // 1/(x + i y), scaled by |x| + |y| so that squares neither overflow nor vanish.
            const pack scale = pack::all(Scalar(1)) / size;
            const pack x = re_[k + k * N] * scale, y = im_[k + k * N] * scale;
            const pack d = scale / (x * x + y * y);
            const pack r = x * d, s = Scalar(-1) * y * d;
            re_[k + k * N] = r;
            im_[k + k * N] = s;
            for (int i = k + 1; i < N; ++i) {
                const pack a = re_[i + k * N], b = im_[i + k * N];
                re_[i + k * N] = a * r - b * s;
                im_[i + k * N] = a * s + b * r;
            }
            for (int j = k + 1; j < N; ++j) {
                const pack a = re_[k + j * N], b = im_[k + j * N];
                for (int i = k + 1; i < N; ++i) {
                    re_[i + j * N] -= re_[i + k * N] * a - im_[i + k * N] * b;
                    im_[i + j * N] -= re_[i + k * N] * b + im_[i + k * N] * a;
                }
            }
        });
        return good;
    }

    /// Solves in all lanes; lane l takes its right-hand side from re[l], im[l] (n numbers each) and leaves
    /// the solution there, for l < used.
    template <class Pointers>
    [[gnu::flatten]] void solve(const Pointers& re, const Pointers& im, int used) const {
        std::array<pack, N> x, y;
        for (int l = 0; l < Lanes; ++l)
            for (int i = 0; i < N; ++i) {
                x[i][l] = l < used ? re[l][from_[i][l]] : Scalar(0);
                y[i][l] = l < used ? im[l][from_[i][l]] : Scalar(0);
            }
        substitute(
            [&](int i, int k) {
                x[i] -= re_[i + k * N] * x[k] - im_[i + k * N] * y[k];
                y[i] -= re_[i + k * N] * y[k] + im_[i + k * N] * x[k];
            },
            [&](int k) {
                const pack r = x[k] * re_[k + k * N] - y[k] * im_[k + k * N];
                y[k] = x[k] * im_[k + k * N] + y[k] * re_[k + k * N];
                x[k] = r;
            });
        for (int l = 0; l < used; ++l)
            for (int i = 0; i < N; ++i) re[l][i] = x[i][l], im[l][i] = y[i][l];
    }

    /// Sign of the determinant of the matrix of lane 0, which is real.
    bool negative_determinant() const { return negative_; }

    /// Solves with the matrix of lane 0, which is real.
    [[gnu::flatten]] void solve_real(Scalar* b) const {
        std::array<Scalar, N> x;
        for (int i = 0; i < N; ++i) x[i] = b[from_[i][0]];
        substitute([&](int i, int k) { x[i] -= re_[i + k * N][0] * x[k]; },
                   [&](int k) { x[k] *= re_[k + k * N][0]; });
        for (int i = 0; i < N; ++i) b[i] = x[i];
    }

  private:
    /// The order of a solution by L and U: subtract(i, k) for l_ik x_k or u_ik x_k from x_i, divide(k) by u_kk.
    /// Without loops where there are few; then the numbers stay in registers.
    template <class Subtract, class Divide>
    static void substitute(const Subtract& subtract, const Divide& divide) {
        if constexpr (N <= 8) {
            unrolled<N>(N, [&](auto k) { unrolled<N - 1 - k>(N, [&](auto i) { subtract(k + 1 + i, k); }); });
            unrolled<N>(N, [&](auto step) {
                constexpr int k = N - 1 - step;
                divide(k);
                unrolled<k>(N, [&](auto i) { subtract(i, k); });
            });
        } else {
            for (int k = 0; k < N; ++k)
                for (int i = k + 1; i < N; ++i) subtract(i, k);
            for (int k = N - 1; k >= 0; --k) {
                divide(k);
                for (int i = 0; i < k; ++i) subtract(i, k);
            }
        }
    }

    void exchange(int i, int k, int l) {
        for (int j = 0; j < N; ++j) {
            std::swap(re_[i + j * N][l], re_[k + j * N][l]);
            std::swap(im_[i + j * N][l], im_[k + j * N][l]);
        }
        std::swap(from_[i][l], from_[k][l]);
    }

    std::array<pack, N * N> re_, im_;
    std::array<std::array<int, Lanes>, N> from_;
    bool negative_ = false;
};

}  // namespace stagecraft
