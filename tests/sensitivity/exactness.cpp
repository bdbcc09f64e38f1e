// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE exactness
#include <Eigen/SparseCore>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <exception>
#include <random>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/linear/sparse_blocks.hpp>
#include <stagecraft/sensitivity/adjoint.hpp>
#include <stagecraft/sensitivity/forward.hpp>
#include <stdexcept>
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

namespace {

// Not generic: what it brings is all there is. `wrong`: 1 an entry of J, 2 one of F, is left out.
struct prey {
    int wrong = 0;
    void operator()(double, const Vector2d& y, const Vector2d& p, Vector2d& f) const {
        f << p[0] * y[0] - p[1] * y[0] * y[1], -y[1] + y[0] * y[1];
    }
    void jacobian(double, const Vector2d& y, const Vector2d& p, Matrix2d& J) const {
        J << p[0] - p[1] * y[1], -p[1] * y[0], wrong == 1 ? 0 : y[1], -1 + y[0];
    }
    void parameter_jacobian(double, const Vector2d& y, const Vector2d&, Matrix2d& F) const {
        F << y[0], wrong == 2 ? 0 : -y[0] * y[1], 0, 0;
    }
};
// The same with its products by transposed matrices alone.
struct prey_by_products : prey {
    void parameter_jacobian() const = delete;
    void parameter_adjoint(double, const Vector2d& y, const Vector2d&, const Vector2d& v, Vector2d& q) const {
        q << y[0] * v[0], wrong == 2 ? 0 : -y[0] * y[1] * v[0];
    }
};
// The same by differences within a pattern.
struct prey_in_a_pattern {
    int wrong = 0;
    void operator()(double, const VectorXd& y, const Vector2d& p, VectorXd& f) const {
        f.resize(2);
        f << p[0] * y[0] - p[1] * y[0] * y[1], -y[1] + y[0] * y[1];
    }
    Eigen::SparseMatrix<double> sparsity() const {
        Eigen::SparseMatrix<double> s(2, 2);
        s.insert(0, 0) = s.insert(1, 1) = s.insert(1, 0) = 1;
        if (wrong == 0) s.insert(0, 1) = 1;
        return s;
    }
    void parameter_jacobian(double, const VectorXd& y, const Vector2d&,
                            Eigen::SparseMatrix<double>& F) const {
        F.coeffRef(0, 0) = y[0];
        F.coeffRef(0, 1) = -y[0] * y[1];
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(matrices_that_disagree_with_f_end_the_run) {
    const Vector2d y0(1.5, 1), p(1, 1);
    const VectorXd y0_sparse = y0;
    const sc::options<double> o{.rtol = 1e-9, .atol = 1e-9};
    const auto g = [](const auto& y) { return y[0]; };
    const auto at = [&](double a, double b) {  // by integrate() alone
        const auto f = [&](double, const Vector2d& y, Vector2d& out) { prey{}(0, y, Vector2d(a, b), out); };
        return sc::integrate(radau, f, y0, 0, 5, {.rtol = 1e-13, .atol = 1e-13}).y;
    };
    Matrix2d exact;  // differences of order 4
    const double d = 1e-3;
    exact.col(0) = (8 * (at(1 + d, 1) - at(1 - d, 1)) - at(1 + 2 * d, 1) + at(1 - 2 * d, 1)) / (12 * d);
    exact.col(1) = (8 * (at(1, 1 + d) - at(1, 1 - d)) - at(1, 1 + 2 * d) + at(1, 1 - 2 * d)) / (12 * d);
    const auto judge = [&](const auto& problem, const auto& start) {
        const auto r = sc::adjoint_gradient(radau, problem, start, p, 0, 5, g, o);
        BOOST_TEST((r.status == (problem.wrong ? sc::status::wrong_derivative : sc::status::success)));
        BOOST_TEST(r.message.empty() == (problem.wrong == 0));
        if (r.ok()) BOOST_TEST(distance(r.dp.transpose(), exact.row(0)) < 1e-7);
        if constexpr (!std::is_same_v<std::decay_t<decltype(problem)>, prey_by_products>) {
            const auto S = sc::sensitivities(radau, problem, start, p, 0, 5, o);
            BOOST_TEST((S.status == (problem.wrong ? sc::status::wrong_derivative : sc::status::success)));
            BOOST_TEST((S.message.find("component") == std::string::npos) == (problem.wrong == 0));
            if (S.ok()) BOOST_TEST(distance(S.S, exact) < 1e-7);
        }
    };
    for (const int wrong : {0, 1, 2}) {
        judge(prey{wrong}, y0);
        judge(prey_by_products{{wrong}}, y0);
    }
    for (const int wrong : {0, 1}) judge(prey_in_a_pattern{wrong}, y0_sparse);
}

namespace {

// f = A g(y) + B p^2, g with kinks, jumps and steep slopes, and noise in f.
struct rough {
    MatrixXd A, B;
    int kind;
    double noise;
    VectorXd g(const VectorXd& y) const {
        if (kind == 0) return (3 * y).array().sin();
        if (kind == 1) return (y.array() - 0.3).abs();
        if (kind == 2) return (5 * y).array().exp();
        return (20 * y).array().floor() / 20;
    }
    VectorXd slope(const VectorXd& y) const {
        if (kind == 0) return 3 * (3 * y).array().cos();
        if (kind == 1) return (y.array() < 0.3).select(VectorXd::Constant(y.size(), -1), 1);
        if (kind == 2) return 5 * (5 * y).array().exp();
        return VectorXd::Zero(y.size());
    }
    void operator()(double, const VectorXd& y, const VectorXd& p, VectorXd& f) const {
        f = A * g(y) + B * p.cwiseAbs2();
        for (int i = 0; i < f.size(); ++i) f[i] *= 1 + noise * std::sin(1e12 * (y.sum() + i));
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(right_matrices_are_not_refuted_and_wrong_ones_mostly_are) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    const auto any = [&](int n, int m) {
        return MatrixXd(MatrixXd::NullaryExpr(n, m, [&] { return normal(random); }));
    };
    int missing = 0, seen = 0;
    for (int run = 0; run < 2000; ++run) {
        const int n = 2 + run % 5, m = 1 + run % 3;
        const rough f{any(n, n), any(n, m), run % 4, run % 3 == 0 ? 1e-10 : 0};
        VectorXd y = any(n, 1);
        const VectorXd p = any(m, 1);
        if (run % 7 == 0) y[0] = 0.3;  // at a kink
        const sc::at_parameters<rough, VectorXd> problem(f, p);
        MatrixXd J = f.A * f.slope(y).asDiagonal();
        const MatrixXd F = 2 * f.B * p.asDiagonal();
        sc::derivative_check<double> check(y, p);
        BOOST_TEST(check(problem, 0.0, y, J, F, sc::options<double>()).empty());
        const int i = run % n, j = (run + 1) % n;
        if (!(std::abs(J(i, j) * y[j]) > 0.1 * J.row(i).cwiseAbs().dot(y.cwiseAbs()))) continue;
        ++missing;
        J(i, j) = 0;
        bool found = false;
        for (int look = 0; look < 5; ++look)
            found = found || !check(problem, 0.0, y, J, F, sc::options<double>()).empty();
        seen += found ? 1 : 0;
    }
    BOOST_TEST_MESSAGE(seen << " of " << missing << " seen");
    BOOST_TEST(missing > 300);
    BOOST_TEST(seen > 0.9 * missing);
}

namespace {

// kind 0: y' = -a z, 0 = z - b y, so that y = e^{-abt}, with z in its place or (kind 1) M = [1 -1; -1 1], f = (-c(y - z),
// c(y - z) + (z + y - b)): the sum of both equations is algebraic and, with u = y - z, 2u' = -2cu - (z + y - b).
struct index_one {
    int kind;
    template <class T, class Y, class P, class F>
    void operator()(const T&, const Y& y, const P& p, F& f) const {
        if (kind == 0)
            f << -p[0] * y[1], y[1] - p[1] * y[0];
        else
            f << -p[0] * (y[0] - y[1]), p[0] * (y[0] - y[1]) + (y[0] + y[1] - p[1]);
    }
    Matrix2d mass() const {
        if (kind == 0) return Vector2d(1, 0).asDiagonal();
        return (Matrix2d() << 1, -1, -1, 1).finished();
    }
};

}  // namespace

// R(infinity) = -1 and 1: what a start leaves in algebraic components stays there.
BOOST_AUTO_TEST_CASE(algebraic_components_of_S_start_consistently_in_methods_that_do_not_forget) {
    const double a = 2, b = 0.75, y = std::exp(-a * b);
    Matrix2d exact;
    exact << -b * y, -a * y, -b * b * y, y - a * b * y;
    // Kind 1: y + z = b, y - z = u = e^{-at} u0.
    const double u = std::exp(-a);
    Matrix2d sum;
    sum << -u / 2, 0.5, u / 2, 0.5;
    const auto judge = [&](const auto& method) {
        for (const int kind : {0, 1}) {
            const Vector2d p(a, b), start = kind == 0 ? Vector2d(1, b) : Vector2d((b + 1) / 2, (b - 1) / 2);
            const Matrix2d& right = kind == 0 ? exact : sum;
            const sc::options<double> o{.rtol = 1e-7, .atol = 1e-7};
            const auto r = sc::sensitivities(method, index_one{kind}, start, p, 0, 1, o);
            BOOST_TEST(r.ok());
            BOOST_TEST(distance(r.S, right) < 1e-7);
            for (const int i : {0, 1}) {
                const auto g = [i](const auto& end) { return end[i]; };
                const auto back = sc::adjoint_gradient(method, index_one{kind}, start, p, 0, 1, g, o);
                BOOST_TEST(back.ok());
                BOOST_TEST(distance(back.dp.transpose(), right.row(i)) < 3e-7);  // the steps are those of y
            }
        }
    };
    judge(sc::gauss<3>());
    judge(radau);
}

namespace {

// M(p) y' = -y with M = diag(p_0, p_1 + p_0^2): y_i = e^{-t/m_i}.
struct inertia {
    template <class T, class Y, class P, class F>
    void operator()(const T&, const Y& y, const P&, F& f) const {
        f = -y;
    }
    template <class P>
    auto mass(const P& p) const {
        Eigen::Matrix<typename P::Scalar, 2, 2> M;
        M << p[0], 0.0, 0.0, p[1] + p[0] * p[0];
        return M;
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(the_mass_matrix_may_depend_on_the_parameters) {
    const double a = 2, b = 1, m = b + a * a, y = std::exp(-1 / a), z = std::exp(-1 / m);
    Matrix2d exact;
    exact << y / (a * a), 0, z / (m * m) * 2 * a, z / (m * m);
    for (const double tol : {1e-5, 1e-8}) {
        const sc::options<double> o{.rtol = tol, .atol = tol};
        const auto r = sc::sensitivities(radau, inertia{}, Vector2d(1, 1), Vector2d(a, b), 0, 1, o);
        BOOST_TEST(r.ok());
        BOOST_TEST(distance(r.S, exact) < tol);
        const auto g = [](const auto& end) { return end[0] + 3 * end[1]; };
        const auto back = sc::adjoint_gradient(radau, inertia{}, Vector2d(1, 1), Vector2d(a, b), 0, 1, g, o);
        BOOST_TEST(back.ok());
        BOOST_TEST(distance(back.dp.transpose(), exact.row(0) + 3 * exact.row(1)) < 4 * tol);
    }
}

namespace {

// y' = -p_0 y, z' = p_1: y = e^{-p_0 t}, z = p_1 t.
struct decay {
    template <class T, class Y, class P, class F>
    void operator()(const T&, const Y& y, const P& p, F& f) const {
        f << -p[0] * y[0], p[1];
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(sums_over_data_and_integrals_are_differentiated_together) {
    const double a = 1.3, b = 0.5;
    const std::vector<double> times{0, 0.5, 0.5, 1.25, 2};
    const auto misfit = [&](std::size_t j, const auto& y) { return (1.0 + double(j)) * y[0] * y[0]; };
    const auto running = [](const auto& t, const auto& y, const auto& p) { return t * y[0] + p[1] * y[1]; };
    const auto last = [](const auto& y, const auto& p) { return p[0] * y[1]; };
    double sum = 0, by_a = 0, by_y = 0;
    for (std::size_t j = 0; j < times.size(); ++j) {
        const double y = std::exp(-a * times[j]);
        sum += (1.0 + double(j)) * y * y;
        by_a -= (1.0 + double(j)) * 2 * times[j] * y * y;
        by_y += (1.0 + double(j)) * 2 * y * y;
    }
    // The integral of t e^{-at} over [0, 2] is I(a), and that of p_1 z is 2 b^2.
    const auto I = [](double x) { return (1 - (1 + 2 * x) * std::exp(-2 * x)) / (x * x); };
    const double slope = 4 * std::exp(-2 * a) / a - 2 * I(a) / a;
    for (const double tol : {1e-5, 1e-9}) {
        const auto r = sc::adjoint_gradient(
            radau, decay{}, Vector2d(1, 0), Vector2d(a, b), 0, 2,
            std::tuple(sc::sum_over(times, misfit), sc::integral_of(running), sc::at_end(last)),
            {.rtol = tol, .atol = tol});
        BOOST_TEST(r.ok());
        BOOST_TEST(distance(r.value, Eigen::Vector3d(sum, I(a) + 2 * b * b, a * 2 * b)) < 100 * tol);
        Eigen::Matrix<double, 2, 3> dp, dy0;
        dp << by_a, slope, 2 * b, 0, 4 * b, 2 * a;
        dy0 << by_y, I(a), 0, 0, 2 * b, a;
        BOOST_TEST(distance(r.dp, dp) < 100 * tol);
        BOOST_TEST(distance(r.dy0, dy0) < 100 * tol);
        BOOST_TEST(r.dp_error.maxCoeff() < 100 * tol);
    }
    BOOST_CHECK_THROW(sc::adjoint_gradient(radau, decay{}, Vector2d(1, 0), Vector2d(a, b), 0, 1,
                                           sc::sum_over(times, misfit)),
                      std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(S_is_kept_at_given_times) {
    const double a = 1.3, b = 0.5;
    sc::sensitivity_options<Vector2d, Vector2d> s;
    s.times = {0, 0.3, 0.3, 1.1, 2};
    const auto r = sc::sensitivities(radau, decay{}, Vector2d(1, 0), Vector2d(a, b), 0, 2,
                                     {.rtol = 1e-8, .atol = 1e-8}, s);
    BOOST_TEST_REQUIRE(r.S_at.size() == s.times.size());
    for (std::size_t k = 0; k < s.times.size(); ++k) {
        const double t = s.times[k], y = std::exp(-a * t);
        Matrix2d exact;
        exact << -t * y, 0, 0, t;
        BOOST_TEST(distance(r.S_at[k], exact) < 1e-6);  // of the continuous solution
        BOOST_TEST(distance(r.y_at[k], Vector2d(y, b * t)) < 1e-6);
    }
    s.times = {1, 0.5};
    BOOST_CHECK_THROW(sc::sensitivities(radau, decay{}, Vector2d(1, 0), Vector2d(a, b), 0, 2, {}, s),
                      std::invalid_argument);
}

namespace {

// kind 0: a ball, y'' = -p_0, that bounces with restitution p_1. kind 1: y' = 1, and 2 from y = p_0 on. kind 2: y'' = -p_0^2 y.
struct hybrid {
    int kind;
    bool beyond = false;
    template <class T, class Y, class P, class F>
    void operator()(const T&, const Y& y, const P& p, F& f) const {
        if (kind == 0) f << y[1], -p[0];
        if (kind == 1) f << (beyond ? 2.0 : 1.0), -p[1] * y[1];
        if (kind == 2) f << y[1], -p[0] * p[0] * y[0];
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(S_jumps_where_the_solution_or_its_equation_does) {
    const auto leaves_state = sc::detail::no_jump();
    const auto floor = sc::sensitivity_event(
        [](const auto&, const auto& y, const auto&) { return y[0]; }, {.direction = sc::crossing::falling},
        [](const auto&, const auto& y, const auto& p, auto& after) { after << 0 * y[0], -p[1] * y[1]; });
    const auto threshold =
        sc::sensitivity_event([](const auto&, const auto& y, const auto& p) { return y[0] - p[0]; }, {},
                              leaves_state, [](auto& problem) { problem.beyond = true; });
    const auto end = sc::sensitivity_event([](const auto& t, const auto&, const auto& p) { return t - p[1]; },
                                           {.terminal = true});
    const auto without_slope =
        sc::sensitivity_event([](const auto&, const auto& y, const auto&) { return y[0] * y[0] * y[0]; });
    for (const double tol : {1e-5, 1e-8}) {
        const sc::options<double> o{.rtol = tol, .atol = tol};
        // From rest at 1 with G = 8 the floor is met at t1 = sqrt(2/G) = 1/2 and again at t1 (1 + 2e) = 1.3.
        const double G = 8, e = 0.8, t1 = std::sqrt(2 / G), rest = 1 - t1, v = e * G * t1;
        const auto ball = sc::sensitivities_with_events(radau, hybrid{0}, Vector2d(1, 0), Vector2d(G, e), 0,
                                                        1, std::tuple(floor), o);
        BOOST_TEST(ball.ok());
        BOOST_TEST_REQUIRE(ball.events.size() == 1);
        const double dt = -t1 / (2 * G), dv = e * t1 / 2;  // by G
        BOOST_TEST(std::abs(ball.events[0].dt[0] - dt) < tol);
        Matrix2d exact;
        exact << dv * rest - v * dt - rest * rest / 2 + G * rest * dt, G * t1 * rest, dv - rest + G * dt,
            G * t1;
        BOOST_TEST(distance(ball.S, exact) < tol);
        // y = p_0 + 2 (t - p_0).
        const auto step = sc::sensitivities_with_events(radau, hybrid{1}, Vector2d(0, 1), Vector2d(0.5, 2), 0,
                                                        1, std::tuple(threshold), o);
        BOOST_TEST(step.ok());
        BOOST_TEST(distance(step.S, (Matrix2d() << -1, 0, 0, -std::exp(-2)).finished()) < tol);
        // The end is at p_1: y = cos(p_0 p_1).
        const auto half = sc::sensitivities_with_events(radau, hybrid{2}, Vector2d(1, 0), Vector2d(3, 0.7), 0,
                                                        2, std::tuple(end), o);
        BOOST_TEST((half.status == sc::status::event));
        BOOST_TEST(std::abs(half.t - 0.7) < 1e-12);
        BOOST_TEST(std::abs(half.events[0].dy(0, 0) + 0.7 * std::sin(2.1)) < tol);
        BOOST_TEST(std::abs(half.events[0].dy(0, 1) + 3 * std::sin(2.1)) < 3 * tol);
        // Both at once, in their order.
        const auto both = sc::sensitivities_with_events(radau, hybrid{1}, Vector2d(0, 1), Vector2d(0.5, 0.75),
                                                        0, 1, std::tuple(end, threshold), o);
        BOOST_TEST_REQUIRE(both.events.size() == 2);
        BOOST_TEST(both.events[0].event == 1);
        BOOST_TEST(distance(both.events[1].dy.row(0), Eigen::RowVector2d(-1, 2)) < tol);
        // Where g passes zero without a slope, its time has no derivative.
        const auto touch = sc::sensitivities_with_events(radau, hybrid{2}, Vector2d(-1, 0), Vector2d(3, 0.7),
                                                         0, 2, without_slope, o);
        BOOST_TEST((touch.status == sc::status::function_threw));
        BOOST_CHECK_THROW(std::rethrow_exception(touch.exception), std::domain_error);
    }
}

namespace {

long calls = 0;
// A rod with a source in every cell.
struct rod {
    int n;
    template <class T, class Y, class P, class F>
    void operator()(const T&, const Y& u, const P& p, F& f) const {
        ++calls;
        const double r = (n + 1.0) * (n + 1.0);
        for (int i = 0; i < n; ++i) {
            f[i] = p[i] - 2 * r * u[i];
            if (i > 0) f[i] += r * u[i - 1];
            if (i + 1 < n) f[i] += r * u[i + 1];
        }
    }
    Eigen::SparseMatrix<double> sparsity() const {
        Eigen::SparseMatrix<double> s(n, n);
        for (int j = 0; j < n; ++j)
            for (int i = std::max(0, j - 1); i < std::min(n, j + 2); ++i) s.insert(i, j) = 1;
        return s;
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(the_adjoints_cost_does_not_grow_with_the_number_of_parameters) {
    long few = 0;
    for (const int n : {100, 800}) {
        calls = 0;
        const auto g = [n](const auto& y) { return y[n / 2]; };
        const auto r =
            sc::adjoint_gradient(radau, rod{n}, VectorXd(VectorXd::Zero(n)), VectorXd(VectorXd::Ones(n)), 0,
                                 1, g, {.rtol = 1e-6, .atol = 1e-9});
        BOOST_TEST(r.ok());
        // u(1) is, but for e^{-pi^2}, the steady state, of which the Green's function is x (1 - y) for x < y.
        const double x = (n / 2 + 1) / (n + 1.0), left = 10 / (n + 1.0), modes = 2 * std::exp(-M_PI * M_PI);
        BOOST_TEST(std::abs(r.dp[9] * (n + 1) - left * (1 - x)) < modes);
        if (n == 100) few = calls;
        BOOST_TEST_MESSAGE("n = m = " << n << ": " << r.report.f << " calls in the run, " << calls
                                      << " in all");
    }
    BOOST_TEST(calls < 2 * few);
}
