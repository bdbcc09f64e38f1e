// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE compile_time
#include <boost/test/unit_test.hpp>
#include <stagecraft/tableaux/fixed_rational.hpp>
#include <stagecraft/theory/models/legendre_simplifying.hpp>
#include <stagecraft/theory/stability/schwarz.hpp>

// Everything in this file is proved by the compiler: that it compiles is the test.

namespace {

using stagecraft::tableaux::family;
using stagecraft::tableaux::fixed_rational;
using namespace stagecraft::theory;

// What the theory says of one member of a family (Hairer-Wanner II, Tables IV.5.13, IV.12.1).
struct expected {
    int b, c, d;
    int r_infinity;
    bool algebraically_stable;
};

constexpr bool holds(family f, int s, expected e) {
    const legendre_model<fixed_rational> m(f, s);
    const auto r = tridiagonal_r_infinity(m.A());
    const simplifying found = simplifying_of(m);
    return found == simplifying{e.b, e.c, e.d} && found.bound_is_order() && r.has_value() &&
           *r == fixed_rational(e.r_infinity) && is_algebraically_stable(m) == e.algebraically_stable;
}

template <family F, class Theory>
constexpr bool up_to_20_stages(Theory theory) {
    for (int s = stagecraft::tableaux::least_stages(F); s <= 20; ++s)
        if (!holds(F, s, theory(s))) return false;
    return true;
}

constexpr int minus_one_to(int s) { return s % 2 == 0 ? 1 : -1; }

static_assert(up_to_20_stages<family::gauss>([](int s) {
    return expected{2 * s, s, s, minus_one_to(s), true};
}));
static_assert(up_to_20_stages<family::radau_ia>([](int s) {
    return expected{2 * s - 1, s - 1, s, 0, true};
}));
static_assert(up_to_20_stages<family::radau_iia>([](int s) {
    return expected{2 * s - 1, s, s - 1, 0, true};
}));
static_assert(up_to_20_stages<family::lobatto_iiia>([](int s) {
    return expected{2 * s - 2, s, s - 2, minus_one_to(s + 1), false};
}));
static_assert(up_to_20_stages<family::lobatto_iiib>([](int s) {
    return expected{2 * s - 2, s - 2, s, minus_one_to(s + 1), false};
}));
static_assert(up_to_20_stages<family::lobatto_iiic>([](int s) {
    return expected{2 * s - 2, s - 1, s - 1, 0, true};
}));

// Negative halves: one wrong number each, and a method that is none of these.
static_assert(!holds(family::gauss, 3, {7, 3, 3, -1, true}));
static_assert(!holds(family::gauss, 3, {6, 2, 3, -1, true}));
static_assert(!holds(family::gauss, 3, {6, 3, 2, -1, true}));
static_assert(!holds(family::gauss, 3, {6, 3, 3, 1, true}));
static_assert(!holds(family::gauss, 3, {6, 3, 3, -1, false}));
static_assert(!holds(family::lobatto_iiia, 3, {4, 3, 1, 1, true}));
static_assert(!tridiagonal_r_infinity(legendre_model<fixed_rational>(family::radau_i, 3).A()).has_value());

}  // namespace

BOOST_AUTO_TEST_CASE(orders_and_algebraic_stability_were_proved_by_the_compiler) {
    // Constants, so that the optimiser has nothing to translate: what this file costs is its proofs.
    constexpr bool right = holds(family::radau_iia, 3, {5, 3, 2, 0, true});
    constexpr bool wrong = holds(family::radau_iia, 3, {6, 3, 2, 0, true});
    BOOST_TEST(right);
    BOOST_TEST(!wrong);
}
