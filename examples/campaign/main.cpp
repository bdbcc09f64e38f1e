// SPDX-License-Identifier: BSL-1.0
// build/campaign [CLASS ...] [--seed N] [--runs N] [--most N]: random problems of every class, each at four tolerances with
// the integrators of fixed and variable order, beside RADAU5 where it is installed. Counts failures, and false
// successes: runs that end in success with an accepted step whose error exceeds 1,000 tolerances, component by
// component, those of index 2 and 3 times |h| and h^2; of boundary values 10 tolerances anywhere, and how many error
// estimates are right within 10.
#include <CLI/CLI.hpp>
#include <iomanip>
#include <iostream>
#include <map>
#include <vector>

#include "problem.hpp"

namespace {

using namespace campaign;

struct entrant {
    std::string name;
    int stages;  // 0: variable order, -1: RADAU5
};

struct counts {
    long runs = 0, failures = 0, false_successes = 0, steps = 0, estimates = 0, close = 0;
    double worst = 0, most = 1000;  ///< most: an error above it, in tolerances, is a false success
    std::map<std::string, long> reasons;

    void add(const outcome& o) {
        ++runs;
        steps += o.steps;
        estimates += o.estimate > 0;
        close += o.estimate >= 0.1 && o.estimate <= 10;
        if (!o.success) {
            ++failures;
            ++reasons[o.status];
        } else {
            worst = std::max(worst, o.worst);
            if (o.worst > most) ++false_successes;
        }
    }
};

void print_row(const std::string& kind, const std::string& name, const counts& c) {
    std::cout << std::left << std::setw(14) << kind << std::setw(10) << name << std::right << std::setw(7)
              << c.runs << std::setw(10) << c.failures << std::setw(8) << c.false_successes << std::setw(11)
              << std::setprecision(2) << std::scientific << c.worst << std::setw(10) << c.steps;
    if (c.estimates > 0) std::cout << "  " << c.close << " of " << c.estimates << " estimates within 10";
    for (const auto& [why, times] : c.reasons) std::cout << "  " << why << ' ' << times;
    std::cout << '\n';
}

const std::map<std::string, problem (*)(dice)> classes{
    {"linear", linear},   {"nonlinear", nonlinear}, {"index_1", index_1},
    {"index_2", index_2}, {"index_3", index_3},     {"pendulum", pendulum},
    {"jumps", jumps},     {"switching", switching}, {"approximate", approximate},
    {"signal", signal},   {"schedules", schedules}, {"doses", doses},
    {"domains", domains}};
const std::vector<double> tolerances{1e-4, 1e-6, 1e-8, 1e-10},
    all_tolerances{1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12};

struct settings {
    unsigned seed = 1;
    int runs = 100, only = -1;
    long most = -1;
    bool verbose = false;
};

void tell(const std::string& kind, const std::string& name, int number, double tol, const std::string& what,
          const outcome& o, double most = 1000) {
    const bool close = o.estimate == 0 || (o.estimate >= 0.1 && o.estimate <= 10);
    if (o.success && o.worst <= most && close) return;
    std::cout << "  " << kind << " --only " << number << " (" << what << "), " << name << " at "
              << std::setprecision(0) << std::scientific << tol << ": " << o.status
              << " at t = " << std::setprecision(17) << std::defaultfloat << o.t << ", "
              << std::setprecision(2) << o.worst << " tolerances, " << o.steps << " steps";
    std::cout << (close ? "\n" : ", estimated times " + std::to_string(o.estimate) + "\n");
}

/// Returns how many runs of this library failed or ended in a false success.
long run_class(const std::string& kind, problem (*draw)(dice), const settings& s) {
    std::vector<entrant> entrants{{"s = 3", 3}, {"s = 5", 5}, {"s = 7", 7}, {"variable", 0}};
    if (draw(dice(s.seed, 0)).said()) entrants = {{"s = 3", 3}, {"variable", 0}};
    if (radau5_available()) entrants.push_back({"RADAU5", -1});
    std::vector<counts> all(entrants.size());
    for (int k = s.only < 0 ? 0 : s.only; k < (s.only < 0 ? s.runs : s.only + 1); ++k) {
        const problem p = draw(dice(s.seed, k));
        for (const double tol : kind == "approximate" ? all_tolerances : tolerances)
            for (std::size_t e = 0; e < entrants.size(); ++e) {
                const outcome o =
                    entrants[e].stages < 0 ? run_radau5(p, tol) : run(entrants[e].stages, p, tol);
                all[e].add(o);
                if (s.verbose) tell(kind, entrants[e].name, k, tol, p.description, o);
            }
    }
    long bad = 0;
    for (std::size_t e = 0; e < entrants.size(); ++e) {
        print_row(kind, entrants[e].name, all[e]);
        if (entrants[e].stages >= 0) bad += all[e].failures + all[e].false_successes;
    }
    return bad;
}

/// Classes that one solver runs: its name, and what is a false success.
struct single {
    outcome (*run)(dice, double);
    const char* method;
    double most;
};
const std::map<std::string, single> singles{{"events", {run_events, "s = 3", 1000}},
                                            {"interior", {run_interior, "Gauss 5", 10}},
                                            {"integral", {run_integral, "Gauss 5", 10}},
                                            {"free_length", {run_free_length, "Gauss 5", 10}},
                                            {"semi_infinite", {run_semi_infinite, "Gauss 5", 10}}};

long run_single_class(const std::string& kind, const single& c, const settings& s) {
    counts all;
    all.most = c.most;
    for (int k = s.only < 0 ? 0 : s.only; k < (s.only < 0 ? s.runs : s.only + 1); ++k)
        for (const double tol : tolerances) {
            const outcome o = c.run(dice(s.seed, k), tol);
            all.add(o);
            if (s.verbose) tell(kind, c.method, k, tol, "drawn", o, c.most);
        }
    print_row(kind, c.method, all);
    return all.failures + all.false_successes;
}

}  // namespace

int main(int argc, char** argv) {
    settings s;
    std::vector<std::string> chosen;
    CLI::App app{"Random problems with known solutions: failures and false successes, beside RADAU5's."};
    std::vector<std::string> names;
    for (const auto& c : classes) names.push_back(c.first);
    for (const auto& c : singles) names.push_back(c.first);
    app.add_option("class", chosen, "classes to run, all by default")->check(CLI::IsMember(names));
    app.add_option("--seed", s.seed, "of the random numbers")->capture_default_str();
    app.add_option("--runs", s.runs, "problems of each class")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    app.add_option("--only", s.only, "the one problem of this number");
    app.add_option("--most", s.most,
                   "exit with 1 where more runs (not RADAU5's) fail or end in a false success");
    app.add_flag("--verbose", s.verbose, "a line for each failure and false success");
    CLI11_PARSE(app, argc, argv);

    std::cout << "class         method       runs  failures   false      worst     steps  (seed " << s.seed
              << ", " << s.runs
              << " problems at 1e-4, 1e-6, 1e-8, 1e-10, approximate ones at 1e-2 and 1e-12 as well)\n";
    const auto wanted = [&](const std::string& name) {
        return chosen.empty() || std::find(chosen.begin(), chosen.end(), name) != chosen.end();
    };
    long bad = 0;
    for (const auto& [name, draw] : classes)
        if (wanted(name)) bad += run_class(name, draw, s);
    for (const auto& [name, one] : singles)
        if (wanted(name)) bad += run_single_class(name, one, s);
    return s.most >= 0 && bad > s.most ? 1 : 0;
}
