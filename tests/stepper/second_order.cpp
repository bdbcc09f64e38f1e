// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE second_order
#include <boost/test/unit_test.hpp>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

namespace sc = stagecraft;
using state = Eigen::Matrix<double, 5, 1>;

namespace {

// The pendulum q'' = (0, -1) - q lambda as index 2 (0 = q.v), and the same with its structure told.
struct pendulum {
    template <class S>
    void operator()(const S&, const Eigen::Matrix<S, 5, 1>& y, Eigen::Matrix<S, 5, 1>& f) const {
        f[0] = y[2];
        f[1] = y[3];
        f[2] = -y[0] * y[4];
        f[3] = -y[1] * y[4] - 1.0;
        f[4] = y[0] * y[2] + y[1] * y[3];
    }
    Eigen::Matrix<double, 5, 5> mass() const {
        Eigen::Matrix<double, 5, 5> m = Eigen::Matrix<double, 5, 5>::Identity();
        m(4, 4) = 0;
        return m;
    }
    std::array<int, 5> index() const { return {1, 1, 1, 1, 2}; }
};
struct structured_pendulum : pendulum {
    static constexpr int second_order_components = 2;
};

struct spring {
    static constexpr int second_order_components = 1;
    void operator()(double, const Eigen::Vector2d& y, Eigen::Vector2d& f) const {
        f << y[1], -y[0] - y[0] * y[0] * y[0];
    }
};
struct plain_spring {
    void operator()(double t, const Eigen::Vector2d& y, Eigen::Vector2d& f) const { spring{}(t, y, f); }
};

struct not_so : structured_pendulum {
    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, 5, 1>& y, Eigen::Matrix<S, 5, 1>& f) const {
        pendulum::operator()(t, y, f);
        f[0] += 1.0;
    }
};
struct heavy : structured_pendulum {
    Eigen::Matrix<double, 5, 5> mass() const { return 2 * pendulum::mass(); }
};

}  // namespace

// Elimination of q changes rounding only: the same steps, the same counts.
BOOST_AUTO_TEST_CASE(the_structure_changes_the_work_and_not_the_solution) {
    state y0;
    y0 << 1, 0, 0, 0, 0;
    const auto check = [&](const auto& method, double tol) {
        const auto a = sc::integrate(method, pendulum{}, y0, 0, 3, {.rtol = tol, .atol = tol});
        const auto b = sc::integrate(method, structured_pendulum{}, y0, 0, 3, {.rtol = tol, .atol = tol});
        BOOST_TEST(a.ok());
        BOOST_TEST(b.ok());
        BOOST_TEST(a.report.steps == b.report.steps);
        for (int i = 0; i < 4; ++i) BOOST_TEST(std::abs(a.y[i] - b.y[i]) < 1e-3 * tol);
    };
    check(sc::radau_iia<3>(), 1e-6);
    check(sc::radau_iia<5>(), 1e-8);
    check(sc::radau_iia<4>(), 1e-6);
    const auto c =
        sc::integrate(sc::gauss<2>(), plain_spring{}, Eigen::Vector2d(1, 0), 0, 3, {.fixed_step = 0.01});
    const auto d = sc::integrate(sc::gauss<2>(), spring{}, Eigen::Vector2d(1, 0), 0, 3, {.fixed_step = 0.01});
    BOOST_TEST((c.y - d.y).norm() < 1e-9);
}

BOOST_AUTO_TEST_CASE(a_structure_that_does_not_hold_is_refused) {
    state y0;
    y0 << 1, 0, 0, 0, 0;
    BOOST_CHECK_THROW(sc::integrate(sc::radau_iia<3>(), not_so{}, y0, 0, 1), std::invalid_argument);
    BOOST_CHECK_THROW(sc::integrate(sc::radau_iia<3>(), heavy{}, y0, 0, 1), std::invalid_argument);
}

namespace {

// Masses between two walls, springs of stiffness 1e4 and dampers.
template <int N, bool WithStructure>
struct chain {
    static constexpr int size = N;
    template <class S>
    void operator()(const S&, const Eigen::Matrix<S, N, 1>& y, Eigen::Matrix<S, N, 1>& f) const {
        const int m = static_cast<int>(y.size()) / 2;
        for (int i = 0; i < m; ++i) {
            const S l = i > 0 ? S(y[i - 1]) : S(0.0), r = i + 1 < m ? S(y[i + 1]) : S(0.0);
            f[i] = y[m + i];
            f[m + i] = 1e4 * (l - 2.0 * y[i] + r) - y[i] * y[i] * y[i] - 3.0 * y[m + i];
        }
    }
};
template <int N>
struct chain<N, true> : chain<N, false> {
    static constexpr int second_order_components = N < 0 ? Eigen::Dynamic : N / 2;
};
template <int N, class Method>
void compare_chains(const Method& method, int n) {
    Eigen::Matrix<double, N, 1> y0(n);
    for (int i = 0; i < n; ++i) y0[i] = i < n / 2 ? std::sin(1.0 + i) : 0.0;
    const sc::options<double> options{.rtol = 1e-5, .atol = 1e-5};
    const auto a = sc::integrate(method, chain<N, false>{}, y0, 0, 0.3, options);
    const auto b = sc::integrate(method, chain<N, true>{}, y0, 0, 0.3, options);
    BOOST_REQUIRE(a.ok());
    BOOST_REQUIRE(b.ok());
    BOOST_TEST(a.report.steps == b.report.steps);
    BOOST_TEST(a.report.solves == b.report.solves);
    BOOST_TEST((a.y - b.y).norm() < 1e-9 * a.y.norm());
}

}  // namespace

BOOST_AUTO_TEST_CASE(large_and_run_time_sizes_are_reduced_as_well) {
    compare_chains<22>(sc::radau_iia<3>(), 22);
    compare_chains<Eigen::Dynamic>(sc::radau_iia<3>(), 22);
    compare_chains<Eigen::Dynamic>(sc::radau_iia<3>(), 6);
    const Eigen::VectorXd odd = Eigen::VectorXd::Zero(5);
    BOOST_CHECK_THROW(sc::integrate(sc::radau_iia<3>(), chain<Eigen::Dynamic, true>{}, odd, 0, 1),
                      std::invalid_argument);
}
