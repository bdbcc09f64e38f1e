// SPDX-License-Identifier: BSL-1.0
// How the cost grows with the number of unknowns, of stages and with the tolerance, and what a run of 1e5
// unknowns needs of memory: the one-dimensional Brusselator with a sparse Jacobian.
#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <stagecraft/integrate.hpp>
#include <stagecraft/linear/sparse_blocks.hpp>
#include <stagecraft/radau_iia_variable.hpp>
#include <utility>
#include <vector>

#include <problems/stiff.hpp>

namespace {

struct measurement {
    double x, seconds;
    stagecraft::report<double> counts;
};

template <class Run>
measurement measured(double x, int repeats, Run run) {
    using clock = std::chrono::steady_clock;
    measurement best{x, 0, {}};
    for (int k = 0; k < repeats; ++k) {
        std::fprintf(stderr, "\r%8g  run %d ", x, k + 1);
        const auto start = clock::now();
        const auto result = run();
        const double seconds = std::chrono::duration<double>(clock::now() - start).count();
        if (!result.ok()) std::printf("%g: %s\n", x, name(result.status));
        if (k == 0 || seconds < best.seconds) best = {x, seconds, result.report};
    }
    std::fprintf(stderr, "\r                    \r");
    return best;
}

/// Slope of the least-squares line through (log x, log seconds), as exponent: seconds ~ x^slope.
double exponent(const std::vector<measurement>& all) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const auto& m : all) {
        const double x = std::log(m.x), y = std::log(m.seconds);
        n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

void print(const char* what, const std::vector<measurement>& all) {
    std::printf("\n%10s %12s %8s %8s %8s %8s\n", what, "ms", "steps", "f", "J", "LU");
    for (const auto& m : all)
        std::printf("%10g %12.2f %8ld %8ld %8ld %8ld\n", m.x, m.seconds * 1e3, m.counts.steps, m.counts.f,
                    m.counts.jacobians, m.counts.factorisations);
    std::printf("time ~ %s^%.2f\n", what, exponent(all));
}

/// The same method with its number of stages known at run time, so that one instantiation serves them all.
template <int S>
auto at_run_time() {
    const auto fixed = stagecraft::radau_iia<S>();
    stagecraft::transformed_tableau<double> m;
    m.A = fixed.A, m.b = fixed.b, m.c = fixed.c, m.b_embedded = fixed.b_embedded, m.facts = fixed.facts;
    m.A_inverse = fixed.A_inverse, m.T = fixed.T, m.T_inverse = fixed.T_inverse;
    m.gamma = fixed.gamma, m.alpha = fixed.alpha, m.beta = fixed.beta;
    return m;
}
template <int... I>
auto stages_from_one(std::integer_sequence<int, I...>) {
    return std::vector{at_run_time<I + 1>()...};
}

auto run(const auto& method, const problems::sparse_brusselator& p, double t1,
         const stagecraft::options<double>& options) {
    return stagecraft::integrate(method, p, p.initial(), p.t0, t1, options);
}

}  // namespace

void print_growth() {
    std::vector<measurement> all;
    const auto methods = stages_from_one(std::make_integer_sequence<int, 9>{});

    std::printf("Brusselator, t in [0, 10], sparse Jacobian, Radau IIA s = 3, rtol = atol = 1e-6\n");
    for (const int N : {50, 100, 200, 500, 1000, 2000, 5000}) {
        const problems::sparse_brusselator p{{N}};
        all.push_back(measured(2 * N, N < 1000 ? 5 : 3,
                               [&] { return run(methods[2], p, p.t1, {.rtol = 1e-6, .atol = 1e-6}); }));
    }
    print("unknowns", all);

    std::printf("\nthe same, N = 500, 50 equal steps\n");
    const problems::sparse_brusselator p;
    all.clear();
    for (int s = 1; s <= 9; ++s)
        all.push_back(measured(s, 3, [&] {
            return run(methods[s - 1], p, p.t1, {.rtol = 1e-6, .atol = 1e-6, .fixed_step = 0.2});
        }));
    print("stages", all);

    std::printf("\nthe same, N = 500, order chosen among s = 3, 5, 7, 9\n");
    all.clear();
    for (int k = 2; k <= 12; ++k) {
        const double tol = std::pow(10.0, -k);
        all.push_back(measured(tol, 3, [&] {
            return run(stagecraft::radau_iia_variable(), p, p.t1, {.rtol = tol, .atol = tol});
        }));
    }
    print("tolerance", all);

    const problems::sparse_brusselator large{{50000}};
    rusage before{}, after{};
    getrusage(RUSAGE_SELF, &before);
    const auto m =
        measured(1e5, 1, [&] { return run(methods[2], large, 1.0, {.rtol = 1e-4, .atol = 1e-4}); });
    getrusage(RUSAGE_SELF, &after);
    std::printf(
        "\n1e5 unknowns, t in [0, 1], s = 3, 1e-4: %.1f s, %ld steps, peak memory %ld MB (%ld before)\n",
        m.seconds, m.counts.steps, after.ru_maxrss / 1024, before.ru_maxrss / 1024);
}
