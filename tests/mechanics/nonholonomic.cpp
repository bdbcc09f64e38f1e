// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE nonholonomic
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <stagecraft/mechanics/holonomic.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>
#include <stagecraft/mechanics/regularisation/regularised.hpp>

#include <problems/thesis/nonholonomic.hpp>
#include <problems/thesis/solve.hpp>

using namespace stagecraft;
using thesis::vector;
using vector3 = Eigen::Vector3d;

namespace {

template <class Problem>
thesis::trajectory run(const Problem& problem, const vector& y0, double end, double tolerance) {
    return thesis::solve<double>({thesis::erased(problem), y0, {}}, {.tolerance = tolerance, .end = end});
}

// A knife edge turned by a torque that depends on time: phi'' = cos t.
struct steered_edge : thesis::knife_edge {
    template <class S>
    Eigen::Matrix<S, 3, 1> F(const Eigen::Matrix<S, 3, 1>& q, const Eigen::Matrix<S, 3, 1>& v,
                             const S& t) const {
        using std::cos;
        Eigen::Matrix<S, 3, 1> F = knife_edge::F(q, v);
        F[2] += S(inertia) * S(cos(t));
        return F;
    }
};

// Largest change of the energy over a run whose states begin with (q, v).
template <class Model>
double drift(const Model& model, const thesis::trajectory& r) {
    constexpr int n = Model::coordinates;
    const auto energy = [&](const vector& y) {
        return total_energy<double>(model, y.head<n>(), y.segment<n>(n));
    };
    double worst = 0;
    for (const auto& p : r.path) worst = std::max(worst, std::abs(energy(p.y) - energy(r.path.front().y)));
    return worst;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_knife_edge_moves_on_its_cycloid) {
    const thesis::knife_edge model;
    const double omega = 2, t = 3, k = model.fall / (2 * omega * omega);
    const auto dae = index_2(model);
    const auto r = run(dae, dae.initial_state(vector3(0, 0, 0), vector3(0, 0, omega)), t, 1e-11);
    const vector& y = r.path.back().y;
    BOOST_TEST(std::abs(y[0] - k * std::pow(std::sin(omega * t), 2)) < 1e-8);
    BOOST_TEST(std::abs(y[1] - k * (omega * t - std::sin(2 * omega * t) / 2)) < 1e-8);
    BOOST_TEST(std::abs(y[2] - omega * t) < 1e-10);
    BOOST_TEST(drift(model, r) < 1e-8);
    for (const auto& p : r.path) {
        const vector3 q = p.y.head<3>(), v = p.y.segment<3>(3);
        BOOST_TEST(constraint_violation(model, q, v) < 1e-11);  // Newton stops at a fraction of the tolerance
    }
    // The same by index reduction, whose Jacobian differentiates G twice automatically.
    vector start(6);
    start << 0, 0, 0, 0, 0, omega;
    const vector reduced = run(index_reduced(model), start, t, 1e-11).path.back().y;
    BOOST_TEST((reduced - y.head(6)).norm() < 1e-7);
}

BOOST_AUTO_TEST_CASE(forces_may_depend_on_time) {
    const auto dae = index_2(steered_edge());
    const auto r = run(dae, dae.initial_state(vector3(0, 0, 0), vector3(0, 0, 0)), 3, 1e-10);
    for (const auto& p : r.path) BOOST_TEST(std::abs(p.y[2] - (1 - std::cos(p.t))) < 1e-8);
    vector start = vector::Zero(6);
    const vector reduced = run(index_reduced(steered_edge()), start, 3, 1e-10).path.back().y;
    BOOST_TEST((reduced - r.path.back().y.head(6)).norm() < 1e-6);
    BOOST_TEST(drift(steered_edge(), r) > 1e-2);  // the torque does work
}

namespace {

// An upright wheel of radius r that rolls without slip at (x, y) in the direction theta while a motor turns it by
// spin(t) = w + a cos(nu t); q = (x, y, theta, phi).
const double r_wheel = 0.4, m_wheel = 3, J_wheel = 0.24, w = 2, a = 1.5, nu = 3;
auto driven_wheel() {
    const auto T = [](const auto&, const auto& v) {
        return 0.5 * (m_wheel * (v[0] * v[0] + v[1] * v[1]) + 0.1 * v[2] * v[2] + J_wheel * v[3] * v[3]);
    };
    const auto V = [](const auto& q) { return 0 * q[0]; };
    const auto rolling_and_spin = [](const auto& q, const auto& t) {
        using std::cos;
        using std::sin;
        using S = std::decay_t<decltype(t)>;
        Eigen::Matrix<S, 3, 5> Gb = Eigen::Matrix<S, 3, 5>::Constant(S(0));
        Gb(0, 0) = Gb(1, 1) = Gb(2, 3) = S(1);
        Gb(0, 3) = S(-r_wheel) * S(cos(q[2]));
        Gb(1, 3) = S(-r_wheel) * S(sin(q[2]));
        Gb(2, 4) = S(-w) - S(a) * S(cos(S(nu) * t));
        return Gb;
    };
    return lagrangian<4, 3>(T, V, rolling_and_spin);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_driven_wheel_takes_the_path_and_the_torque_of_its_spin) {
    using vector4 = Eigen::Vector4d;
    const double turn = 0.7, t = 4;
    const vector4 q(0, 0, 0, 0), v(r_wheel * (w + a), 0, turn, w + a);
    // x' + i y' = r spin(t) exp(i turn t), an elementary integral.
    const auto arc = [&](double rate) {
        return std::complex<double>(std::sin(rate * t), 1 - std::cos(rate * t)) / rate;
    };
    const std::complex<double> place = r_wheel * (w * arc(turn) + a / 2 * (arc(turn + nu) + arc(turn - nu)));
    const vector4 end(place.real(), place.imag(), turn * t, w * t + a / nu * std::sin(nu * t));
    const double spin = w + a * std::cos(nu * t), faster = -a * nu * std::sin(nu * t), c = std::cos(turn * t),
                 s = std::sin(turn * t);
    const vector3 force = -vector3(m_wheel * r_wheel * (faster * c - spin * turn * s),
                                   m_wheel * r_wheel * (faster * s + spin * turn * c),
                                   (J_wheel + m_wheel * r_wheel * r_wheel) * faster);
    const auto check = [&](const auto& problem, double of_q, double of_force) {
        using state = Eigen::Matrix<double, std::decay_t<decltype(problem)>::size, 1>;
        const vector y = run(problem, problem.initial_state(q, v), t, 1e-11).path.back().y;
        BOOST_TEST((y.head(4) - end).norm() < of_q);
        BOOST_TEST((problem.multiplier(state(y), t) - force).norm() < of_force);
    };
    check(index_2(driven_wheel()), 1e-9, 1e-6);
    check(index_reduced(driven_wheel()), 1e-9, 1e-8);
    check(index_reduced(driven_wheel(), 2.0), 1e-9, 1e-8);
    check(regularised(driven_wheel(), 1e-7, 1, 1, 1), 1e-4, 1e-4);
    BOOST_CHECK_THROW(index_2(driven_wheel()).initial_state(q, vector4(1, 0, 0, w + a)),
                      std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_pendulum_whose_suspension_falls_circles_evenly) {
    // The suspension is at (0, -9.81 t^2/2) and takes the weight away: the bob circles about it with the speed that it
    // has, and the rod's force is that of this circle.
    using vector2 = Eigen::Vector2d;
    const double length = 0.8, mass = 2, omega = 3, t = 2;
    const auto T = [=](const auto&, const auto& v) { return 0.5 * mass * v.squaredNorm(); };
    const auto V = [=](const auto& q) { return mass * 9.81 * q[1]; };
    const auto rod = [=](const auto& q, const auto& time) {
        const auto y = q[1] + 0.5 * 9.81 * time * time;
        return q[0] * q[0] + y * y - length * length;
    };
    const auto model = lagrangian<2, 1>(T, V, rod);
    const vector2 q(0, -length), v(omega * length, 0),
        end(length * std::sin(omega * t), -length * std::cos(omega * t) - 0.5 * 9.81 * t * t);
    const auto check = [&](const auto& problem) {
        using state = Eigen::Matrix<double, std::decay_t<decltype(problem)>::size, 1>;
        const vector y = run(problem, problem.initial_state(q, v), t, 1e-11).path.back().y;
        BOOST_TEST((y.head(2) - end).norm() < 1e-7);
        BOOST_TEST(std::abs(2 * problem.multiplier(state(y), t)[0] - mass * omega * omega) < 1e-4);
    };
    check(index_2(model));
    check(index_3(model));
    check(stabilised_index_2(model));
    check(baumgarte(model, 10, 10));
}

BOOST_AUTO_TEST_CASE(the_chaplygin_sleigh_keeps_its_energy_and_straightens) {
    const thesis::chaplygin_sleigh model;
    const auto dae = index_2(model);
    const double u0 = 0.5, w0 = 3;
    const auto r = run(dae, dae.initial_state(vector3(0, 0, 0), vector3(u0, 0, w0)), 12, 1e-10);
    BOOST_TEST(drift(model, r) < 1e-8);
    // What the multiplier's own interpolation leaves does not send the step size up and down.
    BOOST_TEST(r.report.rejected() < r.report.steps / 8);
    // u' = a w^2, w' = -m a u w/(J + m a^2) for the speed u along the blade: w decays, all energy ends in u.
    const vector& y = r.path.back().y;
    const double u = std::cos(y[2]) * y[3] + std::sin(y[2]) * y[4];
    const double all = model.mass * u0 * u0 + (model.inertia + model.mass * model.a * model.a) * w0 * w0;
    BOOST_TEST(std::abs(y[5]) < 1e-2 * w0);
    BOOST_TEST(u == std::sqrt(all / model.mass), boost::test_tools::tolerance(1e-4));
}

BOOST_AUTO_TEST_CASE(a_ball_in_an_upright_cylinder_does_not_fall) {
    const auto largest_distance = [](const thesis::rolling_ball& model) {
        const double omega = 9, spin = 2;
        const auto dae = index_2(model);
        const auto r = run(
            dae, dae.initial_state(model.initial_position(), model.initial_velocity(omega, spin)), 1.5, 1e-9);
        BOOST_TEST(drift(model, r) < 1e-7);
        double worst = 0;
        for (const auto& p : r.path) {
            const Eigen::Matrix<double, 5, 1> q = p.y.head<5>(), v = p.y.segment<5>(5);
            BOOST_TEST(constraint_violation(model, q, v) < 1e-9 * v.norm());
            worst = std::max(worst, std::abs(p.y[1] - thesis::rolling_ball().height(omega, spin, p.t)));
        }
        return worst;
    };
    thesis::rolling_ball hollow;
    hollow.inertia = 2.0 / 3 * hollow.mass * hollow.radius * hollow.radius;
    BOOST_TEST(largest_distance(thesis::rolling_ball()) < 1e-8);
    BOOST_TEST(largest_distance(hollow) > 0.1);  // its own closed form has another frequency
}

BOOST_AUTO_TEST_CASE(gear_gupta_leimkuhler_keeps_both_constraints_of_the_pendulum) {
    const thesis::pendulum model;
    const double tolerance = 1e-9, t = 5;
    vector start(5);
    start << 1, 0, 0, 0, 0;  // horizontal, at rest: lambda = 0
    vector stabilised(6);
    stabilised << start, 0;
    const auto ggl = run(stabilised_index_2(model), stabilised, t, tolerance);
    const auto third = run(index_3(model), start, t, tolerance);
    const auto second = run(index_2(model), start, t, tolerance);
    const auto length_error = [](const thesis::trajectory& r) {
        double worst = 0;
        for (const auto& p : r.path) worst = std::max(worst, std::abs(p.y.head(2).norm() - 1));
        return worst;
    };
    const auto speed_error = [](const thesis::trajectory& r) {
        double worst = 0;
        for (const auto& p : r.path) worst = std::max(worst, std::abs(p.y.head(2).dot(p.y.segment(2, 2))));
        return worst;
    };
    BOOST_TEST(length_error(ggl) < tolerance);
    BOOST_TEST(speed_error(ggl) < tolerance);
    BOOST_TEST(length_error(third) < tolerance);
    BOOST_TEST(speed_error(third) > 10 * speed_error(ggl));     // index 3 keeps the position only
    BOOST_TEST(length_error(second) > 10 * length_error(ggl));  // index 2 the velocity only: it drifts
    BOOST_TEST((ggl.path.back().y.head(4) - second.path.back().y.head(4)).norm() < 1e-5);
    BOOST_TEST((ggl.path.back().y.head(4) - third.path.back().y.head(4)).norm() < 1e-5);
    BOOST_TEST(drift(model, ggl) < 1e-6);
    BOOST_TEST(std::abs(ggl.path.back().y[5]) < 1e-6);  // mu
}

BOOST_AUTO_TEST_CASE(the_stabilised_form_brings_its_derivative_off_the_constraints_too) {
    const auto problem = thesis::erased(stabilised_index_2(thesis::pendulum()));
    const double e = 1e-6;
    vector y(6), up(6), down(6);
    y << 0.7, -1.3, 0.4, 2, 5, 0.6;  // mu is not zero
    Eigen::MatrixXd J(6, 6);
    problem.jacobian(0, y, J);
    for (int j = 0; j < 6; ++j) {
        problem(0, y + e * vector::Unit(6, j), up);
        problem(0, y - e * vector::Unit(6, j), down);
        BOOST_TEST((J.col(j) - (up - down) / (2 * e)).norm() < 1e-8);
    }
}
