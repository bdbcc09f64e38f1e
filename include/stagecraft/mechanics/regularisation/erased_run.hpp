// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <functional>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include <stagecraft/integrate.hpp>

namespace stagecraft::detail {

/// A problem behind one type, so that one integrator is compiled whatever is expanded.
struct erased_problem {
    std::function<void(double, const Eigen::VectorXd&, Eigen::VectorXd&)> f;
    Eigen::MatrixXd M;
    std::vector<int> flags{};  ///< index of each component; empty: 1 for all
    void operator()(double t, const Eigen::VectorXd& y, Eigen::VectorXd& out) const { f(t, y, out); }
    const Eigen::MatrixXd& mass() const { return M; }
    const std::vector<int>& index() const { return flags; }
};

/// The solution with y(0) = y0 at increasing times >= 0, one column each, by the three-stage Radau IIA
/// method. Throws std::invalid_argument if the times are not in order, std::runtime_error if the run fails,
/// each beginning with `who`.
inline Eigen::MatrixXd run(const std::string& who, erased_problem problem, const Eigen::VectorXd& y0,
                           const std::vector<double>& times, double tolerance) {
    if (!std::is_sorted(times.begin(), times.end()) || (!times.empty() && !(times.front() >= 0)))
        throw std::invalid_argument(who + ": times must increase from 0 on");
    Eigen::MatrixXd values = y0.replicate(1, static_cast<Eigen::Index>(times.size()));
    if (times.empty() || times.back() == 0) return values;
    if (problem.flags.empty()) problem.flags.assign(static_cast<std::size_t>(y0.size()), 1);
    std::size_t next = 0;
    const auto keep = [&](double t, const Eigen::VectorXd&, double, const auto& output) {
        for (; next < times.size() && times[next] <= t; ++next)
            if (times[next] > 0) values.col(static_cast<Eigen::Index>(next)) = output(times[next]);
    };
    const auto r = integrate(radau_iia<3>(), problem, y0, 0.0, times.back(),
                             {.rtol = tolerance, .atol = tolerance}, keep);
    if (!r.ok()) throw std::runtime_error(who + ": a run ended with " + std::string(name(r.status)));
    return values;
}

}  // namespace stagecraft::detail
