// SPDX-License-Identifier: BSL-1.0
// A boundary value problem with its solution, as every solver is given it: by functions of pointers.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace bvp {

/// A linear condition at one end: sum_i row[i] y_i = value.
struct condition {
    std::vector<double> row;
    double value;
};

/// y' = f(t, y) on [a, b], n = 2, 3 or 4. With second_order, y = (u, u') and f = (u', u'').
struct problem {
    std::string name;
    int n = 2;
    bool second_order = true, linear = false;
    double a = 0, b = 1;
    std::function<void(double t, const double* y, double* f)> f;
    std::function<void(double t, const double* y, double* J)> jacobian;  ///< n x n by columns, zero before
    std::vector<condition> left, right;
    std::function<void(double t, double* y)> guess;
    std::vector<std::pair<double, std::vector<double>>> reference;  ///< t and y(t), increasing in t
};

/// max |e_i| / (1 + |y_i|) over the reference points; `value` writes y(t).
template <class Value>
double error_of(const problem& p, Value&& value) {
    double worst = 0;
    std::vector<double> y(static_cast<std::size_t>(p.n));
    for (const auto& [t, exact] : p.reference) {
        value(t, y.data());
        for (int i = 0; i < p.n; ++i) {
            const double e = std::abs(y[i] - exact[i]) / (1 + std::abs(exact[i]));
            if (!(e <= worst)) worst = e == e ? e : HUGE_VAL;
        }
    }
    return worst;
}

/// What a run of a solver comes to. `run` does it, `error` measures what it left.
struct result {
    bool success = false;
    double estimate = 0;  ///< of the error, where the solver has one
    long f = 0, jacobians = 0, factorisations = 0;
    int intervals = 0;
};
struct solver {
    std::function<result(double tolerance)> run;
    std::function<double()> error;  ///< of the last run
};

solver ours_2(const problem& p);
solver ours_3(const problem& p);
solver ours_4(const problem& p);
inline solver ours(const problem& p) { return p.n == 2 ? ours_2(p) : p.n == 3 ? ours_3(p) : ours_4(p); }

/// COLNEW with k collocation points, of a library that exports colnew_ and appsln_.
bool open_colnew(const std::string& library);
solver colnew(const problem& p, int k);

std::vector<problem> closed_forms();
std::vector<problem> stored();

}  // namespace bvp
