// SPDX-License-Identifier: BSL-1.0
// Error against run time for one problem of each kind that the library solves, as CSV. Each solution is known: in closed form,
// published, or stored with more digits than a double has. Ends with 1 where a run does not end well.
#include <cmath>
#include <cstdio>

#include "kinds.hpp"

namespace {
bool good = true;
}

void print(const char* kind, const char* problem, const char* method, int unknowns,
           const Eigen::VectorXd& exact, const std::function<outcome(double)>& run) {
    const std::vector<entrant> one{{method, [&](double tol, double) { return run(tol); }}};
    for (int digits = 3; digits <= 12; ++digits) {
        const auto error = [&](const Eigen::VectorXd& y) { return scaled_error(y, exact, 1); };
        const point p = measure(one, std::pow(10.0, -digits), 0, 5, 1, error).front();
        std::printf("%s,%s,%s,%d,%g,%.3e,%.4g\n", kind, problem, method, unknowns, p.tolerance, p.error,
                    p.minimum_us);
        if (!p.counts.ok) std::fprintf(stderr, "%s, %s, %g: no success\n", kind, problem, p.tolerance);
        good = good && p.counts.ok;
    }
}

int main() {
    std::puts("kind,problem,method,unknowns,tolerance,error,microseconds");
    initial_values();
    differential_algebraic();
    mechanics();
    boundary_values();
    return good ? 0 : 1;
}
