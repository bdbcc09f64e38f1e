// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE algebraic_stability
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/theory/stability/algebraic_stability.hpp>
#include <stagecraft/theory/stability/ssp.hpp>
#include <stagecraft/theory/stability/symmetry.hpp>
#include <stagecraft/theory/stability/symplectic_pair.hpp>

#include "methods.hpp"

using namespace stagecraft;
using namespace stagecraft::theory;
using methods::q;
using methods::quadratic;
using methods::rational;

namespace {

/// The implicit midpoint rule with a second stage that nobody uses and a third that doubles the first.
tableau<rational> padded_midpoint() {
    return methods::make<rational>({{1, 0, q(-1, 2)}, {5, 7, 1}, {0, 0, q(1, 2)}}, {q(1, 3), 0, q(2, 3)},
                                   {q(1, 2), 13, q(1, 2)});
}

}  // namespace

BOOST_AUTO_TEST_CASE(gauss_radau_iia_and_lobatto_iiic_are_algebraically_stable_lecture_satz_2_15) {
    BOOST_TEST(algebraically_stable(methods::gauss2()).is_proved());
    BOOST_TEST(algebraically_stable(methods::gauss3()).is_proved());
    BOOST_TEST(algebraically_stable(methods::implicit_euler()).is_proved());
    BOOST_TEST(algebraically_stable(methods::radau_iia2()).is_proved());
    BOOST_TEST(algebraically_stable(methods::radau_iia3()).is_proved());
    BOOST_TEST(algebraically_stable(methods::radau_ia3()).is_proved());
    BOOST_TEST(algebraically_stable(methods::lobatto_iiic2()).is_proved());
    BOOST_TEST(algebraically_stable(methods::lobatto_iiic3()).is_proved());
    BOOST_TEST(algebraically_stable(methods::lobatto_iiic4()).is_proved());
    // IIIA and IIIB are A-stable and not algebraically stable
    BOOST_TEST(algebraically_stable(methods::lobatto_iiia3()).is_refuted());
    BOOST_TEST(algebraically_stable(methods::lobatto_iiib3()).is_refuted());
    BOOST_TEST(algebraically_stable(methods::trapezoidal()).is_refuted());
}

BOOST_AUTO_TEST_CASE(the_matrix_m_has_rank_zero_or_one_for_the_families) {
    using tableaux::inertia;
    BOOST_TEST((stability_matrix_inertia(methods::gauss3()) == inertia{0, 3, 0}));
    BOOST_TEST((stability_matrix_inertia(methods::radau_iia3()) == inertia{1, 2, 0}));
    BOOST_TEST((stability_matrix_inertia(methods::radau_ia3()) == inertia{1, 2, 0}));
    BOOST_TEST((stability_matrix_inertia(methods::lobatto_iiic4()) == inertia{1, 3, 0}));
    BOOST_TEST((stability_matrix_inertia(methods::lobatto_iiia3()) == inertia{1, 1, 1}));
}

BOOST_AUTO_TEST_CASE(no_explicit_method_is_algebraically_stable_lecture_satz_2_16) {
    for (const auto& t : {methods::explicit_euler(), methods::heun2(), methods::kutta3(), methods::rk4(),
                          methods::ssp33(), methods::ssp104()}) {
        BOOST_TEST(algebraically_stable(t).is_refuted());
        BOOST_TEST(b_stable(t).is_refuted());
        BOOST_TEST(an_stable(t).is_refuted());
    }
    // the proof's witness: a diagonal entry -b_i^2
    BOOST_TEST(algebraically_stable(methods::explicit_euler()).reason() == "v^T M v = -1 for v = (1)");
    auto negative = methods::implicit_euler();
    negative.b[0] = -1;
    BOOST_TEST(algebraically_stable(negative).reason() == "b[1] = -1 < 0");
}

BOOST_AUTO_TEST_CASE(every_refutation_has_a_vector_that_anyone_can_check) {
    const auto m = stability_matrix(methods::lobatto_iiib3());
    const auto v = tableaux::diagonalise<rational>(m).negative_direction();
    BOOST_TEST_REQUIRE(v.has_value());
    rational value(0);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) value += (*v)[i] * m(i, j) * (*v)[j];
    }
    BOOST_TEST(value < 0);
}

BOOST_AUTO_TEST_CASE(inertia_handles_a_vanishing_diagonal) {
    tableaux::dense<rational> m(3, 3);
    m << rational(0), rational(1), rational(0), rational(1), rational(0), rational(0), rational(0),
        rational(0), rational(0);
    BOOST_TEST((tableaux::diagonalise<rational>(m).inertia() == tableaux::inertia{1, 1, 1}));
    m(0, 1) = 2;
    BOOST_CHECK_THROW(tableaux::diagonalise<rational>(m), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(the_burrage_perturbation_of_gauss2_is_algebraically_stable_of_order_3) {
    auto t = methods::gauss2();
    for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) t.A(i, j) += quadratic(q(i == j ? 1 : -1, 4));
    }
    BOOST_TEST(algebraically_stable(t).is_proved());
    BOOST_TEST((stability_matrix_inertia(t) == tableaux::inertia{1, 1, 0}));
    const auto r = stability_function_of(t);
    BOOST_TEST(*r.at_infinity() == quadratic(q(-1, 2)));
    BOOST_TEST(exponential_fit_of(r).order == 3);
    // with the opposite sign it is not
    auto wrong = methods::gauss2();
    for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) wrong.A(i, j) -= quadratic(q(i == j ? 1 : -1, 4));
    }
    BOOST_TEST(algebraically_stable(wrong).is_refuted());
    BOOST_TEST(b_stable(wrong).is_refuted());
    BOOST_TEST(an_stable(wrong).is_refuted());
}

BOOST_AUTO_TEST_CASE(reducible_methods_are_recognised_and_reduced) {
    const auto t = padded_midpoint();
    BOOST_TEST(dj_irreducible(t).reason() == "stages without influence: 2");
    BOOST_TEST(s_irreducible(t).is_refuted());
    const auto r = reduced(t);
    BOOST_TEST_REQUIRE(r.stages() == 1);
    BOOST_TEST(r.A(0, 0) == q(1, 2));
    BOOST_TEST(r.b[0] == 1);
    BOOST_TEST(dj_irreducible(methods::rk4()).is_proved());
    BOOST_TEST(s_irreducible(methods::rk4()).is_proved());  // equal nodes alone do not make equal stages
    BOOST_TEST(reduced(methods::rk4()).stages() == 4);
}

BOOST_AUTO_TEST_CASE(b_stability_and_symplecticity_of_a_reducible_method_are_those_of_the_reduced_one) {
    const auto t = padded_midpoint();
    BOOST_TEST(algebraically_stable(t).is_refuted());  // the tableau itself is not
    BOOST_TEST(b_stable(t).is_proved());
    BOOST_TEST(an_stable(t).is_proved());
    BOOST_TEST(symplectic(t).is_proved());
    BOOST_TEST(symmetric(t).is_proved());
    BOOST_TEST(symplectic(t).reason() == "M = 0 (reduced to 1 of 3 stages)");
}

BOOST_AUTO_TEST_CASE(gauss_is_symplectic_and_symmetric_lobatto_iiia_iiib_are_symmetric_only) {
    BOOST_TEST(symplectic(methods::gauss2()).is_proved());
    BOOST_TEST(symplectic(methods::gauss3()).is_proved());
    BOOST_TEST(symmetric(methods::gauss3()).is_proved());
    BOOST_TEST(symmetric(methods::lobatto_iiia3()).is_proved());
    BOOST_TEST(symmetric(methods::lobatto_iiib3()).is_proved());
    BOOST_TEST(symmetric(methods::trapezoidal()).is_proved());
    BOOST_TEST(symplectic(methods::trapezoidal()).is_refuted());
    BOOST_TEST(symplectic(methods::lobatto_iiia3()).is_refuted());
    BOOST_TEST(symplectic(methods::radau_iia3()).is_refuted());
    BOOST_TEST(symmetric(methods::radau_iia3()).is_refuted());
    BOOST_TEST(symmetric(methods::lobatto_iiic3()).is_refuted());
    BOOST_TEST(symmetric(methods::rk4()).is_refuted());
    // the numbering does not matter
    auto swapped = methods::gauss2();
    swapped.A.row(0).swap(swapped.A.row(1));
    swapped.A.col(0).swap(swapped.A.col(1));
    std::swap(swapped.c[0], swapped.c[1]);
    BOOST_TEST(symmetric(swapped).is_proved());
}

BOOST_AUTO_TEST_CASE(stiff_accuracy_regularity_and_eigenvalues) {
    BOOST_TEST(stiffly_accurate(methods::radau_iia3()).is_proved());
    BOOST_TEST(stiffly_accurate(methods::lobatto_iiic4()).is_proved());
    BOOST_TEST(stiffly_accurate(methods::lobatto_iiia3()).is_proved());
    BOOST_TEST(stiffly_accurate(methods::gauss2()).is_refuted());
    BOOST_TEST(stiffly_accurate(methods::radau_ia2()).reason() == "A[2][2] = 5/12, b[2] = 3/4");
    BOOST_TEST(regular_matrix(methods::radau_iia2()).reason() == "det A = 1/6");
    BOOST_TEST(regular_matrix(methods::lobatto_iiia3()).is_refuted());
    BOOST_TEST(regular_matrix(methods::lobatto_iiib3()).is_refuted());
    BOOST_TEST(eigenvalues_in_right_half_plane(methods::radau_iia3()).is_proved());
    BOOST_TEST(eigenvalues_in_right_half_plane(methods::gauss3()).is_proved());
    BOOST_TEST(eigenvalues_in_right_half_plane(methods::lobatto_iiic4()).is_proved());
    BOOST_TEST(eigenvalues_in_right_half_plane(methods::lobatto_iiia3()).is_refuted());
    BOOST_TEST(eigenvalues_in_right_half_plane(methods::rk4()).is_refuted());
}

BOOST_AUTO_TEST_CASE(ssp_radii_are_the_published_ones) {
    const auto is = [](const stability_interval<rational>& r, int value) {
        return !r.infinite && r.low <= value && rational(value) <= r.high &&
               r.high - r.low < rational(1, 1000000000);
    };
    BOOST_TEST(is(ssp_radius(methods::explicit_euler()), 1));
    BOOST_TEST(is(ssp_radius(methods::heun2()), 1));
    BOOST_TEST(is(ssp_radius(methods::ssp33()), 1));
    BOOST_TEST(is(ssp_radius(methods::ssp104()), 6));
    BOOST_TEST(is(ssp_radius(methods::rk4()), 0));
    BOOST_TEST(is(ssp_radius(methods::kutta3()), 0));
    BOOST_TEST(is(ssp_radius(methods::midpoint()), 2));
    BOOST_TEST(is(ssp_radius(methods::trapezoidal()), 2));
    BOOST_TEST(ssp_radius(methods::implicit_euler()).infinite);
    BOOST_TEST(ssp_radius(methods::gauss2()).high == quadratic(0));
}

BOOST_AUTO_TEST_CASE(lobatto_iiia_and_iiib_are_a_symplectic_pair_for_every_s) {
    using tableaux::family;
    for (int s = 2; s <= 60; ++s) {
        const legendre_model<rational> iiia(family::lobatto_iiia, s), iiib(family::lobatto_iiib, s);
        BOOST_TEST(symplectic_pair(iiia, iiib).is_proved());
        BOOST_TEST(symplectic_pair(iiib, iiia).is_proved());
        BOOST_TEST(symplectic_pair(iiia, iiia).is_refuted());
        BOOST_TEST(symplectic_pair(iiia, legendre_model<rational>(family::lobatto_iiic, s)).is_refuted());
    }
    const legendre_model<rational> gauss(family::gauss, 5);  // symplectic by itself
    BOOST_TEST(symplectic_pair(gauss, gauss).is_proved());
    BOOST_CHECK_THROW(symplectic_pair(gauss, legendre_model<rational>(family::radau_iia, 5)),
                      std::invalid_argument);
}
