// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/bvp/options.hpp>
#include <stagecraft/bvp/result.hpp>
#include <stagecraft/theory/dynamics/green_function.hpp>

#include <functional>

#include "../lecture/lecture.hpp"

namespace boundary_values {

using namespace stagecraft;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using lecture::chapter;
using lecture::number;
namespace plot = stagecraft::theory::plot;

constexpr double pi = 3.14159265358979323846;
constexpr double beyond_pi = 1.2246467991473532e-16;  ///< pi less its double

/// x' = A(t) x + q(t), B0 x(0) + BT x(T) = d.
struct linear_rhs {
    std::function<MatrixXd(double)> A;
    std::function<VectorXd(double)> q;
    void operator()(double t, const VectorXd& x, VectorXd& f) const { f = A(t) * x + q(t); }
    template <class J>
    void jacobian(double t, const VectorXd&, J& j) const {
        j = A(t);
    }
};
struct linear_conditions {
    MatrixXd B0, BT;
    VectorXd d;
    void operator()(const VectorXd& left, const VectorXd& right, VectorXd& r) const {
        r = B0 * left + BT * right - d;
    }
};

/// solve_bvp from the guess 0, instantiated once for all linear experiments.
bvp_result<VectorXd, Eigen::Matrix<double, 0, 1>> solve(const tableau<double>& method, const linear_rhs& f,
                                                        const linear_conditions& r, double T,
                                                        const bvp_options<double>& o);
/// The same with Gauss-5.
bvp_result<VectorXd, Eigen::Matrix<double, 0, 1>> solve(const linear_rhs& f, const linear_conditions& r,
                                                        double T, const bvp_options<double>& o);

/// |x / y - 1| <= accuracy, for the verdicts.
inline bool near(double x, double y, double accuracy) { return std::abs(x - y) <= accuracy * std::abs(y); }

chapter conditioning();        ///< Beispiel 4.1
chapter dichotomy();           ///< section 4.2
chapter forced_oscillation();  ///< section 4.4, x' = alpha x + sin t and the harmonic oscillator
chapter limit_cycle();         ///< section 4.4
chapter stoer_bulirsch();      ///< chapter 5
chapter shooting_segments();   ///< section 5.1, the picture
chapter turning_modes();       ///< section 5.1, AMR p. 151
chapter splines();             ///< chapter 6
chapter orders();              ///< chapter 6
chapter factorisation();       ///< section 6.2
chapter bifurcations();        ///< not of the lecture: paths from an equilibrium to doubled orbits

}  // namespace boundary_values
