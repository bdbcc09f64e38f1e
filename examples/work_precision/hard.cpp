// SPDX-License-Identifier: BSL-1.0
// Five of the harder problems of the test set for initial value problems: how many runs end in success, with how many digits.
#include <array>
#include <cstdio>
#include <problems/test_set/charge_pump.hpp>
#include <problems/test_set/fekete.hpp>
#include <problems/test_set/hard_case.hpp>
#include <problems/test_set/nand_gate.hpp>
#include <problems/test_set/slider_crank.hpp>
#include <problems/test_set/water_tubes.hpp>

#include "compete.hpp"

namespace {

using problems::test_set::hard_case;

/// What RADAU5 sees between two break points, at whose end it asks f from the left.
struct piece {
    static constexpr int size = Eigen::Dynamic;
    const hard_case* whole;
    double t0, t1;
    Eigen::VectorXd start;
    const Eigen::VectorXd& initial() const { return start; }
    Eigen::VectorXd atol(double rtol) const { return rtol * whole->scale; }
    const Eigen::MatrixXd& mass() const { return whole->problem.mass(); }
    const std::vector<int>& index() const { return whole->problem.index(); }
    double inside(double t) const { return std::min(t, std::nextafter(t1, t0)); }
    void operator()(double t, const Eigen::VectorXd& y, Eigen::VectorXd& f) const {
        whole->problem(inside(t), y, f);
    }
    void jacobian(double t, const Eigen::VectorXd& y, Eigen::MatrixXd& J) const {
        whole->problem.jacobian(inside(t), y, J);
    }
};

outcome run_radau5(const hard_case& c, double tolerance, double t1) {
    outcome all{.y = c.initial, .ok = true, .status = "success"};
    for (double t = c.t0; all.ok && t < t1;) {
        const double end = c.break_points.next(t, t1);
        const outcome part = peers::radau(peers::radau5_symbol(), piece{&c, t, end, all.y}, tolerance, end);
        all.y = part.y, all.ok = part.ok, all.status = part.status, t = end;
        all.steps += part.steps, all.rejected += part.rejected, all.f += part.f;
        all.jacobians += part.jacobians, all.factorisations += part.factorisations;
    }
    return all;
}

template <class Method>
entrant ours(const char* name, const Method& method, const hard_case& c) {
    return {name, [&c, method](double tolerance, double t1) {
                return outcome_of(
                    stagecraft::integrate(method, c.problem, c.initial, c.t0, t1, c.options(tolerance)));
            }};
}

struct tally {
    std::string problem, solver;
    int runs = 0, successes = 0, false_successes = 0;
};

/// One row, and what it adds to the tally. A false success is off by more than 1000 tolerances in a component of index 1, or
/// not finite.
void print_run(const hard_case& c, const entrant& e, const point& p, tally& sum) {
    const outcome& r = p.counts;
    const double digits = c.mescd(r.y), of_index_2 = c.mescd(r.y, 2, 2);
    const bool wrong = r.ok && !(digits > -std::log10(p.tolerance) - 3);
    std::printf("%-7s %-15s %9.2e %-15s ", c.name.c_str(), e.solver.c_str(), p.tolerance, r.status.c_str());
    if (r.ok)
        std::printf("%6.2f %6.2f %7.2f ", c.scd(r.y), digits, std::isinf(of_index_2) ? NAN : of_index_2);
    else
        std::printf("%6s %6s %7s ", "", "", "");
    std::printf("%9.3f %6ld %5ld %7ld %6ld %6ld%s\n", p.minimum_us / 1000, r.steps - r.rejected, r.rejected,
                r.f, r.jacobians, r.factorisations, wrong ? "  false success" : "");
    ++sum.runs;
    sum.successes += r.ok;
    sum.false_successes += wrong;
}

}  // namespace

int compete_on_hard_problems(const settings& set) {
    using namespace problems::test_set;
    const std::array cases{make_case(charge_pump()), make_case(water_tubes()), make_case(fekete()),
                           make_case(nand_gate()), make_case(slider_crank())};
    std::vector<double> tolerances = set.tolerances;
    if (tolerances.empty())
        for (int m = 0; m <= 28; ++m) tolerances.push_back(std::pow(10.0, -3 - m / 4.0));
    std::vector<tally> sums;
    std::printf("%-7s %-15s %9s %-15s %6s %6s %7s %9s %6s %5s %7s %6s %6s\n", "problem", "solver",
                "tolerance", "status", "scd", "mescd", "index 2", "time [ms]", "steps", "rej", "f", "J",
                "LU");
    for (const hard_case& c : cases) {
        if (!wanted(set.problems, c.name)) continue;
        std::vector<entrant> all{ours("stagecraft", stagecraft::radau_iia_variable(), c),
                                 ours("stagecraft s=3", stagecraft::radau_iia<3>(), c)};
        if (peers::radau5_available())
            all.push_back({"radau5", [&c](double tol, double t1) { return run_radau5(c, tol, t1); }});
        std::erase_if(all, [&](const entrant& e) { return !wanted(set.solvers, e.solver); });
        const std::size_t first = sums.size();
        for (const entrant& e : all) sums.push_back({c.name, e.solver});
        for (const double tolerance : tolerances) {
            const auto points =
                measure(all, tolerance, c.t1, set.repeats, set.patience,
                        [&](const Eigen::VectorXd& y) { return std::pow(10.0, -c.mescd(y)); });
            for (std::size_t e = 0; e < all.size(); ++e) print_run(c, all[e], points[e], sums[first + e]);
        }
    }
    if (sums.empty()) {
        std::cerr << "--hard: no problem or solver of that name\n";
        return 2;
    }
    std::printf("\n%-7s %-15s %s\n", "problem", "solver", "runs, successes, of them false");
    for (const tally& s : sums)
        std::printf("%-7s %-15s %d %d %d\n", s.problem.c_str(), s.solver.c_str(), s.runs, s.successes,
                    s.false_successes);
    return 0;
}
