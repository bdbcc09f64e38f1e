// SPDX-License-Identifier: BSL-1.0
// RADAU5 (Hairer and Wanner, Fortran) as the Debian package r-cran-desolve ships it: the symbol radau5_ of
// deSolve.so, opened at run time. Absent package: `radau5_available()` is false. RADAU, the code of variable
// order by the same authors with the same interface, from a library built of its published source
// (radau.f, with the linear algebra that comes with it).
#pragma once

#include <dlfcn.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <stagecraft/problem/capabilities.hpp>
#include <string>
#include <vector>

#include "run.hpp"

/// deSolve.so prints why RADAU5 gives up by R's own function, which needs R to run: this takes its place, and the
/// reason is known by idid. Programs need ENABLE_EXPORTS for it.
extern "C" [[gnu::used]] inline void Rprintf(const char*, ...) {}

namespace peers {

/// Both have this interface but for the arguments of `jac`.
using radau_function = void (*)(
    int* n, void (*f)(int*, double*, double*, double*, double*, int*), double* t, double* y, double* t_end,
    double* h, double* rtol, double* atol, int* itol, void (*jac)(), int* ijac, int* mljac, int* mujac,
    void (*mas)(int*, double*, int*, double*, int*), int* imas, int* mlmas, int* mumas,
    void (*solout)(int*, double*, double*, double*, double*, int*, int*, double*, int*, int*), int* iout,
    double* work, int* lwork, int* iwork, int* liwork, double* rpar, int* ipar, int* idid);

inline radau_function radau5_symbol() {
    static const radau_function f = [] {
        if (!dlopen("/usr/lib/R/lib/libR.so", RTLD_NOW | RTLD_GLOBAL)) return radau_function{};
        void* library = dlopen("/usr/lib/R/site-library/deSolve/libs/deSolve.so", RTLD_NOW);
        return library ? reinterpret_cast<radau_function>(dlsym(library, "radau5_")) : radau_function{};
    }();
    return f;
}
inline bool radau5_available() { return radau5_symbol() != nullptr; }

/// RADAU; null before open_radau() has found it.
inline radau_function radau_symbol = nullptr;
/// False if there is no library with radau_ at this path.
inline bool open_radau(const std::string& path) {
    void* library = dlopen(path.c_str(), RTLD_NOW);
    if (library) radau_symbol = reinterpret_cast<radau_function>(dlsym(library, "radau_"));
    return radau_symbol != nullptr;
}

/// Integrates `problem` with one of the two, whose option M1 = M2 serves q' = v where the problem has it.
template <class Problem>
outcome radau(radau_function solver, const Problem& problem, double rtol, double t1) {
    static const Problem* current;
    current = &problem;
    static int first_row;  // rows of q' = v that RADAU5 handles by itself
    first_row = 0;
    constexpr bool banded = requires { Problem::lower; };

    Eigen::VectorXd y = problem.initial();
    int n = static_cast<int>(y.size());
    std::array<int, 3> index{n, 0, 0};
    if constexpr (requires { problem.index(); })
        for (int i = 0; i < n; ++i)
            if (problem.index()[i] > 1) --index[0], ++index[problem.index()[i] - 1];
    if constexpr (requires { Problem::second_order_components; })
        first_row = stagecraft::position_components<Problem>(n);

    const auto f = [](int* n, double* t, double* y, double* f, double*, int*) {
        thread_local state_of<Problem> in, out;
        in = Eigen::Map<Eigen::VectorXd>(y, *n);
        out.resize(*n);
        (*current)(*t, in, out);
        Eigen::Map<Eigen::VectorXd>(f, *n) = out;
    };
    static constexpr auto jacobian = [](int* n, double* t, double* y, double* dfy, int* ldfy) {
        thread_local state_of<Problem> in;
        in = Eigen::Map<Eigen::VectorXd>(y, *n);
        Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>> out(dfy, *ldfy, *n, Eigen::OuterStride<>(*ldfy));
        if constexpr (banded) {
            out.setZero();
            current->jacobian_entries(in,
                                      [&](int i, int j, double v) { out(i - j + Problem::upper, j) = v; });
            (void)t;
        } else {
            thread_local jacobian_of<Problem> J;
            J.resize(*n, *n);
            current->jacobian(*t, in, J);
            out.topRows(*n - first_row) = J.bottomRows(*n - first_row);
        }
    };
    // deSolve's RADAU5 hands the bandwidths over as well.
    const auto with_bands = [](int* n, double* t, double* y, int*, int*, double* dfy, int* ldfy, double*,
                               int*) { jacobian(n, t, y, dfy, ldfy); };
    const auto without = [](int* n, double* t, double* y, double* dfy, int* ldfy, double*, int*) {
        jacobian(n, t, y, dfy, ldfy);
    };
    const auto jac = solver == radau_symbol ? reinterpret_cast<void (*)()>(+without)
                                            : reinterpret_cast<void (*)()>(+with_bands);
    // M as the band that it is, which both codes treat for itself; beyond the rows of q' = v.
    static int mass_width;
    mass_width = 0;
    if constexpr (requires { problem.mass(); }) {
        const Eigen::MatrixXd M = problem.mass();
        for (int j = first_row; j < n; ++j)
            for (int i = first_row; i < n; ++i)
                if (M(i, j) != 0) mass_width = std::max(mass_width, std::abs(i - j));
    }
    if (2 * mass_width + 1 >= n - first_row) mass_width = n - first_row;  // full
    const auto mass = [](int* nm, double* am, int* lmas, double*, int*) {
        if constexpr (requires { current->mass(); }) {
            Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>> out(am, *lmas, *nm,
                                                                     Eigen::OuterStride<>(*lmas));
            const Eigen::MatrixXd M = Eigen::MatrixXd(current->mass()).bottomRightCorner(*nm, *nm);
            if (mass_width == *nm) {
                out.topRows(*nm) = M;
            } else {
                for (int j = 0; j < *nm; ++j)
                    for (int d = -mass_width; d <= mass_width; ++d)
                        out(d + mass_width, j) = j + d >= 0 && j + d < *nm ? M(j + d, j) : 0;
            }
        } else {
            (void)nm, (void)am, (void)lmas;
        }
    };
    const auto solout = [](int*, double*, double*, double*, double*, int*, int*, double*, int*, int*) {};

    Eigen::VectorXd rtols(1), atols(1);  // of all components, or of each
    if constexpr (requires { problem.atol(rtol); })
        rtols = Eigen::VectorXd::Constant(n, rtol), atols = problem.atol(rtol);
    else
        rtols[0] = rtol, atols[0] = rtol * Problem::atol_scale;
    double t = problem.t0, t_end = t1, h = 0, rpar = 0;
    int itol = rtols.size() > 1, ijac = 1, iout = 0, ipar = 0, idid = 0;
    int ml = n, mu = n;
    if constexpr (banded) ml = Problem::lower, mu = Problem::upper;
    int imas = 0;
    if constexpr (requires { problem.mass(); }) imas = 1;
    int mlmas = mass_width, mumas = mass_width;
    const int ljac = banded ? ml + mu + 1 : n, le = banded ? 2 * ml + mu + 1 : n;
    int lwork = n * (ljac + n * imas + 7 * le + 24) + 20, liwork = 5 * n + 20;  // seven stages at most
    std::vector<double> work(lwork, 0.0);
    std::vector<int> iwork(liwork, 0);
    iwork[1] = 10'000'000;  // steps allowed
    iwork[4] = index[0], iwork[5] = index[1], iwork[6] = index[2];
    iwork[8] = iwork[9] = first_row;
    if (first_row > 0) ml = mu = n - first_row;

    solver(&n, f, &t, y.data(), &t_end, &h, rtols.data(), atols.data(), &itol, jac, &ijac, &ml, &mu, mass,
           &imas, &mlmas, &mumas, solout, &iout, work.data(), &lwork, iwork.data(), &liwork, &rpar, &ipar,
           &idid);
    return {.y = y,
            .ok = idid == 1,
            .steps = iwork[15],
            .f = iwork[13],
            .jacobians = iwork[14],
            .factorisations = iwork[18],
            .rejected = iwork[15] - iwork[16],
            .status = idid == 1    ? "success"
                      : idid == -3 ? "step too small"
                      : idid == -4 ? "singular matrix"
                                   : "failure " + std::to_string(idid)};
}

}  // namespace peers
