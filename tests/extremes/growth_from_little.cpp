// SPDX-License-Identifier: BSL-1.0
// What grows from far below the tolerance is not passed over, whatever the number of growing modes, real or not; what
// only moves there costs nothing.
#define BOOST_TEST_MODULE growth_from_little
#include <Eigen/Eigenvalues>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <random>
#include <stagecraft/coefficients/lobatto_iiic.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/judge/guards/growth_bound.hpp>
#include <stagecraft/radau_iia_variable.hpp>

namespace sc = stagecraft;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

using right_hand_side = std::function<void(double, const VectorXd&, VectorXd&)>;

/// Species with these rates that share what they live on: y_i' = a_i y_i (1 - sum of all).
right_hand_side species(VectorXd a) {
    return [a](double, const VectorXd& y, VectorXd& f) { f = a.cwiseProduct(y) * (1 - y.sum()); };
}
right_hand_side van_der_pol(double mu) {
    return [mu](double, const VectorXd& y, VectorXd& f) {
        f[0] = y[1], f[1] = mu * (1 - y[0] * y[0]) * y[1] - y[0];
    };
}
/// r' = 10 r (1 - r^2), turning by 20 in a unit of time.
void circle(double, const VectorXd& y, VectorXd& f) {
    const double growth = 10 * (1 - y.squaredNorm());
    f[0] = growth * y[0] - 20 * y[1], f[1] = growth * y[1] + 20 * y[0];
}

/// Calls look with the results of every method.
template <class Look>
void with_methods(const right_hand_side& f, const VectorXd& y0, double t1, Look&& look) {
    const sc::options<double> o{};
    look(sc::integrate(sc::radau_iia<2>(), f, y0, 0, t1, o));
    look(sc::integrate(sc::radau_iia<3>(), f, y0, 0, t1, o));
    look(sc::integrate(sc::radau_iia<5>(), f, y0, 0, t1, o));
    look(sc::integrate(sc::radau_iia_variable(), f, y0, 0, t1, o));
}

}  // namespace

// What is absent, or at rest in an unstable state, has nothing to grow from: where f is exactly zero the steps are as long as
// without the modes that would grow.
BOOST_AUTO_TEST_CASE(nothing_grows_from_nothing) {
    const right_hand_side infection = [](double t, const VectorXd& y, VectorXd& f) {
        f[0] = -3e7 * y[0] * y[1], f[1] = 3e7 * y[0] * y[1] - 2e3 * y[1];  // susceptible and infected
        f[2] = -y[2] + std::cos(t);
    };
    with_methods(infection, Eigen::Vector3d(1, 0, 0), 10, [](const auto& r) {
        BOOST_TEST(r.ok());
        BOOST_TEST((r.y[0] == 1 && r.y[1] == 0));
        BOOST_TEST(std::abs(r.y[2] - (std::cos(10.) + std::sin(10.) - std::exp(-10.)) / 2) < 1e-4);
        BOOST_TEST(r.report.steps + r.report.rejected() < 250);
    });
    const right_hand_side upright = [](double, const VectorXd& y, VectorXd& f) {
        f[0] = y[1], f[1] = 1e6 * std::sin(y[0]);
    };
    with_methods(upright, Eigen::Vector2d(0, 0), 1000, [](const auto& r) {
        BOOST_TEST(r.ok());
        BOOST_TEST(r.report.steps + r.report.rejected() < 10);
    });
    // 0 = S + I + R - 1 in place of an equation for R, which is of index 1.
    struct closed {
        void operator()(double, const VectorXd& y, VectorXd& f) const {
            f[0] = -y[0] * y[1], f[1] = y[0] * y[1] - y[1] / 2, f[2] = y.sum() - 1;
        }
        Eigen::MatrixXd mass() const { return Eigen::Vector3d(1, 1, 0).asDiagonal(); }
    };
    const auto r = sc::integrate(sc::radau_iia<3>(), closed{}, VectorXd(Eigen::Vector3d(1, 0, 0)), 0, 1e6);
    BOOST_TEST(r.ok());
    BOOST_TEST(r.report.steps + r.report.rejected() < 10);
    // One infected in 1e12 is an epidemic.
    const auto some =
        sc::integrate(sc::radau_iia<3>(), closed{}, VectorXd(Eigen::Vector3d(1, 1e-12, -1e-12)), 0, 1e3);
    BOOST_TEST(some.ok());
    BOOST_TEST(std::abs(some.y[0] - 0.2031878700) < 1e-4);  // log S = 2 (S - 1)
}

BOOST_AUTO_TEST_CASE(species_live_from_small_seeds) {
    const auto live = [](const VectorXd& a) {
        const VectorXd seeds = VectorXd::Constant(a.size(), 1e-9);
        with_methods(species(a), seeds, 100, [&](const auto& r) {
            BOOST_TEST(r.ok());
            BOOST_TEST(std::abs(r.y.sum() - 1) < 1e-4);  // all that there is to live on
            BOOST_TEST(r.report.steps < 200);
        });
    };
    live(Eigen::Vector2d(1, 0.9));
    const auto others = sc::integrate(sc::lobatto_iiic<3>(), species(Eigen::Vector2d(1, 0.9)),
                                      VectorXd(Eigen::Vector2d(1e-9, 1e-9)), 0, 100);
    BOOST_TEST(std::abs(others.y.sum() - 1) < 1e-4);
    live(Eigen::Vector2d(1, 1));
    live(Eigen::Vector2d(1, 0.5));
    live(Eigen::Vector3d(1, 0.9, 0.8));
    live(Eigen::Vector4d(1, 0.9, 0.8, 0.7));
    // The share of each: y_i = 1e-9 exp(a_i s), the sum of both 1.
    const auto r = sc::integrate(sc::radau_iia<3>(), species(Eigen::Vector2d(1, 0.9)),
                                 VectorXd(Eigen::Vector2d(1e-9, 1e-9)), 0, 100);
    BOOST_TEST(std::abs(r.y[1] / std::pow(r.y[0], 0.9) - std::pow(1e-9, 0.1)) < 1e-3);
}

// With constraints of index 2 as well, where the mode is real and the only one, beside a component that moves: of a
// hundred random problems like this one RADAU5 passes over 31 at 1e-4.
BOOST_AUTO_TEST_CASE(one_real_mode_grows_beside_constraints_of_index_2) {
    struct held {
        double rate;
        void operator()(double t, const VectorXd& y, VectorXd& f) const {
            f[0] = rate * y[0] * (1 - y[0] * y[0]) + y[2] - std::cos(t);  // y[2] = cos t holds y[1] on sin t
            f[1] = y[2];
            f[2] = y[1] - std::sin(t);
        }
        Eigen::MatrixXd mass() const { return Eigen::Vector3d(1, 1, 0).asDiagonal(); }
        Eigen::Vector3i index() const { return {1, 1, 2}; }
    };
    const auto grows = [](const auto& method, double rate) {
        const auto r = sc::integrate(method, held{rate}, VectorXd(Eigen::Vector3d(1e-9, 0, 1)), 0, 30,
                                     {.rtol = 1e-4, .atol = 1e-4});
        BOOST_TEST(r.ok());
        BOOST_TEST(std::abs(std::abs(r.y[0]) - 1) < 1e-2);
    };
    for (const double rate : {3., 10., 30., 100.}) {
        grows(sc::radau_iia<3>(), rate);
        grows(sc::radau_iia<5>(), rate);
        grows(sc::radau_iia_variable(), rate);
    }
}

BOOST_AUTO_TEST_CASE(oscillations_start_from_little) {
    for (const double mu : {0.5, 1., 3.})
        with_methods(van_der_pol(mu), Eigen::Vector2d(1e-8, 0), 160, [&](const auto& r) {
            BOOST_TEST(r.ok());
            BOOST_TEST(r.y.norm() > 0.5);  // on the limit cycle, which stays away from the origin
        });
    with_methods(circle, Eigen::Vector2d(1e-7, 0), 20, [](const auto& r) {
        BOOST_TEST(r.ok());
        BOOST_TEST(std::abs(r.y.norm() - 1) < 1e-4);
    });
    // Backwards in time, what is damped grows.
    const right_hand_side damped = [](double, const VectorXd& y, VectorXd& f) {
        VectorXd g(2);
        circle(0, y, g);
        f = -g;
    };
    const auto back = sc::integrate(sc::radau_iia<3>(), damped, VectorXd(Eigen::Vector2d(1e-7, 0)), 0, -20);
    BOOST_TEST(std::abs(back.y.norm() - 1) < 1e-4);
}

BOOST_AUTO_TEST_CASE(what_moves_below_the_tolerance_without_growth_costs_no_steps) {
    const auto quiet = [](const right_hand_side& f, const VectorXd& y0) {
        with_methods(f, y0, 100, [](const auto& r) {
            BOOST_TEST(r.ok());
            BOOST_TEST(r.report.steps + r.report.rejected() < 30);
        });
    };
    for (const double omega : {1., 1e2, 1e4})  // not damped, and far from round
        quiet([omega](double, const VectorXd& y, VectorXd& f) { f[0] = y[1], f[1] = -omega * omega * y[0]; },
              Eigen::Vector2d(1e-9 / omega, 1e-9));
    quiet([](double, const VectorXd&, VectorXd& f) { f.setConstant(1e-12); }, VectorXd::Zero(3));
    // Upwind differences of u_t = -u_x: no mode grows, yet powers of J do for a while.
    quiet(
        [](double, const VectorXd& u, VectorXd& f) {
            for (int i = 0; i < u.size(); ++i) f[i] = 30 * ((i > 0 ? u[i - 1] : 0) - u[i]);
        },
        VectorXd::Constant(30, 1e-9));
    quiet([](double, const VectorXd& y, VectorXd& f) { f[0] = y[1], f[1] = 0; }, Eigen::Vector2d(0, 1e-12));
}

namespace {

MatrixXd random(int rows, int columns, std::mt19937& draw) {
    std::normal_distribution<double> normal;
    return MatrixXd::NullaryExpr(rows, columns, [&](auto, auto) { return normal(draw); });
}
/// q' = v, P v' = -K q - D v.
MatrixXd structure(const VectorXd& P, const MatrixXd& K, const MatrixXd& D) {
    const auto m = P.size();
    MatrixXd J = MatrixXd::Zero(2 * m, 2 * m);
    J.topRightCorner(m, m).setIdentity();
    const VectorXd inverse = -P.cwiseInverse();
    J.bottomLeftCorner(m, m) = inverse.asDiagonal() * K;
    J.bottomRightCorner(m, m) = inverse.asDiagonal() * D;
    return J;
}
bool holds(const MatrixXd& J, double towards, double rate) {
    return sc::growth_bound<double>().holds(J.data(), int(J.rows()), towards, rate);
}
double fastest(const MatrixXd& J) { return J.eigenvalues().real().maxCoeff(); }

}  // namespace

// What is proved to grow no faster than a rate has no eigenvalue beyond it: near the boundary, where a wrong bound fails.
BOOST_AUTO_TEST_CASE(growth_is_bounded_where_that_is_proved) {
    std::mt19937 draw(1);
    int proved = 0, refused = 0;
    const auto look = [&](const MatrixXd& J) {
        for (const double towards : {1., -1.}) {
            const double most = fastest(towards * J);
            for (const double factor : {0.1, 0.5, 0.99, 1.01, 2., 4.}) {
                const double rate = factor * std::abs(most);
                const bool proof = holds(J, towards, rate);
                if (proof) BOOST_TEST(most <= rate * (1 + 1e-6) + 1e-7);
                ++(proof ? proved : refused);
            }
        }
    };
    for (int k = 0; k < 50; ++k) {
        const int m = 1 + k % 7;
        const VectorXd P = random(m, 1, draw).cwiseAbs();
        const MatrixXd A = random(m, m, draw), B = random(m, m, draw);
        look(structure(P, A * A.transpose() - MatrixXd::Identity(m, m), B * B.transpose() / 10));
        look(structure(P, A * A.transpose(), B - B.transpose() - MatrixXd::Identity(m, m)));
        look(structure(P, A * A.transpose(), -B * B.transpose()));
        look(structure(P, A, B));
        look(structure(P, A * A.transpose() + B - B.transpose(), MatrixXd::Zero(m, m)));  // flutter
        look(A - 3 * MatrixXd::Identity(m, m));
        MatrixXd reactions = A.cwiseAbs();
        reactions.diagonal().setZero();
        reactions.diagonal() = -reactions.colwise().sum();
        reactions(0, 0) += 1;
        look(reactions);
    }
    BOOST_TEST(proved > 200);
    BOOST_TEST(refused > 200);
    // Weights prove what no sum shows: a cascade whose loop amplifies by 1/10, and one by 10, with the eigenvalue
    // 10^(1/3) - 1.
    MatrixXd cascade = -MatrixXd::Identity(3, 3);
    cascade(1, 0) = cascade(2, 1) = 1000;
    cascade(0, 2) = 1e-7;
    BOOST_TEST(holds(cascade, 1, 0.01));
    cascade(0, 2) = -1e-5;
    BOOST_TEST(!holds(cascade, 1, 1.15));
    BOOST_TEST(holds(cascade, 1, 1.16));
}
