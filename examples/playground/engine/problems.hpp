// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <stagecraft/problem/erased.hpp>
#include <string>
#include <string_view>
#include <vector>

// The problems that the page integrates, all of one type, so that the stepper is compiled once.
namespace playground {

/// A problem with the number that it depends on put in.
struct problem {
    stagecraft::erased_dae f;
    Eigen::VectorXd y0;
    /// The solution at a time: a closed form, or one that another form of the equations leads to; empty where a run
    /// with small tolerances has to do.
    std::function<Eigen::VectorXd(double)> solution{};
};

/// The number that a problem depends on; none where the name is empty.
struct parameter {
    std::string_view name{};
    double standard = 0, least = 0, most = 0;
};

/// What there is to know of a problem beforehand.
struct problem_kind {
    std::string_view name, title, equations, source;
    std::vector<std::string_view> components;
    double t1;        ///< where a run ends that began at 0
    double order_t1;  ///< the same of those that show the error against the step size
    problem (*make)(double);
    playground::parameter parameter{};
    int across = -1, up = -1;  ///< components that make a picture against each other
    bool decades = false;      ///< its time is seen in powers of ten
    double scale = 1;          ///< atol/rtol
};

std::span<const problem_kind> problem_kinds();

/// The one of that name. Throws std::invalid_argument.
const problem_kind& kind_of_problem(std::string_view name);

}  // namespace playground
