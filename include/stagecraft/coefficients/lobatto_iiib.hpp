// SPDX-License-Identifier: BSL-1.0 | written by: stagecraft coefficients lobatto_iiib 6
// clang-format off
#pragma once

#include <stagecraft/coefficients/unpack.hpp>

namespace stagecraft {
namespace coefficients {

template <int S>
struct lobatto_iiib;

template <>
struct lobatto_iiib<2> {
    static constexpr stagecraft::facts facts{.order = 2,
                                             .stage_order = 0,
                                             .a_stable = true,
                                             .algebraically_stable = false,
                                             .symplectic = false,
                                             .symmetric = true,
                                             .r_infinity = -0x1p+0};
    static constexpr double c[] = {
        0x0p+0, 0x1p+0};
    static constexpr double b[] = {
        0x1p-1, 0x1p-1};
    static constexpr double A[] = {
        0x1p-1, 0x0p+0,
        0x1p-1, 0x0p+0};
};

template <>
struct lobatto_iiib<3> {
    static constexpr stagecraft::facts facts{.order = 4,
                                             .stage_order = 1,
                                             .a_stable = true,
                                             .algebraically_stable = false,
                                             .symplectic = false,
                                             .symmetric = true,
                                             .r_infinity = 0x1p+0};
    static constexpr double c[] = {
        0x0p+0, 0x1p-1, 0x1p+0};
    static constexpr double b[] = {
        0x1.5555555555555p-3, 0x1.5555555555555p-1, 0x1.5555555555555p-3};
    static constexpr double A[] = {
        0x1.5555555555555p-3, -0x1.5555555555555p-3, 0x0p+0,
        0x1.5555555555555p-3, 0x1.5555555555555p-2, 0x0p+0,
        0x1.5555555555555p-3, 0x1.aaaaaaaaaaaabp-1, 0x0p+0};
};

template <>
struct lobatto_iiib<4> {
    static constexpr stagecraft::facts facts{.order = 6,
                                             .stage_order = 2,
                                             .a_stable = true,
                                             .algebraically_stable = false,
                                             .symplectic = false,
                                             .symmetric = true,
                                             .r_infinity = -0x1p+0};
    static constexpr double c[] = {
        0x0p+0, 0x1.1b06d1d200913p-2, 0x1.727c9716ffb76p-1, 0x1p+0};
    static constexpr double b[] = {
        0x1.5555555555555p-4, 0x1.aaaaaaaaaaaabp-2, 0x1.aaaaaaaaaaaabp-2, 0x1.5555555555555p-4};
    static constexpr double A[] = {
        0x1.5555555555555p-4, -0x1.1424fbd0ff87p-3, 0x1.a5e9449953715p-5, 0x0p+0,
        0x1.5555555555555p-4, 0x1.d0d4325cffe7dp-3, -0x1.15c4e58ea5c03p-5, 0x0p+0,
        0x1.5555555555555p-4, 0x1.cd63475c7f62bp-2, 0x1.848122f8556d9p-3, 0x0p+0,
        0x1.5555555555555p-4, 0x1.75ed8217803c8p-2, 0x1.1a5e944995371p-1, 0x0p+0};
};

template <>
struct lobatto_iiib<5> {
    static constexpr stagecraft::facts facts{.order = 8,
                                             .stage_order = 3,
                                             .a_stable = true,
                                             .algebraically_stable = false,
                                             .symplectic = false,
                                             .symmetric = true,
                                             .r_infinity = 0x1p+0};
    static constexpr double c[] = {
        0x0p+0, 0x1.61a277d8695abp-3, 0x1p-1, 0x1.a7976209e5a95p-1, 0x1p+0};
    static constexpr double b[] = {
        0x1.999999999999ap-5, 0x1.16c16c16c16c1p-2, 0x1.6c16c16c16c17p-2, 0x1.16c16c16c16c1p-2, 0x1.999999999999ap-5};
    static constexpr double A[] = {
        0x1.999999999999ap-5, -0x1.8b5a173c6ff36p-4, 0x1.1111111111111p-4, -0x1.4a0f1a85b7aap-6, 0x0p+0,
        0x1.999999999999ap-5, 0x1.3846194bef5acp-3, -0x1.4b49100e8c088p-5, 0x1.5c83c29b69ba7p-7, 0x0p+0,
        0x1.999999999999ap-5, 0x1.27cbde58e1ba8p-2, 0x1.6c16c16c16c17p-3, -0x1.10a7242204e65p-6, 0x0p+0,
        0x1.999999999999ap-5, 0x1.0bdd4e01e61e4p-2, 0x1.957fe36de8428p-2, 0x1.ea797dc326faep-4, 0x0p+0,
        0x1.999999999999ap-5, 0x1.2b625dbf1ce6bp-2, 0x1.27d27d27d27d2p-2, 0x1.7997f1e5dd68fp-2, 0x0p+0};
};

template <>
struct lobatto_iiib<6> {
    static constexpr stagecraft::facts facts{.order = 10,
                                             .stage_order = 4,
                                             .a_stable = true,
                                             .algebraically_stable = false,
                                             .symplectic = false,
                                             .symmetric = true,
                                             .r_infinity = -0x1p+0};
    static constexpr double c[] = {
        0x0p+0, 0x1.e12aaca0bcf46p-4, 0x1.6df62279dab2bp-2, 0x1.4904eec312a6bp-1, 0x1.c3daaa6be8617p-1, 0x1p+0};
    static constexpr double b[] = {
        0x1.1111111111111p-5, 0x1.838ef05e9dfc2p-3, 0x1.1c1665ae8edfdp-2, 0x1.1c1665ae8edfdp-2, 0x1.838ef05e9dfc2p-3, 0x1.1111111111111p-5};
    static constexpr double A[] = {
        0x1.1111111111111p-5, -0x1.1f194449ca9fap-4, 0x1.fa3d87fe45574p-5, -0x1.198a5a89ce58cp-5, 0x1.31b9283834be9p-7, 0x0p+0,
        0x1.1111111111111p-5, 0x1.b7c93ff2dbf3fp-4, -0x1.277b02de90428p-5, 0x1.1b9d980253ce3p-6, -0x1.251006bf45a6ep-8, 0x0p+0,
        0x1.1111111111111p-5, 0x1.98566f04fc0c5p-3, 0x1.25d2c9c8915c7p-3, -0x1.894862fcc6e75p-6, 0x1.54fa882f92a75p-8, 0x0p+0,
        0x1.1111111111111p-5, 0x1.78e71c1d2166ep-3, 0x1.34aaebde5b4e4p-2, 0x1.125a01948c633p-3, -0x1.4c77ea65e1031p-7, 0x0p+0,
        0x1.1111111111111p-5, 0x1.8cb7709498295p-3, 0x1.0a5c8c2e69a2fp-2, 0x1.4105c60a60e82p-2, 0x1.4f54a0ca60044p-4, 0x0p+0,
        0x1.1111111111111p-5, 0x1.70735ddb1ab03p-3, 0x1.3f47b0ffc8aafp-2, 0x1.b99d695d8c69dp-3, 0x1.098dc941c1a5fp-2, 0x0p+0};
};

}  // namespace coefficients

/// The S-stage member of this family, 2 <= S <= 6: every entry is the double nearest to the exact one; in another Scalar, float, that one rounded.
template <int S, class Scalar = double>
tableau<Scalar, (S > 0 ? S : -1)> lobatto_iiib() {  // of a variable s: lobatto_iiib(s) of stagecraft/families.hpp
    constexpr bool generated = 2 <= S && S <= 6;
    static_assert(generated, "lobatto_iiib: generated for 2 <= S <= 6; see stagecraft/tableaux/rounded.hpp for more");
    tableau<Scalar, (S > 0 ? S : -1)> t;
    if constexpr (generated) coefficients::unpack<coefficients::lobatto_iiib<S>>(t);
    return t;
}

/// A number of stages in parentheses is for stagecraft/families.hpp.
template <class Never = void>
tableau<double> lobatto_iiib(...) {
    static_assert(detail::never<Never>, "the number of stages stands in angle brackets, lobatto_iiib<3>(), or include stagecraft/families.hpp for lobatto_iiib(3)");
    return {};
}

}  // namespace stagecraft
