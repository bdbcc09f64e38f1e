// SPDX-License-Identifier: BSL-1.0
// States of other types: a number, a std::array, complex ones; and a table of the run as CSV.
#include <array>
#include <complex>
#include <iostream>
#include <sstream>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/observe/table.hpp>
#include <stagecraft/states.hpp>

int main() {
    using namespace stagecraft;
    using complex = std::complex<double>;
    const auto method = radau_iia<3>();
    const auto decay = [](double, double y) { return -y; };
    std::cout << "exp(-1)     " << integrate(method, decay, 1.0, 0, 1).y << '\n';

    using pair = std::array<double, 2>;
    const auto turn = [](double, const pair& y) { return pair{y[1], -y[0]}; };
    std::cout << "sin(1)      " << integrate(method, turn, pair{0, 1}, 0, 1).y[0] << '\n';

    const auto rotate = [](double, complex z) { return complex(0, 1) * z; };
    std::cout << "exp(i)      " << integrate(method, rotate, complex(1), 0, 1).y << '\n';

    // 17 digits, so that they read back to the same bits; a file in place of the string as a rule.
    std::ostringstream file;
    const auto fall = [](double, const Eigen::Vector2d& y) { return Eigen::Vector2d(y[1], -9.81); };
    integrate(method, fall, Eigen::Vector2d(20, 0), 0, 2, {.fixed_step = 0.5},
              csv(file, {"height", "speed"}));
    std::cout << file.str().substr(0, file.str().find("\n0.5")) << "\n...\n";
}
