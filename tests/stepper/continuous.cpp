// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE continuous
#include "methods.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/radau_ia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/event.hpp>
#include <stagecraft/observe/observers.hpp>
#include <stagecraft/observe/output_times.hpp>
#include <stagecraft/problem/with.hpp>
#include <stagecraft/radau_iia_variable.hpp>
#include <stdexcept>
#include <string>

// options.continuous: the tolerance between the ends of the steps.

namespace sc = stagecraft;
using V1 = Eigen::Matrix<double, 1, 1>;

namespace {

struct outcome {
    double between;  // largest error at a thousand times, in units of the tolerance
    long steps;
};

// y' = lambda (y - cos t) - sin t, y = cos t.
template <class Method>
outcome look(const Method& method, double lambda, double tol, bool continuous) {
    const auto f = [lambda](double t, const V1& y, V1& out) {
        out[0] = lambda * (y[0] - std::cos(t)) - std::sin(t);
    };
    std::vector<double> times;
    for (int k = 0; k <= 1000; ++k) times.push_back(k / 50.0);
    sc::output_times<V1> table(times);
    const auto r =
        sc::integrate(method, f, V1(1.0), 0, 20, {.rtol = tol, .atol = tol, .continuous = continuous}, table);
    BOOST_TEST(r.ok());
    outcome o{0, r.report.steps};
    for (int i = 0; i < table.filled(); ++i)
        o.between = std::max(o.between, std::abs(table.y(i)[0] - std::cos(table.time(i))) / tol);
    return o;
}

template <class Method>
std::string refusal(const Method& method, double step = 0) {
    const auto f = [](double, const V1& y, V1& out) { out = -y; };
    try {
        sc::integrate(method, f, V1(1.0), 0, 1, {.fixed_step = step, .continuous = true});
        return "accepted";
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
}

}  // namespace

// In stiff components the ends of the steps lie on the solution however long the steps are; what lies between
// is interpolated.
BOOST_AUTO_TEST_CASE(the_tolerance_holds_between_the_ends_of_the_steps_where_it_is_asked_for) {
    const auto holds = [](const auto& method) {
        for (const double lambda : {-1.0, -1e2, -1e4, -1e8})
            for (const double tol : {1e-4, 1e-7, 1e-10}) {
                BOOST_TEST_CONTEXT("lambda = " << lambda << " tol = " << tol)
                BOOST_TEST(look(method, lambda, tol, true).between < 25);
            }
    };
    holds(sc::radau_iia<3>());
    holds(sc::radau_iia<5>());
    holds(sc::radau_iia<7>());
    holds(sc::radau_iia_variable());
    BOOST_TEST(look(sc::gauss<3>(), -1, 1e-10, true).between < 25);
    // It is not so by itself, and costs steps.
    const auto without = look(sc::radau_iia<3>(), -1e4, 1e-4, false);
    BOOST_TEST(without.between > 1000);
    BOOST_TEST(without.steps < look(sc::radau_iia<3>(), -1e4, 1e-4, true).steps);
    // With the order free it costs few.
    BOOST_TEST(look(sc::radau_iia_variable(), -1e4, 1e-10, true).steps <
               2 * look(sc::radau_iia_variable(), -1e4, 1e-10, false).steps);
}

BOOST_AUTO_TEST_CASE(methods_that_do_not_know_the_error_between_the_ends_say_so) {
    BOOST_TEST(refusal(sc::radau_iia<2>()) == "accepted");
    for (const auto& message :
         {refusal(sc::radau_iia<1>()), refusal(sc::radau_ia<3>()), refusal(methods::dormand_prince())})
        BOOST_TEST(message.find("continuous") != std::string::npos);
    const auto equal_steps = refusal(sc::radau_iia<2>(), 0.1);  // have no estimate that could hold anywhere
    BOOST_TEST(equal_steps.find("continuous") != std::string::npos);
}

// z = sin(200 pi t) follows without a derivative beside a slow oscillator: at the ends of the steps it is exact, however long
// they are. It crosses 1/2 200 times in (0, 1).
BOOST_AUTO_TEST_CASE(algebraic_components_are_controlled_between_the_ends_where_somebody_looks_there) {
    using Eigen::Vector3d;
    const auto wave = sc::with_mass(
        [](double t, const Vector3d& u, Vector3d& f) {
            f << 2 * M_PI * u[1], -2 * M_PI * u[0], u[2] - std::sin(200 * M_PI * t);
        },
        Eigen::Matrix3d(Vector3d(1, 1, 0).asDiagonal()));
    for (const double tol : {1e-3, 1e-6}) {
        const sc::options<double> o{.rtol = tol, .atol = tol};
        std::vector<double> times;
        for (int j = 0; j <= 1000; ++j) times.push_back(j / 1000.0 * 0.999);
        sc::output_times<Vector3d> out(times);
        auto watch = sc::events<Vector3d>(sc::event([](double, const Vector3d& y) { return y[2] - 0.5; }));
        const auto seen =
            sc::integrate(sc::radau_iia<3>(), wave, Vector3d(1, 0, 0), 0, 1, o, sc::observers(out, watch));
        BOOST_TEST(seen.ok());
        BOOST_TEST(watch.found().size() == 200u);
        double worst = 0;
        for (int j = 0; j < out.filled(); ++j)
            worst = std::max(worst, std::abs(out.y(j)[2] - std::sin(200 * M_PI * out.time(j))));
        BOOST_TEST(worst < 20 * tol);
        // Nobody looks there: nothing is paid.
        long ends = 0;
        const auto count = [&](double, const Vector3d&) { ++ends; };
        const auto unseen = sc::integrate(sc::radau_iia<3>(), wave, Vector3d(1, 0, 0), 0, 1, o),
                   counted = sc::integrate(sc::radau_iia<3>(), wave, Vector3d(1, 0, 0), 0, 1, o,
                                           sc::observers(count));
        BOOST_TEST(10 * unseen.report.steps < seen.report.steps);
        BOOST_TEST(counted.report.f == unseen.report.f);
    }
}

// A table of 600 entries that a stiff component follows: the coefficients of the stages do not see every kink.
BOOST_AUTO_TEST_CASE(kinks_of_a_forcing_are_seen_between_the_ends) {
    std::vector<double> table(601), times;
    unsigned seed = 12345;
    for (auto& v : table) seed = seed * 1664525U + 1013904223U, v = (seed >> 8) / double(1 << 24);
    for (int j = 0; j <= 1200; ++j) times.push_back(j * 0.5);
    const auto u = [&](double t) {
        const int i = std::min(599, int(t));
        return table[std::size_t(i)] + (table[std::size_t(i + 1)] - table[std::size_t(i)]) * (t - i);
    };
    for (const double k : {1e5, 1e7})
        for (const double tol : {1e-4, 1e-6}) {
            sc::output_times<V1> out(times);
            const auto follow = [&](double t, const V1& x, V1& f) { f[0] = -k * (x[0] - u(t)); };
            const auto r = sc::integrate(sc::radau_iia<3>(), follow, V1(0.5), 0, 600,
                                         {.rtol = tol, .atol = tol, .continuous = true}, out);
            BOOST_TEST(r.ok());
            double worst = 0;
            for (int j = 5; j < out.filled(); ++j)
                worst = std::max(worst, std::abs(out.y(j)[0] - u(out.time(j))));
            BOOST_TEST(worst < 1.1 / k + 100 * tol);
        }
}
