// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <memory>
#include <stagecraft/gauss_variable.hpp>

#include "problem.hpp"

namespace bvp {

template <int N>
struct right_hand_side {
    const problem* p;
    using vector = Eigen::Matrix<double, N, 1>;
    void operator()(double t, const vector& y, vector& f) const { p->f(t, y.data(), f.data()); }
    template <class J>
    void jacobian(double t, const vector& y, J& j) const {
        Eigen::Matrix<double, N, N> own = Eigen::Matrix<double, N, N>::Zero();
        p->jacobian(t, y.data(), own.data());
        j = own;
    }
};
struct second_order_right_hand_side : right_hand_side<2> {
    static constexpr int second_order_components = 1;
};

template <int N>
struct conditions {
    const problem* p;
    using vector = Eigen::Matrix<double, N, 1>;
    template <class Y, class R>
    void operator()(const Y& left, const Y& right, R& r) const {
        int k = 0;
        const auto write = [&](const std::vector<condition>& all, const Y& y) {
            for (const condition& c : all) {
                r[k] = y[0] * c.row[0] - c.value;
                for (int i = 1; i < N; ++i)
                    if (c.row[i] != 0) r[k] = r[k] + y[i] * c.row[i];
                ++k;
            }
        };
        write(p->left, left);
        write(p->right, right);
    }
};

template <int N, class Rhs>
solver with_gauss(const problem& p) {
    using vector = Eigen::Matrix<double, N, 1>;
    auto y = std::make_shared<stagecraft::solution<vector>>();
    const auto run = [&p, y](double tolerance) {
        const auto guess = [&p](double t) {
            vector value;
            p.guess(std::clamp(t, p.a, p.b), value.data());
            return value;
        };
        auto r = stagecraft::solve_bvp(stagecraft::gauss_variable(),
                                       stagecraft::two_point(Rhs{{&p}}, conditions<N>{&p}), p.a, p.b, guess,
                                       {.rtol = tolerance});
        *y = std::move(r.y);
        return result{r.ok(),
                      r.error.global,
                      r.report.f,
                      r.report.jacobians,
                      r.report.factorisations,
                      r.report.intervals};
    };
    const auto error = [&p, y] {
        if (y->steps() == 0) return HUGE_VAL;
        return error_of(p, [&](double t, double* out) {
            const vector value = (*y)(std::clamp(t, y->t0(), y->t1()));
            std::copy_n(value.data(), N, out);
        });
    };
    return {run, error};
}

}  // namespace bvp
