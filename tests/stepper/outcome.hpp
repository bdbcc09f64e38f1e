// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <functional>
#include <stagecraft/integrate.hpp>
#include <stdexcept>
#include <string>

/// The order that errors show: log2 of error(h) / error(h / 2).
inline double slope(const std::function<double(double)>& error, double h) {
    return std::log2(error(h) / error(h / 2));
}

/// How a run from 0 to 1 ends, or which argument it refuses. Steps are adaptive where `step` is 0.
template <class Method, class Problem, class Vector>
std::string refusal(const Method& m, const Problem& p, const Vector& y0, double step) {
    try {
        const auto r = stagecraft::integrate(m, p, y0, 0, 1, {.fixed_step = step});
        return stagecraft::name(r.status);
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
}

inline bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}
