// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE asymptotic_expansion
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/mechanics/asymptotic_expansion.hpp>

#include <problems/rolling_disc/disc.hpp>

using namespace stagecraft;

namespace {

// y' = z, eps z' = -y - z: linear, so the exact solution is a sum of two exponentials.
struct overdamped_oscillator {
    static constexpr int slow = 1, fast = 1;
    template <class S>
    Eigen::Matrix<S, 1, 1> f(const Eigen::Matrix<S, 1, 1>&, const Eigen::Matrix<S, 1, 1>& z) const {
        return z;
    }
    template <class S>
    Eigen::Matrix<S, 1, 1> g(const Eigen::Matrix<S, 1, 1>& y, const Eigen::Matrix<S, 1, 1>& z) const {
        return Eigen::Matrix<S, 1, 1>(S(-y[0] - z[0]));
    }
};

// Van der Pol's equation on its slow manifold: g_z = 1 - y^2.
struct van_der_pol {
    static constexpr int slow = 1, fast = 1;
    template <class S>
    Eigen::Matrix<S, 1, 1> f(const Eigen::Matrix<S, 1, 1>&, const Eigen::Matrix<S, 1, 1>& z) const {
        return z;
    }
    template <class S>
    Eigen::Matrix<S, 1, 1> g(const Eigen::Matrix<S, 1, 1>& y, const Eigen::Matrix<S, 1, 1>& z) const {
        return Eigen::Matrix<S, 1, 1>(S((S(1) - y[0] * y[0]) * z[0] - y[0]));
    }
};

// The full problem by brute force: one integrator for all of them.
template <class Problem>
Eigen::VectorXd full(const Problem& problem, const Eigen::VectorXd& start, double eps, double t) {
    const auto p = perturbed(problem, eps);
    constexpr int size = decltype(p)::size;
    detail::erased_problem system;
    system.M = p.mass();
    system.f = [p](double time, const Eigen::VectorXd& y, Eigen::VectorXd& out) {
        const Eigen::Matrix<double, size, 1> fixed = y;
        Eigen::Matrix<double, size, 1> value;
        p(time, fixed, value);
        out = value;
    };
    return detail::run(system, start, t, 1e-12);
}

struct slopes {
    double y0, z0, y1, z1;  // of the remainders in eps, N = 0 and N = 1
};

// Remainders at t = far and inside the layer, at t = 1.5 eps, whichever is larger, against eps = 4^-k.
template <class Problem, class Y, class Z>
slopes remainders(const Problem& problem, const Y& y, const Z& z, double eps, double far, double layer_end) {
    const asymptotic_expansion<Problem> expansion(problem, y, z, layer_end);
    Eigen::VectorXd start(y.size() + z.size());
    start << y, z;
    double last[4] = {}, now[4] = {};
    for (int k = 0; k < 2; ++k, eps /= 4) {
        for (double& x : now) x = 0;
        for (const double t : {1.5 * eps, far}) {
            const Eigen::VectorXd exact = full(problem, start, eps, t);
            for (int N = 0; N < 2; ++N) {
                const auto [ye, ze] = expansion(N, eps, t);
                now[2 * N] = std::max(now[2 * N], (exact.head(y.size()) - ye).norm());
                now[2 * N + 1] = std::max(now[2 * N + 1], (exact.tail(z.size()) - ze).norm());
            }
        }
        if (k == 0) std::copy(now, now + 4, last);
    }
    const auto order = [&](int i) { return std::log(last[i] / now[i]) / std::log(4.0); };
    return {order(0), order(1), order(2), order(3)};
}

void has_orders_1_and_2(const slopes& s) {
    BOOST_TEST(std::abs(s.y0 - 1) < 0.15);
    BOOST_TEST(std::abs(s.z0 - 1) < 0.15);
    BOOST_TEST(std::abs(s.y1 - 2) < 0.15);
    BOOST_TEST(std::abs(s.z1 - 2) < 0.15);
}

template <int N>
Eigen::Matrix<double, N, 1> repeat(double x) {
    return Eigen::Matrix<double, N, 1>::Constant(x);
}

}  // namespace

BOOST_AUTO_TEST_CASE(theorem_6_on_a_linear_problem_with_known_solution) {
    const double eps = 1e-3, root = std::sqrt(1 - 4 * eps), t = 0.5;
    const double slow = (-1 + root) / (2 * eps), fast = (-1 - root) / (2 * eps);
    // y(0) = 1, z(0) = 1: y = a e^{slow t} + b e^{fast t}
    const double b = (1 - slow) / (fast - slow), a = 1 - b;
    const double y = a * std::exp(slow * t) + b * std::exp(fast * t);
    const Eigen::VectorXd brute = full(overdamped_oscillator{}, Eigen::Vector2d(1, 1), eps, t);
    BOOST_TEST(std::abs(brute[0] - y) < 1e-10);
    const asymptotic_expansion<overdamped_oscillator> expansion({}, repeat<1>(1), repeat<1>(1));
    // By hand: z_0 = -y_0, y_0 = e^-t, zeta_0 = 2 e^-xi, eta_0 = -2 e^-xi, y_1(0) = 2.
    const auto o = expansion.outer(t);
    const auto l = expansion.layer(1.0);
    BOOST_TEST(std::abs(o.y0[0] - std::exp(-t)) < 1e-9);
    BOOST_TEST(std::abs(o.z0[0] + std::exp(-t)) < 1e-9);
    BOOST_TEST(std::abs(o.y1[0] - (2 - t) * std::exp(-t)) < 1e-9);
    BOOST_TEST(std::abs(l.zeta0[0] - 2 * std::exp(-1.0)) < 1e-9);
    BOOST_TEST(std::abs(l.eta0[0] + 2 * std::exp(-1.0)) < 1e-9);
    BOOST_TEST(std::abs(expansion(1, eps, t).first[0] - y) < 20 * eps * eps);
    BOOST_TEST(std::abs(expansion(0, eps, t).first[0] - y) > 20 * eps * eps);
    has_orders_1_and_2(remainders(overdamped_oscillator{}, repeat<1>(1), repeat<1>(1), 4e-3, 0.5, 40));
}

BOOST_AUTO_TEST_CASE(theorem_6_on_van_der_pol) {
    has_orders_1_and_2(remainders(van_der_pol{}, repeat<1>(2), repeat<1>(-0.2), 4e-3, 0.3, 20));
}

BOOST_AUTO_TEST_CASE(theorem_6_on_the_strongly_damped_disc) {
    const rolling_disc::disc<> body;
    const strongly_damped<rolling_disc::disc<>> problem{body, 2, 2};
    const auto q = rolling_disc::initial_position(), v = rolling_disc::initial_velocity();
    Eigen::Matrix<double, 10, 1> y;
    y << q, v;
    const Eigen::Vector2d lambda = consistent_multiplier(body, q, v) + Eigen::Vector2d(1, 1);
    has_orders_1_and_2(remainders(problem, y, lambda, 4e-4, 0.1, 8));
}

BOOST_AUTO_TEST_CASE(bad_arguments_are_refused) {
    const asymptotic_expansion<overdamped_oscillator> expansion({}, repeat<1>(1), repeat<1>(1));
    BOOST_CHECK_THROW(expansion(2, 1e-3, 0.1), std::invalid_argument);
    BOOST_CHECK_THROW(expansion(1, 0, 0.1), std::invalid_argument);
    BOOST_CHECK_THROW(perturbed(overdamped_oscillator{}, -1), std::invalid_argument);
}
