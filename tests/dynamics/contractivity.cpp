// SPDX-License-Identifier: BSL-1.0
// Lecture, section 1.1, contractivity: dynamical systems, Gronwall's lemma, the one-sided Lipschitz condition
// and what it says of solutions; each theorem with a case in which its hypothesis is missing.
#define BOOST_TEST_MODULE contractivity
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <random>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/linear/logarithmic_norm.hpp>
#include <stagecraft/theory/dynamics/one_sided_lipschitz.hpp>

using namespace stagecraft;
using namespace stagecraft::theory;
using Eigen::VectorXd;

namespace {

using field = std::function<void(double, const VectorXd&, VectorXd&)>;

result<VectorXd> run(const field& f, const VectorXd& x0, double t0, double t1, double tol = 1e-10) {
    return integrate(radau_iia<3>(), f, x0, t0, t1, {.rtol = tol, .atol = tol * 1e-2, .max_steps = 200'000});
}

VectorXd at(const field& f, const VectorXd& x0, double t) {
    const auto r = run(f, x0, 0, t);
    BOOST_REQUIRE(r.ok());
    return r.y;
}

VectorXd vector(std::initializer_list<double> x) {
    VectorXd v(static_cast<Eigen::Index>(x.size()));
    std::copy(x.begin(), x.end(), v.data());
    return v;
}

const auto cubic = [](const auto&, const auto& x, auto& f) { f[0] = x[0] - x[0] * x[0] * x[0]; };
const auto minus_cube = [](const auto&, const auto& x, auto& f) { f[0] = -x[0] * x[0] * x[0]; };
const auto square_field = [](const auto&, const auto& x, auto& f) { f[0] = x[0] * x[0]; };
const auto decay = [](const auto&, const auto& x, auto& f) { f[0] = -x[0]; };
const auto witch = [](const auto&, const auto& x, auto& f) { f[0] = -x[0] / (1 + x[0] * x[0]); };
const auto rotation = [](const auto&, const auto& x, auto& f) {
    f[0] = -x[1];
    f[1] = x[0];
    f[2] = 0;
};
const auto shear = [](const auto&, const auto& x, auto& f) {
    f[0] = -x[0] + 10 * x[1];
    f[1] = -x[1];
};
const auto routh_2 = [](const auto&, const auto& x, auto& f) {
    f[0] = -x[1] - x[0] * x[0] * x[0];
    f[1] = x[0];
};
const auto pendulum = [](const auto&, const auto& x, auto& f) {
    f[0] = x[1] - x[0] / 2;
    f[1] = -sin(x[0]) - x[1];
};

dense<rational> matrix(int n, std::initializer_list<rational> entries) {
    dense<rational> G(n, n);
    auto e = entries.begin();
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) G(i, j) = *e++;
    return G;
}

Eigen::MatrixXd in_double(const dense<rational>& G) {
    return G.unaryExpr([](const rational& q) { return q.to<double>(); });
}

/// A field with the constant that was proved for it, and where its solutions are looked at.
struct contractive {
    const char* name;
    field f;
    one_sided_constant gamma;
    dense<rational> G;
    double reach;
};

const std::vector<contractive>& eight_problems() {
    static const std::vector<contractive> all = [] {
        const auto G = matrix(2, {1, 0, 0, 400});
        box<2> near;
        near[0] = near[1] = interval(-1.5, 1.5);
        return std::vector<contractive>{
            {"x - x^3", cubic, one_sided_lipschitz<1>(cubic), euclidean(1), 2},
            {"-x^3", minus_cube, one_sided_lipschitz<1>(minus_cube), euclidean(1), 2},
            {"-x", decay, one_sided_lipschitz<1>(decay), euclidean(1), 2},
            {"-x/(1 + x^2)", witch, one_sided_lipschitz<1>(witch), euclidean(1), 4},
            {"rotation", rotation, one_sided_lipschitz<3>(rotation), euclidean(3), 2},
            {"shear, G", shear, one_sided_lipschitz<2>(shear, G), G, 2},
            {"Routh 2", routh_2, one_sided_lipschitz<2>(routh_2), euclidean(2), 1},
            {"pendulum", pendulum, one_sided_lipschitz_on<2>(pendulum, near), euclidean(2), 0.7}};
    }();
    return all;
}

double norm(const dense<rational>& G, const VectorXd& v) { return std::sqrt(v.dot(in_double(G) * v)); }

}  // namespace

BOOST_AUTO_TEST_CASE(interval_functions_enclose_and_are_narrow) {
    using wide = boost::multiprecision::cpp_bin_float_50;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> pick(-30, 30);
    for (int k = 0; k < 2000; ++k) {
        const double x = pick(random), p = std::abs(x) + 1e-3;
        const auto check = [&](const interval& e, const wide& exact, const char* what) {
            BOOST_TEST((wide(e.low()) <= exact && exact <= wide(e.high())), what << " of " << x);
            BOOST_TEST(e.width() <= 1e-14 * std::max(1.0, std::abs(e.middle())), what << " of " << x);
        };
        check(exp(interval(x)), exp(wide(x)), "exp");
        check(sin(interval(x)), sin(wide(x)), "sin");
        check(cos(interval(x)), cos(wide(x)), "cos");
        check(log(interval(p)), log(wide(p)), "log");
        check(sqrt(interval(p)), sqrt(wide(p)), "sqrt");
        check(interval(x) / interval(p), wide(x) / wide(p), "quotient");
        const double y = pick(random);
        const interval wide_range(std::min(x, y), std::max(x, y));
        for (int j = 0; j <= 8; ++j) {
            const double z = std::clamp(x + (y - x) * j / 8, wide_range.low(), wide_range.high());
            BOOST_TEST(sin(wide_range).contains(std::sin(z)));
            BOOST_TEST(cos(wide_range).contains(std::cos(z)));
        }
    }
    BOOST_TEST((interval(0.1) + interval(0.2)).width() > 0);
    BOOST_TEST((interval(0.5) + interval(0.25)).width() == 0);
    BOOST_TEST((1 / interval(-1, 1) == interval::whole()));
    BOOST_TEST(sin(interval(0.0, 2.0)).high() == 1.0);
    BOOST_CHECK_THROW(interval(1, 0), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(definition_1_2_x_squared_ends_at_1_over_x0_with_a_status_and_lives_for_x0_not_positive) {
    for (const double x0 : {0.5, 1.0, 4.0}) {
        const auto r = run(square_field, vector({x0}), 0, 10);
        BOOST_TEST(!r.ok());
        BOOST_TEST(std::abs(r.t - 1 / x0) < 1e-5);
        BOOST_TEST(std::isfinite(r.y[0]));
    }
    for (const double x0 : {0.0, -0.5, -3.0}) {
        const VectorXd y = at(square_field, vector({x0}), 50);
        BOOST_TEST(std::abs(y[0] - x0 / (1 - 50 * x0)) < 1e-8);
        BOOST_TEST(y[0] <= 0.0);
    }
    for (const double x0 : {-1.0, 0.0, 1.0, 1e3})  // -x^3 is a dynamical system on all of R
        BOOST_TEST(std::abs(at(minus_cube, vector({x0}), 5)[0] - x0 / std::sqrt(1 + 10 * x0 * x0)) < 1e-8);
}

BOOST_AUTO_TEST_CASE(definition_1_3_the_solution_operators_are_a_semigroup_in_autonomous_systems_only) {
    for (const auto& p : eight_problems()) {
        const VectorXd x = VectorXd::Constant(p.G.rows(), 0.4);
        BOOST_TEST((at(p.f, x, 1.7) - at(p.f, at(p.f, x, 0.9), 0.8)).norm() < 1e-8, p.name);
        BOOST_TEST((at(p.f, x, 1.7) - at(p.f, at(p.f, x, 0.8), 0.9)).norm() < 1e-8, p.name);
    }
    const field minus_tx = [](double t, const VectorXd& x, VectorXd& f) { f = -t * x; };
    const VectorXd x = vector({1.0});
    BOOST_TEST((at(minus_tx, x, 1.7) - at(minus_tx, at(minus_tx, x, 0.9), 0.8)).norm() > 0.1);
}

BOOST_AUTO_TEST_CASE(one_sided_lipschitz_constants_of_the_lecture_are_decided) {
    const auto a = one_sided_lipschitz<1>(cubic);
    BOOST_TEST(a.verdict.is_proved());
    BOOST_TEST((a.low == 1 && a.high == 1 && a.point == std::vector<rational>{0}));
    const auto b = one_sided_lipschitz<1>(minus_cube);  // 0, though f is not Lipschitz continuous
    BOOST_TEST((b.verdict.is_proved() && b.low == 0 && b.high == 0));
    const auto c = one_sided_lipschitz<1>(witch);  // f' = (x^2 - 1)/(1 + x^2)^2, 1/8 at x^2 = 3
    BOOST_TEST(c.verdict.is_proved());
    BOOST_TEST(
        (c.low <= rational(1, 8) && rational(1, 8) <= c.high && c.high - c.low < rational(1, 1'000'000'000)));
    const auto r = one_sided_lipschitz<3>(rotation);
    BOOST_TEST((r.verdict.is_proved() && r.low == 0 && r.high == 0));
    const auto routh = one_sided_lipschitz<2>(routh_2);
    BOOST_TEST((routh.verdict.is_proved() && routh.high == 0));
}

BOOST_AUTO_TEST_CASE(x_squared_has_no_one_sided_constant_and_a_pair_of_points_refutes_each) {
    BOOST_TEST(one_sided_lipschitz<1>(square_field).verdict.is_refuted());
    for (const int gamma : {-3, 0, 7, 1'000'000}) {
        const auto pair = refuting_pair(square_field, gamma);
        BOOST_REQUIRE(pair.has_value());
        const auto [x, y] = *pair;
        BOOST_TEST(((x * x - y * y) * (x - y) > rational(gamma) * (x - y) * (x - y)));
    }
    BOOST_TEST(!refuting_pair(cubic, 1).has_value());
    BOOST_TEST(refuting_pair(cubic, rational(99, 100)).has_value());
}

BOOST_AUTO_TEST_CASE(on_a_box_the_constant_is_enclosed_and_agrees_with_the_exact_one_and_with_samples) {
    box<1> line;
    line[0] = interval(-3, 3);
    const auto g = one_sided_lipschitz_on<1>(witch, line);
    BOOST_TEST(g.verdict.is_proved());
    BOOST_TEST((g.low <= rational(1, 8) && rational(1, 8) <= g.high));
    BOOST_TEST((g.high - g.low).to<double>() < 2e-4);
    box<2> near;
    near[0] = near[1] = interval(-1.5, 1.5);
    const auto p = one_sided_lipschitz_on<2>(pendulum, near);
    BOOST_TEST(p.verdict.is_proved());
    // -1/2 and -1 on the diagonal, (1 - cos x)/2 beside it, largest at the ends
    const double off = (1 - std::cos(1.5)) / 2, exact = -0.75 + std::hypot(0.25, off);
    BOOST_TEST(p.low.to<double>() <= exact + 1e-12);
    BOOST_TEST(p.high.to<double>() >= exact - 1e-12);
    BOOST_TEST(sampled_one_sided_constant<2>(pendulum, near, 2000) <= p.high.to<double>());
    // too few boxes: nothing is claimed
    const auto early =
        one_sided_lipschitz_on<2>(pendulum, near, euclidean(2), {.relative = 1e-9, .boxes = 50});
    BOOST_TEST(early.verdict.is_consistent());
    BOOST_TEST((early.low <= p.high && p.low <= early.high));
}

BOOST_AUTO_TEST_CASE(the_logarithmic_norm_in_an_inner_product_bounds_every_quotient_and_is_attained) {
    const Eigen::Matrix2d A{{-1, 10}, {0, -1}}, G{{1, 0}, {0, 400}};
    const double mu = logarithmic_norm(A, G);
    BOOST_TEST(std::abs(mu - (-0.75)) < 1e-14);  // -1 + 10/(2 sqrt(400))
    BOOST_TEST(std::abs(logarithmic_norm(A, Eigen::Matrix2d::Identity()) - logarithmic_norm(A).euclidean) <
               1e-14);
    double best = -1e300;
    for (int k = 0; k < 1000; ++k) {
        const Eigen::Vector2d x(std::cos(k * 0.00314159265), std::sin(k * 0.00314159265));
        const double q = x.dot(G * A * x) / x.dot(G * x);
        BOOST_TEST(q <= mu + 1e-13);
        best = std::max(best, q);
    }
    BOOST_TEST(best > mu - 1e-3);
    BOOST_CHECK_THROW(logarithmic_norm(A, Eigen::Matrix2d{{1, 2}, {2, 1}}), std::invalid_argument);
    BOOST_CHECK_THROW(logarithmic_norm(A, Eigen::Matrix2d{{1, 1}, {0, 1}}), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(satz_1_6_1_and_2_two_solutions_separate_no_faster_than_e_to_gamma_t) {
    std::mt19937 random(7);
    for (const auto& p : eight_problems()) {
        BOOST_REQUIRE_MESSAGE(p.gamma.verdict.is_proved(), p.name << ": " << p.gamma.verdict.text());
        const double gamma = p.gamma.high.to<double>();
        std::uniform_real_distribution<double> pick(-p.reach, p.reach);
        for (int k = 0; k < 5; ++k) {
            VectorXd x = VectorXd::NullaryExpr(p.G.rows(), [&] { return pick(random); });
            VectorXd y = VectorXd::NullaryExpr(p.G.rows(), [&] { return pick(random); });
            const double first = norm(p.G, x - y);
            for (const double t : {0.3, 1.0, 3.0})
                BOOST_TEST(norm(p.G, at(p.f, x, t) - at(p.f, y, t)) <=
                               std::exp(gamma * t) * first * (1 + 1e-6) + 1e-9,
                           p.name);
        }
    }
}

BOOST_AUTO_TEST_CASE(satz_1_6_2_with_gamma_less_one_hundredth_is_violated_near_the_point_that_attains_gamma) {
    for (const auto& p : eight_problems()) {
        const double gamma = p.gamma.low.to<double>(), t = 0.01;
        VectorXd x(p.G.rows());
        for (Eigen::Index i = 0; i < x.size(); ++i)
            x[i] = p.gamma.point[static_cast<std::size_t>(i)].to<double>();
        double largest = 0;
        for (int k = 0; k < 60; ++k) {  // directions of the first two unknowns
            VectorXd d = VectorXd::Zero(x.size());
            d[0] = std::cos(k * 0.05236);
            if (x.size() > 1) d[1] = std::sin(k * 0.05236) / (p.G(1, 1) == 1 ? 1.0 : 20.0);
            d *= 1e-3;
            const VectorXd u = at(p.f, x + d, t), v = at(p.f, x - d, t);
            largest = std::max(largest, norm(p.G, u - v) / norm(p.G, 2 * d));
        }
        BOOST_TEST(largest > std::exp((gamma - 0.01) * t), p.name);
        BOOST_TEST(largest < std::exp((p.gamma.high.to<double>() + 0.001) * t), p.name);
    }
}

BOOST_AUTO_TEST_CASE(lemma_1_5_gronwall_holds_and_fails_where_its_inequality_does) {
    // z' = a z + b - c(t), c >= 0, against e^(at) z(0) + b/a (e^(at) - 1)
    for (const double a : {-2.0, 0.5}) {
        const double b = 1.5;
        for (const double c : {0.0, 1.0, -1.0}) {
            const field z = [&](double t, const VectorXd& x, VectorXd& f) {
                f = VectorXd::Constant(1, a * x[0] + b - c * std::pow(std::sin(t), 2));
            };
            const double value = at(z, vector({0.7}), 2)[0];
            const double bound = std::exp(2 * a) * 0.7 + b / a * (std::exp(2 * a) - 1);
            if (c == 0) BOOST_TEST(std::abs(value - bound) < 1e-8);
            if (c > 0) BOOST_TEST(value < bound);
            if (c < 0) BOOST_TEST(value > bound + 1e-3);
        }
    }
}

BOOST_AUTO_TEST_CASE(satz_1_7_equilibria_of_weakly_contractive_fields_are_convex) {
    // On the segment between two equilibria f vanishes identically: a polynomial in the parameter s.
    const auto vanishes_between = []<int N>(auto f, const state<rational, N>& c,
                                            const state<rational, N>& d) {
        state<multinomial, N> x, out;
        for (int i = 0; i < N; ++i) x[i] = multinomial(c[i]) + multinomial::unknown(0) * (d[i] - c[i]);
        f(multinomial(0), x, out);
        for (int i = 0; i < N; ++i)
            if (!out[i].is_zero()) return false;
        return true;
    };
    const auto two = [](int a, int b) {
        state<rational, 2> x;
        x << rational(a), rational(b);
        return x;
    };
    const auto sum = [](const auto&, const auto& x, auto& f) { f[0] = f[1] = -x[0] - x[1]; };
    const auto first = [](const auto&, const auto& x, auto& f) {
        f[0] = -x[0] * x[0] * x[0];
        f[1] = 0;
    };
    const auto shifted = [](const auto&, const auto& x, auto& f) {
        f[0] = 2 - x[0] - x[1];
        f[1] = 2 - x[0] - x[1];
    };
    for (const auto& g : {one_sided_lipschitz<2>(sum), one_sided_lipschitz<2>(first),
                          one_sided_lipschitz<2>(shifted), one_sided_lipschitz<3>(rotation)})
        BOOST_TEST((g.verdict.is_proved() && g.high == 0));
    BOOST_TEST((vanishes_between.operator()<2>(sum, two(1, -1), two(-5, 5))));
    BOOST_TEST((vanishes_between.operator()<2>(first, two(0, -1), two(0, 5))));
    BOOST_TEST((vanishes_between.operator()<2>(shifted, two(2, 0), two(-1, 3))));
    state<rational, 3> low, high;
    low << rational(0), rational(0), rational(-1);
    high << rational(0), rational(0), rational(4);
    BOOST_TEST((vanishes_between.operator()<3>(rotation, low, high)));
    // gamma = 1: {-1, 0, 1} is not convex
    state<rational, 1> minus(rational(-1)), plus(rational(1)), half(rational(1, 2));
    BOOST_TEST((exact_value<1>(cubic, minus)[0] == 0 && exact_value<1>(cubic, plus)[0] == 0));
    BOOST_TEST((exact_value<1>(cubic, half)[0] != 0));
    BOOST_TEST((!vanishes_between.operator()<1>(cubic, minus, plus)));
}

BOOST_AUTO_TEST_CASE(section_1_1_1_minus_t_x_is_contractive_from_t0_on_with_gamma_minus_t0) {
    const auto f = [](const auto& t, const auto& x, auto& out) { out[0] = -t * x[0]; };
    for (const rational& t0 : {rational(1, 2), rational(3), rational(-2)}) {
        const auto g = one_sided_lipschitz_from<1>(f, t0);
        BOOST_TEST(g.verdict.is_proved());
        BOOST_TEST((g.low == -t0 && g.high == -t0));
        const double start = t0.to<double>();
        const auto x = run(f, vector({2.0}), start, start + 1, 1e-11),
                   y = run(f, vector({-1.0}), start, start + 1, 1e-11);
        BOOST_TEST((x.y - y.y).norm() <= 3 * std::exp(-start) * (1 + 1e-9));
    }
    // from t0 = -2 on the distance grows first
    const auto x = run(f, vector({2.0}), -2, -1), y = run(f, vector({-1.0}), -2, -1);
    BOOST_TEST((x.y - y.y).norm() > 3 * 1.5);
}

BOOST_AUTO_TEST_CASE(bad_input_of_one_sided_lipschitz_is_named) {
    const auto message = [](auto call) {
        try {
            call();
        } catch (const std::invalid_argument& e) {
            return std::string(e.what());
        }
        return std::string("no exception");
    };
    box<1> open, good;
    open[0] = interval(0, std::numeric_limits<double>::infinity());
    good[0] = interval(-1, 1);
    BOOST_TEST(message([&] { one_sided_lipschitz_on<1>(cubic, open); }).starts_with("box: "));
    const auto pole = [](const auto&, const auto& x, auto& f) { f[0] = 1 / x[0]; };
    BOOST_TEST(message([&] { one_sided_lipschitz<1>(pole); }).starts_with("f: divides through zero"));
    BOOST_TEST(message([&] { one_sided_lipschitz_on<1>(pole, good); }).starts_with("f: "));
    BOOST_TEST(message([&] {
                   one_sided_lipschitz<2>(shear, matrix(2, {1, 2, 2, 1}));
               }) == "G: must be positive definite");
    BOOST_TEST(message([&] {
                   one_sided_lipschitz<2>(shear, matrix(2, {1, 1, 0, 1}));
               }) == "G: must be symmetric");
    BOOST_TEST(message([&] { one_sided_lipschitz<2>(shear, euclidean(3)); }) == "G: must be 2 x 2");
    BOOST_CHECK_THROW(interval(1, -1), std::invalid_argument);
    BOOST_CHECK_THROW(interval(0, std::nan("")), std::invalid_argument);
    const auto timed = [](const auto& t, const auto& x, auto& f) {
        f[0] = t * x[0];
        f[1] = 0;
    };
    BOOST_TEST(message([&] { one_sided_lipschitz<2>(timed); }).starts_with("f: depends on time"));
}
