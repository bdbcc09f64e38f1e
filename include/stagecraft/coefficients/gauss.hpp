// SPDX-License-Identifier: BSL-1.0 | written by: stagecraft coefficients gauss 9
// clang-format off
#pragma once

#include <stagecraft/coefficients/unpack.hpp>

namespace stagecraft {
namespace coefficients {

template <int S>
struct gauss;

template <>
struct gauss<1> {
    static constexpr stagecraft::facts facts{.order = 2,
                                             .stage_order = 1,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = true,
                                             .symmetric = true,
                                             .r_infinity = -0x1p+0};
    static constexpr double c[] = {
        0x1p-1};
    static constexpr double b[] = {
        0x1p+0};
    static constexpr double A[] = {
        0x1p-1};
    static constexpr int pairs = 0;
    static constexpr double gamma[] = {
        0x1p+1};
    static constexpr double A_inverse[] = {
        0x1p+1};
    static constexpr double T[] = {
        0x1p+0};
    static constexpr double T_inverse[] = {
        0x1p+0};
};

template <>
struct gauss<2> {
    static constexpr stagecraft::facts facts{.order = 4,
                                             .stage_order = 2,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = true,
                                             .symmetric = true,
                                             .r_infinity = 0x1p+0};
    static constexpr double c[] = {
        0x1.b0cb174df99c7p-3, 0x1.93cd3a2c8198ep-1};
    static constexpr double b[] = {
        0x1p-1, 0x1p-1};
    static constexpr double A[] = {
        0x1p-2, -0x1.3cd3a2c8198e2p-5,
        0x1.13cd3a2c8198ep-1, 0x1p-2};
    static constexpr int pairs = 1;
    static constexpr double alpha[] = {
        0x1.8p+1};
    static constexpr double beta[] = {
        0x1.bb67ae8584caap+0};
    static constexpr double A_inverse[] = {
        0x1.8p+1, 0x1.db3d742c26554p-2,
        -0x1.9db3d742c2655p+2, 0x1.8p+1};
    static constexpr double T[] = {
        0x0p+0, -0x1.126145e9ecd56p-2,
        0x1p+0, 0x0p+0};
    static constexpr double T_inverse[] = {
        0x0p+0, 0x1p+0,
        -0x1.ddb3d742c2655p+1, 0x0p+0};
};

template <>
struct gauss<3> {
    static constexpr stagecraft::facts facts{.order = 6,
                                             .stage_order = 3,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = true,
                                             .symmetric = true,
                                             .r_infinity = -0x1p+0};
    static constexpr double c[] = {
        0x1.cda042f0236e1p-4, 0x1p-1, 0x1.c64bf7a1fb924p-1};
    static constexpr double b[] = {
        0x1.1c71c71c71c72p-2, 0x1.c71c71c71c71cp-2, 0x1.1c71c71c71c72p-2};
    static constexpr double A[] = {
        0x1.1c71c71c71c72p-3, -0x1.26b88a4e09a62p-5, 0x1.40c7cef225974p-7,
        0x1.337831ea8a881p-2, 0x1.c71c71c71c71cp-3, -0x1.7066ace18c0fbp-6,
        0x1.126b88a4e09a6p-2, 0x1.ebf38310dda69p-2, 0x1.1c71c71c71c72p-3};
    static constexpr int pairs = 1;
    static constexpr double gamma[] = {
        0x1.293d5ea4af41fp+2};
    static constexpr double alpha[] = {
        0x1.d6c2a15b50be1p+1};
    static constexpr double beta[] = {
        0x1.c11f1c4eff056p+1};
    static constexpr double A_inverse[] = {
        0x1.4p+2, 0x1.29fa72e28d245p+0, -0x1.4fd3971469224p-3,
        -0x1.6e8f21f3660dbp+2, 0x1p+1, 0x1.74790f9b306d6p-1,
        0x1.453f4e5c51a49p+3, -0x1.253f4e5c51a49p+3, 0x1.4p+2};
    static constexpr double T[] = {
        0x1.2788b34ec442ap-4, -0x1.50dc2e3b25062p-4, 0x1.ec8253c5cd298p-5,
        0x1.e6bcfd764a45ep-4, 0x1.b2b58fa97c528p-5, -0x1.43cb41c5c5d64p-2,
        0x1p+0, 0x1p+0, 0x0p+0};
    static constexpr double T_inverse[] = {
        0x1.7f77fb3e94137p+2, 0x1.23a38c4cd45fp+0, 0x1.bab006d97718p-2,
        -0x1.7f77fb3e94137p+2, -0x1.23a38c4cd45fp+0, 0x1.22a7fc934474p-1,
        0x1.3f07d545e4daep+0, -0x1.7678bd0d72584p+1, 0x1.07ebbc91fd4e9p-2};
};

template <>
struct gauss<4> {
    static constexpr stagecraft::facts facts{.order = 8,
                                             .stage_order = 4,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = true,
                                             .symmetric = true,
                                             .r_infinity = 0x1p+0};
    static constexpr double c[] = {
        0x1.1c6490c2719ecp-4, 0x1.51ee013116102p-2, 0x1.5708ff6774f7fp-1, 0x1.dc736de7b1cc3p-1};
    static constexpr double b[] = {
        0x1.64340f7e7b66bp-3, 0x1.4de5f840c24cap-2, 0x1.4de5f840c24cap-2, 0x1.64340f7e7b66bp-3};
    static constexpr double A[] = {
        0x1.64340f7e7b66bp-4, -0x1.b3e204d9b9c89p-6, 0x1.9dc6d5a4276fbp-7, -0x1.d1fb07440878dp-9,
        0x1.81441253937e8p-3, 0x1.4de5f840c24cap-3, -0x1.c8cafe42f2e69p-6, 0x1.b96af2c6963cbp-8,
        0x1.5668b7e846b4dp-3, 0x1.6a72a824f17b1p-2, 0x1.4de5f840c24cap-3, -0x1.d1002d51817d2p-7,
        0x1.6b7bfb9b8b889p-3, 0x1.40f7c193a1113p-2, 0x1.6924188e5de93p-2, 0x1.64340f7e7b66bp-4};
    static constexpr int pairs = 2;
    static constexpr double alpha[] = {
        0x1.72b7076eb891ap+2, 0x1.0d48f891476e6p+2};
    static constexpr double beta[] = {
        0x1.bc061c9b7f5bp+0, 0x1.5426463ec99d4p+2};
    static constexpr double A_inverse[] = {
        0x1.ef456e91b52c7p+2, 0x1.05c57f66b8c03p+1, -0x1.bf8f7d094e44fp-2, 0x1.62e4d7f57221cp-4,
        -0x1.cce2c55c45715p+2, 0x1.217522dc95a71p+1, 0x1.72e361215ac0cp+0, -0x1.dd755947261bcp-3,
        0x1.95fde80bcb15fp+2, -0x1.7e2dfb24ec574p+2, 0x1.217522dc95a71p+1, 0x1.1742206ace30fp+0,
        -0x1.f20b3841a010cp+3, 0x1.7c91af7ed4ce5p+3, -0x1.b0069370388c3p+3, 0x1.ef456e91b52c7p+2};
    static constexpr double T[] = {
        -0x1.946a2f3b6c72cp-7, -0x1.80f937d2bd47fp-6, 0x1.93698673ce95ep-5, 0x1.8b72bfa448f1p-8,
        0x1.d35b4c13b3bcp-6, -0x1.8a8eac17e92p-7, -0x1.f51dbefe2b6d5p-4, 0x1.4255622712429p-5,
        0x1.77d3a6a644b36p-3, -0x1.cab6d9b1bb217p-4, 0x1.8d51950cc90b1p-4, -0x1.76bf1ce645fddp-2,
        0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0};
    static constexpr double T_inverse[] = {
        -0x1.17d17b33c260cp+2, 0x1.267a219113a2bp+2, 0x1.b0c334f9bc534p-2, 0x1.7976dfbadbe46p-1,
        -0x1.d144fb5f5555bp+4, -0x1.5d83834fc6e6cp+3, -0x1.a75f6f9cff9a8p+0, 0x1.064e4468645e2p-2,
        0x1.17d17b33c260cp+2, -0x1.267a219113a2bp+2, -0x1.b0c334f9bc534p-2, 0x1.0d12408a48375p-2,
        0x1.f7603e6d793f9p+2, 0x1.1b85f054c3906p+2, -0x1.1031ed69116ffp+1, 0x1.719a26325a85ap-2};
};

template <>
struct gauss<5> {
    static constexpr stagecraft::facts facts{.order = 10,
                                             .stage_order = 5,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = true,
                                             .symmetric = true,
                                             .r_infinity = -0x1p+0};
    static constexpr double c[] = {
        0x1.80498fd662cb6p-5, 0x1.d89b804cc91f6p-3, 0x1p-1, 0x1.89d91feccdb82p-1, 0x1.e7fb670299d35p-1};
    static constexpr double b[] = {
        0x1.e539ec36e038cp-4, 0x1.ea1da25ae415bp-3, 0x1.23456789abcdfp-2, 0x1.ea1da25ae415bp-3, 0x1.e539ec36e038cp-4};
    static constexpr double A[] = {
        0x1.e539ec36e038cp-5, -0x1.40a40eb9277ebp-6, 0x1.70c8c1b9dff4fp-7, -0x1.6e9848d571533p-8, 0x1.a05075098fe41p-10,
        0x1.067408d26b392p-3, 0x1.ea1da25ae415bp-4, -0x1.92eace01f9649p-6, 0x1.521c0304094e1p-7, -0x1.6af008c56338dp-9,
        0x1.d20715c09d602p-4, 0x1.0a3ea8cf1adb3p-2, 0x1.23456789abcdfp-3, -0x1.52fd7a1a8d058p-6, 0x1.332d67642d89ap-8,
        0x1.f0916c7d0b528p-4, 0x1.d4fbe22aa380dp-3, 0x1.3c741469cb644p-2, 0x1.ea1da25ae415bp-4, -0x1.3d712b6fb1ccp-7,
        0x1.deb8aa62b9f93p-4, 0x1.f59264a18fa05p-3, 0x1.17bf217bdcce5p-2, 0x1.091912190482cp-2, 0x1.e539ec36e038cp-5};
    static constexpr int pairs = 2;
    static constexpr double gamma[] = {
        0x1.d2c8548e003aep+2};
    static constexpr double alpha[] = {
        0x1.ad0ce843fdbd9p+2, 0x1.298eed750225p+2};
    static constexpr double beta[] = {
        0x1.be1f0efe82046p+1, 0x1.c91747700f1b5p+2};
    static constexpr double A_inverse[] = {
        0x1.65dd983d657edp+3, 0x1.90ced640b4323p+1, -0x1.84787e745887fp-1, 0x1.e9ade6f5e6c12p-3, -0x1.bcf24f0a2eb43p-5,
        -0x1.2e52bc6646dd2p+3, 0x1.68899f0a6a04ap+1, 0x1.1be3b307aed05p+1, -0x1.1d3f2d140c208p-1, 0x1.e4cb4e2c60ecp-4,
        0x1.9ae33054d305ap+2, -0x1.8e16741a7f2edp+2, 0x1p+1, 0x1.ddb1de0405c6fp+0, -0x1.43933bb554886p-2,
        -0x1.00826c4e42df6p+3, 0x1.8c3184aceb88bp+2, -0x1.d928d12ba59b9p+2, 0x1.68899f0a6a04ap+1, 0x1.8ccf35a2e5fcbp+0,
        0x1.66bc1164ea963p+4, -0x1.0318205d4298dp+4, 0x1.ed4b4f953f98bp+3, -0x1.315e9f576d519p+4, 0x1.65dd983d657edp+3};
    static constexpr double T[] = {
        0x1.31843e5034f9dp-7, -0x1.3b7d45867a231p-8, 0x1.6822fefea0cccp-7, -0x1.41dbf8599cb72p-6, -0x1.4bfdcabb4699fp-6,
        -0x1.769038085303fp-9, -0x1.8adcf811a6ed3p-8, -0x1.04630031fc2f8p-6, 0x1.c1d27510626fcp-5, 0x1.089c9aa1b3a6dp-5,
        0x1.6920f40e24c9cp-5, -0x1.a3663a0be6d54p-11, -0x1.31b973c6c8658p-5, -0x1.46cc25cce634cp-3, 0x1.a8beb5aeef9c5p-7,
        0x1.02dc2067cf1e9p-2, 0x1.de3ac7d66ac9dp-3, -0x1.7dabe8b5d558ap-3, 0x1.268029533cfdp-3, -0x1.a8e93cc99910dp-2,
        0x1p+0, 0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0};
    static constexpr double T_inverse[] = {
        0x1.88427a3cd89cep+5, 0x1.90a37bdf489ffp+4, 0x1.4c2941e496b9fp+2, -0x1.21db5181542bap-2, 0x1.d421d56484ffcp-2,
        -0x1.c8454485edcb3p+5, -0x1.18aee0bbb4113p+5, -0x1.d671a23577f88p+0, -0x1.c5f0964c1e388p-9, 0x1.06da56ab3b1p-1,
        0x1.5bae734c2924dp+4, -0x1.6716c8a0eac6p+3, -0x1.49c2957280833p+2, -0x1.0c3cddfb354d9p+1, 0x1.0b60aab5c95cap-1,
        0x1.000b292454b97p+3, 0x1.41748b303f04dp+3, -0x1.ad19b2ae7177ap+1, 0x1.256732adec681p-2, 0x1.e297d4504e03fp-6,
        -0x1.26bedc71ce0ecp+3, 0x1.0205594f61993p+2, 0x1.a3d7f7e7b0d52p+1, -0x1.8b38f6c95037p+0, 0x1.5f4f6ccf8d61p-2};
};

template <>
struct gauss<6> {
    static constexpr stagecraft::facts facts{.order = 12,
                                             .stage_order = 6,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = true,
                                             .symmetric = true,
                                             .r_infinity = 0x1p+0};
    static constexpr double c[] = {
        0x1.149ad8bfaff12p-5, 0x1.5aebed3546d43p-3, 0x1.85d3b4bf2628fp-2, 0x1.3d1625a06ceb9p-1, 0x1.a94504b2ae4afp-1, 0x1.eeb652740500fp-1};
    static constexpr double b[] = {
        0x1.5edf601e2dbf8p-4, 0x1.716b7b5794c1cp-3, 0x1.df24d499545e8p-3, 0x1.df24d499545e8p-3, 0x1.716b7b5794c1cp-3, 0x1.5edf601e2dbf8p-4};
    static constexpr double A[] = {
        0x1.5edf601e2dbf8p-5, -0x1.e3c71c299bd3p-7, 0x1.319031e8afc17p-7, -0x1.7383a7ed9e62ep-8, 0x1.7622e37953697p-9, -0x1.aa2182090d0e2p-11,
        0x1.7b9732ee64d12p-4, 0x1.716b7b5794c1cp-4, -0x1.4c98ccdd1d63p-6, 0x1.539474914e203p-7, -0x1.40497dcb8fe2ep-8, 0x1.635a299aaa1ecp-10,
        0x1.50e3329c93e11p-4, 0x1.91794f717bcd6p-3, 0x1.df24d499545e8p-4, -0x1.4f95f2b3a5fa9p-6, 0x1.05d0e8f3c1e4ap-7, -0x1.100e71babe93bp-9,
        0x1.675fd3ac03b41p-4, 0x1.610e6cc858a37p-3, 0x1.048bc977e48efp-2, 0x1.df24d499545e8p-4, -0x1.006ea0cf385d2p-6, 0x1.bf85b0333bcd3p-9,
        0x1.5951f777c317p-4, 0x1.7b6dc745f140dp-3, 0x1.c9eb8d503f7c8p-3, 0x1.045bf71a7c057p-2, 0x1.716b7b5794c1cp-4, -0x1.cb7d2d03711a1p-8,
        0x1.6233a3223fd99p-4, 0x1.6b92efc9af742p-3, 0x1.eac0f1d8c151ap-3, 0x1.cc0bd17ac9627p-3, 0x1.8fa7ed1a2e7efp-3, 0x1.5edf601e2dbf8p-5};
    static constexpr int pairs = 3;
    static constexpr double alpha[] = {
        0x1.0fe51eceb8cc4p+3, 0x1.de2bb100e819ep+2, 0x1.420a1161a64dbp+2};
    static constexpr double beta[] = {
        0x1.bc2a3a56fc16ep+0, 0x1.5029b0ec07223p+2, 0x1.1f87f423e4506p+3};
    static constexpr double A_inverse[] = {
        0x1.ea6b4f83a3cep+3, 0x1.1b7134ef376b6p+2, -0x1.22c34ca08c86ap+0, 0x1.a79564585ea7bp-2, -0x1.3ada257d39e06p-3, 0x1.3300c031bbe77p-5,
        -0x1.88c8a26b6695cp+3, 0x1.c6dde53c7e28dp+1, 0x1.8d6358e20b9f3p+1, -0x1.cae1225250429p-1, 0x1.3bd730c5d7a77p-2, -0x1.2b0b645aecbd4p-4,
        0x1.d42d1d74ab99ap+2, -0x1.cdbd1a663f16fp+2, 0x1.0f74dcb4f29f4p+1, 0x1.49bce06fcf799p+1, -0x1.61cbc4c741f07p-1, 0x1.362faf5494423p-3,
        -0x1.c341123fe4fd8p+2, 0x1.60c525c4368b9p+2, -0x1.b4534cecda5cp+2, 0x1.0f74dcb4f29f4p+1, 0x1.3262da75e192ep+1, -0x1.a9d88af6b3e32p-2,
        0x1.47d12ef5b5bfp+3, -0x1.da9b5848dba35p+2, 0x1.c98c828c68be8p+2, -0x1.2b7105599242ep+3, 0x1.c6dde53c7e28dp+1, 0x1.0d3628f99ac11p+1,
        -0x1.eb04cfe3bcabfp+4, 0x1.59254c0f030b4p+4, -0x1.341c851e1c2f6p+4, 0x1.3faa6456c37d2p+4, -0x1.9d8be4ffd6726p+4, 0x1.ea6b4f83a3cep+3};
    static constexpr double T[] = {
        -0x1.34e9bf9eff696p-9, -0x1.a084b1a204abbp-9, 0x1.7ede94379e468p-8, -0x1.1bba62b6569b3p-9, 0x1.2437be1fe2d05p-9, 0x1.21a84d80d3067p-6,
        0x1.818c01a5028bbp-9, 0x1.b8b97ac2a41f5p-10, -0x1.a7c1a6f41b1b1p-8, 0x1.d515125869d45p-8, -0x1.697365f7b9596p-7, -0x1.1e0fc3477b44bp-5,
        0x1.e49cf386875c5p-11, -0x1.15b842451a3e5p-7, -0x1.0b3c528b4170bp-7, -0x1.8678b7291b06fp-8, 0x1.a905ccc89475p-5, 0x1.f1c09cf65e22ap-5,
        0x1.766a0941b0bb8p-5, -0x1.bd5a3e1754bddp-6, -0x1.7d5c8e9453131p-6, -0x1.163756dd421e1p-4, -0x1.9329b1fc0759cp-3, -0x1.63cfcb316c1e9p-6,
        0x1.37665a4b88207p-2, -0x1.39f356c09c2a4p-4, 0x1.1e5680ccbb008p-2, -0x1.f1220783623cfp-3, 0x1.908f620a25213p-3, -0x1.d6de4916a64abp-2,
        0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0};
    static constexpr double T_inverse[] = {
        -0x1.929d8f2a7d609p+5, 0x1.396d26be8e6dfp+3, 0x1.a17c7236c82e6p+3, 0x1.79927af45099dp+2, -0x1.3bc2ca8ddca17p+0, 0x1.e4564fa9820f8p-1,
        -0x1.045b83a80acf5p+8, -0x1.5dafca78bd2c3p+7, -0x1.21e313a84615p+5, -0x1.d27c348a431f6p+0, -0x1.6f39c417ee612p+0, 0x1.d0937ad5d1aabp-2,
        0x1.03e8a090e760dp+6, -0x1.1be499eecfa5cp+3, -0x1.53c7516afba0cp+4, -0x1.794f2632aa263p+1, 0x1.0294f0633a552p-1, 0x1.70a6e930648acp-3,
        0x1.70d45c305e2c4p+6, 0x1.5e060a0890cccp+6, 0x1.8c4cc2a7076eap+2, -0x1.fe2e6490fec65p-1, -0x1.1e0dba55a6451p+1, 0x1.5bd2a0d0c42bep-1,
        -0x1.d4cec7dd45844p+3, -0x1.d888ccfbec82dp-1, 0x1.0612309f2f132p+3, -0x1.79d5cfb5f70d8p+1, 0x1.74f0a4b87eedbp-1, -0x1.020027d66cc8dp-3,
        -0x1.51ce2a7d7d90dp+2, -0x1.05bfddfcb2132p+4, 0x1.f807c3ade3f8ap+0, 0x1.aee93f8480b69p+0, -0x1.e8c79a278ae7p-1, 0x1.fa5819d7daf3fp-3};
};

template <>
struct gauss<7> {
    static constexpr stagecraft::facts facts{.order = 14,
                                             .stage_order = 7,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = true,
                                             .symmetric = true,
                                             .r_infinity = -0x1p+0};
    static constexpr double c[] = {
        0x1.a0e871839dd6ap-6, 0x1.08ac0c838bc54p-3, 0x1.303510773014fp-2, 0x1p-1, 0x1.67e577c467f58p-1, 0x1.bdd4fcdf1d0ebp-1, 0x1.f2f8bc73e3115p-1};
    static constexpr double b[] = {
        0x1.092f69f826d57p-4, 0x1.1e6b1713d8644p-3, 0x1.86fe74ee32b3dp-3, 0x1.abfd7e03c2fa6p-3, 0x1.86fe74ee32b3dp-3, 0x1.1e6b1713d8644p-3, 0x1.092f69f826d57p-4};
    static constexpr double A[] = {
        0x1.092f69f826d57p-5, -0x1.773a185e5cbfep-7, 0x1.f43fe8feea1b4p-8, -0x1.5071c1c2ab913p-8, 0x1.a0294b311442p-9, -0x1.a537ccdbdb2a5p-10, 0x1.e05cd6c284e97p-12,
        0x1.1ee5f9f8484cbp-4, 0x1.1e6b1713d8644p-4, -0x1.0fcf87ec94b3ap-6, 0x1.325e520adb90cp-7, -0x1.61b42d574bbc2p-8, 0x1.5acbc9c17fbd1p-9, -0x1.85fde1eb56dfbp-11,
        0x1.fd2a4030c77d3p-5, 0x1.374eabd065f8bp-3, 0x1.86fe74ee32b3dp-4, -0x1.2d0f5c3d873bp-6, 0x1.1d7e45b65ff7ap-7, -0x1.031a117bf4e13p-8, 0x1.1a41296cc3785p-10,
        0x1.0fb31df0f9468p-4, 0x1.119aa89d9ab38p-3, 0x1.a95f9a89a908ap-3, 0x1.abfd7e03c2fa6p-4, -0x1.13092cdbb2a62p-6, 0x1.9a0dcec7b618p-8, -0x1.a0ecfe349c473p-10,
        0x1.04c6655273c79p-4, 0x1.2683e79fb80b5p-3, 0x1.75269092ccb46p-3, 0x1.d19f698b73e1cp-3, 0x1.86fe74ee32b3dp-4, -0x1.8e394bc8d9468p-7, 0x1.53493bf862da9p-9,
        0x1.0c3b65bbfd833p-4, 0x1.18ffe7ecd2655p-3, 0x1.920c1658ed11bp-3, 0x1.98d798e315415p-3, 0x1.a8f865ebc54a5p-3, 0x1.1e6b1713d8644p-4, -0x1.5b69000217742p-8,
        0x1.074f0d2164508p-4, 0x1.21b586ad901aap-3, 0x1.807dcfc16e62dp-3, 0x1.b6810c11d856ep-3, 0x1.775c75a63b63p-3, 0x1.35deb899be304p-3, 0x1.092f69f826d57p-5};
    static constexpr int pairs = 3;
    static constexpr double gamma[] = {
        0x1.3e31c18203d81p+3};
    static constexpr double alpha[] = {
        0x1.3087d4fed29adp+3, 0x1.047d28f97fa77p+3, 0x1.57c4428d57a38p+2};
    static constexpr double beta[] = {
        0x1.bd41d9eef1be6p+1, 0x1.c232c25aa06d4p+2, 0x1.5aeca713430bap+3};
    static constexpr double A_inverse[] = {
        0x1.42997f84a8882p+4, 0x1.7c23380f0642p+2, -0x1.9243aa95fb14p+0, 0x1.3938324a223ap-1, -0x1.10a8a0273b5d1p-2, 0x1.bb54090469e33p-4, -0x1.c2bb7b26f5886p-6,
        -0x1.f423e8dfa41d8p+3, 0x1.1c5c8140c59e9p+2, 0x1.08024c79b745bp+2, -0x1.4528a6c9b357fp+0, 0x1.0527a9754f183p-1, -0x1.99e648019da03p-3, 0x1.9a76818f0c2bdp-5,
        0x1.14018a34eb3d7p+3, -0x1.135cc8c1b373ap+3, 0x1.327b01593081dp+1, 0x1.ad08eba18297ep+1, -0x1.0a96b60a4b98cp+0, 0x1.7e9cc15d88fc6p-2, -0x1.71da3ed855e2cp-4,
        -0x1.d08c1a9927b9fp+2, 0x1.6e8b2640da65p+2, -0x1.cfb313a768dbcp+2, 0x1p+1, 0x1.87f2c49a66d3bp+1, -0x1.b3341e4ca2a85p-1, 0x1.84252f82e37cdp-3,
        0x1.05d7fa8aae58dp+3, -0x1.7d3dc49df1bdap+2, 0x1.7520aedbc368p+2, -0x1.fb9341af8bc33p+2, 0x1.327b01593081dp+1, 0x1.82cb31f69b72fp+1, -0x1.10d4427ed9061p-1,
        -0x1.9dc123e93e098p+3, 0x1.22c41a60cc151p+3, -0x1.043817c9729dfp+3, 0x1.11dc29c5c762fp+3, -0x1.77e6c36ef94f5p+3, 0x1.1c5c8140c59e9p+2, 0x1.5ff4eddfd480ep+1,
        0x1.42d1d6f40d66dp+5, -0x1.bee22365fe0ecp+4, 0x1.82112fecf27c4p+4, -0x1.76df8d8db895bp+4, 0x1.96f2c815b5401p+4, -0x1.0e17ceb05d9abp+5, 0x1.42997f84a8882p+4};
    static constexpr double T[] = {
        0x1.9c76e1308dd68p-10, -0x1.a1a1558d85fep-12, 0x1.ea52e524db942p-10, -0x1.af747b3c3173bp-9, -0x1.68ff8f7ab99cfp-10, 0x1.7e2218900a15dp-8, -0x1.5bff7ae42c9b7p-7,
        -0x1.7f6a042d61af6p-10, -0x1.253ea1f03165ap-12, -0x1.21a71b00a27ccp-9, 0x1.74ec0384fbdcfp-8, 0x1.9b642b34e382ep-12, -0x1.173532329cca8p-7, 0x1.63b4e9be4e009p-6,
        0x1.72a9527be512dp-9, -0x1.08e7de983079p-10, 0x1.ff3f15772495fp-11, -0x1.1f4f1c572685dp-8, 0x1.340d9b231203dp-8, 0x1.20db89864777cp-8, -0x1.73ef5e952fe2bp-5,
        0x1.dfb82b265c243p-8, -0x1.0c9304682729bp-10, -0x1.a78e0202f0098p-7, -0x1.0a584429bcde4p-6, 0x1.b67fa890ef91ep-9, 0x1.4c9c07166a485p-5, 0x1.781c026b650e1p-4,
        0x1.1920354a431e7p-4, 0x1.69bd86d7ea6dp-5, -0x1.e4d8966d58a76p-5, -0x1.4e6be01e59e1dp-5, -0x1.a6a70713e8a22p-4, -0x1.db4dabf554061p-3, -0x1.10f52fcb669ecp-4,
        0x1.6aebdbefa3f1fp-2, 0x1.64b2141a157d4p-2, -0x1.1234bb9d1c3e2p-3, 0x1.4ca3ad2355859p-2, -0x1.25e8fe1a28b8ap-2, 0x1.024fe90b3e5f7p-2, -0x1.fe199198f3e9cp-2,
        0x1p+0, 0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0};
    static constexpr double T_inverse[] = {
        0x1.c1707ea9da052p+8, 0x1.5815a6378da79p+8, 0x1.6bd9ab273ff1ap+6, 0x1.53d0bcf7cd233p+3, 0x1.dfbb947cc867cp+1, -0x1.6b8383b1eb89ap+0, 0x1.6a10e0866d4cbp-1,
        -0x1.1dbe947f830fdp+9, -0x1.f505a922f4968p+8, -0x1.d50cd003f1c0ap+6, -0x1.0b4c21447e6fcp+3, 0x1.34574edaf6ad2p+1, -0x1.a743f81745c6ep-1, 0x1.5fa536e3e7681p-1,
        0x1.eb002ee69b3acp+7, 0x1.370fdcbd22aedp+4, -0x1.0f17ae3f5b204p+6, -0x1.8a7f1c2f03adbp+4, 0x1.d2cfa4f08cfbcp-1, -0x1.702d75993c846p+1, 0x1.f13b4352a655cp-1,
        0x1.e5cbe5ff097ep+6, 0x1.6214789a2db7ap+7, 0x1.e71114d843155p+4, -0x1.fe362ab14ddb4p+2, -0x1.cfb71d21ae8e6p+1, 0x1.5e099f6350f5ep+0, -0x1.9114e4859c8ccp-3,
        -0x1.282f77efc9e4bp+7, -0x1.c9e4a778bea1dp+4, 0x1.b64197be7cc31p+5, 0x1.9d673366cd73cp+2, 0x1.d9401ee396de2p-3, -0x1.ec5b6ec6ac0e7p+0, 0x1.4f38cdbb912bcp-1,
        0x1.3361aad3760cap-1, -0x1.41a3961afecdbp+4, -0x1.09120595ef652p+2, 0x1.6d2cf34ab0746p+2, -0x1.445bc63610868p+1, 0x1.c237c0b47aee7p-1, -0x1.95c37923b6463p-3,
        0x1.2fc4b7c1c4e63p+4, 0x1.5fba0886ea4f8p+3, -0x1.9c0168593fd47p+3, 0x1.27b5eaaf995b4p+1, 0x1.4efd8ee1ad042p-2, -0x1.82aa4a0fbd80fp-2, 0x1.df8d81bf2c3e6p-4};
};

template <>
struct gauss<8> {
    static constexpr stagecraft::facts facts{.order = 16,
                                             .stage_order = 8,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = true,
                                             .symmetric = true,
                                             .r_infinity = 0x1p+0};
    static constexpr double c[] = {
        0x1.454e34f533998p-6, 0x1.a06d536d82f88p-4, 0x1.e5dad4f9af698p-3, 0x1.a214dac30e32fp-2, 0x1.2ef5929e78e69p-1, 0x1.86894ac19425ap-1, 0x1.cbf255924fa0fp-1, 0x1.f5d58e5856633p-1};
    static constexpr double b[] = {
        0x1.9ea1d04ca0374p-5, 0x1.c76fb531d2b96p-4, 0x1.413c50a255615p-3, 0x1.736360b199343p-3, 0x1.736360b199343p-3, 0x1.413c50a255615p-3, 0x1.c76fb531d2b96p-4, 0x1.9ea1d04ca0374p-5};
    static constexpr double A[] = {
        0x1.9ea1d04ca0374p-6, -0x1.2a623059643d9p-7, 0x1.9b9edc5e41f73p-8, -0x1.25cc85720e17fp-8, 0x1.9381077ef778cp-9, -0x1.f6b5020316266p-10, 0x1.fe0152d5218bfp-11, -0x1.22fd130783f79p-12,
        0x1.c0969f0491b57p-5, 0x1.c76fb531d2b96p-5, -0x1.bef2e760de5e9p-7, 0x1.0b0cb68260d4ep-7, -0x1.55cb16a8f690fp-8, 0x1.9b88a0c7b932ap-9, -0x1.9a3d010d342f3p-10, 0x1.d04fd6a6e27fdp-12,
        0x1.8e0772c379454p-5, 0x1.ef0a65b45e044p-4, 0x1.413c50a255615p-4, -0x1.05bc709f53c37p-6, 0x1.12532f1f42bf8p-7, -0x1.30506e049095bp-8, 0x1.23ba985713c2ap-9, -0x1.446eb1ca187b2p-11,
        0x1.a8e1e18b7a0c9p-5, 0x1.b2f7f1f3c39a5p-4, 0x1.5d88d3e0a4b9dp-3, 0x1.736360b199343p-4, -0x1.067d1e2162fe4p-6, 0x1.da8f495d31168p-8, -0x1.a324d7c36b99cp-9, 0x1.c27cc83b4724fp-11,
        0x1.9797dd2bb31abp-5, 0x1.d488dbefee162p-4, 0x1.3267d6576bd8ap-3, 0x1.94330475c593fp-3, 0x1.736360b199343p-4, -0x1.c4c833e4f5875p-7, 0x1.477c33e0f1f07p-8, -0x1.480227db3aaacp-10,
        0x1.a3b38b13c8993p-5, 0x1.be51e06f1a1b4p-4, 0x1.4abed41279e6p-3, 0x1.623e2dbfa5083p-3, 0x1.941aeec583acap-3, 0x1.413c50a255615p-4, -0x1.3cd584145a57p-7, 0x1.09a5d8926f208p-9,
        0x1.9b01309f52724p-5, 0x1.cdd8a936078a1p-4, 0x1.3ace2e1f367c9p-3, 0x1.7e11b966e0e8bp-3, 0x1.62b295497326ep-3, 0x1.5d2b7f1863474p-3, 0x1.c76fb531d2b96p-5, -0x1.0fa675bf8bf1ap-8,
        0x1.a0e7ca72af3f3p-5, 0x1.c373b28c28764p-4, 0x1.4529baa65b8dap-3, 0x1.6d155c939d565p-3, 0x1.7c91c4dd29a4fp-3, 0x1.345f59bf6351ap-3, 0x1.ecbbfb3cff411p-4, 0x1.9ea1d04ca0374p-6};
    static constexpr int pairs = 4;
    static constexpr double alpha[] = {
        0x1.659fecc865bf2p+3, 0x1.4d1c1c8c2b053p+3, 0x1.17920cefd6a4p+3, 0x1.6b63d377312f6p+2};
    static constexpr double beta[] = {
        0x1.bc37f5e8a7a09p+0, 0x1.4eded3d09a8e3p+2, 0x1.1a8639d666412p+3, 0x1.96a67b934c577p+3};
    static constexpr double A_inverse[] = {
        0x1.9b14ef9527da9p+4, 0x1.ea8c615f5f157p+2, -0x1.088bcc5ca7dffp+1, 0x1.ab80e779f1ba1p-1, -0x1.90b6e834fe4e7p-2, 0x1.8133463202859p-3, -0x1.4ae4a23e2ac4fp-4, 0x1.599eb2e2d115ap-6,
        -0x1.37e141fc78cf1p+4, 0x1.5e6015a8b6ea5p+2, 0x1.523bdda669068p+2, -0x1.afd33a19bdf27p+0, 0x1.74da86cd4f6adp-1, -0x1.5926b93c06e0bp-2, 0x1.22ef2e6c93a62p-3, -0x1.2d3f43f08fd38p-5,
        0x1.47a92cb64b67ap+3, -0x1.49762607abb3ap+3, 0x1.61ae63152544p+1, 0x1.0e1aa594b8c97p+2, -0x1.67b7c62dd05b6p+0, 0x1.2f024fbbe14f4p-1, -0x1.e957d70055147p-3, 0x1.f131a6a397affp-5,
        -0x1.fc07e3013fff4p+2, 0x1.9392d1ec8827p+2, -0x1.03277bbb01105p+3, 0x1.08e9f4f02e133p+1, 0x1.e17a09b8f77b4p+1, -0x1.372428f725fcbp+0, 0x1.c93bc181b68b1p-2, -0x1.bf5f82339649cp-4,
        0x1.f41b20b693d78p+2, -0x1.6df4ef3a8f914p+2, 0x1.6a76fbe2972b2p+2, -0x1.f9a6f9cca9d0dp+2, 0x1.08e9f4f02e133p+1, 0x1.d3420ba268e95p+1, -0x1.08c67b284ff9cp+0, 0x1.dd480a6f501d3p-3,
        -0x1.3442ffd5a4694p+3, 0x1.b272739b66fd6p+2, -0x1.878ead0ca16dep+2, 0x1.a30de242ce1a2p+2, -0x1.2b9d4b2609666p+3, 0x1.61ae63152544p+1, 0x1.df892e57e6253p+1, -0x1.5575e874a9614p-1,
        0x1.00a4bc990b6dbp+4, -0x1.62ebd2626938ep+3, 0x1.326e5d54ffe42p+3, -0x1.2a6beaf929cedp+3, 0x1.4918a9cf8c967p+3, -0x1.d0c3165e54305p+3, 0x1.5e6015a8b6ea5p+2, 0x1.be99282b2d4a1p+1,
        -0x1.9b40236b8434bp+5, 0x1.19e66608f16ffp+5, -0x1.dda68ff0f7e48p+4, 0x1.bff296b921575p+4, -0x1.c70bc2541cebfp+4, 0x1.fbb5a2f028db7p+4, -0x1.56927fe3be3d3p+5, 0x1.9b14ef9527da9p+4};
    static constexpr double T[] = {
        -0x1.e5fda63502c47p-12, -0x1.1b644249253p-11, 0x1.c22e48dfa69bbp-11, -0x1.1d2c2b26c216cp-11, 0x1.fa4ae8a87f79ep-11, 0x1.02a85aae8e6cbp-9, -0x1.00c3f8d264c6bp-7, 0x1.ef0e4a542fa53p-9,
        0x1.31ed03e90c031p-11, 0x1.17582d1b70082p-11, -0x1.df56d7e1912e7p-11, 0x1.03b7c64577c07p-10, -0x1.2825f5e5b1dd3p-9, -0x1.6617e0cbc8f7dp-9, 0x1.bff1feb18544ap-7, -0x1.0efd143339996p-7,
        -0x1.1554083dcf295p-11, -0x1.a52ddba4b58c8p-11, 0x1.fd44c75bb253ep-12, -0x1.653dd46b3caffp-11, 0x1.15bb526ad267p-8, 0x1.6d32586d4340dp-10, -0x1.5aa1cb73d45c9p-6, 0x1.3f89d4efffad1p-6,
        0x1.8a79eb54ffb34p-10, -0x1.c3bf82d4fd8efp-11, -0x1.b28612897d421p-9, 0x1.3a111a46e67ffp-11, -0x1.367f1b8dc5529p-11, 0x1.3e63b557b31dbp-8, 0x1.a0d803162b70fp-6, -0x1.a221fd3459debp-5,
        0x1.3a4bae3c12f8bp-7, -0x1.1beeda8369d04p-7, -0x1.d0290b25fbd0cp-8, -0x1.10fbf884262cep-6, -0x1.e4b6a4c7af3ccp-6, 0x1.6a4a888de81a6p-7, 0x1.395afe24728bep-6, 0x1.fbe8d920fa17bp-4,
        0x1.51915a5571901p-4, -0x1.059187ee81795p-5, 0x1.5f7ddf8d0a3e5p-5, -0x1.7f80c701b8b28p-4, -0x1.b4bf6b11920aap-5, -0x1.241f55949f366p-3, -0x1.0c3e0c4f1e31cp-2, -0x1.f4957ef5cb334p-4,
        0x1.959a9f6528e1dp-2, -0x1.d5c3618a75951p-5, 0x1.8e7250c6b8044p-2, -0x1.6ce465024b7abp-3, 0x1.7aa024d6d21f4p-2, -0x1.4959f02d60e64p-2, 0x1.401eec5b89c08p-2, -0x1.0e549856e7dbcp-1,
        0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0};
    static constexpr double T_inverse[] = {
        -0x1.047656902c88bp+9, -0x1.0dd7a4c104232p+7, 0x1.d417649cea56bp+6, 0x1.e471c3ecc8485p+5, 0x1.3f90c346672e6p+2, 0x1.c94f9c697ad4fp+2, -0x1.d01a4e5b135acp+1, 0x1.9b8266c4a6be9p+0,
        -0x1.3be694b5fd69p+11, -0x1.1b15f5961c78dp+11, -0x1.5c7f63367898dp+9, -0x1.9c1368277e6d7p+6, -0x1.e7789415c9ae7p+3, 0x1.6c452ffdaf1cdp+1, -0x1.509d17e8572cbp+1, 0x1.c78a6e089fcf2p-1,
        0x1.865a8b8914238p+9, 0x1.faa0e937a313fp+7, -0x1.963d4f533e7e8p+7, -0x1.4bd46fa4d1cebp+6, -0x1.c02af5cadbbe5p+2, -0x1.0f023eec9e78bp+0, 0x1.77f319bd319cdp-1, 0x1.85123e6ed077ep-4,
        0x1.0873d6b8264afp+10, 0x1.2e72aa8fae4fep+10, 0x1.6f2e2e4f5037ep+8, 0x1.3c331c2d42p+4, -0x1.c7aca94f73a6fp+3, 0x1.9ece1a4a1d056p+1, -0x1.e97212a6267ecp+1, 0x1.553b4170ec5afp+0,
        -0x1.1855c82740547p+8, -0x1.1db632b848313p+7, 0x1.8d9bdb62601bep+6, 0x1.8f50e2c2fd3bbp+4, -0x1.7edbfe66052e9p+0, -0x1.0ccf0159d6d13p+2, 0x1.0e5dd34e9872p+1, -0x1.03f1f82445241p-1,
        -0x1.e05fa32ec2f39p+6, -0x1.27a00aef46854p+8, -0x1.a04dadf036f41p+6, 0x1.7d5907ca75a82p+4, 0x1.4899cc7e672cbp+2, -0x1.77b92dccad4bdp-2, -0x1.161fb5331558ap+0, 0x1.bfbc6b88201d1p-2,
        0x1.48d5e35711ee1p+4, 0x1.8767720d4a035p+4, -0x1.a9c50ac66bac2p+3, -0x1.4715604a348bcp+1, 0x1.c0a2643bebb73p+1, -0x1.e3002d51f1967p+0, 0x1.8efed274ba063p-1, -0x1.8ed474cb89a04p-3,
        -0x1.1d7e136bbec3ep+3, 0x1.1b61e3f1b0fedp+4, 0x1.e0d8c0de5e78ap+3, -0x1.37bfebafd8466p+3, 0x1.78fc2f8dfce17p+1, -0x1.508087cac746dp-1, 0x1.aff3eb991aecep-4, -0x1.f9b56ef924e7ap-8};
};

template <>
struct gauss<9> {
    static constexpr stagecraft::facts facts{.order = 18,
                                             .stage_order = 9,
                                             .a_stable = true,
                                             .algebraically_stable = true,
                                             .symplectic = true,
                                             .symmetric = true,
                                             .r_infinity = -0x1p+0};
    static constexpr double c[] = {
        0x1.04d4d140def9fp-6, 0x1.4fceec3cbf59fp-4, 0x1.8be85bf1004e7p-3, 0x1.59fb748dbaacdp-2, 0x1p-1, 0x1.530245b922a9ap-1, 0x1.9d05e903bfec6p-1, 0x1.d60622786814cp-1, 0x1.f7d95975f9083p-1};
    static constexpr double b[] = {
        0x1.4ce65f803eef8p-5, 0x1.71f7a9b222beap-4, 0x1.0add87c827506p-3, 0x1.3fd7e9838d512p-3, 0x1.522a43f65486ap-3, 0x1.3fd7e9838d512p-3, 0x1.0add87c827506p-3, 0x1.71f7a9b222beap-4, 0x1.4ce65f803eef8p-5};
    static constexpr double A[] = {
        0x1.4ce65f803eef8p-6, -0x1.e4d3a38d3d395p-8, 0x1.563aaea5cd532p-8, -0x1.fbb3753dcb8ecp-9, 0x1.731cfe61c3579p-9, -0x1.01304fbc2e67fp-9, 0x1.418c63b62c501p-10, -0x1.469cd333a3a02p-11, 0x1.74d415de97f32p-13,
        0x1.682a64b2dbd97p-5, 0x1.71f7a9b222beap-5, -0x1.7370c39be63e5p-7, 0x1.cd07cd59332a6p-8, -0x1.39cdf1630e195p-8, 0x1.a3deee2e1f8fcp-9, -0x1.017a84d17f62bp-9, 0x1.02c7ff9a63208p-10, -0x1.25e38af4094a6p-12,
        0x1.3f8f13532325fp-5, 0x1.9226c6ef07b41p-4, 0x1.0add87c827506p-4, -0x1.c33e20ce397aap-7, 0x1.f64787a89c86p-8, -0x1.34e8dbb9df711p-8, 0x1.6b2d96f4551dap-9, -0x1.64f4428a6c1b3p-10, 0x1.911d2ea26b011p-12,
        0x1.552813da491dcp-5, 0x1.614d6b2a8af2p-4, 0x1.226587bd01feep-3, 0x1.3fd7e9838d512p-4, -0x1.df08b4fd44463p-7, 0x1.de70dca202fe8p-8, -0x1.01be1ad0c443ep-8, 0x1.e5abaa91b2b1dp-10, -0x1.0bb00304250b8p-11,
        0x1.4731086882f4dp-5, 0x1.7cb23084a90dfp-4, 0x1.fcf5061827e7ep-4, 0x1.5c29318569fdp-3, 0x1.522a43f65486ap-4, -0x1.c514801dcabe6p-7, 0x1.8c6097826b8ebp-8, -0x1.5750da50c9ea4p-9, 0x1.6d55c5eefeaa7p-11,
        0x1.51151f8c4f83bp-5, 0x1.6a60fb07dbf3ep-4, 0x1.12eb789ead728p-3, 0x1.30e4629e7d392p-3, 0x1.701acf4628cbp-3, 0x1.3fd7e9838d512p-4, -0x1.787fff4daae71p-7, 0x1.0aa3e8797ccacp-8, -0x1.08368b4145c83p-10,
        0x1.49c42522fa198p-5, 0x1.778b7abc4c6f1p-4, 0x1.0530d16c55fbfp-3, 0x1.497f30615c4cap-3, 0x1.427807b90fa27p-3, 0x1.5c0bcb9070e8cp-3, 0x1.0add87c827506p-4, -0x1.0178e9e727ab6p-7, 0x1.aae985a37932ap-10,
        0x1.4f32269627021p-5, 0x1.6dec89b3b9322p-4, 0x1.0ee371db6d4dfp-3, 0x1.39486dcad4d2ep-3, 0x1.5bf8b3816cf76p-3, 0x1.316fab18c3b7cp-3, 0x1.22149401e5b45p-3, 0x1.71f7a9b222beap-5, -0x1.b4405329ce9fp-9,
        0x1.4b718b6a60579p-5, 0x1.7484e3588a05ep-4, 0x1.085a6f00baf7cp-3, 0x1.43dcaac27e0acp-3, 0x1.4c5dcffccd794p-3, 0x1.47c6b758847f5p-3, 0x1.002bb252f8e5dp-3, 0x1.9044e3eaf6924p-4, 0x1.4ce65f803eef8p-6};
    static constexpr int pairs = 4;
    static constexpr double gamma[] = {
        0x1.93025cbdf007bp+3};
    static constexpr double alpha[] = {
        0x1.8847905180a4dp+3, 0x1.66aed8daf1954p+3, 0x1.28dc32f8f9b59p+3, 0x1.7d586af73819p+2};
    static constexpr double beta[] = {
        0x1.bce3a1b474eefp+1, 0x1.bfc39b1b4c683p+2, 0x1.544e2ddb7c5e3p+3, 0x1.d2a7575059ad6p+3};
    static constexpr double A_inverse[] = {
        0x1.fea550ac8c7d2p+4, 0x1.3359f87be7e81p+3, -0x1.4fb5be929377fp+1, 0x1.158c1fcb1702dp+0, -0x1.0f2c0c2bf398ap-1, 0x1.1a3f901fc7ac4p-2, -0x1.20c2588f6b6bdp-3, 0x1.014d3bf0c5409p-4, -0x1.11c480d83a249p-6,
        -0x1.7dada838395d3p+4, 0x1.a92cfcf2d83c5p+2, 0x1.a582c18f15cccp+2, -0x1.132a84cff18bfp+1, 0x1.eee5f08852ee3p-1, -0x1.ef777b19236adp-2, 0x1.f08f14bdc5e08p-3, -0x1.b58a8b28cc9ccp-4, 0x1.cf0b69a42edebp-6,
        0x1.83b7cc4c67a8cp+3, -0x1.8802c9b054d4ep+3, 0x1.9a67715687a3p+1, 0x1.4c25bb4d707b2p+2, -0x1.cbfc62942d32dp+0, 0x1.a219769e8d8e5p-1, -0x1.9011ebacbcaafp-2, 0x1.583372991ca9fp-3, -0x1.683612b6e4edbp-5,
        -0x1.1cc08356d4493p+3, 0x1.c6aa7515ab5c2p+2, -0x1.270f1826825f9p+3, 0x1.1e140f5f63fb7p+1, 0x1.21f3f19fecc01p+2, -0x1.92df7bdfbe513p+0, 0x1.5cd8b5ff49e9ap-1, -0x1.1e8e84cf4cec6p-2, 0x1.25c524bc23d82p-4,
        0x1.01d58d5a1ee54p+3, -0x1.7aebe358964b3p+2, 0x1.7ab1a5328848fp+2, -0x1.0cb7442a56321p+3, 0x1p+1, 0x1.123e4b4d05965p+2, -0x1.6b00465705f76p+0, 0x1.0eb85c2b2cd6fp-1, -0x1.0af32ec5a2eddp-3,
        -0x1.160508ff7a47cp+3, 0x1.8900e5e9cb196p+2, -0x1.6497a7e259623p+2, 0x1.82cbee57538fbp+2, -0x1.1c1bdbc52a4fp+3, 0x1.1e140f5f63fb7p+1, 0x1.15219f2a949a1p+2, -0x1.3e49dde35446p+0, 0x1.20e0941a4924p-2,
        0x1.6af3888da355ep+3, -0x1.f69930c808136p+2, 0x1.b3689011536dbp+2, -0x1.ab620fe0f73ecp+2, 0x1.dfdf18b5730d8p+2, -0x1.61a24e2d4b041p+3, 0x1.9a67715687a3p+1, 0x1.242dfe2d6a7bbp+2, -0x1.a2c79d17b37cdp-1,
        -0x1.38fdbd28c21d2p+4, 0x1.ac98120929d59p+3, -0x1.6a88ee046e34p+3, 0x1.53c22d3565b52p+3, -0x1.5a59738fa53b9p+3, 0x1.8911129098fccp+3, -0x1.1ac4093c81017p+4, 0x1.a92cfcf2d83c5p+2, 0x1.148eb7a7812f3p+2,
        0x1.fec7893ca7846p+5, -0x1.5bd788212b6acp+5, 0x1.22f4a9da4b8d7p+5, -0x1.0b1d9885cdcbcp+5, 0x1.05e982043bed5p+5, -0x1.11957a63e6f48p+5, 0x1.36cf436ae5598p+5, -0x1.a82d5fa22d023p+5, 0x1.fea550ac8c7d2p+4};
    static constexpr double T[] = {
        0x1.3d3b4d8784febp-12, -0x1.3e13be9ba3edcp-15, 0x1.7177538686f7ep-12, -0x1.2a78dfd6e8f13p-11, -0x1.dea5c132e29b6p-14, 0x1.6a231b219690ep-12, -0x1.6bab63ffa99fep-10, 0x1.a4771a01cced8p-8, 0x1.1b986fea3a8d7p-10,
        -0x1.74fef3be2691dp-12, -0x1.f6c45f33988dbp-17, -0x1.ce24814958977p-12, 0x1.ae8f73c3becc4p-11, -0x1.737983fd8d89bp-18, -0x1.437068f77acdbp-13, 0x1.2dd05817afcefp-9, -0x1.7889e17562c4dp-7, -0x1.1d0dd3cacfcabp-10,
        0x1.b979ae1e8d32p-12, -0x1.f3569993ae3d8p-16, 0x1.bea265b01c572p-12, -0x1.6e7fbf1d95799p-11, 0x1.b669ccee430dp-13, -0x1.01ba5ad0ca125p-10, -0x1.7bac493ca7686p-9, 0x1.3f6d77f350e99p-6, -0x1.20727a9548f75p-10,
        -0x1.344a85b9c01a1p-14, -0x1.193ed540ef808p-12, -0x1.7a9b5a1317b96p-11, 0x1.50a1590d08c18p-11, 0x1.18e5b0a1e3c03p-11, 0x1.86a1b1a14cb86p-9, 0x1.b4c305a8cd309p-11, -0x1.13ea5847e800dp-5, 0x1.722a7558b7f67p-7,
        0x1.55fda8baca5bcp-9, -0x1.08aa58a757b98p-12, -0x1.20629ff2e2015p-9, -0x1.49a6edaf6b51bp-8, 0x1.457516a437a2ap-10, 0x1.f2231ce02bb55p-9, 0x1.077fc9cfd6dc3p-7, 0x1.a3b5e25b9cb92p-5, -0x1.969aef55128c2p-5,
        0x1.1637c559435e5p-6, 0x1.13085469e74b2p-7, -0x1.23c44ec47d51dp-6, -0x1.0b7a49417e3aap-6, -0x1.5b12ef89189e2p-6, -0x1.8703991b9220cp-5, 0x1.078d3ddb644fcp-6, -0x1.ccba8acd09acep-7, 0x1.3bf8bf7950313p-3,
        0x1.b7f3c5fd85e15p-4, 0x1.7bce19d0d6382p-4, -0x1.0b94a2f4b9711p-4, 0x1.65615c8e95cf1p-5, -0x1.0941abf10b3e6p-3, -0x1.ec787bcd62c39p-5, -0x1.7bb741b2b4588p-3, -0x1.21ba0c2d79025p-2, -0x1.7f95a592b33d7p-3,
        0x1.bd3023153079cp-2, 0x1.bb9c74201f107p-2, -0x1.a0cea3f9530b9p-4, 0x1.b5efcfbda22eap-2, -0x1.b3b735abe3597p-3, 0x1.a7f944c6a92cbp-2, -0x1.6440b6cc3c1aep-2, 0x1.7fa82c7bbe98p-2, -0x1.18a113d8bb95bp-1,
        0x1p+0, 0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0, 0x1p+0, 0x0p+0};
    static constexpr double T_inverse[] = {
        0x1.14f1294c2758ap+12, 0x1.0b9db8f2c7251p+12, 0x1.7d88a531adc44p+10, 0x1.212c462b8af15p+8, 0x1.77d19ed924178p+5, -0x1.406e2bd27b0dcp+0, 0x1.7edac75f3c3b7p+2, -0x1.c0703cbed3d02p+1, 0x1.572ec796f5be6p+0,
        -0x1.772108f3b221fp+12, -0x1.8eab794537d5ap+12, -0x1.2474b30ad2ed4p+11, -0x1.76f2b6bee6401p+8, -0x1.188694340c05ap+4, -0x1.2ab1686307f89p+0, 0x1.0c46e16f4fdd9p+2, -0x1.32a9ee5da02abp+1, 0x1.29453f70280aep+0,
        0x1.4b36e3c80a779p+11, 0x1.2a778a22590c6p+10, -0x1.d571c9aa49875p+8, -0x1.454d082c1671p+8, -0x1.c3022be13698dp+5, -0x1.36376c2fe5772p+4, 0x1.fc77c30e6bb5dp+2, -0x1.7df325948765dp+2, 0x1.01d67e7e95ffap+1,
        0x1.9a95f6d72c4c8p+10, 0x1.37b547e48bfadp+11, 0x1.062caaababee9p+10, 0x1.cbf219af62d2cp+5, -0x1.5c1e17ec079ep+5, -0x1.f32af4c410bd3p-8, -0x1.4033f1ce811ep+2, 0x1.82d415e7e9eaep+1, -0x1.6b7d43375f46p-1,
        -0x1.ecf9a9773319p+10, -0x1.1274db094064ap+10, 0x1.963d999519747p+8, 0x1.016cb687b3396p+8, 0x1.0024975cbfdcbp+5, -0x1.07eab06efa953p+3, 0x1.a8d8fd71502a9p+1, -0x1.ca22b9567997bp+1, 0x1.4f5c8f626b33cp+0,
        -0x1.a91599673835ep+5, -0x1.93e2be57adf2cp+8, -0x1.06ae3ff0f39ecp+8, 0x1.3102dd1f6e839p+5, 0x1.c5ba5911e72dfp+3, 0x1.b8e489b50e206p-1, -0x1.062bfb26673c7p+2, 0x1.2f128702794e8p+1, -0x1.4f771cec83c46p-1,
        0x1.cb106dec8670bp+8, 0x1.7d60ad5467734p+8, -0x1.e053d3e08fcc3p+6, -0x1.43b28b77223f8p+6, 0x1.1a680c3e5e16p+3, 0x1.5b650ea294c77p+2, -0x1.f0d5811faa025p+0, 0x1.d5578978902d3p-4, 0x1.5b7513571994p-4,
        -0x1.2372db71d96cdp+4, 0x1.c52116964977dp+2, 0x1.b7e98d2243d85p+4, -0x1.3b05c8cfdb808p+3, -0x1.bda62f208461bp-4, 0x1.90a07a4fc006ep+0, -0x1.1306ef668efaap+0, 0x1.04ce38c84305bp-1, -0x1.17ceb7a96220cp-3,
        -0x1.2435ed63d1dc6p+4, -0x1.2b33e98d17a6bp+5, 0x1.68482834ea0c6p+2, 0x1.793213788109ep+3, -0x1.de713bd315b8fp+2, 0x1.93d085dcfdaf9p+1, -0x1.34bd0a145beedp+0, 0x1.b092d6523f1fap-2, -0x1.8f390b2bfe802p-4};
};

}  // namespace coefficients

/// The S-stage member of this family, 1 <= S <= 9: every entry is the double nearest to the exact one; in another Scalar, float, that one rounded.
template <int S, class Scalar = double>
transformed_tableau<Scalar, (S > 0 ? S : -1)> gauss() {  // of a variable s: gauss(s) of stagecraft/families.hpp
    constexpr bool generated = 1 <= S && S <= 9;
    static_assert(generated, "gauss: generated for 1 <= S <= 9; see stagecraft/tableaux/rounded.hpp for more");
    transformed_tableau<Scalar, (S > 0 ? S : -1)> t;
    if constexpr (generated) coefficients::unpack<coefficients::gauss<S>>(t);
    return t;
}

/// A number of stages in parentheses is for stagecraft/families.hpp.
template <class Never = void>
transformed_tableau<double> gauss(...) {
    static_assert(detail::never<Never>, "the number of stages stands in angle brackets, gauss<3>(), or include stagecraft/families.hpp for gauss(3)");
    return {};
}

}  // namespace stagecraft
