// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE families
#include "slopes.hpp"

#include <stagecraft/tableaux/exact_collocation.hpp>
#include <stagecraft/theory/dae/dae_order.hpp>
#include <stdexcept>
#include <string>

// Fixed steps of the run-time stepper at 50 digits show the orders that the theory derives from the exact
// tableau: ordinary differential equations, index 1 and 2 (3: index_3.cpp), and singular perturbations with
// eps << h.

namespace {

// The error of a singular perturbation problem is e_0 + eps e_1 + eps^2 e_2 + ..., eps << h. By differences
// of the errors at 0, where the problem has index 1, eps and 2 eps.
struct expansion {
    vector one, two, at_eps, at_twice;  // e_1, e_2, the errors at eps and 2 eps without e_0
};
template <class Method>
expansion expand(const Method& m, int steps) {
    const fifty eps("1e-14");
    const vector zero = error(m, {kind::index_1}, steps), a = error(m, {kind::perturbed, eps}, steps) - zero,
                 b = error(m, {kind::perturbed, 2 * eps}, steps) - zero;
    return {(4 * a - b) / (2 * eps), (b - 2 * a) / (2 * eps * eps), a, b};
}

const std::vector<member> regular = {{gauss, 2},        {gauss, 3},        {radau_ia, 2},
                                     {radau_ia, 3},     {radau_iia, 2},    {radau_iia, 3},
                                     {lobatto_iiic, 2}, {lobatto_iiic, 3}, {lobatto_iiic, 4}};

}  // namespace

BOOST_AUTO_TEST_CASE(ordinary_differential_equations_show_the_classical_order) {
    for (const auto& m : regular) BOOST_TEST_CONTEXT(name(m.f) << " s = " << m.s) {
            for (const double k : slopes(method(m), {kind::ordinary}, 64))
                is(k, sc::theory::classical_order(exact(m)));
        }
    for (const int s : {5, 7})
        for (const double k : slopes(method({radau_iia, s}), {kind::ordinary}, 64)) is(k, 2 * s - 1);
}

BOOST_AUTO_TEST_CASE(lobatto_iiia_and_iiib_with_singular_a_show_the_classical_order) {
    for (const auto& m : {member{lobatto_iiia, 2}, member{lobatto_iiia, 3}, member{lobatto_iiia, 4},
                          member{lobatto_iiib, 2}, member{lobatto_iiib, 3}, member{lobatto_iiib, 4}})
        BOOST_TEST_CONTEXT(name(m.f) << " s = " << m.s) {
            for (const double k : slopes(sc::tableaux::rounded<fifty>(m.f, m.s), {kind::ordinary}, 64))
                is(k, sc::theory::classical_order(exact(m)));
        }
}

BOOST_AUTO_TEST_CASE(index_1_shows_the_orders_of_theorem_vi_1_1) {
    for (const auto& m : regular) BOOST_TEST_CONTEXT(name(m.f) << " s = " << m.s) {
            const auto predicted = sc::theory::predict_index1(exact(m));
            BOOST_REQUIRE(predicted.applies());
            const auto seen = slopes(method(m), {kind::index_1}, 128);
            is(seen[0], *predicted.y);
            is(seen[1], *predicted.z);
        }
}

BOOST_AUTO_TEST_CASE(index_2_shows_the_predicted_orders_of_y_and_z) {
    for (const auto& m : regular) BOOST_TEST_CONTEXT(name(m.f) << " s = " << m.s) {
            const auto predicted = sc::theory::predict_index2(exact(m));
            BOOST_REQUIRE(predicted.applies());
            // Low orders are asymptotic later.
            const bool late = m.s == 2 || (m.f == lobatto_iiic && m.s == 3);
            const auto seen = slopes(method(m), {kind::index_2}, late ? 256 : 128);
            is(seen[0], *predicted.y);
            is(seen[1], *predicted.y);
            is(seen[2], *predicted.z);
        }
}

// Theorem 7: y = O(h^p) + O(eps h^{q+1}), lambda = O(h^p) + O(eps h^q), or O(h^{q+1}) without stiff accuracy.
// For eps = 1e-30 the terms without eps are seen.
BOOST_AUTO_TEST_CASE(singular_perturbations_with_eps_far_below_h_show_theorem_7) {
    for (const auto& m : {member{radau_iia, 2}, member{radau_iia, 3}, member{radau_ia, 3}})
        BOOST_TEST_CONTEXT(name(m.f) << " s = " << m.s) {
            const auto predicted = sc::theory::predict_singular_perturbation(exact(m));
            BOOST_REQUIRE(predicted.applies());
            const auto seen = slopes(method(m), {kind::perturbed, fifty("1e-30")}, 128);
            is(seen[0], predicted.y[0].h);
            is(seen[1], predicted.lambda[0].h);
        }
}

// Hairer-Wanner II, section VI.3: the coefficient of eps^k is the error of the method on a problem of index
// k + 1. Theorem 7 promises eps h^{q+1} for y and eps h^q for lambda. Where the order of y on index 2 is
// higher (Radau IIA, Lobatto IIIC) y has more, and what it has of order q comes with eps^2 only.
BOOST_AUTO_TEST_CASE(the_part_of_the_error_proportional_to_eps_has_the_orders_of_index_2) {
    for (const auto& m : regular) BOOST_TEST_CONTEXT(name(m.f) << " s = " << m.s) {
            const auto predicted = sc::theory::predict_index2(exact(m));
            BOOST_REQUIRE(predicted.applies());
            const int steps = m.s == 2 ? 96 : 64;
            const auto coarse = expand(method(m), steps), fine = expand(method(m), 2 * steps);
            const auto seen = logarithms(coarse.one, fine.one), next = logarithms(coarse.two, fine.two);
            is(seen[0], *predicted.y);
            is(seen[1], *predicted.z);
            for (const double power : logarithms(fine.at_twice, fine.at_eps)) is(power, 1);
            const auto theorem_7 = sc::theory::predict_singular_perturbation(exact(m));
            BOOST_TEST(theorem_7.applies() == (m.f != gauss));
            if (theorem_7.applies()) BOOST_TEST(seen[0] > theorem_7.y[1].h - 0.05);
            if (theorem_7.lambda.size() > 1) is(seen[1], theorem_7.lambda[1].h);
            const auto third = sc::theory::predict_index3(exact(m));
            BOOST_TEST(third.applies() == (m.f == radau_iia));
            if (!third.applies()) continue;
            is(next[0], *third.z);
            is(next[1], *third.u);
        }
    // Gauss with two stages: the part of lambda does not decrease with h at all, that of order eps^2 grows.
    const auto coarse = expand(method({gauss, 2}), 32), fine = expand(method({gauss, 2}), 64);
    is(logarithms(coarse.one, fine.one)[1], 0);
    is(logarithms(coarse.two, fine.two)[1], -2);
}

BOOST_AUTO_TEST_CASE(lobatto_iiia_shows_its_orders_for_index_1_and_2_although_its_matrix_is_singular) {
    for (const int s : {2, 3, 4, 5}) BOOST_TEST_CONTEXT("s = " << s) {
            const auto m = sc::tableaux::rounded<fifty>(lobatto_iiia, s);
            const auto first = sc::theory::predict_index1(exact({lobatto_iiia, s})),
                       second = sc::theory::predict_index2(exact({lobatto_iiia, s}));
            BOOST_REQUIRE(first.applies());
            BOOST_REQUIRE(second.applies());
            const auto one = slopes(m, {kind::index_1}, 64), two = slopes(m, {kind::index_2}, 64);
            is(one[0], *first.y);
            is(one[1], *first.z);
            is(two[0], *second.y);
            is(two[1], *second.y);
            is(two[2], *second.z);
        }
}

BOOST_AUTO_TEST_CASE(methods_that_the_theorems_refuse_are_refused_or_diverge) {
    // Lobatto IIIB: A is singular, and the first stage is none of the left end.
    for (const int s : {2, 3, 4}) {
        BOOST_TEST(!sc::theory::predict_index1(exact({lobatto_iiib, s})).applies());
        BOOST_TEST(!sc::theory::predict_index1(exact({lobatto_iiib, s})).applies());
        for (const kind k : {kind::index_1, kind::index_2, kind::index_3}) {
            std::string said;
            try {
                error(sc::tableaux::rounded<fifty>(lobatto_iiib, s), {k}, 8);
            } catch (const std::invalid_argument& e) {
                said = e.what();
            }
            BOOST_TEST(said.find("problem.mass() is singular, which method cannot serve") != said.npos);
        }
    }
    // Collocation at 1/6 and 3/4: order 3, but R(inf) = 5/3.
    const auto growing = [](auto one) {
        using number = decltype(one);
        return sc::tableaux::collocation<number>({one / 6, 3 * one / 4}).tableau;
    };
    BOOST_TEST(!sc::theory::predict_index1(growing(sc::tableaux::rational(1))).applies());
    BOOST_TEST(slopes(growing(fifty(1)), {kind::index_1}, 8)[1] < -1);
}
