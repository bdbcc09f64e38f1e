// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE intervals
#include <boost/test/unit_test.hpp>
#include <stagecraft/stabilised.hpp>
#include <stagecraft/tableaux/rational.hpp>
#include <stagecraft/theory/models/matrix_model.hpp>
#include <stagecraft/theory/stability/stabilised_interval.hpp>
#include <stagecraft/theory/stability/stability_function.hpp>
#include <stagecraft/theory/trees/tree_order.hpp>
#include <stdexcept>

// Stabilised methods in rational arithmetic: |R| <= 1 on the whole of [-beta, 0] for every s to 50, the published lengths beta,
// and the order of the tableau that the recurrence adds up to.

using namespace stagecraft;
using tableaux::rational;
using theory::decide_stabilised_interval;

namespace {

using method = stabilised_method<rational>;
const method chebyshev_2 = {stabilised_family::chebyshev, 2, rational(2, 13)},
             chebyshev_1 = {stabilised_family::chebyshev, 1, rational(1, 20)},
             legendre_1 = {stabilised_family::legendre, 1, 0},
             legendre_2 = {stabilised_family::legendre, 2, 0},
             gegenbauer_1 = {stabilised_family::gegenbauer, 1, 0},
             gegenbauer_2 = {stabilised_family::gegenbauer, 2, 0};
const method* const all[] = {&chebyshev_1, &chebyshev_2,  &legendre_1,
                             &legendre_2,  &gegenbauer_1, &gegenbauer_2};

}  // namespace

BOOST_AUTO_TEST_CASE(every_number_of_stages_to_50_is_stable) {
    for (const method* m : all)
        for (int s = m->order; s <= 50; ++s) {
            const auto found = decide_stabilised_interval(*m, s);
            BOOST_TEST_CONTEXT("family " << static_cast<int>(m->family) << ", order " << m->order << ", s "
                                         << s) {
                BOOST_TEST(found.stable);
                BOOST_TEST(
                    (found.largest_stage <= rational(1)));  // no stage is larger than y on the interval
                if (m->damping > rational(0) && s > 2) BOOST_TEST((found.damped < rational(24, 25)));
            }
        }
}

BOOST_AUTO_TEST_CASE(the_lengths_are_the_published_ones) {
    for (int s = 2; s <= 50; ++s) {
        const auto beta = [s](const method& m) { return decide_stabilised_interval(m, s).beta; };
        // Exactly: Meyer, Balsara and Aslam 2014; Skaras, Saxton, Meyer and Aslam 2021.
        BOOST_TEST((beta(legendre_1) == rational(s * (s + 1))));
        BOOST_TEST((beta(legendre_2) == rational(s * s + s - 2, 2)));
        BOOST_TEST((beta(gegenbauer_1) == rational(s * (s + 3), 2)));
        BOOST_TEST((beta(gegenbauer_2) == rational((s - 1) * (s + 4), 3)));
        // About, for small damping: 2 (1 - 2 eps/3) s^2 and 2/3 (s^2 - 1)(1 - 2 eps/15) (Sommeijer, Shampine and Verwer 1998).
        const rational one = beta(chebyshev_1) / rational(s * s),
                       two = beta(chebyshev_2) / rational(s * s - 1) * rational(3, 2) / rational(191, 195);
        BOOST_TEST((one > rational(193, 100) && one < rational(195, 100)));
        BOOST_TEST((two > rational(99, 100) && two < rational(101, 100)));
        // What rkc2 is told to choose: s = 1 + sqrt(1 + 1.54 h rho) is enough.
        BOOST_TEST((rational((s - 1) * (s - 1) - 1) <= rational(154, 100) * beta(chebyshev_2)));
    }
    // Damping that is too small for the order-2 weights of no family, and none at all: |R| = 1 is reached and not passed.
    BOOST_TEST((decide_stabilised_interval({stabilised_family::chebyshev, 1, 0}, 7).beta == rational(98)));
    BOOST_TEST((decide_stabilised_interval({stabilised_family::chebyshev, 1, 0}, 7).damped == rational(1)));
}

BOOST_AUTO_TEST_CASE(the_tableau_has_the_order_and_the_stability_function) {
    for (const method* m : all)
        for (int s = 2; s <= 8; ++s) {
            const auto t = theory::stabilised_tableau(*m, s);
            const auto order = theory::order_of(theory::matrix_model<rational>(t), 4);
            BOOST_TEST(order.order == m->order);
            BOOST_TEST(order.is_exact());
            for (int i = 0; i < s; ++i) BOOST_TEST((t.c[i] == t.A.row(i).sum()));
            // At the end of the interval w_0 + w_1 z = -1: the least or the largest value, as s is odd or even.
            const auto R = theory::stability_function_of<rational>(t);
            const auto found = decide_stabilised_interval(*m, s);
            const rational at_end = R(-found.beta);
            BOOST_TEST((s % 2 == 1 ? at_end == found.smallest : at_end <= rational(1)));
            BOOST_TEST((R(-found.beta / rational(3)) <= rational(1) &&
                        R(-found.beta / rational(3)) >= found.smallest));
            // Beyond it |R| exceeds its bound.
            const rational beyond = R(-found.beta * rational(6, 5));
            BOOST_TEST((beyond > found.damped || beyond < -found.damped || beyond < found.smallest));
        }
}

BOOST_AUTO_TEST_CASE(bad_methods_are_named) {
    using rows = stabilised_recurrence<double>;
    BOOST_CHECK_THROW(rows({stabilised_family::chebyshev, 3, 0.1}), std::invalid_argument);
    BOOST_CHECK_THROW(rows({stabilised_family::chebyshev, 2, -0.1}), std::invalid_argument);
    BOOST_CHECK_THROW(rows({stabilised_family::legendre, 2, 0.0, 1}), std::invalid_argument);
}
