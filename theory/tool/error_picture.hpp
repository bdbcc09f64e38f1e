// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableau.hpp>
#include <stagecraft/theory/plot/gnuplot.hpp>

#include <string>
#include <vector>

namespace stagecraft::tool {

/// A method to be run, and what it is called in the picture.
struct named_method {
    std::string name;
    tableau<double> method;
};

/// The error at the end of a run with equal steps, over the step size, both on logarithmic axes, a line a method; its slope,
/// measured where errors are above 1e-12, stands in the key. std::invalid_argument for a problem of another name.
theory::plot::script error_picture(const std::vector<named_method>& methods, const std::string& problem);

/// The names of the problems, with commas.
std::string error_problems();

}  // namespace stagecraft::tool
