// SPDX-License-Identifier: BSL-1.0
// Symplectic pairs over long times, beside Boost.odeint's: errors of energy and of phase against the cost, with as many
// evaluations of the force for each.
#include <stagecraft/coefficients/partitioned.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/partitioned.hpp>

#include <array>
#include <boost/numeric/odeint/stepper/base/symplectic_rkn_stepper_base.hpp>
#include <boost/numeric/odeint/stepper/symplectic_rkn_sb3a_m4_mclachlan.hpp>
#include <boost/numeric/odeint/stepper/symplectic_rkn_sb3a_mclachlan.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>

namespace {

namespace odeint = boost::numeric::odeint;
using clock_type = std::chrono::steady_clock;

/// q'' = g(q) with unit masses, or scaled so; `energy` of (q, q').
struct kepler {
    static constexpr const char* name = "Kepler, e = 0.6";
    static constexpr int n = 2;
    static constexpr double period = 2 * M_PI, periods = 1000;
    static void force(const double* q, double* g) {
        const double r2 = q[0] * q[0] + q[1] * q[1], r3 = r2 * std::sqrt(r2);
        g[0] = -q[0] / r3, g[1] = -q[1] / r3;
    }
    static double energy(const double* q, const double* v) {
        return (v[0] * v[0] + v[1] * v[1]) / 2 - 1 / std::hypot(q[0], q[1]);
    }
    static Eigen::Vector4d start() { return {0.4, 0, 0, 2}; }
    static Eigen::Vector4d exact() { return start(); }
};
/// Henon and Heiles' system at energy 0.0853, a regular orbit.
struct henon_heiles {
    static constexpr const char* name = "Henon-Heiles";
    static constexpr int n = 2;
    static constexpr double period = 2 * M_PI, periods = 1000;
    static void force(const double* q, double* g) {
        g[0] = -q[0] - 2 * q[0] * q[1], g[1] = -q[1] - q[0] * q[0] + q[1] * q[1];
    }
    static double energy(const double* q, const double* v) {
        return (v[0] * v[0] + v[1] * v[1] + q[0] * q[0] + q[1] * q[1]) / 2 + q[0] * q[0] * q[1] -
               q[1] * q[1] * q[1] / 3;
    }
    static Eigen::Vector4d start() { return {0, 0.1, 0.4, 0.05}; }
};
/// Sun, Jupiter, Saturn, Uranus, Neptune and Pluto (Hairer-Lubich-Wanner, section I.2.4), in astronomical units and days.
struct outer_solar_system {
    static constexpr const char* name = "outer solar system";
    static constexpr int n = 18;
    static constexpr double period = 200, periods = 1000;  // 200,000 days
    static constexpr double G = 2.95912208286e-4;
    static constexpr std::array<double, 6> mass = {1.00000597682,      0.000954786104043,  0.000285583733151,
                                                   0.0000437273164546, 0.0000517759138449, 1 / 1.3e8};
    static void force(const double* q, double* g) {
        std::fill(g, g + n, 0.0);
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < i; ++j) {
                double d[3], r2 = 0;
                for (int k = 0; k < 3; ++k) d[k] = q[3 * i + k] - q[3 * j + k], r2 += d[k] * d[k];
                const double pull = G / (r2 * std::sqrt(r2));
                for (int k = 0; k < 3; ++k)
                    g[3 * i + k] -= pull * mass[j] * d[k], g[3 * j + k] += pull * mass[i] * d[k];
            }
    }
    static double energy(const double* q, const double* v) {
        double sum = 0;
        for (int i = 0; i < 6; ++i) {
            for (int k = 0; k < 3; ++k) sum += mass[i] * v[3 * i + k] * v[3 * i + k] / 2;
            for (int j = 0; j < i; ++j) {
                double r2 = 0;
                for (int k = 0; k < 3; ++k) r2 += std::pow(q[3 * i + k] - q[3 * j + k], 2);
                sum -= G * mass[i] * mass[j] / std::sqrt(r2);
            }
        }
        return sum;
    }
    static Eigen::Matrix<double, 36, 1> start() {
        Eigen::Matrix<double, 36, 1> y;
        y << 0, 0, 0, -3.5023653, -3.8169847, -1.5507963, 9.0755314, -3.0458353, -1.6483708, 8.3101420,
            -16.2901086, -7.2521278, 11.4707666, -25.7294829, -10.8169456, -15.5387357, -25.2225594,
            -3.1902382,  //
            0, 0, 0, 0.00565429, -0.00412490, -0.00190589, 0.00168318, 0.00483525, 0.00192462, 0.00354178,
            0.00137102, 0.00055029, 0.00288930, 0.00114527, 0.00039677, 0.00276725, -0.00170702, -0.00136504;
        return y;
    }
};

struct sums {
    double energy = 0, phase = 0, us_per_force = 0;
    long forces = 0;
};

template <class P>
using state = Eigen::Matrix<double, 2 * P::n, 1>;

template <class P>
auto as_parts() {
    using part = Eigen::Matrix<double, P::n, 1>;
    return stagecraft::partition([](double, const part& v, part& out) { out = v; },
                                 [](double, const part& q, part& out) { P::force(q.data(), out.data()); });
}

template <class P>
state<P> end_of() {
    if constexpr (requires { P::exact(); })
        return P::exact();
    else
        return stagecraft::integrate(stagecraft::radau_iia<7>(), as_parts<P>(), P::start(), 0.0,
                                     P::period * P::periods,
                                     {.rtol = 1e-13, .atol = 1e-15, .max_steps = 10000000})
            .y;
}

/// As many steps a period as `forces` evaluations allow; the energy is looked at twenty times a period in both programs.
template <class P, class March>
sums run_for(int steps_a_period, const state<P>& exact, const March& march) {
    sums s;
    const state<P> y0 = P::start();
    const double begin = P::energy(y0.data(), y0.data() + P::n);
    const auto look = [&](const double* q, const double* v) {
        s.energy = std::max(s.energy, std::abs(P::energy(q, v) - begin) / std::abs(begin));
    };
    const auto start = clock_type::now();
    const state<P> y = march(steps_a_period, s.forces, look);
    s.us_per_force = std::chrono::duration<double, std::micro>(clock_type::now() - start).count() /
                     static_cast<double>(s.forces);
    s.phase = (y - exact).template head<P::n>().norm() / exact.template head<P::n>().norm();
    return s;
}

template <class P, class Method>
sums ours(const Method& method, int steps, const state<P>& exact) {
    return run_for<P>(steps, exact, [&](int each, long& forces, const auto& look) {
        long seen = 0;
        const auto watch = [&, every = std::max(each / 20, 1)](double, const state<P>& y) {
            if (++seen % every == 0) look(y.data(), y.data() + P::n);
        };
        const auto r = stagecraft::integrate(method, as_parts<P>(), P::start(), 0.0, P::period * P::periods,
                                             {.fixed_step = P::period / each}, watch);
        forces = r.report.f;
        return r.y;
    });
}

template <class P, class Stepper>
sums theirs(Stepper stepper, int steps, int forces_a_step, const state<P>& exact) {
    return run_for<P>(steps, exact, [&](int each, long& forces, const auto& look) {
        using part = std::array<double, P::n>;
        part q, v;
        const state<P> y0 = P::start();
        std::copy_n(y0.data(), P::n, q.begin());
        std::copy_n(y0.data() + P::n, P::n, v.begin());
        const auto rates = std::make_pair([](const part& in, part& out) { out = in; },
                                          [](const part& in, part& out) { P::force(in.data(), out.data()); });
        const long all = static_cast<long>(P::periods) * each, every = std::max(each / 20, 1);
        const double h = P::period / each;
        for (long k = 1; k <= all; ++k) {
            stepper.do_step(rates, std::make_pair(std::ref(q), std::ref(v)), 0.0, h);
            if (k % every == 0) look(q.data(), v.data());
        }
        forces = all * forces_a_step;
        state<P> y;
        std::copy(q.begin(), q.end(), y.data());
        std::copy(v.begin(), v.end(), y.data() + P::n);
        return y;
    });
}

template <class P>
void print_problem() {
    using part = std::array<double, P::n>;
    const state<P> exact = end_of<P>();
    std::printf("\n%s, t = %g\n%-24s %6s %10s %12s %12s %10s\n", P::name, P::period * P::periods, "method",
                "steps", "forces", "energy", "position", "us/force");
    const auto row = [](const char* method, int steps, const sums& s) {
        std::printf("%-24s %6d %10ld %12.1e %12.1e %10.4f\n", method, steps, s.forces, s.energy, s.phase,
                    s.us_per_force);
    };
    for (const int budget : {240, 960}) {  // forces a period
        row("Stoermer-Verlet", budget, ours<P>(stagecraft::stoermer_verlet(), budget, exact));
        row("Forest-Ruth", budget / 3, ours<P>(stagecraft::forest_ruth_4(), budget / 3, exact));
        row("McLachlan 4", budget / 5, ours<P>(stagecraft::mclachlan_4(), budget / 5, exact));
        row("Blanes-Moan 4", budget / 6, ours<P>(stagecraft::blanes_moan_4(), budget / 6, exact));
        row("odeint rkn_sb3a", budget / 6,
            theirs<P>(odeint::symplectic_rkn_sb3a_mclachlan<part>(), budget / 6, 6, exact));
        row("odeint rkn_sb3a_m4", budget / 4,
            theirs<P>(odeint::symplectic_rkn_sb3a_m4_mclachlan<part>(), budget / 5, 5, exact));
    }
}

}  // namespace

void print_symplectic() {
    print_problem<kepler>();
    print_problem<henon_heiles>();
    print_problem<outer_solar_system>();
}
