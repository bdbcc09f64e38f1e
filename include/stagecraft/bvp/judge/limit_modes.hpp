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
#include <string>
#include <vector>

namespace stagecraft::detail {

/// How solutions of v' = A v behave: how many directions decay, by the eigenvalues of A. What is below the
/// rounding errors of a double eigenvalue counts as zero.
template <class Scalar>
struct limit_spectrum {
    using dense = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    std::vector<Scalar> rates;  ///< real parts, increasing
    Scalar none{0};             ///< up to here a rate counts as zero
    Scalar turning{0};          ///< the imaginary part of an eigenvalue on the axis, off zero
    int decaying = 0;
    bool known = false;

    explicit limit_spectrum(const dense& A) {
        using std::abs;
        using std::sqrt;
        if (!A.allFinite()) return;
        const Eigen::EigenSolver<dense> solver(A, false);
        if (solver.info() != Eigen::Success) return;
        none = 10 * sqrt(std::numeric_limits<Scalar>::epsilon()) * A.norm();
        for (Eigen::Index k = 0; k < A.rows(); ++k) {
            const Scalar rate = solver.eigenvalues()[k].real(), turn = abs(solver.eigenvalues()[k].imag());
            rates.push_back(rate);
            decaying += rate < -none;
            if (abs(rate) <= none && turn > none) turning = turn;
        }
        std::sort(rates.begin(), rates.end());
        known = true;
    }
    /// The slowest rate at which something decays.
    Scalar slowest() const { return -rates[static_cast<std::size_t>(decaying) - 1]; }
};

/// The projection on the directions of A whose eigenvalues have real parts above `bound`, along the others: (I + sign)/2, the
/// sign of A - bound I by Newton's iteration, scaled by norms (Roberts 1980; Higham 2008, chapter 5).
template <class Dense, class Scalar>
Dense projection_above(const Dense& A, const Scalar& bound) {
    using std::sqrt;
    const Eigen::Index n = A.rows();
    Dense X = A - bound * Dense::Identity(n, n);
    for (int k = 0; k < 100; ++k) {
        const Dense inverse = X.partialPivLu().inverse();
        const Scalar scale = k < 20 ? Scalar(sqrt(inverse.norm() / X.norm())) : Scalar(1);
        const Dense next = (scale * X + inverse / scale) / Scalar(2);
        const Scalar change = (next - X).norm();
        X = next;
        if (change <= 100 * std::numeric_limits<Scalar>::epsilon() * Scalar(n) * X.norm()) break;
    }
    return (Dense::Identity(n, n) + X) / Scalar(2);
}

/// k orthonormal columns that span those of a projection of rank k.
template <class Dense>
Dense range_of(const Dense& projection, int k) {
    const Eigen::ColPivHouseholderQR<Dense> factors(projection);
    return Dense(factors.householderQ()).leftCols(k);
}

/// The directions of v' = A v near a state that some solutions approach.
template <class Scalar>
struct directions_of_approach {
    using dense = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    dense linear;       ///< A
    dense others;       ///< the projection on what does not decay
    dense away;         ///< rows that vanish on what does
    Scalar slowest{0};  ///< the rate at which that decays, at least
    Scalar growth{0};   ///< the rate at which the others grow, at least

    /// With the spectrum of A, of which something decays.
    void split(const dense& A, const limit_spectrum<Scalar>& modes) {
        const Eigen::Index n = A.rows();
        const int k = static_cast<int>(n) - modes.decaying;
        linear = A;
        slowest = modes.slowest();
        others = k > 0 ? projection_above(A, Scalar(-slowest / 2)) : dense::Zero(n, n);
        away = range_of(dense(others.transpose()), k).transpose();
        growth = k > 0 ? std::max(modes.rates[static_cast<std::size_t>(modes.decaying)], Scalar(0)) : slowest;
    }
};

/// Why there is no condition at infinity by the eigenvalues at the end of the interval and far beyond, in words; null where
/// there is nothing against it. Rates that fall like 1/t are those of powers of t.
template <class Scalar>
const char* fault_of(const limit_spectrum<Scalar>& here, const limit_spectrum<Scalar>& far,
                     const limit_spectrum<Scalar>& twice_as_far) {
    if (!here.known) return "f or its Jacobian is not finite at limit";
    if (here.turning > Scalar(0))
        return "at limit f_y has eigenvalues on the imaginary axis, so that solutions near it turn and do "
               "not approach it";
    if (here.decaying == 0)
        return "at limit f_y has no eigenvalue with a negative real part, so that no solution approaches it "
               "exponentially";
    if (!far.known || !twice_as_far.known) return nullptr;
    const auto last = static_cast<std::size_t>(here.decaying) - 1;
    const bool still = far.rates[last] < -far.none && twice_as_far.rates[last] < -twice_as_far.none;
    if (!still || 2 * twice_as_far.rates[last] > Scalar(1.2) * far.rates[last])
        return "near limit solutions decay no faster than a power of t, not exponentially";
    return nullptr;
}

}  // namespace stagecraft::detail
