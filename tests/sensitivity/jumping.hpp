// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <exception>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/options.hpp>
#include <stagecraft/status.hpp>
#include <stdexcept>
#include <string>

#include "../message.hpp"

// What the tests of jumping derivatives have in common.

inline const auto radau = stagecraft::radau_iia<3>();
constexpr std::array<double, 3> tolerances{1e-4, 1e-7, 1e-10};
inline stagecraft::options<double> to(double tol) { return {.rtol = tol, .atol = tol}; }
inline double distance(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    return (a - b).cwiseAbs().maxCoeff();
}
/// What a run says that ends because something has no derivative.
template <class Result>
std::string refusal(const Result& r) {
    if (r.status != stagecraft::status::function_threw) return "no refusal";
    return message<std::domain_error>([&] { std::rethrow_exception(r.exception); });
}
inline bool says(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }
