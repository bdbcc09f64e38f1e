// SPDX-License-Identifier: BSL-1.0 | written by: stagecraft coefficients tableaux/pairs/stoermer_verlet_nystrom.json tableaux/pairs/nystrom_4.json tableaux/pairs/nystrom_5.json tableaux/pairs/dormand_prince_rkn_4_3.json tableaux/pairs/dormand_prince_rkn_5_4.json tableaux/pairs/dormand_prince_rkn_6_4.json tableaux/pairs/dormand_prince_rkn_8_6.json
// clang-format off
#pragma once

#include <stagecraft/coefficients/unpack_pair.hpp>

namespace stagecraft {
namespace coefficients {

struct stoermer_verlet_nystrom {
    static constexpr int stages = 2, order = 2;
    static constexpr double c[] = {
        0x0p+0, 0x1p+0};
    static constexpr double A_bar[] = {
        0x0p+0, 0x0p+0,
        0x1p-1, 0x0p+0};
    static constexpr double b_bar[] = {
        0x1p-1, 0x0p+0};
    static constexpr double b[] = {
        0x1p-1, 0x1p-1};
};

struct nystrom_4 {
    static constexpr int stages = 4, order = 4;
    static constexpr double c[] = {
        0x0p+0, 0x1p-1, 0x1p-1, 0x1p+0};
    static constexpr double A_bar[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1p-3, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1p-3, 0x0p+0, 0x0p+0, 0x0p+0,
        0x0p+0, 0x0p+0, 0x1p-1, 0x0p+0};
    static constexpr double b_bar[] = {
        0x1.5555555555555p-3, 0x1.5555555555555p-3, 0x1.5555555555555p-3, 0x0p+0};
    static constexpr double A[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1p-1, 0x0p+0, 0x0p+0, 0x0p+0,
        0x0p+0, 0x1p-1, 0x0p+0, 0x0p+0,
        0x0p+0, 0x0p+0, 0x1p+0, 0x0p+0};
    static constexpr double b[] = {
        0x1.5555555555555p-3, 0x1.5555555555555p-2, 0x1.5555555555555p-2, 0x1.5555555555555p-3};
};

struct nystrom_5 {
    static constexpr int stages = 4, order = 5;
    static constexpr double c[] = {
        0x0p+0, 0x1.999999999999ap-3, 0x1.5555555555555p-1, 0x1p+0};
    static constexpr double A_bar[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.47ae147ae147bp-6, 0x0p+0, 0x0p+0, 0x0p+0,
        -0x1.2f684bda12f68p-5, 0x1.097b425ed097bp-2, 0x0p+0, 0x0p+0,
        0x1.3333333333333p-2, -0x1.d41d41d41d41dp-5, 0x1.075075075075p-2, 0x0p+0};
    static constexpr double b_bar[] = {
        0x1.5555555555555p-5, 0x1.30c30c30c30c3p-2, 0x1.4924924924925p-3, 0x0p+0};
    static constexpr double b[] = {
        0x1.5555555555555p-5, 0x1.7cf3cf3cf3cf4p-2, 0x1.edb6db6db6db7p-2, 0x1.aaaaaaaaaaaabp-4};
};

struct dormand_prince_rkn_4_3 {
    static constexpr int stages = 4, order = 4;
    static constexpr double c[] = {
        0x0p+0, 0x1p-2, 0x1.6666666666666p-1, 0x1p+0};
    static constexpr double A_bar[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1p-5, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.cac083126e979p-8, 0x1.e76c8b439581p-3, 0x0p+0, 0x0p+0,
        0x1.2492492492492p-4, 0x1.2f684bda12f68p-2, 0x1.0ee643b990ee6p-3, 0x0p+0};
    static constexpr double b_bar[] = {
        0x1.2492492492492p-4, 0x1.2f684bda12f68p-2, 0x1.0ee643b990ee6p-3, 0x0p+0};
    static constexpr double b_bar_embedded[] = {
        -0x1.7e4b17e4b17e5p-5, 0x1.c962fc962fc96p-2, 0x1.3333333333333p-3, -0x1.999999999999ap-5};
    static constexpr double b[] = {
        0x1.2492492492492p-4, 0x1.948b0fcd6e9ep-2, 0x1.c37fc63546e2ap-2, 0x1.7b425ed097b42p-4};
    static constexpr double b_embedded[] = {
        0x1.3cf3cf3cf3cf4p-1, -0x1.7b425ed097b42p-1, 0x1.747c9d1f2747dp+0, -0x1.5555555555555p-2};
};

struct dormand_prince_rkn_5_4 {
    static constexpr int stages = 6, order = 5;
    static constexpr double c[] = {
        0x0p+0, 0x1p-3, 0x1p-2, 0x1p-1, 0x1.8p-1, 0x1p+0};
    static constexpr double A_bar[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1p-7, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.5555555555555p-7, 0x1.5555555555555p-6, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.5555555555555p-5, 0x0p+0, 0x1.5555555555555p-4, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.2p-4, 0x0p+0, 0x1.2p-3, 0x1.2p-4, 0x0p+0, 0x0p+0,
        0x1.3e93e93e93e94p-4, 0x0p+0, 0x1.1111111111111p-2, 0x1.1111111111111p-4, 0x1.6c16c16c16c17p-4, 0x0p+0};
    static constexpr double b_bar[] = {
        0x1.3e93e93e93e94p-4, 0x0p+0, 0x1.1111111111111p-2, 0x1.1111111111111p-4, 0x1.6c16c16c16c17p-4, 0x0p+0};
    static constexpr double b_bar_embedded[] = {
        0x1.5555555555555p-3, 0x0p+0, 0x0p+0, 0x1.5555555555555p-2, 0x0p+0, 0x0p+0};
    static constexpr double b[] = {
        0x1.3e93e93e93e94p-4, 0x0p+0, 0x1.6c16c16c16c17p-2, 0x1.1111111111111p-3, 0x1.6c16c16c16c17p-2, 0x1.3e93e93e93e94p-4};
    static constexpr double b_embedded[] = {
        0x0p+0, 0x0p+0, 0x1.5555555555555p-1, -0x1.5555555555555p-2, 0x1.5555555555555p-1, 0x0p+0};
};

struct dormand_prince_rkn_6_4 {
    static constexpr int stages = 6, order = 6;
    static constexpr double c[] = {
        0x0p+0, 0x1.999999999999ap-4, 0x1.3333333333333p-2, 0x1.6666666666666p-1, 0x1.5c28f5c28f5c3p-1, 0x1p+0};
    static constexpr double A_bar[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.47ae147ae147bp-8, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        -0x1.dca01dca01dcap-12, 0x1.745d1745d1746p-5, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.8b5378b5378b5p-4, -0x1.04a7904a7904ap-4, 0x1.b26c9b26c9b27p-3, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.d50601fa61055p-4, -0x1.b5f8453877e6ep-4, 0x1.dd7579a02ec73p-3, -0x1.37cf54a74d91cp-7, 0x0p+0, 0x0p+0,
        0x1.20bf3920bf392p-4, 0x1.611a7b9611a7cp-5, 0x1.202fe80bfa03p-2, 0x1.4f3cf3cf3cf3dp-2, -0x1.c77ff32c51f42p-3, 0x0p+0};
    static constexpr double b_bar[] = {
        0x1.20bf3920bf392p-4, 0x1.611a7b9611a7cp-5, 0x1.202fe80bfa03p-2, 0x1.4f3cf3cf3cf3dp-2, -0x1.c77ff32c51f42p-3, 0x0p+0};
    static constexpr double b_bar_embedded[] = {
        0x1.18a917e15d514p-7, 0x1.427a63736cdf2p-3, 0x1.b55c08566f48ap-3, 0x1.fcc3dfe728a2ep-3, -0x1.0624dd2f1a9fcp-3, 0x0p+0};
    static constexpr double b[] = {
        0x1.20bf3920bf392p-4, 0x1.8856506ddaba6p-5, 0x1.9bb226ec89bb2p-2, 0x1.175d75d75d75dp+0, -0x1.63dbf5faa006bp-1, 0x1.5555555555555p-4};
    static constexpr double b_embedded[] = {
        0x1.18a917e15d514p-7, 0x1.664f192aeabf1p-3, 0x1.38664f192aeacp-2, 0x1.a7f88feb4c87cp-1, -0x1.999999999999ap-2, 0x1.5555555555555p-4};
};

struct dormand_prince_rkn_8_6 {
    static constexpr int stages = 9, order = 8;
    static constexpr double c[] = {
        0x0p+0, 0x1.999999999999ap-5, 0x1.999999999999ap-4, 0x1.3333333333333p-2, 0x1p-1, 0x1.6666666666666p-1, 0x1.ccccccccccccdp-1, 0x1p+0, 0x1p+0};
    static constexpr double A_bar[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.47ae147ae147bp-10, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.b4e81b4e81b4fp-10, 0x1.b4e81b4e81b4fp-9, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.70a3d70a3d70ap-5, -0x1.70a3d70a3d70ap-4, 0x1.70a3d70a3d70ap-4, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        -0x1.5a176401c8fp-2, 0x1.b8e8de688ab9ap-1, -0x1.f1cdc0ad5812bp-2, 0x1.684d9f782e3dep-4, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.7e06e214b89e8p-1, -0x1.cde9b69388085p+0, 0x1.46b1e2e085186p+0, -0x1.ff86153e04235p-6, 0x1.dd599d2479fe9p-5, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        -0x1.415251cc04595p+0, 0x1.a0f48dc02f053p+1, -0x1.08d09f136e37ep+1, 0x1.aebe4f0f42008p-2, -0x1.2d2fcd1ae2acap-6, 0x1.1bdb45dff10f7p-4, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.e2ee7279a3eb3p+1, -0x1.356d787f526ecp+3, 0x1.b32558b9f052p+2, -0x1.b2b4a2bb2de61p-1, 0x1.de62b9f91cb31p-2, -0x1.94a9e6be90a55p-5, 0x1.d81b8d33a8c0ep-6, 0x0p+0, 0x0p+0,
        0x1.cc4566e096abfp-6, 0x0p+0, 0x1.2a69a69a69a6ap-3, 0x1.393a3e4e8f93ap-3, 0x1.76db6db6db6dbp-4, 0x1.0c7b10d59fa32p-4, 0x1.094177a5b33ecp-6, 0x0p+0, 0x0p+0};
    static constexpr double b_bar[] = {
        0x1.cc4566e096abfp-6, 0x0p+0, 0x1.2a69a69a69a6ap-3, 0x1.393a3e4e8f93ap-3, 0x1.76db6db6db6dbp-4, 0x1.0c7b10d59fa32p-4, 0x1.094177a5b33ecp-6, 0x0p+0, 0x0p+0};
    static constexpr double b_bar_embedded[] = {
        0x1.2993c93d18027p-4, 0x0p+0, 0x1.275c9d874dd41p-5, 0x1.32541ea256959p-2, -0x1.483b873b8079p-5, 0x1.06913ed44a371p-3, 0x1.068b36b128bc8p-8, 0x0p+0, 0x0p+0};
    static constexpr double b[] = {
        0x1.cc4566e096abfp-6, 0x0p+0, 0x1.4b91d58f200e7p-3, 0x1.bf77c6b95f653p-3, 0x1.76db6db6db6dbp-3, 0x1.bf77c6b95f653p-3, 0x1.4b91d58f200e7p-3, 0x1.cc4566e096abfp-6, 0x0p+0};
    static constexpr double b_embedded[] = {
        0x1.2993c93d18027p-4, 0x0p+0, 0x1.482e045d72ebap-5, 0x1.b59cbe0c7bb11p-2, -0x1.483b873b8079p-4, 0x1.b59cbe0c7bb11p-2, 0x1.482e045d72ebap-5, -0x1.3cd29d294e64p-4, 0x1.3333333333333p-3};
};

}  // namespace coefficients

/// Stoermer-Verlet method (velocity form) (L. Verlet, Phys. Rev. 159 (1967) 98-103; E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, 2nd ed., Springer 2006, sect. I.1.4), order 2, proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
nystrom_method<Scalar, 2> stoermer_verlet_nystrom() {
    return coefficients::unpack_pair<nystrom_method<Scalar, 2>, coefficients::stoermer_verlet_nystrom>();
}

/// Nystrom, order 4, for y'' = f(t, y, y') (E. J. Nystrom, Acta Soc. Sci. Fenn. 50 (1925) no. 13; E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed., Springer 1993, sect. II.14), order 4, proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
velocity_nystrom_method<Scalar, 4> nystrom_4() {
    return coefficients::unpack_pair<velocity_nystrom_method<Scalar, 4>, coefficients::nystrom_4>();
}

/// Nystrom, order 5, for y'' = f(t, y) (E. J. Nystrom, Acta Soc. Sci. Fenn. 50 (1925) no. 13; E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed., Springer 1993, sect. II.14), order 5, proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
nystrom_method<Scalar, 4> nystrom_5() {
    return coefficients::unpack_pair<nystrom_method<Scalar, 4>, coefficients::nystrom_5>();
}

/// Dormand-El-Mikkawy-Prince RKN4(3)4 (J. R. Dormand, M. E. A. El-Mikkawy, P. J. Prince, IMA J. Numer. Anal. 7 (1987) 235-250), order 4(3), proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
nystrom_method<Scalar, 4> dormand_prince_rkn_4_3() {
    return coefficients::unpack_pair<nystrom_method<Scalar, 4>, coefficients::dormand_prince_rkn_4_3>();
}

/// Bettis RKN5(4) (D. G. Bettis, Celestial Mech. 8 (1973) 229-233), order 5(4), proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
nystrom_method<Scalar, 6> dormand_prince_rkn_5_4() {
    return coefficients::unpack_pair<nystrom_method<Scalar, 6>, coefficients::dormand_prince_rkn_5_4>();
}

/// Dormand-El-Mikkawy-Prince RKN6(4)6FM (J. R. Dormand, M. E. A. El-Mikkawy, P. J. Prince, IMA J. Numer. Anal. 7 (1987) 235-250), order 6(4), proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
nystrom_method<Scalar, 6> dormand_prince_rkn_6_4() {
    return coefficients::unpack_pair<nystrom_method<Scalar, 6>, coefficients::dormand_prince_rkn_6_4>();
}

/// Dormand-El-Mikkawy-Prince RKN8(6)9FM (J. R. Dormand, M. E. A. El-Mikkawy, P. J. Prince, IMA J. Numer. Anal. 7 (1987) 423-430), order 8(6), proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
nystrom_method<Scalar, 9> dormand_prince_rkn_8_6() {
    return coefficients::unpack_pair<nystrom_method<Scalar, 9>, coefficients::dormand_prince_rkn_8_6>();
}

}  // namespace stagecraft
