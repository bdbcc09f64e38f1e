// SPDX-License-Identifier: BSL-1.0
// A problem of this folder behind one type, with what a run of it needs and how its result is judged.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <stagecraft/break_points.hpp>
#include <stagecraft/options.hpp>
#include <stagecraft/problem/erased.hpp>
#include <string>
#include <utility>
#include <vector>

namespace problems::test_set {

/// f, mass and index of a problem without its break_points(), which erased() leaves to the options.
template <class Problem>
struct without_break_points {
    Problem problem;
    void operator()(double t, const auto& y, auto& f) const { problem(t, y, f); }
    auto mass() const { return problem.mass(); }
    auto index() const { return problem.index(); }
};

struct hard_case {
    std::string name;
    stagecraft::erased_dae problem;
    double t0, t1;
    Eigen::VectorXd initial, reference;  ///< reference: NaN where nothing is published
    Eigen::VectorXd scale;               ///< atol / rtol of each component
    stagecraft::break_times<double> break_points;

    stagecraft::options<double> options(double tolerance) const {
        stagecraft::options<double> o;
        o.rtol = o.atol = tolerance;
        o.atol_components = tolerance * scale;
        o.break_points = break_points;
        return o;
    }
    /// -log10 of the largest relative error, over components of index 1 (`highest` = 1) or all, whose reference is not 0.
    double scd(const Eigen::VectorXd& y, int highest = 1) const { return digits(y, highest, 0); }
    /// The same of |error| / (atol / rtol + |reference|), over those of index `lowest` ... `highest`.
    double mescd(const Eigen::VectorXd& y, int lowest = 1, int highest = 1) const {
        return digits(y, highest, 1, lowest);
    }

  private:
    double digits(const Eigen::VectorXd& y, int highest, double absolute, int lowest = 1) const {
        double largest = 0;
        for (Eigen::Index i = 0; i < y.size(); ++i) {
            const int index = problem.index()[static_cast<std::size_t>(i)];
            const double size = std::abs(reference[i]) + absolute * scale[i];
            if (index < lowest || index > highest || !(size > 0)) continue;
            const double error = std::abs(y[i] - reference[i]) / size;
            if (!(error <= largest)) largest = error;  // NaN stays
        }
        return -std::log10(largest);
    }
};

template <class Problem>
hard_case make_case(Problem problem) {
    hard_case c{Problem::name,     stagecraft::erased(without_break_points<Problem>{problem}),
                Problem::t0,       Problem::t1,
                problem.initial(), problem.reference(),
                Eigen::VectorXd(), {}};
    c.scale = Eigen::VectorXd::Ones(c.initial.size());
    if constexpr (requires { problem.scale(); }) c.scale = problem.scale();
    if constexpr (requires { problem.break_points(); }) c.break_points = problem.break_points();
    return c;
}

}  // namespace problems::test_set
