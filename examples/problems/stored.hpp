// SPDX-License-Identifier: BSL-1.0
// Stored solutions, read from JSON in one place: its parser takes two seconds to compile.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace problems {

/// The numbers, written as strings of more digits than a double has, at a JSON pointer ("/y_end") into a file.
/// Throws std::runtime_error that names the file, and the pointer if the file has no such thing.
Eigen::VectorXd stored_numbers(const std::string& file, const std::string& pointer);

/// The solution at the end of the interval, from data/NAME.json.
Eigen::VectorXd reference(const std::string& name);

/// max |y_i - reference_i| / (|reference_i| + floor): relative where a component is larger than `floor`, absolute below.
template <class Vector>
double error(const Vector& y, const Eigen::VectorXd& reference, double floor) {
    return ((y - reference).array().abs() / (reference.array().abs() + floor)).maxCoeff();
}

/// A boundary value problem of tests/data/bvp.json: its name, interval, parameter, number of equations, and rows (t, y(t)) of
/// the solution, computed in quadruple precision with a method of order 18.
struct boundary_value_case {
    std::string name;
    double a = 0, b = 0, p = 0;
    int equations = 0;
    std::vector<std::vector<double>> points;
};

std::vector<boundary_value_case> boundary_value_cases();

}  // namespace problems
