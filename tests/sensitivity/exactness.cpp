// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE exactness
#include <Eigen/SparseCore>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/linear/sparse_blocks.hpp>
#include <stagecraft/sensitivity/adjoint.hpp>
#include <stagecraft/sensitivity/forward.hpp>
#include <string>
#include <tuple>
#include <unsupported/Eigen/MatrixFunctions>
#include <vector>

// What S and gradients are where y alone is right: with approximate Jacobians, at rest, with inconsistent starts, across
// events. Truth: closed forms.
namespace sc = stagecraft;
using Eigen::Matrix2d, Eigen::MatrixXd, Eigen::Vector2d, Eigen::VectorXd;

namespace {

const auto radau = sc::radau_iia<3>();
double distance(const MatrixXd& a, const MatrixXd& b) { return (a - b).cwiseAbs().maxCoeff(); }

// y' = (A + p_0 B + p_1 C) y, whose S is exp of a block triangular matrix; the Jacobian of the problem's own is off by `off`.
struct linear {
    MatrixXd A, B, C, off;
    template <class T, class Y, class P, class F>
    void operator()(const T&, const Y& y, const P& p, F& f) const {
        for (int i = 0; i < y.size(); ++i) {
            f[i] = 0;
            for (int j = 0; j < y.size(); ++j) f[i] += (A(i, j) + p[0] * B(i, j) + p[1] * C(i, j)) * y[j];
        }
    }
    void jacobian(double, const VectorXd&, const VectorXd& p, MatrixXd& J) const {
        J = A + p[0] * B + p[1] * C + off;
    }
    MatrixXd exact(const VectorXd& y0, const VectorXd& p, double t) const {
        const auto n = y0.size();
        const MatrixXd M = A + p[0] * B + p[1] * C;
        MatrixXd S(n, 2);
        for (int k = 0; k < 2; ++k) {
            MatrixXd both = MatrixXd::Zero(2 * n, 2 * n);
            both.topLeftCorner(n, n) = both.bottomRightCorner(n, n) = M * t;
            both.bottomLeftCorner(n, n) = (k == 0 ? B : C) * t;
            S.col(k) = both.exp().bottomLeftCorner(n, n) * y0;
        }
        return S;
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(S_and_gradient_are_exact_whatever_the_jacobian_is) {
    std::mt19937 random(40);
    std::normal_distribution<double> normal;
    const auto any = [&](int n) {
        return MatrixXd(MatrixXd::NullaryExpr(n, n, [&] { return normal(random); }));
    };
    for (int run = 0; run < 40; ++run) {
        const int n = 2 + run % 4;
        linear f{any(n), any(n), any(n), {}};
        f.off = MatrixXd::Zero(n, n);
        const VectorXd y0 = any(n).col(0), p = VectorXd(Vector2d(normal(random), normal(random)));
        const MatrixXd J = f.A + p[0] * f.B + p[1] * f.C;
        if (run % 3 == 0) f.off(run % n, (run + 1) % n) = -J(run % n, (run + 1) % n);  // an entry is missing
        if (run % 3 == 1) f.off = -0.3 * J.cwiseProduct(any(n).cwiseMin(1).cwiseMax(-1));
        if (run % 3 == 2) f.off = J.diagonal().asDiagonal().toDenseMatrix() - J;  // the diagonal alone
        const MatrixXd exact = f.exact(y0, p, 1);
        const double size = 1 + exact.cwiseAbs().maxCoeff();
        const auto r = sc::sensitivities(radau, f, y0, p, 0, 1, {.rtol = 1e-8, .atol = 1e-8});
        BOOST_TEST(r.ok());
        BOOST_TEST(distance(r.S, exact) < 1e-7 * size);
        const auto g =
            sc::adjoint_gradient(radau, f, y0, p, 0, 1, [](const auto& y) { return y[0] - 2 * y[1]; },
                                 {.rtol = 1e-8, .atol = 1e-8});
        const VectorXd expected = (exact.row(0) - 2 * exact.row(1)).transpose();
        BOOST_TEST(g.ok());
        BOOST_TEST(distance(g.dp, expected) < 1e-7 * size);
        BOOST_TEST(g.dp_error.maxCoeff() < 1e-6 * size);
    }
}

namespace {

// y'' = -2500 y + p sin 40t from rest, so that y = 0 where p = 0 and dy/dp is a beat.
struct at_rest {
    template <class T, class Y, class P, class F>
    void operator()(const T& t, const Y& y, const P& p, F& f) const {
        using std::sin;
        f << y[1], -2500 * y[0] + (p[0] + p[1]) * sin(40 * t);
    }
};
double beat(double t) { return (std::sin(40 * t) - 0.8 * std::sin(50 * t)) / 900; }

}  // namespace

BOOST_AUTO_TEST_CASE(S_is_controlled_where_y_is_at_rest) {
    for (const double tol : {1e-4, 1e-6, 1e-8}) {
        const sc::options<double> o{.rtol = tol, .atol = tol};
        const auto r = sc::sensitivities(radau, at_rest{}, Vector2d(0, 0), Vector2d(0, 0), 0, 1, o);
        BOOST_TEST(r.ok());
        BOOST_TEST(std::abs(r.S(0, 0) - beat(1)) < tol);
        // Where only changes of a millionth matter, the tolerances of S are a million times larger.
        sc::sensitivity_options<Vector2d, Vector2d> coarse, none;
        coarse.scale = {1e-6, 1e-6};
        none.control = false;
        const auto few = sc::sensitivities(radau, at_rest{}, Vector2d(0, 0), Vector2d(0, 0), 0, 1, o, coarse);
        BOOST_TEST(few.report.steps < r.report.steps);
        const auto fewest =
            sc::sensitivities(radau, at_rest{}, Vector2d(0, 0), Vector2d(0, 0), 0, 1, o, none);
        BOOST_TEST(fewest.report.steps < 10);
    }
}

BOOST_AUTO_TEST_CASE(the_gradients_error_is_about_what_its_estimate_says) {
    const auto g = [](const auto& y) { return y[0]; };
    for (const double step : {0.0, 0.05, 0.02, 0.01, 0.005, 0.0025}) {
        sc::options<double> o{.rtol = 1e-8, .atol = 1e-8};
        o.max_step = step;
        const auto r = sc::adjoint_gradient(radau, at_rest{}, Vector2d(0, 0), Vector2d(0, 0), 0, 1, g, o);
        BOOST_TEST(r.ok());
        const double error = std::abs(r.dp[0] - beat(1));
        BOOST_TEST_MESSAGE(step << ": error " << error << ", estimate " << r.dp_error[0]);
        BOOST_TEST(error < 3 * r.dp_error[0]);
        BOOST_TEST((step == 0 || error > r.dp_error[0] / 3));
    }
}
