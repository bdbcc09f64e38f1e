// SPDX-License-Identifier: BSL-1.0
// Chapter 2: Runge-Kutta methods. Stability functions, contraction, construction, fixed point iteration.
#include <stagecraft/theory/dynamics/contraction.hpp>
#include <stagecraft/theory/plot/pictures.hpp>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <chrono>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/fixed_point.hpp>
#include <stagecraft/integrate.hpp>

#include "lecture.hpp"

namespace lecture {

namespace {

using tableaux::dense;
using tableaux::family;
using tableaux::quadratic;

void draw_stability(chapter& out) {
    const rational half(1, 2);
    const auto named = [](const char* name, const tableau<rational>& t) {
        return plot::named_function{name, plot::in_doubles(theory::stability_function_of(t))};
    };
    const auto explicit_euler = named("explicit Euler", method({{0}}, {1}));
    const auto implicit_euler = named("implicit Euler", method({{1}}, {1}));
    const auto trapezoidal = named("trapezoidal rule", method({{0, 0}, {half, half}}, {half, half}));
    out.pictures.push_back(
        {"p40_real_axis",
         plot::real_axis_picture({explicit_euler, implicit_euler, trapezoidal}, -5, 3, -3, 6)});
    const plot::window lecture{-8, 1, -4, 4}, wide{-80, 80, -80, 80};
    out.pictures.push_back(
        {"p41_explicit_euler", plot::grey_picture(explicit_euler.name, explicit_euler.r, lecture)});
    out.pictures.push_back(
        {"p41_implicit_euler", plot::grey_picture(implicit_euler.name, implicit_euler.r, lecture)});
    out.pictures.push_back(
        {"p41_trapezoidal_rule", plot::grey_picture(trapezoidal.name, trapezoidal.r, lecture)});
    out.pictures.push_back(
        {"p41_trapezoidal_rule_wide", plot::grey_picture(trapezoidal.name, trapezoidal.r, wide)});
}

/// The sector |arg(z) - pi| <= alpha of A(alpha)-stability.
void draw_sector(chapter& out) {
    const double alpha = 50 * 3.141592653589793 / 180;
    plot::curve rays{
        {{-6 * std::cos(alpha), 6 * std::sin(alpha)}, {0, 0}, {-6 * std::cos(alpha), -6 * std::sin(alpha)}},
        false};
    std::vector<plot::patch> inside;
    for (int k = -200; k < 200; ++k) {  // rows: patches overlap upwards
        const double y = 0.02 * k;
        inside.push_back({-4, -std::abs(y + 0.01) / std::tan(alpha), y, y + 0.02, 0});
    }
    plot::curve arc;
    for (double a = 0; a <= alpha; a += alpha / 20)
        arc.points.emplace_back(-1.2 * std::cos(a), 1.2 * std::sin(a));
    plot::script p;
    p.title("The sector of A(α)-stability");
    p.plane({-4, 1, -4, 4});
    p.patches(inside, [](int) { return "#d7e5f3"; })
        .lines({rays}, "lc rgb '#1f4e79' lw 2")
        .lines({arc}, "lc rgb '#b71c1c' lw 2");
    p.label("α", -1.6, 0.45);
    out.pictures.push_back({"p43_sector", std::move(p)});
}

template <class K>
dense<K> product(const dense<K>& a, const dense<K>& b) {
    dense<K> c(a.rows(), b.cols());
    for (Eigen::Index i = 0; i < a.rows(); ++i)
        for (Eigen::Index j = 0; j < b.cols(); ++j) {
            c(i, j) = K(0);
            for (Eigen::Index k = 0; k < a.cols(); ++k) c(i, j) = c(i, j) + a(i, k) * b(k, j);
        }
    return c;
}

/// Radau IA-2 from D(s): as printed, A = V^-T B^-1 (N - C^T) B, and as derived, A = B^-1 V^-T (N - C)^T B.
void construct_radau_ia(chapter& out) {
    const auto t = *tableaux::exact_tableau(family::radau_ia, 2);
    const auto s = t.b.size();
    dense<quadratic> V(s, s), C(s, s), N(s, s), B(s, s);
    for (Eigen::Index i = 0; i < s; ++i) {
        quadratic power(1);
        for (Eigen::Index k = 0; k < s; ++k) {
            const quadratic weight(static_cast<int>(k) + 1);
            V(i, k) = power;
            power = power * t.c[i];
            C(i, k) = power / weight;
            N(i, k) = quadratic(1) / weight;
            B(i, k) = i == k ? t.b[i] : quadratic(0);
        }
    }
    const dense<quadratic> Vt = V.transpose(), Ct = C.transpose(), Nt = N.transpose();
    dense<quadratic> wrong = N, right = Nt;
    for (Eigen::Index i = 0; i < N.size(); ++i) {
        wrong.data()[i] = N.data()[i] - Ct.data()[i];
        right.data()[i] = Nt.data()[i] - Ct.data()[i];
    }
    const auto Vi = *tableaux::inverse<quadratic>(Vt), Bi = *tableaux::inverse<quadratic>(B);
    const auto printed = product(Vi, product(Bi, product(wrong, B)));
    const auto derived = product(Bi, product(Vi, product(right, B)));
    const auto text = [](const dense<quadratic>& a) {
        return "(" + a(0, 0).str() + ", " + a(0, 1).str() + "; " + a(1, 0).str() + ", " + a(1, 1).str() + ")";
    };
    bool same = true, differs = false;
    for (Eigen::Index i = 0; i < t.A.size(); ++i) {
        same = same && derived.data()[i] == t.A.data()[i];
        differs = differs || !(printed.data()[i] == t.A.data()[i]);
    }
    out.find("Radau IA-2 from D(s), B^-1 V^-T (N - C)^T B", "V^-T B^-1 (N - C^T) B", text(derived), text(t.A),
             same);
    out.find("the printed formula gives (misprint)", "Radau IA-2", text(printed), "another matrix", differs);
}

/// The largest h |lambda| for which the fixed point iteration k <- 1 + z A k converges, found by bisection of runs.
double end_of_convergence(const tableau<double>& t) {
    const auto converges = [&](double z) {
        Eigen::VectorXd d = Eigen::VectorXd::LinSpaced(t.b.size(), 1, 2);  // a difference of two iterates
        double logarithm = 0;
        for (int n = 0; n < 400'000; ++n) {
            d = -z * (t.A * d);
            logarithm += std::log(d.norm());
            d.normalize();
        }
        return logarithm < 0;
    };
    double low = 0, high = 100;
    while (high - low > 1e-7) (converges((low + high) / 2) ? low : high) = (low + high) / 2;
    return low;
}

/// Evaluations of f and microseconds in a step.
struct work {
    double evaluations, microseconds;
};

/// 200 steps of Gauss-2 for ten pendulums (|lambda| near 1 on the imaginary axis), stages to 1e-8; zeros
/// where the iteration does not end.
template <class Method>
work work_of(const Method& m, double h) {
    const auto f = [](double, const Eigen::VectorXd& x, Eigen::VectorXd& out) {
        out.head(10) = x.tail(10);
        out.tail(10) = -x.head(10).array().sin();
    };
    const auto begin = std::chrono::steady_clock::now();
    const auto r = integrate(m, f, Eigen::VectorXd::LinSpaced(20, 0.5, 1), 0.0, 200 * h,
                             {.rtol = 1e-8, .atol = 1e-10, .fixed_step = h, .newton_iterations = 20'000});
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    if (!r.ok()) return {0, 0};
    return {static_cast<double>(r.report.f + r.report.f_jacobian) / static_cast<double>(r.report.steps),
            1e6 * seconds.count() / static_cast<double>(r.report.steps)};
}

/// Section 2.4.2: fixed point iteration against Newton's over h |lambda|.
void compare_iterations(chapter& out) {
    plot::curve iterated{{}, false}, newton{{}, false};
    std::string evaluations, times;
    double first = 0, last = 0, largest_newton = 0;
    for (const double h : {0.01, 0.03, 0.1, 0.3, 1.0, 1.5, 2.0}) {
        const work a = work_of(fixed_point(gauss<2>()), h), b = work_of(gauss<2>(), h);
        if (a.evaluations > 0) iterated.points.emplace_back(h, a.evaluations);
        if (b.evaluations > 0) newton.points.emplace_back(h, b.evaluations);
        if (first == 0) first = a.evaluations;
        last = std::max(last, a.evaluations);
        largest_newton = std::max(largest_newton, b.evaluations);
        if (h != 0.01 && h != 0.3 && h != 2.0) continue;
        evaluations += (evaluations.empty() ? "" : ", ") + number(a.evaluations, "%.0f") + " : " +
                       number(b.evaluations, "%.0f");
        times += (times.empty() ? "" : ", ") + number(a.microseconds, "%.1f") + " : " +
                 number(b.microseconds, "%.1f");
    }
    out.pictures.push_back(curves("p48_fixed_point", "Evaluations of f in a step", {iterated, newton},
                                  {0, 2.1, 0, 1.1 * last}, "h λ", "evaluations of f",
                                  {"fixed point iteration", "Newton"}));
    out.find("evaluations of f a step, fixed point : Newton, h |lambda| = 0.01, 0.3, 2", "-", evaluations,
             "grows like 1/log(sqrt 12/(h |lambda|))", last > 3 * first && last > largest_newton);
    out.find("microseconds a step, likewise", "-", times, "-", last > 0);
}

/// Section 2.4.1: h for an error per unit step of 1e-5 from one step of h = 0.02 for y' = y by the midpoint rule.
void choose_step(chapter& out) {
    const auto per_unit_step = [](double h) { return std::abs(std::exp(h) - (1 + h / 2) / (1 - h / 2)) / h; };
    const double h = 0.02, tol = 1e-5, difference = h * per_unit_step(h);
    const double right = per_unit_step(h * std::sqrt(h * tol / difference)) / tol,
                 printed = per_unit_step(h * std::sqrt(tol / difference)) / tol;
    out.find("section 2.4.1: error per unit step/TOL at the new h", "without h: " + number(printed, "%.1f"),
             number(right, "%.3f"), "1", std::abs(right - 1) < 0.05 && printed > 2);
}

/// Section 2.4.2 prints X^[i] = 1 x + h A f(X^[i]): the stage equations themselves, so that the first "iterate" would be
/// their solution. Gauss-2 on x' = lambda x, h lambda = -1, x = 1, from X = (1, 1).
void iterate_as_printed(chapter& out) {
    const Eigen::Matrix2d zA = -theory::in_doubles(*tableaux::exact_tableau(family::gauss, 2)).A;
    const Eigen::Vector2d one(1, 1), printed = (Eigen::Matrix2d::Identity() - zA).inverse() * one,
                                     first = one + zA * one;
    Eigen::Vector2d limit = first;
    for (int i = 0; i < 100; ++i) limit = one + zA * limit;
    const double exact = (printed - limit).norm(), left = (first - limit).norm();
    out.find("fixed point iteration, error after X^[1]: as printed, with X^[i-1]", "X^[i] on both sides",
             number(exact, "%.0e") + ", " + number(left, "%.2f"), "solved at once, contracts by 1/sqrt 12",
             exact < 1e-14 && left > 0.01);
}

}  // namespace

chapter chapter_2() {
    chapter out;
    draw_stability(out);
    draw_sector(out);
    construct_radau_ia(out);
    iterate_as_printed(out);
    compare_iterations(out);
    choose_step(out);

    const auto euler = theory::contraction(*tableaux::exact_tableau(family::radau_iia, 1), -1);
    out.find("contraction of implicit Euler, h gamma = -1", "1/sqrt(3) = 0.57735", number(euler.factor),
             "1/2", euler.verdict.is_proved() && std::abs(euler.factor - 0.5) < 1e-6);
    const auto radau = theory::contraction(*tableaux::exact_tableau(family::radau_iia, 2), -1);
    out.find("contraction of Radau IIA-2, h gamma = -1", "-", number(radau.factor, "%.6f"), "4/7 = 0.571429",
             radau.verdict.is_proved() && std::abs(radau.factor - 4.0 / 7) < 1e-5);

    const double gauss = end_of_convergence(theory::in_doubles(*tableaux::exact_tableau(family::gauss, 2)));
    out.find("fixed point iteration, Gauss-2: converges for h |lambda| below", "|h lambda| < 1",
             number(gauss, "%.5f"), "sqrt 12 = " + number(std::sqrt(12.0), "%.5f"),
             std::abs(gauss - std::sqrt(12.0)) < 1e-4);
    const double three =
        end_of_convergence(theory::in_doubles(*tableaux::exact_tableau(family::radau_iia, 3)));
    out.find("fixed point iteration, Radau IIA-3", "|h lambda| < 1", number(three, "%.5f"), "1/rho(A)",
             std::abs(three - 1 / theory::in_doubles(*tableaux::exact_tableau(family::radau_iia, 3))
                                      .A.eigenvalues()
                                      .cwiseAbs()
                                      .maxCoeff()) < 1e-3);
    return out;
}

}  // namespace lecture
