// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cmath>

#include <stagecraft/linear/lane_lu.hpp>
#include <stagecraft/problem/mass.hpp>

namespace stagecraft {

/// The systems of a step as lanes of one factorisation, the real one (odd number of stages) in lane 0 with
/// imaginary part zero; the number of lanes is even, those left over repeat lane 0. Same members as
/// separate_blocks.
template <class Scalar, int N, int Stages>
class lane_blocks {
    static constexpr int real = Stages % 2, used = real + Stages / 2, lanes = used + used % 2;

  public:
    lane_blocks(int, int, int) {}

    template <class System>
    bool factor(const System& system, const Scalar* shift) {
        const auto& J = system.jacobian();
        using pack = typename lane_lu<Scalar, N, lanes>::pack;
        pack re, im;
        for (int l = 0; l < lanes; ++l) {
            const int k = l >= used ? 0 : l < real ? l : 2 * l - real;
            re[l] = shift[k];
            im[l] = l < real || (l >= used && real == 1) ? Scalar(0) : shift[k + 1];
        }
        for (int j = 0; j < N; ++j)
            for (int i = 0; i < N; ++i) {
                lu_.real(i, j) = pack::Constant(-J(i, j));
                lu_.imaginary(i, j) = pack::Zero();
            }
        if constexpr (System::mass_type::identity) {
            for (int i = 0; i < N; ++i) {
                lu_.real(i, i) += re;
                lu_.imaginary(i, i) += im;
            }
        } else {
            for (const auto& e : system.mass().entries()) {
                lu_.real(e.row, e.column) += e.value * re;
                lu_.imaginary(e.row, e.column) += e.value * im;
            }
        }
        return lu_.factor();
    }

    void solve(Scalar* x) {
        std::array<Scalar, N> zero{};
        std::array<Scalar*, lanes> re, im;
        for (int l = 0; l < used; ++l) {
            re[l] = x + N * (l < real ? l : 2 * l - real);
            im[l] = l < real ? zero.data() : re[l] + N;
        }
        lu_.solve(re, im, used);
    }

    template <class Vector>
    void filter(Vector& x, Vector& scratch) {
        if constexpr (real == 1) {
            lu_.solve_real(x.data());
        } else {
            using std::sqrt;
            scratch.setZero();
            lu_.solve(std::array<Scalar*, 1>{x.data()}, std::array<Scalar*, 1>{scratch.data()}, 1);
            for (int i = 0; i < N; ++i) x[i] = sqrt(x[i] * x[i] + scratch[i] * scratch[i]);
        }
    }

  private:
    lane_lu<Scalar, N, lanes> lu_;
};

}  // namespace stagecraft
