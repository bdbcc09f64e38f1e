// SPDX-License-Identifier: BSL-1.0
#undef NDEBUG  // the builds in which assertions are made
#define BOOST_TEST_MODULE unwritten
#include <boost/test/unit_test.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/problem/semi_explicit.hpp>

namespace sc = stagecraft;
using Eigen::Vector2d;

namespace {

// y0' = -y0, and nothing is said of y1'.
struct forgetful {
    template <class S>
    void operator()(const S&, const Eigen::Matrix<S, 2, 1>& y, Eigen::Matrix<S, 2, 1>& f) const {
        f[0] = -y[0];
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_component_of_f_that_is_never_written_ends_the_run) {
    const auto r = sc::integrate(sc::radau_iia<2>(), forgetful{}, Vector2d(1, 1), 0, 1);
    BOOST_TEST((r.status == sc::status::non_finite));
    BOOST_TEST((r.y == Vector2d(1, 1)));
}

BOOST_AUTO_TEST_CASE(a_constraint_that_is_never_written_ends_the_run) {
    const auto problem =
        sc::semi_explicit<1, 1>([](const auto&, const auto& y, const auto&, auto& f) { f[0] = -y[0]; },
                                [](const auto&, const auto&, const auto&, auto&) {});
    const auto r = sc::integrate(sc::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1);
    BOOST_TEST(!r.ok());
    BOOST_TEST((r.y == Vector2d(1, 1)));
}
