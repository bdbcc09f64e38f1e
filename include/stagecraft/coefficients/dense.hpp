// SPDX-License-Identifier: BSL-1.0 | written by: stagecraft coefficients tableaux/catalogue/bogacki_shampine_3_2.json tableaux/catalogue/dormand_prince_5_4.json tableaux/catalogue/tsitouras_5_4.json tableaux/catalogue/dormand_prince_8_5_3.json tableaux/dense/bogacki_shampine_3_2.json tableaux/dense/dormand_prince_5_4_quartic.json tableaux/dense/tsitouras_5_4.json tableaux/dense/dormand_prince_8_5_3.json
// clang-format off
#pragma once

#include <stagecraft/coefficients/explicit.hpp>
#include <stagecraft/coefficients/unpack_dense.hpp>

namespace stagecraft {
namespace coefficients {

struct bogacki_shampine_3_2_dense : bogacki_shampine_3_2 {
    static constexpr int further_stages = 0, degree = 3, dense_order = 3;
    static constexpr double b_theta[] = {
        0x1p+0, -0x1.5555555555555p+0, 0x1.1c71c71c71c72p-1,
        0x0p+0, 0x1p+0, -0x1.5555555555555p-1,
        0x0p+0, 0x1.5555555555555p+0, -0x1.c71c71c71c71cp-1,
        0x0p+0, -0x1p+0, 0x1p+0};
};

struct dormand_prince_5_4_quartic_dense : dormand_prince_5_4 {
    static constexpr int further_stages = 0, degree = 4, dense_order = 4;
    static constexpr double b_theta[] = {
        0x1p+0, -0x1.6d421c90ad023p+1, 0x1.892ee3cc04af1p+1, -0x1.208439215a046p+0,
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x0p+0, 0x1.017b046ccf5e3p+2, -0x1.8ff4e27046a46p+2, 0x1.56744f3b9a987p+1,
        0x0p+0, -0x1.ddbf58f446418p+1, 0x1.423501cf78761p+3, -0x1.6bdfac7a2320cp+2,
        0x0p+0, 0x1.4703cfd92b80bp+1, -0x1.998b0ea409b1p+2, 0x1.c2ceae0978c92p+1,
        0x0p+0, -0x1.5fda423d67152p+0, 0x1.a2e673007345fp+1, -0x1.c46c8b61f95e5p+0,
        0x0p+0, 0x1.61e97be1b9227p+0, -0x1.e1e97be1b9227p+1, 0x1.30f4bdf0dc914p+1};
};

struct tsitouras_5_4_dense : tsitouras_5_4 {
    static constexpr int further_stages = 0, degree = 4, dense_order = 4;
    static constexpr double b_theta[] = {
        0x1p+0, -0x1.61c11fea8621ap+1, 0x1.74e58e12b5912p+1, -0x1.0d9735318a381p+0,
        0x0p+0, 0x1.0db8bac710cb2p-3, -0x1.c985f06f69446p-3, 0x1.a0902de00d1b7p-4,
        0x0p+0, 0x1.f713f27487049p+1, -0x1.7c39e6224eea7p+2, 0x1.3eccdff932dd6p+1,
        0x0p+0, -0x1.8d278b4d83996p+3, 0x1.e569387b2f10dp+4, -0x1.08c5078902664p+4,
        0x0p+0, 0x1.2c1312e99aa1bp+5, -0x1.60b732d84076dp+6, 0x1.7b0942cf93616p+5,
        0x0p+0, -0x1.be582bf341b49p+4, 0x1.045e19a33ba95p+6, -0x1.16f71b780910ep+5,
        0x0p+0, 0x1.8p+0, -0x1p+2, 0x1.4p+1};
};

struct dormand_prince_8_5_3_dense : dormand_prince_8_5_3 {
    static constexpr int further_stages = 4, degree = 7, dense_order = 7;
    static constexpr double c_more[] = {
        0x1p+0, 0x1.999999999999ap-4, 0x1.999999999999ap-3, 0x1.8e38e38e38e39p-1};
    static constexpr double A_more[] = {
        0x1.bcc6368d1177cp-5, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x1.1cd1ed2ad5ae2p+2, 0x1.e43a845d5ab9fp+0, -0x1.7346ecf96af43p+2, 0x1.3ea1df2f0eb98p-2, -0x1.37a028f43b002p-3, 0x1.9c657697fe72dp-3, 0x1.6e44f50ab6bc2p-5, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.cc1fca2ceb148p-5, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x1.03958f21a35b8p-2, -0x1.f84c2c277c23ep-3, -0x1.fcb02555c9defp-4, 0x1.39f10ce2d1913p-3, 0x1.0cbb69b38652cp-7, 0x1.eff840f396ba9p-8, -0x1.0fe8ab4fa483p-7, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.04ca1897bdb63p-5, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x1.cfae9e5f59f45p-6, 0x1.b69db017c8cf9p-5, -0x1.c1ef72fc69469p-5, 0x0p+0, 0x0p+0, -0x1.c6710eef6e153p-14, 0x1.9127a52d3232p-12, -0x1.6500e13e7149bp-12, 0x1.21686b20cd989p-3, 0x0p+0, 0x0p+0,
        -0x1.b7309792b6015p-2, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, -0x1.2ca5d44afdc9ap+2, 0x1.ebbd2c419eda3p+2, 0x1.046a54457171cp+2, 0x1.6d49e44edba44p-2, 0x0p+0, 0x0p+0, 0x0p+0, -0x1.6ebeec24871d4p-10, 0x1.79482a23f1996p+1, -0x1.24d4a6dca2222p+3, 0x0p+0};
    static constexpr double b_theta[] = {
        0x1p+0, -0x1.48838a1fd54d4p+3, 0x1.814b7885468dp+5, -0x1.cbbb7121aaec2p+6, 0x1.26edced9500f8p+7, -0x1.844475472bd42p+6, 0x1.9b1a59f97e9a3p+4,
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x0p+0, 0x1.bd5d6b2631281p+3, -0x1.3593640bd13cep+7, 0x1.0576011ce24f4p+9, -0x1.c8425a2bce784p+8, -0x1.2e20b42d5b028p+6, 0x1.346126bd860c7p+7,
        0x0p+0, 0x1.4d846c7a92df9p+1, -0x1.59f7149ad3005p+4, 0x1.4480d83fe8d98p+1, 0x1.244111972bc28p+8, -0x1.f968f5b75e7bcp+8, 0x1.cf0f0ac99099p+7,
        0x0p+0, -0x1.e09b30ea8ee29p+3, 0x1.40305f4d153a3p+7, -0x1.da4ea384e5117p+8, 0x1.0febb581bb81bp+7, 0x1.108dfa1613ef7p+9, -0x1.65a39d3b3c602p+8,
        0x0p+0, 0x1.8677b0edb2a16p+1, -0x1.345a0b86061c9p+5, 0x1.5cf15b5a56a6ap+7, -0x1.510d25141c4c9p+8, 0x1.23ca3541030dp+8, -0x1.759f0d4d83c7p+6,
        0x0p+0, -0x1.53ef942dec26ap+0, 0x1.0a969c97285ccp+4, -0x1.29c2d845e7794p+6, 0x1.19811345bd7dep+7, -0x1.dd0659d82843ep+6, 0x1.2baaa552107abp+5,
        0x0p+0, 0x1.6c19ad9659de3p+1, -0x1.247763a03558ap+5, 0x1.55615113a58ffp+7, -0x1.59f98faca86d1p+8, 0x1.394caf8bd8aa7p+8, -0x1.a0660a855838ep+6,
        0x0p+0, 0x1.880b39215574ep-1, -0x1.3d061b80634d4p+3, 0x1.766c8706f4248p+5, -0x1.821458a95bbdfp+6, 0x1.62f900a396f52p+6, -0x1.dd71d78528cf6p+4,
        0x0p+0, -0x1.16c81218b7f08p+0, 0x1.c31abb1881989p+3, -0x1.0abaae66b7d76p+6, 0x1.13ed0d1bc5285p+7, -0x1.ff49e55d3f887p+6, 0x1.5c4484e37f77ep+5,
        0x0p+0, 0x1.22604753358b4p+4, -0x1.fe884ddad4f6ep+6, 0x1.65578a2412809p+8, -0x1.f4b401b0b32b1p+8, 0x1.5d2b9c86030fcp+8, -0x1.814c57df8201p+6,
        0x0p+0, -0x1.263a6db60dfa1p+3, 0x1.756d4ece493efp+6, -0x1.1aa0943be38d4p+8, 0x1.6923dc193d84dp+8, -0x1.93b452514ee36p+7, 0x1.396b082b5cd1ep+5,
        0x0p+0, -0x1.1be8052a2581dp+2, 0x1.c5731bd0ca21cp+5, -0x1.05c5ff71d862cp+8, 0x1.047cb35c7674bp+9, -0x1.cd2c3c9d6acd3p+8, 0x1.2b7423e1cb30dp+7};
};

}  // namespace coefficients

/// Bogacki-Shampine 3(2), cubic Hermite interpolation (P. Bogacki, L. F. Shampine, Appl. Math. Lett. 2 (1989) 321-325), order 3(2), proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
dense_method<Scalar, 4> bogacki_shampine_3_2_dense() {
    return coefficients::unpack_dense<Scalar, coefficients::bogacki_shampine_3_2_dense>();
}

/// Dormand-Prince 5(4), quartic dense output (L. F. Shampine, Math. Comp. 46 (1986) 135-150), order 5(4), proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
dense_method<Scalar, 7> dormand_prince_5_4_quartic_dense() {
    return coefficients::unpack_dense<Scalar, coefficients::dormand_prince_5_4_quartic_dense>();
}

/// Tsitouras 5(4), quartic dense output (C. Tsitouras, Comput. Math. Appl. 62 (2011) 770-775), order 5(4), up to the digits published: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
dense_method<Scalar, 7> tsitouras_5_4_dense() {
    return coefficients::unpack_dense<Scalar, coefficients::tsitouras_5_4_dense>();
}

/// Dormand-Prince 8(5,3) (DOP853), dense output of order 7 (E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed., Springer 1993, sect. II.6; coefficients of the code DOP853), order 8(5), up to the digits published: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
dense_method<Scalar, 12> dormand_prince_8_5_3_dense() {
    return coefficients::unpack_dense<Scalar, coefficients::dormand_prince_8_5_3_dense>();
}

}  // namespace stagecraft
