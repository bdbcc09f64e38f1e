// SPDX-License-Identifier: BSL-1.0
// DOPRI5 and DOP853 (Hairer and Wanner, Fortran) from libraries built of their published sources, dopri5.f and dop853.f,
// and the method of the first one in Boost.odeint.
#pragma once

#include <dlfcn.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <string>
#include <vector>

#include "run.hpp"

namespace peers {

/// Both have this interface.
using dopri_function = void (*)(int* n, void (*f)(int*, double*, double*, double*, double*, int*), double* t,
                                double* y, double* t_end, double* rtol, double* atol, int* itol,
                                void (*solout)(), int* iout, double* work, int* lwork, int* iwork,
                                int* liwork, double* rpar, int* ipar, int* idid);

/// Null before open_dopri() has found them.
inline dopri_function dopri5 = nullptr, dop853 = nullptr;
/// The function `name` of the library at this path; null where there is none.
inline dopri_function open_dopri(const std::string& path, const char* name) {
    void* library = dlopen(path.c_str(), RTLD_NOW);
    return library ? reinterpret_cast<dopri_function>(dlsym(library, name)) : nullptr;
}

/// Integrates `problem` with one of the two.
template <class Problem>
outcome dopri(dopri_function solver, const Problem&, double rtol, double t1) {
    const auto f = [](int*, double*, double* y, double* out, double*, int*) { Problem::slopes(y, out); };
    Eigen::VectorXd y = Problem::initial();
    int n = static_cast<int>(y.size()), itol = 0, iout = 0, ipar = 0, idid = 0;
    double t = Problem::t0, t_end = t1, atol = rtol * Problem::atol_scale, rpar = 0;
    int lwork = 12 * n + 21, liwork = 21;
    std::vector<double> work(lwork, 0.0);
    std::vector<int> iwork(liwork, 0);
    iwork[0] = 10'000'000;  // steps allowed
    iwork[2] = -1;          // nothing is printed
    solver(
        &n, f, &t, y.data(), &t_end, &rtol, &atol, &itol, [] {}, &iout, work.data(), &lwork, iwork.data(),
        &liwork, &rpar, &ipar, &idid);
    return {.y = y, .ok = idid == 1, .steps = iwork[17], .f = iwork[16]};
}

/// The same by odeint, which chooses no first step: it is given a small one, from which its steps grow by up to five.
template <class Problem>
outcome odeint_dopri5(const Problem&, double rtol, double t1) {
    namespace odeint = boost::numeric::odeint;
    using state = std::array<double, Problem::size>;
    outcome out;
    const Eigen::VectorXd y0 = Problem::initial();
    state y;
    std::copy(y0.begin(), y0.end(), y.begin());
    const auto f = [&](const state& in, state& slope, double) {
        Problem::slopes(in.data(), slope.data()), ++out.f;
    };
    const auto stepper =
        odeint::make_controlled<odeint::runge_kutta_dopri5<state>>(rtol * Problem::atol_scale, rtol);
    try {
        out.steps = static_cast<long>(
            odeint::integrate_adaptive(stepper, f, y, Problem::t0, t1, 1e-5 * (t1 - Problem::t0)));
        out.ok = true;
    } catch (const std::exception&) {
    }
    out.y = Eigen::Map<const Eigen::VectorXd>(y.data(), Problem::size);
    return out;
}

}  // namespace peers
