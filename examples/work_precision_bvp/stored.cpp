// SPDX-License-Identifier: BSL-1.0
// The problems of tests/data/bvp.json, whose solutions are known to 24 digits at 21 points.
#include <problems/stored.hpp>

#include "problem.hpp"

namespace bvp {

namespace {

constexpr double pi = 3.14159265358979323846;

void second_order(problem& p, const std::string& kind, double q) {
    const auto set = [&](auto g, auto by_u, auto by_v) {
        p.f = [g](double t, const double* y, double* f) { f[0] = y[1], f[1] = g(t, y[0], y[1]); };
        p.jacobian = [by_u, by_v](double t, const double* y, double* J) {
            J[2] = 1, J[1] = by_u(t, y[0], y[1]), J[3] = by_v(t, y[0], y[1]);
        };
    };
    const auto none = [](double, double, double) { return 0.0; };
    const auto shock = [q](double x) {
        return 1 + q * (std::abs(x) / q + std::log1p(std::exp(-2 * std::abs(x) / q)) - std::log(2.0));
    };
    double left = 0, right = 0;
    bool line = false;
    if (kind == "bratu")
        set([q](double, double u, double) { return -q * std::exp(u); },
            [q](double, double u, double) { return -q * std::exp(u); }, none);
    if (kind == "troesch") {
        right = 1, line = true;
        set([q](double, double u, double) { return q * std::sinh(q * u); },
            [q](double, double u, double) { return q * q * std::cosh(q * u); }, none);
    }
    if (kind == "t1") {
        left = 1, p.linear = true;
        set([q](double, double u, double) { return u / q; }, [q](double, double, double) { return 1 / q; },
            none);
    }
    if (kind == "t7") {
        left = -1, right = 1, p.linear = true;
        set(
            [q](double t, double u, double v) {
                return (u - t * v - pi * t * std::sin(pi * t) - (1 + pi * pi * q) * std::cos(pi * t)) / q;
            },
            [q](double, double, double) { return 1 / q; }, [q](double t, double, double) { return -t / q; });
    }
    if (kind == "t20") {
        left = shock(0.745), right = shock(0.255), line = true;
        set([q](double, double, double v) { return (1 - v * v) / q; }, none,
            [q](double, double, double v) { return -2 * v / q; });
    }
    if (kind == "t30") {
        left = -7.0 / 6, right = 1.5, line = true;
        set([q](double, double u, double v) { return (u - u * v) / q; },
            [q](double, double, double v) { return (1 - v) / q; },
            [q](double, double u, double) { return -u / q; });
    }
    if (kind == "sb") {
        left = right = 1, p.linear = true;
        set([](double, double u, double v) { return 110 * u + v; },
            [](double, double, double) { return 110.0; }, [](double, double, double) { return 1.0; });
    }
    p.left = {{{1, 0}, left}};
    p.right = {{{1, 0}, right}};
    p.guess = [=](double t, double* y) {
        y[0] = line ? left + (right - left) * t : 0;
        y[1] = line ? right - left : 0;
    };
}

void nonlinear_beam(problem& p, double q) {
    p.f = [q](double, const double* y, double* f) {
        f[0] = std::sin(y[1]), f[1] = y[2], f[2] = -y[3] / q;
        f[3] = ((y[0] - 1) * std::cos(y[1]) - y[2] * (1 / std::cos(y[1]) + q * y[3] * std::tan(y[1]))) / q;
    };
    p.jacobian = [q](double, const double* y, double* J) {
        const double c = std::cos(y[1]), s = std::sin(y[1]);
        J[4] = c, J[9] = 1, J[14] = -1 / q;
        J[3] = c / q, J[7] = (-(y[0] - 1) * s - y[2] * (s / (c * c) + q * y[3] / (c * c))) / q;
        J[11] = -(1 / c + q * y[3] * s / c) / q, J[15] = -y[2] * s / c;
    };
    p.left = p.right = {{{1, 0, 0, 0}, 0}, {{0, 0, 1, 0}, 0}};
    p.guess = [](double, double* y) { std::fill_n(y, 4, 0.0); };
}

void turning_modes(problem& p) {
    p.linear = true;
    p.f = [](double t, const double* y, double* f) {
        const double c = 19 * std::cos(2 * t), s = 19 * std::sin(2 * t), e = std::exp(t);
        f[0] = y[0] * (1 - c) + y[1] * (s + 1) + (c - s - 1) * e;
        f[1] = y[0] * (s - 1) + y[1] * (c + 1) + (1 - s - c) * e;
        f[2] = f[3] = 0;
    };
    p.jacobian = [](double t, const double*, double* J) {
        const double c = 19 * std::cos(2 * t), s = 19 * std::sin(2 * t);
        J[0] = 1 - c, J[4] = s + 1, J[1] = s - 1, J[5] = c + 1;
    };
    p.left = {{{1, 0, -1, 0}, 0}, {{0, 1, 0, -1}, 0}};
    p.right = {{{1, 0, 1, 0}, 1 + std::exp(pi)}, {{0, 1, 0, 1}, 1 + std::exp(pi)}};
    p.guess = [](double, double* y) { std::fill_n(y, 4, 1.0); };
}

void van_der_pol(problem& p, double q) {
    p.f = [q](double, const double* y, double* f) {
        f[0] = y[1] * y[2], f[1] = y[2] * (q * y[1] * (1 - y[0] * y[0]) - y[0]), f[2] = f[3] = 0;
    };
    p.jacobian = [q](double, const double* y, double* J) {
        J[4] = y[2], J[8] = y[1];
        J[1] = y[2] * (-2 * q * y[1] * y[0] - 1), J[5] = y[2] * q * (1 - y[0] * y[0]);
        J[9] = q * y[1] * (1 - y[0] * y[0]) - y[0];
    };
    p.left = p.right = {{{0, 1, 0, 0}, 0}, {{1, 0, 0, -1}, 0}};
    p.guess = [q](double t, double* y) {
        y[0] = 2 * std::cos(2 * pi * t), y[1] = -2 * std::sin(2 * pi * t), y[2] = 1.5 * q + 5, y[3] = 2;
    };
}

}  // namespace

std::vector<problem> stored() {
    std::vector<problem> all;
    for (const auto& c : problems::boundary_value_cases()) {
        problem p;
        p.name = c.name;
        p.n = c.equations;
        p.second_order = p.n == 2;
        p.a = c.a, p.b = c.b;
        const double q = c.p;
        const std::string kind = c.name.substr(0, c.name.find('_'));
        if (p.second_order) second_order(p, kind, q);
        if (kind == "t31") nonlinear_beam(p, q);
        if (kind == "amr") turning_modes(p);
        if (kind == "vdp") van_der_pol(p, q);
        for (const auto& point : c.points)
            p.reference.emplace_back(point.front(), std::vector<double>(point.begin() + 1, point.end()));
        all.push_back(std::move(p));
    }
    return all;
}

}  // namespace bvp
