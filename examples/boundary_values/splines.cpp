// SPDX-License-Identifier: BSL-1.0
// Chapter 6: collocation with cubic splines, which is Lobatto IIIA with three stages.
#include <stagecraft/families.hpp>

#include "experiments.hpp"

namespace boundary_values {

namespace {

/// y'' = y + q: the solution x = (y, y'), its second derivative q included.
struct solution_of {
    std::function<double(double)> y, slope, q;
    Eigen::Vector2d x(double t) const { return {y(t), slope(t)}; }
    Eigen::Vector2d f(double t, const Eigen::Vector2d& x) const { return {x[1], x[0] + q(t)}; }
};

struct errors {
    double nodes = 0, defect = 0, spline = 0, derivative = 0;
};

/// The cubic on [t, t + h] with these values and slopes: (6.2), as value and derivative at t + theta h.
std::pair<Eigen::Vector2d, Eigen::Vector2d> cubic(const Eigen::Vector2d& u, const Eigen::Vector2d& du,
                                                  const Eigen::Vector2d& v, const Eigen::Vector2d& dv,
                                                  double h, double theta) {
    const Eigen::Vector2d w = (v - u) / h, a = du - w, b = dv - w, inner = (1 - theta) * a - theta * b;
    return {u + h * theta * (w + (1 - theta) * inner),
            w + (1 - 2 * theta) * inner - theta * (1 - theta) * (a + b)};
}

errors collocate(const solution_of& s, const std::vector<double>& mesh) {
    linear_rhs f{[](double) {
                     return MatrixXd(Eigen::Matrix2d{{0, 1}, {1, 0}});
                 },
                 [&](double t) { return VectorXd(Eigen::Vector2d(0, s.q(t))); }};
    linear_conditions r{MatrixXd(Eigen::Matrix2d{{1, 0}, {0, 0}}), MatrixXd(Eigen::Matrix2d{{0, 0}, {1, 0}}),
                        Eigen::Vector2d(s.y(0), s.y(1))};
    static const tableau<double> method = lobatto_iiia(3);
    const auto answer =
        solve(method, f, r, 1, {.rtol = 1e-12, .mesh = mesh, .adapt = false, .conditioning = false});
    errors e;
    for (std::size_t i = 0; i + 1 < mesh.size(); ++i) {
        const double t = mesh[i], h = mesh[i + 1] - t;
        const Eigen::Vector2d u = answer.y(t), v = answer.y(mesh[i + 1]), du = s.f(t, u), dv = s.f(t + h, v);
        e.nodes = std::max(e.nodes, (v - s.x(t + h)).cwiseAbs().maxCoeff());
        const auto [x, dx] = cubic(s.x(t), s.f(t, s.x(t)), s.x(t + h), s.f(t + h, s.x(t + h)), h, 0.5);
        e.defect = std::max(e.defect, (dx - s.f(t + h / 2, x)).cwiseAbs().maxCoeff());
        for (int k = 0; k <= 20; ++k) {
            const double theta = k / 20.0, at = t + theta * h;
            const auto [w, dw] = cubic(u, du, v, dv, h, theta);
            e.spline = std::max(e.spline, (w - s.x(at)).cwiseAbs().maxCoeff());
            e.derivative = std::max(e.derivative, (dw - s.f(at, s.x(at))).cwiseAbs().maxCoeff());
        }
    }
    return e;
}

std::vector<double> equal(int N, double fixed = -1) {
    std::vector<double> t;
    for (int i = 0; i <= N; ++i) t.push_back(i / static_cast<double>(N));
    if (fixed > 0) t.insert(std::lower_bound(t.begin(), t.end(), fixed), fixed);
    return t;
}

/// log2 of the quotients from N = 40 to 80.
errors orders(const solution_of& s, double fixed = -1) {
    const errors coarse = collocate(s, equal(40, fixed)), fine = collocate(s, equal(80, fixed));
    return {std::log2(coarse.nodes / fine.nodes), std::log2(coarse.defect / fine.defect),
            std::log2(coarse.spline / fine.spline), std::log2(coarse.derivative / fine.derivative)};
}

}  // namespace

chapter splines() {
    chapter out;
    const auto zero = [](double) { return 0.0; };
    const solution_of smooth{[](double t) { return std::sinh(1 - t) / std::sinh(1.0); },
                             [](double t) { return -std::cosh(1 - t) / std::sinh(1.0); }, zero};
    const errors p = orders(smooth);
    const auto line = [&](const std::string& what, const std::string& printed, double here, double theory,
                          double reference) {
        out.find("order of splines on y'' = y: " + what, printed, number(here, "%.2f"),
                 number(theory, "%.0f"), std::abs(here - theory) < 0.05 && std::abs(here - reference) < 0.03);
    };
    line("at mesh points", "-", p.nodes, 4, 4.00);
    line("defect of the solution", "1 at least", p.defect, 4, 3.99);
    line("the spline", "-", p.spline, 4, 3.98);
    line("its derivative", "-", p.derivative, 3, 2.99);

    // y'' = y + |t - c|: the error depends on where in its interval c stands (at 1/3 of it the defect is
    // O(h^2)), so the largest over 15 places is taken.
    const auto kinked = [](double c) {
        return solution_of{[c](double t) { return std::sinh(std::abs(t - c)) - std::abs(t - c); },
                           [c](double t) { return (t < c ? -1 : 1) * (std::cosh(t - c) - 1); },
                           [c](double t) { return std::abs(t - c); }};
    };
    const auto envelope = [&](int N) {
        errors most;
        for (int k = 1; k < 16; ++k) {
            const errors e = collocate(kinked((N / 3 + k / 16.0) / N), equal(N));
            most.defect = std::max(most.defect, e.defect), most.nodes = std::max(most.nodes, e.nodes);
        }
        return most;
    };
    const errors coarse = envelope(40), fine = envelope(80), on = orders(kinked(1.0 / 3), 1.0 / 3);
    const double defect = std::log2(coarse.defect / fine.defect),
                 nodes = std::log2(coarse.nodes / fine.nodes);
    out.find("the same, q with a kink off the mesh: defect, mesh points", "1, -",
             number(defect, "%.2f") + ", " + number(nodes, "%.2f"), "1, 2",
             std::abs(defect - 1) < 0.05 && std::abs(nodes - 2) < 0.1);
    out.find("with the kink a mesh point: defect, mesh points", "-",
             number(on.defect, "%.2f") + ", " + number(on.nodes, "%.2f"), "4, 4",
             std::abs(on.defect - 4) < 0.1 && std::abs(on.nodes - 4) < 0.1);
    return out;
}

}  // namespace boundary_values
