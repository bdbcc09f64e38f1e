// SPDX-License-Identifier: BSL-1.0
// Problems for explicit methods: an orbit that passes close by, one that never repeats itself, and one of more unknowns.
// Reference solutions are in data/<name>.json. slopes() takes pointers, so that no solver pays for a conversion.
#pragma once

#include <cmath>
#include <problems/stiff.hpp>

namespace problems {

/// Arenstorf's closed orbit about earth and moon (Hairer-Norsett-Wanner I, II.0).
struct arenstorf {
    static constexpr const char* name = "arenstorf";
    static constexpr int size = 4;
    static constexpr double t0 = 0, t1 = 17.0652165601579625588917206249, atol_scale = 1;
    static vec<double, 4> initial() { return {0.994, 0, 0, -2.00158510637908252240537862224}; }
    void operator()(double, const vec<double, 4>& y, vec<double, 4>& f) const { slopes(y.data(), f.data()); }
    template <class S>
    static void slopes(const S* y, S* f) {
        using std::sqrt;
        constexpr double moon = 0.012277471, earth = 1 - moon;
        const S from_earth = y[0] + moon, from_moon = y[0] - earth;
        const S a = from_earth * from_earth + y[1] * y[1], b = from_moon * from_moon + y[1] * y[1];
        const S pull_a = earth / (a * sqrt(a)), pull_b = moon / (b * sqrt(b));
        f[0] = y[2];
        f[1] = y[3];
        f[2] = y[0] + 2 * y[3] - pull_a * from_earth - pull_b * from_moon;
        f[3] = y[1] - 2 * y[2] - (pull_a + pull_b) * y[1];
    }
};

/// Lorenz' attractor (Hairer-Norsett-Wanner I, I.16), as long as sixteen digits of the start say where it goes.
struct lorenz {
    static constexpr const char* name = "lorenz";
    static constexpr int size = 3;
    static constexpr double t0 = 0, t1 = 10, atol_scale = 1;
    static vec<double, 3> initial() { return {10, 10, 27}; }
    void operator()(double, const vec<double, 3>& y, vec<double, 3>& f) const { slopes(y.data(), f.data()); }
    template <class S>
    static void slopes(const S* y, S* f) {
        f[0] = 10 * (y[1] - y[0]);
        f[1] = y[0] * (28 - y[2]) - y[1];
        f[2] = y[0] * y[1] - 8.0 / 3 * y[2];
    }
};

/// Seven bodies in the plane, some of which come close (Hairer-Norsett-Wanner I, II.10): positions, then velocities.
struct pleiades {
    static constexpr const char* name = "pleiades";
    static constexpr int size = 28;
    static constexpr double t0 = 0, t1 = 3, atol_scale = 1;
    static vec<double, 28> initial() {
        vec<double, 28> y;
        y << 3, 3, -1, -3, 2, -2, 2, 3, -3, 2, 0, 0, -4, 4, 0, 0, 0, 0, 0, 1.75, -1.5, 0, 0, 0, -1.25, 1, 0,
            0;
        return y;
    }
    void operator()(double, const vec<double, 28>& y, vec<double, 28>& f) const {
        slopes(y.data(), f.data());
    }
    static void slopes(const double* y, double* f) {
        for (int i = 0; i < 14; ++i) f[i] = y[14 + i], f[14 + i] = 0;
        for (int i = 0; i < 7; ++i)
            for (int j = 0; j < i; ++j) {
                const double x = y[j] - y[i], z = y[7 + j] - y[7 + i], r = x * x + z * z,
                             s = 1 / (r * std::sqrt(r));
                f[14 + i] += (j + 1) * s * x, f[21 + i] += (j + 1) * s * z;
                f[14 + j] -= (i + 1) * s * x, f[21 + j] -= (i + 1) * s * z;
            }
    }
};

}  // namespace problems
