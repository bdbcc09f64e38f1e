// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <stagecraft/tableaux/tableau_from_file.hpp>

#include "../catalogue.hpp"

// Every method of the catalogue, and a problem to run it on at 50 digits.

namespace catalogue_runs {

using fifty =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using vector = Eigen::Matrix<fifty, 2, 1>;

using read_once::catalogue;

// y = (1/(1+t), 1/(1+t)^2); polynomials only, so that 50 digits stay cheap.
struct hyperbola {
    void operator()(const fifty& t, const vector& y, vector& f) const {
        const fifty a = y[0] * y[0] - y[1], b = y[0] - y[1] * (1 + t);
        f[0] = -y[1] + a * (1 + y[0] + t) + b * y[1];
        f[1] = -2 * y[0] * y[1] + b * y[1] - a * t;
    }
    void jacobian(const fifty& t, const vector& y, Eigen::Matrix<fifty, 2, 2>& J) const {
        const fifty a = y[0] * y[0] - y[1], b = y[0] - y[1] * (1 + t);
        J(0, 0) = 2 * y[0] * (1 + y[0] + t) + a + y[1];
        J(0, 1) = -1 - (1 + y[0] + t) + b - y[1] * (1 + t);
        J(1, 0) = -2 * y[1] + y[1] - 2 * y[0] * t;
        J(1, 1) = -2 * y[0] + b - y[1] * (1 + t) + t;
    }
};

}  // namespace catalogue_runs
