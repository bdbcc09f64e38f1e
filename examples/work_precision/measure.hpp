// SPDX-License-Identifier: BSL-1.0
// Error against run time: repeated, interleaved measurements and what is read off them.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "run.hpp"

/// One solver at one tolerance on one problem.
struct point {
    double tolerance, error = 0, minimum_us = 0, median_us = 0;
    double largest_error = 0;  ///< over the times with a reference, the end among them
    outcome counts;
};

struct curve {
    std::string problem, solver;
    int size = 0;
    bool banded = false;
    bool references_inside = false;  ///< the reference is known at times before the end as well
    std::vector<point> points;
};

/// The solution at a time.
struct reference_point {
    double t;
    Eigen::VectorXd y;
};

/// A solver on a problem: what to run for a tolerance, from the problem's t0 to t1.
struct entrant {
    std::string solver;
    std::function<outcome(double tolerance, double t1)> run;
};

/// The size and structure a problem stands for.
inline const char* class_of(const curve& c) {
    return c.banded ? "banded" : c.size <= 15 ? "n <= 15" : c.size <= 100 ? "n = 16 ... 100" : "n > 100";
}

/// Runs every entrant `repeats` times at one tolerance, in turn (A B C A B C ...), so that a slow moment of
/// the machine hits all of them. A turn lasts at least two milliseconds: short runs are repeated in it, so
/// that every solver is seen with warm caches, whoever came before. A run much longer than `patience` seconds
/// in all is repeated less often.
inline std::vector<point> measure(const std::vector<entrant>& entrants, double tolerance, double t1,
                                  int repeats, double patience,
                                  const std::function<double(const Eigen::VectorXd&)>& error) {
    using clock = std::chrono::steady_clock;
    const auto microseconds = [](auto a, auto b) {
        return std::chrono::duration<double, std::micro>(b - a).count();
    };
    std::vector<point> points(entrants.size());
    std::vector<std::vector<double>> times(entrants.size());
    std::vector<double> spent(entrants.size(), 0);
    for (int k = 0; k < repeats; ++k)
        for (std::size_t e = 0; e < entrants.size(); ++e) {
            if (k >= 2 && spent[e] > patience * 1e6) continue;
            for (const double end = spent[e] + 2000; spent[e] < end; spent[e] += times[e].back()) {
                const auto start = clock::now();
                points[e].counts = entrants[e].run(tolerance, t1);
                times[e].push_back(microseconds(start, clock::now()));
            }
        }
    for (std::size_t e = 0; e < entrants.size(); ++e) {
        auto& t = times[e];
        std::sort(t.begin(), t.end());
        points[e].tolerance = tolerance;
        points[e].minimum_us = t.front();
        points[e].median_us = t[t.size() / 2];
        const bool usable = points[e].counts.ok && points[e].counts.y.allFinite();
        points[e].error = usable ? error(points[e].counts.y) : std::numeric_limits<double>::infinity();
    }
    return points;
}

/// Time at a given error, interpolated in log-log between neighbouring tolerances; nothing where the curve
/// does not bracket the error. Where it crosses more than once, the cheapest crossing counts.
inline std::optional<double> time_at(const curve& c, double error) {
    std::optional<double> best;
    for (std::size_t i = 0; i + 1 < c.points.size(); ++i) {
        const point &a = c.points[i], &b = c.points[i + 1];
        if (!std::isfinite(a.error) || !std::isfinite(b.error) || a.error <= 0 || b.error <= 0) continue;
        const double la = std::log(a.error), lb = std::log(b.error), l = std::log(error);
        if (la == lb || (l - la) * (l - lb) > 0) continue;
        const double w = (l - la) / (lb - la);
        const double t = std::exp((1 - w) * std::log(a.minimum_us) + w * std::log(b.minimum_us));
        if (!best || t < *best) best = t;
    }
    return best;
}

/// Geometric mean over problems and over the errors 10^-first ... 10^-last of time(ours)/time(peer).
struct time_ratio {
    double mean = std::numeric_limits<double>::quiet_NaN();
    int points = 0;
};
inline time_ratio ratio_at_equal_error(const std::vector<curve>& curves, const std::string& ours,
                                       const std::string& peer, int first, int last,
                                       const std::function<bool(const curve&)>& counted) {
    double sum = 0;
    time_ratio result;
    for (const curve& a : curves) {
        if (a.solver != ours || !counted(a)) continue;
        for (const curve& b : curves) {
            if (b.solver != peer || b.problem != a.problem) continue;
            for (int k = first; k <= last; ++k) {
                const auto ta = time_at(a, std::pow(10.0, -k)), tb = time_at(b, std::pow(10.0, -k));
                if (ta && tb) sum += std::log(*ta / *tb), ++result.points;
            }
        }
    }
    if (result.points > 0) result.mean = std::exp(sum / result.points);
    return result;
}
