// SPDX-License-Identifier: BSL-1.0 | written by: stagecraft coefficients tableaux/catalogue/heun_euler_2_1.json tableaux/catalogue/bogacki_shampine_3_2.json tableaux/catalogue/classical_rk4.json tableaux/catalogue/fehlberg_4_5.json tableaux/catalogue/cash_karp_5_4.json tableaux/catalogue/dormand_prince_5_4.json tableaux/catalogue/tsitouras_5_4.json tableaux/catalogue/bogacki_shampine_5_4.json tableaux/catalogue/verner_6_5.json tableaux/catalogue/prince_dormand_8_7.json tableaux/catalogue/dormand_prince_8_5_3.json
// clang-format off
#pragma once

#include <stagecraft/coefficients/unpack_one.hpp>

namespace stagecraft {
namespace coefficients {

struct heun_euler_2_1 {
    static constexpr int stages = 2, order = 2;
    static constexpr double c[] = {
        0x0p+0, 0x1p+0};
    static constexpr double A[] = {
        0x0p+0, 0x0p+0,
        0x1p+0, 0x0p+0};
    static constexpr double b[] = {
        0x1p-1, 0x1p-1};
    static constexpr double b_embedded[] = {
        0x1p+0, 0x0p+0};
};

struct bogacki_shampine_3_2 {
    static constexpr int stages = 4, order = 3;
    static constexpr double c[] = {
        0x0p+0, 0x1p-1, 0x1.8p-1, 0x1p+0};
    static constexpr double A[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1p-1, 0x0p+0, 0x0p+0, 0x0p+0,
        0x0p+0, 0x1.8p-1, 0x0p+0, 0x0p+0,
        0x1.c71c71c71c71cp-3, 0x1.5555555555555p-2, 0x1.c71c71c71c71cp-2, 0x0p+0};
    static constexpr double b[] = {
        0x1.c71c71c71c71cp-3, 0x1.5555555555555p-2, 0x1.c71c71c71c71cp-2, 0x0p+0};
    static constexpr double b_embedded[] = {
        0x1.2aaaaaaaaaaabp-2, 0x1p-2, 0x1.5555555555555p-2, 0x1p-3};
};

struct classical_rk4 {
    static constexpr int stages = 4, order = 4;
    static constexpr double c[] = {
        0x0p+0, 0x1p-1, 0x1p-1, 0x1p+0};
    static constexpr double A[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1p-1, 0x0p+0, 0x0p+0, 0x0p+0,
        0x0p+0, 0x1p-1, 0x0p+0, 0x0p+0,
        0x0p+0, 0x0p+0, 0x1p+0, 0x0p+0};
    static constexpr double b[] = {
        0x1.5555555555555p-3, 0x1.5555555555555p-2, 0x1.5555555555555p-2, 0x1.5555555555555p-3};
};

struct fehlberg_4_5 {
    static constexpr int stages = 6, order = 4;
    static constexpr double c[] = {
        0x0p+0, 0x1p-2, 0x1.8p-2, 0x1.d89d89d89d89ep-1, 0x1p+0, 0x1p-1};
    static constexpr double A[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1p-2, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.8p-4, 0x1.2p-2, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.c23e39189614cp-1, -0x1.a37b2a108bd3cp+1, 0x1.a912fe408db1p+1, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.0425ed097b426p+1, -0x1p+3, 0x1.cb1a72c69cb1ap+2, -0x1.a5ad296b4a5adp-3, 0x0p+0, 0x0p+0,
        -0x1.2f684bda12f68p-2, 0x1p+1, -0x1.61b58ba0961b6p+0, 0x1.cfd813f604fd8p-2, -0x1.199999999999ap-2, 0x0p+0};
    static constexpr double b[] = {
        0x1.da12f684bda13p-4, 0x0p+0, 0x1.190d13101190dp-1, 0x1.1216f485bd217p-1, -0x1.999999999999ap-3, 0x0p+0};
    static constexpr double b_embedded[] = {
        0x1.e573ac901e574p-4, 0x0p+0, 0x1.09b89459aa352p-1, 0x1.0323aaacfd498p-1, -0x1.70a3d70a3d70ap-3, 0x1.29e4129e4129ep-5};
};

struct cash_karp_5_4 {
    static constexpr int stages = 6, order = 5;
    static constexpr double c[] = {
        0x0p+0, 0x1.999999999999ap-3, 0x1.3333333333333p-2, 0x1.3333333333333p-1, 0x1p+0, 0x1.cp-1};
    static constexpr double A[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.999999999999ap-3, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.3333333333333p-4, 0x1.ccccccccccccdp-3, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.3333333333333p-2, -0x1.ccccccccccccdp-1, 0x1.3333333333333p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        -0x1.a12f684bda12fp-3, 0x1.4p+1, -0x1.4bda12f684bdap+1, 0x1.4bda12f684bdap+0, 0x0p+0, 0x0p+0,
        0x1.e3425ed097b42p-6, 0x1.5ep-2, 0x1.54bda12f684bep-5, 0x1.99f425ed097b4p-2, 0x1.fap-5, 0x0p+0};
    static constexpr double b[] = {
        0x1.90ee643b990eep-4, 0x0p+0, 0x1.9c3d02e2bb28p-2, 0x1.aef9f76166929p-3, 0x0p+0, 0x1.280a685dab4bp-2};
    static constexpr double b_embedded[] = {
        0x1.a284bda12f685p-4, 0x0p+0, 0x1.891f2747c9d1fp-2, 0x1.f4ed097b425edp-3, 0x1.3c92492492492p-6, 0x1p-2};
};

struct dormand_prince_5_4 {
    static constexpr int stages = 7, order = 5;
    static constexpr double c[] = {
        0x0p+0, 0x1.999999999999ap-3, 0x1.3333333333333p-2, 0x1.999999999999ap-1, 0x1.c71c71c71c71cp-1, 0x1p+0, 0x1p+0};
    static constexpr double A[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.999999999999ap-3, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.3333333333333p-4, 0x1.ccccccccccccdp-3, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.f49f49f49f49fp-1, -0x1.ddddddddddddep+1, 0x1.c71c71c71c71cp+1, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.79eec0fc37181p+1, -0x1.7310bd29520e4p+3, 0x1.3a552363c529p+3, -0x1.29c9eba1e3345p-2, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.6c52bf5a814bp+1, -0x1.583e0f83e0f84p+3, 0x1.1d016a3721e8bp+3, 0x1.1d1745d1745d1p-2, -0x1.1818970d9cc2fp-2, 0x0p+0, 0x0p+0,
        0x1.7555555555555p-4, 0x0p+0, 0x1.cc0499a5605fbp-2, 0x1.4d55555555555p-1, -0x1.4a1cfb2b78c13p-2, 0x1.0c30c30c30c31p-3, 0x0p+0};
    static constexpr double b[] = {
        0x1.7555555555555p-4, 0x0p+0, 0x1.cc0499a5605fbp-2, 0x1.4d55555555555p-1, -0x1.4a1cfb2b78c13p-2, 0x1.0c30c30c30c31p-3, 0x0p+0};
    static constexpr double b_embedded[] = {
        0x1.7048d159e26afp-4, 0x0p+0, 0x1.d05f703aa30fap-2, 0x1.3a66666666666p-1, -0x1.16075785e4908p-2, 0x1.6cbd323989ffp-4, 0x1.999999999999ap-6};
};

struct tsitouras_5_4 {
    static constexpr int stages = 7, order = 5;
    static constexpr double c[] = {
        0x0p+0, 0x1.49ba5e353f7cfp-3, 0x1.4ed916872b021p-2, 0x1.ccccccccccccdp-1, 0x1.f5c5e85edbf1dp-1, 0x1p+0, 0x1p+0};
    static constexpr double A[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.49ba5e353f7cfp-3, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        -0x1.15e4e4fe8123ep-7, 0x1.57883daf1f0b3p-2, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.72d5e94fe3235p+1, -0x1.9701343d4287bp+2, 0x1.172fd92eea8fap+2, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.54daf827440c7p+2, -0x1.77f6daaa052d3p+3, 0x1.dfb6eaa5e5f6ap+2, -0x1.7adc1b510a9a4p-4, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.772216029aa0ep+2, -0x1.9d7894a598ba8p+3, 0x1.05198ab50d56dp+3, -0x1.253648f20ef47p-4, -0x1.cf28fdbb9db09p-6, 0x0p+0, 0x0p+0,
        0x1.8b1a71ed4a6eep-4, 0x1.47ae147ae147bp-7, 0x1.eb683148e0688p-2, 0x1.6106b4b6adddbp+0, -0x1.a520ff752ea91p+1, 0x1.29901d4cd6786p+1, 0x0p+0};
    static constexpr double b[] = {
        0x1.8b1a71ed4a6eep-4, 0x1.47ae147ae147bp-7, 0x1.eb683148e0688p-2, 0x1.6106b4b6adddbp+0, -0x1.a520ff752ea91p+1, 0x1.29901d4cd6786p+1, 0x0p+0};
    static constexpr double b_embedded[] = {
        0x1.83cff7d9328f8p-4, 0x1.2ced54d406734p-7, 0x1.f37a1e0e25e09p-2, 0x1.3bfaece37faffp+0, -0x1.5a96517b13c84p+1, 0x1.dddb5c29d3aeap+0, 0x1.f07c1f07c1f08p-7};
};

struct bogacki_shampine_5_4 {
    static constexpr int stages = 8, order = 5;
    static constexpr double c[] = {
        0x0p+0, 0x1.5555555555555p-3, 0x1.c71c71c71c71cp-3, 0x1.b6db6db6db6dbp-2, 0x1.5555555555555p-1, 0x1.8p-1, 0x1p+0, 0x1p+0};
    static constexpr double A[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.5555555555555p-3, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.2f684bda12f68p-4, 0x1.2f684bda12f68p-3, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.112a8ad278e8ep-3, -0x1.e3a373af64c21p-2, 0x1.88f4cdfe81ddbp-1, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.d4e700dca8f16p-3, -0x1.745d1745d1746p-2, 0x1.2cc157b864407p-2, 0x1.03e974e4e1b2fp-1, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.b22e8ba2e8ba3p-6, 0x1.d745d1745d174p-3, 0x1.b9407292cc158p-4, 0x1.4820f09aac938p-3, 0x1.cdb3333333333p-3, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.73e9c415c80b2p-3, -0x1.8c5ea75b7e2b7p-2, 0x1.a6cab7fef5963p-2, 0x1.483003a15398fp-1, -0x1.031bdd7a106a8p+0, 0x1.29eb9efdcfc2p+0, 0x0p+0, 0x0p+0,
        0x1.2a28a28a28a29p-4, 0x0p+0, 0x1.2580dc62773cap-2, 0x1.8fa393d2d6c7p-3, 0x1.1b101767dce43p-7, 0x1.7031f5a617032p-2, 0x1.3c62eac0f533ep-4, 0x0p+0};
    static constexpr double b[] = {
        0x1.2a28a28a28a29p-4, 0x0p+0, 0x1.2580dc62773cap-2, 0x1.8fa393d2d6c7p-3, 0x1.1b101767dce43p-7, 0x1.7031f5a617032p-2, 0x1.3c62eac0f533ep-4, 0x0p+0};
    static constexpr double b_embedded[] = {
        0x1.33c23c23c23c2p-4, 0x0p+0, 0x1.1ae0d5c05df2ap-2, 0x1.b16949c7cfb03p-3, -0x1.530463796ac9ep-7, 0x1.7af95ebe57af9p-2, 0x1.3c62eac0f533ep-4, 0x0p+0};
};

struct verner_6_5 {
    static constexpr int stages = 8, order = 6;
    static constexpr double c[] = {
        0x0p+0, 0x1.5555555555555p-3, 0x1.1111111111111p-2, 0x1.5555555555555p-1, 0x1.aaaaaaaaaaaabp-1, 0x1p+0, 0x1.1111111111111p-4, 0x1p+0};
    static constexpr double A[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.5555555555555p-3, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.b4e81b4e81b4fp-5, 0x1.b4e81b4e81b4fp-3, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.aaaaaaaaaaaabp-1, -0x1.5555555555555p+1, 0x1.4p+1, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        -0x1.4ap+1, 0x1.2555555555555p+3, -0x1.a9p+2, 0x1.c555555555555p-1, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.3333333333333p+1, -0x1p+3, 0x1.a3de8933de893p+2, -0x1.38e38e38e38e4p-2, 0x1.6161616161616p-2, 0x0p+0, 0x0p+0, 0x0p+0,
        -0x1.1a0b321b94696p-1, 0x1.a740da740da74p+0, -0x1.e424242424242p-1, -0x1.4bc6a7ef9db23p-2, 0x1.decc5dc638e91p-3, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.048a1ef548a1fp+1, -0x1.be82fa0be82fap+2, 0x1.697bc7305e02cp+2, -0x1.195b81dfce9bbp-3, 0x1.252c6bd6be27p-2, 0x0p+0, 0x1.2747164f0dcbbp-3, 0x0p+0};
    static constexpr double b[] = {
        0x1.3333333333333p-4, 0x0p+0, 0x1.8f497803a68f5p-2, 0x1.471c71c71c71cp-2, 0x1.148efe4c35f33p-3, 0x0p+0, 0x1.6158dde6e99p-7, 0x1.1dec0d4c77b03p-4};
    static constexpr double b_embedded[] = {
        0x1.4cccccccccccdp-4, 0x0p+0, 0x1.966ac7df24f67p-2, 0x1.4p-2, 0x1.2121212121212p-3, 0x1.1745d1745d174p-4, 0x0p+0, 0x0p+0};
};

struct prince_dormand_8_7 {
    static constexpr int stages = 13, order = 8;
    static constexpr double c[] = {
        0x0p+0, 0x1.c71c71c71c71cp-5, 0x1.5555555555555p-4, 0x1p-3, 0x1.4p-2, 0x1.8p-2, 0x1.2e147ae147ae1p-3, 0x1.dc28f5c28f5c3p-2, 0x1.21360b60a7777p-1, 0x1.4cccccccccccdp-1, 0x1.d96c8c31039dbp-1, 0x1p+0, 0x1p+0};
    static constexpr double A[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.c71c71c71c71cp-5, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.5555555555555p-6, 0x1p-4, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1p-5, 0x0p+0, 0x1.8p-4, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.4p-2, 0x0p+0, -0x1.2cp+0, 0x1.2cp+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.3333333333333p-5, 0x0p+0, 0x0p+0, 0x1.8p-3, 0x1.3333333333333p-3, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.887ad701404aap-5, 0x0p+0, 0x0p+0, 0x1.cbc54e6660e1fp-4, -0x1.a1e28caf3b662p-6, 0x1.a4f6f83ae9738p-7, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.152f31366e4ddp-6, 0x0p+0, 0x0p+0, 0x1.8d28195fa13c2p-2, 0x1.26ba035d10b69p-5, 0x1.93651ea2bd3c5p-3, -0x1.61b7ccdaf2f36p-3, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.1b04260f85fe2p-4, 0x0p+0, 0x0p+0, -0x1.44bc269b358dep-1, -0x1.4a21f44e45fd4p-3, 0x1.1bf4b185a5c0dp-3, 0x1.e1c165324ef0bp-1, 0x1.b16e62e7158fdp-3, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.77ecbb1301621p-3, 0x0p+0, 0x0p+0, -0x1.3c0097b3c5a32p+1, -0x1.2a471c23b2d2ap-2, -0x1.b1bbe5082a5c8p-6, 0x1.6c85fb0a3e9bfp+1, 0x1.20240028afd67p-2, 0x1.fadbee9f5b0f7p-4, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        -0x1.372614b1764cfp+0, 0x0p+0, 0x0p+0, 0x1.0ac3014df3e48p+4, 0x1.d4dc1ce9424acp-1, -0x1.839f6df39ea9cp+2, -0x1.000ea32f607acp+4, 0x1.db2d7daa814a6p+3, -0x1.abe3f2cbe1d36p+3, 0x1.489672d167d27p+2, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.0912d609427e1p-2, 0x0p+0, 0x0p+0, -0x1.31912cd3f927p+2, -0x1.bd8905e38fcd7p-2, -0x1.865578467943fp+1, 0x1.64fca455cea0cp+2, 0x1.89f9250f88c23p+2, -0x1.43f985843ddf3p+2, 0x1.18d292a5d3212p+1, 0x1.13b7d81af1342p-3, 0x0p+0, 0x0p+0,
        0x1.a5153af7727fdp-1, 0x0p+0, 0x0p+0, -0x1.7513d9f0583c5p+3, -0x1.83e70bcbd3e65p-1, 0x1.6d8df236b4d36p-1, 0x1.826cbfaa51862p+3, -0x1.10572243a9883p+1, 0x1.fd7b8854e12f5p+0, -0x1.dfd195e96a442p-3, 0x1.683d837559249p-3, 0x0p+0, 0x0p+0};
    static constexpr double b[] = {
        0x1.55fed5a492d1p-5, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, -0x1.c643f63bea073p-5, 0x1.ea1cd5438b4fp-3, 0x1.68328ceaf3204p-1, -0x1.84ff364c4f34cp-1, 0x1.5235514d8405cp-1, 0x1.43f7cc8023f21p-3, -0x1.e7a5f94e7938dp-3, 0x1p-2};
    static constexpr double b_embedded[] = {
        0x1.e433298ed3291p-6, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, -0x1.a83f14f58d042p-1, 0x1.3eb5ef3b96b09p-2, 0x1.3bd1f79ac8e22p+1, -0x1.46022f1dbd988p+1, 0x1.718c66651430cp+0, 0x1.454949b1a0f2dp-4, 0x1.6c16c16c16c17p-5, 0x0p+0};
};

struct dormand_prince_8_5_3 {
    static constexpr int stages = 12, order = 8;
    static constexpr double c[] = {
        0x0p+0, 0x1.aee6838dae63ap-5, 0x1.432ce2aa42cacp-4, 0x1.e4c353ff64302p-4, 0x1.2068c499c08d9p-2, 0x1.5555555555555p-2, 0x1p-2, 0x1.3b13b13b13b14p-2, 0x1.4d74d74d74d75p-1, 0x1.3333333333333p-1, 0x1.b6db6db6db6dbp-1, 0x1p+0};
    static constexpr double A[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.aee6838dae63ap-5, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.432ce2aa42cacp-6, 0x1.e4c353ff64302p-5, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.e4c353ff64302p-6, 0x0p+0, 0x1.6b927eff8b241p-4, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.ee50d7ecde9fap-3, 0x0p+0, -0x1.c4e3ab5ad1507p-1, 0x1.d983d7ac79ef5p-1, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.2f684bda12f68p-5, 0x0p+0, 0x0p+0, 0x1.5ddb63bdb6d36p-3, 0x1.00f533f66f19ap-3, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.3p-5, 0x0p+0, 0x0p+0, 0x1.5cad30f3347edp-3, 0x1.ed4b3c332e04dp-5, -0x1.2p-6, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.2fdb8fee78792p-5, 0x0p+0, 0x0p+0, 0x1.5cf23f6595d72p-3, 0x1.b758640dea698p-4, -0x1.f5fcc20fcd32fp-7, 0x1.0f1d92efb0b71p-7, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.3f8b78b985813p-1, 0x0p+0, 0x0p+0, -0x1.ae31bacc6bc8ap+1, -0x1.bc873f08e11f9p-1, 0x1.b9793d88d1855p+4, 0x1.42770f892ad69p+4, -0x1.5beb4865c42f9p+5, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.e9205e321b655p-2, 0x0p+0, 0x0p+0, -0x1.3e7a8a34bd27fp+1, -0x1.2e3a9968c93c8p-1, 0x1.53ae4a6d655eep+4, 0x1.e8ef7b5f258b8p+3, -0x1.0a4e418d711b9p+5, -0x1.4d1b3d9b4a876p-6, 0x0p+0, 0x0p+0, 0x0p+0,
        -0x1.dfd121f1d399bp-1, 0x0p+0, 0x0p+0, 0x1.4bed869fb0b9dp+2, 0x1.1768702792ea9p+0, -0x1.04cb0e2110c1cp+3, -0x1.2852305e975a8p+4, 0x1.6bd4f06cb863ap+4, 0x1.3f2e777cf109dp+1, -0x1.85fc60d2b572cp+1, 0x0p+0, 0x0p+0,
        0x1.22fbd3b09fcdcp+1, 0x0p+0, 0x0p+0, -0x1.511a963cafe55p+3, -0x1.001c935ac72acp+1, -0x1.1f57c8eff3006p+4, 0x1.bf2ea18b58a01p+4, -0x1.6df3a7d1cec13p+1, -0x1.1bee71a9f33a9p+3, 0x1.8b89c42c81861p+3, 0x1.496ac6253e202p-1, 0x0p+0};
    static constexpr double b[] = {
        0x1.bcc6368d1177cp-5, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x1.1cd1ed2ad5ae2p+2, 0x1.e43a845d5ab9fp+0, -0x1.7346ecf96af43p+2, 0x1.3ea1df2f0eb98p-2, -0x1.37a028f43b002p-3, 0x1.9c657697fe72dp-3, 0x1.6e44f50ab6bc2p-5};
    static constexpr double b_embedded[] = {
        0x1.514b7c078f7f5p-5, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x1.6b3ae3c040853p+2, 0x1.319249ac6a71ep+1, -0x1.ddcc14d921885p+2, 0x1.52af3d1ffb505p-1, -0x1.f2032181a118ap-2, 0x1.e93c37e5cba25p-4, 0x1.12b3b7c8090d2p-4};
};

}  // namespace coefficients

/// Heun-Euler 2(1) (E. Fehlberg, Computing 6 (1970) 61-71; Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 2nd ed., Springer 1993, sect. II.4), order 2(1), proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
tableau<Scalar, 2> heun_euler_2_1() {
    return coefficients::unpack_one<tableau<Scalar, 2>, coefficients::heun_euler_2_1>();
}

/// Bogacki-Shampine 3(2) (P. Bogacki, L. F. Shampine, Appl. Math. Lett. 2 (1989) 321-325), order 3(2), proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
tableau<Scalar, 4> bogacki_shampine_3_2() {
    return coefficients::unpack_one<tableau<Scalar, 4>, coefficients::bogacki_shampine_3_2>();
}

/// The Runge-Kutta method of order 4 (RK4) (W. Kutta, Z. Math. Phys. 46 (1901) 435-453; Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 2nd ed., Springer 1993, sect. II.1), order 4, proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
tableau<Scalar, 4> classical_rk4() {
    return coefficients::unpack_one<tableau<Scalar, 4>, coefficients::classical_rk4>();
}

/// Fehlberg 4(5) (E. Fehlberg, NASA TR R-315 (1969), table III, formula 2; Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 2nd ed., Springer 1993, sect. II.5), order 4(5), proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
tableau<Scalar, 6> fehlberg_4_5() {
    return coefficients::unpack_one<tableau<Scalar, 6>, coefficients::fehlberg_4_5>();
}

/// Cash-Karp 5(4) (J. R. Cash, A. H. Karp, ACM Trans. Math. Software 16 (1990) 201-222), order 5(4), proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
tableau<Scalar, 6> cash_karp_5_4() {
    return coefficients::unpack_one<tableau<Scalar, 6>, coefficients::cash_karp_5_4>();
}

/// Dormand-Prince 5(4) (J. R. Dormand, P. J. Prince, J. Comput. Appl. Math. 6 (1980) 19-26, RK5(4)7M; Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 2nd ed., Springer 1993, sect. II.5 (DOPRI5)), order 5(4), proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
tableau<Scalar, 7> dormand_prince_5_4() {
    return coefficients::unpack_one<tableau<Scalar, 7>, coefficients::dormand_prince_5_4>();
}

/// Tsitouras 5(4) (C. Tsitouras, Comput. Math. Appl. 62 (2011) 770-775), order 5(4), up to the digits published: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
tableau<Scalar, 7> tsitouras_5_4() {
    return coefficients::unpack_one<tableau<Scalar, 7>, coefficients::tsitouras_5_4>();
}

/// Bogacki-Shampine 5(4) (P. Bogacki, L. F. Shampine, Comput. Math. Appl. 32 (1996) no. 6, 15-28), order 5(4), proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
tableau<Scalar, 8> bogacki_shampine_5_4() {
    return coefficients::unpack_one<tableau<Scalar, 8>, coefficients::bogacki_shampine_5_4>();
}

/// Verner 6(5) (DVERK) (J. H. Verner, SIAM J. Numer. Anal. 15 (1978) 772-790; Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 2nd ed., Springer 1993, sect. II.5), order 6(5), proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
tableau<Scalar, 8> verner_6_5() {
    return coefficients::unpack_one<tableau<Scalar, 8>, coefficients::verner_6_5>();
}

/// Prince-Dormand 8(7) (RK8(7)13M) (P. J. Prince, J. R. Dormand, J. Comput. Appl. Math. 7 (1981) 67-75; Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 2nd ed., Springer 1993, sect. II.5), order 8(7), up to the digits published: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
tableau<Scalar, 13> prince_dormand_8_7() {
    return coefficients::unpack_one<tableau<Scalar, 13>, coefficients::prince_dormand_8_7>();
}

/// Dormand-Prince 8(5,3) (DOP853) (Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 2nd ed., Springer 1993, sect. II.5 and II.10; coefficients of the code DOP853), order 8(5), up to the digits published: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
tableau<Scalar, 12> dormand_prince_8_5_3() {
    return coefficients::unpack_one<tableau<Scalar, 12>, coefficients::dormand_prince_8_5_3>();
}

}  // namespace stagecraft
