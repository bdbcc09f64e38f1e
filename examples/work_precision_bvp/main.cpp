// SPDX-License-Identifier: BSL-1.0
// Boundary value problems: error of the continuous solution against run time, ours beside COLNEW.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <iostream>

#include "../work_precision/report.hpp"
#include "problem.hpp"

namespace {

/// What a solver comes to at the tolerances that are counted.
struct totals {
    int runs = 0, solved = 0, false_successes = 0, estimated = 0, close = 0;
    std::string failures;
};

/// One solver at one tolerance: the least of a few run times, and what the last run left. Short runs are repeated for two
/// milliseconds a turn, so that every solver is seen with warm caches, whatever ran before it.
point measured(const bvp::solver& s, double tolerance, int repeats) {
    using clock = std::chrono::steady_clock;
    point result;
    bvp::result r;
    std::vector<double> times;
    double spent = 0;
    for (int k = 0; k < repeats && (k < 1 || spent < 3e5); ++k)
        for (const double end = spent + 2000; spent < end; spent += times.back()) {
            const auto start = clock::now();
            r = s.run(tolerance);
            times.push_back(std::chrono::duration<double, std::micro>(clock::now() - start).count());
        }
    std::sort(times.begin(), times.end());
    result.tolerance = tolerance;
    result.minimum_us = times.front(), result.median_us = times[times.size() / 2];
    result.error = s.error();
    result.counts.ok = r.success;
    result.counts.steps = r.intervals, result.counts.f = r.f, result.counts.jacobians = r.jacobians;
    result.counts.factorisations = r.factorisations;
    result.largest_error = r.estimate;
    if (!r.success) result.error = HUGE_VAL;
    return result;
}

void count(const point& p, totals& t, const std::string& name) {
    if (p.tolerance != 1e-4 && p.tolerance != 1e-7 && p.tolerance != 1e-10) return;
    char text[80];
    ++t.runs;
    const bool wrong = p.counts.ok && !(p.error <= 100 * p.tolerance);
    std::snprintf(text, sizeof text, "%s at %.0e%s", name.c_str(), p.tolerance,
                  wrong ? " (false success)" : "");
    if (p.counts.ok && !wrong)
        ++t.solved;
    else
        t.failures += (t.failures.empty() ? "" : ", ") + std::string(text);
    t.false_successes += wrong;
    if (!p.counts.ok || p.largest_error <= 0 || p.error < 1e-13) return;
    ++t.estimated;
    t.close += p.largest_error <= 10 * p.error && p.largest_error >= p.error / 10;
}

/// COLNEW with the number of collocation points that suits problem and tolerance best.
point best_of_colnew(const bvp::problem& p, double tolerance, int repeats) {
    std::optional<point> best;
    for (int k = tolerance < 1e-5 ? 4 : 2; k <= 7; ++k) {  // fewer points are never the best there
        const point here = measured(bvp::colnew(p, k), tolerance, repeats);
        const auto good = [](const point& x) { return x.counts.ok && x.error <= 10 * x.tolerance; };
        if (!best || (good(here) && !good(*best)) ||
            (good(here) == good(*best) && here.minimum_us < best->minimum_us))
            best = here;
    }
    return *best;
}

/// Both on one problem, from 1e-3 to 1e-12.
void compete(const bvp::problem& p, bool peer, int repeats, std::vector<curve>& curves, totals& ours,
             totals& theirs) {
    curve mine{p.name, "stagecraft", p.n, false, true, {}}, other{p.name, "colnew", p.n, false, false, {}};
    const auto solver = bvp::ours(p);
    for (int digits = 3; digits <= 12; ++digits) {
        const double tolerance = std::stod("1e-" + std::to_string(digits));
        mine.points.push_back(measured(solver, tolerance, repeats));
        count(mine.points.back(), ours, p.name);
        if (!peer) continue;
        other.points.push_back(best_of_colnew(p, tolerance, repeats));
        count(other.points.back(), theirs, p.name);
    }
    curves.push_back(mine);
    if (peer) curves.push_back(other);
}

/// Geometric mean over problems of the time ratio at equal error, and the worst of them.
void print_ratio(const std::vector<curve>& curves, int first, const std::string& where, bool small_only) {
    double sum = 0, worst = 0;
    int cases = 0, above = 0;
    std::string which;
    for (const curve& c : curves) {
        if (c.solver != "stagecraft" || (small_only && c.size != 2)) continue;
        const auto same = [&](const curve& other) { return other.problem == c.problem; };
        const time_ratio r = ratio_at_equal_error(curves, "stagecraft", "colnew", first, 10, same);
        if (r.points == 0) continue;
        sum += std::log(r.mean), ++cases;
        above += r.mean > 1;
        if (r.mean > worst) worst = r.mean, which = c.problem;
    }
    if (cases > 0)
        std::printf(
            "geometric mean time ratio to colnew (best k) at equal error%s: %.3f (%d cases), above 1: %d, "
            "worst %.2f (%s)\n",
            where.c_str(), std::exp(sum / cases), cases, above, worst, which.c_str());
}

}  // namespace

int main(int argc, char** argv) {
    std::string library, svg, only;
    int repeats = 5;
    bool stored_only = false, table = false;
    CLI::App app{"Boundary value problems: error against run time, ours beside COLNEW"};
    app.add_option("--colnew", library, "library that exports colnew_ and appsln_")->check(CLI::ExistingFile);
    app.add_option("--svg", svg, "write one work-precision diagram per problem to this directory");
    app.add_option("--problem", only, "only problems whose name begins so");
    app.add_option("--repeats", repeats, "runs of which the fastest counts")->check(CLI::PositiveNumber);
    app.add_flag("--stored", stored_only, "only the 23 problems with stored solutions");
    app.add_flag("--table", table, "print every run");
    CLI11_PARSE(app, argc, argv);
    const bool peer = !library.empty() && bvp::open_colnew(library);
    if (!peer) std::cout << "colnew is left out: --colnew names a library with colnew_ and appsln_\n";
    std::vector<bvp::problem> problems = bvp::stored();
    if (!stored_only)
        for (auto& p : bvp::closed_forms()) problems.push_back(std::move(p));
    std::vector<curve> curves;
    totals ours, theirs;
    for (const auto& p : problems) {
        if (p.name.rfind(only, 0) != 0) continue;
        std::cerr << p.name << "        \r" << std::flush;
        compete(p, peer, repeats, curves, ours, theirs);
    }
    if (curves.empty()) {
        std::cerr << "--problem: no problem of that name\n";
        return 2;
    }
    if (table) print_table(curves);
    if (!svg.empty()) write_diagrams(curves, svg);
    std::printf("not solved by ours: %s\n", ours.failures.c_str());
    if (peer) std::printf("not solved by colnew: %s\n", theirs.failures.c_str());
    print_ratio(curves, 3, "", false);
    print_ratio(curves, 8, " (n = 2, errors 1e-8 and below)", true);
    std::printf("estimated over true error within 1/10 ... 10: %d of %d\n", ours.close, ours.estimated);
    std::printf("solved at 1e-4, 1e-7, 1e-10 from the trivial guess: ours %d, colnew %d of %d\n", ours.solved,
                theirs.solved, ours.runs);
    std::printf("false successes: ours %d, colnew %d\n", ours.false_successes, theirs.false_successes);
}
