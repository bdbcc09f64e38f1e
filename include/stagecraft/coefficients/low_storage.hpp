// SPDX-License-Identifier: BSL-1.0 | written by: stagecraft coefficients tableaux/low_storage/williamson_2n_3.json tableaux/low_storage/carpenter_kennedy_2n_5_4.json tableaux/low_storage/ssp_3_3_shu_osher.json tableaux/low_storage/ssp_5_4_shu_osher.json tableaux/low_storage/ssp_10_4_2s.json tableaux/low_storage/ranocha_3s_3_2.json tableaux/low_storage/ranocha_3s_4_3.json
// clang-format off
#pragma once

#include <stagecraft/coefficients/unpack_low_storage.hpp>

namespace stagecraft {
namespace coefficients {

struct williamson_2n_3 {
    static constexpr int stages = 3, lists = 2, order = 3;
    static constexpr storage_form form = storage_form::williamson;
    static constexpr double rows[] = {
        0x0p+0, -0x1.1c71c71c71c72p-1, -0x1.32p+0,
        0x1.5555555555555p-2, 0x1.ep-1, 0x1.1111111111111p-1};
};

struct carpenter_kennedy_2n_5_4 {
    static constexpr int stages = 5, lists = 2, order = 4;
    static constexpr storage_form form = storage_form::williamson;
    static constexpr double rows[] = {
        0x0p+0, -0x1.abeb7b0525ab4p-2, -0x1.3130da7c5c7c9p+0, -0x1.b2a20481d08b9p+0, -0x1.83a186b53aa7dp+0,
        0x1.32806de84de49p-3, 0x1.844fb5528eaaap-2, 0x1.a55a5c929773dp-1, 0x1.661e5ec2f291cp-1, 0x1.3976141383057p-3};
};

struct ssp_3_3_shu_osher {
    static constexpr int stages = 3, lists = 6, order = 3;
    static constexpr storage_form form = storage_form::shu_osher;
    static constexpr double rows[] = {
        0x1p+0, 0x0p+0, 0x0p+0,
        0x1.8p-1, 0x1p-2, 0x0p+0,
        0x1.5555555555555p-2, 0x0p+0, 0x1.5555555555555p-1,
        0x1p+0, 0x0p+0, 0x0p+0,
        0x0p+0, 0x1p-2, 0x0p+0,
        0x0p+0, 0x0p+0, 0x1.5555555555555p-1};
};

struct ssp_5_4_shu_osher {
    static constexpr int stages = 5, lists = 10, order = 4;
    static constexpr storage_form form = storage_form::shu_osher;
    static constexpr double rows[] = {
        0x1p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.c7090f0628605p-2, 0x1.1c7b787cebcfdp-1, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.3d7dfd68a9d9dp-1, 0x0p+0, 0x1.8504052eac4c6p-2, 0x0p+0, 0x0p+0,
        0x1.6cb52ee1888c2p-3, 0x0p+0, 0x0p+0, 0x1.a4d2b4479dddp-1, 0x0p+0,
        0x0p+0, 0x0p+0, 0x1.08d296f7235c2p-1, 0x1.8975e832c4b95p-4, 0x1.8bfd5805081a8p-2,
        0x1.91277ee50bb98p-2, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x0p+0, 0x1.7940a0629af09p-2, 0x0p+0, 0x0p+0, 0x0p+0,
        0x0p+0, 0x0p+0, 0x1.01efead2836b9p-2, 0x0p+0, 0x0p+0,
        0x0p+0, 0x0p+0, 0x0p+0, 0x1.1706ee32c1291p-1, 0x0p+0,
        0x0p+0, 0x0p+0, 0x0p+0, 0x1.04e264dec582ap-4, 0x1.cedd02e93af0cp-3};
};

struct ssp_10_4_2s {
    static constexpr int stages = 10, lists = 4, order = 4;
    static constexpr storage_form form = storage_form::ketcheson;
    static constexpr double rows[] = {
        0x1p+0, 0x1p+0, 0x1p+0, 0x1p+0, 0x1.999999999999ap-2, 0x1p+0, 0x1p+0, 0x1p+0, 0x1p+0, 0x1.3333333333333p-1,
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x1.3333333333333p-1, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, -0x1p-1,
        0x1p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, -0x1.ccccccccccccdp+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.5555555555555p-3, 0x1.5555555555555p-3, 0x1.5555555555555p-3, 0x1.5555555555555p-3, 0x1.1111111111111p-4, 0x1.5555555555555p-3, 0x1.5555555555555p-3, 0x1.5555555555555p-3, 0x1.5555555555555p-3, 0x1.999999999999ap-4};
};

struct ranocha_3s_3_2 {
    static constexpr int stages = 5, lists = 5, order = 3;
    static constexpr storage_form form = storage_form::ketcheson_three;
    static constexpr double rows[] = {
        0x0p+0, 0x1.08fa312c035e8p-2, -0x1.0f3af7495ea5ap-3, 0x1.9e27a4703c998p-5, 0x1.225511dc09698p-1,
        0x1p+0, 0x1.1b0e1715c2ecfp-1, 0x1.58aba1844970bp-1, 0x1.1f09af330fb72p-2, 0x1.1ab3856741f2dp-1,
        0x0p+0, 0x0p+0, 0x0p+0, 0x1.19dd62b34655bp-2, -0x1.ca44a1cd85b7fp-1,
        0x1p+0, 0x1.5cf279bf9cfecp-2, 0x1.5da26db23d1f3p-2, 0x1.7223eab21de7bp-1, 0x0p+0,
        0x1.d7192f7d3b2ebp-3, 0x1.3565b4adbb921p-2, 0x1.9ae9286f0e473p-1, 0x1.beaf617dec1c2p-2, 0x1.ce8c625371e65p-4};
    static constexpr double b_embedded[] = {
        0x1.ac9726df845b4p-4, 0x1.85f4f5e951b7ap-4, 0x1.cb00a63b834fap-2, 0x1.f58fb834bc52ap-3, 0x1.b651d9dfa4097p-4};
};

struct ranocha_3s_4_3 {
    static constexpr int stages = 9, lists = 5, order = 4;
    static constexpr storage_form form = storage_form::ketcheson_three;
    static constexpr double rows[] = {
        0x0p+0, -0x1.29f606eeb42ap+2, -0x1.8b470e71b9b12p-1, -0x1.01902661b9a91p+2, -0x1.5ced7936bb3b8p-6, -0x1.37aed162915abp+1, 0x1.455340bb708cep-6, -0x1.1fd32d244e13p-2, 0x1.59ff0b55115d9p-3,
        0x1p+0, 0x1.3fe7d78547e0fp+1, 0x1.2c6196803603dp-1, 0x1.348424ff8113bp+0, 0x1.63d1a26ede9bap-2, 0x1.5243bd9a8c779p+0, 0x1.3f7364fb72fffp-2, 0x1.bd95d6f680a53p-2, 0x1.e34426739eb86p-3,
        0x0p+0, 0x0p+0, 0x0p+0, 0x1.86327526c9c45p-1, -0x1.95bf00d08f019p-3, -0x1.3eec3bd85731bp-1, -0x1.803ae75152afp-2, -0x1.5798c16f86664p-2, -0x1.75a2543f9d34dp-5,
        0x1p+0, 0x1.434efa4bef13cp+0, 0x1.83d69c1b2df21p-1, 0x1.086038d6cced2p-1, -0x1.c1f5968d435b2p-6, -0x1.c0c92fbb1340fp-2, 0x1.4609cdeedcf4bp+0, -0x1.424a6aae6650ep-1, 0x0p+0,
        0x1.22710b3c06bf6p-2, 0x1.f28239ef2bf8cp-1, 0x1.5a5a801a5ffb6p-2, -0x1.6f18fe766963cp-2, -0x1.0d9cb9ae726cdp-8, 0x1.6d8f5fb855c01p+0, 0x1.284ca2329c324p-6, 0x1.48dca9c863cdcp-3, 0x1.2e4edac2200b1p-2};
    static constexpr double b_embedded[] = {
        0x1.74ca2bfb83c9cp-5, 0x1.e1ad36f78467ep-4, 0x1.2baf377e5f72p-5, -0x1.5c191e9974999p-8, 0x1.535c9e748261bp-8, 0x1.fb5ae3a164e17p-2, -0x1.892b9ac0ff8e7p-8, 0x1.813b8d72c469bp-4, 0x1.bc46be80c893ap-3};
};

}  // namespace coefficients

/// Williamson, 2N, order 3 (case 7) (J. H. Williamson, J. Comput. Phys. 35 (1980) 48-56), order 3, proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
low_storage_method<Scalar> williamson_2n_3() {
    return coefficients::unpack_low_storage<Scalar, coefficients::williamson_2n_3>();
}

/// Carpenter-Kennedy, 2N, five stages of order 4 (solution 3) (M. H. Carpenter, C. A. Kennedy, NASA TM 109112 (1994)), order 4, proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
low_storage_method<Scalar> carpenter_kennedy_2n_5_4() {
    return coefficients::unpack_low_storage<Scalar, coefficients::carpenter_kennedy_2n_5_4>();
}

/// SSP(3,3), Shu-Osher form (C.-W. Shu, S. Osher, J. Comput. Phys. 77 (1988) 439-471), order 3, proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
low_storage_method<Scalar> ssp_3_3_shu_osher() {
    return coefficients::unpack_low_storage<Scalar, coefficients::ssp_3_3_shu_osher>();
}

/// SSP(5,4), Shu-Osher form (R. J. Spiteri, S. J. Ruuth, SIAM J. Numer. Anal. 40 (2002) 469-491), order 4, up to the digits published: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
low_storage_method<Scalar> ssp_5_4_shu_osher() {
    return coefficients::unpack_low_storage<Scalar, coefficients::ssp_5_4_shu_osher>();
}

/// SSP(10,4), in two registers (D. I. Ketcheson, SIAM J. Sci. Comput. 30 (2008) 2113-2136; D. I. Ketcheson, J. Comput. Phys. 229 (2010) 1763-1773), order 4, proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
low_storage_method<Scalar> ssp_10_4_2s() {
    return coefficients::unpack_low_storage<Scalar, coefficients::ssp_10_4_2s>();
}

/// RK3(2)5[3S*+] (H. Ranocha, L. Dalcin, M. Parsani, D. I. Ketcheson, Commun. Appl. Math. Comput. 4 (2022) 1191-1228), order 3(2), up to the digits published: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
low_storage_method<Scalar> ranocha_3s_3_2() {
    return coefficients::unpack_low_storage<Scalar, coefficients::ranocha_3s_3_2>();
}

/// RK4(3)9[3S*+] (H. Ranocha, L. Dalcin, M. Parsani, D. I. Ketcheson, Commun. Appl. Math. Comput. 4 (2022) 1191-1228), order 4(3), up to the digits published: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
low_storage_method<Scalar> ranocha_3s_4_3() {
    return coefficients::unpack_low_storage<Scalar, coefficients::ranocha_3s_4_3>();
}

}  // namespace stagecraft
