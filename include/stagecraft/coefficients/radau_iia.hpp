// SPDX-License-Identifier: BSL-1.0 | written by: stagecraft coefficients radau_iia 9
// clang-format off
#pragma once

#include <stagecraft/coefficients/unpack.hpp>

namespace stagecraft {
namespace coefficients {

template <int S>
struct radau_iia;

template <>
struct radau_iia<1> {
    static constexpr stagecraft::facts facts{.order = 1,
                                             .stage_order = 1,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = false,
                                             .symmetric = false,
                                             .r_infinity = 0x0p+0};
    static constexpr double c[] = {
        0x1p+0};
    static constexpr double b[] = {
        0x1p+0};
    static constexpr double A[] = {
        0x1p+0};
    static constexpr int pairs = 0;
    static constexpr double gamma[] = {
        0x1p+0};
    static constexpr double A_inverse[] = {
        0x1p+0};
    static constexpr double T[] = {
        0x1p+0};
    static constexpr double T_inverse[] = {
        0x1p+0};
};

template <>
struct radau_iia<2> {
    static constexpr stagecraft::facts facts{.order = 3,
                                             .stage_order = 2,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = false,
                                             .symmetric = false,
                                             .r_infinity = 0x0p+0};
    static constexpr double c[] = {
        0x1.5555555555555p-2, 0x1p+0};
    static constexpr double b[] = {
        0x1.8p-1, 0x1p-2};
    static constexpr double A[] = {
        0x1.aaaaaaaaaaaabp-2, -0x1.5555555555555p-4,
        0x1.8p-1, 0x1p-2};
    static constexpr int pairs = 1;
    static constexpr double alpha[] = {
        0x1p+1};
    static constexpr double beta[] = {
        0x1.6a09e667f3bcdp+0};
    static constexpr double A_inverse[] = {
        0x1.8p+0, 0x1p-1,
        -0x1.2p+2, 0x1.4p+1};
    static constexpr double T[] = {
        0x1.c71c71c71c71cp-4, -0x1.41cfe93ff5199p-2,
        0x1p+0, 0x0p+0};
    static constexpr double T_inverse[] = {
        0x0p+0, 0x1p+0,
        -0x1.974b2334f2346p+1, 0x1.6a09e667f3bcdp-2};
};

template <>
struct radau_iia<3> {
    static constexpr stagecraft::facts facts{.order = 5,
                                             .stage_order = 3,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = false,
                                             .symmetric = false,
                                             .r_infinity = 0x0p+0};
    static constexpr double c[] = {
        0x1.3d8b64657cae9p-3, 0x1.4a36c0803a6dfp-1, 0x1p+0};
    static constexpr double b[] = {
        0x1.816fcdf1a6a67p-2, 0x1.06648ace491e9p-1, 0x1.c71c71c71c71cp-4};
    static constexpr double A[] = {
        0x1.9313fe302d93bp-3, -0x1.0c6edfec18b84p-4, 0x1.8576b15adbb79p-6,
        0x1.93e3f7b234d43p-2, 0x1.2b154adc88802p-2, -0x1.545e0c7243c2cp-5,
        0x1.816fcdf1a6a67p-2, 0x1.06648ace491e9p-1, 0x1.c71c71c71c71cp-4};
    static constexpr int pairs = 1;
    static constexpr double gamma[] = {
        0x1.d1a48d83e731dp+1};
    static constexpr double alpha[] = {
        0x1.572db93e0c672p+1};
    static constexpr double beta[] = {
        0x1.86747f2c3fcb5p+1};
    static constexpr double A_inverse[] = {
        0x1.9cc470a049097p+1, 0x1.2af7915ab4027p+0, -0x1.034624ce046cap-2,
        -0x1.c8aefbe08d347p+1, 0x1.8cee3d7edbda3p-1, 0x1.0d9e56004de7fp+0,
        0x1.620bd700c2c3ep+2, -0x1.e20bd700c2c3ep+2, 0x1.4p+2};
    static constexpr double T[] = {
        0x1.82d23845d677bp-4, -0x1.214a74c403bf7p-3, 0x1.ebff91a6d688fp-6,
        0x1.0037de70aa1edp-2, 0x1.a20e91e20b551p-3, -0x1.8821fa2a36dedp-2,
        0x1p+0, 0x1p+0, 0x0p+0};
    static constexpr double T_inverse[] = {
        0x1.0b70201a79c47p+2, 0x1.4f8c15da84e86p-2, 0x1.0bf7ff59d56efp-1,
        -0x1.0b70201a79c47p+2, -0x1.4f8c15da84e86p-2, 0x1.e810014c55221p-2,
        0x1.017885a24a7f2p-1, -0x1.4934e6fcaa598p+1, 0x1.312c0cf7bdfd1p-1};
};

template <>
struct radau_iia<4> {
    static constexpr stagecraft::facts facts{.order = 7,
                                             .stage_order = 4,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = false,
                                             .symmetric = false,
                                             .r_infinity = 0x0p+0};
    static constexpr double c[] = {
        0x1.6adb354ed2ae1p-4, 0x1.a34b481e46449p-2, 0x1.934819d94bac8p-1, 0x1p+0};
    static constexpr double b[] = {
        0x1.c381b1181084dp-3, 0x1.8d8296b4cf125p-2, 0x1.50bc90bf28ab5p-2, 0x1p-4};
    static constexpr double A[] = {
        0x1.ced88ac2871a4p-4, -0x1.4a36901783436p-5, 0x1.a6bf03cb7b2f8p-6, -0x1.448e72d68cb3p-7,
        0x1.e004b76386efep-3, 0x1.a7b74b36b3769p-3, -0x1.880babfb2abc3p-5, 0x1.06ebc508e68dfp-6,
        0x1.bbc3a8d4c4262p-3, 0x1.9fdec6e1d212p-2, 0x1.832593fa5220ep-3, -0x1.8c33196c5dc78p-6,
        0x1.c381b1181084dp-3, 0x1.8d8296b4cf125p-2, 0x1.50bc90bf28ab5p-2, 0x1p-4};
    static constexpr int pairs = 2;
    static constexpr double alpha[] = {
        0x1.32615f2e64b48p+2, 0x1.9b3d41a33697p+1};
    static constexpr double beta[] = {
        0x1.9146226bd0f14p+0, 0x1.317a43b6b7cafp+2};
    static constexpr double A_inverse[] = {
        0x1.6939103d934e6p+2, 0x1.ec6af91091689p+0, -0x1.2bfb4770a0ad1p-1, 0x1.641a556e4f586p-3,
        -0x1.4326552798095p+2, 0x1.389a02f13f52cp+0, 0x1.c132c5f5a4076p+0, -0x1.bd39f909f3cdcp-2,
        0x1.bf09218ed76cap+1, -0x1.fe04aeb25b352p+1, 0x1.45037830e6e77p-1, 0x1.d2779c12164c5p+0,
        -0x1.bb1a6e7ceb172p+2, 0x1.a6185fbd199bcp+2, -0x1.857ef8a017425p+3, 0x1.1p+3};
    static constexpr double T[] = {
        -0x1.8209588c52f11p-7, -0x1.2268baf59c74ap-5, 0x1.07b499f8d24eap-4, 0x1.726951dbf08e6p-5,
        0x1.7ba76ab719fdep-5, -0x1.07d79e9b76576p-5, -0x1.8f5d380f1d85cp-3, -0x1.e43590d5c2a77p-6,
        0x1.58ee9447178bfp-2, -0x1.022f37788094fp-3, 0x1.2b1c3722ce28ep-2, -0x1.bc4a8bc9555f9p-2,
        0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0};
    static constexpr double T_inverse[] = {
        -0x1.c7c3c3dc8aff4p+0, 0x1.d4c498859791fp+1, -0x1.bd6e5bb7233c4p-2, 0x1.e9622248b682cp-1,
        -0x1.1f6182fecd3b9p+4, -0x1.58e6cd1406f87p+2, -0x1.8136ca251723bp+0, 0x1.170d3e7eabe43p-1,
        0x1.c7c3c3dc8aff4p+0, -0x1.d4c498859791fp+1, 0x1.bd6e5bb7233c4p-2, 0x1.69dddb7497d47p-5,
        0x1.42406c975f19p+2, 0x1.f18c266e1a8bbp+0, -0x1.e995db5481415p+0, 0x1.3a15e25ad5415p-1};
};

template <>
struct radau_iia<5> {
    static constexpr stagecraft::facts facts{.order = 9,
                                             .stage_order = 5,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = false,
                                             .symmetric = false,
                                             .r_infinity = 0x0p+0};
    static constexpr double c[] = {
        0x1.d3cc2dd8d6d32p-5, 0x1.1b7cbc26ceaaep-2, 0x1.2acc5d7a90e51p-1, 0x1.b8716522b33bep-1, 0x1p+0};
    static constexpr double b[] = {
        0x1.26534b9cb85e2p-3, 0x1.201bca8e66374p-2, 0x1.3f4f73b8d3267p-2, 0x1.c8eab2b61c94ap-3, 0x1.47ae147ae147bp-5};
    static constexpr double A[] = {
        0x1.2b00db6e3fa2dp-4, -0x1.b6081b30682ap-6, 0x1.3200b8a1aa037p-6, -0x1.a605c5bc79bfcp-7, 0x1.4a7ccd96a885cp-8,
        0x1.3aee82311a74fp-3, 0x1.2b72b35cc0671p-3, -0x1.2a8dccf20f1a7p-5, 0x1.5be1ebec3e8bdp-6, -0x1.040878141910fp-7,
        0x1.1ed95fc4c15b4p-3, 0x1.3224706ef9eacp-2, 0x1.5736d75c3ae6dp-3, -0x1.16465e9a31545p-5, 0x1.669f591dfd1acp-7,
        0x1.28be58d5a7ef5p-3, 0x1.1b22d582aaa26p-2, 0x1.4d9df880051b7p-2, 0x1.07b19ee2f3ab4p-3, -0x1.015ff99971365p-6,
        0x1.26534b9cb85e2p-3, 0x1.201bca8e66374p-2, 0x1.3f4f73b8d3267p-2, 0x1.c8eab2b61c94ap-3, 0x1.47ae147ae147bp-5};
    static constexpr int pairs = 2;
    static constexpr double gamma[] = {
        0x1.92595ee3123e2p+2};
    static constexpr double alpha[] = {
        0x1.6cdc6b397464ep+2, 0x1.d3edcaaa04f82p+1};
    static constexpr double beta[] = {
        0x1.9ae9fbb266469p+1, 0x1.a2cc95da18518p+2};
    static constexpr double A_inverse[] = {
        0x1.1830877b703d6p+3, 0x1.722b2cf57bb01p+1, -0x1.c0186e6b2b212p-1, 0x1.994c52709276dp-2, -0x1.11d489880c497p-3,
        -0x1.ca540fccceadfp+2, 0x1.ce5b1c16f92e6p+0, 0x1.2e90e7e6cbc1p+1, -0x1.bb5758d9cb3c5p-1, 0x1.18ec14c05e2bbp-2,
        0x1.07d18e2e54ad5p+2, -0x1.1fbebe9d67f6fp+2, 0x1.b6a9ef2aa91c1p-1, 0x1.42585742d8bacp+1, -0x1.506a879a9f92ep-1,
        -0x1.f078095074d2fp+1, 0x1.b252cd53396d6p+1, -0x1.4c0dc7046124bp+2, 0x1.299760f060b19p-1, 0x1.67ad8b5edc468p+1,
        0x1.0d3294490d4d2p+3, -0x1.be18ad1c72325p+2, 0x1.18de1e9b82aadp+3, -0x1.23822e2b2b6f6p+4, 0x1.ap+3};
    static constexpr double T[] = {
        0x1.bce3049d4571bp-7, -0x1.7820c3d05d519p-7, 0x1.cb6719b83f651p-7, -0x1.4f9c863603a7fp-7, -0x1.868b5dfabb152p-5,
        0x1.a81f7541182a2p-10, -0x1.f695a1442b72fp-8, -0x1.94d34a11716e1p-6, 0x1.9b041f87f5bd6p-5, 0x1.826214e5b71e4p-4,
        0x1.443b067594e3ap-4, 0x1.3dd30e1ded383p-6, -0x1.4f0de33f576c9p-4, -0x1.d8251c7936647p-3, -0x1.a4abf2d1b7462p-4,
        0x1.a6267562c234ap-2, 0x1.a1623391d6c89p-2, -0x1.98f319cae0a7ep-3, 0x1.82f69e7e11149p-2, -0x1.ddf22c5d8318fp-2,
        0x1p+0, 0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0};
    static constexpr double T_inverse[] = {
        0x1.bb29c0f2d2f98p+4, 0x1.99111aaad89ebp+3, 0x1.9aafc7bcbfa6dp+1, -0x1.e729c05622205p-1, 0x1.7bac81b18745bp-1,
        -0x1.0855c54b1b4f1p+5, -0x1.1608005f0b102p+4, -0x1.608533caefc2p-3, -0x1.96330c92fc51ep-4, 0x1.0ffd21b07b821p-1,
        0x1.1390f2f71cd09p+3, -0x1.366654626d079p+3, -0x1.ea2ba7f8366fcp+0, -0x1.3597b31c9da03p+1, 0x1.0c2691306fb5ap+0,
        0x1.5607268d8e926p+2, 0x1.25fdcc267b033p+2, -0x1.84a7748010aabp+1, 0x1.0cf810f440d55p+0, -0x1.175346c4058f7p-2,
        -0x1.dfc06c7c33f87p+1, 0x1.fe135b74a3869p+1, 0x1.0b5ed2d02325fp+0, -0x1.2f21157164963p+0, 0x1.ccb73e72d9b82p-2};
};

template <>
struct radau_iia<6> {
    static constexpr stagecraft::facts facts{.order = 11,
                                             .stage_order = 6,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = false,
                                             .symmetric = false,
                                             .r_infinity = 0x0p+0};
    static constexpr double c[] = {
        0x1.461f52430616bp-5, 0x1.95880f0f7d9a1p-3, 0x1.c07c77f9eff4p-2, 0x1.6413e4ab2e381p-1, 0x1.cd8ccf29f891bp-1, 0x1p+0};
    static constexpr double b[] = {
        0x1.9cda5f0f56522p-4, 0x1.aae82ef21d169p-3, 0x1.0ab6ea52d1c52p-2, 0x1.f10956d17c887p-3, 0x1.474fe7d6341f7p-3, 0x1.c71c71c71c71cp-6};
    static constexpr double A[] = {
        0x1.a161eade7d844p-5, -0x1.35c6fdd397a74p-6, 0x1.c077169ba0712p-7, -0x1.53ce30ade0b49p-7, 0x1.e26352802b547p-8, -0x1.7d5bd7d20f3ap-9,
        0x1.bb46a25c6b698p-4, 0x1.b62bf679a7b03p-4, -0x1.c333092b3652cp-6, 0x1.1eaaad30825bcp-6, -0x1.7dde81331e5ebp-7, 0x1.27b6c6df8e3fdp-8,
        0x1.90816a542f6fap-4, 0x1.c90e886ee1a78p-3, 0x1.172c268b8a369p-3, -0x1.e5bc63561349p-6, 0x1.0c04da490ff9ep-6, -0x1.897061e06881ep-8,
        0x1.a24b12772876bp-4, 0x1.9fb1dbd6556f5p-3, 0x1.1b08600d9781bp-2, 0x1.0c4ce2c7962aep-3, -0x1.9792c72c124c8p-6, 0x1.00ce39d8c50bep-7,
        0x1.9af4ae1b92ca3p-4, 0x1.ae96241278086p-3, 0x1.063b3e67c2c1dp-2, 0x1.03725c0de804dp-2, 0x1.7a9870a1fa689p-4, -0x1.684abb4b1e856p-7,
        0x1.9cda5f0f56522p-4, 0x1.aae82ef21d169p-3, 0x1.0ab6ea52d1c52p-2, 0x1.f10956d17c887p-3, 0x1.474fe7d6341f7p-3, 0x1.c71c71c71c71cp-6};
    static constexpr int pairs = 3;
    static constexpr double alpha[] = {
        0x1.df669af31b5e2p+2, 0x1.9e1ceaae5a6a9p+2, 0x1.027c7a5e8a376p+2};
    static constexpr double beta[] = {
        0x1.9f1ac7d230678p+0, 0x1.399b95baa738fp+2, 0x1.0b0f2899eb86cp+3};
    static constexpr double A_inverse[] = {
        0x1.91e91743c4253p+3, 0x1.04da553f9a467p+2, -0x1.379aab35ebaf8p+0, 0x1.21e924acf4cb9p-1, -0x1.3a7986d06d8a8p-2, 0x1.bed0f90c91cb8p-4,
        -0x1.39b0dacfce27fp+3, 0x1.4335de19788ep+1, 0x1.90ecc6ede0bb7p+1, -0x1.284c057307916p+0, 0x1.2ab1121b51805p-1, -0x1.9ed153e66fee4p-3,
        0x1.4ba87959d476bp+2, -0x1.62d9769e15f59p+2, 0x1.2441169321243p+0, 0x1.7ccc059a44f9ap+1, -0x1.2d92acb3c60abp+0, 0x1.89c579130622p-2,
        -0x1.06ed63a9a3791p+2, 0x1.bee9913c4435fp+1, -0x1.4478e4b98cfbdp+2, 0x1.701973ffb33cap-1, 0x1.bae2a64a7de73p+1, -0x1.da56c059926a8p-1,
        0x1.18b0b3d5a5e84p+2, -0x1.bb648473fdd55p+1, 0x1.f9cc24a9e64f3p+1, -0x1.b3dfe0cf8a0b7p+2, 0x1.1bfb7237e5efap-1, 0x1.0118b43362da3p+2,
        -0x1.3e2cdefc819edp+3, 0x1.eb449a35d844p+2, -0x1.07729522486aap+3, 0x1.74704a3e80694p+3, -0x1.9a39919d5140ep+4, 0x1.28p+4};
    static constexpr double T[] = {
        -0x1.874d0a1ecf46cp-9, -0x1.55e515e721f29p-8, 0x1.47467df2537c1p-7, 0x1.c51a99419b595p-15, -0x1.0046897c14206p-6, 0x1.d7dc039cc9e27p-6,
        0x1.eda8322eadd44p-9, 0x1.93b3b42292215p-10, -0x1.9ce338f617146p-7, 0x1.0dc88b3ba47b2p-7, 0x1.4d9a5343f2a95p-6, -0x1.feac39bd01ed5p-5,
        0x1.b0ce52828cf36p-8, -0x1.e1fec1a9ae95ep-7, -0x1.26f641e5be8c6p-6, -0x1.c3b7a1bf82adp-7, 0x1.d1657ea996797p-7, 0x1.15ba708b350f6p-3,
        0x1.775ccf91b17c9p-4, -0x1.7bc00aa5ab1a9p-5, 0x1.acbc3b10be05bp-8, -0x1.17c6c604350bbp-3, -0x1.fe19d1f2dff6ep-3, -0x1.7c7ab0be4d9bap-3,
        0x1.e2788961d1983p-2, -0x1.3bb769f2e6607p-4, 0x1.e193e996ac111p-2, -0x1.f8584832ada13p-3, 0x1.d591f5b713a6cp-2, -0x1.eecfb3fa54fb7p-2,
        0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0};
    static constexpr double T_inverse[] = {
        -0x1.353fd79dc2f7fp+4, 0x1.82d1bf7df9ee8p+3, 0x1.be3a1618d6e9dp+2, 0x1.1f4b916212179p+2, -0x1.3d83ee0086ce2p+1, 0x1.9bad19263e2adp+0,
        -0x1.165321893e81dp+7, -0x1.5b74ad6bf01cdp+6, -0x1.1afacd01bc826p+4, 0x1.41ff656831f37p-1, -0x1.258eda91ce778p+1, 0x1.0d2b8ea5cc0afp+0,
        0x1.972c55c454a84p+4, -0x1.da8c6f585c752p+3, -0x1.551a9b5668656p+3, -0x1.f3044ff54ae6fp+0, 0x1.30152033f55dep+0, -0x1.6e2efe9e60dacp-3,
        0x1.a89fb1a999635p+5, 0x1.55487cedb1e6bp+5, -0x1.dde85f87c2d7ap-1, 0x1.793e2ab238973p-3, -0x1.561d1c096c667p+1, 0x1.3f1296e20b433p+0,
        -0x1.87b1f89a46c13p+2, 0x1.5eeabf698a1a6p+1, 0x1.d7f64127f3c1ep+1, -0x1.4514fac97ebbap+1, 0x1.4af2bbcd183e6p+0, -0x1.b79ce549c83dfp-2,
        -0x1.2f41d9cc2883dp+2, -0x1.fb837fc42f52fp+2, 0x1.9c28ea1567f0cp+1, -0x1.fdc9bf7ae405cp-4, -0x1.826b6425ff077p-2, 0x1.7822e6e729c35p-3};
};

template <>
struct radau_iia<7> {
    static constexpr stagecraft::facts facts{.order = 13,
                                             .stage_order = 7,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = false,
                                             .symmetric = false,
                                             .r_infinity = 0x0p+0};
    static constexpr double c[] = {
        0x1.e05201f8c2062p-6, 0x1.2f43d53682496p-3, 0x1.591283c00a7e2p-2, 0x1.1e0a317ca931cp-1, 0x1.89d90550ca2b2p-1, 0x1.da989f7ef95f1p-1, 0x1p+0};
    static constexpr double b[] = {
        0x1.3120de1741e2p-4, 0x1.45d7547e674b8p-3, 0x1.b2e58c2545d3dp-3, 0x1.c9d728b559d1fp-3, 0x1.8617b942de854p-3, 0x1.e9f01a14371c2p-4, 0x1.4e5e0a72f0539p-6};
    static constexpr double A[] = {
        0x1.339439878c04p-5, -0x1.cc0a796388665p-7, 0x1.533d7e60f7a16p-7, -0x1.0b54f84016f6ep-7, 0x1.a2abccaf980e9p-8, -0x1.2d9e3b007fb24p-8, 0x1.df7241f37c4edp-10,
        0x1.4848d89e338e7p-4, 0x1.4c07bc1c40287p-4, -0x1.5bf69865d58fp-6, 0x1.cac2f480aa399p-7, -0x1.4f5a928186d41p-7, 0x1.d4cf3ae0d0d66p-8, -0x1.70a8843d67503p-9,
        0x1.272c6b9d6de7dp-4, 0x1.5e5915f04a5dcp-3, 0x1.c0fb337b7a802p-4, -0x1.935f39fa17c8p-6, 0x1.e3ab045717476p-7, -0x1.39c318fadf2ccp-7, 0x1.e162a3357877dp-9,
        0x1.361693f89245cp-4, 0x1.3b939e87c4fffp-3, 0x1.d11ddc6d709b8p-3, 0x1.e130ceb5140a4p-4, -0x1.861dd8fa6f242p-6, 0x1.a07b16199008p-7, -0x1.2e0b9375e30a2p-8,
        0x1.2ebeb545c9676p-4, 0x1.4a74cf0de4b92p-3, 0x1.a7aa0328a3e17p-3, 0x1.e563fc8a8784fp-3, 0x1.a63e566e09258p-4, -0x1.34e7fdc37e032p-6, 0x1.7ff80c13e0dccp-8,
        0x1.31fe759e0499cp-4, 0x1.443693ea05bdep-3, 0x1.b69611ea12931p-3, 0x1.c24f5110ef0fep-3, 0x1.970b5a3508124p-3, 0x1.1bb624822fe97p-4, -0x1.09f202e443882p-7,
        0x1.3120de1741e2p-4, 0x1.45d7547e674b8p-3, 0x1.b2e58c2545d3dp-3, 0x1.c9d728b559d1fp-3, 0x1.8617b942de854p-3, 0x1.e9f01a14371c2p-4, 0x1.4e5e0a72f0539p-6};
    static constexpr int pairs = 3;
    static constexpr double gamma[] = {
        0x1.1dfa88c180ab2p+3};
    static constexpr double alpha[] = {
        0x1.1060f36d58ac5p+3, 0x1.c9070c7855d36p+2, 0x1.183c83eb7828ep+2};
    static constexpr double beta[] = {
        0x1.a3f841231a708p+1, 0x1.a7dffc016913ep+2, 0x1.456e209c08037p+3};
    static constexpr double A_inverse[] = {
        0x1.10e271cb7791ep+4, 0x1.5e6b4ea5290d6p+2, -0x1.9e5b54d0b7ccap+0, 0x1.7fd2aa7831099p-1, -0x1.b0044af93ef83p-2, 0x1.01134eaf5e426p-2, -0x1.7a2996fbbb1c3p-4,
        -0x1.9e5e1d8c35692p+3, 0x1.b033f129f053cp+1, 0x1.0374f50e39c6dp+2, -0x1.7c7f129e892cbp+0, 0x1.8bb394e2e532cp-1, -0x1.c7a02c2abc0aap-2, 0x1.4b5088ba15d6bp-3,
        0x1.a1b70c95575d5p+2, -0x1.ba633432bb25ap+2, 0x1.7bd6d6c033dd7p+0, 0x1.cc1bf674bd6fp+1, -0x1.7341546366556p+0, 0x1.88b9437c04588p-1, -0x1.15f15953c2b8ep-2,
        -0x1.30aaa65fb16ebp+2, 0x1.fed482ca90257p+1, -0x1.6a48b7b87a2f5p+2, 0x1.ca3adb68c00bdp-1, 0x1.de31f385d1d9ap+1, -0x1.8abf1a6795a2ap+0, 0x1.05ff338e6294bp-1,
        0x1.1515b9b786376p+2, -0x1.ad4067d2b6a47p+1, 0x1.d8662b1bb0d68p+1, -0x1.82634612c966dp+2, 0x1.4ccc751bd2ac9p-1, 0x1.24f27fa5d4d5dp+2, -0x1.3e7a7f13d9a8bp+0,
        -0x1.3c64553829083p+2, 0x1.da36f95dd5b12p+1, -0x1.df74077c39556p+1, 0x1.3206cf42c3b31p+2, -0x1.1911854bd811fp+3, 0x1.142d03e452014p-1, 0x1.5c6541966637cp+2,
        0x1.6fdac4dfd37d5p+3, -0x1.108bdb7756224p+3, 0x1.0c31688e961e8p+3, -0x1.4111f43a2e702p+3, 0x1.e305467242cd3p+3, -0x1.135ce90bc9f5bp+5, 0x1.9p+4};
    static constexpr double T[] = {
        0x1.404915594ff5bp-9, -0x1.44b423796b1ccp-10, 0x1.69d6f3976638bp-9, -0x1.09c251d158d33p-8, -0x1.2224a3e316d81p-8, 0x1.615cdded5bb91p-6, -0x1.1fd1e87d8734ep-7,
        -0x1.dbe161aec270ep-10, -0x1.179e73af3cd03p-14, -0x1.a186cc6484147p-9, 0x1.13c2e74335c5ep-7, 0x1.083ce38b117eap-8, -0x1.385fdcb5c18d7p-5, 0x1.60acbeb1e0799p-6,
        0x1.2dd0c5d07774fp-8, -0x1.344e18cac272cp-9, -0x1.b528d3f9b4dfbp-12, -0x1.188219b981005p-7, 0x1.c5b83bfac286p-8, 0x1.d6313419932dbp-5, -0x1.e21a8149adf6cp-5,
        0x1.24c84f75861c9p-6, 0x1.984c7172b55a2p-9, -0x1.9b82ad2c253c3p-6, -0x1.32252ceffcfe5p-5, -0x1.0df9cd7305315p-7, -0x1.390e05673870bp-5, 0x1.536dd24148f21p-3,
        0x1.0683c3ad482f3p-3, 0x1.a0a2c5e6ea782p-4, -0x1.854ded613adfp-4, 0x1.5fb7509be8d64p-8, -0x1.8bb245070754ap-3, -0x1.fe4f0cac5be13p-3, -0x1.1820faaf29e23p-2,
        0x1.0a45fab3ebcc8p-1, 0x1.0b23122b28b41p-1, -0x1.064a956df5512p-3, 0x1.0d9b23131c6f7p-1, -0x1.1a25b03d9d468p-2, 0x1.102bdcf5bd592p-1, -0x1.f1fe9d1a481ep-2,
        0x1p+0, 0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0};
    static constexpr double T_inverse[] = {
        0x1.c707d62ee24b7p+7, 0x1.4d4bc999d2eap+7, 0x1.5a1f04ce35ac3p+5, 0x1.cfc16a45f60dep+1, 0x1.c94d68af5b718p+1, -0x1.5f2cdae07fe1fp+1, 0x1.7392758f0ebd1p+0,
        -0x1.2b2fadf366499p+8, -0x1.e614dc93b471dp+7, -0x1.86378257c6165p+5, -0x1.04f3337537c1dp+1, 0x1.ac6e71a216dacp+0, -0x1.165e250234761p+0, 0x1.cdcad9a779fadp-1,
        0x1.744e56c68a22bp+6, -0x1.7e1b292a9dd8ep+4, -0x1.3a3b25d212a3fp+5, -0x1.cc71ff4ec2bd5p+3, 0x1.c1560ba4057bep+1, -0x1.37400f3fa8d28p+2, 0x1.1f8cbeff4fc49p+1,
        0x1.2ab69cb9b4fafp+6, 0x1.5da2652648b85p+6, 0x1.018bd116bd6c7p+2, -0x1.db7ec5f94a2b3p+1, -0x1.b70d51da000bp+1, 0x1.592a58ae16d32p+1, -0x1.e09c55d592e7bp-1,
        -0x1.d2da2bcc78274p+5, 0x1.42336571722f3p+3, 0x1.e5dcba8c07172p+4, 0x1.0520166134e55p+0, 0x1.cc764af9f9754p-4, -0x1.e4010999a0feap+0, 0x1.f17bee32b5008p-1,
        -0x1.80f2293c0d772p+1, -0x1.6081f9942d45ap+3, 0x1.7ce06cd71790ap+0, 0x1.10b08f288bdf3p+1, -0x1.d0ee9f4ccda7cp+0, 0x1.226329670693ap+0, -0x1.a8a6dde0091a8p-2,
        0x1.0e248ffbfbff9p+3, 0x1.4d11a61298d05p-1, -0x1.bc33f301cf8e3p+2, 0x1.9a3eff5048cb1p+1, -0x1.123f77c95c32ap+0, 0x1.6b5dfea9c0fdcp-2, -0x1.78c5c74f5ad34p-4};
};

template <>
struct radau_iia<8> {
    static constexpr stagecraft::facts facts{.order = 15,
                                             .stage_order = 8,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = false,
                                             .symmetric = false,
                                             .r_infinity = 0x0p+0};
    static constexpr double c[] = {
        0x1.704d6165a89bfp-6, 0x1.d5b9b3edcc19ap-4, 0x1.102b3511e0b6dp-2, 0x1.cfb6f5b416ffdp-2, 0x1.4b74c5e879b1dp-1, 0x1.a3b77df729cb6p-1, 0x1.e3318dbd0267fp-1, 0x1p+0};
    static constexpr double b[] = {
        0x1.d50731e6e289ep-5, 0x1.ff47661dd07f2p-4, 0x1.6357d8b9e9c93p-3, 0x1.90f84b54eddeep-3, 0x1.818dd0bf440e1p-3, 0x1.376e04758f7cdp-3, 0x1.7b9d0e6767d62p-4, 0x1p-6};
    static constexpr double A[] = {
        0x1.d7e7cca9addb2p-6, -0x1.629afb9c3c6d2p-7, 0x1.0867c377e38e8p-7, -0x1.a987b2bf65792p-8, 0x1.5b57eed634aa8p-8, -0x1.14c760d3e268bp-8, 0x1.92506be7a9a3ap-9, -0x1.40d137f89366fp-10,
        0x1.f94a116bff036p-5, 0x1.034f2676c3d7cp-4, -0x1.12b26767373b3p-6, 0x1.7182c67c8206ap-7, -0x1.18ffad18a763dp-7, 0x1.b100054d3198p-8, -0x1.3594812231c2ap-8, 0x1.eac0caeacf50cp-10,
        0x1.c4e63ac58f0bfp-5, 0x1.139a7ec1da1cep-3, 0x1.6bd9326278cefp-4, -0x1.4cf6af02c6b06p-6, 0x1.9de4b1ad06c55p-7, -0x1.25ee07a1028f4p-7, 0x1.95124f4c6191fp-8, -0x1.3cd8eee0d4e2p-9,
        0x1.dd99667e72a51p-5, 0x1.ed79fbff19831p-4, 0x1.7dc6c5b53dc7cp-3, 0x1.9f7603028e96ep-4, -0x1.5b474a953571ap-6, 0x1.915195482cf1fp-7, -0x1.ff176e359d78ep-8, 0x1.85560094131b6p-9,
        0x1.d056c9db8fc05p-5, 0x1.042f347e0377ep-3, 0x1.583eb72e5018bp-3, 0x1.ac723a8585d19p-3, 0x1.96451d1dcba92p-4, -0x1.3bce813d8a9dp-6, 0x1.49f6513602ef1p-7, -0x1.dab9205aceb26p-9,
        0x1.d7647c140e413p-5, 0x1.fad7d5ad7bf0ep-4, 0x1.68594995e9ac3p-3, 0x1.86cc89dbc8fa2p-3, 0x1.987cda77c891fp-3, 0x1.51a97c5502198p-4, -0x1.e2808a1c4903fp-7, 0x1.293151d5be00fp-8,
        0x1.d425e2bd31fd6p-5, 0x1.0073b5257592dp-3, 0x1.6192d140206f5p-3, 0x1.944e0517d3decp-3, 0x1.7b4fcab91db23p-3, 0x1.44db3cd132caap-3, 0x1.b803401f08231p-5, -0x1.98749957e8bfcp-8,
        0x1.d50731e6e289ep-5, 0x1.ff47661dd07f2p-4, 0x1.6357d8b9e9c93p-3, 0x1.90f84b54eddeep-3, 0x1.818dd0bf440e1p-3, 0x1.376e04758f7cdp-3, 0x1.7b9d0e6767d62p-4, 0x1p-6};
    static constexpr int pairs = 4;
    static constexpr double alpha[] = {
        0x1.456c1a082104bp+3, 0x1.2d00fe341acd4p+3, 0x1.ef46aaa6251f9p+2, 0x1.2bdf24e1633c8p+2};
    static constexpr double beta[] = {
        0x1.a63216c5db1c9p+0, 0x1.3e07a7f243d4fp+2, 0x1.0bde3e4761c51p+3, 0x1.8056a8ee879b4p+3};
    static constexpr double A_inverse[] = {
        0x1.63e1b0800d563p+4, 0x1.c5c7aa9d74351p+2, -0x1.0a5589728a88cp+1, 0x1.ea27e957075a3p-1, -0x1.14da6dd1ec8cbp-1, 0x1.5a9dbbe6c3df6p-2, -0x1.b4847c262642cp-3, 0x1.4831e3a503074p-4,
        -0x1.097544f000f9fp+4, 0x1.170a24debd13fp+2, 0x1.47fec472235d4p+2, -0x1.dd1bb2dae5708p+0, 0x1.f0cd3537f1526p-1, -0x1.2bc692ce575ccp-1, 0x1.72ffd77c1dfa6p-2, -0x1.15293f60f3046p-3,
        0x1.03c896e6b83fcp+3, -0x1.1172301dc2632p+3, 0x1.e19561f3c10ffp+0, 0x1.1670d09453b6cp+2, -0x1.bfc5e19e7857dp+0, 0x1.ecae720fad385p-1, -0x1.24eb8f59693dfp-1, 0x1.af8c72ea7ff2bp-3,
        -0x1.68f13b69445c1p+2, 0x1.2c4a0c66b7606p+2, -0x1.a46b09253d63ap+2, 0x1.1aa81493ffbbp+0, 0x1.0dd2d6b92c03fp+2, -0x1.c904a0b3fad13p+0, 0x1.f116ec6e7ff35p-1, -0x1.63c8746d8a76p-2,
        0x1.2f196df0cd323p+2, -0x1.d0e06a28936d3p+1, 0x1.f6956f0b2cf03p+1, -0x1.912791101d2bdp+2, 0x1.8b716604f403p-1, 0x1.2885593f637e1p+2, -0x1.f5f9d8d0c7b36p+0, 0x1.509062b647c6bp-1,
        -0x1.297269b326debp+2, 0x1.b7c026b48d281p+1, -0x1.b173fa6e2914dp+1, 0x1.0a4b20d6b502dp+2, -0x1.d0d8fdb513b56p+2, 0x1.38496ad56651bp-1, 0x1.779a30ad32d88p+2, -0x1.9c37640c2cdd4p+0,
        0x1.61ca42c8ba7dp+2, -0x1.010083636f423p+2, 0x1.e6c94ea2797b9p+1, -0x1.118e24b04427dp+2, 0x1.739d10a099938p+2, -0x1.62bdb9fd0e979p+3, 0x1.0f430b1e90af4p-1, 0x1.c5bcf33a69f45p+2,
        -0x1.a1f3adf8a8df6p+3, 0x1.2dae031f78222p+3, -0x1.19b6f17e1473ep+3, 0x1.33a4723edbdd1p+3, -0x1.877ed8c6b34cep+3, 0x1.31dd4d7cc12edp+4, -0x1.6478e606996f3p+5, 0x1.04p+5};
    static constexpr double T[] = {
        -0x1.5680a9f2f8ce9p-11, -0x1.e67ee64fbe8d2p-11, 0x1.a488be06146cfp-10, -0x1.db1747ef922b9p-12, -0x1.4331a0b785515p-13, 0x1.f71ea02fa8803p-9, -0x1.0f019d08163f5p-6, -0x1.3d102fbebf1cep-8,
        0x1.99b15f65b6154p-11, 0x1.a36e2bae9afb9p-11, -0x1.c49701c4a6f0dp-10, 0x1.320c8a4591a57p-10, -0x1.6636152d9438cp-10, -0x1.8220c1e32787p-8, 0x1.f2cd3f469db64p-6, 0x1.8263ab1c701a2p-8,
        -0x1.094c9bd0527b7p-11, -0x1.5cbc74c483882p-10, 0x1.078dee6941354p-11, -0x1.0567980c49256p-11, 0x1.7fe7249b959dap-8, 0x1.274a587c35538p-8, -0x1.b9765752df023p-5, 0x1.350ccdee8bec6p-11,
        0x1.84d35a48bfa8fp-9, -0x1.350ff19312b6cp-9, -0x1.a437d2d0ebd21p-8, -0x1.92f472905824dp-10, -0x1.0eeabf65f385ep-8, 0x1.6f20113d27a7ap-7, 0x1.80a9916442893p-4, -0x1.3bea836d4ebd6p-5,
        0x1.73ecbd31b50ffp-6, -0x1.01a9a3c7aefa1p-6, -0x1.7475067888e5dp-8, -0x1.295f5a718caa5p-5, -0x1.0047300b6233ep-4, -0x1.43e564e3cffb1p-7, -0x1.a5929cd5943bep-4, 0x1.7196a81ecaf34p-3,
        0x1.39cdcee083a2p-3, -0x1.7ceef2fdcde88p-5, 0x1.d364742ab9d1ep-4, -0x1.249f02a26279cp-3, 0x1.dd029aca7b613p-7, -0x1.fe0a8d99bc0acp-3, -0x1.d9471098791a6p-3, -0x1.7113844dbf71ap-2,
        0x1.1f9d14106863ep-1, -0x1.ada734b677d67p-5, 0x1.2208026c4bd46p-1, -0x1.4d38353a8cf8ep-3, 0x1.2755f4d6b3b23p-1, -0x1.2bdce0c6f38dbp-2, 0x1.30e990c04c5f1p-1, -0x1.eaffc08e6ca29p-2,
        0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0};
    static constexpr double T_inverse[] = {
        -0x1.81dff2fc73bacp+7, 0x1.055f9220910b9p+0, 0x1.2b0c83a431405p+6, 0x1.0d15526bd66f8p+5, -0x1.2061fc1ce9eebp-1, 0x1.f4a51b80d42d6p+2, -0x1.afc03feb8378cp+2, 0x1.b51e289e212cdp+1,
        -0x1.36c0cd87f2b3cp+10, -0x1.0bd1b80574258p+10, -0x1.3a4bd62aa8bf3p+8, -0x1.4c5c83fb22824p+5, -0x1.38c0a6d72f0e5p+3, 0x1.5055b4c9cd6bdp+2, -0x1.5379febdd70bdp+2, 0x1.315bcf737743ap+1,
        0x1.27eb96e60eb29p+8, 0x1.b242cf359a016p+3, -0x1.0043beb8ea30dp+7, -0x1.43b28c02824b2p+5, 0x1.afce1e527cb7cp-3, -0x1.683a3431b1a51p+1, 0x1.3c7e083b34cfdp+1, -0x1.73032472d3f3fp-1,
        0x1.199694d97ac7ap+9, 0x1.248e7f15588f7p+9, 0x1.1dbfbbf7e6d1fp+7, 0x1.304d97c444e41p+0, -0x1.4b76f3d1269a8p+3, 0x1.4a0f96558d4e4p+2, -0x1.8bb3875cf15a8p+2, 0x1.72e33bbb31dcfp+1,
        -0x1.c4abe780a4df6p+6, -0x1.4c1554733ed46p+4, 0x1.f6a8ae025f304p+5, 0x1.3197f3d296875p+2, -0x1.b6aa9ff967241p-3, -0x1.0897df48c2b7ap+2, 0x1.cdaf19dab9028p+1, -0x1.6d8b7d6a42063p+0,
        -0x1.69c455d9ae13bp+6, -0x1.33c50f7e393a1p+7, -0x1.b941c1435d0e8p+4, 0x1.e590d7ddf52f1p+3, 0x1.446f19560b224p+1, -0x1.8e24b0123d944p+0, -0x1.c6547a38935b3p-4, 0x1.f650f0b2f0436p-3,
        0x1.45eb8f0a8c54ep+3, 0x1.8a77ced9a30cp+2, -0x1.2ecae99c63b5bp+3, 0x1.06a3b1c590ab2p+1, 0x1.22191c86a489dp-1, -0x1.bf8110f9c51ap-1, 0x1.554d7704647cbp-1, -0x1.0cbd066259662p-2,
        0x1.59d071c0c2574p-3, 0x1.90ee1a51503c7p+3, 0x1.64d3329ae8963p+1, -0x1.4eb46a2a2c19ap+2, 0x1.891d763b3fc26p+1, -0x1.982697a554dc2p+0, 0x1.b0bbc7fe76224p-1, -0x1.2bfd7048080cep-2};
};

template <>
struct radau_iia<9> {
    static constexpr stagecraft::facts facts{.order = 17,
                                             .stage_order = 9,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = false,
                                             .symmetric = false,
                                             .r_infinity = 0x0p+0};
    static constexpr double c[] = {
        0x1.234e5e8559645p-6, 0x1.760fbe5484796p-4, 0x1.b6e75d3213ea2p-3, 0x1.7cdbc90cdcd1dp-2, 0x1.1722b58ae4089p-1, 0x1.6d254e30c357bp-1, 0x1.b615a03eb753p-1, 0x1.e925bcfb7a169p-1, 0x1p+0};
    static constexpr double b[] = {
        0x1.73910d7eb17cp-5, 0x1.9abbb000f6902p-4, 0x1.25428ddb74857p-3, 0x1.59cc7280df5b4p-3, 0x1.64a1ad93f55cp-3, 0x1.4472b1d9c8636p-3, 0x1.fa3e6cba755afp-4, 0x1.2e653af76a431p-4, 0x1.948b0fcd6e9ep-7};
    static constexpr double A[] = {
        0x1.755d6369649aap-6, -0x1.19771ee961b51p-7, 0x1.a6c64f573a78ap-8, -0x1.588eb1d2bdc54p-8, 0x1.1fa069adc4eedp-8, -0x1.de9276c99937fp-9, 0x1.816a696cb7f39p-9, -0x1.19b5ac7cef502p-9, 0x1.c247ffe9e9c81p-11,
        0x1.90a76908d7b7cp-5, 0x1.9f59e814f832dp-5, -0x1.bb25eacfe9c04p-7, 0x1.2dc5d396b11f8p-7, -0x1.d4f4f2ada9d8dp-8, 0x1.78a6cc9db91a9p-8, -0x1.29b3e552aedfep-8, 0x1.aefc65c64637p-9, -0x1.572a72d127ea7p-10,
        0x1.66573780f65bap-5, 0x1.bb9ac401cb6c4p-4, 0x1.2aadb4ef094f7p-4, -0x1.148f5624f6002p-6, 0x1.5ec44a0bbeefbp-7, -0x1.02ee54d9fe4aep-7, 0x1.88a720dfaa2d2p-8, -0x1.1666060ad7bap-8, 0x1.b7eaba240bc29p-10,
        0x1.7adfae4a8c6bbp-5, 0x1.8b8343c8ca9fbp-4, 0x1.3c00fe507d6fep-3, 0x1.6333d971633a8p-4, -0x1.2e4fc934ec308p-6, 0x1.69a634269ff46p-7, -0x1.f6e04ab10819p-8, 0x1.56a30f6402147p-8, -0x1.0ad9a9f88757fp-9,
        0x1.6f48a0dc02fe2p-5, 0x1.a30c81d8ed30ap-4, 0x1.1b11d8d4b1966p-3, 0x1.733a817b3b8a2p-3, 0x1.726a80d08baeap-4, -0x1.284e40ed35f58p-6, 0x1.4e0455d75c36cp-7, -0x1.a3c6857f08f7fp-8, 0x1.3e224f03c560bp-9,
        0x1.760959d2e5c2bp-5, 0x1.96198f94c6789p-4, 0x1.2a7d6ca3630fap-3, 0x1.4f26d47f919c8p-3, 0x1.7cd0840c1a784p-3, 0x1.567adba34d4b4p-4, -0x1.0307adacd0dbep-6, 0x1.0aac9c9570d64p-7, -0x1.7d7b24208280ep-9,
        0x1.724887721dfcep-5, 0x1.9d18c6c091a96p-4, 0x1.22b29c87a15b2p-3, 0x1.5e9895f7bc6b4p-3, 0x1.5bb7645808ccdp-3, 0x1.5796e6df290b4p-3, 0x1.12c1772a99106p-4, -0x1.8268663fe335p-7, 0x1.d912358bc1342p-9,
        0x1.740d56b7bd92fp-5, 0x1.99d8efc2142e2p-4, 0x1.263375f02270cp-3, 0x1.581a634f5413p-3, 0x1.678c67768aaeep-3, 0x1.3f414d0bd391ep-3, 0x1.07f98839a79a1p-3, 0x1.5eb4cf362da0fp-5, -0x1.43646d431d0bep-8,
        0x1.73910d7eb17cp-5, 0x1.9abbb000f6902p-4, 0x1.25428ddb74857p-3, 0x1.59cc7280df5b4p-3, 0x1.64a1ad93f55cp-3, 0x1.4472b1d9c8636p-3, 0x1.fa3e6cba755afp-4, 0x1.2e653af76a431p-4, 0x1.948b0fcd6e9ep-7};
    static constexpr int pairs = 4;
    static constexpr double gamma[] = {
        0x1.72cb9428c666bp+3};
    static constexpr double alpha[] = {
        0x1.681ac96341496p+3, 0x1.469ec98f7455dp+3, 0x1.08f61b0f9bb5cp+3, 0x1.3dd50fd296ef8p+2};
    static constexpr double beta[] = {
        0x1.a921afc0e1fc6p+1, 0x1.ab876cf556e08p+2, 0x1.446d713d71887p+3, 0x1.bbab81ee17db6p+3};
    static constexpr double A_inverse[] = {
        0x1.c1f226c95ccc3p+4, 0x1.1d774bf5eb66ep+3, -0x1.4d531ff6239fep+1, 0x1.30ef2b802209ep+0, -0x1.578248aa01f7ap-1, 0x1.b28783fb150d6p-2, -0x1.22d2c08a8763fp-2, 0x1.7c2cac53a4485p-3, -0x1.221a016ca44d6p-4,
        -0x1.4b9b96fd000b3p+4, 0x1.5e66fb8435063p+2, 0x1.95f097cf19339p+2, -0x1.254d638220893p+1, 0x1.3036c0c3004fp+0, -0x1.7253784364e47p-1, 0x1.e5ef48b2a4dbep-2, -0x1.3a65ca371990cp-2, 0x1.ddf816b17facdp-4,
        0x1.3e281dcd5decbp+3, -0x1.4d8d94c620b4ap+3, 0x1.2aa28b7677806p+1, 0x1.4eae6e326c676p+2, -0x1.0b77e3d99995bp+1, 0x1.27e296afbfe82p+0, -0x1.7332baf9207f7p-1, 0x1.d5eced053c495p-2, -0x1.62517eb4bf4e9p-3,
        -0x1.ac626c43ef648p+2, 0x1.62b598fcde1cp+2, -0x1.ec97004d1969p+2, 0x1.5826165356981p+0, 0x1.35d9db2912921p+2, -0x1.0662d65f2cbecp+1, 0x1.2a8a6f0bb2809p+0, -0x1.6a1094cc2e113p-1, 0x1.0cddbb42bcd3fp-2,
        0x1.56f11e88bad64p+2, -0x1.05739857285d6p+2, 0x1.17c1d7be04beep+2, -0x1.b863f4d1d5519p+2, 0x1.d5905d70a423cp-1, 0x1.3db6fd33cb8edp+2, -0x1.1545a4cbfe6f3p+1, 0x1.32fc0fd3b8e5dp+0, -0x1.baa43005eb7f2p-2,
        -0x1.37e3124ef114fp+2, 0x1.c9a35593d3e57p+1, -0x1.bcff638a0fa9fp+1, 0x1.0c1d7e1a4e0c4p+2, -0x1.c8d6c373d1e7ep+2, 0x1.66f543458ec4fp-1, 0x1.6a4657bb7ae6fp+2, -0x1.37b87dc135bp+1, 0x1.a4d327e75520dp-1,
        0x1.4101c073e8b65p+2, -0x1.cdbc276f52777p+1, 0x1.ad41cc7c6ac37p+1, -0x1.d520c079403f7p+1, 0x1.328e24ea048b9p+2, -0x1.168ec36f53a91p+3, 0x1.2b31850f19ecp-1, 0x1.d55d7fd5a4e79p+2, -0x1.0334da26304cep+1,
        -0x1.883281aff561cp+2, 0x1.1735b076fee3p+2, -0x1.fbe60bd8083c7p+1, 0x1.09e07340a2182p+2, -0x1.3d376a37968fp+2, 0x1.c0083282c0066p+2, -0x1.b6adf47ae3fbbp+3, 0x1.0bf5ca6ce6413p-1, 0x1.1e8ffffdd9f49p+3,
        0x1.d451c82967251p+3, -0x1.4c1e0d63d9794p+3, 0x1.2ba0ba3e9b275p+3, -0x1.34f57ae326f23p+3, 0x1.65e00d21faadbp+3, -0x1.d93e85084ca75p+3, 0x1.7b195e55f8f68p+4, -0x1.c06ccfb9a8751p+5, 0x1.48p+5};
    static constexpr double T[] = {
        0x1.008c1df193bbfp-11, -0x1.5245e628730eap-13, 0x1.23bedb78e7d16p-11, -0x1.b6199750b8f5dp-11, -0x1.0e67392139ca1p-11, 0x1.e140949c7a9f7p-10, -0x1.da22ef0c0aeb9p-10, 0x1.f92b9d09e0292p-8, 0x1.5d6572085587p-7,
        -0x1.1416c3de7d347p-11, 0x1.31d3502c984a1p-14, -0x1.5e30889e300dp-11, 0x1.4ce1283c63efbp-10, 0x1.ae8702186fd1ep-12, -0x1.2b956d1e04c0dp-9, 0x1.b9ed671f90eeep-9, -0x1.e228078024143p-7, -0x1.200a15f83f1c3p-6,
        0x1.4784f64ff4b7p-11, -0x1.87c3f2db578b4p-13, 0x1.2045dcf26d132p-11, -0x1.01a76413b3afbp-10, 0x1.1e20510dbcbd6p-14, 0x1.6ab8fe6ab49p-11, -0x1.520b4e89f3bcap-8, 0x1.cd7554f818816p-6, 0x1.97e3f1b287be6p-6,
        0x1.042928ce5c849p-12, -0x1.917275db79891p-12, -0x1.4f9ca90f73d78p-10, 0x1.8ef966e964886p-13, 0x1.9601de23cd054p-10, 0x1.4eea26d90ab83p-8, 0x1.6919b09013817p-9, -0x1.e2c328d643ccfp-5, -0x1.d2bfdb0f6d97cp-6,
        0x1.68f9fe5387365p-8, 0x1.5ad9df693f07cp-12, -0x1.6a9b4ba7b7f82p-8, -0x1.54f2d02207017p-7, -0x1.1d7a9eb6e29c6p-10, -0x1.0b3773b7ef412p-9, 0x1.4edb9bfebbdf6p-6, 0x1.fbd2ed6adb36ep-4, -0x1.4a66250e6a212p-9,
        0x1.24d10c7b7a2dfp-5, 0x1.78f341d60630bp-6, -0x1.0b793a345f51fp-5, -0x1.1eac72a9cc0abp-6, -0x1.9bca6b11feb7dp-5, -0x1.742ff804911cfp-4, -0x1.421b3e4c63728p-6, -0x1.658e5e4f4a6bfp-3, 0x1.69fe3dedcf18cp-3,
        0x1.80d31727af415p-3, 0x1.65e2e3c700ba6p-3, -0x1.7352823b61d86p-4, 0x1.0a9ec94b6073bp-3, -0x1.81c27c8db751ep-3, 0x1.0c245c354b2d8p-5, -0x1.353b2bb4b42dap-2, -0x1.931cda73fa753p-3, -0x1.c40af67373b38p-2,
        0x1.31354d4982a73p-1, 0x1.32727af2bfbb1p-1, -0x1.6e841e56cf6f8p-4, 0x1.3669c278d5f7p-1, -0x1.7d5ea3a4d5724p-3, 0x1.3e175b9438b18p-1, -0x1.34ed76e52357ap-2, 0x1.4cd25dce37505p-1, -0x1.dd2a59ebab858p-2,
        0x1p+0, 0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0};
    static constexpr double T_inverse[] = {
        0x1.06650ad17c997p+11, 0x1.ee0f40902d72cp+10, 0x1.55abec4b0c99dp+9, 0x1.ef50c32476ca9p+6, 0x1.8164bb847dcdap+4, -0x1.32ea4ada0f131p+2, 0x1.0091b03ad4cb6p+3, -0x1.c87f128596ce1p+2, 0x1.ab84d9ae50b2fp+1,
        -0x1.6fbcc86faacdep+11, -0x1.7583db9698e6p+11, -0x1.f9f8f3d7a66fdp+9, -0x1.1c67c8e1bf09ep+7, -0x1.51978a92d9fe7p+1, -0x1.945da84d8669dp-2, 0x1.af5c9ea7b2a19p+1, -0x1.a3eb7fd23db7ap+1, 0x1.e26c4c68e6585p+0,
        0x1.e901c5f264196p+9, 0x1.c0b738103c477p+7, -0x1.56f278631891ap+8, -0x1.55d2763ad08fdp+7, -0x1.45092c380eb4cp+4, -0x1.0591f1db9ba36p+4, 0x1.99623bdfe209cp+3, -0x1.856f9cd9cedf1p+3, 0x1.5c5ccf4b72166p+2,
        0x1.d34fa32d19e01p+9, 0x1.34e0750399b13p+10, 0x1.9802163629df3p+8, -0x1.010f98bc16f01p+3, -0x1.b61932ff2aa63p+4, 0x1.6ba8ef9abb26fp+2, -0x1.04247a1261cc1p+3, 0x1.c4523838745e3p+2, -0x1.6610105999937p+1,
        -0x1.7a23fa4c69b5cp+9, -0x1.da72808e4ca8dp+7, 0x1.300b09fb7ebf1p+8, 0x1.d64c75648fc5ep+6, 0x1.16f0c9c543e9p+3, -0x1.65865b657f522p+2, 0x1.a9eec12366fe2p+1, -0x1.278fc7a6902abp+2, 0x1.27164180675d1p+1,
        -0x1.616b08cef54a4p+6, -0x1.d59f9c06ffdcp+7, -0x1.62b033dae3b42p+6, 0x1.1152afe170ecap+5, 0x1.8415fc0543e7fp+1, 0x1.1ed9d8a2e6761p-2, -0x1.ae26d745ebbcap+1, 0x1.a46c337c5f1b4p+1, -0x1.62ff662715547p+0,
        0x1.82cecb599738ep+7, 0x1.8fe2bbe990db5p+6, -0x1.9266baef62413p+6, -0x1.87affb1bc1a56p+4, 0x1.72c24d4f0d6dp+2, 0x1.1f4290c01726ap+2, -0x1.ef07f0a47a4fap+1, 0x1.0e2d1e4a3fcc3p+1, -0x1.64d7c2f44f19p-1,
        -0x1.c34b9a826523ep+1, 0x1.65fa8d2551bccp+3, 0x1.2880bb38573b2p+3, -0x1.f08963a2e4f27p+2, 0x1.73254a62fcdb2p+1, -0x1.8b333e3010a4ep-1, 0x1.a2abff8da3b19p-4, 0x1.f6403c08df0a8p-5, -0x1.4acf1d67e85e4p-5,
        -0x1.5b92f7712d0e3p+3, -0x1.9e959f3a711a3p+3, 0x1.2d466fcdd1785p+3, 0x1.b785712a717fp+0, -0x1.b8ee206f4285p+1, 0x1.41ba00688b5d3p+1, -0x1.9cafc40f8d656p+0, 0x1.fba71356edd1p-1, -0x1.77a039a355ee4p-2};
};

}  // namespace coefficients

/// The S-stage member of this family, 1 <= S <= 9: every entry is the double nearest to the exact one; in another Scalar, float, that one rounded.
template <int S, class Scalar = double>
transformed_tableau<Scalar, (S > 0 ? S : -1)> radau_iia() {  // of a variable s: radau_iia(s) of stagecraft/families.hpp
    constexpr bool generated = 1 <= S && S <= 9;
    static_assert(generated, "radau_iia: generated for 1 <= S <= 9; see stagecraft/tableaux/rounded.hpp for more");
    transformed_tableau<Scalar, (S > 0 ? S : -1)> t;
    if constexpr (generated) coefficients::unpack<coefficients::radau_iia<S>>(t);
    return t;
}

/// A number of stages in parentheses is for stagecraft/families.hpp.
template <class Never = void>
transformed_tableau<double> radau_iia(...) {
    static_assert(detail::never<Never>, "the number of stages stands in angle brackets, radau_iia<3>(), or include stagecraft/families.hpp for radau_iia(3)");
    return {};
}

}  // namespace stagecraft
