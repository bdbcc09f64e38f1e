// SPDX-License-Identifier: BSL-1.0 | written by: stagecraft coefficients tableaux/pairs/symplectic_euler.json tableaux/pairs/stoermer_verlet.json tableaux/pairs/ruth_3.json tableaux/pairs/forest_ruth_4.json tableaux/pairs/mclachlan_4.json tableaux/pairs/blanes_moan_4.json
// clang-format off
#pragma once

#include <stagecraft/coefficients/unpack_pair.hpp>

namespace stagecraft {
namespace coefficients {

struct symplectic_euler {
    static constexpr int stages = 1, order = 1;
    static constexpr double c[] = {
        0x1p+0};
    static constexpr double A[] = {
        0x1p+0};
    static constexpr double b[] = {
        0x1p+0};
    static constexpr double c_hat[] = {
        0x0p+0};
    static constexpr double A_hat[] = {
        0x0p+0};
    static constexpr double b_hat[] = {
        0x1p+0};
};

struct stoermer_verlet {
    static constexpr int stages = 2, order = 2;
    static constexpr double c[] = {
        0x0p+0, 0x1p+0};
    static constexpr double A[] = {
        0x0p+0, 0x0p+0,
        0x1p-1, 0x1p-1};
    static constexpr double b[] = {
        0x1p-1, 0x1p-1};
    static constexpr double c_hat[] = {
        0x0p+0, 0x1p+0};
    static constexpr double A_hat[] = {
        0x1p-1, 0x0p+0,
        0x1p-1, 0x0p+0};
    static constexpr double b_hat[] = {
        0x1p-1, 0x1p-1};
};

struct ruth_3 {
    static constexpr int stages = 3, order = 3;
    static constexpr double c[] = {
        0x0p+0, 0x1.5555555555555p-1, 0x0p+0};
    static constexpr double A[] = {
        0x0p+0, 0x0p+0, 0x0p+0,
        0x1.5555555555555p-1, 0x0p+0, 0x0p+0,
        0x1.5555555555555p-1, -0x1.5555555555555p-1, 0x0p+0};
    static constexpr double b[] = {
        0x1.5555555555555p-1, -0x1.5555555555555p-1, 0x1p+0};
    static constexpr double c_hat[] = {
        0x1.2aaaaaaaaaaabp-2, 0x1.0aaaaaaaaaaabp+0, 0x1p+0};
    static constexpr double A_hat[] = {
        0x1.2aaaaaaaaaaabp-2, 0x0p+0, 0x0p+0,
        0x1.2aaaaaaaaaaabp-2, 0x1.8p-1, 0x0p+0,
        0x1.2aaaaaaaaaaabp-2, 0x1.8p-1, -0x1.5555555555555p-5};
    static constexpr double b_hat[] = {
        0x1.2aaaaaaaaaaabp-2, 0x1.8p-1, -0x1.5555555555555p-5};
};

struct forest_ruth_4 {
    static constexpr int stages = 4, order = 4;
    static constexpr double c[] = {
        0x0p+0, 0x1.59e8b6eb96338p+0, -0x1.67a2dbae58ce2p-2, 0x1p+0};
    static constexpr double A[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.59e8b6eb96338p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.59e8b6eb96338p+0, -0x1.b3d16dd72c671p+0, 0x0p+0, 0x0p+0,
        0x1.59e8b6eb96338p+0, -0x1.b3d16dd72c671p+0, 0x1.59e8b6eb96338p+0, 0x0p+0};
    static constexpr double b[] = {
        0x1.59e8b6eb96338p+0, -0x1.b3d16dd72c671p+0, 0x1.59e8b6eb96338p+0, 0x0p+0};
    static constexpr double c_hat[] = {
        0x1.59e8b6eb96338p-1, 0x1p-1, 0x1.4c2e9228d398fp-2, 0x1p+0};
    static constexpr double A_hat[] = {
        0x1.59e8b6eb96338p-1, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.59e8b6eb96338p-1, -0x1.67a2dbae58ce2p-3, 0x0p+0, 0x0p+0,
        0x1.59e8b6eb96338p-1, -0x1.67a2dbae58ce2p-3, -0x1.67a2dbae58ce2p-3, 0x0p+0,
        0x1.59e8b6eb96338p-1, -0x1.67a2dbae58ce2p-3, -0x1.67a2dbae58ce2p-3, 0x1.59e8b6eb96338p-1};
    static constexpr double b_hat[] = {
        0x1.59e8b6eb96338p-1, -0x1.67a2dbae58ce2p-3, -0x1.67a2dbae58ce2p-3, 0x1.59e8b6eb96338p-1};
};

struct mclachlan_4 {
    static constexpr int stages = 6, order = 4;
    static constexpr double c[] = {
        0x0p+0, 0x1.999999999999ap-2, 0x1.3333333333334p-2, 0x1.6666666666667p-1, 0x1.3333333333334p-1, 0x1p+0};
    static constexpr double A[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.999999999999ap-2, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.999999999999ap-2, -0x1.999999999999ap-4, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.999999999999ap-2, -0x1.999999999999ap-4, 0x1.999999999999ap-2, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.999999999999ap-2, -0x1.999999999999ap-4, 0x1.999999999999ap-2, -0x1.999999999999ap-4, 0x0p+0, 0x0p+0,
        0x1.999999999999ap-2, -0x1.999999999999ap-4, 0x1.999999999999ap-2, -0x1.999999999999ap-4, 0x1.999999999999ap-2, 0x0p+0};
    static constexpr double b[] = {
        0x1.999999999999ap-2, -0x1.999999999999ap-4, 0x1.999999999999ap-2, -0x1.999999999999ap-4, 0x1.999999999999ap-2, 0x0p+0};
    static constexpr double c_hat[] = {
        0x1.6da5cea6f3a17p-4, -0x1.085372b4debfp-7, 0x1p-1, 0x1.0210a6e569bd8p+0, 0x1.d24b462b218bdp-1, 0x1p+0};
    static constexpr double A_hat[] = {
        0x1.6da5cea6f3a17p-4, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.6da5cea6f3a17p-4, -0x1.8eb03cfd8f795p-4, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.6da5cea6f3a17p-4, -0x1.8eb03cfd8f795p-4, 0x1.04214dcad37bp-1, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.6da5cea6f3a17p-4, -0x1.8eb03cfd8f795p-4, 0x1.04214dcad37bp-1, 0x1.04214dcad37bp-1, 0x0p+0, 0x0p+0,
        0x1.6da5cea6f3a17p-4, -0x1.8eb03cfd8f795p-4, 0x1.04214dcad37bp-1, 0x1.04214dcad37bp-1, -0x1.8eb03cfd8f795p-4, 0x0p+0,
        0x1.6da5cea6f3a17p-4, -0x1.8eb03cfd8f795p-4, 0x1.04214dcad37bp-1, 0x1.04214dcad37bp-1, -0x1.8eb03cfd8f795p-4, 0x1.6da5cea6f3a17p-4};
    static constexpr double b_hat[] = {
        0x1.6da5cea6f3a17p-4, -0x1.8eb03cfd8f795p-4, 0x1.04214dcad37bp-1, 0x1.04214dcad37bp-1, -0x1.8eb03cfd8f795p-4, 0x1.6da5cea6f3a17p-4};
};

struct blanes_moan_4 {
    static constexpr int stages = 7, order = 4;
    static constexpr double c[] = {
        0x0p+0, 0x1.ad16419760f57p-3, 0x1.0cf4feda4b6d6p-4, 0x1p-1, 0x1.de616024b6925p-1, 0x1.94ba6f9a27c2ap-1, 0x1p+0};
    static constexpr double A[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.ad16419760f57p-3, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.ad16419760f57p-3, -0x1.269bc22a3b3ecp-3, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.ad16419760f57p-3, -0x1.269bc22a3b3ecp-3, 0x1.bcc2c0496d24ap-2, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.ad16419760f57p-3, -0x1.269bc22a3b3ecp-3, 0x1.bcc2c0496d24ap-2, 0x1.bcc2c0496d24ap-2, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.ad16419760f57p-3, -0x1.269bc22a3b3ecp-3, 0x1.bcc2c0496d24ap-2, 0x1.bcc2c0496d24ap-2, -0x1.269bc22a3b3ecp-3, 0x0p+0, 0x0p+0,
        0x1.ad16419760f57p-3, -0x1.269bc22a3b3ecp-3, 0x1.bcc2c0496d24ap-2, 0x1.bcc2c0496d24ap-2, -0x1.269bc22a3b3ecp-3, 0x1.ad16419760f57p-3, 0x0p+0};
    static constexpr double b[] = {
        0x1.ad16419760f57p-3, -0x1.269bc22a3b3ecp-3, 0x1.bcc2c0496d24ap-2, 0x1.bcc2c0496d24ap-2, -0x1.269bc22a3b3ecp-3, 0x1.ad16419760f57p-3, 0x0p+0};
    static constexpr double c_hat[] = {
        0x1.446b185e4f0adp-4, 0x1.bac0ee9cd86e1p-2, 0x1.8fadd2db15da3p-2, 0x1.382916927512fp-1, 0x1.229f88b193c9p-1, 0x1.d7729cf4361ebp-1, 0x1p+0};
    static constexpr double A_hat[] = {
        0x1.446b185e4f0adp-4, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.446b185e4f0adp-4, 0x1.69a6288544ab6p-2, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.446b185e4f0adp-4, 0x1.69a6288544ab6p-2, -0x1.5898de0e149fp-5, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.446b185e4f0adp-4, 0x1.69a6288544ab6p-2, -0x1.5898de0e149fp-5, 0x1.c148b493a8975p-3, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.446b185e4f0adp-4, 0x1.69a6288544ab6p-2, -0x1.5898de0e149fp-5, 0x1.c148b493a8975p-3, -0x1.5898de0e149fp-5, 0x0p+0, 0x0p+0,
        0x1.446b185e4f0adp-4, 0x1.69a6288544ab6p-2, -0x1.5898de0e149fp-5, 0x1.c148b493a8975p-3, -0x1.5898de0e149fp-5, 0x1.69a6288544ab6p-2, 0x0p+0,
        0x1.446b185e4f0adp-4, 0x1.69a6288544ab6p-2, -0x1.5898de0e149fp-5, 0x1.c148b493a8975p-3, -0x1.5898de0e149fp-5, 0x1.69a6288544ab6p-2, 0x1.446b185e4f0adp-4};
    static constexpr double b_hat[] = {
        0x1.446b185e4f0adp-4, 0x1.69a6288544ab6p-2, -0x1.5898de0e149fp-5, 0x1.c148b493a8975p-3, -0x1.5898de0e149fp-5, 0x1.69a6288544ab6p-2, 0x1.446b185e4f0adp-4};
};

}  // namespace coefficients

/// Symplectic Euler method (R. de Vogelaere, Univ. of Notre Dame, report 4 (1956)), order 1, proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
partitioned_method<Scalar, 1> symplectic_euler() {
    return coefficients::unpack_pair<partitioned_method<Scalar, 1>, coefficients::symplectic_euler>();
}

/// Stoermer-Verlet method (Lobatto IIIA-IIIB, s = 2) (L. Verlet, Phys. Rev. 159 (1967) 98-103; E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, 2nd ed., Springer 2006, sect. I.1.4 and II.2.1), order 2, proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
partitioned_method<Scalar, 2> stoermer_verlet() {
    return coefficients::unpack_pair<partitioned_method<Scalar, 2>, coefficients::stoermer_verlet>();
}

/// Ruth, order 3 (R. D. Ruth, IEEE Trans. Nuclear Science NS-30 (1983) 2669-2671; E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, 2nd ed., Springer 2006, sect. V.3.1), order 3, proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
separable_method<Scalar, 3> ruth_3() {
    return coefficients::unpack_pair<separable_method<Scalar, 3>, coefficients::ruth_3>();
}

/// Forest-Ruth, order 4 (E. Forest, R. D. Ruth, Physica D 43 (1990) 105-117), order 4, up to the digits published: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
separable_method<Scalar, 4> forest_ruth_4() {
    return coefficients::unpack_pair<separable_method<Scalar, 4>, coefficients::forest_ruth_4>();
}

/// McLachlan, order 4, five stages (R. I. McLachlan, SIAM J. Sci. Comput. 16 (1995) 151-168), order 4, proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
separable_method<Scalar, 6> mclachlan_4() {
    return coefficients::unpack_pair<separable_method<Scalar, 6>, coefficients::mclachlan_4>();
}

/// Blanes-Moan, order 4, six stages (S6) (S. Blanes, P. C. Moan, J. Comput. Appl. Math. 142 (2002) 313-330), order 4, up to the digits published: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
separable_method<Scalar, 7> blanes_moan_4() {
    return coefficients::unpack_pair<separable_method<Scalar, 7>, coefficients::blanes_moan_4>();
}

}  // namespace stagecraft
