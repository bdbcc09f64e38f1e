// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE right_hand_sides
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <stagecraft/integrate.hpp>
#include <stagecraft/linear/banded_blocks.hpp>
#include <stagecraft/tableaux/rounded.hpp>
#include <stdexcept>

// Right-hand sides and Jacobians that are not what the theory assumes: discontinuous, non-finite from some
// time on, throwing, resizing. With every family of transformed methods.

namespace sc = stagecraft;
using sc::tableaux::family;
using enum sc::tableaux::family;
using V = Eigen::VectorXd;

namespace {

using method = sc::transformed_tableau<double>;
// Of one type, as an integrator is compiled for every type of right-hand side.
using rhs = std::function<void(double, const V&, V&)>;

std::vector<method> methods() {
    std::vector<method> list;
    for (const auto& [f, s] :
         {std::pair{radau_iia, 1}, std::pair{radau_iia, 3}, std::pair{radau_iia, 4}, std::pair{gauss, 2},
          std::pair{gauss, 3}, std::pair{radau_ia, 3}, std::pair{lobatto_iiic, 3}})
        list.push_back(sc::tableaux::transformed<double>(f, s));
    return list;
}

const V start = Eigen::Vector2d(1, 2);

/// y' = -y until t = 1, then `after`, which may do anything.
struct until_one {
    std::function<void(V&)> after;
    void operator()(double t, const V& y, V& f) const {
        f = -y;
        if (t > 1) after(f);
    }
};

// Methods with c_s < 1 as well: f is asked for at the end of a step before it is accepted.
template <class Result>
void is_good_up_to_one(const Result& r, double bound = 2e-3) {
    BOOST_TEST(!r.ok());
    BOOST_TEST(r.t <= 1);
    BOOST_TEST(r.y.size() == 2);
    BOOST_TEST(std::abs(r.y[1] - 2 * std::exp(-r.t)) < bound);
}

}  // namespace

BOOST_AUTO_TEST_CASE(nan_and_infinity_from_some_time_on_keep_the_last_good_state) {
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();
    for (const auto& m : methods())
        for (const double bad : {nan, inf, -inf})
            for (const double step : {0.0, 0.07}) {
                const until_one one{[bad](V& f) { f[1] = bad; }};
                const auto r =
                    sc::integrate(m, one, start, 0, 2, {.rtol = 1e-4, .atol = 1e-4, .fixed_step = step});
                is_good_up_to_one(r, m.stages() == 1 ? 5e-2 : 2e-3);
                BOOST_TEST(sc::name(r.status) == "non_finite");
                BOOST_TEST(r.t > 0.85);
            }
}

BOOST_AUTO_TEST_CASE(a_right_hand_side_that_becomes_enormous_is_no_success) {
    for (const auto& m : methods()) {
        const until_one one{[](V& f) { f *= -1e305; }};
        const auto r = sc::integrate(m, one, start, 0, 2, {.rtol = 1e-4, .atol = 1e-4});
        BOOST_TEST(!r.ok());
        BOOST_TEST(r.y.allFinite());
    }
}

BOOST_AUTO_TEST_CASE(a_jacobian_that_is_not_finite_is_a_status) {
    struct problem {
        double from;
        void operator()(double, const V& y, V& f) const { f = -y; }
        void jacobian(double t, const V&, Eigen::MatrixXd& J) const {
            J = -Eigen::MatrixXd::Identity(2, 2);
            if (t >= from) J(0, 1) = std::nan("");
        }
    };
    for (const auto& m : methods()) {
        const auto r = sc::integrate(m, problem{0}, start, 0, 2);
        BOOST_TEST(!r.ok());
        BOOST_TEST(r.t == 0);
        BOOST_TEST((r.y == start));
    }
}

BOOST_AUTO_TEST_CASE(what_is_thrown_ends_the_run_with_the_last_good_state) {
    for (const auto& m : methods()) {
        const until_one one{[](V&) { throw std::domain_error("beyond the table"); }};
        const auto r = sc::integrate(m, one, start, 0, 2, {.rtol = 1e-4, .atol = 1e-4});
        is_good_up_to_one(r);
        BOOST_TEST(sc::name(r.status) == "function_threw");
        BOOST_CHECK_THROW(std::rethrow_exception(r.exception), std::domain_error);
        // Not only exceptions of the standard library.
        const until_one seven{[](V&) { throw 7; }};
        const auto q = sc::integrate(m, seven, start, 0, 2, {.rtol = 1e-4, .atol = 1e-4});
        is_good_up_to_one(q);
        BOOST_CHECK_THROW(std::rethrow_exception(q.exception), int);
    }
}

BOOST_AUTO_TEST_CASE(an_output_that_changes_size_is_a_status) {
    for (const auto& m : methods())
        for (const int size : {0, 1, 3, 50}) {
            const until_one one{[size](V& f) { f = V::Ones(size); }};
            const auto r = sc::integrate(m, one, start, 0, 2, {.rtol = 1e-4, .atol = 1e-4});
            is_good_up_to_one(r);
            BOOST_TEST(sc::name(r.status) == "size_changed");
        }
}

BOOST_AUTO_TEST_CASE(a_jacobian_that_changes_size_is_a_status) {
    struct problem {
        void operator()(double, const V& y, V& f) const { f = -y; }
        void jacobian(double t, const V&, Eigen::MatrixXd& J) const {
            J = -Eigen::MatrixXd::Identity(t > 0 ? 3 : 2, 2);
        }
    };
    const auto r = sc::integrate(methods()[1], problem{}, start, 0, 100, {.rtol = 1e-6, .atol = 1e-6});
    BOOST_TEST((r.ok() || sc::name(r.status) == std::string("size_changed")));
    struct never : problem {
        void jacobian(double, const V&, Eigen::MatrixXd& J) const { J.resize(3, 3); }
    };
    BOOST_TEST(sc::name(sc::integrate(methods()[1], never{}, start, 0, 1).status) == "size_changed");
}

// Jumps of f. Across one every method is of order 1, and an estimate of order q no longer stands for an error
// of order p + 1: the step control notices, with all families, wherever the jump falls, beside oscillations
// or none. A jump beyond the last node of a method (Gauss, Radau IA) is in no stage value; the estimate at
// the right end finds it. The bound: three jumps, each of one tolerance in the norm, which is 2 (1 + 4.5) tol
// in a single one of four components as large as 4.5, grown by e^{t1 - back} < 3 on the way. Radau IA, whose
// estimate is of order s only, is held to the bound of that, rtol^{s/2s}.
BOOST_AUTO_TEST_CASE(discontinuous_right_hand_sides_are_solved_to_the_tolerance) {
    std::vector<method> list = methods();
    for (const auto& [f, s] : {std::pair{radau_iia, 5}, std::pair{radau_iia, 7}, std::pair{gauss, 4},
                               std::pair{gauss, 5}, std::pair{lobatto_iiic, 4}})
        list.push_back(sc::tableaux::transformed<double>(f, s));
    for (const double frequency : {0.0, 20.0})
        for (const double shift : {0.0, 0.013, 0.1, 0.237}) {
            const double jump = 2 + shift, back = jump + (jump - 1.5) / 2, t1 = 1.5 * jump;
            const rhs sawtooth = [&](double t, const V& y, V& f) {
                f[0] = t < jump ? 1 : -2;
                f[1] = y[0] > 1.5 ? -y[1] : y[1];  // y0 passes 1.5 upwards at t = 1.5, downwards at `back`
                f[2] = frequency * y[3];
                f[3] = -frequency * y[2];
            };
            const double y1 = std::exp(1.5 - (back - 1.5) + (t1 - back));
            for (const auto& m : list)
                for (const double tol : {1e-3, 1e-5, 1e-7, 1e-9}) {
                    if (m.stages() == 1 && tol < 1e-4) continue;
                    const auto r = sc::integrate(m, sawtooth, V(Eigen::Vector4d(0, 1, 1, 0)), 0, t1,
                                                 {.rtol = tol, .atol = tol});
                    const bool by_jump = m.c[0] == 0 && m.c[m.stages() - 1] < 1;  // Radau IA
                    const double bound = 100 * (by_jump ? std::sqrt(tol) : tol);
                    BOOST_TEST_CONTEXT("s = " << m.stages() << " c_1 = " << m.c[0] << " tol = " << tol
                                              << " shift = " << shift << " steps " << r.report.steps) {
                        BOOST_TEST(sc::name(r.status) == "success");
                        BOOST_TEST(std::abs(r.y[0]) < bound);
                        BOOST_TEST(std::abs(r.y[1] / y1 - 1) < bound);
                        BOOST_TEST(r.report.rejected_error > 0);
                    }
                }
        }
}

// Runs often begin exactly where f jumps: a block at rest with dry friction, a thermostat at its limit. Differences of f
// across the jump must not be taken for a Jacobian, which would be the jump over 1e-14.
struct block_at_rest {
    std::function<double(double)> friction;
    void operator()(double, const V& y, V& f) const {
        f[0] = y[1];
        f[1] = -y[0] - friction(y[1]);
    }
};
struct banded_block_at_rest : block_at_rest {
    sc::bandwidth bandwidth() const { return {1, 1}; }
};
BOOST_AUTO_TEST_CASE(runs_that_begin_where_f_jumps_are_solved_to_the_tolerance) {
    const auto sign = [](double v) { return v > 0 ? 0.1 : v < 0 ? -0.1 : 0.0; };
    const auto right = [](double v) { return v >= 0 ? 0.1 : -0.1; };
    const auto left = [](double v) { return v > 0 ? 0.1 : -0.1; };
    const auto check = [](const auto& m, const auto& block, double tol) {
        // Until t = pi: x = 0.1 + 0.9 cos t.
        const auto r = sc::integrate(m, block, V(Eigen::Vector2d(1, 0)), 0, 3, {.rtol = tol, .atol = tol});
        BOOST_TEST_CONTEXT("s = " << m.stages() << " c_1 = " << m.c[0] << " tol = " << tol) {
            BOOST_TEST(sc::name(r.status) == "success");
            BOOST_TEST(std::abs(r.y[0] - 0.1 - 0.9 * std::cos(3.0)) < 10 * tol);
            BOOST_TEST(std::abs(r.y[1] + 0.9 * std::sin(3.0)) < 10 * tol);
        }
    };
    for (const auto& m : methods())
        for (const double tol : {1e-4, 1e-6, 1e-8})
            for (const std::function<double(double)>& friction :
                 {std::function<double(double)>(sign), std::function<double(double)>(right),
                  std::function<double(double)>(left)}) {
                if (m.stages() == 1) continue;  // the error of an order of one, not of the jump
                check(m, block_at_rest{friction}, tol);
                check(m, banded_block_at_rest{{friction}}, tol);
            }
    // A thermostat that cools from its limit: y' = 15 - y below 20 and from there on (or above), 30 - y else.
    for (const bool inclusive : {false, true})
        for (const auto& m : methods()) {
            if (m.stages() == 1) continue;
            const rhs heating = [=](double, const V& y, V& f) {
                const bool on = inclusive ? y[0] <= 20 : y[0] < 20;
                f[0] = on ? 15 - y[0] : 30 - y[0];
            };
            const double outside = inclusive ? 15 : 30;
            const auto r =
                sc::integrate(m, heating, V(V::Constant(1, 20)), 0, 1, {.rtol = 1e-6, .atol = 1e-6});
            BOOST_TEST(sc::name(r.status) == "success");
            BOOST_TEST(std::abs(r.y[0] - outside - (20 - outside) * std::exp(-1.0)) < 1e-5 * 21);
        }
}

namespace {

/// M y' = f with a singular M, of one type for all problems.
struct constrained {
    rhs f;
    Eigen::MatrixXd M;
    std::vector<int> of_index;
    void operator()(double t, const V& y, V& out) const { f(t, y, out); }
    const Eigen::MatrixXd& mass() const { return M; }
    const std::vector<int>& index() const { return of_index; }
};

/// y' = z, 0 = z - k max(0, t - 1/2 - z): z = k / (1 + k) (t - 1/2) from t = 1/2 on. Across the kink an iteration with the
/// Jacobian of the left side multiplies its error by -k, whatever h is.
constrained kinked(double k) {
    return {[k](double t, const V& y, V& f) { f << y[1], k * std::max(0.0, t - 0.5 - y[1]) - y[1]; },
            Eigen::Vector2d(1, 0).asDiagonal(),
            {1, 1}};
}

// A MOS transistor that is driven through the kinks of its charges (problem pump of the test set for initial value problems), in ns, pC and V, for the first of its ten pulses.
namespace pump {

constexpr double vt0 = 0.2, gamma = 0.035, phi = 1.01, cox = 4, cs = 1.6, cd = 0.4;
const double flat = vt0 - gamma * std::sqrt(phi) - phi;

double pulse(double t) { return t < 50 ? 0 : t < 60 ? 2 * (t - 50) : t < 110 ? 20 : 2 * (120 - t); }
/// Charges of the gate and of the source.
std::pair<double, double> charges(double gb, double gs, double gd) {
    const double big = std::max(gs, gd), small = std::min(gs, gd), root = std::sqrt(phi - (big - gb)),
                 threshold = vt0 + gamma * (root - std::sqrt(phi));
    if (gb <= flat) return {cox * (gb - flat), 0};
    if (big <= threshold) return {cox * gamma * (std::sqrt(gamma * gamma / 4 + gb - flat) - gamma / 2), 0};
    const double a = big - threshold, b = std::max(0.0, small - threshold), h = a + b - a * b / (a + b);
    return {cox * (2 * h / 3 + gamma * root), -cox * h / 3};
}
constrained problem() {
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(9, 9);
    M(0, 0) = M(1, 1) = M(1, 2) = M(2, 3) = M(2, 4) = 1;
    const rhs f = [](double t, const V& y, V& out) {
        const auto [gate, source] = charges(y[5], y[5] - y[6], y[5] - y[7]);
        out << -y[8], 0, 0, pulse(t) - y[5], y[0] - gate, y[1] - cs * y[6], y[2] - source, y[3] - cd * y[7],
            y[4] - source;
    };
    return {f, M, {1, 1, 1, 1, 1, 1, 1, 1, 2}};
}

}  // namespace pump
}  // namespace

BOOST_AUTO_TEST_CASE(a_kink_in_an_algebraic_equation_is_passed_whatever_the_slopes) {
    const auto method = sc::tableaux::transformed<double>(radau_iia, 3);
    for (const double k : {1.5, 3.0, 30.0, 1e4}) {
        const V right = k / (1 + k) * Eigen::Vector2d(1 / 8., 1 / 2.), zero = V::Zero(2);
        for (const double tol : {1e-3, 1e-6, 1e-9}) {
            const auto r = sc::integrate(method, kinked(k), zero, 0.0, 1.0, {.rtol = tol, .atol = tol});
            BOOST_TEST(r.ok());
            BOOST_TEST((r.y - right).lpNorm<Eigen::Infinity>() < 5 * tol);
            BOOST_TEST(r.report.steps < 60);
        }
        // Equal steps cannot be shorter; z is right wherever one ends.
        const auto r = sc::integrate(method, kinked(k), zero, 0.0, 1.0, {.fixed_step = 0.07});
        BOOST_TEST(r.ok());
        BOOST_TEST(std::abs(r.y[1] - right[1]) < 1e-8);
    }
}

// Nodes at t1 would ask f there, where it may have begun its next period: here its equation has no solution then.
BOOST_AUTO_TEST_CASE(f_that_jumps_at_the_very_end_is_told_a_time_before_it) {
    for (const double end : {1.0, -1.0}) {
        const constrained jumps{[end](double t, const V& y, V& f) {
                                    f << y[1], std::abs(t) < std::abs(end) ? y[1] - end : y[1] * y[1] + 1;
                                },
                                Eigen::Vector2d(1, 0).asDiagonal(),
                                {1, 1}};
        for (const family f : {radau_iia, lobatto_iiic})
            for (const double step : {0.0, 0.1}) {
                const auto r =
                    sc::integrate(sc::tableaux::transformed<double>(f, 3), jumps, V(Eigen::Vector2d(0, end)),
                                  0.0, end, {.rtol = 1e-6, .atol = 1e-6, .fixed_step = step});
                BOOST_TEST(r.ok());
                BOOST_TEST(r.t == end);
                BOOST_TEST((r.y - Eigen::Vector2d(1, end)).lpNorm<Eigen::Infinity>() < 1e-12);
            }
    }
}

BOOST_AUTO_TEST_CASE(a_transistor_passes_the_kinks_of_its_charges) {
    V y0 = V::Zero(9);
    y0[0] = pump::charges(0, 0, 0).first;
    const auto method = sc::tableaux::transformed<double>(radau_iia, 3);
    for (const double tol : {1e-3, 1e-5, 1e-7, 1e-9}) {
        const auto r = sc::integrate(method, pump::problem(), y0, 0.0, 85.0,
                                     {.rtol = tol, .atol = tol, .break_points = {50.0, 60.0}});
        BOOST_TEST(r.ok());
        // On top of the pulse nothing flows; the charges are those of the voltages, of which the source's and the drain's
        // follow from what the transistor has taken from either.
        const auto [gate, source] = pump::charges(20, 20 - r.y[6], 20 - r.y[7]);
        BOOST_TEST(std::abs(r.y[5] - 20) < 10 * tol * 20);
        BOOST_TEST(std::abs(r.y[0] - gate) < 10 * tol * gate);
        BOOST_TEST(std::abs(r.y[2] - source) < 10 * tol * gate);
        BOOST_TEST(std::abs(pump::cs * r.y[6] + source) < 10 * tol * gate);
        BOOST_TEST(std::abs(pump::cd * r.y[7] + source) < 10 * tol * gate);
        BOOST_TEST(r.report.steps < 300);
    }
}

// y' = -sign y has no solution beyond y = 0 in the classical sense (it slides): no success with another
// answer than 0.
BOOST_AUTO_TEST_CASE(sliding_on_a_discontinuity_ends_at_zero_or_in_a_status) {
    const rhs slide = [](double, const V& y, V& f) {
        for (int i = 0; i < 2; ++i) f[i] = y[i] > 0 ? -1 : y[i] < 0 ? 1 : 0;
    };
    for (const auto& m : methods()) {
        const auto r = sc::integrate(m, slide, start, 0, 3, {.rtol = 1e-4, .atol = 1e-4, .max_steps = 20000});
        BOOST_TEST(r.y.allFinite());
        if (r.ok()) BOOST_TEST(r.y.lpNorm<Eigen::Infinity>() < 1e-2);
        if (!r.ok()) BOOST_TEST(std::abs(r.y[1] - std::max(0.0, 2 - r.t)) < 1e-2);
    }
}

// Square roots and powers: f leaves its domain if a stage does.
BOOST_AUTO_TEST_CASE(a_solution_at_the_edge_of_the_domain_is_right_or_no_success) {
    const rhs torricelli = [](double, const V& y, V& f) {  // the tank is empty at t = 2
        f[0] = -std::sqrt(y[0]);
        f[1] = 0;
    };
    for (const auto& m : methods()) {
        const auto before = sc::integrate(m, torricelli, start, 0, 1.9, {.rtol = 1e-4, .atol = 1e-4});
        BOOST_TEST(before.ok());
        BOOST_TEST(std::abs(before.y[0] - 0.05 * 0.05) < 2e-3);
        const auto after = sc::integrate(m, torricelli, start, 0, 3, {.rtol = 1e-4, .atol = 1e-4});
        BOOST_TEST(after.y.allFinite());
        BOOST_TEST((after.ok() ? std::abs(after.y[0]) < 1e-2 : after.t < 2.1));
    }
}
