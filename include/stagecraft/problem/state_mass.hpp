// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include <stagecraft/break_points.hpp>
#include <stagecraft/jacobian/automatic.hpp>
#include <stagecraft/linear/split_lu.hpp>
#include <stagecraft/owned_value.hpp>
#include <stagecraft/problem/capabilities.hpp>
#include <stagecraft/problem/parts.hpp>

namespace stagecraft {

/// Optional: `problem.mass(t, y)` returns a matrix M that depends on t or y, an n x n matrix of Eigen's (an object, in the
/// scalar of y): M(t, y) y' = f(t, y), circuits with capacitances that depend on the voltage, multibody systems in minimal
/// coordinates. M must be regular wherever the run comes; with a singular one write fully_implicit (problem/fully_implicit.hpp).
template <class Problem, class Vector>
concept has_state_mass = requires(Problem& p, const typename Vector::Scalar& t, const Vector& y) {
    { p.mass(t, y) } -> detail::owns_numbers;
    p.mass(t, y).rows();
    p.mass(t, y).cols();
};

namespace detail {

/// y' = M(t, y)^-1 f(t, y), which has the steps of the explicit form: a factorisation of M at every evaluation, and where f
/// and mass() are generic, one at every evaluation of the Jacobian, as M y'_p = f_p - M_p y'. A jacobian() of f alone is not
/// that of y', and not asked for.
template <class Problem, class Vector>
class explicit_form
    : public optional_domain<explicit_form<Problem, Vector>, has_domain<Problem, Vector>>,
      public optional_break_points<explicit_form<Problem, Vector>, has_break_points<Problem>> {
    static constexpr int N = Vector::RowsAtCompileTime;
    template <class S>
    using column = Eigen::Matrix<S, N, 1>;
    template <class S>
    using square = Eigen::Matrix<S, N, N>;
    template <class T, class S>
    static constexpr bool callable =
        callable_unconverted<Problem, const T&, const column<S>&, column<S>&>&& requires(Problem& p,
                                                                                         const T& t,
                                                                                         const column<S>& y) {
        {square<S>(p.mass(t, y))};
    };

  public:
    using scalar = typename Vector::Scalar;

    /// bad_problem where M is not n x n, or singular at the start.
    explicit_form(Problem& problem, const scalar& t0, const Vector& y0) : problem_(problem) {
        const auto M = problem.mass(t0, y0);
        if (M.rows() != y0.size() || M.cols() != y0.size())
            throw bad_problem("integrate: problem.mass(t, y) must be n x n, n the size of y0");
        const int n = static_cast<int>(y0.size());
        const square<scalar> rows =
            M.array().colwise() / M.rowwise().template lpNorm<Eigen::Infinity>().array();
        factors lu(n);
        bool regular = factor(lu, rows, [](const scalar& x) { return x; });
        for (int k = 0; regular && k < n; ++k)
            regular = lu.pivot(k) > n * std::numeric_limits<scalar>::epsilon();
        if (M.allFinite() && !regular)
            throw bad_problem(
                "integrate: problem.mass(t, y) is singular at y0, and so gives no y': write the problem with "
                "fully_implicit of problem/fully_implicit.hpp");
    }

    void operator()(const scalar& t, const Vector& y, Vector& f) const {
        problem_(t, y, f);
        factors lu(static_cast<int>(y.size()));
        solve(lu, factor(lu, problem_.mass(t, y), [](const scalar& x) { return x; }), f);
    }
    template <class T, class Dual>
    requires(is_dual<Dual>&& callable<T, Dual>) void operator()(const T& t, const column<Dual>& y,
                                                                column<Dual>& f) const {
        problem_(t, y, f);
        const square<Dual> M = problem_.mass(t, y);
        const int n = static_cast<int>(y.size());
        factors lu(n);
        const bool regular = factor(lu, M, [](const Dual& x) { return x.value(); });
        Vector slope(n), rest(n);
        for (int i = 0; i < n; ++i) slope[i] = f[i].value();
        solve(lu, regular, slope);
        for (int k = 0; k < static_cast<int>(Dual::derivatives_type::RowsAtCompileTime); ++k) {
            for (int i = 0; i < n; ++i) {
                rest[i] = f[i].derivatives()[k];
                for (int j = 0; j < n; ++j) rest[i] -= M(i, j).derivatives()[k] * slope[j];
            }
            solve(lu, regular, rest);
            for (int i = 0; i < n; ++i) f[i].derivatives()[k] = rest[i];
        }
        for (int i = 0; i < n; ++i) f[i].value() = slope[i];
    }

    auto jumps() const { return problem_.break_points(); }
    bool within(const scalar& t, const Vector& y) const { return problem_.domain(t, y); }
    template <class Tolerance>
    requires requires(Problem& p, Vector& y, const Tolerance& atol) { p.clip(y, atol); }
    long clip(Vector& y, const Tolerance& atol) const { return problem_.clip(y, atol); }

  private:
    using factors = split_lu<scalar, N>;
    template <class Matrix, class Value>
    static bool factor(factors& lu, const Matrix& M, const Value& value) {
        scalar* entries = lu.entries();
        for (Eigen::Index j = 0; j < M.cols(); ++j)
            for (Eigen::Index i = 0; i < M.rows(); ++i) *entries++ = value(M(i, j));
        return lu.factor();
    }
    /// NaN where M is singular, which ends the attempt.
    static void solve(const factors& lu, bool regular, Vector& x) {
        if (regular)
            lu.solve(x.data());
        else
            x.setConstant(std::numeric_limits<scalar>::quiet_NaN());
    }

    Problem& problem_;
};

}  // namespace detail

}  // namespace stagecraft
