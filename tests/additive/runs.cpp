// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE runs
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <stagecraft/additive.hpp>
#include <stagecraft/coefficients/additive.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/observe/event.hpp>
#include <stagecraft/observe/save_every.hpp>
#include <stagecraft/observe/solution.hpp>
#include <stagecraft/problem/erased.hpp>
#include <stagecraft/relaxation.hpp>
#include <stagecraft/states.hpp>
#include <stagecraft/tableaux/read_method.hpp>
#include <string>
#include <vector>

// Additive methods with step size control, what they cost, and what they refuse. Their orders: orders.cpp.

namespace sc = stagecraft;
using Eigen::MatrixXd, Eigen::VectorXd;

namespace {

sc::additive_method<double> method(const std::string& name) {
    return sc::tableaux::read_additive(STAGECRAFT_SOURCE_DIR "/tableaux/pairs/" + name + ".json");
}

// Two types of problems for all that needs no other.
auto ode(sc::erased_function explicit_part, sc::erased_function implicit_part, sc::erased_jacobian jacobian) {
    return sc::split(std::move(explicit_part), sc::erased_ode(std::move(implicit_part), std::move(jacobian)));
}
auto dae(sc::erased_function explicit_part, sc::erased_function implicit_part, sc::erased_jacobian jacobian,
         const MatrixXd& mass) {
    return sc::split(
        std::move(explicit_part),
        sc::with_index(sc::with_mass(sc::erased_ode(std::move(implicit_part), std::move(jacobian)), mass),
                       std::vector<int>(static_cast<std::size_t>(mass.rows()), 1)));
}

VectorXd vector(std::initializer_list<double> x) {
    return Eigen::Map<const VectorXd>(x.begin(), static_cast<Eigen::Index>(x.size()));
}

// Kaps: y_1 = exp(-2t), y_2 = exp(-t) for every eps.
auto kaps(double eps) {
    return ode([](double, const VectorXd& y, VectorXd& f) { f << -2 * y[0], y[0] - y[1] - y[1] * y[1]; },
               [eps](double, const VectorXd& y, VectorXd& f) { f << (y[1] * y[1] - y[0]) / eps, 0; },
               [eps](double, const VectorXd& y, MatrixXd& J) { J << -1 / eps, 2 * y[1] / eps, 0, 0; });
}
// The same with y_2^2 as a third component, which has no derivative.
auto constrained_kaps(double eps) {
    return dae(
        [](double, const VectorXd& y, VectorXd& f) { f << -2 * y[0], y[0] - y[1] - y[1] * y[1], 0; },
        [eps](double, const VectorXd& y, VectorXd& f) { f << (y[2] - y[0]) / eps, 0, y[2] - y[1] * y[1]; },
        [eps](double, const VectorXd& y, MatrixXd& J) {
            J << -1 / eps, 0, 1 / eps, 0, 0, 0, 0, -2 * y[1], 1;
        },
        MatrixXd(vector({1, 1, 0}).asDiagonal()));
}
/// The error of y in tolerances rtol |y| + atol with rtol = atol.
double in_tolerances(const VectorXd& y, const VectorXd& exact, double tolerance) {
    return ((y - exact).array().abs() / (1 + exact.array().abs())).maxCoeff() / tolerance;
}

std::string refusal(const auto& call) {
    try {
        call();
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
    return "none";
}
void expect(const std::string& said, const std::string& part) {
    BOOST_TEST(said.find(part) != std::string::npos, said);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_tolerance_holds_on_kaps_problem_at_every_stiffness) {
    for (const auto* name : {"ark2", "ark3", "ark4", "ark5", "ark4_2019", "ark5_2019"})
        for (const double tolerance : {1e-4, 1e-6})
            for (const double eps : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
                BOOST_TEST_CONTEXT(name << ", " << tolerance << ", eps " << eps) {
                    const VectorXd exact = vector({std::exp(-2), std::exp(-1)});
                    const auto r = sc::integrate(method(name), kaps(eps), vector({1, 1}), 0, 1,
                                                 {.rtol = tolerance, .atol = tolerance});
                    BOOST_TEST(r.ok());
                    BOOST_TEST(in_tolerances(r.y, exact, tolerance) < 1);
                    BOOST_TEST(r.report.f == r.report.f_explicit + r.report.f_implicit);
                }
}

BOOST_AUTO_TEST_CASE(and_with_an_algebraic_equation_in_the_implicit_part) {
    const double tolerance = 1e-6;
    for (const auto* name : {"ark2", "ark3", "ark4", "ark5", "ark4_2019", "ark5_2019", "ars_4_4_3"})
        for (const double eps : {1e-1, 1e-3, 1e-6}) BOOST_TEST_CONTEXT(name << ", eps " << eps) {
                const VectorXd exact = vector({std::exp(-2), std::exp(-1), std::exp(-2)});
                auto m = method(name);
                if (m.embedded_order == 0) m = sc::step_doubling(m);
                const auto r = sc::integrate(m, constrained_kaps(eps), vector({1, 1, 1}), 0, 1,
                                             {.rtol = tolerance, .atol = tolerance});
                BOOST_TEST(r.ok());
                BOOST_TEST(in_tolerances(r.y, exact, tolerance) < 3);
                BOOST_TEST(std::abs(r.y[2] - r.y[1] * r.y[1]) < tolerance / 10);
            }
}

BOOST_AUTO_TEST_CASE(every_part_is_evaluated_as_often_as_its_stages_say) {
    // name, and evaluations of f_explicit, solved stages and evaluations of f_implicit for a slope in a step
    struct cost {
        int e, solved, slope;
    };
    const std::map<std::string, cost> costs{
        {"ars_1_1_1", {1, 1, 0}},  {"ars_1_2_2", {2, 1, 0}}, {"ars_2_2_2", {2, 2, 0}},
        {"ars_2_3_2", {3, 2, 0}},  {"ars_2_3_3", {3, 2, 0}}, {"ars_3_4_3", {4, 3, 0}},
        {"ars_4_4_3", {4, 4, 0}},  {"bpr_3_5_3", {3, 4, 1}}, {"ssp2_2_2_2", {2, 2, 0}},
        {"ssp3_4_3_3", {3, 4, 0}}, {"ark3", {4, 3, 1}},      {"ark4", {6, 5, 1}}};
    struct linear {  // one Newton iteration a stage
        void operator()(double, const VectorXd& y, VectorXd& f) const { f = -3 * y; }
        void jacobian(double, const VectorXd&, MatrixXd& J) const { J << -3, 0, 0, -3; }
        bool constant_jacobian() const { return true; }
    };
    const auto p =
        sc::split([](double t, const VectorXd& y, VectorXd& f) { f << std::cos(t) * y[1], 1; }, linear{});
    for (const auto& [name, c] : costs) BOOST_TEST_CONTEXT(name) {
            const auto count = [&](int steps) {
                return sc::integrate(method(name), p, vector({1, 1}), 0, 1, {.fixed_step = 1.0 / steps})
                    .report;
            };
            const auto few = count(50), many = count(150);  // the first step iterates twice
            BOOST_TEST(many.f_explicit == 150 * c.e);
            BOOST_TEST(many.f_implicit - few.f_implicit ==
                       100 * (c.solved +
                              (name == "bpr_3_5_3" ? 0 : c.slope)));  // that of the last stage serves again
            BOOST_TEST(many.solves - few.solves == 100 * c.solved);
            BOOST_TEST(many.jacobians == 1);
        }
}

BOOST_AUTO_TEST_CASE(between_the_ends_the_solution_has_order_three) {
    const auto error = [](int steps) {
        sc::solution<VectorXd> u;
        sc::integrate(method("ark4"), kaps(0.5), vector({1, 1}), 0, 1, {.fixed_step = 1.0 / steps}, u);
        double most = 0;
        for (int i = 0; i < steps; ++i)
            for (const double x : {0.2, 0.5, 0.7}) {
                const double t = (i + x) / steps;
                most = std::max(most, (u(t) - vector({std::exp(-2 * t), std::exp(-t)})).norm());
            }
        return most;
    };
    BOOST_TEST(std::abs(std::log2(error(20) / error(40)) - 4) < 0.1);  // what a step adds between its ends
}

BOOST_AUTO_TEST_CASE(events_and_checkpoints_are_those_of_every_method) {
    const auto p = kaps(1e-3);
    const auto fall = sc::event([](double, const VectorXd& y) { return y[1] - 0.5; }, {.terminal = true});
    const auto r = sc::integrate(method("ark4"), p, vector({1, 1}), 0, 2, {.rtol = 1e-8, .atol = 1e-8},
                                 sc::events<VectorXd>(fall));
    BOOST_TEST(sc::name(r.status) == "event");
    BOOST_TEST(std::abs(r.t - std::log(2)) < 1e-6);

    sc::checkpoint<VectorXd> middle;
    const auto whole = sc::integrate(method("ark3"), p, vector({1, 1}), 0, 1, {.rtol = 1e-5, .atol = 1e-5},
                                     sc::save_every(7, [&](auto point) { middle = std::move(point); }));
    const auto rest = sc::integrate(method("ark3"), p, middle, 1);
    BOOST_TEST((middle.t > 0 && middle.t < 1));
    BOOST_TEST((whole.y == rest.y));
    BOOST_TEST(whole.report.f_explicit == rest.report.f_explicit);
    expect(refusal([&] { sc::integrate(method("ark4"), p, middle, 1); }), "checkpoint is of another method");
}

BOOST_AUTO_TEST_CASE(the_parts_may_return_their_values_and_the_state_be_a_number) {
    const auto r = sc::integrate(method("ark4"),
                                 sc::split([](double t, double) { return std::cos(t); },
                                           [](double t, double y) { return -1000 * (y - std::sin(t)); }),
                                 0.0, 0, 1, {.rtol = 1e-8, .atol = 1e-8});
    BOOST_TEST(std::abs(r.y - std::sin(1)) < 2e-8);
}

BOOST_AUTO_TEST_CASE(a_file_of_any_kind_runs_where_the_problem_is_of_its_kind) {
    const std::string folder = STAGECRAFT_SOURCE_DIR "/tableaux/";
    const auto additive = sc::tableaux::read_method(folder + "pairs/ark3.json");
    const auto one = sc::tableaux::read_method(folder + "catalogue/dormand_prince_5_4.json");
    const auto p = kaps(0.1);
    const sc::erased_function f = [](double, const VectorXd& y, VectorXd& out) { out = -y; };
    BOOST_TEST(sc::integrate(additive, p, vector({1, 1}), 0, 1).ok());
    BOOST_TEST(std::abs(sc::integrate(one, f, vector({1, 1}), 0, 1).y[0] - std::exp(-1)) < 1e-5);
    expect(refusal([&] { sc::integrate(additive, f, vector({1, 1}), 0, 1); }), "the method is additive");
    expect(refusal([&] { sc::integrate(one, p, vector({1, 1}), 0, 1); }), "the method is one tableau");
    expect(refusal([&] { sc::tableaux::read_additive(folder + "catalogue/kutta_3.json"); }),
           "is one tableau");
    expect(refusal([&] { sc::tableaux::read_additive(folder + "pairs/ruth_3.json"); }),
           "\"separable\", not \"additive\"");
    expect(refusal([&] { sc::tableaux::read_method(folder + "pairs/ruth_3.json"); }), "read_partitioned");
}

// Ketcheson's oscillator (2019), a half to each part: |y| is an invariant of their sum alone.
auto halves_of_a_circle() {
    return ode([](double, const VectorXd& y, VectorXd& f) { f << -y[1] / y.squaredNorm(), 0; },
               [](double, const VectorXd& y, VectorXd& f) { f << 0, y[0] / y.squaredNorm(); },
               [](double, const VectorXd& y, MatrixXd& J) {
                   const double r = y.squaredNorm();
                   J << 0, 0, (r - 2 * y[0] * y[0]) / (r * r), -2 * y[0] * y[1] / (r * r);
               });
}
// For numbers alone: an invariant. For any numbers: its rate along f counts.
const auto square = [](const VectorXd& y) { return y.squaredNorm(); };
const auto any_square = [](const auto& y) { return y[0] * y[0] + y[1] * y[1]; };
VectorXd on_circle(double t) { return vector({std::cos(t), std::sin(t)}); }

BOOST_AUTO_TEST_CASE(relaxed_additive_methods_keep_an_invariant_of_the_sum_and_their_order) {
    const auto p = halves_of_a_circle();
    for (const char* name : {"ark3", "ark4", "ars_2_2_2", "ars_4_4_3"}) BOOST_TEST_CONTEXT(name) {
            const auto m = method(name);
            double before = 0;
            const double longest = m.order == 3 ? 0.0125 : 0.05;  // where the slope has settled
            for (const double h : {longest, longest / 2}) {
                const sc::options<double> o{.rtol = 1e-12, .fixed_step = h};
                const auto r = sc::integrate(sc::relaxation(m, square), p, on_circle(0), 0, 10, o);
                BOOST_TEST(r.ok());
                BOOST_TEST(r.t == 10);
                BOOST_TEST(std::abs(r.y.squaredNorm() - 1) < 1e-15 * 4);
                const double error = (r.y - on_circle(10)).norm();
                if (before > 0) BOOST_TEST(std::abs(std::log2(before / error) - m.order) < 0.1);
                before = error;
            }
        }
    // Ten thousand steps, every one of them.
    double worst = 0;
    const auto look = [&](double, const VectorXd& y) {
        worst = std::max(worst, std::abs(y.squaredNorm() - 1));
    };
    const sc::options<double> o{.rtol = 1e-10, .fixed_step = 0.1};
    const auto relaxed =
        sc::integrate(sc::relaxation(method("ark4"), square), p, on_circle(0), 0, 1000, o, look);
    BOOST_TEST(relaxed.report.steps == 10000);
    BOOST_TEST(worst < 2e-15);
    const auto plain = sc::integrate(method("ark4"), p, on_circle(0), 0, 1000, o);
    BOOST_TEST(std::abs(plain.y.squaredNorm() - 1) > 1e-6);
    const auto error = [](const auto& r) { return (r.y - on_circle(1000)).norm(); };
    BOOST_TEST(error(relaxed) < error(plain));
}

BOOST_AUTO_TEST_CASE(a_dissipated_quantity_falls_with_relaxed_additive_methods_as_f_lets_it) {
    // y' = -|y|^2 y in two halves: y = y0 / sqrt(1 + 2 t |y0|^2).
    const auto half = [](double, const VectorXd& y, VectorXd& f) { f = -y.squaredNorm() / 2 * y; };
    const auto p = ode(half, half, [](double, const VectorXd& y, MatrixXd& J) {
        J = -y.squaredNorm() / 2 * MatrixXd::Identity(2, 2) - y * y.transpose();
    });
    for (const char* name : {"ark3", "ars_2_2_2"}) BOOST_TEST_CONTEXT(name) {
            const auto m = method(name);
            double before = 0;
            for (const double h : {0.1, 0.05, 0.025}) {
                double last = 1;
                const auto falls = [&](double, const VectorXd& y) {
                    BOOST_TEST(any_square(y) < last);
                    last = any_square(y);
                };
                const sc::options<double> o{.rtol = 1e-12, .fixed_step = h};
                const auto r =
                    sc::integrate(sc::relaxation(m, any_square), p, vector({1, 0}), 0, 3, o, falls);
                BOOST_TEST(r.ok());
                const double error = std::abs(r.y[0] - 1 / std::sqrt(7));
                if (before > 0) BOOST_TEST(std::abs(std::log2(before / error) - m.order) < 0.3);
                before = error;
            }
        }
}

BOOST_AUTO_TEST_CASE(relaxed_additive_methods_choose_their_steps_go_on_and_refuse) {
    const auto p = halves_of_a_circle();
    const auto m = sc::relaxation(method("ark4"), square);
    const sc::options<double> o{.rtol = 1e-7, .atol = 1e-7};
    sc::solution<VectorXd> y;
    const auto whole = sc::integrate(m, p, on_circle(0), 0, 20, o, y);
    BOOST_TEST(whole.t == 20);
    BOOST_TEST(std::abs(whole.y.squaredNorm() - 1) < 4e-15);
    BOOST_TEST((whole.y - on_circle(20)).norm() < 1e-5);
    for (const double t : {0.01, 3.3, 19.9}) BOOST_TEST((y(t) - on_circle(t)).norm() < 1e-4);
    sc::checkpoint<VectorXd> middle;
    sc::integrate(m, p, on_circle(0), 0, 20, o, sc::save_every(5, [&](auto point) {
                      if (middle.y.size() == 0) middle = std::move(point);
                  }));
    const auto rest = sc::integrate(m, p, middle, 20);
    BOOST_TEST((rest.y - whole.y).norm() == 0);
    BOOST_TEST(rest.report.f_explicit == whole.report.f_explicit);
    // Stiff: the fast component follows, the quantity that the other two keep is kept.
    const auto stiff = ode(
        [](double, const VectorXd& x, VectorXd& f) { f << -x[1], 0, x[0] * x[0] - x[1] * x[1]; },
        [](double, const VectorXd& x, VectorXd& f) { f << 0, x[0], 1e6 * (x[0] * x[1] - x[2]); },
        [](double, const VectorXd& x, MatrixXd& J) { J << 0, 0, 0, 1, 0, 0, 1e6 * x[1], 1e6 * x[0], -1e6; });
    const auto of_two = [](const VectorXd& x) { return x[0] * x[0] + x[1] * x[1]; };
    const auto r = sc::integrate(sc::relaxation(method("ark4"), of_two), stiff, vector({1, 0, 0}), 0, 10, o);
    BOOST_TEST(r.ok());
    BOOST_TEST(std::abs(of_two(r.y) - 1) < 4e-15);
    BOOST_TEST(std::abs(r.y[2] - std::cos(10) * std::sin(10)) < 1e-5);
    const auto unrelaxed = sc::integrate(method("ark4"), stiff, vector({1, 0, 0}), 0, 10, o);
    BOOST_TEST(std::abs(of_two(unrelaxed.y) - 1) > 1e-13);
    BOOST_TEST(r.report.steps < 1.1 * unrelaxed.report.steps);

    const auto never = [](const VectorXd&) { return std::numeric_limits<double>::quiet_NaN(); };
    expect(refusal([&] { sc::integrate(sc::relaxation(method("ark4"), never), p, on_circle(0), 0, 1); }),
           "eta must be finite at y0");
    const auto third = [](const VectorXd& x) { return x[0]; };
    expect(refusal([&] {
               sc::integrate(sc::relaxation(method("ark4"), third), constrained_kaps(0.1), vector({1, 1, 1}),
                             0, 1);
           }),
           "without a mass matrix");
}

BOOST_AUTO_TEST_CASE(generated_headers_hold_the_files_to_the_last_bit) {
    const auto same = [](const auto& generated, const std::string& name) {
        const auto read = method(name);
        const auto equal = [](const auto& a, const auto& b) {
            return (a.A == b.A) && (a.b == b.b) && (a.c == b.c) &&
                   a.b_embedded.size() == b.b_embedded.size() &&
                   (a.b_embedded.size() == 0 || a.b_embedded == b.b_embedded);
        };
        BOOST_TEST_CONTEXT(name) {
            BOOST_TEST(equal(generated.explicit_part, read.explicit_part));
            BOOST_TEST(equal(generated.implicit_part, read.implicit_part));
            BOOST_TEST(generated.order == read.order);
            BOOST_TEST(generated.embedded_order == read.embedded_order);
        }
    };
    same(sc::ark4(), "ark4");
    same(sc::ars_2_2_2(), "ars_2_2_2");
    same(sc::bhr_5_5_3(), "bhr_5_5_3");
    same(sc::ark4_2019(), "ark4_2019");
    same(sc::ark5_2019(), "ark5_2019");
    BOOST_TEST((sc::ark4<float>().implicit_part.b == sc::ark4().implicit_part.b.cast<float>()));
    BOOST_TEST(sc::integrate(sc::ark4(), kaps(0.1), vector({1, 1}), 0, 1).ok());
}

BOOST_AUTO_TEST_CASE(what_does_not_fit_is_said_in_a_sentence) {
    const auto m = method("ark3");
    const auto& e = m.explicit_part;
    const auto& i = m.implicit_part;
    expect(refusal([&] { sc::additive(i, e); }), "explicit_part.A must be strictly lower triangular");
    expect(refusal([&] { sc::additive(e, sc::radau_iia<4>()); }), "implicit_part.A must be lower triangular");
    expect(refusal([&] { sc::additive(e, method("ark4").implicit_part); }), "the same number of stages");
    auto plain = i;
    plain.b_embedded.resize(0);
    expect(refusal([&] { sc::additive(e, plain); }), "b_embedded must be given in both parts or in neither");
    const VectorXd one = vector({1, 1});
    expect(refusal([&] { sc::integrate(method("ars_2_2_2"), kaps(1), one, 0, 1); }), "has no b_embedded");
    BOOST_TEST(sc::integrate(sc::step_doubling(method("ars_2_2_2")), kaps(1e-4), one, 0, 1).ok());

    // M singular: a method that cannot, and an explicit part where there is no derivative, at the start and later.
    const VectorXd start = vector({1, 1, 1});
    expect(refusal([&] {
               sc::integrate(method("ars_2_3_3"), constrained_kaps(1), start, 0, 1, {.fixed_step = 0.1});
           }),
           "problem.mass() is singular, which the additive method cannot serve");
    auto early = constrained_kaps(1), late = constrained_kaps(1);
    early.f_explicit = [](double, const VectorXd&, VectorXd& f) { f << 0, 0, 1; };
    late.f_explicit = [](double t, const VectorXd& y, VectorXd& f) {
        f << -2 * y[0], y[0] - y[1] - y[1] * y[1], t < 0.5 ? 0 : 1;
    };
    expect(refusal([&] { sc::integrate(m, early, start, 0, 1); }),
           "equation 2 (counted from 0) belongs to f_implicit");
    const auto r = sc::integrate(m, late, start, 0, 1);
    BOOST_TEST(sc::name(r.status) == "function_threw");
    BOOST_TEST((r.t > 0.1 && r.t < 0.5));
    BOOST_TEST(std::abs(r.y[1] - std::exp(-r.t)) < 1e-4);
    // sizes
    auto longer = kaps(1);
    longer.f_explicit = [](double, const VectorXd&, VectorXd& f) { f = VectorXd::Zero(3); };
    BOOST_TEST(sc::name(sc::integrate(m, longer, one, 0, 1).status) == "size_changed");
}
