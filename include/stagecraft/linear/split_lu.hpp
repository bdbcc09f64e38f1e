// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/linear/columns.hpp>
#include <stagecraft/linear/split_complex.hpp>

namespace stagecraft {

/// N numbers in place, or as many as asked for on the heap when N is dynamic (-1).
template <class T, int N>
using workspace = std::conditional_t<(N >= 0), std::array<T, (N >= 0 ? N : 0)>, std::vector<T>>;

/// f(std::integral_constant<int, 0>{}), ..., so that the loops inside f have bounds known to the compiler; a
/// plain loop where N is dynamic.
template <int N, class F>
inline void unrolled(int n, F&& f) {
    if constexpr (N >= 0) {
        [&]<int... K>(std::integer_sequence<int, K...>) { (f(std::integral_constant<int, K>{}), ...); }
        (std::make_integer_sequence<int, N>{});
    } else {
        for (int k = 0; k < n; ++k) f(k);
    }
}

/// N * N, or dynamic.
template <int N>
inline constexpr int squared = N >= 0 ? N* N : -1;

template <class T, int N>
workspace<T, N> make_workspace(int n) {
    if constexpr (N >= 0)
        return {};
    else
        return std::vector<T>(n);
}

/// LU with row pivoting of a real matrix of size N (or of run-time size, N = -1); loops over columns so that
/// the compiler vectorises them. Serves fixed sizes to about 16, and wide scalars of any size.
template <class Scalar, int N>
class split_lu {
  public:
    explicit split_lu(int n)
        : n_(n), a_(make_workspace<Scalar, squared<N>>(n * n)), p_(make_workspace<int, N>(n)) {}

    Scalar* entries() { return a_.data(); }

    bool factor() {
        using std::abs;
        const int n = size();
        Scalar* a = a_.data();
        negative_ = false;
        for (int k = 0; k < n; ++k) {
            Scalar* ak = a + k * n;
            int p = k;
            Scalar largest = abs(ak[k]);
            for (int i = k + 1; i < n; ++i)
                if (abs(ak[i]) > largest) largest = abs(ak[i]), p = i;
            if (!usable_pivot(largest)) return false;
            p_[k] = p;
            if (p != k)
                for (int j = 0; j < n; ++j) std::swap(a[k + j * n], a[p + j * n]);
            negative_ ^= (p != k) ^ (ak[k] < Scalar(0));
            ak[k] = Scalar(1) / ak[k];
            const Scalar r = ak[k];
            for (int i = k + 1; i < n; ++i) ak[i] *= r;
            for (int j = k + 1; j < n; ++j) {
                Scalar* aj = a + j * n;
                const Scalar m = aj[k];
                subtract(aj, ak, m, k + 1, n);
            }
        }
        return true;
    }

    /// Sign of the determinant of the matrix last factored.
    bool negative_determinant() const { return negative_; }
    /// |u_kk| of the triangular factor.
    Scalar pivot(int k) const {
        using std::abs;
        return Scalar(1) / abs(a_[k + k * size()]);
    }

    void solve(Scalar* x) const {
        const int n = size();
        const Scalar* a = a_.data();
        for (int k = 0; k < n; ++k)
            if (p_[k] != k) std::swap(x[k], x[p_[k]]);
        unrolled<N>(n, [&](auto k) {
            const Scalar m = x[k];
            subtract(x, a + k * n, m, k + 1, n);
        });
        unrolled<N>(n, [&](auto step) {
            const int k = n - 1 - step;
            const Scalar m = x[k] * a[k + k * n];
            x[k] = m;
            subtract(x, a + k * n, m, 0, k);
        });
    }

  private:
    /// Subtracts m a from x, from entry first to last - 1: in packets where the size is known at run time only, which
    /// g++ makes of the loop at -O3 alone.
    static void subtract(Scalar* x, const Scalar* a, const Scalar& m, int first, int last) {
        if constexpr (N < 0 && built_in<Scalar>) {
            const real_column<Scalar> column{const_cast<Scalar*>(a)};
            real_column<Scalar>{x}.subtract(first, last, &column, &m, std::integer_sequence<int, 0>());
        } else {
            for (int i = first; i < last; ++i) x[i] -= a[i] * m;
        }
    }
    int size() const {
        if constexpr (N >= 0)
            return N;
        else
            return n_;
    }
    int n_;
    workspace<Scalar, squared<N>> a_;
    workspace<int, N> p_;
    bool negative_ = false;
};

/// The same for a complex matrix kept as real and imaginary part.
template <class Scalar, int N>
class split_complex_lu {
  public:
    explicit split_complex_lu(int n)
        : n_(n),
          re_(make_workspace<Scalar, squared<N>>(n * n)),
          im_(make_workspace<Scalar, squared<N>>(n * n)),
          p_(make_workspace<int, N>(n)) {}

    Scalar* real_entries() { return re_.data(); }
    Scalar* imaginary_entries() { return im_.data(); }

    bool factor() {
        using std::abs;
        const int n = size();
        Scalar *re = re_.data(), *im = im_.data();
        for (int k = 0; k < n; ++k) {
            Scalar *rk = re + k * n, *ik = im + k * n;
            int p = k;
            Scalar largest = abs(rk[k]) + abs(ik[k]);
            for (int i = k + 1; i < n; ++i) {
                const Scalar candidate = abs(rk[i]) + abs(ik[i]);
                if (candidate > largest) largest = candidate, p = i;
            }
            if (!usable_pivot(largest)) return false;
            p_[k] = p;
            if (p != k)
                for (int j = 0; j < n; ++j) {
                    std::swap(re[k + j * n], re[p + j * n]);
                    std::swap(im[k + j * n], im[p + j * n]);
                }
            Scalar r, s;
            reciprocal(rk[k], ik[k], r, s);
            rk[k] = r;
            ik[k] = s;
            for (int i = k + 1; i < n; ++i) {
                const Scalar x = rk[i], y = ik[i];
                rk[i] = x * r - y * s;
                ik[i] = x * s + y * r;
            }
            for (int j = k + 1; j < n; ++j) {
                Scalar *rj = re + j * n, *ij = im + j * n;
                const Scalar x = rj[k], y = ij[k];
                for (int i = k + 1; i < n; ++i) {
                    rj[i] -= rk[i] * x - ik[i] * y;
                    ij[i] -= rk[i] * y + ik[i] * x;
                }
            }
        }
        return true;
    }

    void solve(Scalar* x, Scalar* y) const {
        const int n = size();
        const Scalar *re = re_.data(), *im = im_.data();
        for (int k = 0; k < n; ++k)
            if (p_[k] != k) {
                std::swap(x[k], x[p_[k]]);
                std::swap(y[k], y[p_[k]]);
            }
        unrolled<N>(n, [&](auto k) {
            const Scalar r = x[k], s = y[k];
            for (int i = k + 1; i < n; ++i) {
                x[i] -= re[i + k * n] * r - im[i + k * n] * s;
                y[i] -= re[i + k * n] * s + im[i + k * n] * r;
            }
        });
        unrolled<N>(n, [&](auto step) {
            const int k = n - 1 - step;
            const Scalar r = x[k] * re[k + k * n] - y[k] * im[k + k * n];
            const Scalar s = x[k] * im[k + k * n] + y[k] * re[k + k * n];
            x[k] = r;
            y[k] = s;
            for (int i = 0; i < k; ++i) {
                x[i] -= re[i + k * n] * r - im[i + k * n] * s;
                y[i] -= re[i + k * n] * s + im[i + k * n] * r;
            }
        });
    }

  private:
    int size() const {
        if constexpr (N >= 0)
            return N;
        else
            return n_;
    }
    int n_;
    workspace<Scalar, squared<N>> re_, im_;
    workspace<int, N> p_;
};

}  // namespace stagecraft
