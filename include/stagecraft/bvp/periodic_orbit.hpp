// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>
#include <utility>
#include <vector>

#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/observe/solution.hpp>

namespace stagecraft {

/// A stretch of a trajectory that nearly returns to where it began.
template <class Vector>
struct orbit_guess {
    using scalar = typename Vector::Scalar;
    solution<Vector> y;
    scalar begin{0}, period{0};
};

/// What periodic_orbit may be told; see bvp_options.
template <class Scalar>
struct orbit_options {
    Scalar rtol = Scalar(1) / 1000000;
    Scalar atol{0};
    int intervals = 20;
    int max_intervals = 10000;
    int phase_component = -1;  ///< i >= 0: the phase is fixed by y_i(0) = phase_value (lecture 4.4.1), which
    Scalar phase_value{0};     ///< needs f_i(y(0)) != 0; else by f(g) (y(0) - g) = 0, g the guess at 0
};

/// A Floquet multiplier and its estimated absolute error.
template <class Scalar>
struct floquet_multiplier {
    std::complex<Scalar> value;
    Scalar error;
};

template <class Vector>
struct orbit_result {
    using scalar = typename Vector::Scalar;
    bvp_status status = bvp_status::newton_failed;
    std::string message;
    scalar period{0};
    solution<Vector> y;                                   ///< over [0, 1], time in units of the period
    std::vector<floquet_multiplier<scalar>> multipliers;  ///< by decreasing modulus
    bvp_error<Vector> error;                              ///< error.parameters[0] is that of the period
    std::vector<scalar> mesh;
    bvp_report report;

    bool ok() const { return status == bvp_status::success; }
};

namespace detail {

/// y' = T f(y) on [0, 1].
template <class Rhs>
struct scaled_rhs {
    Rhs f;
    template <class T, class Y, class P>
    requires(std::is_invocable_v<Rhs&, const T&, const Y&, Y&>) void operator()(const T& t, const Y& y,
                                                                                const P& p, Y& out) {
        f(t, y, out);
        for (Eigen::Index i = 0; i < out.size(); ++i) out[i] = out[i] * p[0];
    }
};

template <class Vector>
struct orbit_conditions {
    Vector at, normal;
    typename Vector::Scalar shift;
    template <class Y, class P, class R>
    void operator()(const Y& left, const Y& right, const P&, R& r) const {
        const Eigen::Index n = at.size();
        for (Eigen::Index i = 0; i < n; ++i) r[i] = left[i] - right[i];
        r[n] = left[0] * typename Vector::Scalar(0) - shift;
        for (Eigen::Index i = 0; i < n; ++i) r[n] = r[n] + normal[i] * (left[i] - at[i]);
    }
};

/// The eigenvalues of X_{L-1} ... X_0 by orthogonal iteration on the factors (periodic QR without shifts): each
/// sweep makes X_k Q = Q' R_k, and the eigenvalues are products of the diagonals of R_k, so that those of
/// small modulus keep their relative accuracy, which forming the product would lose. Eigenvalues of equal
/// modulus are taken from the product of the triangles.
template <class Matrix>
std::vector<std::complex<typename Matrix::Scalar>> product_eigenvalues(const std::vector<Matrix>& X) {
    using scalar = typename Matrix::Scalar;
    using std::abs;
    using dense = Eigen::Matrix<scalar, Eigen::Dynamic, Eigen::Dynamic>;
    const int n = static_cast<int>(X[0].rows());
    dense Q = dense::Identity(n, n), product, turn;
    scalar before(2);
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
        scalar off(0);
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                if (i != j) off = std::max(off, scalar(abs(turn(i, j))));
        if (off < 100 * std::numeric_limits<scalar>::epsilon()) break;
        if (sweep > 10 && off >= before) break;
        before = off;
    }
    // Blocks that have not settled are those of equal modulus.
    std::vector<std::complex<scalar>> values;
    const dense T = turn * product;
    for (int k = 0; k < n;) {
        int end = k + 1;
        for (int j = k; j < end; ++j)
            for (int i = end; i < n; ++i)
                if (abs(turn(i, j)) > scalar(1e-6)) end = i + 1;
        if (end == k + 1) {
            values.emplace_back(turn(k, k) * product(k, k));
        } else {
            const Eigen::EigenSolver<dense> solver(T.block(k, k, end - k, end - k), false);
            for (int i = 0; i < end - k; ++i) values.push_back(solver.eigenvalues()[i]);
        }
        k = end;
    }
    std::sort(values.begin(), values.end(),
              [](const auto& a, const auto& b) { return std::abs(a) > std::abs(b); });
    return values;
}

template <class Solver>
auto multipliers_of(Solver& solver) {
    auto& e = solver.linearised();
    using scalar = std::decay_t<decltype(solver.solution_on_mesh().t[0])>;
    using dense = Eigen::Matrix<scalar, Eigen::Dynamic, Eigen::Dynamic>;
    std::vector<dense> X;
    for (int i = 0; i < solver.solution_on_mesh().intervals(); ++i)
        X.push_back(dense(-e.right_block(i)).partialPivLu().solve(dense(e.left_block(i))));
    return product_eigenvalues(X);
}

/// Is the orbit a point, or run through several times?
template <class Result>
void judge_orbit(Result& r, const typename Result::scalar& tolerance) {
    using scalar = typename Result::scalar;
    const auto start = r.y(scalar(0));
    scalar size(0);
    for (int k = 1; k < 64; ++k) size = std::max(size, scalar((r.y(scalar(k) / 64) - start).norm()));
    if (size <= scalar(1000) * tolerance * (scalar(1) + start.norm())) {
        r.status = bvp_status::equilibrium;
        r.message = "the orbit is a point";
        return;
    }
    for (int times = 2; times < 8; ++times) {
        scalar gap(0);
        for (int k = 0; k < 8; ++k) {
            const scalar s = scalar(k) / scalar(8 * times);
            gap = std::max(gap, scalar((r.y(s) - r.y(s + scalar(1) / scalar(times))).norm()));
        }
        if (gap <= scalar(1000) * tolerance * size) {
            r.status = bvp_status::multiple_period;
            r.message =
                "the period is a multiple of the smallest one, at least " + std::to_string(times) + " times";
        }
    }
}

}  // namespace detail

/// A periodic orbit of the autonomous y' = f(y), its period (unknown, in the border of the linear systems) and
/// its Floquet multipliers. f is called as f(t, y, out); guess from last_return(), or any orbit_guess. The
/// error of a multiplier is its change when every interval is halved the last time (at most four
/// times, until they settle to seven digits); one of them is 1.
template <class Scalar, int S, class Rhs, class Vector>
orbit_result<Vector> periodic_orbit(const tableau<Scalar, S>& method, Rhs f, const orbit_guess<Vector>& guess,
                                    const orbit_options<std::type_identity_t<Scalar>>& o = {}) {
    using std::abs;
    if (!(guess.period > Scalar(0)) || !(guess.period - guess.period == Scalar(0)))
        throw std::invalid_argument("periodic_orbit: guess.period must be positive and finite");
    const Vector at = guess.y(guess.begin);
    const int n = static_cast<int>(at.size());
    if (o.phase_component >= n)
        throw std::invalid_argument("periodic_orbit: phase_component must be below the size of y");
    Vector normal(n);
    f(guess.begin, at, normal);
    if (!(normal.norm() > Scalar(0))) {
        orbit_result<Vector> r;
        r.status = bvp_status::equilibrium;
        r.message = "the guess begins at an equilibrium";
        return r;
    }
    Scalar shift(0);
    normal /= normal.norm();
    if (o.phase_component >= 0) {
        normal.setZero();
        normal[o.phase_component] = Scalar(1);
        shift = o.phase_value - at[o.phase_component];
    }
    using problem = two_point_problem<detail::scaled_rhs<Rhs>, detail::orbit_conditions<Vector>>;
    using parameters = Eigen::Matrix<Scalar, 1, 1>;
    problem scaled{{f}, {at, normal, shift}};
    bvp_options<Scalar> b;
    b.rtol = o.rtol, b.atol = o.atol, b.intervals = o.intervals, b.max_intervals = o.max_intervals;
    b.conditioning = false;
    detail::validate(b, Scalar(0), Scalar(1));
    detail::bvp_solver<Scalar, S, problem, Vector, parameters, 0> solver(method, scaled, n,
                                                                         parameters(guess.period), b);
    const auto value = [&](const Scalar& s) {
        const Scalar t = guess.begin + s * guess.period;
        return guess.y(t < guess.y.t1() ? t : guess.y.t1());
    };
    auto solved = solver.run(value, Scalar(0), Scalar(1));
    orbit_result<Vector> r;
    r.status = solved.status, r.message = solved.message;
    r.period = solved.p[0];
    r.y = std::move(solved.y);
    r.error = solved.error, r.mesh = solved.mesh, r.report = solved.report;
    if (!r.ok()) return r;
    detail::judge_orbit(r, o.rtol);
    // Multipliers far below 1 are found to their last digits only on meshes much finer than the orbit asks for.
    auto fine = detail::multipliers_of(solver), coarse = fine;
    bool settled = false;
    for (int pass = 0; pass < 4 && !settled; ++pass) {
        solver.halve();
        coarse = std::exchange(fine, detail::multipliers_of(solver));
        settled = true;
        for (int k = 0; k < n; ++k) settled &= std::abs(fine[k] - coarse[k]) <= 1e-7 * std::abs(fine[k]);
    }
    for (int k = 0; k < n; ++k) {
        const Scalar rounding = 100 * std::numeric_limits<Scalar>::epsilon() * std::abs(fine[k]);
        r.multipliers.push_back({fine[k], std::abs(fine[k] - coarse[k]) + rounding});
    }
    return r;
}

}  // namespace stagecraft
