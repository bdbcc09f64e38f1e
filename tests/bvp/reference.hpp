// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <problems/stored.hpp>
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/coefficients/gauss.hpp>
#include <string>

namespace sc = stagecraft;

namespace {

constexpr double pi = 3.14159265358979323846;

// The largest error over the points of the reference, relative as the tolerance is.
template <class Solution>
double largest_error(const Solution& y, const problems::boundary_value_case& reference) {
    double worst = 0;
    for (const auto& point : reference.points) {
        const auto value = y(point.front());
        for (Eigen::Index i = 0; i < value.size(); ++i) {
            const double exact = point[static_cast<std::size_t>(i) + 1];
            worst = std::max(worst, std::abs(value[i] - exact) / (1 + std::abs(exact)));
        }
    }
    return worst;
}

template <class Result>
void check(const problems::boundary_value_case& reference, double tolerance, const Result& r) {
    BOOST_TEST_CONTEXT("tolerance " << tolerance << ": " << r.message) {
        BOOST_TEST(name(r.status) == std::string("success"));
        if (!r.ok()) return;
        const double error = largest_error(r.y, reference);
        BOOST_TEST(error <= 3 * tolerance);
        BOOST_TEST(r.error.global <= tolerance);
        BOOST_TEST(error <= 30 * (r.error.global + 1e-14));
        BOOST_TEST(r.error.global <= 100 * (error + 1e-13));
    }
}

}  // namespace
