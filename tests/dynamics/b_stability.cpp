// SPDX-License-Identifier: BSL-1.0
// Lecture, section 1.2: B-stability in runs of two solutions, its converse, and contraction factors.
#define BOOST_TEST_MODULE b_stability
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <problems/dense_once.hpp>
#include <random>
#include <stagecraft/tableaux/exact_tableau.hpp>
#include <stagecraft/theory/dynamics/autonomous_witness.hpp>
#include <stagecraft/theory/dynamics/contraction.hpp>
#include <stagecraft/theory/dynamics/expansion_witness.hpp>
#include <stagecraft/theory/dynamics/rk_map.hpp>

#include "../catalogue.hpp"

using namespace stagecraft;
using namespace stagecraft::theory;
using tableaux::family;
using tableaux::quadratic;

namespace {

using method = tableau<quadratic>;
using read_once::exact_methods;

method named(const std::string& name) {
    for (const auto& [n, t] : exact_methods())
        if (n == name) return t;
    throw std::invalid_argument(name);
}

bool has_distinct_nodes(const method& t) {
    for (Eigen::Index i = 0; i < t.c.size(); ++i)
        for (Eigen::Index j = 0; j < i; ++j)
            if (t.c[i] == t.c[j]) return false;
    return true;
}

/// Six fields in the plane with <f(x) - f(y), x - y> <= 0.
struct monotone {
    int kind;
    template <class T, class X, class Y>
    void operator()(const T& t, const X& x, Y& f) const {
        using std::sqrt;
        switch (kind) {
            case 0:  // Routh's second system
                f[0] = -x[1] - x[0] * x[0] * x[0];
                f[1] = x[0];
                break;
            case 1:  // a rotation, energy kept
                f[0] = -3 * x[1];
                f[1] = 3 * x[0];
                break;
            case 2:  // -grad of (x + y)^4/4
                f[0] = f[1] = -(x[0] + x[1]) * (x[0] + x[1]) * (x[0] + x[1]);
                break;
            case 3:  // -grad of sqrt(1 + |x|^2)
                f[0] = -x[0] / sqrt(1 + x[0] * x[0] + x[1] * x[1]);
                f[1] = -x[1] / sqrt(1 + x[0] * x[0] + x[1] * x[1]);
                break;
            case 4:  // explicit in time
                f[0] = -t * t * x[0] + t * x[1];
                f[1] = -t * x[0];
                break;
            default:  // stiff and skew
                f[0] = -1e4 * x[0] + 50 * x[1];
                f[1] = -50 * x[0] - x[1] * x[1] * x[1];
        }
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(satz_1_18_algebraically_stable_methods_contract_random_pairs_on_six_monotone_fields) {
    std::vector<std::pair<std::string, tableau<double>>> stable;
    for (const auto& [name, t] : exact_methods())
        if (algebraically_stable(t).is_proved()) stable.emplace_back(name, in_doubles(t));
    BOOST_TEST(stable.size() >= 10u);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> pick(-3, 3), exponent(-3, 6), time(0, 5);
    int measured = 0, tried = 0;
    for (int k = 0; k < 100'000; ++k) {
        const auto& [name, m] = stable[static_cast<std::size_t>(k) % stable.size()];
        const monotone f{static_cast<int>(random() % 6)};
        const state<double, 2> x(pick(random), pick(random)), y(pick(random), pick(random));
        const double h = std::pow(10, exponent(random)), t = time(random);
        ++tried;
        const auto u = rk_step<2>(m, f, x, h, t), v = rk_step<2>(m, f, y, h, t);
        if (!u || !v) continue;  // Newton's method found no solution: nothing is measured
        ++measured;
        BOOST_TEST((*u - *v).norm() <= (x - y).norm() * (1 + 1e-9) + 1e-9,
                   name << ", field " << f.kind << ", h = " << h);
    }
    BOOST_TEST(measured > 0.9 * tried);
}

BOOST_AUTO_TEST_CASE(satz_1_18_every_other_exact_method_has_an_exact_expansion_witness_equal_nodes_or_not) {
    int witnesses = 0, with_equal_nodes = 0;
    for (const auto& [name, t] : exact_methods()) {
        const auto w = expansion_witness(t);
        BOOST_TEST(w.has_value() == !algebraically_stable(t).is_proved(), name);
        if (!w) continue;
        ++witnesses;
        with_equal_nodes += has_distinct_nodes(t) ? 0 : 1;
        BOOST_TEST((quadratic(1) < w->squared_factor), name);
        for (std::size_t i = 0; i < w->real.size(); ++i) {
            BOOST_TEST((w->real[i] <= 0), name);
            for (std::size_t j = 0; j < i; ++j)
                if (t.c[static_cast<Eigen::Index>(i)] == t.c[static_cast<Eigen::Index>(j)])
                    BOOST_TEST((w->real[i] == w->real[j] && w->imaginary[i] == w->imaginary[j]), name);
        }
        // the linear problem with these values, one step
        const double h = 0.5;
        const auto problem = [&](double time, const auto& x, auto& f) { w->field(time, x, f, h); };
        const auto y = rk_step<2>(w->method, problem, state<double, 2>(1, 0), h);
        BOOST_REQUIRE_MESSAGE(y.has_value(), name);
        BOOST_TEST(std::abs(y->norm() - w->factor()) <= 1e-9 * w->factor(), name);
        BOOST_TEST(y->norm() > 1.0, name);
    }
    BOOST_TEST(witnesses >= 70);
    BOOST_TEST(with_equal_nodes >= 20);
}

BOOST_AUTO_TEST_CASE(satz_1_18_methods_with_equal_nodes_expand_on_an_autonomous_decreasing_field_too) {
    int found = 0;
    for (const auto& [name, t] : exact_methods()) {
        if (has_distinct_nodes(t) || algebraically_stable(t).is_proved()) continue;
        const auto w = autonomous_witness(t);
        BOOST_REQUIRE_MESSAGE(w.has_value(), name);
        ++found;
        for (std::size_t i = 1; i < w->points.size(); ++i) {
            BOOST_TEST((w->points[i - 1].first < w->points[i].first), name);
            BOOST_TEST(!(w->points[i - 1].second < w->points[i].second), name);
        }
        BOOST_TEST((*w)(0) == 0.0);
        BOOST_TEST((quadratic(1) < w->end * w->end), name);
        const auto m = in_doubles(t);
        if (!is_explicit(m)) continue;
        double end = 1;  // one step of size 1
        std::vector<double> k;
        for (Eigen::Index i = 0; i < m.b.size(); ++i) {
            double x = 1;
            for (Eigen::Index j = 0; j < i; ++j) x += m.A(i, j) * k[static_cast<std::size_t>(j)];
            k.push_back((*w)(x));
            end += m.b[i] * k.back();
        }
        BOOST_TEST(std::abs(end - near_double(w->end)) <= 1e-9 * std::abs(end), name);
    }
    BOOST_TEST(found >= 20);
    BOOST_TEST(!autonomous_witness(named("gauss_2")).has_value());
    BOOST_TEST(!autonomous_witness(named("lobatto_iiib_2")).has_value());  // there it is the midpoint rule
}

BOOST_AUTO_TEST_CASE(
    the_trapezoidal_rule_doubles_a_distance_and_lobatto_iiib_2_expands_though_it_is_the_midpoint_rule) {
    const auto trapezoidal = expansion_witness(named("trapezoidal_rule"));
    BOOST_REQUIRE(trapezoidal.has_value());
    BOOST_TEST((trapezoidal->real == std::vector<rational>{-6, 0}));
    BOOST_TEST((trapezoidal->squared_factor == quadratic(4)));
    const auto lobatto = expansion_witness(named("lobatto_iiib_2"));
    BOOST_REQUIRE(lobatto.has_value());
    BOOST_TEST((lobatto->real == std::vector<rational>{0, -6}));
    // an autonomous field: |y|^3 left of 0 and -y^2 right of it, h = 2, from -3 and from 0
    const auto f = [](double, const auto& y, auto& out) {
        if (y[0] < 0)
            out[0] = -y[0] * y[0] * y[0];
        else
            out[0] = -y[0] * y[0];
    };
    const auto y = rk_step<1>(trapezoidal->method, f, state<double, 1>(-3.0), 2.0);
    BOOST_REQUIRE(y.has_value());
    BOOST_TEST(std::abs((*y)[0] - (std::sqrt(97.0) - 1) / 2) < 1e-12);
    BOOST_TEST(std::abs((*y)[0]) > 3.0);
    BOOST_TEST(!expansion_witness(named("gauss_2")).has_value());
}

BOOST_AUTO_TEST_CASE(
    minus_1e5_x_limits_the_step_of_explicit_methods_at_exactly_2e_5_and_not_of_implicit_euler) {
    // |R(z)| <= 1 for z <= 0: explicit Euler |1 + z|, improved Euler 1 + z + z^2/2, both up to z = -2
    const auto size = [](const char* name, const rational& h) {
        const auto t = named(name);
        const std::vector<rational> z(static_cast<std::size_t>(t.stages()), -100'000 * h),
            none(static_cast<std::size_t>(t.stages()), rational(0));
        return *squared_amplification(t, z, none);
    };
    const rational limit(2, 100'000), more = limit + rational(1, 1'000'000'000);
    for (const char* name : {"explicit_euler", "explicit_midpoint"}) {
        BOOST_TEST((size(name, limit) == quadratic(1)), name);
        BOOST_TEST((quadratic(1) < size(name, more)), name);
        BOOST_TEST((size(name, limit / 2) < quadratic(1)), name);
    }
    for (const int h : {1, 1000, 1'000'000}) BOOST_TEST((size("implicit_euler", h) < quadratic(1)));
}

BOOST_AUTO_TEST_CASE(bemerkung_1_19_contraction_factors_are_proved_and_met) {
    const auto radau_1 = *tableaux::exact_tableau(family::radau_iia, 1);
    for (const rational& l : {rational(-1, 10), rational(-1), rational(-10)}) {
        const double x = l.to<double>();
        const auto euler = contraction(radau_1, l);  // attained by x' = gamma x; 1/sqrt(1 - 2l) is not sharp
        BOOST_TEST(euler.verdict.is_proved());
        BOOST_TEST(std::abs(euler.factor - 1 / (1 - x)) < 1e-6);
        BOOST_TEST(euler.factor >= 1 / (1 - x) - 1e-15);
        BOOST_TEST(euler.factor < 1 / std::sqrt(1 - 2 * x));
        const auto lobatto = contraction(*tableaux::exact_tableau(family::lobatto_iiic, 2), l);
        BOOST_TEST(lobatto.verdict.is_proved());
        BOOST_TEST(std::abs(lobatto.factor - 1 / (1 - x + x * x / 2)) < 1e-5);
        for (const int s : {1, 2}) {
            const auto gauss = contraction(*tableaux::exact_tableau(family::gauss, s), l);
            BOOST_TEST(gauss.verdict.is_proved());
            BOOST_TEST(std::abs(gauss.factor - 1) < 1e-6);
        }
    }
    const auto radau_2 = *tableaux::exact_tableau(family::radau_iia, 2);
    BOOST_TEST(std::abs(contraction(radau_2, -1).factor - 4.0 / 7) < 1e-5);
    BOOST_TEST(std::abs(contraction(radau_2, -10).factor - 4.0 / 25) < 1e-5);
}

BOOST_AUTO_TEST_CASE(bemerkung_1_19_factors_bound_runs_and_exceed_1_for_positive_l) {
    const auto radau_2 = *tableaux::exact_tableau(family::radau_iia, 2);
    const auto doubles = in_doubles(radau_2);
    const auto f = [](const auto&, const auto& x, auto& out) {  // gamma = -1
        out[0] = -x[0] - 7 * x[1] - x[0] * x[0] * x[0];
        out[1] = 7 * x[0] - x[1];
    };
    std::mt19937 random(9);
    std::uniform_real_distribution<double> pick(-2, 2);
    for (const rational& h : {rational(1, 4), rational(1), rational(10)}) {
        const double factor = contraction(radau_2, -h).factor;
        for (int k = 0; k < 200; ++k) {
            const state<double, 2> x(pick(random), pick(random)), y(pick(random), pick(random));
            const auto u = rk_step<2>(doubles, f, x, h.to<double>()),
                       v = rk_step<2>(doubles, f, y, h.to<double>());
            if (u && v) BOOST_TEST((*u - *v).norm() <= factor * (x - y).norm() * (1 + 1e-9));
        }
    }
    const auto euler = contraction(*tableaux::exact_tableau(family::radau_iia, 1), rational(1, 4));
    BOOST_TEST(euler.verdict.is_proved());
    BOOST_TEST(std::abs(euler.factor - 4.0 / 3) < 1e-6);
    BOOST_TEST(contraction(radau_2, rational(1, 4)).factor > 1.0);
    const contraction_bound<rational> nothing;  // claims nothing
    BOOST_TEST((nothing.verdict == verdict::unexamined() && std::isinf(nothing.factor)));
    // beyond l = 1 there is no bound for implicit Euler
    BOOST_TEST(contraction(*tableaux::exact_tableau(family::radau_iia, 1), 2).verdict.is_consistent());
}
