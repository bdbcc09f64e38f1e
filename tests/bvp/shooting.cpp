// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE bvp_shooting
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/shooting.hpp>
#include <stdexcept>
#include <string>

#include "end_values.hpp"

namespace sc = stagecraft;
using Eigen::Vector2d;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity(), pi = 3.14159265358979323846;

/// growth: x'' = x' + 110 x, modes e^{-10 t} and e^{11 t} (Stoer and Bulirsch). bratu: u'' = -e^u. turn: x'' = -x.
struct rhs {
    enum { growth, bratu, turn } which;
    template <class T, class Y, class F>
    void operator()(const T&, const Y& y, F& f) const {
        using std::exp;
        f[0] = y[1];
        if (which == growth) f[1] = 110 * y[0] + y[1];
        if (which == bratu) f[1] = -exp(y[0]);
        if (which == turn) f[1] = -y[0];
    }
};

auto shoot(const rhs& f, const end_values& r, double b, const Vector2d& guess,
           const sc::shooting_options<double>& o = {}) {
    return sc::shooting(sc::radau_iia<5>(), sc::two_point(f, r), 0.0, b, guess, o);
}

}  // namespace

BOOST_AUTO_TEST_CASE(multiple_shooting_solves_what_single_shooting_cannot) {
    // x(0) = x(10) = 1.
    for (const double growth : {10.0, 30.0, 100.0}) {
        const auto r = shoot({rhs::growth}, {1, 1}, 10, Vector2d(0, 0), {.growth = growth});
        BOOST_TEST(sc::name(r.status) == std::string("success"));
        BOOST_TEST(r.nodes.size() == r.values.size());
        BOOST_TEST(r.newton_steps <= 3);  // linear
        BOOST_TEST(r.growth <= 3 * growth);
        double error = 0;
        for (std::size_t i = 0; i < r.nodes.size(); ++i) {
            const double t = r.nodes[i], down = std::exp(-10 * t), up = std::exp(11 * (t - 10));
            error = std::max({error, std::abs(r.values[i][0] - down - up),
                              std::abs(r.values[i][1] + 10 * down - 11 * up)});
        }
        BOOST_TEST(error < 1e-6);
        BOOST_TEST(r.jump < 1e-7);
    }
    const auto single = shoot({rhs::growth}, {1, 1}, 10, Vector2d(0, 0), {.growth = infinity});
    BOOST_TEST(!single.ok());
}

BOOST_AUTO_TEST_CASE(single_and_multiple_shooting_find_both_solutions_of_bratu) {
    for (const auto& [height, exact] :
         {std::pair{0.1, 0.5493527287752708}, std::pair{4.0, 10.84689901938945}})
        for (const auto& o : {sc::shooting_options<double>{.rtol = 1e-10, .growth = infinity},
                              sc::shooting_options<double>{.rtol = 1e-10, .growth = infinity, .intervals = 4},
                              sc::shooting_options<double>{.rtol = 1e-10, .growth = 5}})
            BOOST_TEST_CONTEXT("height " << height << ", growth " << o.growth << ", " << o.intervals) {
                const double a = height;
                const auto guess = [a](double t) {
                    return Vector2d(a * std::sin(pi * t), a * pi * std::cos(pi * t));
                };
                const auto r = sc::shooting(
                    sc::radau_iia<5>(), sc::two_point(rhs{rhs::bratu}, end_values{0, 0}), 0.0, 1.0, guess, o);
                BOOST_TEST(sc::name(r.status) == std::string("success"), r.message);
                BOOST_TEST(std::abs(r.values[0][1] - exact) < 1e-7 * exact);
            }
}

BOOST_AUTO_TEST_CASE(no_solution_and_bad_arguments) {
    // x'' = -x, x(0) = 0, x(pi) = 1: no solution; M is singular up to the error of the integration.
    const auto r = shoot({rhs::turn}, {0, 1}, pi, Vector2d(0, 0), {.rtol = 1e-12});
    BOOST_TEST((!r.ok() || std::abs(r.values[0][1]) > 1e9));
    BOOST_CHECK_THROW(shoot({rhs::turn}, {0, 1}, -1, Vector2d(0, 0)), std::invalid_argument);
    BOOST_CHECK_THROW(shoot({rhs::turn}, {0, 1}, 1, Vector2d(0, 0), {.rtol = 1e-17}), std::invalid_argument);
    BOOST_CHECK_THROW(shoot({rhs::turn}, {0, 1}, 1, Vector2d(0, 0), {.growth = 0.5}), std::invalid_argument);
}
