// SPDX-License-Identifier: BSL-1.0
// Lecture, chapter 3: stability in the sense of Lyapunov.
#define BOOST_TEST_MODULE lyapunov
#include <Eigen/Cholesky>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <problems/dense_once.hpp>
#include <random>
#include <stagecraft/tableaux/exact_tableau.hpp>
#include <stagecraft/theory/dynamics/lyapunov.hpp>
#include <stagecraft/theory/dynamics/lyapunov_function.hpp>
#include <stagecraft/theory/dynamics/multistep.hpp>
#include <stagecraft/theory/dynamics/rk_map.hpp>

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

const auto routh_1 = [](const auto&, const auto& x, auto& f) {
    f[0] = -x[1] + x[0] * x[0] * x[0];
    f[1] = x[0];
};
const auto routh_2 = [](const auto&, const auto& x, auto& f) {
    f[0] = -x[1] - x[0] * x[0] * x[0];
    f[1] = x[0];
};
/// The first phase portrait, eigenvalues -1 and -2.
const auto node = [](const auto&, const auto& x, auto& f) {
    f[0] = -x[0] - x[0] * x[1];
    f[1] = -x[0] - 2 * x[1] + x[0] * x[1];
};
/// The second phase portrait, eigenvalues +-i.
const auto centre = [](const auto&, const auto& x, auto& f) {
    f[0] = 2 * x[1] - x[0] * x[1];
    f[1] = -x[0] / 2 + x[0] * x[1] * x[1];
};
const auto squared_length = [](const auto& x) { return x[0] * x[0] + x[1] * x[1]; };

const tableau<double>& gauss_2() {
    static const auto m = in_doubles(*tableaux::exact_tableau(tableaux::family::gauss, 2));
    return m;
}

template <class F>
state<double, 2> run(F f, state<double, 2> x, double t, int steps) {
    for (int n = 0; n < steps; ++n) {
        const auto next = rk_step<2>(gauss_2(), f, x, t / steps);
        BOOST_REQUIRE(next.has_value());
        x = *next;
    }
    return x;
}

/// log |e^(T B)|/T for T = 2^16, by squaring: alpha(B) but for log(cond)/T. Blocks of zeros decay.
double abscissa_in_doubles(const dense<rational>& B) {
    using matrix = Eigen::Matrix4d;
    matrix D = -60 * matrix::Identity();
    for (Eigen::Index i = 0; i < B.rows(); ++i)
        for (Eigen::Index j = 0; j < B.cols(); ++j) D(i, j) = B(i, j).to<double>();
    constexpr double first = 0x1p-10;
    matrix e = matrix::Identity(), term = matrix::Identity();
    for (int k = 1; k < 12; ++k) {
        term = matrix((first / k) * D.lazyProduct(term));
        e += term;
    }
    double logarithm = 0, time = first;
    while (time < 65536) {
        const double size = e.norm();
        e = matrix((e / size).lazyProduct(e / size));
        logarithm = 2 * (logarithm + std::log(size));
        time *= 2;
    }
    return (logarithm + std::log(e.norm())) / time;
}

}  // namespace

BOOST_AUTO_TEST_CASE(
    lemma_3_3_and_satz_3_5_an_inner_product_is_proved_for_200_random_matrices_close_to_alpha) {
    std::mt19937 random(11);
    std::uniform_int_distribution<int> size(1, 4), pick(-9, 9), part(1, 5);
    for (int k = 0; k < 200; ++k) {
        const int n = size(random);
        dense<rational> B(n, n);
        for (Eigen::Index i = 0; i < B.size(); ++i)
            B.data()[i] = rational(tableaux::integer(pick(random)), tableaux::integer(part(random)));
        const auto alpha = spectral_abscissa(B, rational(1, 1000));
        BOOST_TEST(std::abs(alpha.low.to<double>() - abscissa_in_doubles(B)) < 2e-3 + 1e-3 * (n > 2));
        const rational gamma = alpha.high + rational(1, 200);  // at most alpha(B) + 1/100
        const auto G = inner_product(B, gamma);
        // x^T G x > 0 and <B x, x> <= gamma <x, x> on random vectors, apart from the exact proof inside
        for (int j = 0; j < 5; ++j) {
            column<rational> x(n), Bx(n);
            for (int i = 0; i < n; ++i) x[i] = pick(random);
            x[0] += 20;
            for (int i = 0; i < n; ++i) {
                Bx[i] = 0;
                for (int l = 0; l < n; ++l) Bx[i] += B(i, l) * x[l];
            }
            BOOST_TEST((inner_product<rational>(G, x, x) > 0));
            BOOST_TEST((inner_product<rational>(G, Bx, x) <= gamma * inner_product<rational>(G, x, x)));
        }
        BOOST_CHECK_THROW(inner_product(B, alpha.low - rational(1, 1000)), std::invalid_argument);
    }
}

BOOST_AUTO_TEST_CASE(
    lemma_3_3_gamma_below_alpha_is_refused_and_a_jordan_block_has_no_inner_product_at_alpha) {
    const auto block = matrix(2, {0, 1, 0, 0});
    BOOST_TEST(message([&] { inner_product(block, 0); }).starts_with("gamma: must exceed"));
    BOOST_TEST((inner_product(block, rational(1, 100))(0, 0) > 0));
    // <B x, x> <= 0 fails for every G > 0: x = (1, e), e small, gives G_11 e + ... > 0
    for (const auto& G : {euclidean(2), matrix(2, {1, 0, 0, 1000}), matrix(2, {3, -1, -1, 5})})
        BOOST_TEST(!bounds(0, G, symmetric_part<rational>(G, block)));
}

BOOST_AUTO_TEST_CASE(lemma_3_4_the_lyapunov_equation_is_solved_exactly) {
    const auto B = matrix(2, {-1, 0, -1, -2});
    const auto G = solve_lyapunov(B, euclidean(2));
    BOOST_TEST((G(0, 0) == rational(7, 12) && G(0, 1) == rational(-1, 12) && G(1, 1) == rational(1, 4)));
    const auto S = symmetric_part<rational>(G, B);
    BOOST_TEST((S(0, 0) == rational(-1, 2) && S(0, 1) == 0 && S(1, 1) == rational(-1, 2)));
    const auto singular = message([] { solve_lyapunov(matrix(2, {0, -1, 1, 0}), euclidean(2)); });
    BOOST_TEST(singular.find("singular") != std::string::npos);
    BOOST_TEST(singular.find("1i and") != std::string::npos);
    BOOST_TEST(message([] {
                   solve_lyapunov(matrix(2, {3, 0, 0, -3}), euclidean(2));
               }).find("3") != std::string::npos);
    BOOST_TEST(message([] { solve_lyapunov(euclidean(2), euclidean(3)); }).starts_with("Q: "));
}

BOOST_AUTO_TEST_CASE(definition_3_2_the_spectral_abscissa_is_enclosed) {
    const auto a = spectral_abscissa(matrix(3, {-1, 2, 0, -2, -1, 0, 0, 0, -3}));
    BOOST_TEST((a.low == -1 && a.high == -1));
    const auto b = spectral_abscissa(matrix(2, {0, 2, 1, 0}));  // sqrt 2
    BOOST_TEST((b.low * b.low <= 2 && 2 <= b.high * b.high && b.high - b.low < rational(1, 100'000)));
}

BOOST_AUTO_TEST_CASE(korollar_3_6_stability_of_linear_equations_is_decided_with_a_witness) {
    using enum lyapunov_stability;
    BOOST_TEST((linear_stability(matrix(2, {-1, 0, -1, -2})).kind == asymptotically_stable));
    BOOST_TEST((linear_stability(matrix(2, {0, 2, rational(-1, 2), 0})).kind == stable));
    BOOST_TEST((linear_stability(matrix(2, {0, 0, 0, 0})).kind == stable));
    BOOST_TEST((linear_stability(matrix(2, {1, 0, 0, -5})).kind == unstable));
    const auto jordan = linear_stability(matrix(2, {0, 1, 0, 0}));
    BOOST_TEST((jordan.kind == unstable && jordan.witness.has_value()));
    BOOST_TEST(((*jordan.witness)[1] != 0));  // B v != 0, B^2 v = 0: x(t) = v + t B v
    // the double pair +-i: as two blocks of order 1, and as one of order 2
    BOOST_TEST(
        (linear_stability(matrix(4, {0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0})).kind == stable));
    const auto resonant = matrix(4, {0, -1, 1, 0, 1, 0, 0, 1, 0, 0, 0, -1, 0, 0, 1, 0});
    const auto grows = linear_stability(resonant);
    BOOST_TEST((grows.kind == unstable && grows.witness.has_value()));
    Eigen::Vector4d v = grows.witness->unaryExpr([](const rational& q) { return q.to<double>(); });
    const Eigen::Matrix4d B = resonant.unaryExpr([](const rational& q) { return q.to<double>(); });
    const double first = v.norm();
    for (int n = 0; n < 4000; ++n) {  // classical Runge-Kutta
        const Eigen::Vector4d k1 = B * v, k2 = B * (v + 0.005 * k1), k3 = B * (v + 0.005 * k2),
                              k4 = B * (v + 0.01 * k3);
        v += 0.01 / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    BOOST_TEST(v.norm() > 10 * first);  // like t = 40
}

BOOST_AUTO_TEST_CASE(equations_3_3_and_3_4_differences_of_solutions_solve_the_homogeneous_equation) {
    const auto forced = [](const auto& t, const auto& x, auto& f) {
        f[0] = -x[0] + 3 * x[1] + sin(t);
        f[1] = -2 * x[1] + t;
    };
    const auto plain = [](const auto&, const auto& x, auto& f) {
        f[0] = -x[0] + 3 * x[1];
        f[1] = -2 * x[1];
    };
    state<double, 2> x(1, 2), reference(-0.5, 0.25), z = x - reference;
    for (int n = 0; n < 100; ++n) {
        x = *rk_step<2>(gauss_2(), forced, x, 0.05, 0.05 * n);
        reference = *rk_step<2>(gauss_2(), forced, reference, 0.05, 0.05 * n);
        z = *rk_step<2>(gauss_2(), plain, z, 0.05);
        BOOST_TEST((x - reference - z).norm() < 1e-11);
    }
    const auto nonlinear = [](const auto&, const auto& y, auto& f) {
        f[0] = -y[0] * y[0];
        f[1] = -2 * y[1];
    };
    state<double, 2> u(1, 2), w(0.5, 0.25), d = u - w;
    u = run(nonlinear, u, 1, 20);
    w = run(nonlinear, w, 1, 20);
    d = run(nonlinear, d, 1, 20);
    BOOST_TEST((u - w - d).norm() > 0.01);
}

BOOST_AUTO_TEST_CASE(satz_3_7_and_3_8_all_of_1e4_starts_in_the_proved_ball_converge) {
    const auto a = attraction_radius<2>(node, origin<2>());
    BOOST_TEST(a.verdict.is_proved());
    BOOST_TEST(a.radius > 0.05);
    BOOST_TEST(a.rate > 0);
    const Eigen::Matrix2d G = a.G.unaryExpr([](const rational& q) { return q.to<double>(); });
    const Eigen::Matrix2d R = Eigen::LLT<Eigen::Matrix2d>(G).matrixU();
    std::mt19937 random(2);
    std::uniform_real_distribution<double> angle(0, 6.2831853), square(0, 1);
    int kept = 0;
    for (int k = 0; k < 10'000; ++k) {
        const double phi = angle(random), r = a.radius * std::sqrt(square(random));
        const state<double, 2> x = R.inverse() * Eigen::Vector2d(r * std::cos(phi), r * std::sin(phi));
        const state<double, 2> y = run(node, x, 2, 20);
        kept += std::sqrt(y.dot(G * y)) <= r * std::exp(-a.rate * 2) * (1 + 1e-4) ? 1 : 0;
    }
    BOOST_TEST(kept == 10'000);
    BOOST_TEST(run(node, state<double, 2>(0.05, -0.05), 20, 200).norm() < 1e-6);
    // no equilibrium: refused
    state<rational, 2> away;
    away << rational(-1), rational(-1);
    BOOST_TEST(message([&] { attraction_radius<2>(node, away); }).starts_with("c: "));
}

BOOST_AUTO_TEST_CASE(rational_constants_serve_in_balls_and_shells_as_on_the_whole_space) {
    const rational third(1, 3);
    const auto f = [&](const auto&, const auto& x, auto& out) {
        out[0] = (x[0] * x[0] - third) * x[0] * third;
    };
    const auto a = attraction_radius<1>(f, state<rational, 1>(rational(0)));
    BOOST_TEST(a.verdict.is_proved());  // f' = x^2 - 1/9 < 0 for |x| < 1/3
    BOOST_TEST((a.euclidean_radius() > 0.3 && a.euclidean_radius() <= 1.0 / 3));
    const auto v = [&](const auto& x) { return third * x[0] * x[0]; };
    BOOST_TEST(lyapunov_function_on_shell<1>(v, f, 0.01, 0.5).is_proved());
    BOOST_TEST(lyapunov_function<1>(v, [&](const auto&, const auto& x, auto& out) {
                   out[0] = -third * x[0];
               }).is_proved());
    BOOST_TEST(lyapunov_function<1>(v, f).is_refuted());
}

BOOST_AUTO_TEST_CASE(satz_3_8_with_alpha_0_both_routh_systems_share_their_linear_part_and_differ) {
    for (const auto& a :
         {attraction_radius<2>(routh_1, origin<2>()), attraction_radius<2>(routh_2, origin<2>())}) {
        BOOST_TEST(a.verdict.is_consistent());
        BOOST_TEST(a.radius == 0.0);
    }
    BOOST_TEST((linear_stability(matrix(2, {0, -1, 1, 0})).kind == lyapunov_stability::stable));
    const double grown = run(routh_1, state<double, 2>(0.1, 0), 100, 10'000).norm();
    const double shrunk = run(routh_2, state<double, 2>(0.1, 0), 100, 10'000).norm();
    BOOST_TEST(std::abs(grown - 0.19807) < 5e-6);
    BOOST_TEST(std::abs(shrunk - 0.07570) < 5e-6);
}

BOOST_AUTO_TEST_CASE(definition_3_9_the_squared_length_is_a_lyapunov_function_of_routh_2_and_not_of_routh_1) {
    const auto good = lyapunov_function<2>(squared_length, routh_2);
    BOOST_TEST(good.is_proved(), good.text());
    const auto bad = lyapunov_function<2>(squared_length, routh_1);
    BOOST_TEST(bad.is_refuted(), bad.text());
    BOOST_TEST(bad.reason().find("> 0 at (") != std::string::npos);
    BOOST_TEST((orbital_derivative<2>(squared_length, routh_1).str() == "2*x1^4"));
    // averaged over a turn r' = -3/8 r^3, so 1/r^2 grows by 3/4 t
    const double r = run(routh_2, state<double, 2>(0.05, 0), 400, 20'000).norm();
    BOOST_TEST(std::abs(1 / (r * r) - (400 + 0.75 * 400)) < 2);
    const auto indefinite = [](const auto& x) { return x[0] * x[0] - x[1] * x[1]; };
    BOOST_TEST(lyapunov_function<2>(indefinite, routh_2).is_refuted());
    const auto degenerate = [](const auto& x) { return x[0] * x[0]; };  // 0 on an axis
    BOOST_TEST(lyapunov_function<2>(degenerate, routh_2).is_refuted());
}

BOOST_AUTO_TEST_CASE(definition_3_9_a_zero_of_v_off_the_origin_refutes_and_quadratic_forms_are_decided) {
    const auto decay_2 = [](const auto&, const auto& x, auto& f) {
        f[0] = -x[0];
        f[1] = -x[1];
    };
    const auto rest = [](const auto&, const auto&, auto& f) { f[0] = 0; };
    const auto difference = [](const auto& x) { return (x[0] - x[1]) * (x[0] - x[1]); };
    const auto flat = lyapunov_function<2>(difference, decay_2);
    BOOST_TEST(flat.is_refuted(), flat.text());
    BOOST_TEST(flat.reason() == "V = 0 <= 0 at (1, 1)");
    const auto two_wells = [](const auto& x) { return x[0] * x[0] * (x[0] - 1) * (x[0] - 1); };
    const auto well = lyapunov_function<1>(two_wells, rest);
    BOOST_TEST(well.is_refuted(), well.text());
    BOOST_TEST(well.reason() == "V = 0 <= 0 at (1)");
    // x^2 - 2xy + (1 + d) y^2 is positive definite for d > 0 only
    for (const int digits : {1, 9, 40, 300}) {
        const rational d(tableaux::integer(1),
                         tableaux::integer(pow(tableaux::integer(10), static_cast<unsigned>(digits))));
        const auto form = [](const rational& last) {
            return [last](const auto& x) { return x[0] * x[0] - 2 * x[0] * x[1] + last * x[1] * x[1]; };
        };
        BOOST_TEST(lyapunov_function<2>(form(1 + d), decay_2).is_proved(), digits);
        BOOST_TEST(lyapunov_function<2>(form(1 - d), decay_2).is_refuted(), digits);
        // beside higher powers the quadratic part is violated near 0
        const auto with_quartic = [&](const rational& last) {
            return [form, last](const auto& x) { return form(last)(x) + x[0] * x[0] * x[0] * x[0]; };
        };
        if (digits < 10) BOOST_TEST(lyapunov_function<2>(with_quartic(1 - d), decay_2).is_refuted(), digits);
        BOOST_TEST(!lyapunov_function<2>(with_quartic(1 + d), decay_2).is_refuted(), digits);
        // dV/dt of |x|^2/2 along x' = (-x + y, y (-1 - d) + x) is minus that form
        const auto squares = [](const auto& x) { return (x[0] * x[0] + x[1] * x[1]) / 2; };
        const auto along = [](const rational& last) {
            return [last](const auto&, const auto& x, auto& f) {
                f[0] = -x[0] + x[1];
                f[1] = x[0] - last * x[1];
            };
        };
        BOOST_TEST(lyapunov_function<2>(squares, along(1 + d)).is_proved(), digits);
        BOOST_TEST(lyapunov_function<2>(squares, along(1)).is_proved(), digits);
        BOOST_TEST(lyapunov_function<2>(squares, along(1 - d)).is_refuted(), digits);
    }
}

BOOST_AUTO_TEST_CASE(definition_3_9_on_a_shell_in_intervals) {
    const auto v = [](const auto& x) { return 7 * x[0] * x[0] - 2 * x[0] * x[1] + 3 * x[1] * x[1]; };  // 12 G
    const auto shell = lyapunov_function_on_shell<2>(v, node, 0.1, 0.4);
    BOOST_TEST(shell.is_proved(), shell.text());
    BOOST_TEST(!lyapunov_function_on_shell<2>(v, node, 0.1, 4.0).is_proved());
    const auto pendulum = [](const auto&, const auto& x, auto& f) {
        f[0] = x[1];
        f[1] = -sin(x[0]) - x[1];
    };
    const auto energy = [](const auto& x) { return 2 - 2 * cos(x[0]) + x[1] * x[1] + x[0] * x[1] / 2; };
    BOOST_TEST(lyapunov_function_on_shell<2>(energy, pendulum, 0.2, 0.8).is_proved());
    BOOST_TEST(message([&] { lyapunov_function_on_shell<2>(v, node, 1, 1); }).starts_with("shell: "));
}

BOOST_AUTO_TEST_CASE(the_second_phase_portrait_is_a_centre_by_its_first_integral) {
    // V = -x1 - 2 ln(1 - x1/2) - ln(1 - 2 x2^2)/2 has V' = x1' x1/(2 - x1) + x2' 2 x2/(1 - 2 x2^2); times
    // both denominators that is a polynomial, and it vanishes identically.
    state<multinomial, 2> x, f;
    for (int i = 0; i < 2; ++i) x[i] = multinomial::unknown(i);
    centre(0, x, f);
    const multinomial rate = f[0] * x[0] * (1 - 2 * x[1] * x[1]) + f[1] * 2 * x[1] * (2 - x[0]);
    BOOST_TEST(rate.is_zero(), rate.str());
    const auto v = [](const state<double, 2>& y) {
        return -y[0] - 2 * std::log(1 - y[0] / 2) - std::log(1 - 2 * y[1] * y[1]) / 2;
    };
    for (const state<double, 2>& start :
         {state<double, 2>(-1, 0), state<double, 2>(-0.5, 0), state<double, 2>(0.3, 0.2)}) {
        const auto end = run(centre, start, 30, 3000);
        BOOST_TEST(std::abs(v(end) - v(start)) < 1e-7 * v(start));
        BOOST_TEST(v(start) > 0);
    }
    // every term of V is convex near 0 with a strict minimum: V'' = 2/(2 - x1)^2 and (2 + 4 x2^2)/(1 - 2
    // x2^2)^2
    BOOST_TEST((linear_stability(matrix(2, {0, 2, rational(-1, 2), 0})).kind == lyapunov_stability::stable));
}

BOOST_AUTO_TEST_CASE(definition_3_1_x_minus_x_cubed_has_two_stable_equilibria_and_an_unstable_one) {
    const auto f = [](const auto&, const auto& x, auto& out) { out[0] = x[0] - x[0] * x[0] * x[0]; };
    for (const int c : {-1, 1}) {
        const auto a = attraction_radius<1>(f, state<rational, 1>(rational(c)));
        BOOST_TEST(a.verdict.is_proved());
    }
    BOOST_TEST(!attraction_radius<1>(f, state<rational, 1>(rational(0))).verdict.is_proved());
    BOOST_TEST((linear_stability(matrix(1, {1})).kind == lyapunov_stability::unstable));
    for (const double x0 : {-0.2, 0.1, 1.5}) {
        state<double, 1> x(x0);
        for (int n = 1; n <= 100; ++n) {
            x = *rk_step<1>(gauss_2(), f, x, 0.1);
            const double e = std::exp(0.1 * n);
            BOOST_TEST(std::abs(x[0] - x0 * e / std::sqrt(1 + x0 * x0 * (e * e - 1))) < 1e-5);
        }
    }
}

BOOST_AUTO_TEST_CASE(satz_1_25_adams_and_bdf_1_to_6_have_no_ghosts_by_exact_root_conditions) {
    for (int k = 1; k <= 6; ++k) {
        for (const auto& m : {adams_bashforth(k), adams_moulton(k), bdf(k)}) {
            BOOST_TEST(consistent_method(m).is_proved());
            BOOST_TEST(root_condition(m).is_proved(), root_condition(m).text());
            BOOST_TEST(no_multistep_ghosts(m).is_proved());
        }
        BOOST_TEST(order(adams_bashforth(k)) == k);
        BOOST_TEST(order(adams_moulton(k)) == k + 1);
        BOOST_TEST(order(bdf(k)) == k);
    }
    const auto two = adams_bashforth(2);
    BOOST_TEST((two.sigma == polynomial<rational>{rational(-1, 2), rational(3, 2)}));
}

BOOST_AUTO_TEST_CASE(
    satz_1_25_bdf_7_fails_the_root_condition_and_a_double_root_at_1_makes_every_point_stationary) {
    BOOST_TEST(root_condition(bdf(7)).is_refuted());
    const multistep bad{power(polynomial<rational>{-1, 1}, 2), polynomial<rational>{-1, 1}};
    BOOST_TEST(consistent_method(bad).is_proved());
    BOOST_TEST(root_condition(bad).is_refuted());
    BOOST_TEST(no_multistep_ghosts(bad).is_refuted());
    // x_n = 5 for f = 1: rho(1) 5 = 0 = h sigma(1) f
    BOOST_TEST((bad.rho(rational(1)) * 5 == bad.sigma(rational(1))));
    const multistep leapfrog{polynomial<rational>{-1, 0, 1}, polynomial<rational>{0, 2}};  // roots 1 and -1
    BOOST_TEST(root_condition(leapfrog).is_proved());
    const multistep twice{power(polynomial<rational>{1, 1}, 2) * polynomial<rational>{-1, 1},
                          polynomial<rational>{4}};
    BOOST_TEST(root_condition(twice).is_refuted());  // -1 twice
    BOOST_CHECK_THROW(bdf(0), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(the_order_counts_all_weights_also_beyond_the_last_x) {
    // x_(n+1) - x_n = h (5 f_n + 8 f_(n+1) - f_(n+2))/12: exact for f = 1, t, t^2, not for t^3
    const multistep ahead{polynomial<rational>{-1, 1},
                          polynomial<rational>{rational(5, 12), rational(2, 3), rational(-1, 12)}};
    BOOST_TEST(consistent_method(ahead).is_proved());
    BOOST_TEST(order(ahead) == 3);
    BOOST_CHECK_EXCEPTION(root_condition(ahead), std::invalid_argument, [](const auto& e) {
        return std::string(e.what()).starts_with("sigma: its degree 2 exceeds that of rho, 1");
    });
    // Consistency is order 1 at least, whatever the degrees.
    std::mt19937 random(3);
    std::uniform_int_distribution<int> pick(-2, 2);
    int consistent = 0;
    for (int k = 0; k < 2000; ++k) {
        const polynomial<rational> minus{-1, 1}, factor{pick(random), pick(random)};
        const multistep m{minus * factor,
                          polynomial<rational>{pick(random), pick(random), pick(random), pick(random)}};
        if (m.rho.is_zero()) continue;
        const bool proved = consistent_method(m).is_proved();
        BOOST_TEST(proved == (order(m) >= 1));
        consistent += proved ? 1 : 0;
    }
    BOOST_TEST(consistent > 100);
    BOOST_TEST(order({polynomial<rational>{1, 1}, polynomial<rational>{1}}) == -1);
    BOOST_CHECK_THROW(order(multistep{}), std::invalid_argument);
}
