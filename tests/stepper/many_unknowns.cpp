// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE many_unknowns
#include "methods.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <stagecraft/dae/projection.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/event.hpp>
#include <stagecraft/observe/observers.hpp>
#include <stagecraft/problem/with.hpp>

namespace sc = stagecraft;

namespace {

// A wave on a ring of n points, y_j' = y_{j-1} - y_{j+1}: y_j = cos(k j - 2 t sin k), ten points per wave.
struct ring {
    void operator()(double, const Eigen::VectorXd& y, Eigen::VectorXd& f) const {
        const Eigen::Index n = y.size();
        for (Eigen::Index j = 0; j < n; ++j) f[j] = y[(j + n - 1) % n] - y[(j + 1) % n];
    }
    static Eigen::VectorXd exact(int n, double t) {
        const double k = std::numbers::pi / 5;
        return (k * Eigen::ArrayXd::LinSpaced(n, 0, n - 1) - 2 * t * std::sin(k)).cos();
    }
};

// What the ring keeps.
struct sum {
    void operator()(double, const Eigen::VectorXd& y, Eigen::Matrix<double, 1, 1>& g) const {
        g[0] = y.sum();
    }
    template <class Matrix>
    void jacobian(double, const Eigen::VectorXd&, Matrix& G) const {
        G.setOnes();
    }
};

}  // namespace

// A dense Jacobian of 200000 unknowns would be 320 GB.
BOOST_AUTO_TEST_CASE(explicit_methods_take_no_room_for_a_jacobian) {
    const int n = 200000;
    const Eigen::VectorXd y0 = ring::exact(n, 0), y1 = ring::exact(n, 1);
    const auto error = [&](const auto& r) { return (r.y - y1).template lpNorm<Eigen::Infinity>(); };
    const auto fixed = sc::integrate(methods::classical(), ring{}, y0, 0, 1, {.fixed_step = 1.0 / 16});
    BOOST_TEST(fixed.ok());
    BOOST_TEST(fixed.report.f == 4 * 16);
    BOOST_TEST(error(fixed) < 1e-6);
    const sc::options<double> o{.rtol = 1e-8, .atol = 1e-8};
    const auto adaptive = sc::integrate(methods::dormand_prince(), ring{}, y0, 0, 1, o);
    BOOST_TEST(adaptive.ok());
    BOOST_TEST(adaptive.report.f == 6 * (adaptive.report.steps + adaptive.report.rejected()) + 1);
    BOOST_TEST(error(adaptive) < 1e-7);

    // nor does what a generic right-hand side, a diagonal mass matrix, a projection or an event asks for
    const auto generic = [](const auto&, const auto& y, auto& f) {
        for (Eigen::Index j = 0, m = y.size(); j < m; ++j) f[j] = 2.0 * (y[(j + m - 1) % m] - y[(j + 1) % m]);
    };
    const Eigen::DiagonalMatrix<double, Eigen::Dynamic> twice(Eigen::VectorXd::Constant(n, 2));
    auto keep_sum = sc::projection_onto<1>(sum{});
    auto watch = sc::events<Eigen::VectorXd>(
        sc::event([](double, const Eigen::VectorXd& y) { return y[0] - y[1]; }, {.terminal = true}));
    auto all = sc::observers(keep_sum, watch);
    const auto r = sc::integrate(methods::dormand_prince(), sc::with_mass(generic, twice), y0, 0, 2, o, all);
    BOOST_TEST(sc::name(r.status) == "event");
    BOOST_TEST(r.t == std::numbers::pi / 20 / std::sin(std::numbers::pi / 5),
               boost::test_tools::tolerance(1e-7));
    BOOST_TEST((r.y - ring::exact(n, r.t)).lpNorm<Eigen::Infinity>() < 1e-7);

    // An implicit method needs it, and takes it.
    const auto implicit = sc::integrate(methods::sdirk_4_3(), ring{}, ring::exact(20, 0), 0, 1, o);
    BOOST_TEST(implicit.ok());
    BOOST_TEST(implicit.report.jacobians > 0);
    BOOST_TEST((implicit.y - y1.head(20)).lpNorm<Eigen::Infinity>() < 1e-7);
}
