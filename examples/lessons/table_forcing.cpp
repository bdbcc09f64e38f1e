// SPDX-License-Identifier: BSL-1.0
// A fast sensor follows a measured temperature, which is a table: one value an hour, straight lines between. Where a kink
// matters at the tolerance asked for a step ends; without that the run steps over hours that it never sees.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/output_times.hpp>
#include <stagecraft/problem/interpolant.hpp>
#include <vector>

int main() {
    using namespace stagecraft;
    using state = Eigen::Matrix<double, 1, 1>;
    std::vector<double> hours, degrees, halves;
    for (int i = 0; i <= 48; ++i) {
        hours.push_back(i);
        degrees.push_back(15 + 8 * std::sin(i * 0.2618) + (i * 7919 % 13 - 6) * 0.5);
        halves.push_back(i == 48 ? 48 : i + 0.5);
    }
    const interpolant outside(hours, degrees, interpolation::linear);
    const double k = 1e5;  // the sensor lags by 1/k of an hour
    const auto largest_distance = [&](const break_times<double>& breaks) {
        output_times<state> out(halves);
        integrate(
            radau_iia<3>(), [&](double t, const state& y, state& f) { f[0] = k * (outside(t) - y[0]); },
            state(outside(0)), 0, 48, {.break_points = breaks}, out);
        double distance = 0;
        for (int i = 0; i < out.filled(); ++i)
            distance = std::max(distance, std::abs(out.y(i)[0] - outside(out.time(i))));
        return distance;
    };
    const auto kinks = outside.break_points(1e-4);
    std::printf("%zu of 47 kinks matter at 1e-4\n", kinks.size());
    std::printf("steps end there: within 1e-3 of the table %s\n",
                largest_distance(kinks) < 1e-3 ? "always" : "not always");
    std::printf("not said: within 1e-3 of the table %s\n",
                largest_distance({}) < 1e-3 ? "always" : "not always");
}
