// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE asymptotic_expansion
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/mechanics/regularisation/asymptotic_expansion.hpp>
#include <stagecraft/mechanics/regularisation/regularisation_error.hpp>

#include <problems/rolling_disc/disc.hpp>

using namespace stagecraft;

namespace {

// y' = z, eps z' = Sign (y + z): linear, so the exact solution is a sum of two exponentials; with +1 the layer grows.
template <int Sign>
struct linear_relaxation {
    static constexpr int slow = 1, fast = 1;
    template <class S>
    Eigen::Matrix<S, 1, 1> f(const Eigen::Matrix<S, 1, 1>&, const Eigen::Matrix<S, 1, 1>& z) const {
        return z;
    }
    template <class S>
    Eigen::Matrix<S, 1, 1> g(const Eigen::Matrix<S, 1, 1>& y, const Eigen::Matrix<S, 1, 1>& z) const {
        return Eigen::Matrix<S, 1, 1>(S(Sign * (y[0] + z[0])));
    }
};
using overdamped_oscillator = linear_relaxation<-1>;
using growing = linear_relaxation<1>;

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

// z' = g_z z with a large entry off the diagonal; y rests on it.
struct sheared {
    static constexpr int slow = 1, fast = 2;
    template <class S>
    Eigen::Matrix<S, 1, 1> f(const Eigen::Matrix<S, 1, 1>&, const Eigen::Matrix<S, 2, 1>& z) const {
        return Eigen::Matrix<S, 1, 1>(z[0]);
    }
    template <class S>
    Eigen::Matrix<S, 2, 1> g(const Eigen::Matrix<S, 1, 1>&, const Eigen::Matrix<S, 2, 1>& z) const {
        return {S(6) * z[1] - z[0], -z[1]};
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
    return detail::run("full", system, start, {t}, 1e-12);
}

// q_1'' = q_2 - lambda, q_2'' = 6 q_1, 0 = q_1': from q = 0, q' = (0, 1) it is q_2 = lambda = t, q_1 = 0.
struct guided {
    static constexpr int coordinates = 2, constraints = 1;
    template <class S>
    using vector = Eigen::Matrix<S, 2, 1>;
    template <class S>
    Eigen::Matrix<S, 2, 2> M(const vector<S>&) const {
        Eigen::Matrix<S, 2, 2> M;
        M << S(1), S(0), S(0), S(1);
        return M;
    }
    template <class S>
    vector<S> F(const vector<S>& q, const vector<S>&) const {
        return vector<S>(q[1], S(6) * q[0]);
    }
    template <class S>
    Eigen::Matrix<S, 1, 2> G(const vector<S>&) const {
        return Eigen::Matrix<S, 1, 2>(S(1), S(0));
    }
};

struct slopes {
    double y0, z0, y1, z1;  // of the remainders in eps, N = 0 and N = 1
};

// Least-squares slopes over four values of eps, halved each time, of the remainders at t = far and inside the
// layer, at t = 1.5 eps, whichever is larger. Initial values y[0] + eps y[1], z[0] + eps z[1].
template <class Problem, class Y, class Z>
slopes remainders(const Problem& problem, const std::array<Y, 2>& y, const std::array<Z, 2>& z, double eps,
                  double far, double layer_end) {
    const asymptotic_expansion<Problem> expansion(problem, y, z, layer_end);
    constexpr int values = 4;
    double sum[4] = {};
    for (int k = 0; k < values; ++k, eps /= 2) {
        Eigen::VectorXd start(y[0].size() + z[0].size());
        start << y[0] + eps * y[1], z[0] + eps * z[1];
        double worst[4] = {};
        for (const double t : {1.5 * eps, far}) {
            const Eigen::VectorXd exact = full(problem, start, eps, t);
            for (int N = 0; N < 2; ++N) {
                const auto [ye, ze] = expansion(N, eps, t);
                worst[2 * N] = std::max(worst[2 * N], (exact.head(ye.size()) - ye).norm());
                worst[2 * N + 1] = std::max(worst[2 * N + 1], (exact.tail(ze.size()) - ze).norm());
            }
        }
        // log eps = const - k log 2; the weights of a straight line through four points are 1.5 - k over 5.
        for (int i = 0; i < 4; ++i) sum[i] += (1.5 - k) * std::log2(worst[i]) / 5;
    }
    return {sum[0], sum[1], sum[2], sum[3]};
}

template <class Problem, class Y, class Z>
slopes remainders(const Problem& problem, const Y& y, const Z& z, double eps, double far, double layer_end) {
    return remainders(problem, std::array<Y, 2>{y, Y::Zero()}, std::array<Z, 2>{z, Z::Zero()}, eps, far,
                      layer_end);
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

BOOST_AUTO_TEST_CASE(theorem_6_for_n_2_what_n_1_leaves_is_eps_squared_times_terms_without_eps) {
    // (exact - expansion of N = 1)/eps^2 = y_2(t) + eta_1(t/eps) + O(eps): at a fixed t, and at a fixed xi = t/eps, where
    // it goes to y_2(0) + eta_1(xi), and eta_1 decays.
    const asymptotic_expansion<van_der_pol> expansion({}, repeat<1>(2), repeat<1>(-0.2), 20);
    const auto rest = [&](double eps, double t) -> Eigen::Vector2d {
        const Eigen::VectorXd exact = full(van_der_pol{}, Eigen::Vector2d(2, -0.2), eps, t);
        const auto [y, z] = expansion(1, eps, t);
        return Eigen::Vector2d(exact[0] - y[0], exact[1] - z[0]) / (eps * eps);
    };
    const auto limit_and_order = [&](auto at) {
        const Eigen::Vector2d a = rest(4e-3, at(4e-3)), b = rest(2e-3, at(2e-3)), c = rest(1e-3, at(1e-3));
        for (int i = 0; i < 2; ++i)
            BOOST_TEST(std::abs(std::log2(std::abs(a[i] - b[i]) / std::abs(b[i] - c[i])) - 1) < 0.25);
        return Eigen::Vector2d(2 * c - b);
    };
    const Eigen::Vector2d far = limit_and_order([](double) { return 0.3; });
    BOOST_TEST(far.norm() > 1e-3);  // the term is there
    // g_z = 1 - y^2 = -3 in the layer
    const Eigen::Vector2d end = limit_and_order([](double eps) { return 10 * eps; });
    const Eigen::Vector2d one = limit_and_order([](double eps) { return eps; });
    const Eigen::Vector2d four = limit_and_order([](double eps) { return 4 * eps; });
    for (int i = 0; i < 2; ++i) {
        BOOST_TEST(std::abs(one[i] - end[i]) > 3e-3);
        BOOST_TEST(std::abs(four[i] - end[i]) < std::exp(-3.0) * std::abs(one[i] - end[i]));
    }
}

BOOST_AUTO_TEST_CASE(theorem_6_layer_terms_decay_exponentially) {
    // |c(xi)| <= C e^{-kappa xi} for eta_0, zeta_0, zeta_1, with kappa a little below |mu(g_z)| for the powers of xi.
    const auto decays = [](const auto& expansion, double kappa) {
        double early[3] = {}, late[3] = {};
        for (double xi = 0; xi < 6; xi += 0.5) {
            const auto l = expansion.layer(xi);
            const double size[3] = {l.eta0.norm(), l.zeta0.norm(), l.zeta1.norm()};
            for (int i = 0; i < 3; ++i) {
                double& most = xi < 3 ? early[i] : late[i];
                most = std::max(most, size[i] * std::exp(kappa * xi));
            }
        }
        for (int i = 0; i < 3; ++i) BOOST_TEST((early[i] > 0 && late[i] <= early[i] * (1 + 1e-3)));
    };
    decays(asymptotic_expansion<overdamped_oscillator>({}, repeat<1>(1), repeat<1>(1)), 0.6);
    decays(asymptotic_expansion<van_der_pol>({}, repeat<1>(2), repeat<1>(-0.2), 20), 2);
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

BOOST_AUTO_TEST_CASE(theorem_6_with_initial_values_that_depend_on_eps) {
    const std::array y{repeat<1>(2), repeat<1>(-1.5)}, z{repeat<1>(-0.2), repeat<1>(3)};
    has_orders_1_and_2(remainders(van_der_pol{}, y, z, 4e-3, 0.3, 20));
    // By hand for y' = z, eps z' = -y - z: y_1(0) = y[1] + 2, zeta_1(0) = z[1] - z_1(0).
    const asymptotic_expansion<overdamped_oscillator> expansion({}, std::array{repeat<1>(1), repeat<1>(5)},
                                                                std::array{repeat<1>(1), repeat<1>(7)});
    const auto o = expansion.outer(0);
    BOOST_TEST(o.y1[0] == 7, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(expansion.layer(0).zeta1[0] == 7 - o.z1[0], boost::test_tools::tolerance(1e-12));
    BOOST_TEST(expansion(1, 1e-3, 0).first[0] == 1.005, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(expansion(1, 1e-3, 0).second[0] == 1.007, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(theorem_6_is_refused_where_its_hypothesis_fails) {
    // Otherwise the layer would grow like e^xi, to 1e17 at xi = 40, with no word about it.
    BOOST_CHECK_THROW(asymptotic_expansion<growing>({}, repeat<1>(1), repeat<1>(1)), std::domain_error);
    BOOST_CHECK_THROW(asymptotic_expansion<van_der_pol>({}, repeat<1>(0.5), repeat<1>(0.1)),
                      std::domain_error);
}

BOOST_AUTO_TEST_CASE(theorem_6_takes_the_norm_in_which_its_hypothesis_holds) {
    // g_z = ((-1, 6), (0, -1)): mu is 2 in the Euclidean norm and -0.4 in that of D = diag(1, 100), where the off-diagonal
    // entry is 0.6.
    using plane = Eigen::Vector2d;
    const plane z(1, 1);
    BOOST_CHECK_THROW(asymptotic_expansion<sheared>({}, repeat<1>(1), z), std::domain_error);
    const Eigen::Matrix2d D = plane(1, 100).asDiagonal();
    const asymptotic_expansion<sheared> expansion({}, repeat<1>(1), z, 60, 1e-11, D);
    // zeta_0 = exp(g_z xi) z = e^-xi (1 + 6 xi, 1), as z_0 = 0.
    for (const double xi : {0.0, 0.5, 3.0})
        BOOST_TEST((expansion.layer(xi).zeta0 - std::exp(-xi) * plane(1 + 6 * xi, 1)).norm() < 1e-8);
    BOOST_CHECK_THROW(asymptotic_expansion<sheared>({}, repeat<1>(1), z, 60, 1e-11, -D),
                      std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(the_error_of_regularisation_in_closed_form) {
    // g_y Y = lambda_0'/c = 1/c: Y_q = (t, t^3)/c, Y_v = (1, 3 t^2)/c, Lambda = t^3/c.
    const double c = 5;
    const auto terms =
        regularisation_error(guided{}, Eigen::Vector2d(0, 0), Eigen::Vector2d(0, 1), c, {0.0, 0.5, 2.0});
    BOOST_TEST(terms.size() == 3);
    for (const auto& term : terms) {
        const double t = term.t;
        BOOST_TEST((term.y0 - Eigen::Vector4d(0, t, 0, 1)).norm() < 1e-9);
        BOOST_TEST(std::abs(term.lambda0[0] - t) < 1e-9);
        BOOST_TEST((term.Y - Eigen::Vector4d(t, t * t * t, 1, 3 * t * t) / c).norm() < 1e-8);
        if (t > 0) BOOST_TEST(std::abs(term.Lambda[0] - t * t * t / c) < 1e-8);
    }
    const Eigen::Vector2d q(0, 0), v(0, 1);
    BOOST_TEST(regularisation_error(guided{}, q, v, c, {}).empty());
    BOOST_CHECK_THROW(regularisation_error(guided{}, q, v, 0, {1.0}), std::invalid_argument);
    BOOST_CHECK_THROW(regularisation_error(guided{}, q, v, c, {1.0, 0.5}), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(bad_arguments_are_refused) {
    const asymptotic_expansion<overdamped_oscillator> expansion({}, repeat<1>(1), repeat<1>(1));
    BOOST_CHECK_THROW(expansion(2, 1e-3, 0.1), std::invalid_argument);
    BOOST_CHECK_THROW(expansion(1, 0, 0.1), std::invalid_argument);
    BOOST_CHECK_THROW(perturbed(overdamped_oscillator{}, -1), std::invalid_argument);
}
