// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE free_motion
#include <Eigen/LU>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/free_motion.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>
#include <stdexcept>
#include <string>

using namespace stagecraft;
using Eigen::Vector2d, Eigen::Vector4d;
using angle = Eigen::Matrix<double, 1, 1>;

namespace {

// Two unit masses on rods of length 1, by the angles from the vertical.
const auto T = [](const auto& q, const auto& v) {
    using std::cos;
    return v[0] * v[0] + 0.5 * v[1] * v[1] + v[0] * v[1] * cos(q[0] - q[1]);
};
const auto V = [](const auto& q) {
    using std::cos;
    return -9.81 * (2 * cos(q[0]) + cos(q[1]));
};

// Their accelerations from the textbook (Landau-Lifshitz, Mechanics, section 5, problem 1).
Vector2d textbook(const Vector2d& q, const Vector2d& v) {
    const double s = std::sin(q[0] - q[1]), c = std::cos(q[0] - q[1]);
    Eigen::Matrix2d M;
    M << 2, c, c, 1;
    return M.inverse() *
           Vector2d(-v[1] * v[1] * s - 2 * 9.81 * std::sin(q[0]), v[0] * v[0] * s - 9.81 * std::sin(q[1]));
}

// A mass on a spring that stiffens with time, and whose mass depends on where it is: M and F by hand.
struct by_hand {
    static constexpr int coordinates = 2;
    template <class S>
    Eigen::Matrix<S, 2, 2> M(const Eigen::Matrix<S, 2, 1>& q) const {
        Eigen::Matrix<S, 2, 2> M;
        M << S(2) + q[0] * q[0], q[1], q[1], S(3) + q[1] * q[1];
        return M;
    }
    template <class S>
    Eigen::Matrix<S, 2, 1> F(const Eigen::Matrix<S, 2, 1>& q, const Eigen::Matrix<S, 2, 1>& v,
                             const S& t) const {
        return Eigen::Matrix<S, 2, 1>(-q[0] * t - v[0] * v[1], -q[1] * q[0] - v[1]);
    }
};

template <class Problem>
void check_jacobian(const Problem& f, const Vector4d& y, double t) {
    Eigen::Matrix4d J, differences;
    f.jacobian(t, y, J);
    for (int j = 0; j < 4; ++j) {
        Vector4d up, down;
        const Vector4d e = 1e-5 * Vector4d::Unit(j);
        f(t, Vector4d(y + e), up);
        f(t, Vector4d(y - e), down);
        differences.col(j) = (up - down) / 2e-5;
    }
    BOOST_TEST((J - differences).norm() < 1e-7 * (1 + J.norm()));
}

template <class Error>
void check_refused(const std::function<void()>& call, const std::string& what) {
    BOOST_CHECK_EXCEPTION(
        call(), Error, [&](const Error& e) { return std::string(e.what()).find(what) != std::string::npos; });
}

}  // namespace

BOOST_AUTO_TEST_CASE(energies_alone_give_the_equations_of_the_double_pendulum) {
    const auto pendulum = free_motion(lagrangian<2>(T, V));
    const Vector4d y(1.1, -0.4, 2, -3);
    Vector4d f;
    pendulum(0.0, y, f);
    BOOST_TEST((f.head<2>() - y.tail<2>()).norm() == 0);
    BOOST_TEST((f.tail<2>() - textbook(y.head<2>(), y.tail<2>())).norm() < 1e-13);
    check_jacobian(pendulum, y, 0);
    const auto r =
        integrate(radau_iia<5>(), pendulum, pendulum.initial_state(Vector2d(1.1, -0.4), Vector2d(2, -3)), 0.0,
                  3.0, {.rtol = 1e-11, .atol = 1e-11});
    BOOST_TEST(r.ok());
    const auto energy = [](const Vector4d& at) {
        const Vector2d q = at.head<2>(), v = at.tail<2>();
        return T(q, v) + V(q);
    };
    BOOST_TEST(std::abs(energy(r.y) - energy(y)) < 1e-9);
}

BOOST_AUTO_TEST_CASE(forces_stand_beside_the_energies) {
    // One angle, damped and driven.
    const auto kinetic = [](const auto&, const auto& v) { return 0.5 * v[0] * v[0]; };
    const auto potential = [](const auto& q) {
        using std::cos;
        return -9.81 * cos(q[0]);
    };
    const auto drive = [](const auto&, const auto& v, const auto& t) {
        using std::sin;
        auto f = (-0.3 * v).eval();
        f[0] += 2 * sin(3 * t);
        return f;
    };
    const auto driven = free_motion(lagrangian<1>(kinetic, potential, drive));
    const auto written = [](double t, const Vector2d& y, Vector2d& f) {
        f << y[1], -9.81 * std::sin(y[0]) - 0.3 * y[1] + 2 * std::sin(3 * t);
    };
    const options<double> tight{.rtol = 1e-11, .atol = 1e-11};
    const auto a = integrate(radau_iia<3>(), driven, driven.initial_state(angle(0.5), angle(0)), 0.0, 4.0,
                             tight),
               b = integrate(radau_iia<3>(), written, Vector2d(0.5, 0), 0.0, 4.0, tight);
    BOOST_TEST((a.y - b.y).norm() < 1e-8);
    const auto undriven = free_motion(lagrangian<1, 0>(kinetic, potential));
    const auto c =
        integrate(radau_iia<3>(), undriven, undriven.initial_state(angle(0.5), angle(0)), 0.0, 4.0, tight);
    BOOST_TEST((a.y - c.y).norm() > 0.1);
}

BOOST_AUTO_TEST_CASE(models_by_hand_have_their_jacobian_too) {
    const auto f = free_motion(by_hand{});
    const Vector4d y(0.3, -0.7, 1.5, 0.4);
    check_jacobian(f, y, 2);
    Vector4d value;
    f(2.0, y, value);
    const Vector2d q = y.head<2>(), v = y.tail<2>();
    BOOST_TEST((by_hand{}.M(q) * value.tail<2>() - by_hand{}.F(q, v, 2.0)).norm() < 1e-14);
}

BOOST_AUTO_TEST_CASE(starts_without_an_acceleration_are_named) {
    const auto massless = [](const auto&, const auto& v) { return 0.5 * v[0] * v[0] + 0 * v[1]; };
    const auto cubic = [](const auto&, const auto& v) { return v[0] * v[0] * v[0] + v[1] * v[1]; };
    const auto steep = [](const auto& q) {
        using std::sqrt;
        return sqrt(q[0]);
    };
    const Vector2d zero(0, 0);
    check_refused<std::domain_error>(
        [&] { free_motion(lagrangian<2>(massless, V)).initial_state(zero, zero); },
        "the mass of coordinate 1 is not positive");
    check_refused<std::invalid_argument>(
        [&] { free_motion(lagrangian<2>(cubic, V)).initial_state(zero, zero); },
        "must be a quadratic polynomial in v");
    check_refused<std::domain_error>([&] { free_motion(lagrangian<2>(T, steep)).initial_state(zero, zero); },
                                     "is not finite here, in component 0");
}
