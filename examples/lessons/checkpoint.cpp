// SPDX-License-Identifier: BSL-1.0
// A checkpoint: a run is cut, written to a file and continued, and ends with the bits it would have had.
#include <iostream>
#include <sstream>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/observers.hpp>
#include <stagecraft/observe/save_every.hpp>

int main() {
    using namespace stagecraft;
    using Eigen::Vector2d;
    const auto method = radau_iia<3>();
    const auto van_der_pol = [](const auto&, const auto& y, auto& f) {
        f[0] = y[1];
        f[1] = 1e3 * (1 - y[0] * y[0]) * y[1] - y[0];
    };
    const Vector2d start(2, 0);
    const auto whole = integrate(method, van_der_pol, start, 0, 2000);

    // As if the machine had to be given back after t = 1000.
    checkpoint<Vector2d> last;
    const auto until = [](double t, const Vector2d&) { return t < 1000; };
    integrate(method, van_der_pol, start, 0, 2000, {},
              observers(until, save_every(1, [&](auto point) { last = std::move(point); })));
    std::stringstream file;  // or a std::ofstream
    file << last;

    checkpoint<Vector2d> read;
    file >> read;
    const auto rest = integrate(method, van_der_pol, read, 2000);
    std::cout << name(rest.status) << ", the same bits: " << (rest.y == whole.y ? "yes" : "no")
              << ", the same number of steps: " << (rest.report.steps == whole.report.steps ? "yes" : "no")
              << '\n';
}
