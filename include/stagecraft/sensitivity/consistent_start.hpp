// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <vector>

#include <stagecraft/linear/mass.hpp>
#include <stagecraft/sensitivity/matrix_products.hpp>
#include <stagecraft/stages/separate_blocks.hpp>
#include <stagecraft/work.hpp>

namespace stagecraft::detail {

/// J and M as the solvers of stage equations take them.
template <class Matrix, class Mass>
struct matrix_pair {
    using matrix = Matrix;
    using mass_type = Mass;
    Matrix J;
    Mass M;
    const Matrix& jacobian() const { return J; }
    const Mass& mass() const { return M; }
    template <class F>
    static decltype(auto) measure(work, F&& f) {
        return f();
    }
};

/// Solves M x = 0 and u^T (J x + r) = 0 for all u with u^T M = 0: what makes r, the derivative of the algebraic equations of
/// a problem of index 1, vanish by the algebraic components alone. `pair` is M with a matrix near J, add(x, r) adds J x to
/// r. False if there is no such x, as with index 2 and 3.
///
/// No null space is formed, so that any linear solver serves: x is the limit of (c M - J)^-1 r for large c, by extrapolation
/// from c, 2c and 4c. With c of eps^{-1/4} times |J|/|M| rounding and the error of the extrapolation are both of the order
/// eps^{3/4}; where M is diagonal the components that it has are zero exactly.
template <class Blocks, class Pair, class Vector, class Add>
bool solve_algebraic(const Pair& pair, const Vector& r, const Add& add, Vector& x) {
    using std::abs;
    using std::sqrt;
    using scalar = typename Vector::Scalar;
    const scalar eps = std::numeric_limits<scalar>::epsilon();
    const int n = static_cast<int>(r.size());
    // Differential components whose entry of M stands alone in its row and column do not move.
    std::vector<int> entries(static_cast<std::size_t>(n)), alone(entries);
    scalar least(0);
    for (const auto& e : pair.M.entries()) {
        if (least == scalar(0) || abs(e.value) < least) least = abs(e.value);
        ++entries[static_cast<std::size_t>(e.row)], ++entries[static_cast<std::size_t>(e.column)];
        if (e.row == e.column) alone[static_cast<std::size_t>(e.row)] = 1;
    }
    if (least == scalar(0)) least = scalar(1);
    const scalar largest = row_sums(pair.J, n).maxCoeff();
    separate_blocks<scalar, Blocks> blocks(n, 3, 0);
    const scalar c = (largest > scalar(0) ? largest : scalar(1)) / least / sqrt(sqrt(eps));
    const scalar shifts[3] = {c, 2 * c, 4 * c};
    if (!blocks.factor(pair, shifts)) return false;
    Eigen::Matrix<scalar, Vector::RowsAtCompileTime, 3> at(n, 3);
    x.setZero();
    Vector left = r;
    // What differential components contribute is zero up to the error of the extrapolation, in units of |r|/|J|.
    const scalar unit = r.template lpNorm<Eigen::Infinity>() / (largest > scalar(0) ? largest : scalar(1));
    const auto size = [&] {
        const scalar own = x.template lpNorm<Eigen::Infinity>();
        return own < unit ? unit : own;
    };
    scalar change(0);
    for (int k = 0; k < 100; ++k) {  // exact at once where J is that of the pair
        for (int j = 0; j < 3; ++j) at.col(j) = left;
        blocks.solve(pair, at.data());
        const Vector more = (8 * at.col(2) - 6 * at.col(1) + at.col(0)) / scalar(3);
        change = scalar(0);
        for (int i = 0; i < n; ++i) {
            const auto u = static_cast<std::size_t>(i);
            const scalar step = alone[u] == 1 && entries[u] == 2 ? scalar(0) : more[i];
            x[i] += step;
            if (!(abs(step) <= change)) change = abs(step);
        }
        if (!(size() - size() == scalar(0))) return false;
        if (change <= 100 * eps * size()) break;
        left = r;
        add(x, left);
    }
    if (!(change <= sqrt(eps) * size())) return false;
    Vector product = Vector::Zero(n), terms = Vector::Zero(n);
    for (const auto& e : pair.M.entries()) {
        product[e.row] += e.value * x[e.column];
        terms[e.row] += abs(e.value) * size();
    }
    return (product.cwiseAbs() - sqrt(eps) * terms).maxCoeff() <= scalar(0);
}

}  // namespace stagecraft::detail
