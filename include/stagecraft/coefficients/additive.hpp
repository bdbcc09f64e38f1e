// SPDX-License-Identifier: BSL-1.0 | written by: stagecraft coefficients tableaux/pairs/ark3.json tableaux/pairs/ark4.json tableaux/pairs/ark5.json tableaux/pairs/ark4_2019.json tableaux/pairs/ark5_2019.json tableaux/pairs/ars_2_2_2.json tableaux/pairs/ars_4_4_3.json tableaux/pairs/bhr_5_5_3.json
// clang-format off
#pragma once

#include <stagecraft/coefficients/unpack_pair.hpp>

namespace stagecraft {
namespace coefficients {

struct ark3 {
    static constexpr int stages = 4, order = 3, embedded_order = 2;
    static constexpr double c[] = {
        0x0p+0, 0x1.be53cb1d33509p-1, 0x1.3333333333333p-1, 0x1p+0};
    static constexpr double A[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.be53cb1d33509p-1, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.0e2025a055965p-1, 0x1.28986c96ece6fp-4, 0x0p+0, 0x0p+0,
        0x1.98ac9fb3bb468p-2, -0x1.c00f1d22b7d69p-2, 0x1.09d89f5bbf24p+0, 0x0p+0};
    static constexpr double b[] = {
        0x1.8049eff7a82ddp-3, -0x1.30cad498cf138p-1, 0x1.f18e730c4b5fcp-1, 0x1.be53cb1d33509p-2};
    static constexpr double b_embedded[] = {
        0x1.b7c9c153b4808p-3, -0x1.f0ce60628e798p-2, 0x1.bcc9860615cd5p-1, 0x1.9b5673ac889eap-2};
    static constexpr double c_hat[] = {
        0x0p+0, 0x1.be53cb1d33509p-1, 0x1.3333333333333p-1, 0x1p+0};
    static constexpr double A_hat[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.be53cb1d33509p-2, 0x1.be53cb1d33509p-2, 0x0p+0, 0x0p+0,
        0x1.07d4f11ae883ep-2, -0x1.7f095746d5b84p-4, 0x1.be53cb1d33509p-2, 0x0p+0,
        0x1.8049eff7a82ddp-3, -0x1.30cad498cf138p-1, 0x1.f18e730c4b5fcp-1, 0x1.be53cb1d33509p-2};
    static constexpr double b_hat[] = {
        0x1.8049eff7a82ddp-3, -0x1.30cad498cf138p-1, 0x1.f18e730c4b5fcp-1, 0x1.be53cb1d33509p-2};
    static constexpr double b_hat_embedded[] = {
        0x1.b7c9c153b4808p-3, -0x1.f0ce60628e798p-2, 0x1.bcc9860615cd5p-1, 0x1.9b5673ac889eap-2};
};

struct ark4 {
    static constexpr int stages = 6, order = 4, embedded_order = 3;
    static constexpr double c[] = {
        0x0p+0, 0x1p-1, 0x1.53f7ced916873p-2, 0x1.3d70a3d70a3d7p-1, 0x1.b333333333333p-1, 0x1p+0};
    static constexpr double A[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1p-1, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.c6327ed84d339p-3, 0x1.c37a3db3bfb59p-4, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        -0x1.9026bc1683dcap-5, -0x1.6bf8ce2c86828p-3, 0x1.b1714323941bep-1, 0x0p+0, 0x0p+0, 0x0p+0,
        -0x1.3e4b31a174e34p-3, -0x1.6d4413fe05d74p-2, 0x1.0f08a8c576babp+0, 0x1.36ad701f4bc49p-2, 0x0p+0, 0x0p+0,
        0x1.9c845eb60eb4ap-3, 0x1.1e75b2447b54ep-7, 0x1.478e99a792763p-3, 0x1.9d855d8077877p-2, 0x1.cefaf17d28111p-3, 0x0p+0};
    static constexpr double b[] = {
        0x1.43699e59cc843p-3, 0x0p+0, 0x1.7e7b78ae4a1f4p-3, 0x1.5c730dec4ad76p-1, -0x1.19d8a75ca1006p-2, 0x1p-2};
    static constexpr double b_embedded[] = {
        0x1.3cd98a64aa866p-3, 0x0p+0, 0x1.837e02f354096p-3, 0x1.67727dab79094p-1, -0x1.46d90fc117ef3p-2, 0x1.17c84dbe2694dp-2};
    static constexpr double c_hat[] = {
        0x0p+0, 0x1p-1, 0x1.53f7ced916873p-2, 0x1.3d70a3d70a3d7p-1, 0x1.b333333333333p-1, 0x1p+0};
    static constexpr double A_hat[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1p-2, 0x1p-2, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.1a2a4db163bacp-3, -0x1.c8eabffcdab19p-5, 0x1p-2, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.28375f8b0df8ap-3, -0x1.ca9ccfddd777ep-3, 0x1.cc13ffd7793a8p-2, 0x1p-2, 0x0p+0, 0x0p+0,
        0x1.9277cd4bf66cap-4, -0x1.2edee312185acp-1, 0x1.9ec82fcffcb97p-1, 0x1.21f5d997a00dcp-2, 0x1p-2, 0x0p+0,
        0x1.43699e59cc843p-3, 0x0p+0, 0x1.7e7b78ae4a1f4p-3, 0x1.5c730dec4ad76p-1, -0x1.19d8a75ca1006p-2, 0x1p-2};
    static constexpr double b_hat[] = {
        0x1.43699e59cc843p-3, 0x0p+0, 0x1.7e7b78ae4a1f4p-3, 0x1.5c730dec4ad76p-1, -0x1.19d8a75ca1006p-2, 0x1p-2};
    static constexpr double b_hat_embedded[] = {
        0x1.3cd98a64aa866p-3, 0x0p+0, 0x1.837e02f354096p-3, 0x1.67727dab79094p-1, -0x1.46d90fc117ef3p-2, 0x1.17c84dbe2694dp-2};
};

struct ark5 {
    static constexpr int stages = 8, order = 5, embedded_order = 4;
    static constexpr double c[] = {
        0x0p+0, 0x1.a3d70a3d70a3dp-2, 0x1.0a2afb21dfe93p-2, 0x1.95cfec203f0cep-3, 0x1.d70a3d70a3d71p-1, 0x1.eb851eb851eb8p-3, 0x1.3333333333333p-1, 0x1p+0};
    static constexpr double A[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.a3d70a3d70a3dp-2, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.6b97943a490c9p-3, 0x1.517cc412ed8b9p-4, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.f6439e22aed25p-4, 0x0p+0, 0x1.355c3a1dcf477p-4, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.25248a8d4d93ep+1, 0x0p+0, 0x1.67d66e8ee7af2p+3, -0x1.93aeed5b30d6ap+3, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.9c9d7cd8cfaf4p-2, 0x0p+0, 0x1.5aa08e2a8e9b6p+0, -0x1.7c56e4e428805p+0, -0x1.000c94b1f92d6p-5, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.76d1c6e9dd27dp+0, 0x0p+0, 0x1.cebfffb4af84ap+2, -0x1.f60e0b08c0683p+2, -0x1p-3, -0x1p-3, 0x0p+0, 0x0p+0,
        -0x1.acc037a88b5dfp+0, 0x0p+0, -0x1.98ec90119e724p+2, 0x1.d62682087d3f6p+3, 0x1.83c0bdc76db0bp-4, -0x1.cd839a06251b5p+2, 0x1.7d10c3e738be5p+0, 0x0p+0};
    static constexpr double b[] = {
        -0x1.875df4746ba0ep-4, 0x0p+0, 0x0p+0, 0x1.2b5a4929c7f8cp+1, -0x1.1f9aaf3d8d7ap-3, -0x1.0909049c96258p+1, 0x1.86979599cd5cbp-1, 0x1.a3d70a3d70a3dp-3};
    static constexpr double b_embedded[] = {
        -0x1.97de03f45bfa5p-4, 0x0p+0, 0x0p+0, 0x1.341de9cadf422p+1, -0x1.47fbc546edc68p-3, -0x1.127658444ecbbp+1, 0x1.8f2339aacd70ep-1, 0x1.bce4c82cde999p-3};
    static constexpr double c_hat[] = {
        0x0p+0, 0x1.a3d70a3d70a3dp-2, 0x1.0a2afb21dfe93p-2, 0x1.95cfec203f0cep-3, 0x1.d70a3d70a3d71p-1, 0x1.eb851eb851eb8p-3, 0x1.3333333333333p-1, 0x1p+0};
    static constexpr double A_hat[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.a3d70a3d70a3dp-3, 0x1.a3d70a3d70a3dp-3, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.a3d70a3d70a3dp-4, -0x1.85b26461a48d9p-5, 0x1.a3d70a3d70a3dp-3, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.2eb12e164f4a6p-4, 0x0p+0, -0x1.4abf6a50b2785p-4, 0x1.a3d70a3d70a3dp-3, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.32663c0203ab5p-2, 0x0p+0, 0x1.3b5e79c015996p+1, -0x1.0626228804235p+1, 0x1.a3d70a3d70a3dp-3, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.2cd5ea1939c7p-3, 0x0p+0, 0x1.e0e2501a1e814p-4, -0x1.c60bae703c2acp-3, -0x1.f1a9e76572a47p-8, 0x1.a3d70a3d70a3dp-3, 0x0p+0, 0x0p+0,
        0x1.6d7b04c2c960fp-3, 0x0p+0, 0x1.050e1f68ec087p+0, -0x1.c5b991942ef86p-3, -0x1.27ef70b583ee9p-5, -0x1.175033ee4f61dp-1, 0x1.a3d70a3d70a3dp-3, 0x0p+0,
        -0x1.875df4746ba0ep-4, 0x0p+0, 0x0p+0, 0x1.2b5a4929c7f8cp+1, -0x1.1f9aaf3d8d7ap-3, -0x1.0909049c96258p+1, 0x1.86979599cd5cbp-1, 0x1.a3d70a3d70a3dp-3};
    static constexpr double b_hat[] = {
        -0x1.875df4746ba0ep-4, 0x0p+0, 0x0p+0, 0x1.2b5a4929c7f8cp+1, -0x1.1f9aaf3d8d7ap-3, -0x1.0909049c96258p+1, 0x1.86979599cd5cbp-1, 0x1.a3d70a3d70a3dp-3};
    static constexpr double b_hat_embedded[] = {
        -0x1.97de03f45bfa5p-4, 0x0p+0, 0x0p+0, 0x1.341de9cadf422p+1, -0x1.47fbc546edc68p-3, -0x1.127658444ecbbp+1, 0x1.8f2339aacd70ep-1, 0x1.bce4c82cde999p-3};
};

struct ark4_2019 {
    static constexpr int stages = 7, order = 4, embedded_order = 3;
    static constexpr double c[] = {
        0x0p+0, 0x1.f9db22d0e5604p-3, 0x1.afc66d366ca16p-2, 0x1.570a3d70a3d71p-2, 0x1.3333333333333p-4, 0x1.6666666666666p-1, 0x1p+0};
    static constexpr double A[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.f9db22d0e5604p-3, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.f9db22d0e5604p-5, 0x1.708b08dc4ff55p-2, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.b24fd61e47832p-5, 0x1.701ed70abfad4p-2, -0x1.3d7a5177931a4p-4, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.de8da9ab5005ep-5, -0x1.4e1b6d05334efp-3, -0x1.941cfc3331c84p-3, 0x1.82174c339557bp-2, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.13ba3f17df0d8p-1, -0x1.d1e59d1662caap-2, 0x1.419c421f895f3p+0, -0x1.e9c36b4a38afcp-2, -0x1.4adf6300f6a17p-3, 0x0p+0, 0x0p+0,
        0x1.db94ab5359d93p-3, 0x1.db94ab5359d93p-3, -0x1.b3d6f2a5aee2cp+2, 0x1.d728b0c61c35fp+2, -0x1.5ff81343b5be3p+0, 0x1.5bcbefed29fb1p+0, 0x0p+0};
    static constexpr double b[] = {
        0x0p+0, 0x0p+0, 0x1.083faa5679e51p-1, -0x1.2b235fb206e51p-3, 0x1.e0ba60822e391p-3, 0x1.163e6236bf33cp-2, 0x1.f9db22d0e5604p-4};
    static constexpr double b_embedded[] = {
        0x0p+0, 0x0p+0, 0x1.08f89c3d72492p-1, -0x1.36c285670cd74p-3, 0x1.e4cd7f22aa318p-3, 0x1.1a0e9dcd64825p-2, 0x1.f3eab367a0f91p-4};
    static constexpr double c_hat[] = {
        0x0p+0, 0x1.f9db22d0e5604p-3, 0x1.afc66d366ca16p-2, 0x1.570a3d70a3d71p-2, 0x1.3333333333333p-4, 0x1.6666666666666p-1, 0x1p+0};
    static constexpr double A_hat[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.f9db22d0e5604p-4, 0x1.f9db22d0e5604p-4, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.314fa48233495p-3, 0x1.314fa48233495p-3, 0x1.f9db22d0e5604p-4, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.ff5262cc18ca2p-4, 0x1.ff5262cc18ca2p-4, -0x1.38ade54d0f30bp-5, 0x1.f9db22d0e5604p-4, 0x0p+0, 0x0p+0, 0x0p+0,
        -0x1.2b238a3294a64p-4, -0x1.2b238a3294a64p-4, -0x1.f28e68d841c6bp-3, 0x1.5d2efd9dfeab3p-2, 0x1.f9db22d0e5604p-4, 0x0p+0, 0x0p+0,
        -0x1.3945b6e1bdf04p-3, -0x1.3945b6e1bdf04p-3, 0x1.27c114a865028p-4, 0x1.9e0278aaf7c98p-2, 0x1.9fa8fd25405afp-2, 0x1.f9db22d0e5604p-4, 0x0p+0,
        0x0p+0, 0x0p+0, 0x1.083faa5679e51p-1, -0x1.2b235fb206e51p-3, 0x1.e0ba60822e391p-3, 0x1.163e6236bf33cp-2, 0x1.f9db22d0e5604p-4};
    static constexpr double b_hat[] = {
        0x0p+0, 0x0p+0, 0x1.083faa5679e51p-1, -0x1.2b235fb206e51p-3, 0x1.e0ba60822e391p-3, 0x1.163e6236bf33cp-2, 0x1.f9db22d0e5604p-4};
    static constexpr double b_hat_embedded[] = {
        0x0p+0, 0x0p+0, 0x1.08f89c3d72492p-1, -0x1.36c285670cd74p-3, 0x1.e4cd7f22aa318p-3, 0x1.1a0e9dcd64825p-2, 0x1.f3eab367a0f91p-4};
};

struct ark5_2019 {
    static constexpr int stages = 8, order = 5, embedded_order = 4;
    static constexpr double c[] = {
        0x0p+0, 0x1.c71c71c71c71cp-2, 0x1.84762d8388c5bp-1, 0x1.d824c33ae5433p-4, 0x1.6d51bd9c72184p-2, 0x1.70a3d70a3d70ap-1, 0x1.e8f5c28f5c28fp-1, 0x1p+0};
    static constexpr double A[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.c71c71c71c71cp-2, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.c71c71c71c71cp-4, 0x1.4b929f4aa5377p-1, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.78229820c517dp-4, 0x1.226508c5ba551p-5, -0x1.8982ca45e7f97p-7, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        -0x1.5ebe7e024aeddp-2, -0x1.121a2510781bp-2, 0x1.c4e3f04e7498p-4, 0x1.b678b24dcbfd8p-1, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        -0x1.4037d9afb0da3p-7, 0x1.af8804ceda86bp-3, 0x1.36fc3604b9b97p-4, 0x1.a9471f4479a29p-3, 0x1.e2459aae3fca3p-3, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.de118501d6d27p-2, 0x1.4a55066cf334dp+0, 0x1.837cdab330231p-2, -0x1.207d48ade6711p-1, -0x1.273e5d016799ep-2, -0x1.50be05ece6fadp-2, 0x0p+0, 0x0p+0,
        0x1.3a9234d624343p-1, 0x1.3a9234d624343p-1, 0x1.4518e69327149p-2, -0x1.6c9f31f38891dp-1, 0x1.d6fcb14b858cp-4, 0x1.7655b1155d0cap-4, -0x1.4bbf74e6fb3f6p-5, 0x0p+0};
    static constexpr double b[] = {
        0x0p+0, 0x0p+0, 0x1.63a92efc34ba9p-3, 0x1.04e81b08c80b9p-2, 0x1.ef6a31c2bb288p-3, 0x1.3ac856d42888dp-2, -0x1.9990b63fed7dap-3, 0x1.c71c71c71c71cp-3};
    static constexpr double b_embedded[] = {
        0x0p+0, 0x0p+0, 0x1.00eb1bc7aa56p-4, 0x1.055bd73b3374p-2, 0x1.e9874693e1df2p-3, 0x1.98a84d5f44948p-2, -0x1.252fa102b96d9p-3, 0x1.7f2a835612527p-3};
    static constexpr double c_hat[] = {
        0x0p+0, 0x1.c71c71c71c71cp-2, 0x1.84762d8388c5bp-1, 0x1.d824c33ae5433p-4, 0x1.6d51bd9c72184p-2, 0x1.70a3d70a3d70ap-1, 0x1.e8f5c28f5c28fp-1, 0x1p+0};
    static constexpr double A_hat[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.c71c71c71c71cp-3, 0x1.c71c71c71c71cp-3, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.12af1111c1a94p-2, 0x1.12af1111c1a94p-2, 0x1.c71c71c71c71cp-3, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        -0x1.dab0b6f366817p-5, -0x1.dab0b6f366817p-5, 0x1.24e4b50097086p-7, 0x1.c71c71c71c71cp-3, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        -0x1.62c1c550873afp-5, -0x1.62c1c550873afp-5, -0x1.16a44cb9362d8p-5, 0x1.05487fa42c73cp-2, 0x1.c71c71c71c71cp-3, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.0deb0e5e83eb3p-3, 0x1.0deb0e5e83eb3p-3, -0x1.093aea907a92bp-5, 0x1.fb4f1cc1f7ab9p-4, 0x1.2443f9e7f4496p-3, 0x1.c71c71c71c71cp-3, 0x0p+0, 0x0p+0,
        0x1.3cbf1f207affp-2, 0x1.3cbf1f207affp-2, -0x1.5da7ae4282bd8p-1, -0x1.e1e042bd8d841p-5, -0x1.5266712ea7b79p-5, 0x1.cb5ba07e601ebp-1, 0x1.c71c71c71c71cp-3, 0x0p+0,
        0x0p+0, 0x0p+0, 0x1.63a92efc34ba9p-3, 0x1.04e81b08c80b9p-2, 0x1.ef6a31c2bb288p-3, 0x1.3ac856d42888dp-2, -0x1.9990b63fed7dap-3, 0x1.c71c71c71c71cp-3};
    static constexpr double b_hat[] = {
        0x0p+0, 0x0p+0, 0x1.63a92efc34ba9p-3, 0x1.04e81b08c80b9p-2, 0x1.ef6a31c2bb288p-3, 0x1.3ac856d42888dp-2, -0x1.9990b63fed7dap-3, 0x1.c71c71c71c71cp-3};
    static constexpr double b_hat_embedded[] = {
        0x0p+0, 0x0p+0, 0x1.00eb1bc7aa56p-4, 0x1.055bd73b3374p-2, 0x1.e9874693e1df2p-3, 0x1.98a84d5f44948p-2, -0x1.252fa102b96d9p-3, 0x1.7f2a835612527p-3};
};

struct ars_2_2_2 {
    static constexpr int stages = 3, order = 2, embedded_order = 0;
    static constexpr double c[] = {
        0x0p+0, 0x1.2bec333018867p-2, 0x1p+0};
    static constexpr double A[] = {
        0x0p+0, 0x0p+0, 0x0p+0,
        0x1.2bec333018867p-2, 0x0p+0, 0x0p+0,
        -0x1.6a09e667f3bcdp-1, 0x1.b504f333f9de6p+0, 0x0p+0};
    static constexpr double b[] = {
        -0x1.6a09e667f3bcdp-1, 0x1.b504f333f9de6p+0, 0x0p+0};
    static constexpr double c_hat[] = {
        0x0p+0, 0x1.2bec333018867p-2, 0x1p+0};
    static constexpr double A_hat[] = {
        0x0p+0, 0x0p+0, 0x0p+0,
        0x0p+0, 0x1.2bec333018867p-2, 0x0p+0,
        0x0p+0, 0x1.6a09e667f3bcdp-1, 0x1.2bec333018867p-2};
    static constexpr double b_hat[] = {
        0x0p+0, 0x1.6a09e667f3bcdp-1, 0x1.2bec333018867p-2};
};

struct ars_4_4_3 {
    static constexpr int stages = 5, order = 3, embedded_order = 0;
    static constexpr double c[] = {
        0x0p+0, 0x1p-1, 0x1.5555555555555p-1, 0x1p-1, 0x1p+0};
    static constexpr double A[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1p-1, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.38e38e38e38e4p-1, 0x1.c71c71c71c71cp-5, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.aaaaaaaaaaaabp-1, -0x1.aaaaaaaaaaaabp-1, 0x1p-1, 0x0p+0, 0x0p+0,
        0x1p-2, 0x1.cp+0, 0x1.8p-1, -0x1.cp+0, 0x0p+0};
    static constexpr double b[] = {
        0x1p-2, 0x1.cp+0, 0x1.8p-1, -0x1.cp+0, 0x0p+0};
    static constexpr double c_hat[] = {
        0x0p+0, 0x1p-1, 0x1.5555555555555p-1, 0x1p-1, 0x1p+0};
    static constexpr double A_hat[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x0p+0, 0x1p-1, 0x0p+0, 0x0p+0, 0x0p+0,
        0x0p+0, 0x1.5555555555555p-3, 0x1p-1, 0x0p+0, 0x0p+0,
        0x0p+0, -0x1p-1, 0x1p-1, 0x1p-1, 0x0p+0,
        0x0p+0, 0x1.8p+0, -0x1.8p+0, 0x1p-1, 0x1p-1};
    static constexpr double b_hat[] = {
        0x0p+0, 0x1.8p+0, -0x1.8p+0, 0x1p-1, 0x1p-1};
};

struct bhr_5_5_3 {
    static constexpr int stages = 5, order = 3, embedded_order = 0;
    static constexpr double c[] = {
        0x0p+0, 0x1.2548259df7d24p+0, 0x1.f74f45c1284a9p-2, 0x1.51700abb50b4ap-1, 0x1p+0};
    static constexpr double A[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.2548259df7d24p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.8b57716d4a8ep-2, 0x1.afdf514f76f24p-4, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.bcd3c44d6bb0fp-3, 0x0p+0, 0x1.c476334feb90dp-2, 0x0p+0, 0x0p+0,
        -0x1.2895bd0a674cfp-1, -0x1.b64b944022737p-2, 0x1.fc243a787f0f8p+0, 0x1.6e62472f4cf42p-6, 0x0p+0};
    static constexpr double b[] = {
        -0x1.b61172dbdc849p-5, 0x0p+0, 0x1.29a4c13540acep+1, -0x1.d83d09a29e5f4p+0, 0x1.2548259df7d24p-1};
    static constexpr double c_hat[] = {
        0x0p+0, 0x1.2548259df7d24p+0, 0x1.f74f45c1284a9p-2, 0x1.51700abb50b4ap-1, 0x1p+0};
    static constexpr double A_hat[] = {
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.2548259df7d24p-1, 0x1.2548259df7d24p-1, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.e376488f78679p-5, -0x1.1f5f9d196cd17p-3, 0x1.2548259df7d24p-1, 0x0p+0, 0x0p+0,
        0x1.c9628e7b6ad87p-4, -0x1.cee386676e8f6p-3, 0x1.9ad1d39f1ca8fp-3, 0x1.2548259df7d24p-1, 0x0p+0,
        -0x1.b61172dbdc849p-5, 0x0p+0, 0x1.29a4c13540acep+1, -0x1.d83d09a29e5f4p+0, 0x1.2548259df7d24p-1};
    static constexpr double b_hat[] = {
        -0x1.b61172dbdc849p-5, 0x0p+0, 0x1.29a4c13540acep+1, -0x1.d83d09a29e5f4p+0, 0x1.2548259df7d24p-1};
};

}  // namespace coefficients

/// Kennedy-Carpenter ARK3(2)4L[2]SA (C. A. Kennedy, M. H. Carpenter, Appl. Numer. Math. 44 (2003) 139-181), order 3(2), up to the digits published: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
additive_method<Scalar, 4> ark3() {
    return coefficients::unpack_pair<additive_method<Scalar, 4>, coefficients::ark3>();
}

/// Kennedy-Carpenter ARK4(3)6L[2]SA (C. A. Kennedy, M. H. Carpenter, Appl. Numer. Math. 44 (2003) 139-181), order 4(3), up to the digits published: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
additive_method<Scalar, 6> ark4() {
    return coefficients::unpack_pair<additive_method<Scalar, 6>, coefficients::ark4>();
}

/// Kennedy-Carpenter ARK5(4)8L[2]SA (C. A. Kennedy, M. H. Carpenter, Appl. Numer. Math. 44 (2003) 139-181), order 5(4), up to the digits published: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
additive_method<Scalar, 8> ark5() {
    return coefficients::unpack_pair<additive_method<Scalar, 8>, coefficients::ark5>();
}

/// Kennedy-Carpenter ARK4(3)7L[2]SA1 (C. A. Kennedy, M. H. Carpenter, Appl. Numer. Math. 136 (2019) 183-205), order 4(3), up to the digits published: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
additive_method<Scalar, 7> ark4_2019() {
    return coefficients::unpack_pair<additive_method<Scalar, 7>, coefficients::ark4_2019>();
}

/// Kennedy-Carpenter ARK5(4)8L[2]SA2 (C. A. Kennedy, M. H. Carpenter, Appl. Numer. Math. 136 (2019) 183-205), order 5(4), up to the digits published: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
additive_method<Scalar, 8> ark5_2019() {
    return coefficients::unpack_pair<additive_method<Scalar, 8>, coefficients::ark5_2019>();
}

/// ARS(2,2,2) (U. M. Ascher, S. J. Ruuth, R. J. Spiteri, Appl. Numer. Math. 25 (1997) 151-167), order 2, proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
additive_method<Scalar, 3> ars_2_2_2() {
    return coefficients::unpack_pair<additive_method<Scalar, 3>, coefficients::ars_2_2_2>();
}

/// ARS(4,4,3) (U. M. Ascher, S. J. Ruuth, R. J. Spiteri, Appl. Numer. Math. 25 (1997) 151-167), order 3, proved: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
additive_method<Scalar, 5> ars_4_4_3() {
    return coefficients::unpack_pair<additive_method<Scalar, 5>, coefficients::ars_4_4_3>();
}

/// BHR(5,5,3)* (S. Boscarino, Appl. Numer. Math. 59 (2009) 1515-1528; S. Boscarino, G. Russo, SIAM J. Sci. Comput. 31 (2009) 1926-1945), order 3, up to the digits published: every entry is the nearest double; in another Scalar that one rounded.
template <class Scalar = double>
additive_method<Scalar, 5> bhr_5_5_3() {
    return coefficients::unpack_pair<additive_method<Scalar, 5>, coefficients::bhr_5_5_3>();
}

}  // namespace stagecraft
