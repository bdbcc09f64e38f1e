// SPDX-License-Identifier: BSL-1.0
// Problems u'' = g(t, u, u') with closed solutions: Cash's test set (stated in the vignette bvpTests of the R package
// bvpSolve; the solutions of 7 and 8 printed there are corrected), Bratu's two solutions, Lane and Emden, a sine of a
// cubic; and systems of three equations: Blasius, eigenvalues of -u''.
#include "problem.hpp"

namespace bvp {

namespace {

constexpr double pi = 3.14159265358979323846;
using function = std::function<double(double)>;

/// u'' = (c(t) - q(t) u' - r(t) u)/e(t).
struct linear {
    function e, q, r, c;
};

problem named(const std::string& name, double a, double b, const function& u, const function& v) {
    problem p;
    p.name = name;
    p.a = a, p.b = b;
    for (int k = 0; k <= 1000; ++k) {
        // Layers are seen as well: points close to both ends and to the middle.
        const double s = k / 1000.0, near = std::pow(10.0, -8 + 8 * s) / 2, middle = (a + b) / 2;
        for (const double t : {a + (b - a) * s, a + (b - a) * near, b - (b - a) * near,
                               middle + (b - a) * (near - 0.25), middle - (b - a) * (near - 0.25)})
            p.reference.push_back({std::clamp(t, a, b), {u(std::clamp(t, a, b)), v(std::clamp(t, a, b))}});
    }
    std::sort(p.reference.begin(), p.reference.end());
    p.left = {{{1, 0}, u(a)}};
    p.right = {{{1, 0}, u(b)}};
    p.guess = [](double, double* y) { y[0] = y[1] = 0; };
    return p;
}

problem with(problem p, const linear& l) {
    p.linear = true;
    p.f = [l](double t, const double* y, double* f) {
        f[0] = y[1], f[1] = (l.c(t) - l.q(t) * y[1] - l.r(t) * y[0]) / l.e(t);
    };
    p.jacobian = [l](double t, const double*, double* J) {
        J[2] = 1, J[1] = -l.r(t) / l.e(t), J[3] = -l.q(t) / l.e(t);
    };
    return p;
}

void straight_guess(problem& p) {
    const double a = p.a, u = p.left[0].value, slope = (p.right[0].value - u) / (p.b - a);
    p.guess = [=](double t, double* y) { y[0] = u + slope * (t - a), y[1] = slope; };
}

function constant(double x) {
    return [x](double) { return x; };
}
double wave(double t) { return std::cos(pi * t); }
double wave_slope(double t) { return -pi * std::sin(pi * t); }

/// Cash's problems 1 to 11.
void first_half(std::vector<problem>& all, double e, const std::string& end) {
    const auto zero = constant(0), eps = constant(e);
    const auto wave_force = [e](double factor) {
        return [=](double t) { return -(factor + e * pi * pi) * wave(t); };
    };
    const double root = std::sqrt(e), small = std::exp(-2 / root), tiny = std::exp(-1 / e),
                 w = std::sqrt(2 * e);
    all.push_back(with(
        named(
            "cash1" + end, 0, 1,
            [=](double t) { return (std::exp(-t / root) - std::exp((t - 2) / root)) / (1 - small); },
            [=](double t) { return -(std::exp(-t / root) + std::exp((t - 2) / root)) / (1 - small) / root; }),
        {eps, zero, constant(-1), zero}));
    all.push_back(
        with(named(
                 "cash2" + end, 0, 1, [=](double t) { return -std::expm1((t - 1) / e) / (1 - tiny); },
                 [=](double t) { return -std::exp((t - 1) / e) / e / (1 - tiny); }),
             {eps, constant(-1), zero, zero}));
    all.push_back(
        with(named("cash3" + end, -1, 1, wave, wave_slope),
             {eps, [](double t) { return 2 + wave(t); }, constant(-1),
              [=](double t) { return -(1 + e * pi * pi) * wave(t) + (2 + wave(t)) * wave_slope(t); }}));
    all.push_back(
        with(named(
                 "cash4" + end, -1, 1,
                 [=](double t) { return std::exp(t - 1) + std::exp(-(1 + e) * (1 + t) / e); },
                 [=](double t) { return std::exp(t - 1) - (1 + e) / e * std::exp(-(1 + e) * (1 + t) / e); }),
             {eps, constant(1), constant(-1 - e), zero}));
    all.push_back(with(named("cash5" + end, -1, 1, wave, wave_slope),
                       {eps, [](double t) { return -t; }, constant(-1),
                        [=](double t) { return -(1 + e * pi * pi) * wave(t) - t * wave_slope(t); }}));
    const double jump = std::erf(1 / w);
    const auto step = [=](double t) { return std::erf(t / w) / jump; };
    const auto step_slope = [=](double t) {
        return 2 / std::sqrt(pi) / w * std::exp(-t * t / (2 * e)) / jump;
    };
    all.push_back(with(named(
                           "cash6" + end, -1, 1, [=](double t) { return wave(t) + step(t); },
                           [=](double t) { return wave_slope(t) + step_slope(t); }),
                       {eps, [](double t) { return t; }, zero,
                        [=](double t) { return -e * pi * pi * wave(t) + t * wave_slope(t); }}));
    const double bell = std::sqrt(2 * e / pi), size = jump + bell * std::exp(-1 / (2 * e));
    all.push_back(with(named(
                           "cash7" + end, -1, 1,
                           [=](double t) {
                               return wave(t) + t +
                                      (t * std::erf(t / w) + bell * std::exp(-t * t / (2 * e))) / size;
                           },
                           [=](double t) { return wave_slope(t) + 1 + std::erf(t / w) / size; }),
                       {eps, [](double t) { return t; }, constant(-1),
                        [=](double t) { return wave_force(1)(t) + t * wave_slope(t); }}));
    all.push_back(
        with(named(
                 "cash8" + end, 0, 1, [=](double t) { return (2 - tiny - std::exp(-t / e)) / (1 - tiny); },
                 [=](double t) { return std::exp(-t / e) / e / (1 - tiny); }),
             {eps, constant(1), zero, zero}));
    all.push_back(
        with(named(
                 "cash9" + end, -1, 1, [=](double t) { return 1 / (e + t * t); },
                 [=](double t) { return -2 * t / (e + t * t) / (e + t * t); }),
             {[=](double t) { return e + t * t; }, [](double t) { return 4 * t; }, constant(2), zero}));
    all.push_back(with(named(
                           "cash10" + end, -1, 1, [=](double t) { return 1 + step(t); }, step_slope),
                       {eps, [](double t) { return t; }, zero, zero}));
    all.push_back(
        with(named("cash11" + end, -1, 1, wave, wave_slope), {eps, zero, constant(-1), wave_force(1)}));
}

/// 14, 16, 17, 18, 20 and 21.
void second_half(std::vector<problem>& all, double e, const std::string& end) {
    const auto zero = constant(0), eps = constant(e);
    const double root = std::sqrt(e);
    all.push_back(
        with(named(
                 "cash14" + end, -1, 1,
                 [=](double t) { return wave(t) + std::exp((t - 1) / root) + std::exp(-(t + 1) / root); },
                 [=](double t) {
                     return wave_slope(t) + (std::exp((t - 1) / root) - std::exp(-(t + 1) / root)) / root;
                 }),
             {eps, zero, constant(-1), [=](double t) { return -(1 + e * pi * pi) * wave(t); }}));
    const double k = std::round(1 / e) + 1,
                 half = pi * k / 2;  // an odd 1/epsilon: at even ones M is singular
    if (k < 2000)
        all.push_back(with(named(
                               "cash16" + end, 0, 1, [=](double t) { return std::sin(half * t); },
                               [=](double t) { return half * std::cos(half * t); }),
                           {constant(1), zero, constant(half * half), zero}));
    all.push_back(with(named(
                           "cash17" + end, -0.1, 0.1, [=](double t) { return t / std::sqrt(e + t * t); },
                           [=](double t) { return e / std::pow(e + t * t, 1.5); }),
                       {[=](double t) { return (e + t * t) * (e + t * t); }, zero, constant(3 * e), zero}));
    all.push_back(with(named(
                           "cash18" + end, 0, 1, [=](double t) { return std::exp(-t / e); },
                           [=](double t) { return -std::exp(-t / e) / e; }),
                       {eps, constant(1), zero, zero}));
    problem shock = named(
        "cash20" + end, 0, 1,
        [=](double t) {
            const double x = std::abs(t - 0.745) / e;
            return 1 + e * (x + std::log1p(std::exp(-2 * x)) - std::log(2.0));
        },
        [=](double t) { return std::tanh((t - 0.745) / e); });
    shock.f = [=](double, const double* y, double* f) { f[0] = y[1], f[1] = (1 - y[1] * y[1]) / e; };
    shock.jacobian = [=](double, const double* y, double* J) { J[2] = 1, J[3] = -2 * y[1] / e; };
    straight_guess(shock);
    all.push_back(shock);
    problem layer = named(
        "cash21" + end, 0, 1, [=](double t) { return std::exp(-t / root); },
        [=](double t) { return -std::exp(-t / root) / root; });
    layer.f = [=](double t, const double* y, double* f) {
        f[0] = y[1], f[1] = (y[0] + y[0] * y[0] - std::exp(-2 * t / root)) / e;
    };
    layer.jacobian = [=](double, const double* y, double* J) { J[2] = 1, J[1] = (1 + 2 * y[0]) / e; };
    straight_guess(layer);
    all.push_back(layer);
}

void bratu(std::vector<problem>& all, const std::string& branch, double a, double height) {
    // u = -2 ln(cosh((t - 1/2) a / 2)/cosh(a / 4)), a = sqrt(2) cosh(a / 4).
    problem p = named(
        "bratu" + branch, 0, 1,
        [=](double t) { return -2 * std::log(std::cosh((t - 0.5) * a / 2) / std::cosh(a / 4)); },
        [=](double t) { return -a * std::tanh((t - 0.5) * a / 2); });
    p.left[0].value = p.right[0].value = 0;
    p.f = [](double, const double* y, double* f) { f[0] = y[1], f[1] = -std::exp(y[0]); };
    p.jacobian = [](double, const double* y, double* J) { J[2] = 1, J[1] = -std::exp(y[0]); };
    p.guess = [=](double t, double* y) { y[0] = 4 * height * t * (1 - t), y[1] = 4 * height * (1 - 2 * t); };
    all.push_back(p);
}

void lane_emden(std::vector<problem>& all) {
    problem p = named(
        "laneemden5", 0, 1, [](double t) { return 1 / std::sqrt(1 + t * t / 3); },
        [](double t) { return -t / 3 / std::pow(1 + t * t / 3, 1.5); });
    p.left = {{{0, 1}, 0}};
    p.f = [](double t, const double* y, double* f) { f[0] = y[1], f[1] = -2 * y[1] / t - std::pow(y[0], 5); };
    p.jacobian = [](double t, const double* y, double* J) {
        J[2] = 1, J[1] = -5 * std::pow(y[0], 4), J[3] = -2 / t;
    };
    p.guess = [](double, double* y) { y[0] = 1, y[1] = 0; };
    all.push_back(p);
}

/// u'' + (lambda pi)^2 sin(u + u^2 + u^3) = 0 with lambda = 3/2, where coarse fixed meshes have solutions that the equation
/// has not. The positive solution by its energy: u'^2/2 is the integral of the force from u to the height u(1/2), and the
/// way there takes 1/2; between them by extrapolation, at points where the energy is the same to 6e-15.
void sine_of_cubic(std::vector<problem>& all) {
    const double height = 1.0095775455192477, slope = 5.0531587127081306, k = 2.25 * pi * pi;
    problem p;
    p.name = "sine_cubic";
    p.left = p.right = {{{1, 0}, 0}};
    p.f = [=](double, const double* y, double* f) {
        const double u = y[0];
        f[0] = y[1], f[1] = -k * std::sin(u + u * u + u * u * u);
    };
    p.jacobian = [=](double, const double* y, double* J) {
        const double u = y[0];
        J[2] = 1, J[1] = -k * std::cos(u + u * u + u * u * u) * (1 + 2 * u + 3 * u * u);
    };
    p.guess = [](double t, double* y) { y[0] = 4 * t * (1 - t), y[1] = 4 - 8 * t; };
    p.reference = {{0, {0, slope}},
                   {0.03, {0.1510494952877602, 4.9972353340341185}},
                   {0.07, {0.3460801739231534, 4.7083186112353221}},
                   {0.14, {0.6389691402300064, 3.5317561317236579}},
                   {0.23, {0.8698510736982030, 1.6764196171670209}},
                   {0.37, {0.9906941415524174, 0.3428047651247145}},
                   {0.5, {height, 0}}};
    for (int i = 5; i >= 0; --i) {
        const auto [t, y] = p.reference[i];
        p.reference.push_back({1 - t, {y[0], -y[1]}});
    }
    all.push_back(p);
}

/// f''' + f f''/2 = 0; of the solution f''(0) alone is known, to all digits.
void blasius(std::vector<problem>& all) {
    problem p;
    p.name = "blasius";
    p.n = 3, p.second_order = false;
    p.b = 20;
    p.left = {{{1, 0, 0}, 0}, {{0, 1, 0}, 0}};
    p.right = {{{0, 1, 0}, 1}};
    p.f = [](double, const double* y, double* f) { f[0] = y[1], f[1] = y[2], f[2] = -y[0] * y[2] / 2; };
    p.jacobian = [](double, const double* y, double* J) {
        J[3] = J[7] = 1, J[2] = -y[2] / 2, J[8] = -y[0] / 2;
    };
    p.guess = [](double t, double* y) { y[0] = t, y[1] = 1, y[2] = 0; };
    p.reference = {{0, {0, 0, 0.3320573362151963}}};
    all.push_back(p);
}

/// u'' + lambda u = 0, u(0) = u(1) = 0, u'(0) = 1, with lambda as a component: lambda = (k pi)^2. The guess has the
/// form of u and lambda = 10 k^2.
void eigenvalue(std::vector<problem>& all, int k) {
    problem p;
    p.name = "eigenvalue" + std::to_string(k);
    p.n = 3, p.second_order = false;
    p.left = {{{1, 0, 0}, 0}, {{0, 1, 0}, 1}};
    p.right = {{{1, 0, 0}, 0}};
    p.f = [](double, const double* y, double* f) { f[0] = y[1], f[1] = -y[2] * y[0], f[2] = 0; };
    p.jacobian = [](double, const double* y, double* J) { J[3] = 1, J[1] = -y[2], J[7] = -y[0]; };
    const double w = k * pi;
    p.guess = [=](double t, double* y) {
        y[0] = std::sin(w * t) / w, y[1] = std::cos(w * t), y[2] = 10.0 * k * k;
    };
    for (int i = 0; i <= 200; ++i) {
        const double t = i / 200.0;
        p.reference.push_back({t, {std::sin(w * t) / w, std::cos(w * t), w * w}});
    }
    all.push_back(p);
}

}  // namespace

std::vector<problem> closed_forms() {
    std::vector<problem> all;
    for (int k = 1; k <= 8; ++k) {
        first_half(all, std::pow(10.0, -k), "_1e-" + std::to_string(k));
        second_half(all, std::pow(10.0, -k), "_1e-" + std::to_string(k));
    }
    bratu(all, "_low", 1.5171645990507544, 0);
    bratu(all, "_high", 10.938702772115119, 4);
    lane_emden(all);
    sine_of_cubic(all);
    blasius(all);
    for (const int k : {1, 2, 10}) eigenvalue(all, k);
    return all;
}

}  // namespace bvp
