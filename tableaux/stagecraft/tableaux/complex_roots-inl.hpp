// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/complex_roots.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/roots.hpp"

namespace stagecraft::tableaux {

namespace zeros {

/// Value and derivative by Horner's rule.
STAGECRAFT_INLINE std::pair<complex_ball, complex_ball> horner(const std::vector<ball>& a,
                                                               const complex_ball& z) {
    complex_ball value{a.back(), 0}, slope{0, 0};
    for (auto k = a.size() - 1; k-- > 0;) {
        slope = slope * z + value;
        value = value * z + complex_ball{a[k], 0};
    }
    return {value, slope};
}

STAGECRAFT_INLINE std::vector<std::complex<bound>> rough(const std::vector<ball>& a) {
    using complex = std::complex<bound>;
    const auto n = a.size() - 1;
    std::vector<bound> p;
    for (const ball& x : a)
        p.push_back(std::ldexp(x.digits().convert_to<bound>(), static_cast<int>(x.exponent())));
    const bound size = std::exp2(std::log2(a[0].magnitude()) / static_cast<bound>(n));
    std::vector<complex> circle;
    for (std::size_t k = 0; k < n; ++k)
        circle.push_back(std::polar(
            size, 2 * std::numbers::pi_v<bound> * (static_cast<bound>(k) + 0.3L) / static_cast<bound>(n)));
    std::vector<complex> z = circle;
    const auto over = [](const complex& x) { return std::conj(x) / std::norm(x); };
    for (int sweep = 0; sweep < 60; ++sweep) {
        bound largest = 0;
        for (std::size_t k = 0; k < n; ++k) {
            complex value = p[n], slope = 0, repulsion = 0;
            for (auto i = n; i-- > 0;) {
                slope = slope * z[k] + value;
                value = value * z[k] + p[i];
            }
            if (value == complex(0)) continue;
            for (std::size_t j = 0; j < n; ++j)
                if (j != k) repulsion += over(z[k] - z[j]);
            const complex step = over(slope * over(value) - repulsion);
            z[k] -= step;
            if (!std::isfinite(z[k].real()) || !std::isfinite(z[k].imag())) return circle;
            largest = std::max(largest, std::abs(step) / std::abs(z[k]));
        }
        if (largest < 1e-9L) return z;
    }
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (std::abs(z[i] - z[j]) < 1e-15L * std::abs(z[i])) return circle;
    return z;
}

/// The same to `bits` bits. Radii are dropped: the proof comes later.
STAGECRAFT_INLINE std::vector<complex_ball> approximate(const std::vector<ball>& a, int bits) {
    const auto n = a.size() - 1;
    std::vector<complex_ball> z;
    const auto exactly = [&](bound x) {
        const auto [m, e] = ball::bound_parts(x);
        return ball(m, e, 0, bits);
    };
    for (const auto& x : rough(a)) z.push_back({exactly(x.real()), exactly(x.imag())});
    const bound close = std::ldexp(bound(1), -bits / 2);
    for (int sweep = 0; sweep < 200; ++sweep) {
        bound largest = 0;
        for (std::size_t k = 0; k < n; ++k) {
            const auto [value, slope] = horner(a, z[k]);
            const complex_ball newton = value.midpoint() / slope.midpoint();
            complex_ball repulsion{0, 0};
            for (std::size_t j = 0; j < n; ++j)
                if (j != k)
                    repulsion = (repulsion + complex_ball{1, 0} / (z[k] - z[j]).midpoint()).midpoint();
            const complex_ball step =
                newton.midpoint() / (complex_ball{1, 0} - newton * repulsion).midpoint();
            z[k] = (z[k] - step).midpoint();
            largest = std::max(largest, step.upper_magnitude() / z[k].upper_magnitude());
        }
        if (largest < close) return z;
    }
    throw undecided("roots: the Ehrlich-Aberth iteration did not converge");
}

}  // namespace zeros

STAGECRAFT_INLINE root_enclosures locate_roots(const std::vector<ball>& a, int bits) {
    const int n = static_cast<int>(a.size()) - 1;
    const int start = std::min(bits, 64 + 6 * n);
    std::vector<complex_ball> all;  // real ones, and of each pair the upper one followed by its conjugate
    root_enclosures found;
    auto rough = zeros::approximate(a, start);
    const bound flat = std::ldexp(bound(1), -start / 4);
    for (complex_ball z : rough) {
        const bool real = z.im.upper_magnitude() < flat * z.upper_magnitude();
        if (!real && !certainly_positive(z.im)) continue;
        if (real) z.im = 0;
        for (int precision = start;; precision = std::min(2 * precision, bits)) {
            z = z.with_bits(precision).midpoint();
            const auto [value, slope] = zeros::horner(a, z);
            z = (z - value.midpoint() / slope.midpoint()).with_bits(precision).midpoint();
            if (precision == bits) break;
        }
        if (real) z.im = 0;
        all.push_back(z);
        if (!real) all.push_back(z.conjugate());
    }
    if (static_cast<int>(all.size()) != n) throw undecided("roots: real and complex roots not told apart");
    std::vector<bound> radius;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bound residual = zeros::horner(a, all[i]).first.upper_magnitude();
        complex_ball product{1, 0};
        for (std::size_t j = 0; j < all.size(); ++j)
            if (j != i) product = product * (all[i] - all[j]);
        const bound distance = product.lower_magnitude();
        if (!(distance > 0)) throw undecided("roots: two approximations coincide");
        radius.push_back(upward(static_cast<bound>(n) * residual / distance));
    }
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = i + 1; j < all.size(); ++j)
            if (!((all[i] - all[j]).lower_magnitude() > upward(radius[i] + radius[j])))
                throw undecided("roots: two discs overlap");
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].im.exactly_zero()) {
            found.real.push_back(all[i].re.widened(radius[i]));
        } else {
            found.upper.push_back(all[i].widened(radius[i]));
            ++i;
        }
    }
    for (const auto& z : found.upper)
        if (!certainly_positive(z.im)) throw undecided("roots: a root too close to the real axis");
    return found;
}

STAGECRAFT_INLINE root_enclosures enclose_roots(const polynomial<rational>& p, int bits) {
    root_enclosures found = locate_roots(enclosed(monic(p).coefficients(), bits), bits);
    const auto by_order = [](const ball& x, const ball& y) {
        const auto order = compare(x, y);
        if (order == std::partial_ordering::unordered) throw undecided("roots: their order is undecided");
        return order < 0;
    };
    std::sort(found.real.begin(), found.real.end(), by_order);
    std::sort(found.upper.begin(), found.upper.end(),
              [&](const complex_ball& x, const complex_ball& y) { return &x != &y && by_order(x.im, y.im); });
    return found;
}

}  // namespace stagecraft::tableaux
