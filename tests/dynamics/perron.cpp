// SPDX-License-Identifier: BSL-1.0
// Lecture, chapter 3: inner products for B up to the imaginary axis, and what they say of nonlinear equations.
#define BOOST_TEST_MODULE perron
#include <Eigen/Eigenvalues>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <problems/dense_once.hpp>
#include <random>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/theory/dynamics/lyapunov.hpp>
#include <stagecraft/theory/dynamics/lyapunov_function.hpp>

#include "../message.hpp"

using namespace stagecraft;
using namespace stagecraft::theory;

namespace {

dense<rational> matrix(int n, std::initializer_list<rational> entries) {
    dense<rational> B(n, n);
    auto e = entries.begin();
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) B(i, j) = *e++;
    return B;
}

bool is_inner_product_for(const dense<rational>& B, const rational& gamma, const dense<rational>& G) {
    return tableaux::diagonalise<rational>(G).inertia().positive == B.rows() &&
           bounds(gamma, G, symmetric_part<rational>(G, B));
}

dense<rational> product(const dense<rational>& A, const dense<rational>& B) {
    dense<rational> C = dense<rational>::Constant(A.rows(), B.cols(), rational(0));
    for (Eigen::Index i = 0; i < A.rows(); ++i)
        for (Eigen::Index j = 0; j < B.cols(); ++j)
            for (Eigen::Index k = 0; k < A.cols(); ++k) C(i, j) += A(i, k) * B(k, j);
    return C;
}

template <class Random>
dense<rational> random_matrix(Random& random, Eigen::Index n) {
    std::uniform_int_distribution<int> pick(-3, 3);
    dense<rational> T(n, n);
    for (Eigen::Index i = 0; i < T.size(); ++i) T.data()[i] = pick(random);
    return T;
}

/// T B T^-1 for a random regular T.
template <class Random>
dense<rational> in_other_coordinates(Random& random, const dense<rational>& B) {
    for (;;) {
        const dense<rational> T = random_matrix(random, B.rows());
        if (const auto inverse = tableaux::inverse<rational>(T)) return product(T, product(B, *inverse));
    }
}

Eigen::MatrixXd in_doubles(const dense<rational>& G) {
    return G.unaryExpr([](const rational& q) { return q.to<double>(); });
}

/// The values of one run at the given times.
template <int N, class F>
std::vector<state<double, N>> values(const F& f, const state<double, N>& x0, const std::vector<double>& t) {
    std::vector<state<double, N>> out;
    state<double, N> x = x0;
    double now = 0;
    for (const double next : t) {
        const auto r = integrate(radau_iia<3>(), f, x, now, next, {.rtol = 1e-10, .atol = 1e-13});
        BOOST_REQUIRE(r.ok());
        out.push_back(x = r.y);
        now = next;
    }
    return out;
}

const auto pendulum = [](const auto&, const auto& x, auto& f) {
    f[0] = x[1];
    f[1] = -sin(x[0]) - x[1];
};

}  // namespace

BOOST_AUTO_TEST_CASE(lemma_3_3_part_2_an_inner_product_at_alpha_0_where_the_axis_is_semisimple) {
    const dense<rational> zero = matrix(2, {0, 0, 0, 0}), rotation = matrix(2, {0, -1, 1, 0}),
                          portrait = matrix(2, {0, 2, rational(-1, 2), 0}), mixed = matrix(2, {0, 0, 0, -1});
    for (const auto& B : {zero, rotation, portrait, mixed}) {
        const auto G = inner_product(B, 0);
        BOOST_TEST(is_inner_product_for(B, 0, G));
    }
    // The mean of e^(tB)^T e^(tB) over a turn, e^(tB) = (cos t, 2 sin t; -sin t/2, cos t): (1 + 1/4)/2 and (1 + 4)/2.
    const auto G = inner_product(portrait, 0);
    BOOST_TEST((G(0, 0) == rational(5, 8) && G(0, 1) == 0 && G(1, 1) == rational(5, 2)));
    BOOST_TEST((inner_product(rotation, 0) == euclidean(2)));
    // gamma = alpha(B) attained elsewhere than at 0, and part 1 beyond it as before
    const auto node = matrix(2, {-1, 0, 0, -2});
    BOOST_TEST(is_inner_product_for(node, -1, inner_product(node, -1)));
    BOOST_TEST(message([&] { inner_product(node, rational(-101, 100)); }).starts_with("gamma: must exceed"));
}

BOOST_AUTO_TEST_CASE(satz_3_5_part_2_holds_for_300_random_matrices_and_for_no_jordan_block_on_the_axis) {
    std::mt19937 random(35);
    std::uniform_int_distribution<int> kind(0, 3), frequency(1, 3);
    int found = 0, refused = 0;
    for (int k = 0; k < 300; ++k) {
        // blocks (0), (0, -w; 1, 0) with eigenvalues +-i sqrt(w), (-1, 1; 0, -1); perhaps coupled into a Jordan block
        const int n = 6;
        dense<rational> B = dense<rational>::Constant(n, n, rational(0));
        const bool jordan = k % 3 == 0;
        const int w = frequency(random);
        for (int i = 0; i < n; i += 2) {
            const int which = jordan && i < 4 ? 1 : kind(random);
            if (which == 1) B(i, i + 1) = jordan && i < 4 ? -w : -frequency(random), B(i + 1, i) = 1;
            if (which == 2) B(i, i) = B(i + 1, i + 1) = -1, B(i, i + 1) = 1;
            if (which == 3) B(i, i) = -2;  // and 0
        }
        if (jordan) B(0, 2) = B(1, 3) = 1;
        B = in_other_coordinates(random, B);
        if (jordan) {
            BOOST_TEST(message([&] { inner_product(B, 0); }).starts_with("gamma: must exceed"));
            // s(B)^2 v = 0 != s(B) v: a solution that grows in every norm, so no inner product is left out
            BOOST_TEST(linear_stability(B).witness.has_value());
            ++refused;
        } else {
            // the eigenvalues are those of the blocks, 0 the largest real part unless all blocks are of the third kind
            BOOST_TEST(is_inner_product_for(B, 0, inner_product(B, 0)));
            BOOST_TEST((linear_stability(B).kind != lyapunov_stability::unstable));
            ++found;
        }
    }
    BOOST_TEST(found == 200);
    BOOST_TEST(refused == 100);
    // B = (0, 1; 0, 0): the symmetric part of G B has determinant -(G_11/2)^2 < 0 for every G > 0
    const auto block = matrix(2, {0, 1, 0, 0});
    for (int k = 0; k < 100; ++k) {
        const dense<rational> T = random_matrix(random, 2);
        dense<rational> G = product(T.transpose(), T);
        G(0, 0) += 1, G(1, 1) += 1;
        const auto S = symmetric_part<rational>(G, block);
        BOOST_TEST((tableaux::determinant<rational>(S) == -G(0, 0) * G(0, 0) / 4));
        BOOST_TEST(!bounds(0, G, S));
    }
}

BOOST_AUTO_TEST_CASE(lemma_3_4_c_star_c_is_an_inner_product_and_a_c_that_takes_a_real_vector_to_0_is_not) {
    std::mt19937 random(34);
    int regular = 0, singular = 0;
    for (int k = 0; k < 200; ++k) {
        // C = A + i B: Re <C* C x, y> = x^T (A^T A + B^T B) y for real x and y
        dense<rational> A = random_matrix(random, 3), B = random_matrix(random, 3);
        const bool kill = k % 2 == 0;
        if (kill)  // C (1, 1, 1) = 0
            for (Eigen::Index i = 0; i < 3; ++i) A(i, 2) = -A(i, 0) - A(i, 1), B(i, 2) = -B(i, 0) - B(i, 1);
        const dense<rational> AA = product(A.transpose(), A), BB = product(B.transpose(), B);
        dense<rational> G = AA;
        for (Eigen::Index i = 0; i < G.size(); ++i) G.data()[i] += BB.data()[i];
        const std::complex<double> det =
            (in_doubles(A).cast<std::complex<double>>() +
             std::complex<double>(0, 1) * in_doubles(B).cast<std::complex<double>>())
                .determinant();
        if (!kill && std::abs(det) < 1e-9) continue;
        const std::string said = message([&] { require_inner_product(G, 3); });
        BOOST_TEST(said == (kill ? "G: must be positive definite" : "no exception"));
        ++(kill ? singular : regular);
    }
    BOOST_TEST((regular > 90 && singular == 100));
}

BOOST_AUTO_TEST_CASE(satz_3_7_perron_with_h_of_x_and_t_decays_at_gamma_plus_epsilon_eta_2_over_eta_1) {
    // x' = B x + h(x, t), h = epsilon sin(7t) (x2, -x1): |h| <= epsilon |x|.
    const auto B = matrix(2, {-1, 0, -1, -2});
    const rational gamma(-1, 2), epsilon(1, 5);
    const auto G = inner_product(B, gamma);
    const Eigen::Matrix2d H = in_doubles(G);
    const Eigen::Vector2d eta = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(H).eigenvalues();
    const double kappa = perron_rate(gamma, G, epsilon);
    BOOST_TEST(std::abs(kappa - (-0.5 + 0.2 * std::sqrt(eta[1] / eta[0]))) < 1e-6);
    BOOST_TEST(kappa < -0.05);
    const auto f = [](const auto& t, const auto& x, auto& out) {
        out[0] = -x[0] + 0.2 * sin(7 * t) * x[1];
        out[1] = -x[0] - 2 * x[1] - 0.2 * sin(7 * t) * x[0];
    };
    const std::vector<double> times{0.25, 0.5, 1, 2, 4};
    for (int k = 0; k < 8; ++k) {
        const state<double, 2> x0(std::cos(k), std::sin(k));
        const auto x = values<2>(f, x0, times);
        for (std::size_t i = 0; i < x.size(); ++i)
            BOOST_TEST(std::sqrt(x[i].dot(H * x[i])) <=
                       std::exp(kappa * times[i]) * std::sqrt(x0.dot(H * x0)) * (1 + 1e-8));
    }
    // epsilon too large: kappa >= 0 and the theorem is silent; x' = -x + 2x grows at just that rate
    BOOST_TEST(std::abs(perron_rate(-1, euclidean(1), 2) - 1) < 1e-8);
    BOOST_TEST(message([&] { perron_rate(gamma, G, -1); }).starts_with("epsilon: "));
}

BOOST_AUTO_TEST_CASE(satz_3_7_needs_h_small_for_all_times_at_once) {
    // h = x^2 sin t: f_x = -1 + 2x sin t < 0 for all t where |x| < 1/2.
    const auto uniform = [](const auto& t, const auto& x, auto& f) { f[0] = -x[0] + x[0] * x[0] * sin(t); };
    const state<rational, 1> rest(rational(0));
    const auto a = attraction_radius_on<1>(uniform, rest, 10);
    BOOST_TEST(a.verdict.is_proved(), a.verdict.text());
    BOOST_TEST((a.euclidean_radius() > 0.47 && a.euclidean_radius() <= 0.5));
    for (const double x0 : {-0.47, 0.47}) {
        const auto x = values<1>(uniform, state<double, 1>(x0), {1, 5, 20});
        BOOST_TEST(std::abs(x[0][0]) <= std::abs(x0) * std::exp(-a.rate));
        BOOST_TEST(std::abs(x[2][0]) < 1e-6);
    }
    // h = e^(2t) x^2 is o(x) at every t, but rho(epsilon) goes to 0 with t: u = 1/x solves u' = u - e^(2t), and every
    // x(0) > 0 blows up at t = log(1 + 1/x(0)). No ball is proved for all times; for t in [0, 1] one is.
    const auto growing = [](const auto& t, const auto& x, auto& f) {
        f[0] = -x[0] + exp(2 * t) * x[0] * x[0];
    };
    const auto none = attraction_radius_on<1>(growing, rest, 10);
    BOOST_TEST((none.verdict.is_consistent() && none.radius == 0));
    const auto early = attraction_radius_on<1>(growing, rest, 10, interval(0, 1));
    BOOST_TEST((early.euclidean_radius() > 0.062 && early.euclidean_radius() < 0.5 * std::exp(-2)));
    const state<double, 1> x0(0.01);
    const auto run = integrate(radau_iia<3>(), growing, x0, 0.0, 10.0, {.rtol = 1e-10, .atol = 1e-12});
    BOOST_TEST(!run.ok());
    BOOST_TEST(std::abs(run.t - std::log(101.0)) < 1e-3);
}

BOOST_AUTO_TEST_CASE(satz_3_8_for_f_in_c2_the_damped_pendulum_attracts_a_ball_and_not_upside_down) {
    const auto a = attraction_radius_on<2>(pendulum, origin<2>(), 10);
    BOOST_TEST(a.verdict.is_proved(), a.verdict.text());
    BOOST_TEST(a.euclidean_radius() > 0.3);
    // The box around the ball reaches no point with cos x1 <= 0: there f' has an eigenvalue >= 0.
    const Eigen::Matrix2d G = in_doubles(a.G);
    BOOST_TEST(a.radius * std::sqrt(G.inverse()(0, 0)) < 1.5707963267948966);
    const std::vector<double> times{0.5, 2, 8};
    for (int k = 0; k < 12; ++k) {
        const Eigen::Vector2d on_circle(std::cos(k), std::sin(k));
        const state<double, 2> x0 = on_circle * (a.radius / std::sqrt(on_circle.dot(G * on_circle)));
        const auto x = values<2>(pendulum, x0, times);
        for (std::size_t i = 0; i < x.size(); ++i)
            BOOST_TEST(std::sqrt(x[i].dot(G * x[i])) <= a.radius * std::exp(-a.rate * times[i]) * (1 + 1e-8));
    }
    // alpha(f'(c)) > 0 and = 0: nothing is claimed
    const auto upside_down = [](const auto&, const auto& x, auto& f) {
        f[0] = x[1];
        f[1] = sin(x[0]) - x[1];
    };
    BOOST_TEST(attraction_radius_on<2>(upside_down, origin<2>(), 10).verdict.is_consistent());
    const auto undamped = [](const auto&, const auto& x, auto& f) {
        f[0] = x[1];
        f[1] = -sin(x[0]);
    };
    BOOST_TEST(attraction_radius_on<2>(undamped, origin<2>(), 10).radius == 0);
    // no equilibrium, no radius
    state<rational, 2> away;
    away << rational(1), rational(0);
    BOOST_TEST(message([&] { attraction_radius_on<2>(pendulum, away, 10); }).starts_with("c: "));
    BOOST_TEST(message([&] { attraction_radius_on<2>(pendulum, origin<2>(), -1); }).starts_with("most: "));
    // where f is a polynomial, the ball is that of the exact Jacobian
    const auto cubic = [](const auto&, const auto& x, auto& f) {
        f[0] = -x[0] - x[0] * x[1];
        f[1] = -x[0] - 2 * x[1] + x[0] * x[1];
    };
    BOOST_TEST(attraction_radius_on<2>(cubic, origin<2>(), 1000).radius ==
               attraction_radius<2>(cubic, origin<2>(), 1000).radius);
}

BOOST_AUTO_TEST_CASE(the_remark_after_definition_3_9_is_false_where_v_does_not_grow_without_bound) {
    // Printed: if there is a Lyapunov function, all solutions are bounded and exist for ever. V = x^2/(1 + x^4) is
    // one of x' = -x + x^5, V' f = -2 x^2 (1 - x^4)^2/(1 + x^4)^2, decided on the whole line; x(0) = 1.1 ends at
    // t = log(1.1^4/(1.1^4 - 1))/4 all the same: V -> 0 as |x| -> oo.
    const rational_function x = rational_function::x(), fourth = x * x * x * x, V = x * x / (1 + fourth),
                            rate = derivative(V) * (x * fourth - x);
    const auto highest = supremum_on_line(rate);
    BOOST_REQUIRE(highest.has_value());
    BOOST_TEST((highest->low == 0 && highest->high == 0));
    BOOST_TEST((V(rational(0)) == 0 && !point_above(-V, 0).has_value()));
    const auto f = [](const auto&, const auto& y, auto& out) {
        out[0] = -y[0] + y[0] * y[0] * y[0] * y[0] * y[0];
    };
    const state<double, 1> start(1.1);
    const auto run = integrate(radau_iia<3>(), f, start, 0.0, 10.0, {.rtol = 1e-10, .atol = 1e-12});
    const double end = std::log(std::pow(1.1, 4) / (std::pow(1.1, 4) - 1)) / 4;
    BOOST_TEST(std::abs(end - 0.28722) < 1e-5);
    BOOST_TEST(!run.ok());
    BOOST_TEST(std::abs(run.t - end) < 1e-3);
    // with V = x^2, which grows without bound, the same equation is refuted, and x' = -x - x^5 proved
    const auto square = [](const auto& y) { return y[0] * y[0]; };
    BOOST_TEST(lyapunov_function<1>(square, f).is_refuted());
    BOOST_TEST(lyapunov_function<1>(square, [](const auto&, const auto& y, auto& out) {
                   out[0] = -y[0] - y[0] * y[0] * y[0] * y[0] * y[0];
               }).is_proved());
}
