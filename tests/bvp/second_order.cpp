// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE bvp_second_order
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/coefficients/gauss.hpp>

namespace sc = stagecraft;
using Eigen::Vector2d;
using std::numbers::pi;

namespace {

// eps u'' = u - (1 + eps pi^2) cos(pi t), u(-1) = u(1) = -1, so u = cos(pi t): modes e^{+-t/sqrt(eps)} that the solution
// does not have (number 11 of Cash's test set).
struct fast_modes {
    double eps;
    void operator()(double t, const Vector2d& y, Vector2d& f) const {
        f = Vector2d(y[1], (y[0] - (1 + eps * pi * pi) * std::cos(pi * t)) / eps);
    }
};
struct of_second_order : fast_modes {
    static constexpr int second_order_components = 1;
};
// The same in the order (v, q), which is not of that form.
struct velocities_first : fast_modes {
    void operator()(double t, const Vector2d& y, Vector2d& f) const {
        fast_modes::operator()(t, Vector2d(y[1], y[0]), f);
        std::swap(f[0], f[1]);
    }
};
// Not of that form, though its Jacobian is: q' = v + 1.
struct not_of_second_order : of_second_order {
    void operator()(double t, const Vector2d& y, Vector2d& f) const {
        of_second_order::operator()(t, y, f);
        f[0] += 1;
    }
};
// eps u'' = t u' + u + c with the same solution: kappa is 0.9/eps, layers at both ends, which the mesh has to resolve for
// M alone (number 5).
struct turning_point {
    static constexpr int second_order_components = 1;
    double eps;
    void operator()(double t, const Vector2d& y, Vector2d& f) const {
        const double c = t * pi * std::sin(pi * t) - (1 + eps * pi * pi) * std::cos(pi * t);
        f = Vector2d(y[1], (t * y[1] + y[0] + c) / eps);
    }
    template <class J>
    void jacobian(double t, const Vector2d&, J& j) const {
        j << 0, 1, 1 / eps, t / eps;
    }
};
struct ends {
    void operator()(const Vector2d& a, const Vector2d& b, Vector2d& r) const {
        r = Vector2d(a[0] + 1, b[0] + 1);
    }
};

template <class Problem>
auto solve(double eps, const sc::bvp_options<double>& o) {
    return sc::solve_bvp(sc::gauss<5>(), sc::two_point(Problem{{eps}}, ends{}), -1.0, 1.0, Vector2d(0, 0), o);
}
auto solve_first_order(double eps, const sc::bvp_options<double>& o) {
    const auto r = [](const Vector2d& a, const Vector2d& b, Vector2d& out) {
        out = Vector2d(a[1] + 1, b[1] + 1);
    };
    return sc::solve_bvp(sc::gauss<5>(), sc::two_point(velocities_first{{eps}}, r), -1.0, 1.0, Vector2d(0, 0),
                         o);
}

double error_at(const auto& y, double t) {
    const Vector2d exact(std::cos(pi * t), -pi * std::sin(pi * t));
    return ((y(t) - exact).array().abs() / (1 + exact.array().abs())).maxCoeff();
}
double error_of(const auto& y) {
    double worst = 0;
    for (int k = 0; k <= 1000; ++k) worst = std::max(worst, error_at(y, -1 + k / 500.0));
    return worst;
}

}  // namespace

BOOST_AUTO_TEST_CASE(fast_modes_that_a_smooth_solution_does_not_have_ask_for_no_mesh) {
    for (const double eps : {1e-4, 1e-6, 1e-8}) BOOST_TEST_CONTEXT("eps " << eps) {
            const auto answer = solve<of_second_order>(eps, {.rtol = 1e-7});
            BOOST_TEST(answer.ok());
            const double error = error_of(answer.y);
            BOOST_TEST(error <= 1e-7);
            BOOST_TEST(answer.error.global <= 10 * error);
            BOOST_TEST(answer.report.intervals <= 25);
            // What has the slope of y as polynomial of degree s - 1 needs more than that.
            BOOST_TEST(solve_first_order(eps, {.rtol = 1e-7}).report.intervals >= 40);
        }
}

// kappa times the tolerance is above 1: of a nonlinear problem more meshes would have to be solved on to show that M is
// regular. Where fast modes are not resolved, the Jacobians on the mesh halved show it, for as many evaluations of f and one
// factorisation.
BOOST_AUTO_TEST_CASE(ill_conditioned_linear_problems_take_one_step_on_a_mesh) {
    const auto both = [](const auto& a, const auto& b, auto& r) {
        r[0] = a[0] + 1;
        r[1] = b[0] + 1;
    };
    for (const double eps : {1e-4, 1e-6, 1e-8})
        for (const double rtol : {1e-4, 1e-6}) BOOST_TEST_CONTEXT("eps " << eps << ", rtol " << rtol) {
                const auto answer = sc::solve_bvp(sc::gauss<7>(), sc::two_point(turning_point{eps}, both),
                                                  -1.0, 1.0, Vector2d(0, 0), {.rtol = rtol});
                BOOST_TEST(answer.ok());
                BOOST_TEST(error_of(answer.y) <= rtol);
                BOOST_TEST(answer.report.meshes == 1);
                BOOST_TEST(answer.report.newton_steps == 1);
                BOOST_TEST(answer.report.factorisations <= 2);
                BOOST_TEST(answer.report.intervals == 10);
                BOOST_TEST(answer.report.f <= 400);
            }
}

// With eps = 1 nothing is fast: order 2 s = 10 at mesh points, s + 3 = 8 between them.
BOOST_AUTO_TEST_CASE(orders_at_mesh_points_and_between_them) {
    double at[2], between[2];
    for (const int k : {0, 1}) {
        const auto answer =
            solve<of_second_order>(1, {.rtol = 1e-12, .intervals = k == 0 ? 3 : 6, .adapt = false});
        at[k] = std::max(error_at(answer.y, -1 + 2 / 3.0), error_at(answer.y, -1 + 4 / 3.0));
        between[k] = error_of(answer.y);
    }
    BOOST_TEST(std::abs(std::log2(at[0] / at[1]) - 10) < 0.3);
    BOOST_TEST(std::log2(between[0] / between[1]) > 7.5);
}

// What nobody has declared is seen: one evaluation of f more, and the same numbers.
BOOST_AUTO_TEST_CASE(a_system_of_second_order_is_recognised) {
    for (const double eps : {1.0, 1e-4, 1e-8}) {
        const auto declared = solve<of_second_order>(eps, {.rtol = 1e-8}),
                   seen = sc::solve_bvp(sc::gauss<5>(), sc::two_point(fast_modes{eps}, ends{}), -1.0, 1.0,
                                        Vector2d(0, 0), {.rtol = 1e-8});
        BOOST_TEST(seen.ok());
        BOOST_TEST(seen.report.f == declared.report.f + 1);
        BOOST_TEST((seen.mesh == declared.mesh));
        for (const double t : {-0.7, 0.1, 0.9}) BOOST_TEST((seen.y(t) == declared.y(t)));
    }
}

// u''' = -u, u = exp(-t), at fixed and at run-time size: u' = v is the one equation of that form.
BOOST_AUTO_TEST_CASE(one_equation_of_three_is_recognised) {
    const auto f = [](const auto&, const auto& y, auto& out) {
        out[0] = y[1], out[1] = y[2], out[2] = -y[0];
    };
    const auto r = [](const auto& a, const auto& b, auto& out) {
        out[0] = a[0] - 1, out[1] = a[1] + 1, out[2] = b[0] - std::exp(-2.0);
    };
    const auto error = [](const auto& answer) {
        double worst = 0;
        for (int k = 0; k <= 200; ++k)
            for (int c = 0; c < 3; ++c)
                worst = std::max(worst,
                                 std::abs(answer.y(k / 100.0)[c] - (c == 1 ? -1 : 1) * std::exp(-k / 100.0)));
        return worst;
    };
    const auto fixed = sc::solve_bvp(sc::gauss<3>(), sc::two_point(f, r), 0.0, 2.0, Eigen::Vector3d(0, 0, 0),
                                     {.rtol = 1e-9}),
               three = sc::solve_bvp(sc::gauss<3>(), sc::two_point(f, r), 0.0, 2.0, Eigen::Vector3d(1, -1, 1),
                                     {.rtol = 1e-9});
    const auto dynamic = sc::solve_bvp(sc::gauss<3>(), sc::two_point(f, r), 0.0, 2.0,
                                       Eigen::VectorXd(Eigen::Vector3d(0, 0, 0)), {.rtol = 1e-9});
    BOOST_TEST((fixed.ok() && three.ok() && dynamic.ok()));
    BOOST_TEST(error(fixed) < 1e-9);
    BOOST_TEST(error(three) < 1e-9);
    BOOST_TEST(error(dynamic) < 1e-9);
    BOOST_TEST(dynamic.report.intervals == fixed.report.intervals);
}

// q' = v on a part of the interval, at one node in the middle and near the guess: what was taken for granted is given up where
// an evaluation contradicts it, and the work of both attempts is counted.
BOOST_AUTO_TEST_CASE(what_only_looked_like_second_order_is_solved_as_it_is) {
    const auto r = [](const auto& a, const auto& b, auto& out) { out[0] = a[0], out[1] = b[0] - 1; };
    const auto later = [](const auto& t, const auto& y, auto& out) {
        out[0] = y[1], out[1] = -y[0];
        if (t > 0.9) out[0] += 1;
    };
    const auto pushed = sc::solve_bvp(sc::gauss<5>(), sc::two_point(later, r), 0.0, 1.0, Vector2d(0, 0),
                                      {.rtol = 1e-10, .fixed_points = {0.9}});
    BOOST_TEST(pushed.ok());
    BOOST_TEST(std::abs(pushed.y(0.0)[1] - (1 - std::sin(0.1)) / std::sin(1.0)) < 1e-9);
}

BOOST_AUTO_TEST_CASE(a_first_component_whose_derivative_is_not_the_second_is_refused) {
    const sc::bvp_options<double> o{.rtol = 1e-7};
    BOOST_CHECK_EXCEPTION(sc::solve_bvp(sc::gauss<5>(), sc::two_point(not_of_second_order{{{1e-4}}}, ends{}),
                                        -1.0, 1.0, Vector2d(0, 0), o),
                          std::invalid_argument, [](const std::invalid_argument& e) {
                              return std::string(e.what()).find("second_order_components does not hold") !=
                                     std::string::npos;
                          });
}
