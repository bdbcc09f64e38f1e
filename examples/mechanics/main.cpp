// SPDX-License-Identifier: BSL-1.0
// Which formulation of constrained mechanics when: steps, f, time, drift and error of each on six models.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "run.hpp"

namespace mechanics {

namespace {

struct reference {
    VectorXd y, lambda;  // (q, v) and lambda at the end
};

VectorXd numbers(const nlohmann::json& list) {
    VectorXd r(static_cast<Eigen::Index>(list.size()));
    for (Eigen::Index i = 0; i < r.size(); ++i)
        r[i] = std::stod(list[static_cast<std::size_t>(i)].get<std::string>());
    return r;
}

reference stored(const body& b) {
    std::ifstream in(std::string(DATA_DIR) + "/" + b.name + ".json");
    if (!in) throw std::runtime_error("no reference for " + b.name);
    const auto data = nlohmann::json::parse(in);
    return {numbers(data.at("y")), numbers(data.at("lambda"))};
}

thesis::vector_of<long double> by_gauss(const thesis::setup_of<long double>& setup, double end, int stages,
                                        double tolerance) {
    return thesis::solve<long double>(
               setup, {.method = thesis::family::gauss, .stages = stages, .tolerance = tolerance, .end = end})
        .path.back()
        .y;
}

/// Computes the reference by Gauss methods of two orders on the index-reduced equation in long double and writes
/// it, with the distance of the two, and of the second way where there is one.
void compute(const body& b) {
    using wide = thesis::vector_of<long double>;
    const wide y = by_gauss(b.wide(), b.end, 8, 1e-17), other = by_gauss(b.wide(), b.end, 6, 1e-16),
               lambda = b.wide_multiplier(y);
    const auto text = [](const wide& x) {
        std::vector<std::string> list;
        for (const long double v : x) {
            char digits[40];
            std::snprintf(digits, sizeof digits, "%.17Le", v);
            list.push_back(digits);
        }
        return list;
    };
    nlohmann::ordered_json data;
    data["model"] = b.name;
    data["t"] = b.end;
    data["method"] =
        "build/mechanics --reference: index-reduced equation in long double, Gauss s = 8, tolerance 1e-17";
    data["distance_to_s_6_tolerance_1e-16"] = static_cast<double>((y - other).cwiseAbs().maxCoeff());
    if (b.alone.setup)
        data["distance_to_minimal_coordinates"] = static_cast<double>(
            (y - b.alone.state(by_gauss(b.alone.setup(), b.end, 8, 1e-17))).cwiseAbs().maxCoeff());
    data["y"] = text(y);
    data["lambda"] = text(lambda);
    std::ofstream(std::string(DATA_DIR) + "/" + b.name + ".json") << data.dump(1) << '\n';
    std::cout << b.name << ": the two differ by " << data["distance_to_s_6_tolerance_1e-16"] << '\n';
}

std::string text(const char* format, double x) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, format, x);
    return buffer;
}

/// max |e_i| / (1 + |y_i|).
double distance(const VectorXd& y, const VectorXd& exact) {
    return ((y - exact).array().abs() / (1 + exact.array().abs())).maxCoeff();
}

/// Time against error over the tolerances.
struct curve {
    std::vector<double> error, time;

    /// By interpolation in logarithms; nothing where the error is not bracketed.
    std::optional<double> time_at(double e) const {
        std::optional<double> best;
        for (std::size_t i = 0; i + 1 < error.size(); ++i) {
            const double a = std::log(error[i]), b = std::log(error[i + 1]), l = std::log(e);
            if (!std::isfinite(a) || !std::isfinite(b) || a == b || (l - a) * (l - b) > 0) continue;
            const double w = (l - a) / (b - a),
                         t = std::exp((1 - w) * std::log(time[i]) + w * std::log(time[i + 1]));
            if (!best || t < *best) best = t;
        }
        return best;
    }
};

/// Geometric mean of a's time over b's at the errors 1e-3 ... 1e-9 that both reach.
double ratio(const curve& a, const curve& b) {
    double sum = 0;
    int count = 0;
    for (int k = 3; k <= 9; ++k) {
        const auto ta = a.time_at(std::pow(10, -k)), tb = b.time_at(std::pow(10, -k));
        if (ta && tb) sum += std::log(*ta / *tb), ++count;
    }
    return count > 0 ? std::exp(sum / count) : std::nan("");
}

/// One line of the summary: a formulation over the models.
using summary = std::map<std::string, std::map<std::string, std::string>>;

struct entrant {
    std::string name;
    outcome (*run)(const body&, const formulation&, double, int);
    const formulation* f;
};

std::vector<entrant> entrants(const body& b) {
    std::vector<entrant> all;
    for (const auto& f : b.formulations) all.push_back({f.name, run_ours, &f});
    if (radau5_available())
        for (const auto& f : b.formulations)
            if (f.name == "index 3" || f.name == "stabilised index 2" || f.name == "index 2")
                all.push_back({"RADAU5, " + f.name, run_radau5, &f});
    return all;
}

void print(const entrant& e, int power, const outcome& o, double error, double of_multiplier) {
    if (!o.ok)
        std::printf("%-28s 1e-%-2d %s\n", e.name.c_str(), power, o.status.c_str());
    else
        std::printf("%-28s 1e-%-2d %7ld %7ld %9.3f %9.1e %9.1e %9.1e %9.1e %9.1e\n", e.name.c_str(), power,
                    o.steps, o.f, o.microseconds / 1000, o.drift[0], o.drift[1], o.drift[2], error,
                    of_multiplier);
}

void print_ratios(const std::vector<entrant>& all, const std::vector<curve>& curves) {
    for (std::size_t peer = 0; peer < all.size(); ++peer) {
        if (all[peer].run != run_radau5) continue;
        std::printf("time to %s at equal error:", all[peer].name.c_str());
        for (std::size_t i = 0; i < all.size(); ++i)
            if (all[i].run == run_ours)
                std::printf("%s %s %.2f", i > 0 ? "," : "", all[i].name.c_str(),
                            ratio(curves[i], curves[peer]));
        std::printf("\n");
    }
}

/// Runs everything over the tolerances 1e-3 ... 1e-11. False if one of ours did not succeed, or is off by more than
/// 1e-5 at tolerance 1e-9 (index 3 leaves the velocities the least accurate).
bool report(const body& b, int repeats, summary& lines) {
    const reference exact = stored(b);
    const auto all = entrants(b);
    std::printf("\n%s, t = 0 ... %g, %d coordinates, %d constraints\n", b.name.c_str(), b.end, b.n, b.m);
    if (b.published.size() > 0) {
        const double start = b.look(0, b.formulations.front().y0)[2];
        std::printf("the published q, v differ from the reference by %.1e, %.1e;",
                    distance(b.published.head(b.n), exact.y.head(b.n)),
                    distance(b.published.tail(b.n), exact.y.tail(b.n)));
        std::printf(
            " |G v + b| and the change of energy are %.1e, %.1e in them, %.1e, %.1e in the reference\n",
            b.look(b.end, b.published)[1], b.look(b.end, b.published)[2] - start, b.look(b.end, exact.y)[1],
            b.look(b.end, exact.y)[2] - start);
    }
    bool good = true;
    if (b.alone.setup) {
        const VectorXd way = b.alone.state(by_gauss(b.alone.setup(), b.end, 6, 1e-15)).cast<double>();
        good = distance(way, exact.y) < 1e-12;
        std::printf("the motion in minimal coordinates differs from the reference by %.1e\n",
                    distance(way, exact.y));
    }
    std::printf("%-28s %5s %7s %7s %9s %9s %9s %9s %9s %9s\n", "", "tol", "steps", "f", "ms", "|g|", "|Gv+b|",
                "energy", "q, v", "lambda");
    std::vector<curve> curves(all.size());
    std::vector<std::string> drift(all.size());
    for (int power = 3; power <= 11; ++power)
        for (std::size_t i = 0; i < all.size(); ++i) {
            const entrant& e = all[i];
            const outcome o = e.run(b, *e.f, std::pow(10, -power), repeats);
            good = good && (o.ok || e.run != run_ours);
            curves[i].error.push_back(o.ok ? distance(o.y.head(2 * b.n), exact.y) : INFINITY);
            curves[i].time.push_back(o.microseconds);
            if (power == 9 && e.run == run_ours) good = good && curves[i].error.back() < 1e-5;
            if (power != 6 && power != 9) continue;
            print(e, power, o, curves[i].error.back(),
                  o.ok ? distance(e.f->multiplier(b.end, o.y), exact.lambda) : INFINITY);
            if (power == 9) drift[i] = text("%.0e, ", o.drift[0]) + text("%.0e", o.drift[1]);
        }
    print_ratios(all, curves);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto time = curves[i].time_at(1e-6);
        lines[all[i].name][b.name] = (time ? text("%.2f", *time / 1000) : "-") + "; " + drift[i];
    }
    return good;
}

void print(const summary& lines, const std::vector<std::string>& models) {
    std::printf("\nTime in ms at error 1e-6; largest |g| and |G v + b| at tolerance 1e-9\n\n| |");
    for (const auto& m : models) std::printf(" %s |", m.c_str());
    std::printf("\n|---|");
    for (std::size_t k = 0; k < models.size(); ++k) std::printf("---|");
    std::printf("\n");
    for (const auto& [name, cells] : lines) {
        std::printf("| %s |", name.c_str());
        for (const auto& m : models) std::printf(" %s |", cells.count(m) ? cells.at(m).c_str() : "");
        std::printf("\n");
    }
}

}  // namespace

}  // namespace mechanics

int main(int argc, char** argv) {
    CLI::App app("Formulations of constrained mechanics compared");
    bool report = false, reference = false;
    int repeats = 3;
    std::string only;
    app.add_flag("--report", report, "the table (the default)");
    app.add_flag("--reference", reference, "compute the references of examples/mechanics/data anew");
    app.add_option("--repeat", repeats, "timed runs of each, of which the fastest counts")
        ->check(CLI::Range(1, 1000));
    app.add_option("--only", only,
                   "one model: double_pendulum, squeezer, disc, chain, slider_crank or four_bar");
    CLI11_PARSE(app, argc, argv);
    try {
        bool good = true;
        mechanics::summary lines;
        std::vector<std::string> models;
        for (const auto make : {mechanics::double_pendulum, mechanics::squeezer, mechanics::disc,
                                mechanics::chain, mechanics::slider_crank, mechanics::four_bar}) {
            const mechanics::body b = make();
            if (!only.empty() && b.name != only) continue;
            if (reference)
                mechanics::compute(b);
            else
                good = mechanics::report(b, repeats, lines) && good;
            models.push_back(b.name);
        }
        if (!reference) mechanics::print(lines, models);
        return good ? 0 : 1;
    } catch (const std::exception& e) {
        std::cerr << "mechanics: " << e.what() << '\n';
        return 1;
    }
}
