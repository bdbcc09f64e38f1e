// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE projection
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/dae/constraint_monitor.hpp>
#include <stagecraft/dae/projection.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/observers.hpp>
#include <stagecraft/problem/semi_explicit.hpp>

#include "problems.hpp"

namespace sc = stagecraft;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector4d;

namespace {

const auto index_2 = sc::semi_explicit<2, 1>(dae::hlr_f{}, dae::hlr_g{});

const auto length = [](const auto&, const auto& y, auto& g) {
    g[0] = (y[0] * y[0] + y[1] * y[1] - 1.0) / 2.0;
};
const auto length_and_speed = [](const auto&, const auto& y, auto& g) {
    g[0] = (y[0] * y[0] + y[1] * y[1] - 1.0) / 2.0;
    g[1] = y[0] * y[2] + y[1] * y[3];
};

struct pendulum_run {
    double length = 0, speed = 0, error = 0, gap = 0;
    long steps = 0;
};

// The index-reduced pendulum to t = 30, its violations at the steps, its error at the end, and the largest
// jump of the continuous solution from step to step.
template <class Projection>
pendulum_run run_pendulum(Projection& projection) {
    pendulum_run r;
    const auto watch = [&](double t, const Vector4d& y, double, const auto& output) {
        r.length = std::max(r.length, std::abs(y.head<2>().norm() - 1));
        r.speed = std::max(r.speed, std::abs(y[0] * y[2] + y[1] * y[3]));
        r.gap = std::max(r.gap, (output(t) - y).norm());
    };
    const auto end = sc::integrate(sc::radau_iia<3>(), dae::pendulum_reduced{}, Vector4d(1, 0, 0, 0), 0, 30,
                                   {.rtol = 1e-6, .atol = 1e-6}, sc::observers(projection, watch));
    BOOST_TEST(end.ok());
    r.error = (end.y - dae::pendulum_by_angle(30)).norm();
    r.steps = end.report.steps;
    return r;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_index_reduced_pendulum_drifts_without_and_stays_with_projection) {
    const auto nothing = [](double, const Vector4d&) {};
    auto keep_length = sc::projection_onto<1>(length);
    auto keep_both = sc::projection_onto<2>(length_and_speed);
    const auto drifting = run_pendulum(nothing), one = run_pendulum(keep_length),
               both = run_pendulum(keep_both);
    BOOST_TEST(drifting.length > 1e-6);
    BOOST_TEST(one.length < 4e-16);
    BOOST_TEST(one.speed > 1e-9);  // not asked for, not kept
    BOOST_TEST(both.length < 4e-16);
    BOOST_TEST(both.speed < 4e-16);
    BOOST_TEST(both.error < 2 * drifting.error);  // the phase is the method's, with or without
    // The correction is of the size of the local error, the step sizes are those of the method.
    BOOST_TEST(keep_both.corrections() > 0);
    BOOST_TEST(keep_both.largest_change() < 1e-6);
    BOOST_TEST(std::abs(both.steps - drifting.steps) <= 2);
    // Dense output ends where the next step begins.
    BOOST_TEST(both.gap < 1e-14);
    BOOST_TEST(keep_both.largest_change() > 1e-9);
    BOOST_TEST_MESSAGE("length " << drifting.length << ", projected " << both.length << "; error "
                                 << drifting.error << ", " << both.error);
}

// Gauss methods on index 2: order s (even) or s + 1 (odd) in y and s - 2 or s - 1 in z (HLR89); projected
// along f_z after every step 2s, in z as well (Ascher and Petzold 1991).
BOOST_AUTO_TEST_CASE(projected_gauss_methods_are_superconvergent_on_index_2) {
    const auto error = [](const auto& method, double h, bool projected) {
        auto keep = sc::projection(index_2, {.hidden = true});
        const sc::options<double> o{.rtol = 1e-14, .atol = 1e-14, .fixed_step = h};
        const auto r = projected ? sc::integrate(method, index_2, Vector3d(1, 1, 1), 0, 0.4, o, keep)
                                 : sc::integrate(method, index_2, Vector3d(1, 1, 1), 0, 0.4, o);
        BOOST_TEST(r.ok());
        return Vector2d(std::abs(r.y[0] - std::exp(0.4)), std::abs(r.y[2] - std::exp(0.8)));
    };
    const auto slope = [&](const auto& method, double h, bool projected, int i) {
        return std::log2(error(method, h, projected)[i] / error(method, h / 2, projected)[i]);
    };
    BOOST_TEST(slope(sc::gauss<2>(), 0.025, false, 0) == 2, boost::test_tools::tolerance(0.05));
    BOOST_TEST(std::abs(slope(sc::gauss<2>(), 0.025, false, 1)) < 0.05);
    BOOST_TEST(slope(sc::gauss<2>(), 0.0125, true, 0) == 4, boost::test_tools::tolerance(0.05));
    BOOST_TEST(slope(sc::gauss<2>(), 0.0125, true, 1) == 4, boost::test_tools::tolerance(0.05));
    BOOST_TEST(slope(sc::gauss<3>(), 0.025, false, 0) == 4, boost::test_tools::tolerance(0.05));
    BOOST_TEST(slope(sc::gauss<3>(), 0.025, true, 0) == 6, boost::test_tools::tolerance(0.05));
    // By the smallest change instead of along f_z it is not: the error along the constraint stays.
    auto nearest = sc::projection(index_2, {.hidden = true, .along_algebraic = false});
    const auto r = sc::integrate(sc::gauss<2>(), index_2, Vector3d(1, 1, 1), 0, 0.4,
                                 {.rtol = 1e-14, .atol = 1e-14, .fixed_step = 0.025}, nearest);
    BOOST_TEST(std::abs(r.y[0] - std::exp(0.4)) > 10 * error(sc::gauss<2>(), 0.025, true)[0]);
}

BOOST_AUTO_TEST_CASE(a_monitor_reports_constraints_and_hidden_ones_along_a_run) {
    const auto look = [](const auto& method, double step) {
        auto watch = sc::monitor_constraints(index_2, Vector3d(1, 1, 1));
        const auto r = sc::integrate(method, index_2, Vector3d(1, 1, 1), 0, 0.4,
                                     {.rtol = 1e-12, .atol = 1e-12, .fixed_step = step}, watch);
        BOOST_TEST(r.ok());
        return Vector3d(watch.largest(0), watch.largest(1), watch.largest(2));
    };
    // Stiffly accurate: g = 0 to rounding, the hidden constraint to the accuracy of z; Gauss leaves both.
    const Vector3d radau = look(sc::radau_iia<3>(), 0.05), finer = look(sc::radau_iia<3>(), 0.025);
    BOOST_TEST(radau[0] < 1e-12);
    BOOST_TEST(radau[1] > 1e-7);
    BOOST_TEST(std::log2(radau[1] / finer[1]) == 3, boost::test_tools::tolerance(0.2));
    BOOST_TEST(radau[2] == 0);
    const Vector3d gauss = look(sc::gauss<2>(), 0.05);
    BOOST_TEST(gauss[0] > 1e-5);
    BOOST_TEST(gauss[1] > 1e-2);
    // With a projection before it, it sees the corrected states.
    auto keep = sc::projection(index_2, {.hidden = true});
    auto watch = sc::monitor_constraints(index_2, Vector3d(1, 1, 1));
    sc::integrate(sc::gauss<2>(), index_2, Vector3d(1, 1, 1), 0, 0.4, {.fixed_step = 0.05},
                  sc::observers(keep, watch));
    BOOST_TEST(watch.largest(0) < 1e-14);
    BOOST_TEST(watch.largest(1) < 1e-13);
    // An inconsistent start shows, and when.
    auto wrong = sc::monitor_constraints(index_2, Vector3d(1, 1, 1));
    sc::integrate(sc::radau_iia<3>(), index_2, Vector3d(1.1, 1, 1), 0, 0.1, {.fixed_step = 0.05}, wrong);
    BOOST_TEST(wrong.largest(0) == 0.21, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(wrong.time(0) == 0);
}

BOOST_AUTO_TEST_CASE(a_projection_that_is_impossible_ends_the_run) {
    const auto run = [](auto g) {
        return sc::integrate(sc::radau_iia<3>(), dae::pendulum_reduced{}, Vector4d(1, 0, 0, 0), 0, 1, {},
                             sc::projection_onto<1>(g));
    };
    const auto message = [](const auto& r) -> std::string {
        try {
            if (r.exception) std::rethrow_exception(r.exception);
        } catch (const std::exception& e) {
            return e.what();
        }
        return "";
    };
    const auto constant = run([](double, const Vector4d&, Eigen::Matrix<double, 1, 1>& g) { g[0] = 1; });
    BOOST_TEST((constant.status == sc::status::function_threw));
    BOOST_TEST(message(constant).find("derivative of equation 0") != std::string::npos);
    const auto nowhere =
        run([](double, const Vector4d& y, Eigen::Matrix<double, 1, 1>& g) { g[0] = y.squaredNorm() + 1; });
    BOOST_TEST((nowhere.status == sc::status::function_threw));
}
