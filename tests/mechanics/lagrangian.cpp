// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE lagrangian
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <sstream>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/dae/projection.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/constraint_forces.hpp>
#include <stagecraft/mechanics/holonomic.hpp>
#include <stagecraft/mechanics/invariants.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>
#include <stagecraft/mechanics/regularisation/regularised_position.hpp>

#include <problems/rolling_disc/disc.hpp>
#include <problems/thesis/any_problem.hpp>

using namespace stagecraft;
using wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_50::backend_type,
                                           boost::multiprecision::et_off>;

namespace {

// The thin disc from its energies alone: the centre is at (x, y - R sin beta, R cos beta) in the frame turned
// by alpha, the inertia about it m R^2 diag(1/4, 1/2, 1/4).
template <class Real>
auto disc_from_energies() {
    const rolling_disc::disc<Real> body;
    const auto T = [R = body.R, m = body.m](const auto& q, const auto& v) {
        using std::cos;
        using std::sin;
        const auto s = sin(q[3]), c = cos(q[3]);
        const auto vx = v[0] + v[2] * (R * s - q[1]), vy = v[1] - v[3] * R * c + v[2] * q[0],
                   vz = v[3] * R * s;
        const auto lean = v[3], turn = v[2] * c, spin = v[4] + v[2] * s;
        return m * (vx * vx + vy * vy + vz * vz + R * R * (lean * lean + turn * turn + 2 * spin * spin) / 4) /
               2;
    };
    const auto V = [body](const auto& q) {
        using std::cos;
        return body.m * body.g * body.R * cos(q[3]);
    };
    const auto rolling = [body](const auto& q) { return body.G(q.eval()); };
    return lagrangian<5, 2>(T, V, rolling);
}

// One instantiation of the integrator for every formulation.
template <class Problem>
auto run(const Problem& problem, const Eigen::VectorXd& y0, double end, double tolerance = 1e-10) {
    return integrate(radau_iia<3>(), thesis::erased(problem), y0, 0.0, end,
                     {.rtol = tolerance, .atol = tolerance});
}

const auto free_particle = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
const auto weight = [](const auto& q) { return 9.81 * q[1]; };

}  // namespace

BOOST_AUTO_TEST_CASE(the_rolling_disc_from_T_and_V_has_the_corrected_forces) {
    const rolling_disc::disc<wide> body;
    rolling_disc::disc<wide> printed;
    printed.printed_force = true;
    const auto model = disc_from_energies<wide>();
    using vector = Eigen::Matrix<wide, 5, 1>;
    for (int k = 1; k <= 5; ++k) {
        vector q, v;
        for (int i = 0; i < 5; ++i) {
            q[i] = wide((7 * i + 3 * k) % 11 - 5) / 7;
            v[i] = wide((5 * i + 2 * k) % 13 - 6) / 5;
        }
        BOOST_TEST((model.M(q) - body.M(q)).cwiseAbs().maxCoeff() < 1e-45);
        BOOST_TEST((model.F(q, v, wide(0)) - body.F(q, v)).cwiseAbs().maxCoeff() < 1e-45);
        BOOST_TEST((model.F(q, v, wide(0)) - printed.F(q, v)).cwiseAbs().maxCoeff() > 1e-3);
        const vector defect = model.balance(q, v, q, wide(0)) - body.F(q, v) + body.M(q) * q;
        BOOST_TEST(defect.cwiseAbs().maxCoeff() < 1e-45);
    }
}

BOOST_AUTO_TEST_CASE(a_run_from_T_and_V_is_the_run_of_the_written_model) {
    const auto written = index_2(rolling_disc::disc<>());
    const auto derived = index_2(disc_from_energies<double>());
    Eigen::Matrix<double, 5, 1> q, v;
    q << 0, 0, 0, 0.3, 0;
    v << 0.2, 0, 0.5, 0.1, 2;
    const auto y0 = derived.initial_state(q, v);
    BOOST_TEST((y0 - written.initial_state(q, v)).cwiseAbs().maxCoeff() < 1e-13);
    const auto a = run(written, y0, 0.5, 1e-9), b = run(derived, y0, 0.5, 1e-9);
    BOOST_TEST(b.ok());
    BOOST_TEST(a.report.steps == b.report.steps);
    BOOST_TEST((a.y - b.y).head(10).cwiseAbs().maxCoeff() < 1e-9);        // the tolerance
    BOOST_TEST((a.y - b.y).tail(2).cwiseAbs().maxCoeff() < 1e-9 / 1e-3);  // over the step size
}

// A pendulum in Cartesian coordinates against the same in its angle, in every formulation.
BOOST_AUTO_TEST_CASE(position_constraints_give_every_formulation_of_the_pendulum) {
    const auto pendulum =
        lagrangian<2, 1>(free_particle, weight, [](const auto& q) { return (q.squaredNorm() - 1) / 2; });
    const auto angle = [](double, const Eigen::VectorXd& y, Eigen::VectorXd& f) {
        f << y[1], -9.81 * std::sin(y[0]);
    };
    const Eigen::VectorXd reference = [&] {
        Eigen::VectorXd start(2);
        start << 1.2, 0;
        return integrate(radau_iia<3>(), angle, start, 0.0, 2.0, {.rtol = 1e-12, .atol = 1e-12}).y;
    }();
    const Eigen::Vector2d q0(std::sin(1.2), -std::cos(1.2)), v0(0, 0),
        end(std::sin(reference[0]), -std::cos(reference[0]));
    const double tension = reference[1] * reference[1] + 9.81 * std::cos(reference[0]);  // lambda
    const auto check = [&]<class Problem>(const Problem& problem, double allowed) {
        const auto r = run(problem, problem.initial_state(q0, v0), 2.0);
        BOOST_TEST(r.ok());
        BOOST_TEST((r.y.head(2) - end).norm() < allowed);
        if constexpr (requires { problem.multiplier(Eigen::Matrix<double, Problem::size, 1>()); })
            BOOST_TEST(std::abs(problem.multiplier(Eigen::Matrix<double, Problem::size, 1>(r.y))[0] -
                                tension) < 1e4 * allowed);
    };
    check(index_2(pendulum), 1e-7);
    check(index_3(pendulum), 1e-7);
    check(stabilised_index_2(pendulum), 1e-7);
    check(index_reduced(pendulum), 1e-7);
    check(index_reduced(pendulum, 20), 1e-7);
    check(baumgarte(pendulum, 5, 5.0), 1e-7);
}

namespace {

// A bead of mass 1 on a straight wire that turns with speed w, pulled down by `gravity`.
auto bead(double w, double gravity) {
    return lagrangian<2, 1>(
        free_particle, [gravity](const auto& q) { return gravity * q[1]; },
        [w](const auto& q, const auto& t) {
            using std::cos;
            using std::sin;
            return q[1] * cos(w * t) - q[0] * sin(w * t);
        });
}

// Every regularised form of the bead, the one of position last.
template <class Visit>
void every_contact(double w, double gravity, double eps, double kappa, const Visit& visit) {
    const double c = 2, d = 1.5;
    visit(regularised(bead(w, gravity), eps, kappa, c, d));
    visit(regularised_multiplier_form(bead(w, gravity), eps, kappa, c, d));
    visit(regularised_creep_form(bead(w, gravity), eps, kappa, c, d));
    if (kappa == 0.5) visit(principal_damping_transformed(bead(w, gravity), eps, c, d));
    visit(regularised_position(bead(w, gravity), eps, kappa, c, d));
}

}  // namespace

// On a circle of radius 1 the rod pulls with v^2 + 9.81 cos(angle), in every formulation.
BOOST_AUTO_TEST_CASE(forces_of_constraints_are_written_as_a_table) {
    const auto pendulum =
        lagrangian<2, 1>(free_particle, weight, [](const auto& q) { return (q.squaredNorm() - 1) / 2; });
    const Eigen::Vector2d q(0.6, -0.8), v(0.8, 0.6);
    const double tension = 1 + 9.81 * 0.8;
    const auto check = [&](const auto& problem) {
        const auto y = problem.initial_state(q, v);
        BOOST_TEST((constraint_forces(problem, y) - tension * q).norm() < 1e-13);
        std::ostringstream out;
        write_constraint_forces(
            out, problem, [&](double) { return y; }, std::vector<double>{0, 0.5});
        BOOST_TEST(out.str() ==
                   "t,lambda_0,force_0_0,force_0_1\n0,8.848,5.3088,-7.0784\n"
                   "0.5,8.848,5.3088,-7.0784\n");
    };
    check(index_2(pendulum));
    check(index_3(pendulum));
    check(stabilised_index_2(pendulum));
    check(index_reduced(pendulum));
}

// A bead on the turning wire, moved back by the smallest change: along the normal of the wire.
BOOST_AUTO_TEST_CASE(projection_on_what_index_reduction_loses) {
    const double w = 1.5, t = 0.4, c = std::cos(w * t), s = std::sin(w * t);
    const auto lost = invariants(bead(w, 0));
    BOOST_TEST(lost.count == 2);
    auto keep = projection_onto(lost);
    Eigen::Vector4d y(2 * c - 0.3 * s, 2 * s + 0.3 * c, 0.5, -1);
    Eigen::Vector2d r;
    lost(t, y, r);
    BOOST_TEST(std::abs(r[0] - 0.3) < 1e-15);                         // the distance from the wire
    BOOST_TEST(std::abs(r[1] - (-1 * c - 0.5 * s - w * 2)) < 1e-14);  // its rate
    BOOST_TEST(keep.correct(t, y));
    lost(t, y, r);
    BOOST_TEST(r.norm() < 1e-14);
    Eigen::Matrix<double, 2, 4> J, differences;
    lost.jacobian(t, y, J);
    for (int j = 0; j < 4; ++j) {
        Eigen::Vector2d up, down;
        const Eigen::Vector4d e = 1e-5 * Eigen::Vector4d::Unit(j);
        lost(t, Eigen::Vector4d(y + e), up);
        lost(t, Eigen::Vector4d(y - e), down);
        differences.col(j) = (up - down) / 2e-5;
    }
    BOOST_TEST((J - differences).norm() < 1e-9);
}

BOOST_AUTO_TEST_CASE(baumgarte_damps_a_violation_by_its_own_equation) {
    const auto pendulum =
        lagrangian<2, 1>(free_particle, weight, [](const auto& q) { return (q.squaredNorm() - 1) / 2; });
    const double alpha = 3, beta = 3, t = 1;
    Eigen::Vector4d y0(0.9, -0.5, 0.3, 0.2);  // g and g' are not zero: g'' + 6 g' + 9 g = 0 from there
    const double g0 = (y0.head<2>().squaredNorm() - 1) / 2, rate = y0.head<2>().dot(y0.tail<2>());
    const auto r = run(baumgarte(pendulum, alpha, beta), y0, t);
    const double expected = std::exp(-alpha * t) * (g0 + (rate + alpha * g0) * t);
    BOOST_TEST(std::abs((r.y.head(2).squaredNorm() - 1) / 2 - expected) < 1e-8);
    BOOST_TEST(std::abs(expected) > 1e-3);
    const Eigen::Vector4d same = run(baumgarte(pendulum, 3, 3), y0, t).y;
    BOOST_TEST((same - r.y).norm() == 0);
    BOOST_CHECK_THROW(baumgarte(pendulum, -1, 1), std::invalid_argument);
}

// r'' = w^2 r, and the wire pushes with 2 w r'.
BOOST_AUTO_TEST_CASE(moving_constraints_do_work) {
    const double w = 1.5;
    const Eigen::Vector2d q0(1, 0), v0(0, w);
    const double t = 1, r1 = std::cosh(w * t), speed = w * std::sinh(w * t);
    const Eigen::Vector2d end(r1 * std::cos(w * t), r1 * std::sin(w * t));
    const auto check = [&]<class Problem>(const Problem& problem) {
        const auto r = run(problem, problem.initial_state(q0, v0), t);
        BOOST_TEST(r.ok());
        BOOST_TEST((r.y.head(2) - end).norm() < 1e-8);
        if constexpr (requires { problem.multiplier(Eigen::Matrix<double, Problem::size, 1>()); })
            BOOST_TEST(std::abs(problem.multiplier(Eigen::Matrix<double, Problem::size, 1>(r.y), t)[0] +
                                2 * w * speed) < 1e-4);
    };
    check(index_2(bead(w, 0)));
    check(index_3(bead(w, 0)));
    check(stabilised_index_2(bead(w, 0)));
    check(index_reduced(bead(w, 0)));
    check(baumgarte(bead(w, 0), 5.0, 5.0));
}

// As eps -> 0 the moving wire's contact tends to the constraint: the error in q falls like eps.
BOOST_AUTO_TEST_CASE(regularised_moving_constraints_tend_to_the_constraint) {
    const double w = 1.5, t = 1, r1 = std::cosh(w * t);
    const Eigen::Vector2d q0(1, 0), v0(0, w), end(r1 * std::cos(w * t), r1 * std::sin(w * t));
    for (const double kappa : {0.5, 1.0}) {
        std::vector<double> coarse, fine;
        for (const bool small : {false, true})
            every_contact(w, 0, small ? 1e-5 : 1e-4, kappa, [&]<class Problem>(const Problem& problem) {
                const auto r = run(problem, problem.initial_state(q0, v0), t);
                BOOST_TEST(r.ok());
                const double force =
                    problem.multiplier(typename Problem::state(r.y), t)[0] + 2 * w * w * std::sinh(w * t);
                BOOST_TEST(std::abs(force) < (small ? 1e-3 : 1e-2));
                (small ? fine : coarse).push_back((r.y.head(2) - end).norm());
            });
        for (std::size_t k = 0; k < fine.size(); ++k) {
            BOOST_TEST(coarse[k] < 1e-2);
            BOOST_TEST(coarse[k] / fine[k] > 9);
            BOOST_TEST(coarse[k] / fine[k] < 11);
        }
    }
}

// On a wire at rest the bead is a mass on a spring with a damper, x'' + (d/sqrt(eps)) x' + (c/eps) x = -9.81 from
// rest at zero, in every form.
BOOST_AUTO_TEST_CASE(a_regularised_support_is_a_damped_oscillator) {
    const double eps = 1e-2, stiffness = 2 / eps, damping = 1.5 / std::sqrt(eps), t = 0.2, rate = damping / 2,
                 omega = std::sqrt(stiffness - rate * rate), rest = -9.81 / stiffness;
    const double x =
        rest * (1 - std::exp(-rate * t) * (std::cos(omega * t) + rate / omega * std::sin(omega * t)));
    using one = Eigen::Matrix<double, 1, 1>;
    every_contact(0, 9.81, eps, 0.5, [&]<class Problem>(const Problem& problem) {
        const auto y0 = problem.initial_state(Eigen::Vector2d(0, 0), Eigen::Vector2d(0.5, 0), one(0));
        const auto r = run(problem, y0, t);
        BOOST_TEST(r.ok());
        BOOST_TEST(std::abs(r.y[1] - x) < 1e-9);
        BOOST_TEST(std::abs(r.y[0] - 0.5 * t) < 1e-12);
    });
}

namespace {

// A ball on a turntable (affine constraint): its centre moves on a circle with 2/7 of the table's speed
// (Earnshaw 1844; Bloch, Nonholonomic Mechanics and Control).
struct ball {
    static constexpr int coordinates = 5, constraints = 2;
    double R = 1, speed = 7;
    template <class S>
    Eigen::Matrix<S, 5, 5> M(const Eigen::Matrix<S, 5, 1>&) const {
        Eigen::Matrix<S, 5, 1> d;
        d << 1, 1, 0.4 * R * R, 0.4 * R * R, 0.4 * R * R;
        return d.asDiagonal();
    }
    template <class S>
    Eigen::Matrix<S, 5, 1> F(const Eigen::Matrix<S, 5, 1>&, const Eigen::Matrix<S, 5, 1>&) const {
        return Eigen::Matrix<S, 5, 1>::Constant(S(0));
    }
    template <class S>
    Eigen::Matrix<S, 2, 5> G(const Eigen::Matrix<S, 5, 1>&) const {
        Eigen::Matrix<S, 2, 5> G;
        G << 1, 0, 0, -R, 0, 0, 1, R, 0, 0;
        return G;
    }
    template <class S>
    Eigen::Matrix<S, 2, 1> b(const Eigen::Matrix<S, 5, 1>& q) const {
        return Eigen::Matrix<S, 2, 1>(speed * q[1], -speed * q[0]);
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(an_affine_constraint_is_given_with_its_last_column) {
    const ball written;
    const auto T = [](const auto&, const auto& v) {
        return 0.5 * (v.template head<2>().squaredNorm() + 0.4 * v.template tail<3>().squaredNorm());
    };
    const auto V = [](const auto& q) { return 0 * q[0]; };
    const auto derived = lagrangian<5, 2>(T, V, [written](const auto& q) {
        const auto at = q.eval();
        Eigen::Matrix<std::decay_t<decltype(at[0])>, 2, 6> Gb;
        Gb << written.G(at), written.b(at);
        return Gb;
    });
    Eigen::Matrix<double, 5, 1> q, v;
    q << 1, 0.5, 0.2, 0.1, 0.3;
    v << 0.3, 2, 4, 0.1, -1;
    BOOST_TEST((derived.M(q) - written.M(q)).norm() < 1e-14);
    BOOST_TEST((velocity_constraint(derived, q, v) - velocity_constraint(written, q, v)).norm() < 1e-14);
    BOOST_TEST((consistent_multiplier(derived, q, v) - consistent_multiplier(written, q, v)).norm() < 1e-13);
}

BOOST_AUTO_TEST_CASE(a_ball_on_a_turntable_circles_with_two_sevenths_of_its_speed) {
    Eigen::Matrix<double, 5, 1> q, v;
    q << 1, 0, 0, 0, 0;
    v << 0, 2, (7.0 - 2), 0, 0;  // contact at rest on the table: v_y + R w_x = speed x
    const auto dae = index_2(ball());
    const auto r = run(dae, dae.initial_state(q, v), 1);
    BOOST_TEST(r.ok());  // centre: v = (2/7) speed rot (x - c), c = 0 here
    BOOST_TEST((r.y.head(2) - Eigen::Vector2d(std::cos(2.0), std::sin(2.0))).norm() < 1e-8);
    Eigen::Matrix<double, 5, 1> slipping = v;
    slipping[1] = 2.5;
    BOOST_CHECK_EXCEPTION(dae.initial_state(q, slipping), std::invalid_argument, [](const auto& e) {
        return std::string(e.what()).find("at t = 0; velocity constraint 1 is 0.5") != std::string::npos;
    });
}

BOOST_AUTO_TEST_CASE(a_ball_on_a_soft_turntable_circles_alike) {
    Eigen::Matrix<double, 5, 1> q, v;
    q << 1, 0, 0, 0, 0;
    v << 0, 2, 5, 0, 0;
    const auto distance = [&](double eps) {
        const auto soft = regularised(ball(), eps, 1.0, 2.0, 2.0);
        const auto r = run(soft, soft.initial_state(q, v), 1);
        BOOST_TEST(r.ok());
        return (r.y.head(2) - Eigen::Vector2d(std::cos(2.0), std::sin(2.0))).norm();
    };
    const double coarse = distance(1e-4), fine = distance(1e-5);
    BOOST_TEST(coarse < 1e-2);
    BOOST_TEST(coarse / fine > 9);
    BOOST_TEST(coarse / fine < 11);
}

// A ball thrown without spin slides and then rolls with 5/7 of its speed; so it does if it is made to roll at once.
BOOST_AUTO_TEST_CASE(a_constraint_that_begins_to_act_changes_the_velocity_by_an_impulse) {
    ball at_rest;
    at_rest.speed = 0;
    const auto start = assemble(at_rest, Eigen::Matrix<double, 5, 1>::Zero(),
                                (Eigen::Matrix<double, 5, 1>() << 3, 0, 0, 0, 1).finished());
    BOOST_TEST(std::abs(start.v[0] - 5.0 / 7 * 3) < 1e-15);
    BOOST_TEST(std::abs(start.v[3] - 5.0 / 7 * 3) < 1e-15);
    BOOST_TEST(start.v[4] == 1);
    BOOST_CHECK_NO_THROW(index_2(at_rest).initial_state(start.q, start.v));
}

BOOST_AUTO_TEST_CASE(a_mechanism_is_assembled_from_rough_coordinates) {
    const auto pendulum =
        lagrangian<2, 1>(free_particle, weight, [](const auto& q) { return (q.squaredNorm() - 1) / 2; });
    const auto start = assemble(pendulum, Eigen::Vector2d(0.7, -0.9), Eigen::Vector2d(1, 0));
    BOOST_TEST((start.q - Eigen::Vector2d(0.7, -0.9).normalized()).norm() < 1e-15);
    BOOST_TEST(std::abs(start.q.dot(start.v)) < 1e-15);
    BOOST_CHECK_NO_THROW(index_3(pendulum).initial_state(start.q, start.v));
    const auto nowhere =
        lagrangian<2, 1>(free_particle, weight, [](const auto& q) { return (q.squaredNorm() + 1) / 2; });
    BOOST_CHECK_THROW(assemble(nowhere, Eigen::Vector2d(0.7, -0.9), Eigen::Vector2d(1, 0)),
                      std::runtime_error);
}

BOOST_AUTO_TEST_CASE(a_constraint_that_depends_on_others_is_named) {
    const auto twice = lagrangian<3, 2>(free_particle, weight, [](const auto& q) {
        auto g = q.template head<2>().eval();
        g[0] = q.squaredNorm() - 1;
        g[1] = 3 * q.squaredNorm() - 3;
        return g;
    });
    const auto check = [](const auto& problem) {
        BOOST_CHECK_EXCEPTION(problem.initial_state(Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0)),
                              std::domain_error, [](const std::domain_error& e) {
                                  return std::string(e.what()).find(
                                             "constraints that depend on others: 1 ") != std::string::npos;
                              });
    };
    check(index_2(twice));
    check(index_3(twice));
    check(stabilised_index_2(twice));
}

BOOST_AUTO_TEST_CASE(forces_and_constraints_of_another_size_are_refused) {
    const auto T = [](const auto& q, const auto& v) { return 0.5 * v.dot(v) + 0.0 * q[0]; };
    const auto V = [](const auto& q) { return 9.81 * q[1]; };
    const auto short_Q = [](const auto&, const auto& v, const auto&) {
        using S = std::decay_t<decltype(v[0])>;
        return Eigen::Matrix<S, Eigen::Dynamic, 1>(-v.head(1));
    };
    const Eigen::Vector2d q(1, 0), v(0, 0);
    const auto pushed = lagrangian<2>(T, V, short_Q);
    BOOST_CHECK_THROW(pushed.F(q, v, 0.0), size_change);
    const auto short_g = [](const auto& q) {
        using S = std::decay_t<decltype(q[0])>;
        return Eigen::Matrix<S, Eigen::Dynamic, 1>(Eigen::Matrix<S, 1, 1>(q.dot(q) - 1.0));
    };
    const auto bound = lagrangian<3, 2>(T, V, short_g);
    BOOST_CHECK_THROW(bound.g(Eigen::Vector3d(1, 0, 0), 0.0), size_change);
}
