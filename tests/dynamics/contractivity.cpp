// SPDX-License-Identifier: BSL-1.0
// Lecture, section 1.1, contractivity: dynamical systems, Gronwall's lemma, the one-sided Lipschitz condition
// and what it says of solutions; each theorem with a case in which its hypothesis is missing.
#define BOOST_TEST_MODULE contractivity
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <random>
#include <sstream>
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

namespace {

/// Doubles of all sizes and of kinds that rounding finds hard: few bits, subnormal, next to a power of two, next to a
/// multiple of pi/2.
class doubles {
  public:
    double operator()(int least, int most) {  // 2^least <= |x| < 2^(most + 1)
        const double size = std::ldexp(1 + std::ldexp(static_cast<double>(engine_() >> 12), -52),
                                       least + static_cast<int>(below(most - least + 1)));
        double x = size;
        switch (below(8)) {
            case 0:
                x = std::ldexp(1.0, std::ilogb(size));
                break;
            case 1:
                x = std::nextafter(std::ldexp(1.0, std::ilogb(size)), 0.0);
                break;
            case 2:
                x = std::ldexp(static_cast<double>(1 + below(1000)),
                               std::max(least, std::min(most - 10, std::ilogb(size))));
                break;
            case 3:
                if (size < 1e6)
                    x = std::nextafter(std::round(size / 1.5707963267948966) * 1.5707963267948966, size);
                break;
            default:
                break;
        }
        return below(2) == 0 ? x : -x;
    }
    unsigned below(int n) { return static_cast<unsigned>(engine_() % static_cast<unsigned>(n)); }
    /// An interval that contains x: x itself, a few neighbours, or wide.
    interval around(double x) {
        switch (below(4)) {
            case 0:
                return {std::nextafter(x, -HUGE_VAL), x};
            case 1: {
                const double w = std::ldexp(std::abs(x), -static_cast<int>(below(60)));
                return {x - w, x + std::ldexp(w, -static_cast<int>(below(4)))};
            }
            default:
                return x;
        }
    }

  private:
    std::mt19937_64 engine_{20241127};
};

bool contains(const interval& e, const rational& q) {
    return (std::isinf(e.low()) || exactly(e.low()) <= q) && (std::isinf(e.high()) || q <= exactly(e.high()));
}

}  // namespace

BOOST_AUTO_TEST_CASE(interval_arithmetic_contains_the_exact_results_of_1e5_operands_of_all_sizes) {
    doubles random;
    int missed = 0, points = 0;
    std::string first;
    const auto check = [&](const char* what, double x, double y, const interval& e, bool holds) {
        points += e.width() == 0 ? 1 : 0;
        if (holds || missed++ > 0) return;
        std::ostringstream text;
        text << std::hexfloat << what << " of " << x << " and " << y << ": " << e.low() << ", " << e.high();
        first = text.str();
    };
    for (int k = 0; k < 17'000; ++k) {
        const bool small = k % 2 == 0;
        const double x = small ? random(-40, 40) : random(-1074, 1023),
                     y = small ? random(-40, 40) : random(-1074, 1023);
        const interval a = random.around(x), b = random.around(y);
        const rational p = exactly(x), q = exactly(y);
        check("sum", x, y, a + b, contains(a + b, p + q));
        check("difference", x, y, a - b, contains(a - b, p - q));
        check("product", x, y, a * b, contains(a * b, p * q));
        check("quotient", x, y, a / b, contains(a / b, p / q));
        check("square", x, x, square(a), contains(square(a), p * p));
        const interval r = sqrt(abs(a));
        check(
            "root", x, x, r,
            exactly(r.low()) * exactly(r.low()) <= abs(p) && abs(p) <= exactly(r.high()) * exactly(r.high()));
    }
    BOOST_TEST(missed == 0, missed << " missed, first the " << first);
    BOOST_TEST(points > 4000);  // exact results stay points
}

BOOST_AUTO_TEST_CASE(interval_functions_contain_the_400_bit_values_at_24_000_arguments_of_all_sizes) {
    using wide = boost::multiprecision::number<
        boost::multiprecision::cpp_bin_float<400, boost::multiprecision::digit_base_2>,
        boost::multiprecision::et_off>;
    doubles random;
    int missed = 0;
    std::string first;
    const auto check = [&](const char* what, double x, const interval& e, const wide& value) {
        if ((wide(e.low()) <= value && value <= wide(e.high())) || missed++ > 0) return;
        std::ostringstream text;
        text << std::hexfloat << what << " of " << x << ": " << e.low() << ", " << e.high();
        first = text.str();
    };
    for (int k = 0; k < 6000; ++k) {
        const double x = k % 2 == 0 ? random(-10, 9) : random(-1074, 19);
        const interval a = random.around(x);
        check("exp", x, exp(a), exp(wide(x)));
        check("sin", x, sin(a), sin(wide(x)));
        check("cos", x, cos(a), cos(wide(x)));
        const double p = std::abs(k % 3 == 0 ? random(-1074, 1023) : x);
        check("log", p, log(abs(random.around(p))), log(wide(p)));
    }
    BOOST_TEST(missed == 0, missed << " missed, first the " << first);
}

BOOST_AUTO_TEST_CASE(intervals_of_rationals_are_the_narrowest_whatever_the_lengths_of_both_parts) {
    std::mt19937_64 random(3);
    const auto number = [&](int most) {
        tableaux::integer n = 1;
        for (int bits = 1 + static_cast<int>(random() % static_cast<unsigned>(most)); bits > 0; bits -= 60)
            n = (n << std::min(bits, 60)) + (random() >> (64 - std::min(bits, 60)));
        return n;
    };
    for (int k = 0; k < 20'000; ++k) {
        const rational q(random() % 2 == 0 ? number(1200) : tableaux::integer(-number(1200)), number(1200));
        const interval e(q);
        if (!contains(e, q) || (e.width() != 0 && std::nextafter(e.low(), HUGE_VAL) != e.high()))
            BOOST_ERROR(q << " is in " << to_string(e));
    }
    const rational huge = rational(tableaux::integer(1) << 1100), tiny = 1 / huge;
    BOOST_TEST((interval(huge).low() == 0x1.fffffffffffffp1023 && std::isinf(interval(huge).high())));
    BOOST_TEST((std::isinf(interval(-huge).low()) && interval(-huge).high() == -0x1.fffffffffffffp1023));
    BOOST_TEST((interval(tiny) == interval(0.0, 0x1p-1074)));
    BOOST_TEST((interval(-tiny) == interval(-0x1p-1074, 0.0)));
    BOOST_TEST((interval(tableaux::scaled(rational(3), -1074)) == interval(3 * 0x1p-1074)));
}

BOOST_AUTO_TEST_CASE(a_constant_that_is_attained_at_a_surd_is_said_to_be_attained_near_a_rational) {
    // f' = (x^2 - 1)/(1 + x^2)^2 is largest at x^2 = 3, with the value 1/8; that of 2x - x^2 at x = 0.
    const auto surd =
        one_sided_lipschitz<1>([](const auto&, const auto& x, auto& f) { f[0] = -x[0] / (1 + x[0] * x[0]); });
    BOOST_TEST(surd.high == rational(1, 8));
    BOOST_TEST(surd.verdict.reason().find("attained near") != std::string::npos, surd.verdict.text());
    BOOST_TEST(abs(surd.point[0] * surd.point[0] - 3) < rational(1, 1000000));
    const auto rational_point =
        one_sided_lipschitz<1>([](const auto&, const auto& x, auto& f) { f[0] = x[0] / (1 + x[0] * x[0]); });
    BOOST_TEST(rational_point.high == 1);
    BOOST_TEST(rational_point.verdict.reason().find("attained at (0)") != std::string::npos,
               rational_point.verdict.text());
}

BOOST_AUTO_TEST_CASE(one_sided_constants_of_long_rational_slopes_are_theirs) {
    tableaux::integer power = 1;
    power <<= 962;
    const rational q(tableaux::integer(3), tableaux::integer(power + 1));  // f = q 2^962 x, f' = 3 - 6e-290
    const auto steep = [&](const auto&, const auto& x, auto& f) {
        f[0] = std::decay_t<decltype(f[0])>(interval(q)) * (0x1p962 * x[0]);
    };
    const box<1> where(interval(-1, 1));
    const auto three = one_sided_lipschitz_on<1>(steep, where);
    BOOST_TEST(three.verdict.is_proved());
    BOOST_TEST((three.low <= q * rational(power) && q * rational(power) <= three.high));
    BOOST_TEST(std::abs(three.high.to<double>() - 3) < 1e-12);
    const rational small = 1 / rational(tableaux::integer(pow(tableaux::integer(10), 290)));
    const auto flat = [&](const auto&, const auto& x, auto& f) {
        f[0] = std::decay_t<decltype(f[0])>(interval(small)) * x[0];
    };
    const auto tiny = one_sided_lipschitz_on<1>(flat, where);
    BOOST_TEST(tiny.high >= small);
    // what is printed is the double that was proved
    BOOST_TEST(tiny.verdict.reason().find(" and 1.00000000000000") != std::string::npos, tiny.verdict.text());
    BOOST_TEST(tiny.verdict.reason().find("e-290, attained at") != std::string::npos, tiny.verdict.text());
    BOOST_TEST(to_string(interval(0.1, 1e300)) == "[0.1, 1e+300]");
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

BOOST_AUTO_TEST_CASE(on_a_box_an_inner_product_may_be_nearly_singular) {
    box<2> where;
    where[0] = where[1] = interval(-1, 1);
    const auto twisted = [](const auto&, const auto& x, auto& f) {
        f[0] = -3 * x[0] + x[1];
        f[1] = x[0] - 3 * x[1];
    };
    const auto both_decay = [](const auto&, const auto& x, auto& f) {
        f[0] = -x[0];
        f[1] = -x[1];
    };
    for (const int k : {10, 40, 60, 300, 700}) {
        const rational e = tableaux::scaled(rational(1), -k), c = 1 - e;
        const bool lost = k > 80;
        for (const auto& G :
             {matrix(2, {1, c, c, 1}), matrix(2, {1, 0, 0, e}), matrix(2, {e, 0, 0, 1 / e})}) {
            if (lost && G(0, 1) != 0) {
                BOOST_CHECK_EXCEPTION(
                    one_sided_lipschitz_on<2>(both_decay, where, G), std::invalid_argument,
                    [](const auto& x) {
                        return std::string(x.what()).starts_with("G: positive definite, but");
                    });
                continue;
            }
            const auto decays = one_sided_lipschitz_on<2>(both_decay, where, G);
            BOOST_TEST(decays.verdict.is_proved(), k << ": " << decays.verdict.text());
            BOOST_TEST((decays.low <= -1 && -1 <= decays.high && decays.high - decays.low < rational(1, 100)),
                       k);
        }
        if (lost) continue;
        // the matrix has the eigenvectors (1, 1) and (1, -1) of G, so gamma is its larger eigenvalue
        const auto sym = one_sided_lipschitz_on<2>(twisted, where, matrix(2, {1, c, c, 1}));
        BOOST_TEST((sym.verdict.is_proved() && sym.low <= -2 && -2 <= sym.high),
                   k << ": " << sym.verdict.text());
        // any other: the exact constant of the linear field
        const auto G = matrix(2, {1, c, c, 1});
        const auto exact = one_sided_lipschitz<2>(shear, G),
                   boxed = one_sided_lipschitz_on<2>(shear, where, G);
        BOOST_TEST((boxed.verdict.is_proved() && boxed.low <= exact.high && exact.low <= boxed.high), k);
    }
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
