// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE stage_order
#include <Eigen/Core>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/coefficients/lobatto_iiic.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stdexcept>
#include <string>

#include "../stepper/methods.hpp"

// What a step of stage order q leaves in components of index 3 is O(h^{q-1}) (HLR89, section 6): with q = 1 they do not
// converge, and adaptive steps are refused.

namespace sc = stagecraft;

namespace {

/// y' = z, z' = u, 0 = y - t^2.
struct parabola {
    void operator()(double t, const Eigen::Vector3d& x, Eigen::Vector3d& f) const {
        f << x[1], x[2], x[0] - t * t;
    }
    void jacobian(double, const Eigen::Vector3d&, Eigen::Matrix3d& J) const {
        J << 0, 1, 0, 0, 0, 1, 1, 0, 0;
    }
    Eigen::Matrix3d mass() const { return Eigen::Vector3d(1, 1, 0).asDiagonal(); }
    std::array<int, 3> index() const { return {1, 2, 3}; }
};

/// The error of u, which is 2, after a step of h and one of h/2.
template <class Method>
double error_of_unequal_steps(const Method& method, double h) {
    const Eigen::Vector3d start(0, 0, 2);
    const auto one = sc::integrate(method, parabola{}, start, 0, h, {.fixed_step = h});
    const auto two = sc::integrate(method, parabola{}, one.y, h, 1.5 * h, {.fixed_step = h / 2});
    BOOST_TEST((one.ok() && two.ok()));
    return std::abs(two.y[2] - 2);
}

template <class Method>
std::string run(const Method& method) {
    try {
        return sc::name(
            sc::integrate(method, parabola{}, Eigen::Vector3d(0, 0, 2), 0, 1, {.rtol = 1e-6, .atol = 1e-6})
                .status);
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
}

template <class Method>
void does_not_converge_and_is_refused(const Method& method) {
    for (const double h : {0.1, 0.01, 0.001}) BOOST_TEST(error_of_unequal_steps(method, h) > 0.1);
    const std::string message = run(method);
    BOOST_TEST_CONTEXT(message)
    for (const char* part : {"stage order 2", "index() 3", "radau_iia<3>()"})
        BOOST_TEST(message.find(part) != std::string::npos);
}

template <class Method>
void converges_and_is_served(const Method& method) {
    for (const double h : {0.1, 0.01, 0.001}) BOOST_TEST(error_of_unequal_steps(method, h) < 1e-6);
    BOOST_TEST(run(method) == "success");
}

}  // namespace

BOOST_AUTO_TEST_CASE(stages_of_order_one_are_refused_to_index_3) {
    does_not_converge_and_is_refused(methods::sdirk_4_3());
    does_not_converge_and_is_refused(sc::lobatto_iiic<2>());
    does_not_converge_and_is_refused(sc::radau_iia<1>());
}

BOOST_AUTO_TEST_CASE(stages_of_order_two_are_not) {
    converges_and_is_served(methods::tr_bdf2());
    converges_and_is_served(sc::radau_iia<2>());
    converges_and_is_served(sc::lobatto_iiic<3>());
}
