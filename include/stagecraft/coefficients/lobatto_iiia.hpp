// SPDX-License-Identifier: BSL-1.0 | written by: stagecraft coefficients lobatto_iiia 6
// clang-format off
#pragma once

#include <stagecraft/coefficients/unpack.hpp>

namespace stagecraft {
namespace coefficients {

template <int S>
struct lobatto_iiia;

template <>
struct lobatto_iiia<2> {
    static constexpr stagecraft::facts facts{.order = 2,
                                             .stage_order = 2,
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
        0x0p+0, 0x0p+0,
        0x1p-1, 0x1p-1};
};

template <>
struct lobatto_iiia<3> {
    static constexpr stagecraft::facts facts{.order = 4,
                                             .stage_order = 3,
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
        0x0p+0, 0x0p+0, 0x0p+0,
        0x1.aaaaaaaaaaaabp-3, 0x1.5555555555555p-2, -0x1.5555555555555p-5,
        0x1.5555555555555p-3, 0x1.5555555555555p-1, 0x1.5555555555555p-3};
};

template <>
struct lobatto_iiia<4> {
    static constexpr stagecraft::facts facts{.order = 6,
                                             .stage_order = 4,
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
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.c3ca86dc21f1cp-4, 0x1.848122f8556d9p-3, -0x1.15c4e58ea5c03p-5, 0x1.51876a1442c11p-7,
        0x1.2b246812ccfd3p-4, 0x1.cd63475c7f62bp-2, 0x1.d0d4325cffe7dp-3, -0x1.b9d4c61b32719p-6,
        0x1.5555555555555p-4, 0x1.aaaaaaaaaaaabp-2, 0x1.aaaaaaaaaaaabp-2, 0x1.5555555555555p-4};
};

template <>
struct lobatto_iiia<5> {
    static constexpr stagecraft::facts facts{.order = 8,
                                             .stage_order = 5,
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
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.156a6893fb7c2p-4, 0x1.ea797dc326faep-4, -0x1.641e39a498af7p-6, 0x1.5c83c29b69ba7p-7, -0x1.e4fc1212d9a0fp-9,
        0x1.4cccccccccccdp-5, 0x1.3675ea2025d2ep-2, 0x1.6c16c16c16c17p-3, -0x1.fb47e096466dp-6, 0x1.3333333333333p-7,
        0x1.b7e95abac733bp-5, 0x1.0bdd4e01e61e4p-2, 0x1.8258a506604c6p-2, 0x1.3846194bef5acp-3, -0x1.22766f1cbabd4p-6,
        0x1.999999999999ap-5, 0x1.16c16c16c16c1p-2, 0x1.6c16c16c16c17p-2, 0x1.16c16c16c16c1p-2, 0x1.999999999999ap-5};
};

template <>
struct lobatto_iiia<6> {
    static constexpr stagecraft::facts facts{.order = 10,
                                             .stage_order = 6,
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
        0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0, 0x0p+0,
        0x1.76357ea463602p-5, 0x1.4f54a0ca60044p-4, -0x1.e7693cb3d8201p-7, 0x1.f3e32b78ed1dbp-8, -0x1.251006bf45a6ep-8, 0x1.aed073c2f327fp-10,
        0x1.a87ba4fbb80b1p-6, 0x1.b5f22b7d0683cp-3, 0x1.125a01948c633p-3, -0x1.894862fcc6e75p-6, 0x1.82ea22e43e214p-7, -0x1.0e9e517ff104fp-8,
        0x1.32e4db410f31bp-5, 0x1.6b604e305a1ap-3, 0x1.34aaebde5b4e4p-2, 0x1.25d2c9c8915c7p-3, -0x1.9319d8f3443dp-6, 0x1.e699f499a85c3p-8,
        0x1.039a8d72f977dp-5, 0x1.8cb7709498295p-3, 0x1.1446d900ab2b6p-2, 0x1.2b51af942da0dp-2, 0x1.b7c93ff2dbf3fp-4, -0x1.9491b64d493c4p-7,
        0x1.1111111111111p-5, 0x1.838ef05e9dfc2p-3, 0x1.1c1665ae8edfdp-2, 0x1.1c1665ae8edfdp-2, 0x1.838ef05e9dfc2p-3, 0x1.1111111111111p-5};
};

}  // namespace coefficients

/// The S-stage member of this family, 2 <= S <= 6: every entry is the double nearest to the exact one; in another Scalar, float, that one rounded.
template <int S, class Scalar = double>
tableau<Scalar, (S > 0 ? S : -1)> lobatto_iiia() {  // of a variable s: lobatto_iiia(s) of stagecraft/families.hpp
    constexpr bool generated = 2 <= S && S <= 6;
    static_assert(generated, "lobatto_iiia: generated for 2 <= S <= 6; see stagecraft/tableaux/rounded.hpp for more");
    tableau<Scalar, (S > 0 ? S : -1)> t;
    if constexpr (generated) coefficients::unpack<coefficients::lobatto_iiia<S>>(t);
    return t;
}

/// A number of stages in parentheses is for stagecraft/families.hpp.
template <class Never = void>
tableau<double> lobatto_iiia(...) {
    static_assert(detail::never<Never>, "the number of stages stands in angle brackets, lobatto_iiia<3>(), or include stagecraft/families.hpp for lobatto_iiia(3)");
    return {};
}

}  // namespace stagecraft
