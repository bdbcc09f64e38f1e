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

#include <stagecraft/bvp/judge/multiplier_judge.hpp>

namespace stagecraft {

/// A Floquet multiplier and its estimated absolute error. Its logarithm ln |value| + i arg(value), the Floquet exponent times
/// the period, is known whatever its size: where value is 0 or infinite because a double holds nothing as small or as large
/// (1e-308, 1e308), it is what is left. Its error is the relative one of the multiplier.
template <class Scalar>
struct floquet_multiplier {
    std::complex<Scalar> value;
    Scalar error;
    std::complex<Scalar> logarithm{};
    Scalar logarithm_error{0};
};

namespace detail {

/// The logarithms of the eigenvalues of X_{L-1} ... X_0, by decreasing modulus, from the periodic Schur form Q_{k+1}^T X_k Q_k
/// = R_k (Kressner 2005), which orthogonal iteration on the factors makes: each sweep sends Q through
/// all factors. Eigenvalues are products of diagonal entries of the R_k, so that those of small modulus keep
/// their relative accuracy, which forming the product would lose; where moduli are so close that the sweeps do not
/// separate them (complex pairs, say), those of the product of the diagonal blocks.
template <class Matrix>
std::vector<std::complex<typename Matrix::Scalar>> product_logarithms(const std::vector<Matrix>& X) {
    using scalar = typename Matrix::Scalar;
    using std::abs;
    using std::log;
    using dense = Eigen::Matrix<scalar, Eigen::Dynamic, Eigen::Dynamic>;
    const int n = static_cast<int>(X[0].rows());
    const scalar noise = 10 * scalar(n) * scalar(X.size()) * std::numeric_limits<scalar>::epsilon();
    dense Q = dense::Identity(n, n), turn;
    std::vector<dense> R(X.size());
    for (int sweep = 0; sweep < 60; ++sweep) {
        const dense start = Q;
        for (std::size_t k = 0; k < X.size(); ++k) {
            const Eigen::HouseholderQR<dense> qr(dense(X[k] * Q));
            R[k] = qr.matrixQR().template triangularView<Eigen::Upper>();
            Q = qr.householderQ() * dense::Identity(n, n);
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
        // The other blocks would add nothing but rounding errors times larger eigenvalues. Sizes go into the logarithm.
        dense block = dense::Identity(m, m);
        scalar size(0);
        const auto multiply = [&](const dense& by) {
            block = (by * block).eval();
            const scalar largest = block.cwiseAbs().maxCoeff();
            if (largest > scalar(0) && largest - largest == scalar(0)) block /= largest, size += log(largest);
        };
        for (const dense& r : R) multiply(r.block(k, k, m, m));
        multiply(turn.block(k, k, m, m));
        if (m == 1) {
            values.push_back(size + log(std::complex<scalar>(block(0, 0))));
        } else {
            const Eigen::EigenSolver<dense> solver(block, false);
            for (int i = 0; i < m; ++i)
                values.push_back(size + log(std::complex<scalar>(solver.eigenvalues()[i])));
        }
        k = end;
    }
    std::sort(values.begin(), values.end(), [](const auto& a, const auto& b) {
        return a.real() > b.real() || (a.real() == b.real() && a.imag() > b.imag());
    });
    return values;
}

/// The number of which this is the logarithm; real where its argument is that of a real one to rounding.
template <class Scalar>
std::complex<Scalar> number_of(const std::complex<Scalar>& logarithm) {
    using std::abs;
    const Scalar size = std::exp(logarithm.real()), c = std::cos(logarithm.imag()),
                 s = std::sin(logarithm.imag());
    if (abs(s) <= std::numeric_limits<Scalar>::epsilon()) return c < Scalar(0) ? -size : size;
    return {size * c, size * s};
}

/// The logarithms of the multipliers of the equations linearised at the solution that `solver` holds, in the first `n` components.
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
    return product_logarithms(X);
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

/// Is none of the multipliers 1?
template <class Scalar>
bool trivial_is_lost(const std::vector<floquet_multiplier<Scalar>>& multipliers) {
    return multiplier_judge<Scalar>::lost(std::abs(multipliers[trivial(multipliers)].value - Scalar(1)));
}

/// Of the multiplier of least modulus, if it is real: what the product of all, e^trace, leaves for it, where it was not found
/// to seven digits and that is known better. Its own error is no less than it differs from that by.
template <class Scalar>
void take_last_from_trace(std::vector<floquet_multiplier<Scalar>>& all, const Scalar& trace,
                          const Scalar& trace_error) {
    using std::abs;
    auto& last = all.back();
    Scalar left = trace, error = trace_error + 100 * std::numeric_limits<Scalar>::epsilon() * abs(trace);
    for (const auto& m : all)
        if (&m != &last) left -= m.logarithm.real(), error += m.logarithm_error;
    const Scalar off = abs(last.logarithm.real() - left);
    if (!(last.logarithm_error >= off)) last.logarithm_error = off;
    if (!(std::max(error, Scalar(1e-7)) < last.logarithm_error) || last.value.imag() != Scalar(0)) return;
    last.logarithm.real(left), last.logarithm_error = error;
    last.value = number_of(last.logarithm);
}

/// The multipliers of the orbit that `solver` holds, with errors: their change when every interval is halved the last time (at
/// most `passes` times, until they settle to seven digits; those far below 1 ask for meshes much finer than the
/// orbit does; and four times where the one that is 1 is not found). The one nearest to 1 is no better than its distance
/// from 1, and the one of least modulus no better than the product of all, which is known (trace_integral), and makes it known.
template <class Solver>
auto multipliers_with_errors(Solver& solver, int n, int passes) {
    using std::abs;
    auto fine = multipliers_of(solver, n), coarse = fine;
    using complex = std::decay_t<decltype(fine[0])>;
    using scalar = typename complex::value_type;
    const auto size_of = [](const complex& change) {
        const scalar turn = std::arg(number_of(complex(0, change.imag())));
        const scalar size = std::abs(complex(change.real(), turn));
        return size == size ? size : scalar(0);  // both are zero
    };
    const auto build = [&] {
        std::vector<floquet_multiplier<scalar>> out;
        for (int k = 0; k < n; ++k) {
            const scalar rounding = (100 + abs(fine[k])) * std::numeric_limits<scalar>::epsilon();
            const scalar error = size_of(fine[k] - coarse[k]) + (rounding == rounding ? rounding : scalar(0));
            out.push_back({number_of(fine[k]), scalar(0), fine[k], error});
        }
        return out;
    };
    std::vector<floquet_multiplier<scalar>> out = build();
    bool settled = false;
    scalar coarse_trace(0);
    constexpr int most_passes = 4;
    for (int pass = 0; (pass < passes && !settled) || (pass < most_passes && trivial_is_lost(out)); ++pass) {
        coarse_trace = trace_integral(solver, n);
        solver.halve();
        coarse = std::exchange(fine, multipliers_of(solver, n));
        out = build();
        settled = true;
        for (int k = 0; k < n; ++k) settled &= size_of(fine[k] - coarse[k]) <= scalar(1e-7);
    }
    const auto raise = [](scalar& error, const scalar& least) {
        if (!(error >= least)) error = least;
    };
    auto& one = out[trivial(out)];
    raise(one.logarithm_error, abs(one.logarithm));
    const scalar trace = trace_integral(solver, n);
    take_last_from_trace(out, trace, scalar(abs(trace - coarse_trace)));
    for (auto& m : out)
        m.error =
            std::max(std::expm1(m.logarithm_error) * std::abs(m.value), std::numeric_limits<scalar>::min());
    raise(one.error, abs(one.value - scalar(1)));
    return out;
}

/// (1 + mu) / max(1, |mu|), by the logarithm of mu.
template <class Scalar>
std::complex<Scalar> one_plus(const std::complex<Scalar>& logarithm) {
    if (logarithm.real() > Scalar(0))
        return std::exp(-logarithm.real()) + number_of(std::complex<Scalar>(0, logarithm.imag()));
    return Scalar(1) + number_of(logarithm);
}

/// The product of 1 + mu over all multipliers, those beyond the unit circle divided by their modulus: it changes its sign where
/// an odd number of them passes -1.
template <class Scalar>
Scalar doubling_test(const std::vector<floquet_multiplier<Scalar>>& multipliers) {
    std::complex<Scalar> product(1);
    for (const auto& m : multipliers) product *= one_plus(m.logarithm);
    return product.real();
}

/// act(mu mu', error) for all pairs without the trivial multiplier, by logarithms.
template <class Scalar, class Act>
void for_pairs(const std::vector<floquet_multiplier<Scalar>>& multipliers, Act&& act) {
    const std::size_t one = trivial(multipliers);
    for (std::size_t j = 0; j < multipliers.size(); ++j)
        for (std::size_t i = 0; i < j; ++i)
            if (i != one && j != one)
                act(multipliers[i].logarithm + multipliers[j].logarithm,
                    multipliers[i].logarithm_error + multipliers[j].logarithm_error);
}

/// The same of 1 - mu mu' over all pairs without the trivial multiplier: it vanishes where a complex pair is on the unit
/// circle, and where two real ones are inverse to each other.
template <class Scalar>
Scalar torus_test(const std::vector<floquet_multiplier<Scalar>>& multipliers) {
    const std::complex<Scalar> turned(0, std::arg(std::complex<Scalar>(-1)));
    std::complex<Scalar> product(1);
    for_pairs(multipliers, [&](const auto& pair, const Scalar&) { product *= one_plus(pair + turned); });
    return product.real();
}

/// Are all multipliers known so well that the sign of doubling_test is, or torus_test?
template <class Scalar>
bool decides_doubling(const std::vector<floquet_multiplier<Scalar>>& multipliers) {
    bool known = true;
    for (const auto& m : multipliers)
        known &= multiplier_judge<Scalar>::known(std::abs(one_plus(m.logarithm)), m.logarithm_error);
    return known;
}
template <class Scalar>
bool decides_torus(const std::vector<floquet_multiplier<Scalar>>& multipliers) {
    const std::complex<Scalar> turned(0, std::arg(std::complex<Scalar>(-1)));
    bool known = true;
    for_pairs(multipliers, [&](const auto& pair, const Scalar& error) {
        known &= multiplier_judge<Scalar>::known(std::abs(one_plus(pair + turned)), error);
    });
    return known;
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
