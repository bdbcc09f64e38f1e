// SPDX-License-Identifier: BSL-1.0
// Sections 4.1, 4.2 and 4.4: linear problems, their condition numbers and dichotomies.
#include "../lecture/portrait.hpp"
#include "experiments.hpp"

namespace boundary_values {

namespace {

MatrixXd matrix(const std::vector<std::vector<double>>& rows) {
    MatrixXd m(rows.size(), rows[0].size());
    for (Eigen::Index i = 0; i < m.rows(); ++i)
        for (Eigen::Index j = 0; j < m.cols(); ++j) m(i, j) = rows[i][j];
    return m;
}

linear_rhs constant(const MatrixXd& A) {
    return {[A](double) { return A; }, [n = A.rows()](double) { return VectorXd(VectorXd::Zero(n)); }};
}

const MatrixXd rotation = matrix({{0, 1}, {-1, 0}});
const linear_rhs oscillator = constant(rotation);

/// x_1(0) = 0, x_1(T) = beta.
linear_conditions ends(double beta) {
    return {matrix({{1, 0}, {0, 0}}), matrix({{0, 0}, {1, 0}}), Eigen::Vector2d(0, beta)};
}
linear_conditions periodic(Eigen::Index n) {
    return {MatrixXd::Identity(n, n), -MatrixXd::Identity(n, n), VectorXd::Zero(n)};
}

/// Orbits in the plane.
template <class F>
lecture::picture plane(const std::string& name, const std::string& title, const F& f,
                       const std::vector<theory::state<double, 2>>& starts, double end,
                       const plot::window& view, const std::vector<plot::complex>& equilibria) {
    std::vector<plot::curve> all;
    for (const auto& x : starts) all.push_back(lecture::solution<2>(f, x, end, 400, 1e3, true));
    return lecture::portrait(name, title, all, view, equilibria);
}

}  // namespace

chapter conditioning() {
    chapter out;
    bool all_kappa = true;
    for (int k = 1; k <= 14; ++k) {
        const double T = pi * (1 - std::pow(10.0, -k)), gap = (pi - T) + beyond_pi;
        const double kappa1 = 1 / (std::sqrt(2.0) * std::sin(gap / 2)), kappa2 = 1 / std::sin(gap);
        const auto r = solve(oscillator, ends(1), T, {.rtol = 1e-6});
        const double eps = 20 * std::numeric_limits<double>::epsilon() * kappa1;
        const bool agrees = near(r.conditioning.kappa1, kappa1, 1e-5 + eps) &&
                            near(r.conditioning.kappa2, kappa2, 1e-5 + eps) &&
                            (r.ok() || kappa1 * std::numeric_limits<double>::epsilon() > 1e-10);
        all_kappa = all_kappa && agrees;
        out.find("4.1, T = pi (1 - 1e-" + std::to_string(k) + "): kappa1, kappa2, status", "finite",
                 number(r.conditioning.kappa1, "%.5g") + ", " + number(r.conditioning.kappa2, "%.5g") + ", " +
                     name(r.status),
                 number(kappa1, "%.5g") + ", " + number(kappa2, "%.5g"), agrees);
    }
    const auto many = solve(oscillator, ends(0), 2 * pi, {.rtol = 1e-10});
    const auto none = solve(oscillator, ends(1), 2 * pi, {.rtol = 1e-10});
    out.find("4.1, T = 2 pi, beta = 0", "c2 (sin t, cos t)",
             std::string(name(many.status)) + ", kernel " + std::to_string(many.kernel),
             "not_isolated, kernel 1", many.status == bvp_status::not_isolated && many.kernel == 1);
    out.find("4.1, T = 2 pi, beta = 1", "no solution", name(none.status), "singular",
             none.status == bvp_status::singular);
    std::vector<plot::curve> sines(3);
    for (int c = 1; c <= 3; ++c)
        for (int k = 0; k <= 200; ++k)
            sines[c - 1].points.emplace_back(pi * k / 100, c * std::sin(pi * k / 100));
    out.pictures.push_back(lecture::curves("p60_family", "c sin t: zero at 0 and at 2 π", sines,
                                           {0, 2 * pi, -3.3, 3.3}, "t", "x_1", {"c = 1", "c = 2", "c = 3"}));
    return out;
}

chapter dichotomy() {
    chapter out;
    using problem = theory::linear_two_point<double>;
    const problem three{
        [](double t) { return MatrixXd(Eigen::Vector3d(std::exp(-2 * t), 1, std::exp(3 * t)).asDiagonal()); },
        0, 4, MatrixXd::Identity(3, 3), MatrixXd::Zero(3, 3)};
    for (const double middle : {1.0, 0.0}) {
        const MatrixXd P = Eigen::Vector3d(1, middle, 0).asDiagonal();
        // The constant solution belongs to either space, and takes alpha or beta with it.
        const double alpha = middle == 1 ? 0 : 2, beta = middle == 1 ? 3 : 0;
        const double K = theory::dichotomy_constant<double>(three, P, alpha, beta, 40);
        const double printed = theory::dichotomy_constant<double>(three, P, 2, 3, 40);
        const double growth = std::exp((middle == 1 ? 2 : 3) * 4.0);
        const std::string which = "diag(-2, 0, 3), P = diag(1, " + number(middle) + ", 0): ";
        out.find(which + "K for alpha = " + number(alpha) + ", beta = " + number(beta), "1", number(K), "1",
                 near(K, 1, 1e-12));
        out.find(which + "K for alpha = 2, beta = 3 on [0, 4] (misprint)", "1", number(printed, "%.5g"),
                 number(growth, "%.5g") + ": not exponentially", near(printed, growth, 1e-10));
    }
    for (const double eps : {1.0, 0.5, 0.1}) {
        const problem turning{
            [eps](double t) {
                return MatrixXd(Eigen::Vector2d(std::exp((1 - t * t) / eps), std::exp(t + 1)).asDiagonal());
            },
            -1, 3, MatrixXd::Identity(2, 2), MatrixXd::Zero(2, 2)};
        // Printed as an equation that is not dichotomic; it is, exponentially, for every alpha.
        for (const double alpha : {0.0, 3.0}) {
            const double K =
                theory::dichotomy_constant<double>(turning, Eigen::Vector2d(1, 0).asDiagonal(), alpha, 1, 80);
            const double exact = std::exp(std::pow(1 + alpha * eps / 2, 2) / eps);
            out.find("turning point, epsilon = " + number(eps) + ": K for alpha = " + number(alpha) +
                         " (misprint)",
                     "none", number(K, "%.6g"),
                     "e^((1 + alpha epsilon/2)^2/epsilon) = " + number(exact, "%.6g"), near(K, exact, 1e-10));
        }
    }
    const auto turning = [](const auto& t, const auto& x, auto& f) {
        f[0] = -2 * (t - 1) * x[0];  // from t = -1 on
        f[1] = x[1];
    };
    out.pictures.push_back(plane("p66_turning_point",
                                 "x_1' = -2 t x_1, x_2' = x_2 from t = -1: x_1 grows, then decays", turning,
                                 {{1, 1}, {2, 1}, {3, 1}}, 2.5, {0, 9, 0, 10}, {{0, 0}}));
    return out;
}

chapter forced_oscillation() {
    chapter out;
    const auto forced = [](double alpha) {
        return linear_rhs{[alpha](double) { return MatrixXd(MatrixXd::Constant(1, 1, alpha)); },
                          [](double t) { return VectorXd(VectorXd::Constant(1, std::sin(t))); }};
    };
    for (const double alpha : {0.25, 1e-8, -1e-8, 50.0, -50.0}) {
        const double tolerance = std::abs(alpha) == 1e-8 ? 1e-6 : 1e-10;
        const auto r = solve(forced(alpha), periodic(1), 2 * pi, {.rtol = tolerance});
        const double x0 = -1 / (1 + alpha * alpha), kappa = -1 / std::expm1(-2 * pi * std::abs(alpha));
        double error = 0;
        for (int k = 0; k <= 100; ++k) {
            const double t = k < 100 ? 2 * pi * k / 100 : r.y.t1(),
                         exact = x0 * (alpha * std::sin(t) + std::cos(t));
            error = std::max(error, std::abs(r.y(t)[0] - exact));
        }
        const std::string which = "x' = alpha x + sin t, alpha = " + number(alpha) + ": ";
        out.find(which + "x(0), status", alpha == 0.25 ? "-16/17" : "-1/(1 + alpha^2)",
                 number(r.y(0)[0], "%.7g") + std::string(", ") + name(r.status), number(x0, "%.7g"),
                 r.ok() && error <= tolerance);
        const double slack = 1e-5 + 100 * std::numeric_limits<double>::epsilon() * kappa;
        out.find(which + "kappa1, kappa2", "-",
                 number(r.conditioning.kappa1, "%.6g") + ", " + number(r.conditioning.kappa2, "%.6g"),
                 number(kappa, "%.6g"),
                 near(r.conditioning.kappa1, kappa, slack) && near(r.conditioning.kappa2, kappa, slack));
    }
    const auto all = solve(oscillator, periodic(2), 2 * pi, {.rtol = 1e-10});
    out.find("harmonic oscillator, periodic, T = 2 pi", "M = 0",
             std::string(name(all.status)) + ", kernel " + std::to_string(all.kernel),
             "not_isolated, kernel 2", all.status == bvp_status::not_isolated && all.kernel == 2);
    const auto quarter = [](const auto& t, const auto& x, auto& f) {
        using std::sin;
        f[0] = x[0] / 4 + sin(t);
    };
    std::vector<plot::curve> all_forced;
    for (const double x : {-1.5, -16.0 / 17, 0.0})
        all_forced.push_back(lecture::solution<1>(quarter, theory::state<double, 1>(x), 8, 400, 1e3));
    out.pictures.push_back(lecture::curves("p72_forced", "x' = x/4 + sin t", all_forced, {0, 8, -8, 8}, "t",
                                           "x", {"x(0) = -3/2", "x(0) = -16/17, periodic", "x(0) = 0"}));
    const auto harmonic = [](const auto&, const auto& x, auto& f) { f[0] = x[1], f[1] = -x[0]; };
    out.pictures.push_back(plane("p73_harmonic", "x' = (x_2, -x_1): every solution is periodic", harmonic,
                                 {{1, 0}, {2, 0}, {3, 0}}, 2 * pi, {-3.3, 3.3, -3.3, 3.3}, {{0, 0}}));
    return out;
}

}  // namespace boundary_values
