// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>

#include <stagecraft/dense_output.hpp>

namespace stagecraft {

/// The continuous solution of methods whose stages do not give one: Hermite's cubic through the states and slopes at both
/// ends of the step, or, of a system of second order y = (q, v), his quintic q through positions, velocities and
/// accelerations, with v = q'. Between the ends an error O(h^4) is added, with the quintic O(h^6) in q and O(h^5) in v
/// (Hairer-Norsett-Wanner I.II.6).
template <class Space>
class hermite_output {
    using scalar = typename Space::scalar;
    using vector = typename Space::vector;
    using output = typename Space::output;

  public:
    static constexpr int cubic_columns = 3, quintic_columns = 5;

    explicit hermite_output(int columns) : nodes_(columns) {
        nodes_.size = columns;
        nodes_.c[0] = scalar(0);
        nodes_.c[1] = scalar(1);
        for (int k = 2; k < columns; ++k) nodes_.c[k] = scalar(k - 1) / scalar(columns - 1);
        nodes_.finish();
    }

    /// From y with slope f0 to y1 with slope f1.
    void cubic(const scalar& t, const vector& y, const scalar& h, const vector& y1, const vector& f0,
               const vector& f1, output& now) const {
        now.cover(nodes_, t, h, y);
        auto& z = now.increments();
        z.col(0) = h * f0;
        z.col(1) = y1 - y;
        for (int k = 2; k < nodes_.size; ++k) {
            const scalar x = nodes_.c[k];
            z.col(k) = (x * x * (3 - 2 * x)) * (y1 - y) + (x * (1 - x) * h) * ((1 - x) * f0 - x * f1);
        }
    }
    /// The same of (q, v) with slopes (v, a).
    void quintic(const scalar& t, const vector& y, const scalar& h, const vector& y1, const vector& f0,
                 const vector& f1, output& now) const {
        now.cover(nodes_, t, h, y);
        auto& z = now.increments();
        z.col(0) = h * f0;
        z.col(1) = y1 - y;
        const Eigen::Index n = y.size() / 2;
        for (int k = 2; k < nodes_.size; ++k) {
            // u(x) = x v0 + x^2 a0/2 + x^3 (c3 + c4 x + c5 x^2) in units of the step, less q.
            const scalar x = nodes_.c[k];
            for (Eigen::Index i = 0; i < n; ++i) {
                const scalar v0 = h * y[n + i], v1 = h * y1[n + i], a0 = h * h * f0[n + i] / 2,
                             a1 = h * h * f1[n + i] / 2;
                const scalar rest = y1[i] - y[i] - v0 - a0, turn = v1 - v0 - 2 * a0, bend = a1 - a0;
                const scalar c3 = 10 * rest - 4 * turn + bend, c4 = 7 * turn - 15 * rest - 2 * bend,
                             c5 = 6 * rest - 3 * turn + bend;
                z(i, k) = x * (v0 + x * (a0 + x * (c3 + x * (c4 + x * c5))));
                z(n + i, k) = (x * (2 * a0 + x * (3 * c3 + x * (4 * c4 + x * (5 * c5))))) / h;
            }
        }
    }

  private:
    interpolation_nodes<scalar, Space::columns> nodes_;
};

}  // namespace stagecraft
