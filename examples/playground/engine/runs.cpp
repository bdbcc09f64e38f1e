// SPDX-License-Identifier: BSL-1.0
#include "runs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stagecraft/families.hpp>
#include <stagecraft/steps.hpp>
#include <stdexcept>
#include <string>

namespace playground {

namespace {

using Eigen::VectorXd;
using json = nlohmann::ordered_json;
constexpr std::size_t most_points = 4000;
constexpr int between = 5;  // points of the continuous solution in a step

/// Points of a curve; every second one is dropped whenever there are too many.
class curve {
  public:
    void add(double t, const VectorXd& y) {
        if (seen_++ % stride_ != 0) return;
        if (points_.size() == most_points) {
            for (std::size_t k = 0; 2 * k < points_.size(); ++k) points_[k] = points_[2 * k];
            points_.resize(points_.size() / 2);
            stride_ *= 2;
        }
        keep(t, y);
    }
    void keep(double t, const VectorXd& y) {
        points_.emplace_back(1, t);
        points_.back().insert(points_.back().end(), y.begin(), y.end());
    }
    const std::vector<std::vector<double>>& points() const { return points_; }

  private:
    std::vector<std::vector<double>> points_;
    std::size_t seen_ = 0, stride_ = 1;
};

json counts(const stagecraft::report<double>& r) {
    return {{"steps", r.steps},
            {"refused for the error", r.rejected_error},
            {"refused by Newton", r.rejected_newton},
            {"f", r.f},
            {"Jacobians", r.jacobians},
            {"factorisations", r.factorisations},
            {"linear systems", r.solves + r.error_solves}};
}

template <class Method>
json run_of(const Method& method, const problem& p, double t1, const stagecraft::options<double>& o) {
    auto steps = stagecraft::steps(method, p.f, p.y0, 0, t1, o);
    curve solution;
    json taken = json::array();
    long refused = 0, unsolved = 0;
    solution.add(0, p.y0);
    for (const auto& step : steps) {
        const auto& r = steps.report();
        for (int k = 1; k < between; ++k) {
            const double t = step.t - step.h * (between - k) / between;
            solution.add(t, step.output(t));
        }
        solution.add(step.t, step.y);
        taken.push_back({step.t, step.h, r.rejected_error - refused, r.rejected_newton - unsolved});
        refused = r.rejected_error, unsolved = r.rejected_newton;
    }
    solution.keep(steps.t(), steps.y());
    return {{"status", name(steps.status())},
            {"t", steps.t()},
            {"points", solution.points()},
            {"steps", taken},
            {"report", counts(steps.report())}};
}

template <class Method>
json error_of(const Method& method, const problem& p, double t1, int n, const VectorXd& solution) {
    const stagecraft::options<double> o{
        .rtol = 1e-12, .atol = 1e-12, .fixed_step = t1 / n, .max_steps = n + 10L};
    auto steps = stagecraft::steps(method, p.f, p.y0, 0, t1, o);
    for ([[maybe_unused]] const auto& step : steps) {
    }
    std::array<double, 4> largest{-1, -1, -1, -1};
    for (Eigen::Index i = 0; i < solution.size(); ++i) {
        double& e = largest[static_cast<std::size_t>(p.f.index()[static_cast<std::size_t>(i)])];
        e = std::max(e, std::abs(steps.y()[i] - solution[i]));
    }
    json errors;
    for (std::size_t k = 1; k < largest.size(); ++k)
        if (largest[k] >= 0) errors[std::to_string(k)] = largest[k];
    return {{"h", t1 / n}, {"f", steps.report().f}, {"status", name(steps.status())}, {"errors", errors}};
}

/// Where the steps h from `start` go: the last 40 of 340, nowhere if they leave every bound.
template <class Method>
void visit(const Method& method, const problem& p, double start, double h, std::set<double>& seen) {
    const stagecraft::options<double> o{.rtol = 1e-12, .atol = 1e-12, .fixed_step = h, .max_steps = 400};
    auto steps = stagecraft::steps(method, p.f, VectorXd(VectorXd::Constant(1, start)), 0, 340 * h, o);
    std::vector<double> last;
    int n = 0;
    for (const auto& step : steps) {
        if (!(std::abs(step.y[0]) < 1e3)) return;
        if (++n > 300) last.push_back(std::round(step.y[0] * 1e4) / 1e4);
    }
    if (steps.status() == stagecraft::status::success) seen.insert(last.begin(), last.end());
}

}  // namespace

json run(const runnable& method, const problem& p, double t1, const stagecraft::options<double>& o) {
    return std::visit([&](const auto& m) { return run_of(m, p, t1, o); }, method);
}

json error_at_end(const runnable& method, const problem& p, double t1, int n, const VectorXd& solution) {
    return std::visit([&](const auto& m) { return error_of(m, p, t1, n, solution); }, method);
}

VectorXd accurate(const problem& p, double t1) {
    auto steps = stagecraft::steps(stagecraft::radau_iia(5), p.f, p.y0, 0, t1,
                                   {.rtol = 1e-13, .atol = 1e-13, .max_steps = 20000});
    for ([[maybe_unused]] const auto& step : steps) {
    }
    if (steps.status() != stagecraft::status::success)
        throw std::runtime_error("no solution to compare with: a run with tolerances of 1e-13 ended with " +
                                 std::string(name(steps.status())));
    return steps.y();
}

json orbits(const runnable& method, const problem& p, double low, double high, int count) {
    json columns = json::array();
    for (int k = 0; k < count; ++k) {
        const double h = low + (high - low) * k / std::max(count - 1, 1);
        std::set<double> seen;
        for (const double start : {-0.2, 0.1, 0.7, 1.4})
            std::visit([&](const auto& m) { visit(m, p, start, h, seen); }, method);
        columns.push_back({h});
        for (const double x : seen) columns.back().push_back(x);
    }
    return columns;
}

}  // namespace playground
