// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "stagecraft/theory/stability/stability_function.hpp"

namespace stagecraft::theory {

/// The leading term `coefficient` y^(order + 1) of an error on the imaginary axis.
template <class K>
struct axis_error {
    int order = 0;
    K coefficient;
};

/// How an explicit method turns and shrinks an oscillation y' = i omega y in a step, y = h omega (Houwen-Sommeijer 1987):
/// the phase error, or dispersion, y - arg R(iy), and the amplification error, or dissipation, 1 - |R(iy)|.
template <class K>
struct phase_errors {
    std::optional<axis_error<K>> dispersion;
    std::optional<axis_error<K>> dissipation;  ///< nothing where |R(iy)| = 1 for all y
};

/// From the series of log R(z) - z = sum_k d_k z^k for a polynomial R with R(0) = 1, coefficients ascending: odd powers turn,
/// even ones shrink. The first coefficients for which `differs` holds lead. Exact over a field; O(s^2).
template <class K, class Differs>
phase_errors<K> phase_errors_of(const std::vector<K>& r, const Differs& differs) {
    phase_errors<K> out;
    const std::size_t s = r.size() - 1;
    std::vector<K> k_l{K(0)};  // k times the k-th coefficient of log R
    // |R(iy)|^2 has degree 2 s in y, so the first even term is no later; that of arg R follows from R(z)/R(-z) = e^(2z) + ...
    for (std::size_t n = 1; n <= 2 * s + 1 && !(out.dispersion && out.dissipation); ++n) {
        K sum = n <= s ? K(static_cast<int>(n)) * r[n] : K(0);
        for (std::size_t k = n > s ? n - s : 1; k < n; ++k) sum = sum - k_l[k] * r[n - k];
        k_l.push_back(sum);
        const K d = n == 1 ? sum - K(1) : sum / K(static_cast<int>(n));
        auto& error = n % 2 == 0 ? out.dissipation : out.dispersion;
        if (error || !differs(d)) continue;
        const bool minus = n % 4 == 0 || n % 4 == 1;  // -i^n, or -i^(n - 1)
        error = axis_error<K>{static_cast<int>(n) - 1, minus ? K(0) - d : d};
    }
    return out;
}

template <class K>
phase_errors<K> phase_errors_of(const stability_function<K>& r) {
    std::vector<K> coefficients;
    for (int k = 0; k <= r.numerator.degree(); ++k) coefficients.push_back(r.numerator[k]);
    return phase_errors_of(coefficients, [](const K& d) { return !(d == K(0)); });
}

/// "dispersion order 4", and the leading term of the error: "y - arg R(iy) = 1/120*y^5 + O(y^7)".
inline std::string dispersion_text(int order) { return "dispersion order " + std::to_string(order); }
inline std::string dissipation_text(int order) { return "dissipation order " + std::to_string(order); }
inline std::string leading_text(const char* error, const std::string& coefficient, int order) {
    const auto power = [](int n) { return n == 1 ? std::string("y") : "y^" + std::to_string(n); };
    return error + (" = " + coefficient) + "*" + power(order + 1) + " + O(" + power(order + 3) + ")";
}

}  // namespace stagecraft::theory
