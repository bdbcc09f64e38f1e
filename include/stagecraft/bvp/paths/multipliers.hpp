// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace stagecraft {

/// A Floquet multiplier and its estimated absolute error.
template <class Scalar>
struct floquet_multiplier {
    std::complex<Scalar> value;
    Scalar error;
};

namespace detail {

/// The eigenvalues of X_{L-1} ... X_0, by decreasing modulus, from the periodic Schur form Q_{k+1}^T X_k Q_k = R_k
/// (Kressner 2005), which orthogonal iteration on the factors makes: each sweep sends Q through
/// all factors. Eigenvalues are products of diagonal entries of the R_k, so that those of small modulus keep
/// their relative accuracy, which forming the product would lose; where moduli are so close that the sweeps do not
/// separate them (complex pairs, say), those of the product of the diagonal blocks.
template <class Matrix>
std::vector<std::complex<typename Matrix::Scalar>> product_eigenvalues(const std::vector<Matrix>& X) {
    using scalar = typename Matrix::Scalar;
    using std::abs;
    using dense = Eigen::Matrix<scalar, Eigen::Dynamic, Eigen::Dynamic>;
    const int n = static_cast<int>(X[0].rows());
    const scalar noise = 10 * scalar(n) * scalar(X.size()) * std::numeric_limits<scalar>::epsilon();
    dense Q = dense::Identity(n, n), product, turn;
    for (int sweep = 0; sweep < 60; ++sweep) {
        const dense start = Q;
        product = dense::Identity(n, n);
        for (const auto& factor : X) {
            const Eigen::HouseholderQR<dense> qr(dense(factor * Q));
            const dense R = qr.matrixQR().template triangularView<Eigen::Upper>();
            Q = qr.householderQ() * dense::Identity(n, n);
            product = (R * product).eval();
        }
        turn = start.transpose() * Q;
        const dense off = turn - dense(turn.diagonal().asDiagonal());
        if (off.cwiseAbs().maxCoeff() < noise) break;
    }
    std::vector<std::complex<scalar>> values;
    for (int k = 0; k < n;) {
        int end = k + 1;
        for (int j = k; j < end; ++j)
            for (int i = end; i < n; ++i)
                if (abs(turn(i, j)) > noise) end = i + 1;
        const int m = end - k;
        // The other blocks would add nothing but rounding errors times larger eigenvalues.
        const dense block = turn.block(k, k, m, m) * product.block(k, k, m, m);
        if (m == 1) {
            values.emplace_back(block(0, 0));
        } else {
            const Eigen::EigenSolver<dense> solver(block, false);
            for (int i = 0; i < m; ++i) values.push_back(solver.eigenvalues()[i]);
        }
        k = end;
    }
    std::sort(values.begin(), values.end(),
              [](const auto& a, const auto& b) { return std::abs(a) > std::abs(b); });
    return values;
}

/// The multipliers of the equations linearised at the solution that `solver` holds, in the first `n` components.
template <class Solver>
auto multipliers_of(Solver& solver, int n) {
    auto& e = solver.linearised();
    using scalar = std::decay_t<decltype(solver.solution_on_mesh().t[0])>;
    using dense = Eigen::Matrix<scalar, Eigen::Dynamic, Eigen::Dynamic>;
    std::vector<dense> X;
    for (int i = 0; i < solver.solution_on_mesh().intervals(); ++i) {
        const dense step = dense(-e.right_block(i)).partialPivLu().solve(dense(e.left_block(i)));
        X.push_back(step.topLeftCorner(n, n));
    }
    return product_eigenvalues(X);
}

/// The integral of the trace of f_y over the interval, by the method's weights at its nodes, whose Jacobians the
/// equations hold; its exponential is the product of the multipliers (Liouville).
template <class Solver>
auto trace_integral(Solver& solver, int n) {
    auto& e = solver.linearised();
    const auto& x = solver.solution_on_mesh();
    std::decay_t<decltype(x.t[0])> sum(0);
    const int width = e.n() + e.np();
    for (int i = 0; i < x.intervals(); ++i)
        for (int j = 0; j < e.s(); ++j)
            for (int c = 0; c < n; ++c) sum += x.h(i) * e.method().b[j] * e.jacobians(i)(c, j * width + c);
    return sum;
}

/// Which of the multipliers is the one that is 1, with the direction of the orbit.
template <class Scalar>
std::size_t trivial(const std::vector<floquet_multiplier<Scalar>>& multipliers) {
    const auto at =
        std::min_element(multipliers.begin(), multipliers.end(), [](const auto& a, const auto& b) {
            return std::abs(a.value - Scalar(1)) < std::abs(b.value - Scalar(1));
        });
    return static_cast<std::size_t>(at - multipliers.begin());
}

/// The multipliers of the orbit that `solver` holds, with errors: their change when every interval is halved the last time (at
/// most `passes` times, until they settle to seven digits; those far below 1 ask for meshes much finer than the
/// orbit does). The one nearest to 1 is no better than its distance from 1, and the one of least modulus no better
/// than the product of all, which is known (trace_integral).
template <class Solver>
auto multipliers_with_errors(Solver& solver, int n, int passes) {
    using std::abs;
    using std::exp;
    using std::log;
    auto fine = multipliers_of(solver, n), coarse = fine;
    using scalar = typename std::decay_t<decltype(fine[0])>::value_type;
    bool settled = false;
    for (int pass = 0; pass < passes && !settled; ++pass) {
        solver.halve();
        coarse = std::exchange(fine, multipliers_of(solver, n));
        settled = true;
        for (int k = 0; k < n; ++k) settled &= abs(fine[k] - coarse[k]) <= scalar(1e-7) * abs(fine[k]);
    }
    std::vector<floquet_multiplier<scalar>> out;
    scalar logarithms(0);
    for (int k = 0; k < n; ++k) {
        const scalar rounding = 100 * std::numeric_limits<scalar>::epsilon() * abs(fine[k]);
        out.push_back({fine[k], abs(fine[k] - coarse[k]) + rounding});
        logarithms += log(abs(fine[k]));
    }
    const auto raise = [](scalar& error, const scalar& least) {
        if (!(error >= least)) error = least;
    };
    auto& one = out[trivial(out)];
    raise(one.error, abs(one.value - scalar(1)));
    raise(out.back().error, abs(exp(logarithms - trace_integral(solver, n)) - 1) * abs(fine.back()));
    return out;
}

/// The product of 1 + mu over all multipliers, those beyond the unit circle divided by their modulus: it changes its sign where
/// an odd number of them passes -1.
template <class Scalar>
Scalar doubling_test(const std::vector<floquet_multiplier<Scalar>>& multipliers) {
    std::complex<Scalar> product(1);
    for (const auto& m : multipliers)
        product *= (Scalar(1) + m.value) / std::max(Scalar(1), Scalar(std::abs(m.value)));
    return product.real();
}

/// The same of 1 - mu mu' over all pairs without the trivial multiplier: it vanishes where a complex pair is on the unit
/// circle, and where two real ones are inverse to each other.
template <class Scalar>
Scalar torus_test(const std::vector<floquet_multiplier<Scalar>>& multipliers) {
    const std::size_t one = trivial(multipliers);
    std::complex<Scalar> product(1);
    for (std::size_t j = 0; j < multipliers.size(); ++j)
        for (std::size_t i = 0; i < j; ++i) {
            if (i == one || j == one) continue;
            const std::complex<Scalar> pair = multipliers[i].value * multipliers[j].value;
            product *= (Scalar(1) - pair) / std::max(Scalar(1), Scalar(std::abs(pair)));
        }
    return product.real();
}

/// Is there a complex multiplier near the unit circle?
template <class Scalar>
bool on_unit_circle(const std::vector<floquet_multiplier<Scalar>>& multipliers) {
    return std::any_of(multipliers.begin(), multipliers.end(), [](const auto& m) {
        return std::abs(std::abs(m.value) - Scalar(1)) < Scalar(1e-6) &&
               std::abs(m.value.imag()) > Scalar(1e-3);
    });
}

}  // namespace detail

}  // namespace stagecraft
