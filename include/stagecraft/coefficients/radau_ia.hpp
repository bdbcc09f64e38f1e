// SPDX-License-Identifier: BSL-1.0 | written by: stagecraft coefficients radau_ia 6
// clang-format off
#pragma once

#include <stagecraft/coefficients/unpack.hpp>

namespace stagecraft {
namespace coefficients {

template <int S>
struct radau_ia;

template <>
struct radau_ia<1> {
    static constexpr stagecraft::facts facts{.order = 1,
                                             .stage_order = 0,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = false,
                                             .symmetric = false,
                                             .r_infinity = 0x0p+0};
    static constexpr double c[] = {
        0x0p+0};
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
struct radau_ia<2> {
    static constexpr stagecraft::facts facts{.order = 3,
                                             .stage_order = 1,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = false,
                                             .symmetric = false,
                                             .r_infinity = 0x0p+0};
    static constexpr double c[] = {
        0x0p+0, 0x1.5555555555555p-1};
    static constexpr double b[] = {
        0x1p-2, 0x1.8p-1};
    static constexpr double A[] = {
        0x1p-2, -0x1p-2,
        0x1p-2, 0x1.aaaaaaaaaaaabp-2};
    static constexpr int pairs = 1;
    static constexpr double alpha[] = {
        0x1p+1};
    static constexpr double beta[] = {
        0x1.6a09e667f3bcdp+0};
    static constexpr double A_inverse[] = {
        0x1.4p+1, 0x1.8p+0,
        -0x1.8p+0, 0x1.8p+0};
    static constexpr double T[] = {
        -0x1.5555555555555p-2, -0x1.e2b7dddfefa66p-1,
        0x1p+0, 0x0p+0};
    static constexpr double T_inverse[] = {
        0x0p+0, 0x1p+0,
        -0x1.0f876ccdf6cd9p+0, -0x1.6a09e667f3bcdp-2};
};

template <>
struct radau_ia<3> {
    static constexpr stagecraft::facts facts{.order = 5,
                                             .stage_order = 2,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = false,
                                             .symmetric = false,
                                             .r_infinity = 0x0p+0};
    static constexpr double c[] = {
        0x0p+0, 0x1.6b927eff8b241p-2, 0x1.b09d26e6a0d46p-1};
    static constexpr double b[] = {
        0x1.c71c71c71c71cp-4, 0x1.06648ace491e9p-1, 0x1.816fcdf1a6a67p-2};
    static constexpr double A[] = {
        0x1.c71c71c71c71cp-4, -0x1.8879abc79e49bp-3, 0x1.49d6e5c82021ap-4,
        0x1.c71c71c71c71cp-4, 0x1.2b154adc88802p-2, -0x1.8a4f427623c3cp-5,
        0x1.c71c71c71c71cp-4, 0x1.12f49921b1e13p-1, 0x1.9313fe302d93bp-3};
    static constexpr int pairs = 1;
    static constexpr double gamma[] = {
        0x1.d1a48d83e731dp+1};
    static constexpr double alpha[] = {
        0x1.572db93e0c672p+1};
    static constexpr double beta[] = {
        0x1.86747f2c3fcb5p+1};
    static constexpr double A_inverse[] = {
        0x1.4p+2, 0x1.36e52e105535bp+2, -0x1.b7297082a9ad9p-1,
        -0x1.a20bd700c2c3ep+0, 0x1.8cee3d7edbda3p-1, 0x1.b7297082a9ad9p-1,
        0x1.a20bd700c2c3ep+0, -0x1.36e52e105535bp+2, 0x1.9cc470a049097p+1};
    static constexpr double T[] = {
        0x1.b27a144093acfp-2, -0x1.4b5290e84f494p-2, 0x1.0b55a4dd0570bp-1,
        0x1.d7d0a68748284p-5, 0x1.9cb39b36bd386p-9, -0x1.cf499cda0fa02p-2,
        0x1p+0, 0x1p+0, 0x0p+0};
    static constexpr double T_inverse[] = {
        0x1.3bc8341753727p+0, 0x1.6c6fbf67e8107p+0, 0x1.941aad2bbd9d4p-2,
        -0x1.3bc8341753727p+0, -0x1.6c6fbf67e8107p+0, 0x1.35f2a96a21316p-1,
        0x1.30035a801431dp-3, -0x1.04fd2046d14cfp+1, 0x1.be0e3291eea37p-5};
};

template <>
struct radau_ia<4> {
    static constexpr stagecraft::facts facts{.order = 7,
                                             .stage_order = 3,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = false,
                                             .symmetric = false,
                                             .r_infinity = 0x0p+0};
    static constexpr double c[] = {
        0x0p+0, 0x1.b2df989ad14dep-3, 0x1.2e5a5bf0dcddcp-1, 0x1.d2a4995625aa4p-1};
    static constexpr double b[] = {
        0x1p-4, 0x1.50bc90bf28ab5p-2, 0x1.8d8296b4cf125p-2, 0x1.c381b1181084dp-3};
    static constexpr double A[] = {
        0x1p-4, -0x1.04937374bf046p-3, 0x1.9841bf10b3f46p-4, -0x1.1e35b04e6bd75p-5,
        0x1p-4, 0x1.832593fa5220ep-3, -0x1.cecd1a0129d07p-5, 0x1.1b6a59064d08fp-6,
        0x1p-4, 0x1.604a29bc2e297p-2, 0x1.a7b74b36b3769p-3, -0x1.7711775ce2945p-6,
        0x1p-4, 0x1.4af65a4f4e7ecp-2, 0x1.a69cb5ac5b0f2p-2, 0x1.ced88ac2871a4p-4};
    static constexpr int pairs = 2;
    static constexpr double alpha[] = {
        0x1.32615f2e64b48p+2, 0x1.9b3d41a33697p+1};
    static constexpr double beta[] = {
        0x1.9146226bd0f14p+0, 0x1.317a43b6b7cafp+2};
    static constexpr double A_inverse[] = {
        0x1.1p+3, 0x1.32ca4a36f9d78p+3, -0x1.59ab025fa97a4p+1, 0x1.3a07660f08713p-1,
        -0x1.281c15c57b6c1p+1, 0x1.45037830e6e77p-1, 0x1.092265aa7974cp+1, -0x1.92396f89be14dp-2,
        0x1.0fd540c0fb631p+0, -0x1.b00b3ca5ef6e4p+1, 0x1.389a02f13f52cp+0, 0x1.17a73599a426bp+0,
        -0x1.f67882ecdff8bp+0, 0x1.4d66f1cf03cafp+2, -0x1.1c80f0a8af8d9p+3, 0x1.6939103d934e6p+2};
    static constexpr double T[] = {
        -0x1.fd9feb76948aap-4, -0x1.672e1aa38e2c2p-3, 0x1.911f38352adc8p-2, -0x1.b88f2852bf6f5p-4,
        0x1.d4af602c262dp-5, 0x1.5a34971a6c312p-7, -0x1.aa42ef9b9482ep-3, 0x1.0d54e778e0953p-3,
        0x1.424d0c695a6b9p-3, -0x1.0d191d02a2575p-3, 0x1.0a5e7b443359dp-4, -0x1.be8640b48780cp-2,
        0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0};
    static constexpr double T_inverse[] = {
        -0x1.026a0fb23db4fp-1, 0x1.3dd1fa5b9ecbbp+1, 0x1.bf245606c4d93p-1, 0x1.50bf1f25d34c4p-1,
        -0x1.45e2713620ba6p+2, -0x1.2b7ff5c770771p+3, -0x1.9112049754cfdp+0, 0x1.3019f7489dcfcp-3,
        0x1.026a0fb23db4fp-1, -0x1.3dd1fa5b9ecbbp+1, -0x1.bf245606c4d93p-1, 0x1.5e81c1b459678p-2,
        0x1.6d6d649ef74eap+0, 0x1.ac4a61815225cp+1, -0x1.a2e1213001d6bp+0, 0x1.f309f0d40455fp-3};
};

template <>
struct radau_ia<5> {
    static constexpr stagecraft::facts facts{.order = 9,
                                             .stage_order = 4,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = false,
                                             .symmetric = false,
                                             .r_infinity = 0x0p+0};
    static constexpr double c[] = {
        0x0p+0, 0x1.1e3a6b7533109p-3, 0x1.aa67450ade35ep-2, 0x1.7241a1ec98aa9p-1, 0x1.e2c33d227292dp-1};
    static constexpr double b[] = {
        0x1.47ae147ae147bp-5, 0x1.c8eab2b61c94ap-3, 0x1.3f4f73b8d3267p-2, 0x1.201bca8e66374p-2, 0x1.26534b9cb85e2p-3};
    static constexpr double A[] = {
        0x1.47ae147ae147bp-5, -0x1.66e226cf72263p-4, 0x1.5d7664eab170ep-4, -0x1.c942feb38ffdp-5, 0x1.28d8dc04603fep-6,
        0x1.47ae147ae147bp-5, 0x1.07b19ee2f3ab4p-3, -0x1.84f0046bd759bp-5, 0x1.b6b6d1c115594p-6, -0x1.0fd91a9a5c153p-7,
        0x1.47ae147ae147bp-5, 0x1.dd63932ef9317p-3, 0x1.5736d75c3ae6dp-3, -0x1.0d615ea34771dp-5, 0x1.1a0f214a1de08p-7,
        0x1.47ae147ae147bp-5, 0x1.c107e42b18da8p-3, 0x1.534c13c6b174cp-2, 0x1.2b72b35cc0671p-3, -0x1.bf7bc8191d2c6p-7,
        0x1.47ae147ae147bp-5, 0x1.ccabba0699c54p-3, 0x1.37330f563b0ecp-2, 0x1.3447948071229p-2, 0x1.2b00db6e3fa2dp-4};
    static constexpr int pairs = 2;
    static constexpr double gamma[] = {
        0x1.92595ee3123e2p+2};
    static constexpr double alpha[] = {
        0x1.6cdc6b397464ep+2, 0x1.d3edcaaa04f82p+1};
    static constexpr double beta[] = {
        0x1.9ae9fbb266469p+1, 0x1.a2cc95da18518p+2};
    static constexpr double A_inverse[] = {
        0x1.ap+3, 0x1.f588defa734efp+3, -0x1.47d2c73093f84p+2, 0x1.edfea3300af13p+0, -0x1.ebe9f905561e8p-2,
        -0x1.a21d064111528p+1, 0x1.299760f060b19p-1, 0x1.c288890a6d19fp+1, -0x1.178c693de1eaap+0, 0x1.07a6cccbe80c3p-2,
        0x1.203aca50cb33cp+0, -0x1.db26eb36e2f3dp+1, 0x1.b6a9ef2aa91c1p-1, 0x1.11001c31ac216p+1, -0x1.9d088f6ec873cp-2,
        -0x1.fb5e08319253bp-1, 0x1.58669f18cdea2p+1, -0x1.3ee8541c46c82p+2, 0x1.ce5b1c16f92e6p+0, 0x1.7a27fa414f47ap+0,
        0x1.2bb45f31b4a61p+1, -0x1.815d41a53102cp+2, 0x1.1e36c04475736p+3, -0x1.c0a5beb9ba58ep+3, 0x1.1830877b703d6p+3};
    static constexpr double T[] = {
        0x1.89ffad11db0ap-4, -0x1.aecb34b9f447cp-6, 0x1.ee971d5c2e92cp-4, -0x1.0f7b333da78cfp-2, -0x1.dd57470051da4p-4,
        -0x1.6a8d880e057cap-6, -0x1.3dc0b290ae645p-7, -0x1.6d92491ea4c7fp-5, 0x1.374253b1fc877p-3, 0x1.280218cf4c436p-5,
        0x1.b55a3f23db386p-5, -0x1.17cf5c6ddd337p-8, -0x1.a356a1f516c5cp-6, -0x1.be2e2cf69464p-3, 0x1.00eb5c78e1ee6p-4,
        0x1.e2ce3183b083bp-3, 0x1.b836232b02614p-3, -0x1.a5d3decff1ef9p-3, 0x1.d809ea141b971p-4, -0x1.d8c8355b7e5d7p-2,
        0x1p+0, 0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0};
    static constexpr double T_inverse[] = {
        0x1.ed6286a377e15p+2, 0x1.1b9f42614a54fp+4, 0x1.30763c57b40efp+2, 0x1.6758c89498224p-4, 0x1.8112b4541288p-2,
        -0x1.264a7e9726a9ep+3, -0x1.793cbffe6d878p+4, -0x1.75a79eb57b84ep+1, 0x1.45b2e00a0f1f7p-4, 0x1.0000632c04315p-1,
        0x1.32cb812660b9bp+1, -0x1.32cafcbed8d91p+2, -0x1.602261f24c68bp+2, -0x1.ba465dfa8c517p+0, 0x1.7524335e696e1p-2,
        0x1.7cc9da2b55c9dp+0, 0x1.7675f6748cca3p+2, -0x1.d689b3f3d931fp+0, -0x1.5685d44f53a0ep-3, 0x1.fbb2154f94556p-4,
        -0x1.0b0f57172fc6bp+0, 0x1.ac6afc2b8d101p+0, 0x1.886b09a56f77ap+1, -0x1.5ae8ccf1507b6p+0, 0x1.2c33ae425f5ebp-2};
};

template <>
struct radau_ia<6> {
    static constexpr stagecraft::facts facts{.order = 11,
                                             .stage_order = 5,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = false,
                                             .symmetric = false,
                                             .r_infinity = 0x0p+0};
    static constexpr double c[] = {
        0x0p+0, 0x1.939986b03b729p-4, 0x1.37d836a9a38ffp-2, 0x1.1fc1c4030806p-1, 0x1.9a9dfc3c20998p-1, 0x1.eb9e0adbcf9e9p-1};
    static constexpr double b[] = {
        0x1.c71c71c71c71cp-6, 0x1.474fe7d6341f7p-3, 0x1.f10956d17c887p-3, 0x1.0ab6ea52d1c52p-2, 0x1.aae82ef21d169p-3, 0x1.9cda5f0f56522p-4};
    static constexpr double A[] = {
        0x1.c71c71c71c71cp-6, -0x1.031e73f42defcp-4, 0x1.18767a1cfab02p-4, -0x1.cd24e02fdc7aep-5, 0x1.156353144ccd5p-5, -0x1.59f2e06660304p-7,
        0x1.c71c71c71c71cp-6, 0x1.7a9870a1fa689p-4, -0x1.35754a704e699p-5, 0x1.b4cc22ec74329p-6, -0x1.f2108d50a22edp-7, 0x1.303a7c3985b8bp-8,
        0x1.c71c71c71c71cp-6, 0x1.55b49dd756073p-3, 0x1.0c4ce2c7962aep-3, -0x1.04a687baaa3aap-5, 0x1.ec70526185253p-7, -0x1.1a40977ecc831p-8,
        0x1.c71c71c71c71cp-6, 0x1.41cf7b9442e3p-3, 0x1.07b9209963913p-2, 0x1.172c268b8a369p-3, -0x1.691915e99a4d3p-6, 0x1.5b1827bb72f03p-8,
        0x1.c71c71c71c71cp-6, 0x1.4a221c2f3a5e6p-3, 0x1.e3fb7f023df28p-3, 0x1.1d8d0893f042p-2, 0x1.b62bf679a7b03p-4, -0x1.2b944de8dd522p-7,
        0x1.c71c71c71c71cp-6, 0x1.45ced8d1d2265p-3, 0x1.f7960557ad095p-3, 0x1.02bcd997a523dp-2, 0x1.ca5d9125f213cp-3, 0x1.a161eade7d844p-5};
    static constexpr int pairs = 3;
    static constexpr double alpha[] = {
        0x1.df669af31b5e2p+2, 0x1.9e1ceaae5a6a9p+2, 0x1.027c7a5e8a376p+2};
    static constexpr double beta[] = {
        0x1.9f1ac7d230678p+0, 0x1.399b95baa738fp+2, 0x1.0b0f2899eb86cp+3};
    static constexpr double A_inverse[] = {
        0x1.28p+4, 0x1.71cda755ddd1p+4, -0x1.03048c20bcca7p+3, 0x1.cd889bf3b40abp+1, -0x1.851c50a7ed6a6p+0, 0x1.955411a23a607p-2,
        -0x1.1d32d522a0227p+2, 0x1.1bfb7237e5efap-1, 0x1.5044fe2f52aa2p+2, -0x1.eb7b30dd81a1fp+0, 0x1.8593eeb6734cp-1, -0x1.8ca91e63a8d57p-3,
        0x1.5505eef42612ap+0, -0x1.1f0909f39a1ecp+2, 0x1.701973ffb33cap-1, 0x1.98adb5e61d4bep+1, -0x1.fcfb506e162aep-1, 0x1.e19dda29ca3e6p-3,
        -0x1.c1895bf6b8999p-1, 0x1.365b7d6bf6856p+1, -0x1.2e55e47204064p+2, 0x1.2441169321243p+0, 0x1.40dced87092dp+1, -0x1.e256b2d6d08c9p-2,
        0x1.05dcb30a753dp+0, -0x1.53f3a937f0d88p+1, 0x1.042a03f48e2dap+2, -0x1.bb64466343814p+2, 0x1.4335de19788ep+1, 0x1.f887eced50a69p+0,
        -0x1.5ebe1575351d5p+1, 0x1.bd10c669fb0d5p+2, -0x1.3c8a38645415dp+3, 0x1.ac854bf60c242p+3, -0x1.445e845696397p+4, 0x1.91e91743c4253p+3};
    static constexpr double T[] = {
        -0x1.0b25575d5469p-5, -0x1.32648318dc33dp-5, 0x1.0841846246ab6p-4, -0x1.6187b521fe8a7p-5, 0x1.b3f0c60f1f96bp-4, 0x1.87c2f7066945fp-3,
        0x1.80537d0fa25fcp-7, 0x1.3afe3d147cba1p-7, -0x1.4cebccdc6f239p-6, 0x1.86dbb53fd65cp-6, -0x1.080e8ce72a4ffp-4, -0x1.6bb6fb63fd51ep-4,
        -0x1.e09e64a3e7a99p-9, -0x1.a64d0a3027489p-7, -0x1.38df645826b74p-8, -0x1.a8c970dbdf76bp-7, 0x1.ca1a97703232bp-4, 0x1.401401cf6e1edp-4,
        0x1.75a0d8f4b9706p-5, -0x1.a572182046defp-6, -0x1.2585139117813p-5, -0x1.efec0ac69ec57p-5, -0x1.f45eb570d7b6cp-3, 0x1.d9381f1e4fb13p-7,
        0x1.295aff4da6f8ep-2, -0x1.513ca961f420dp-4, 0x1.0da668aa2c587p-2, -0x1.0b9fd88e5e0a3p-2, 0x1.57c0fe218acf4p-3, -0x1.fc7b4a6db7985p-2,
        0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0};
    static constexpr double T_inverse[] = {
        -0x1.54e72b0127761p+2, 0x1.48c2ea6390ac8p+1, 0x1.6893fac1f24dcp+3, 0x1.3d6d284e59c8bp+2, -0x1.30010b4e2a889p-1, 0x1.9140e504e40c4p-1,
        -0x1.32d021b29cb56p+5, -0x1.a94facf90c7d3p+6, -0x1.06e9eb3003113p+5, -0x1.8e06959bc50ep+1, -0x1.05bad89130912p+0, 0x1.422c0888d55f2p-2,
        0x1.c0d99411ef567p+2, -0x1.bfb804f20083bp+0, -0x1.10edfbada1cfdp+4, -0x1.898f6db1da6e2p+1, 0x1.ecc102951358cp-3, 0x1.07346eb3749d6p-2,
        0x1.d41633195df51p+3, 0x1.8c230b8ff3ebp+5, 0x1.269e252c5ce71p+3, -0x1.901029de66e62p+0, -0x1.d101fff4e0512p+0, 0x1.0eb849508f808p-1,
        -0x1.afc9a4431f817p+0, -0x1.a39b9faa41aaap-1, 0x1.728ff932a2a3ap+2, -0x1.e295c5d5b2468p+0, 0x1.69a19551cb64dp-2, -0x1.4db1c5e9e5afp-5,
        -0x1.4e4c29b05b0bcp+0, -0x1.044e6d2d4f583p+3, 0x1.a9df5c024ca19p-4, 0x1.f886eb7820c8ep+0, -0x1.fa23725d0c904p-1, 0x1.00639ee1d9e9cp-2};
};

}  // namespace coefficients

/// The S-stage member of this family, 1 <= S <= 6: every entry is the double nearest to the exact one; in another Scalar, float, that one rounded.
template <int S, class Scalar = double>
transformed_tableau<Scalar, (S > 0 ? S : -1)> radau_ia() {  // of a variable s: radau_ia(s) of stagecraft/families.hpp
    constexpr bool generated = 1 <= S && S <= 6;
    static_assert(generated, "radau_ia: generated for 1 <= S <= 6; see stagecraft/tableaux/rounded.hpp for more");
    transformed_tableau<Scalar, (S > 0 ? S : -1)> t;
    if constexpr (generated) coefficients::unpack<coefficients::radau_ia<S>>(t);
    return t;
}

/// A number of stages in parentheses is for stagecraft/families.hpp.
template <class Never = void>
transformed_tableau<double> radau_ia(...) {
    static_assert(detail::never<Never>, "the number of stages stands in angle brackets, radau_ia<3>(), or include stagecraft/families.hpp for radau_ia(3)");
    return {};
}

}  // namespace stagecraft
