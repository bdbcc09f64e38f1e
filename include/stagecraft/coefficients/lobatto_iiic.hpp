// SPDX-License-Identifier: BSL-1.0 | written by: stagecraft coefficients lobatto_iiic 6
// clang-format off
#pragma once

#include <stagecraft/coefficients/unpack.hpp>

namespace stagecraft {
namespace coefficients {

template <int S>
struct lobatto_iiic;

template <>
struct lobatto_iiic<2> {
    static constexpr stagecraft::facts facts{.order = 2,
                                             .stage_order = 1,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = false,
                                             .symmetric = false,
                                             .r_infinity = 0x0p+0};
    static constexpr double c[] = {
        0x0p+0, 0x1p+0};
    static constexpr double b[] = {
        0x1p-1, 0x1p-1};
    static constexpr double A[] = {
        0x1p-1, -0x1p-1,
        0x1p-1, 0x1p-1};
    static constexpr int pairs = 1;
    static constexpr double alpha[] = {
        0x1p+0};
    static constexpr double beta[] = {
        0x1p+0};
    static constexpr double A_inverse[] = {
        0x1p+0, 0x1p+0,
        -0x1p+0, 0x1p+0};
    static constexpr double T[] = {
        0x0p+0, -0x1p+0,
        0x1p+0, 0x0p+0};
    static constexpr double T_inverse[] = {
        0x0p+0, 0x1p+0,
        -0x1p+0, 0x0p+0};
};

template <>
struct lobatto_iiic<3> {
    static constexpr stagecraft::facts facts{.order = 4,
                                             .stage_order = 2,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = false,
                                             .symmetric = false,
                                             .r_infinity = 0x0p+0};
    static constexpr double c[] = {
        0x0p+0, 0x1p-1, 0x1p+0};
    static constexpr double b[] = {
        0x1.5555555555555p-3, 0x1.5555555555555p-1, 0x1.5555555555555p-3};
    static constexpr double A[] = {
        0x1.5555555555555p-3, -0x1.5555555555555p-2, 0x1.5555555555555p-3,
        0x1.5555555555555p-3, 0x1.aaaaaaaaaaaabp-2, -0x1.5555555555555p-4,
        0x1.5555555555555p-3, 0x1.5555555555555p-1, 0x1.5555555555555p-3};
    static constexpr int pairs = 1;
    static constexpr double gamma[] = {
        0x1.501ac3f95b4fap+1};
    static constexpr double alpha[] = {
        0x1.afe53c06a4b06p+0};
    static constexpr double beta[] = {
        0x1.411e1f44eb65fp+1};
    static constexpr double A_inverse[] = {
        0x1.8p+1, 0x1p+2, -0x1p+0,
        -0x1p+0, 0x0p+0, 0x1p+0,
        0x1p+0, -0x1p+2, 0x1.8p+1};
    static constexpr double T[] = {
        0x1.d2570283321b8p-2, -0x1.3495c0a0cc86ep-1, 0x1.b946453af45d6p-2,
        0x1.a8c0715c2bcf4p-3, 0x1.6b9fc751ea186p-3, -0x1.09f5569d8cda4p-1,
        0x1p+0, 0x1p+0, 0x0p+0};
    static constexpr double T_inverse[] = {
        0x1.d8d099fba5124p-1, 0x1.883e766d4afdbp-1, 0x1.aea635ea2bbf5p-2,
        -0x1.d8d099fba5124p-1, -0x1.883e766d4afdbp-1, 0x1.28ace50aea205p-1,
        0x1.b2af63d728a2fp-5, -0x1.e18f57022167bp+0, 0x1.76c0fc605252ep-2};
};

template <>
struct lobatto_iiic<4> {
    static constexpr stagecraft::facts facts{.order = 6,
                                             .stage_order = 3,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = false,
                                             .symmetric = false,
                                             .r_infinity = 0x0p+0};
    static constexpr double c[] = {
        0x0p+0, 0x1.1b06d1d200913p-2, 0x1.727c9716ffb76p-1, 0x1p+0};
    static constexpr double b[] = {
        0x1.5555555555555p-4, 0x1.aaaaaaaaaaaabp-2, 0x1.aaaaaaaaaaaabp-2, 0x1.5555555555555p-4};
    static constexpr double A[] = {
        0x1.5555555555555p-4, -0x1.7d9f4cf754635p-3, 0x1.7d9f4cf754635p-3, -0x1.5555555555555p-4,
        0x1.5555555555555p-4, 0x1p-2, -0x1.81e02cd6a805p-4, 0x1.314c3d92a9e91p-5,
        0x1.5555555555555p-4, 0x1.b5cd608aff569p-2, 0x1p-2, -0x1.314c3d92a9e91p-5,
        0x1.5555555555555p-4, 0x1.aaaaaaaaaaaabp-2, 0x1.aaaaaaaaaaaabp-2, 0x1.5555555555555p-4};
    static constexpr int pairs = 2;
    static constexpr double alpha[] = {
        0x1.e3b6ed209eb11p+1, 0x1.1c4912df614efp+1};
    static constexpr double beta[] = {
        0x1.61533faa7574ap+0, 0x1.0a43da7b40ab1p+2};
    static constexpr double A_inverse[] = {
        0x1.8p+2, 0x1.02e2ac13ef8e9p+3, -0x1.8b8ab04fbe3a3p+1, 0x1p+0,
        -0x1.9e3779b97f4a8p+0, 0x0p+0, 0x1.1e3779b97f4a8p+1, -0x1.3c6ef372fe95p-1,
        0x1.3c6ef372fe95p-1, -0x1.1e3779b97f4a8p+1, 0x0p+0, 0x1.9e3779b97f4a8p+0,
        -0x1p+0, 0x1.8b8ab04fbe3a3p+1, -0x1.02e2ac13ef8e9p+3, 0x1.8p+2};
    static constexpr double T[] = {
        -0x1.dd898b26d928ap-4, -0x1.dd8267e3605eap-3, 0x1.1f3f6a48695dfp-1, 0x1.c5761701c2e17p-4,
        0x1.18be8099dec54p-4, -0x1.8105b0445a905p-7, -0x1.5c7d9d61ee134p-2, 0x1.5114ea7733f93p-5,
        0x1.42aeab4fd28dfp-2, -0x1.2b8e2af04167ap-3, 0x1.12333b2a37bd4p-2, -0x1.0641b19fda778p-1,
        0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0};
    static constexpr double T_inverse[] = {
        -0x1.8130083d21a4ep-3, 0x1.0f3e471fb6ccdp+1, 0x1.09614d9886b8dp-3, 0x1.9580554ba9f63p-1,
        -0x1.a6c0bfe3c73a6p+1, -0x1.55d8eb19cbf89p+2, -0x1.2496880f32b26p+0, 0x1.5d6478dd8cb95p-2,
        0x1.8130083d21a4ep-3, -0x1.0f3e471fb6ccdp+1, -0x1.09614d9886b8dp-3, 0x1.a9feaad158275p-3,
        0x1.d9fa10a63dbe1p-1, 0x1.b89bf063d60a2p+0, -0x1.9d2b3f34ca0e7p+0, 0x1.fe82649164f16p-2};
};

template <>
struct lobatto_iiic<5> {
    static constexpr stagecraft::facts facts{.order = 8,
                                             .stage_order = 4,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = false,
                                             .symmetric = false,
                                             .r_infinity = 0x0p+0};
    static constexpr double c[] = {
        0x0p+0, 0x1.61a277d8695abp-3, 0x1p-1, 0x1.a7976209e5a95p-1, 0x1p+0};
    static constexpr double b[] = {
        0x1.999999999999ap-5, 0x1.16c16c16c16c1p-2, 0x1.6c16c16c16c17p-2, 0x1.16c16c16c16c1p-2, 0x1.999999999999ap-5};
    static constexpr double A[] = {
        0x1.999999999999ap-5, -0x1.ddddddddddddep-4, 0x1.1111111111111p-3, -0x1.ddddddddddddep-4, 0x1.999999999999ap-5,
        0x1.999999999999ap-5, 0x1.49f49f49f49f5p-3, -0x1.1aabd87c4d54bp-4, 0x1.aa0072485ef61p-5, -0x1.5f15f15f15f16p-6,
        0x1.999999999999ap-5, 0x1.200f83b9bf6c8p-2, 0x1.9f49f49f49f4ap-3, -0x1.b0d7237e5669bp-5, 0x1.3333333333333p-6,
        0x1.999999999999ap-5, 0x1.14b49100e8c08p-2, 0x1.783e0f50a66e6p-2, 0x1.49f49f49f49f5p-3, -0x1.5f15f15f15f16p-6,
        0x1.999999999999ap-5, 0x1.16c16c16c16c1p-2, 0x1.6c16c16c16c17p-2, 0x1.16c16c16c16c1p-2, 0x1.999999999999ap-5};
    static constexpr int pairs = 2;
    static constexpr double gamma[] = {
        0x1.51bc614fb13f7p+2};
    static constexpr double alpha[] = {
        0x1.2c96d94779ba5p+2, 0x1.5515ec215b4bfp+1};
    static constexpr double beta[] = {
        0x1.74594ec45b6c3p+1, 0x1.7893d4e6c173cp+2};
    static constexpr double A_inverse[] = {
        0x1.4p+3, 0x1.b06a896a1a723p+3, -0x1.5555555555555p+2, 0x1.6900850240e1fp+1, -0x1p+0,
        -0x1.3db189876c3fp+1, 0x0p+0, 0x1.bee9056fb9c39p+1, -0x1.870be4c1c28b2p+0, 0x1.0939d9e24f04p-1,
        0x1.8p-1, -0x1.562a68298a39bp+1, 0x0p+0, 0x1.562a68298a39bp+1, -0x1.8p-1,
        -0x1.0939d9e24f04p-1, 0x1.870be4c1c28b2p+0, -0x1.bee9056fb9c39p+1, 0x0p+0, 0x1.3db189876c3fp+1,
        0x1p+0, -0x1.6900850240e1fp+1, 0x1.5555555555555p+2, -0x1.b06a896a1a723p+3, 0x1.4p+3};
    static constexpr double T[] = {
        0x1.fc3a5eeca92e2p-4, -0x1.38726dae4f2e6p-4, 0x1.2ed7f88ccab7dp-3, -0x1.108f42bb25ec7p-2, -0x1.7c6b8e56f6accp-2,
        -0x1.2c14c35b40b96p-6, -0x1.a0dce2f16aebcp-8, -0x1.d8a6bbad18733p-5, 0x1.676683f33637ap-3, 0x1.577f905558bf2p-3,
        0x1.5e4a820b1e5f9p-4, 0x1.0ab51e6b41b33p-7, -0x1.328f7d07d5001p-4, -0x1.5275d4a274b5p-2, -0x1.20117f5e30f61p-4,
        0x1.95c6487d50be7p-2, 0x1.90bef49f551b5p-2, -0x1.c64d1d7c400bfp-3, 0x1.6c9931bf5ab2ap-2, -0x1.0d273e9dfbab1p-1,
        0x1p+0, 0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0};
    static constexpr double T_inverse[] = {
        0x1.216990ed91adbp+2, 0x1.3831d6c070083p+3, 0x1.600246d28d9c5p+1, -0x1.cdc0aa8e2f0ebp-2, 0x1.1f47bc694959bp-1,
        -0x1.5c7704da35367p+2, -0x1.9474ae28ec2b5p+3, -0x1.8b922da0fe855p-1, -0x1.4d964fa8ef128p-4, 0x1.15b9c78f8938p-1,
        0x1.b8141ab079568p-1, -0x1.2fa3c70c2a319p+2, -0x1.6c8de6aafc95ap+1, -0x1.bd77e7bda75dep+0, 0x1.7aa88ea0fd096p-1,
        0x1.d86b9f651c461p-1, 0x1.710b5da1f08c7p+1, -0x1.fa3b76d49bf5fp+0, 0x1.10931f3c3569bp-1, -0x1.a80c1fc6948d5p-4,
        -0x1.879770cc64d57p-2, 0x1.e647597966021p+0, 0x1.5c3bf166ef21bp+0, -0x1.353bd1e5f7116p+0, 0x1.c73e21021102cp-2};
};

template <>
struct lobatto_iiic<6> {
    static constexpr stagecraft::facts facts{.order = 10,
                                             .stage_order = 5,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = false,
                                             .symmetric = false,
                                             .r_infinity = 0x0p+0};
    static constexpr double c[] = {
        0x0p+0, 0x1.e12aaca0bcf46p-4, 0x1.6df62279dab2bp-2, 0x1.4904eec312a6bp-1, 0x1.c3daaa6be8617p-1, 0x1p+0};
    static constexpr double b[] = {
        0x1.1111111111111p-5, 0x1.838ef05e9dfc2p-3, 0x1.1c1665ae8edfdp-2, 0x1.1c1665ae8edfdp-2, 0x1.838ef05e9dfc2p-3, 0x1.1111111111111p-5};
    static constexpr double A[] = {
        0x1.1111111111111p-5, -0x1.45506950d1377p-4, 0x1.89e3f14409d8p-4, -0x1.89e3f14409d8p-4, 0x1.45506950d1377p-4, -0x1.1111111111111p-5,
        0x1.1111111111111p-5, 0x1.c7d334a2e2406p-4, -0x1.9da4657f257cep-5, 0x1.62467bc14d188p-5, -0x1.159f2888ed2d2p-5, 0x1.ca6bc4c5a7a14p-7,
        0x1.1111111111111p-5, 0x1.91b6e10bb46bbp-3, 0x1.3e3887d0b101fp-3, -0x1.741e4a6ef5eebp-5, 0x1.e34f64fcafd0cp-6, -0x1.7a9c230cccb09p-7,
        0x1.1111111111111p-5, 0x1.7f86aa1669077p-3, 0x1.28780cda4b7b8p-2, 0x1.3e3887d0b101fp-3, -0x1.1a265c11ddd44p-5, 0x1.7a9c230cccb09p-7,
        0x1.1111111111111p-5, 0x1.84b2763c95032p-3, 0x1.1921b8827c4a3p-2, 0x1.2676d0125c81fp-2, 0x1.c7d334a2e2406p-4, -0x1.ca6bc4c5a7a14p-7,
        0x1.1111111111111p-5, 0x1.838ef05e9dfc2p-3, 0x1.1c1665ae8edfdp-2, 0x1.1c1665ae8edfdp-2, 0x1.838ef05e9dfc2p-3, 0x1.1111111111111p-5};
    static constexpr int pairs = 3;
    static constexpr double alpha[] = {
        0x1.9ee1d8597ae7dp+2, 0x1.5e0858d96c0a8p+2, 0x1.862b9d9a321b5p+1};
    static constexpr double beta[] = {
        0x1.7fd2d221886e7p+0, 0x1.21468bd915c78p+2, 0x1.e9b6f1ae6bcbap+2};
    static constexpr double A_inverse[] = {
        0x1.ep+3, 0x1.44867ab6b409dp+4, -0x1.0250e4699f8dp+3, 0x1.1f51d398dffcdp+2, -0x1.5993eb40e2141p+1, 0x1p+0,
        -0x1.c94f3697d64efp+1, 0x0p+0, 0x1.42ffa60d7480ep+2, -0x1.271fbf06d1d92p+1, 0x1.4e9dc765962c9p+0, -0x1.e6f9d1785f7fp-2,
        0x1.f09701eac49e7p-1, -0x1.b8a44bb06b20ap+1, 0x0p+0, 0x1.c0c21d8cae8cdp+1, -0x1.929d577c61634p+0, 0x1.142c659cf0777p-1,
        -0x1.142c659cf0777p-1, 0x1.929d577c61634p+0, -0x1.c0c21d8cae8cdp+1, 0x0p+0, 0x1.b8a44bb06b20ap+1, -0x1.f09701eac49e7p-1,
        0x1.e6f9d1785f7fp-2, -0x1.4e9dc765962c9p+0, 0x1.271fbf06d1d92p+1, -0x1.42ffa60d7480ep+2, 0x0p+0, 0x1.c94f3697d64efp+1,
        -0x1p+0, 0x1.5993eb40e2141p+1, -0x1.1f51d398dffcdp+2, 0x1.0250e4699f8dp+3, -0x1.44867ab6b409dp+4, 0x1.ep+3};
    static constexpr double T[] = {
        -0x1.3cf4a61fc580fp-5, -0x1.cd22358cc5292p-5, 0x1.c3f9a5a7a8e5dp-4, -0x1.b9b26a617e07bp-6, -0x1.2aa2e5155567dp-5, 0x1.7e2e195027169p-2,
        0x1.b88001851d68ap-7, 0x1.86e587e39a839p-7, -0x1.2daea5f09b13dp-5, 0x1.8ed769a2351abp-6, -0x1.23eb46f51a12fp-8, -0x1.7afb752858afbp-3,
        0x1.2258eae92c856p-9, -0x1.48e05c6d0f96p-6, -0x1.d24ac90fba21dp-7, -0x1.2aaec067ae975p-6, 0x1.4a14ca71dd3cbp-4, 0x1.a7958dc62c756p-3,
        0x1.69b9e10963fep-4, -0x1.7bdcfc29e5e61p-5, -0x1.d1c4f2448e5c6p-7, -0x1.160de323df659p-3, -0x1.53d410e2dd264p-2, -0x1.58d70cc0d447ap-3,
        0x1.d549a3e7399cep-2, -0x1.564c591ab59cfp-4, 0x1.d402e602b1c2bp-2, -0x1.12b6c2468aef2p-2, 0x1.c31e66dd2b525p-2, -0x1.10efccd7f9e47p-1,
        0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0};
    static constexpr double T_inverse[] = {
        -0x1.db281a4d4f481p+0, 0x1.48b4d77168213p+2, 0x1.af7d238ee09a9p+2, 0x1.bcc8d018aaf98p+1, -0x1.906bae687fdd7p+0, 0x1.4110dfc452268p+0,
        -0x1.5011d57a5a5acp+4, -0x1.bc3b376bc0379p+5, -0x1.0279c8e2f037ap+4, -0x1.6509374a0f8e3p-1, -0x1.7a30590056251p+0, 0x1.6a98c336714d9p-1,
        0x1.3d12a7285806ep+1, -0x1.8e8d57655d0a3p+2, -0x1.35d31155dc28bp+3, -0x1.8dd7801cdd2bp+0, 0x1.42c478c0e9281p-1, 0x1.943102dca987ap-5,
        0x1.09e2b07578741p+3, 0x1.954f086f78d3cp+4, 0x1.d0efa196f3cd2p+0, -0x1.3768ea607575ap-1, -0x1.0a2c26437e49dp+1, 0x1.f79ec834c6bp-1,
        -0x1.3dfa6806c18b4p-1, 0x1.1761ffcfd3a3fp+0, 0x1.7851fe39af6d9p+1, -0x1.ebba201478c8p+0, 0x1.de12e4101692cp-1, -0x1.36c99f6cddcafp-2,
        -0x1.bf6a52f1992c6p-1, -0x1.042a1ea4bf61dp+2, 0x1.8b1651d800751p+0, 0x1.ee914b0275939p-2, -0x1.42bcfee37f2aep-1, 0x1.0df95c3836636p-2};
};

}  // namespace coefficients

/// The S-stage member of this family, 2 <= S <= 6: every entry is the double nearest to the exact one; in another Scalar, float, that one rounded.
template <int S, class Scalar = double>
transformed_tableau<Scalar, (S > 0 ? S : -1)> lobatto_iiic() {  // of a variable s: lobatto_iiic(s) of stagecraft/families.hpp
    constexpr bool generated = 2 <= S && S <= 6;
    static_assert(generated, "lobatto_iiic: generated for 2 <= S <= 6; see stagecraft/tableaux/rounded.hpp for more");
    transformed_tableau<Scalar, (S > 0 ? S : -1)> t;
    if constexpr (generated) coefficients::unpack<coefficients::lobatto_iiic<S>>(t);
    return t;
}

/// A number of stages in parentheses is for stagecraft/families.hpp.
template <class Never = void>
transformed_tableau<double> lobatto_iiic(...) {
    static_assert(detail::never<Never>, "the number of stages stands in angle brackets, lobatto_iiic<3>(), or include stagecraft/families.hpp for lobatto_iiic(3)");
    return {};
}

}  // namespace stagecraft
