// SPDX-License-Identifier: BSL-1.0
// COLNEW (Ascher, Christiansen, Russell and Bader, Fortran), opened at run time, with analytic Jacobians.
#include <dlfcn.h>

#include <array>
#include <memory>

#include "problem.hpp"

namespace bvp {

namespace {

using callback = void (*)();
using colnew_function = void (*)(int* ncomp, int* m, double* a, double* b, double* zeta, int* ipar, int* ltol,
                                 double* tol, double* fixpnt, int* ispace, double* fspace, int* iflag,
                                 callback f, callback df, callback g, callback dg, callback guess);
using appsln_function = void (*)(double* x, double* z, double* fspace, int* ispace);

colnew_function colnew_symbol = nullptr;
appsln_function appsln_symbol = nullptr;
const problem* current = nullptr;
long evaluations = 0, jacobians = 0;

void f(double* t, double* z, double* out) {
    ++evaluations;
    double all[4];
    current->f(*t, z, all);
    if (current->second_order)
        out[0] = all[1];
    else
        std::copy_n(all, current->n, out);
}
void df(double* t, double* z, double* out) {
    ++jacobians;
    double all[16] = {};
    current->jacobian(*t, z, all);
    if (current->second_order)
        out[0] = all[1], out[1] = all[3];
    else
        std::copy_n(all, current->n * current->n, out);
}
const condition& number(int i) {
    const int k = static_cast<int>(current->left.size());
    return i <= k ? current->left[i - 1] : current->right[i - 1 - k];
}
void g(int* i, double* z, double* out) {
    const condition& c = number(*i);
    *out = -c.value;
    for (int j = 0; j < current->n; ++j) *out += c.row[j] * z[j];
}
void dg(int* i, double*, double* out) { std::copy_n(number(*i).row.data(), current->n, out); }
void guess(double* t, double* z, double* slope) {
    const double h = 1e-6 * (current->b - current->a);
    double before[4], after[4];
    current->guess(*t - h, before);
    current->guess(*t + h, after);
    current->guess(*t, z);
    if (current->second_order)
        slope[0] = (after[1] - before[1]) / (2 * h);
    else
        for (int i = 0; i < current->n; ++i) slope[i] = (after[i] - before[i]) / (2 * h);
}

struct memory {
    std::vector<double> numbers = std::vector<double>(4'000'000);
    std::vector<int> integers = std::vector<int>(400'000);
};

}  // namespace

bool open_colnew(const std::string& library) {
    void* opened = dlopen(library.c_str(), RTLD_NOW);
    if (!opened) return false;
    colnew_symbol = reinterpret_cast<colnew_function>(dlsym(opened, "colnew_"));
    appsln_symbol = reinterpret_cast<appsln_function>(dlsym(opened, "appsln_"));
    return colnew_symbol && appsln_symbol;
}

solver colnew(const problem& p, int k) {
    static const auto work = std::make_shared<memory>();
    const auto run = [&p, k](double tolerance) {
        current = &p;
        evaluations = jacobians = 0;
        int components = p.second_order ? 1 : p.n, flag = 0;
        std::array<int, 4> orders{1, 1, 1, 1}, which{1, 2, 3, 4};
        if (p.second_order) orders[0] = 2;
        std::array<double, 4> tolerances, points;
        tolerances.fill(tolerance);
        for (int i = 0; i < p.n; ++i) points[i] = i < static_cast<int>(p.left.size()) ? p.a : p.b;
        double a = p.a, b = p.b, none = 0;
        // nonlinear, k, intervals, tolerances, memory, silence, mesh, guess, regular, fixed points
        std::array<int, 11> ipar{p.linear ? 0 : 1,
                                 k,
                                 0,
                                 p.n,
                                 static_cast<int>(work->numbers.size()),
                                 static_cast<int>(work->integers.size()),
                                 1,
                                 0,
                                 p.linear ? 0 : 1,
                                 0,
                                 0};
        colnew_symbol(&components, orders.data(), &a, &b, points.data(), ipar.data(), which.data(),
                      tolerances.data(), &none, work->integers.data(), work->numbers.data(), &flag,
                      reinterpret_cast<callback>(f), reinterpret_cast<callback>(df),
                      reinterpret_cast<callback>(g), reinterpret_cast<callback>(dg),
                      reinterpret_cast<callback>(guess));
        return result{flag == 1, 0, evaluations, jacobians, 0, work->integers[0]};
    };
    const auto error = [&p] {
        return error_of(p, [&](double t, double* out) {
            appsln_symbol(&t, out, work->numbers.data(), work->integers.data());
        });
    };
    return {run, error};
}

}  // namespace bvp
