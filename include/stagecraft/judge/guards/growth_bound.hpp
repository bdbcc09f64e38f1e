// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace stagecraft {

/// Proofs that no solution of y' = J y grows faster than e^{rate t} in some norm, where they cost little beside a
/// factorisation of J: logarithmic norms (Hairer-Norsett-Wanner I, Theorem I.10.5) for diffusion, advection and chains and
/// networks of reactions, the energy of an oscillating structure, q' = v, v' = -K q - D v, for others.
template <class Scalar>
class growth_bound {
  public:
    /// True if it is proved, forwards in time (towards = 1) or backwards (-1), of the n x n matrix J kept by columns.
    /// Costs 2 n^2 operations, n^3 / 24 where q' = v, and where neither proves it up to n^3 / 3, much less if most
    /// entries of J are zero.
    bool holds(const Scalar* J, int n, const Scalar& towards, const Scalar& rate) {
        return logarithmic_norm_below(J, n, towards, rate) || energy_holds(J, n, towards, rate) ||
               weighted_norm_below(J, n, towards, rate);
    }

  private:
    /// The one of the largest component or of the sum of all is at most `rate`.
    bool logarithmic_norm_below(const Scalar* J, int n, const Scalar& towards, const Scalar& rate) {
        using std::abs;
        rows_.assign(static_cast<std::size_t>(n), Scalar(0));
        bool columns = true;
        for (int j = 0; j < n; ++j, J += n) {
            Scalar sum(0);
            for (int i = 0; i < n; ++i) {
                const Scalar size = abs(J[i]);
                rows_[i] += size;
                sum += size;
            }
            const Scalar sign = towards * J[j] - abs(J[j]);
            rows_[j] += sign;
            columns = columns && sum + sign <= rate;
        }
        const auto small = [&](const Scalar& sum) { return sum <= rate; };
        return columns || std::all_of(rows_.begin(), rows_.end(), small);
    }

    /// The logarithmic norm of the largest component is below `rate` with some weights d > 0: rate d_i > J_ii d_i + sum over
    /// the other j of |J_ij| d_j. As no entry beside the diagonal of this matrix, rate I less J_ii and |J_ij|, is positive,
    /// there are such d if and only if its elimination without row exchanges has positive pivots (M-matrices).
    bool weighted_norm_below(const Scalar* J, int n, const Scalar& towards, const Scalar& rate) {
        using std::abs;
        a_.assign(J, J + static_cast<std::ptrdiff_t>(n) * n);
        for (Scalar& entry : a_) entry = -abs(entry);
        for (int j = 0; j < n; ++j) a_[j + j * n] = rate - towards * J[j + j * n];
        for (int j = 0; j < n; ++j) {
            Scalar* const aj = a_.data() + j * n;
            const Scalar least = 100 * std::numeric_limits<Scalar>::epsilon() * (rate + abs(J[j + j * n]));
            for (int k = 0; k < j; ++k) {
                const Scalar u = aj[k];
                if (u == Scalar(0)) continue;
                const Scalar* const l = a_.data() + k * n;
                for (int i = k + 1; i < n; ++i) aj[i] -= l[i] * u;
            }
            if (!(aj[j] > least)) return false;
            for (int i = j + 1; i < n; ++i) aj[i] /= aj[j];
        }
        return true;
    }

    /// Where the first half of the components are q, the others v = q', and K is symmetric for some masses P: E = v^T P v +
    /// q^T (P K + c^2 P) q grows by no more than e^{(3 + 1/4) c t} if P K + c^2/2 P and c P - (P D + D^T P)/2
    /// (backwards: plus) are positive definite, as E' = -2 v^T P D v + 2 c^2 v^T P q. (The quarter: what rounding or
    /// differences leave of P K - K^T P.) The amplitude grows like the square root of E.
    [[gnu::cold]] bool energy_holds(const Scalar* J, int n, const Scalar& towards, const Scalar& rate) {
        const int m = n / 2;
        if (n % 2 != 0 || !positions_first(J, m)) return false;
        const Scalar* const K = J + m;  // with the other sign, columns n apart as those of D
        const Scalar *const D = K + m * n, c = rate * 8 / 13;
        if (!find_masses(K, m)) return false;
        a_.resize(static_cast<std::size_t>(m) * static_cast<std::size_t>(m));
        return is_symmetric(K, m, c * c / 4) && is_definite(K, m, Scalar(-1), c * c / 2) &&
               is_definite(D, m, -towards, c);
    }
    static bool positions_first(const Scalar* J, int m) {
        const int n = 2 * m;
        for (int j = n - 1; j >= 0; --j)
            for (int i = 0; i < m; ++i)
                if (!(J[i + j * n] == Scalar(i + m == j ? 1 : 0))) return false;
        return true;
    }
    /// P_i K_ij = P_j K_ji determines P up to a factor for all that is connected; false if it is not positive.
    [[gnu::cold]] bool find_masses(const Scalar* K, int m) {
        masses_.assign(static_cast<std::size_t>(m), Scalar(0));
        found_.clear();
        for (int first = 0, next = 0; first < m; ++first) {
            if (masses_[first] > Scalar(0)) continue;
            masses_[first] = Scalar(1);
            found_.push_back(first);
            for (; next < static_cast<int>(found_.size()); ++next)
                for (int i = found_[next], j = 0; j < m; ++j) {
                    if (masses_[j] > Scalar(0) || K[i + 2 * m * j] == Scalar(0)) continue;
                    masses_[j] = masses_[i] * (K[i + 2 * m * j] / K[j + 2 * m * i]);
                    if (!(masses_[j] > Scalar(0) && masses_[j] < std::numeric_limits<Scalar>::max()))
                        return false;
                    found_.push_back(j);
                }
        }
        return true;
    }
    /// The rows of |P K - K^T P| sum up to no more than `most` masses.
    bool is_symmetric(const Scalar* K, int m, const Scalar& most) const {
        using std::abs;
        for (int i = 0; i < m; ++i) {
            Scalar sum(0);
            for (int j = 0; j < m; ++j)
                sum += abs(masses_[i] * K[i + 2 * m * j] - masses_[j] * K[j + 2 * m * i]);
            if (!(sum <= most * masses_[i])) return false;
        }
        return true;
    }
    /// sign (P A + A^T P)/2 + shift P is positive definite, by more than rounding: its Cholesky factors exist.
    bool is_definite(const Scalar* A, int m, const Scalar& sign, const Scalar& shift) {
        using std::abs;
        for (int j = 0; j < m; ++j) {
            for (int i = j; i < m; ++i)
                a_[i + j * m] = sign * (masses_[i] * A[i + 2 * m * j] + masses_[j] * A[j + 2 * m * i]) / 2;
            a_[j + j * m] += shift * masses_[j];
        }
        for (int j = 0; j < m; ++j) {
            Scalar* const aj = a_.data() + j * m;
            const Scalar before = abs(masses_[j] * A[j + 2 * m * j]);
            if (!(aj[j] > 100 * std::numeric_limits<Scalar>::epsilon() * before)) return false;
            for (int k = j + 1; k < m; ++k) {
                const Scalar factor = aj[k] / aj[j];
                if (factor == Scalar(0)) continue;
                Scalar* const ak = a_.data() + k * m;
                for (int i = k; i < m; ++i) ak[i] -= factor * aj[i];
            }
        }
        return true;
    }

    std::vector<Scalar> rows_, masses_, a_;
    std::vector<int> found_;
};

}  // namespace stagecraft
