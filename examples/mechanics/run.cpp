// SPDX-License-Identifier: BSL-1.0
#include "run.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <stagecraft/integrate.hpp>
#include <stagecraft/radau_iia_variable.hpp>

namespace mechanics {

namespace {

/// Projects where the formulation does, and looks at what drifts where it is asked to.
struct watch {
    formulation f;  // a copy: its projection keeps matrices from step to step
    const body* looking = nullptr;
    double energy = 0;
    std::array<double, 3> worst{};

    bool correct(double t, VectorXd& y) { return f.correct && f.correct(t, y); }
    void operator()(double t, const VectorXd& y) {
        if (!looking) return;
        auto now = looking->look(t, y);
        now[2] = std::abs(now[2] - energy);
        for (std::size_t k = 0; k < worst.size(); ++k) worst[k] = std::max(worst[k], now[k]);
    }
};

/// A problem whose first rows are q' = v.
template <int Positions>
struct of_second_order : thesis::any_problem {
    static constexpr int second_order_components = Positions;
};

template <class Problem>
outcome run(const body& b, const formulation& f, const Problem& problem, double tolerance, int repeats) {
    outcome o;
    static const auto method = stagecraft::radau_iia_variable();
    const stagecraft::options<double> options{.rtol = tolerance, .atol = tolerance, .max_steps = 10'000'000};
    watch w{f, &b, b.look(0, f.y0)[2], {}};
    for (int k = 0; k <= repeats; ++k) {
        const std::clock_t start = std::clock();
        const auto r = stagecraft::integrate(method, problem, f.y0, 0.0, b.end, options, w);
        const double time = 1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        if (k == 0) {
            o = {r.ok(),     name(r.status),
                 r.y,        r.report.steps + r.report.rejected(),
                 r.report.f, std::numeric_limits<double>::infinity(),
                 w.worst};
            w.looking = nullptr;
        } else {
            o.microseconds = std::min(o.microseconds, time);
        }
    }
    return o;
}

}  // namespace

outcome run_ours(const body& b, const formulation& f, double tolerance, int repeats) {
    switch (f.positions) {
        case 3:
            return run(b, f, of_second_order<3>{f.problem}, tolerance, repeats);
        case 4:
            return run(b, f, of_second_order<4>{f.problem}, tolerance, repeats);
        case 5:
            return run(b, f, of_second_order<5>{f.problem}, tolerance, repeats);
        case 6:
            return run(b, f, of_second_order<6>{f.problem}, tolerance, repeats);
        case 7:
            return run(b, f, of_second_order<7>{f.problem}, tolerance, repeats);
        case 16:
            return run(b, f, of_second_order<16>{f.problem}, tolerance, repeats);
        default:
            return run(b, f, f.problem, tolerance, repeats);
    }
}

}  // namespace mechanics
