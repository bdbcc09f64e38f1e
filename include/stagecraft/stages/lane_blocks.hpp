// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cmath>

#include <stagecraft/linear/lane_lu.hpp>
#include <stagecraft/linear/mass.hpp>

namespace stagecraft::detail {

/// The systems of a step as lanes of one factorisation, the real one (odd number of stages) in lane 0 with
/// imaginary part zero; the number of lanes is even, those left over repeat lane 0. Same members as
/// separate_blocks.
///
/// With Positions = m > 0 the first m equations are q' = v, v being the next m components: q is eliminated
/// from shift q - v = r_q, so that matrices of size N - m are factored, shift M_22 - J_22 - J_21 / shift (in
/// the columns of v).
template <class Scalar, int N, int Stages, int Positions = 0>
class lane_blocks {
    static constexpr int real = Stages % 2, used = real + Stages / 2, lanes = used + used % 2;
    static constexpr int m = Positions, R = N - m;
    using lu_type = lane_lu<Scalar, R, lanes>;
    using pack = typename lu_type::pack;

  public:
    lane_blocks(int, int, int) {}

    template <class System>
    bool factor(const System& system, const Scalar* shift) {
        const auto& J = system.jacobian();
        pack re, im;
        for (int l = 0; l < lanes; ++l) {
            const int k = l >= used ? 0 : l < real ? l : 2 * l - real;
            re[l] = shift[k];
            im[l] = l < real || (l >= used && real == 1) ? Scalar(0) : shift[k + 1];
        }
        for (int j = 0; j < R; ++j)
            for (int i = 0; i < R; ++i) {
                lu_.real(i, j) = pack::all(-J(m + i, m + j));
                lu_.imaginary(i, j) = pack::all(Scalar(0));
            }
        if constexpr (System::mass_type::identity) {
            for (int i = 0; i < R; ++i) {
                lu_.real(i, i) += re;
                lu_.imaginary(i, i) += im;
            }
        } else {
            for (const auto& e : system.mass().entries()) {
                if (e.row < m) continue;
                lu_.real(e.row - m, e.column - m) += e.value * re;
                lu_.imaginary(e.row - m, e.column - m) += e.value * im;
            }
        }
        if constexpr (m > 0) {
            for (int l = 0; l < lanes; ++l) reciprocal(re[l], im[l], inverse_re_[l], inverse_im_[l]);
            for (int j = 0; j < m; ++j)
                for (int i = 0; i < R; ++i) {
                    coupling_[i + j * R] = J(m + i, j);
                    lu_.real(i, j) -= J(m + i, j) * inverse_re_;
                    lu_.imaginary(i, j) -= J(m + i, j) * inverse_im_;
                }
        }
        return lu_.factor();
    }

    static constexpr bool inexact = false;
    template <class System>
    void solve(const System&, Scalar* x) {
        std::array<Scalar, N> zero{};
        std::array<Scalar*, lanes> re, im;
        for (int l = 0; l < used; ++l) {
            re[l] = x + N * (l < real ? l : 2 * l - real);
            im[l] = l < real ? zero.data() : re[l] + N;
            eliminate(re[l], im[l], l);
            re[l] += m;
            im[l] += m;
        }
        lu_.solve(re, im, used);
        for (int l = 0; l < used; ++l) recover(re[l] - m, im[l] - m, l);
    }

    template <class System, class Vector>
    void solve_first(const System&, Vector& x, Vector& y) {
        if constexpr (real == 1) y.setZero();
        eliminate(x.data(), y.data(), 0);
        if constexpr (real == 1) {
            lu_.solve_real(x.data() + m);
        } else {
            lu_.solve(std::array<Scalar*, 1>{x.data() + m}, std::array<Scalar*, 1>{y.data() + m}, 1);
        }
        recover(x.data(), y.data(), 0);
    }

    template <class System, class Vector>
    void filter(const System& system, Vector& x, Vector& scratch) {
        scratch.setZero();
        solve_first(system, x, scratch);
        if constexpr (real == 0) {
            for (int i = 0; i < N; ++i) x[i] = modulus(x[i], scratch[i]);
        }
    }

    static constexpr bool knows_determinant = true;
    /// Sign of det(gamma/h M - J), 0 where no eigenvalue of A^-1 is real.
    int determinant_sign() {
        if constexpr (real == 0) return 0;
        bool negative = lu_.negative_determinant();
        if constexpr (m % 2 == 1) negative ^= inverse_re_[0] < Scalar(0);
        return negative ? -1 : 1;
    }

  private:
    /// q := r_q / shift, and J_21 q joins the other right-hand sides.
    void eliminate(Scalar* x, Scalar* y, int lane) const {
        if constexpr (m > 0) {
            const Scalar a = inverse_re_[lane], b = inverse_im_[lane];
            for (int j = 0; j < m; ++j) {
                const Scalar r = x[j] * a - y[j] * b, s = x[j] * b + y[j] * a;
                x[j] = r;
                y[j] = s;
                for (int i = 0; i < R; ++i) {
                    x[m + i] += coupling_[i + j * R] * r;
                    y[m + i] += coupling_[i + j * R] * s;
                }
            }
        }
    }
    /// q += v / shift.
    void recover(Scalar* x, Scalar* y, int lane) const {
        if constexpr (m > 0) {
            const Scalar a = inverse_re_[lane], b = inverse_im_[lane];
            for (int j = 0; j < m; ++j) {
                const Scalar v = x[m + j], w = y[m + j];
                x[j] += v * a - w * b;
                y[j] += v * b + w * a;
            }
        }
    }

    lu_type lu_;
    std::array<Scalar, static_cast<std::size_t>(R* m)> coupling_;
    pack inverse_re_, inverse_im_;
};

}  // namespace stagecraft::detail
