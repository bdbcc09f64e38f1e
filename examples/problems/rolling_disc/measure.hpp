// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <problems/stored.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/formulations.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "disc.hpp"

namespace rolling_disc {

using state = Eigen::Matrix<double, 12, 1>;

/// The reference solution at t = `key` ("1.0", say), rounded from 33 digits to double.
/// Throws std::runtime_error if the file cannot be read or does not hold that time.
inline state reference_solution(const std::string& file, const std::string& key) {
    return problems::stored_numbers(file, "/t=" + key + "/values");
}

/// What is seen at one accepted step.
struct sample {
    double t, h;
    Eigen::Vector2d violation;  ///< G(q) q'
    double drift;               ///< energy minus its value at the start
};

/// One run over [0, 1].
struct run {
    double tolerance = 0;
    stagecraft::status status{};
    stagecraft::report<double> report;
    state y;
    std::vector<sample> steps;

    double largest_violation() const {
        double largest = 0;
        for (const auto& s : steps) largest = std::max(largest, s.violation.cwiseAbs().maxCoeff());
        return largest;
    }
    double largest_drift() const {
        double largest = 0;
        for (const auto& s : steps) largest = std::max(largest, std::abs(s.drift));
        return largest;
    }
    double error_y(const state& exact) const { return (y - exact).head<10>().cwiseAbs().maxCoeff(); }
    double error_lambda(const state& exact) const { return (y - exact).tail<2>().cwiseAbs().maxCoeff(); }
};

/// Integrates the index-2 system of `body` from 0 to 1 with atol = rtol = tolerance, looking at every
/// accepted step; `extra(t, output)` is called there too, for whoever wants the solution in between.
template <class Method, class Extra>
run observe(const Method& method, const disc<>& body, double tolerance, Extra&& extra) {
    const auto dae = stagecraft::index_2(body);
    const state y0 = dae.initial_state(initial_position(), initial_velocity(body));
    const auto energy = [&](const state& y) {
        return stagecraft::total_energy<double>(body, y.head<5>(), y.segment<5>(5));
    };
    const double energy0 = energy(y0);
    run r;
    r.tolerance = tolerance;
    const auto result =
        stagecraft::integrate(method, dae, y0, 0.0, 1.0, {.rtol = tolerance, .atol = tolerance},
                              [&](double t, const state& y, double h, const auto& output) {
                                  const Eigen::Matrix<double, 5, 1> q = y.head<5>(), v = y.segment<5>(5);
                                  r.steps.push_back({t, h, body.G(q) * v, energy(y) - energy0});
                                  extra(t, output);
                              });
    r.status = result.status;
    r.report = result.report;
    r.y = result.y;
    return r;
}

/// Microseconds of one run without an observer: minimum and median over `repeats`.
struct timing {
    double minimum, median;
};
template <class Method>
timing time_run(const Method& method, const disc<>& body, double tolerance, int repeats) {
    const auto dae = stagecraft::index_2(body);
    const state y0 = dae.initial_state(initial_position(), initial_velocity(body));
    std::vector<double> times;
    for (int k = 0; k < repeats; ++k) {
        const auto start = std::chrono::steady_clock::now();
        const auto result =
            stagecraft::integrate(method, dae, y0, 0.0, 1.0, {.rtol = tolerance, .atol = tolerance});
        const auto stop = std::chrono::steady_clock::now();
        if (!result.ok()) throw std::runtime_error("the run ended with " + std::string(name(result.status)));
        times.push_back(std::chrono::duration<double, std::micro>(stop - start).count());
    }
    std::sort(times.begin(), times.end());
    return {times.front(), times[times.size() / 2]};
}

}  // namespace rolling_disc
