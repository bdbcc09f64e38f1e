// SPDX-License-Identifier: BSL-1.0
// Fifty digits: the same right-hand side, method and function, with another scalar type. The method with
// nine stages is constructed to that precision on the spot.
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <iostream>
#include <stagecraft/integrate.hpp>
#include <stagecraft/tableaux/rounded.hpp>

// Without expression templates (et_off), as Eigen needs it.
using real =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using vector = Eigen::Matrix<real, 2, 1>;

int main() {
    using namespace stagecraft;
    const auto oscillator = [](const real&, const vector& y, vector& f) { f << y[1], -y[0]; };
    const auto method = tableaux::transformed<real>(tableaux::family::gauss, 9);
    const real tolerance("1e-40");  // 1e-40 without the quotes would be a double first
    const auto r =
        integrate(method, oscillator, vector(real(0), real(1)), 0, 1, {.rtol = tolerance, .atol = tolerance});
    std::cout << name(r.status) << '\n'
              << "computed " << r.y[0].str(38) << '\n'
              << "sin 1    " << sin(real(1)).str(38) << '\n';
}
