// SPDX-License-Identifier: BSL-1.0
#include "report.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <set>
#include <stdexcept>

namespace {

std::vector<std::string> distinct(const std::vector<curve>& curves, std::string curve::*member) {
    std::vector<std::string> names;
    for (const curve& c : curves)
        if (std::find(names.begin(), names.end(), c.*member) == names.end()) names.push_back(c.*member);
    return names;
}

/// The largest error over the interval, where it is known.
std::string largest(const curve& c, const point& p) {
    char text[16] = "";
    if (c.references_inside) std::snprintf(text, sizeof text, "%.2e", p.largest_error);
    return text;
}

}  // namespace

void print_table(const std::vector<curve>& curves) {
    std::printf("%-14s %-16s %8s %10s %10s %12s %12s %9s %9s %7s %7s\n", "problem", "solver", "tol", "error",
                "max over t", "min us", "median us", "steps", "f", "J", "LU");
    for (const curve& c : curves)
        for (const point& p : c.points)
            std::printf("%-14s %-16s %8.0e %10.2e %10s %12.1f %12.1f %9ld %9ld %7ld %7ld%s\n",
                        c.problem.c_str(), c.solver.c_str(), p.tolerance, p.error, largest(c, p).c_str(),
                        p.minimum_us, p.median_us, p.counts.steps, p.counts.f, p.counts.jacobians,
                        p.counts.factorisations, p.counts.ok ? "" : "  stopped early");
}

void write_csv(const std::vector<curve>& curves, const std::string& file) {
    std::ofstream out(file);
    if (!out) throw std::runtime_error("--csv: cannot write " + file);
    out << "problem,solver,n,tolerance,error,largest_error,minimum_us,median_us,steps,f,jacobians,"
           "factorisations,ok\n";
    for (const curve& c : curves)
        for (const point& p : c.points)
            out << c.problem << ',' << c.solver << ',' << c.size << ',' << p.tolerance << ',' << p.error
                << ',' << largest(c, p) << ',' << p.minimum_us << ',' << p.median_us << ',' << p.counts.steps
                << ',' << p.counts.f << ',' << p.counts.jacobians << ',' << p.counts.factorisations << ','
                << p.counts.ok << '\n';
}

void write_diagrams(const std::vector<curve>& curves, const std::string& directory) {
    std::filesystem::create_directories(directory);
    for (const std::string& problem : distinct(curves, &curve::problem)) {
        const std::unique_ptr<FILE, int (*)(FILE*)> gnuplot(popen("gnuplot", "w"), pclose);
        if (!gnuplot) throw std::runtime_error("--svg: gnuplot could not be started; install gnuplot-nox");
        std::FILE* g = gnuplot.get();
        std::fprintf(
            g,
            "set terminal svg size 760,560 font 'sans,13' background 'white'\nset output '%s/%s.svg'\n"
            "set logscale xy\nset format '10^{%%L}'\nset grid lc rgb '#dddddd'\nset key outside right\n"
            "set xlabel 'error'\nset ylabel 'time / microseconds'\nset title '%s'\nset xrange [] reverse\n",
            directory.c_str(), problem.c_str(), problem.c_str());
        std::string plot = "plot ";
        for (const curve& c : curves)
            if (c.problem == problem)
                plot += "'-' using 1:2 with linespoints pt 7 ps 0.5 lw " +
                        std::string(c.solver == "stagecraft" ? "3" : "1.5") + " title '" + c.solver + "', ";
        std::fprintf(g, "%s\n", plot.substr(0, plot.size() - 2).c_str());
        for (const curve& c : curves) {
            if (c.problem != problem) continue;
            for (const point& p : c.points)
                if (std::isfinite(p.error) && p.error > 0 && p.error < 10)
                    std::fprintf(g, "%g %g\n", p.error, p.minimum_us);
            std::fprintf(g, "e\n");
        }
    }
}

/// The mean of the time ratio over the problems that are `counted`, and the worst of them.
template <class Counted>
static void print_mean(const std::vector<curve>& curves, const std::string& ours, const std::string& peer,
                       const std::string& what, const Counted& counted) {
    double sum = 0, worst = 0;
    int count = 0;
    std::string which;
    for (const std::string& problem : distinct(curves, &curve::problem)) {
        const auto this_one = [&](const curve& c) { return c.problem == problem && counted(c); };
        const time_ratio r = ratio_at_equal_error(curves, ours, peer, 3, 10, this_one);
        if (r.points == 0) continue;
        sum += std::log(r.mean), ++count;
        if (r.mean > worst) worst = r.mean, which = problem;
    }
    if (count > 0)
        std::printf("to %s, %s: mean %.3f over %d problems, worst %.3f (%s)\n", peer.c_str(), what.c_str(),
                    std::exp(sum / count), count, worst, which.c_str());
}

/// Per peer and class the mean over its problems, and the worst of them.
static void print_classes(const std::vector<curve>& curves, const std::string& ours) {
    for (const std::string& peer : distinct(curves, &curve::solver)) {
        if (peer.starts_with(ours)) continue;
        std::set<std::string> classes;
        for (const curve& c : curves) classes.insert(class_of(c));
        for (const std::string& name : classes)
            print_mean(curves, ours, peer, name, [&](const curve& c) { return class_of(c) == name; });
    }
}

/// The same for explicit methods, each beside the peers with its coefficients.
static void print_explicit(const std::vector<curve>& curves) {
    const auto everything = [](const curve&) { return true; };
    print_mean(curves, "stagecraft 5(4)", "dopri5", "explicit", everything);
    print_mean(curves, "stagecraft 5(4)", "odeint", "explicit", everything);
    print_mean(curves, "stagecraft 8(5,3)", "dop853", "explicit", everything);
}

void print_same_tables(const std::vector<curve>& curves) {
    double sum = 0, worst = 0;
    int count = 0;
    std::printf(
        "time of ours to ARKODE's at equal error 1e-2 ... 1e-8, evaluations of both parts at equal "
        "tolerance\n");
    for (const std::string& problem : distinct(curves, &curve::problem))
        for (const char* table : {"ark3", "ark4", "ark5"}) {
            const auto here = [&](const curve& c) { return c.problem == problem; };
            const std::string a = std::string("stagecraft ") + table, b = std::string("arkode ") + table;
            const time_ratio r = ratio_at_equal_error(curves, a, b, 2, 8, here);
            if (r.points == 0) continue;
            double calls = 0;
            int same = 0;
            for (const curve& x : curves)
                for (const curve& y : curves)
                    if (here(x) && here(y) && x.solver == a && y.solver == b)
                        for (std::size_t k = 0; k < x.points.size(); ++k, ++same)
                            calls += std::log(static_cast<double>(x.points[k].counts.f) /
                                              static_cast<double>(y.points[k].counts.f));
            std::printf("%-20s %s: time %.3f (%d points), evaluations %.2f\n", problem.c_str(), table, r.mean,
                        r.points, std::exp(calls / same));
            sum += std::log(r.mean), ++count;
            worst = std::max(worst, r.mean);
        }
    if (count > 0) std::printf("mean %.3f of %d, worst %.3f\n", std::exp(sum / count), count, worst);
    std::printf("compiled by %s with %s\n", COMPILER, OPTIMISATION);
}

void print_ratios(const std::vector<curve>& curves, const std::string& ours) {
    const auto line = [&](const std::string& peer, const std::string& where, int first, int last,
                          const auto& counted) {
        const time_ratio r = ratio_at_equal_error(curves, ours, peer, first, last, counted);
        if (r.points > 0)
            std::printf("geometric mean time ratio to %s at equal error%s: %.3f (%d points)\n", peer.c_str(),
                        where.c_str(), r.mean, r.points);
    };
    const auto everything = [](const curve&) { return true; };
    const auto small = [](const curve& c) { return c.size <= 12; };
    for (const std::string& peer : distinct(curves, &curve::solver)) {
        if (peer.starts_with(ours)) continue;
        line(peer, "", 3, 10, everything);
        line(peer, " (n <= 12, errors 1e-8 and below)", 8, 10, small);
        line(peer, " (errors 1e-6 and below)", 6, 10, everything);
        for (const std::string& problem : distinct(curves, &curve::problem))
            line(peer, " (" + problem + ")", 3, 10, [&](const curve& c) { return c.problem == problem; });
    }
    print_classes(curves, ours);
    print_explicit(curves);
    std::printf("compiled by %s with %s\n", COMPILER, OPTIMISATION);
}
