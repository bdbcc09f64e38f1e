// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <utility>
#include <vector>

#include <stagecraft/break_points.hpp>
#include <stagecraft/problem/parts.hpp>
#include <stagecraft/refuse/problem/written_argument.hpp>

namespace stagecraft {

namespace detail {

/// F(t, y, v, out)
template <class F, class T, class S, int N>
concept implicit_equations =
    !reads_last<const F, Eigen::Matrix<S, N, 1>, T, Eigen::Matrix<S, N, 1>, Eigen::Matrix<S, N, 1>>() &&
    callable_unconverted<const F, const T&, const Eigen::Matrix<S, N, 1>&, const Eigen::Matrix<S, N, 1>&,
                         Eigen::Matrix<S, N, 1>&>;
/// F.jacobian(t, y, v, F_y, F_v)
template <class F, class S, int N>
concept implicit_jacobian = requires(const F& f, const S& t, const Eigen::Matrix<S, N, 1>& y,
                                     const Eigen::Matrix<S, N, 1>& v, Eigen::Matrix<S, N, N>& block) {
    f.jacobian(t, y, v, block, block);
};

/// F.domain(t, y)
template <class F, int N>
concept domain_of_values = requires(const F& f, const double& t, const Eigen::Matrix<double, N, 1>& y) {
    f.domain(t, y);
};

}  // namespace detail

/// The fully implicit system F(t, y, y') = 0 of n equations as the system of first order
///
///     y' = v,   0 = F(t, y, v)
///
/// in the state (y; v) with M = diag(I, 0), ready for `integrate`. The matrices that are factored are n x n,
/// shift F_v + F_y, because y' = v eliminates y. Made by `fully_implicit`. N is n, or -1 if n is known only
/// at run time.
template <int N, class F>
class fully_implicit_problem
    : public detail::optional_jacobian<fully_implicit_problem<N, F>, detail::implicit_jacobian<F, double, N>>,
      public detail::optional_domain<fully_implicit_problem<N, F>, detail::domain_of_values<F, N>>,
      public detail::optional_break_points<fully_implicit_problem<N, F>, has_break_points<const F>> {
    static constexpr bool fits = detail::implicit_equations<F, double, double, N>;
    static_assert(fits, "fully_implicit: F must be callable as F(t, y, v, out) with v for y'");
    using values = Eigen::Matrix<double, N, 1>;
    static_assert(
        !fits || detail::writes_into<const F, values, double, values, values>,
        "fully_implicit: F takes out by value, or const, and what it writes is lost: write `Vector& out` "
        "or `auto& out`");
    static_assert(
        !detail::has_member_named<F, detail::jacobian_member> || detail::implicit_jacobian<F, double, N>,
        "fully_implicit: F.jacobian must be callable as F.jacobian(t, y, v, F_y, F_v) on a const F");
    using sizes = part_sizes<N, N>;

  public:
    static constexpr int size = sizes::size;
    static constexpr int second_order_components = N;
    template <class S>
    using state_vector = Eigen::Matrix<S, size, 1>;
    template <class S>
    using part_vector = Eigen::Matrix<S, N, 1>;

    fully_implicit_problem(F f, int n, std::vector<int> index)
        : f_(std::move(f)), parts_(n, n, "fully_implicit"), index_(std::move(index)) {
        if (static_cast<int>(index_.size()) != 2 * n)
            throw std::invalid_argument(
                "fully_implicit: index must hold 2 n flags, those of y and then of y'");
    }

    /// (v; F(t, y, v)) at x = (y; v). Run-time sizes: a const problem allocates, another one does not.
    template <class T, class S>
    requires detail::implicit_equations<F, T, S, N>
    void operator()(const T& t, const state_vector<S>& x, state_vector<S>& out) {
        auto&& parts = parts_.template get<S>();
        evaluate(t, x, parts, out);
    }
    template <class T, class S>
    requires detail::implicit_equations<F, T, S, N>
    void operator()(const T& t, const state_vector<S>& x, state_vector<S>& out) const {
        auto parts = parts_.template get<S>();
        evaluate(t, x, parts, out);
    }

    /// The derivative of (v; F), as jacobian(t, x, J) where F brings its own: F.jacobian(t, y, v, F_y, F_v),
    /// into blocks that arrive zero.
    template <class S, class Matrix>
    void write_jacobian(const S& t, const state_vector<S>& x, Matrix& J) const {
        const int n = parts_.first();
        const part_vector<S> y = x.head(n), v = x.tail(n);
        Eigen::Matrix<S, N, N> F_y(n, n), F_v(n, n);
        F_y.setZero();
        F_v.setZero();
        f_.jacobian(t, y, v, F_y, F_v);
        J.topRows(n).setZero();
        for (int i = 0; i < n; ++i) J(i, n + i) = S(1);
        J.bottomLeftCorner(n, n) = F_y;
        J.bottomRightCorner(n, n) = F_v;
    }

    /// diag(1, ..., 1, 0, ..., 0).
    Eigen::DiagonalMatrix<double, size> mass() const {
        Eigen::DiagonalMatrix<double, size> M(parts_.size());
        M.diagonal().setZero();
        M.diagonal().head(parts_.first()).setOnes();
        return M;
    }
    const std::vector<int>& index() const { return index_; }

    /// The break_points() of F, and F.domain(t, y), where there are some.
    auto jumps() const { return f_.break_points(); }
    template <class T, class S>
    bool within(const T& t, const state_vector<S>& x) const {
        return f_.domain(t, value<S>(x));
    }

    /// The state (y; y'), and its parts.
    template <class S>
    state_vector<S> state(const part_vector<S>& y, const part_vector<S>& derivative) const {
        if (y.size() != parts_.first() || derivative.size() != parts_.first())
            throw std::invalid_argument("fully_implicit: y and y' must have n components");
        state_vector<S> x(parts_.size());
        x.head(parts_.first()) = y;
        x.tail(parts_.first()) = derivative;
        return x;
    }
    template <class S>
    part_vector<S> value(const state_vector<S>& x) const {
        return x.head(parts_.first());
    }
    template <class S>
    part_vector<S> derivative(const state_vector<S>& x) const {
        return x.tail(parts_.first());
    }

  private:
    template <class T, class S, class Parts>
    void evaluate(const T& t, const state_vector<S>& x, Parts& parts, state_vector<S>& out) const {
        const int n = parts_.first();
        if (x.size() != 2 * n)
            throw std::invalid_argument("fully_implicit: the state must have 2 n components");
        parts.a = x.head(n);
        parts.b = x.tail(n);
        expect_written(parts.g);
        f_(t, parts.a, parts.b, parts.g);
        if (parts.g.size() != n)
            throw std::invalid_argument("fully_implicit: F must keep the size n of its output");
        out.head(n) = parts.b;
        out.tail(n) = parts.g;
    }

    F f_;
    detail::part_storage<sizes> parts_;
    std::vector<int> index_;
};

namespace detail {

inline std::vector<int> implicit_flags(int n, int index) {
    if (index < 0 || index > 2) throw std::invalid_argument("fully_implicit: index must be 0, 1 or 2");
    std::vector<int> flags(n < 0 ? 0 : 2 * n, index > 1 ? index : 1);
    for (int i = n; i < 2 * n; ++i) flags[i] = index + 1;
    return flags;
}

}  // namespace detail

/// F(t, y, y') = 0 with n components known at compile time.
///
/// F(t, y, v, out) writes the n equations, where v stands for y'; it may be a lambda. Its derivatives come
/// from a member F.jacobian(t, y, v, F_y, F_v) if there is one, from automatic differentiation if F is
/// generic in the scalar, else from finite differences.
///
/// `index` is the differentiation index of F(t, y, y') = 0 (Hairer-Wanner II.VII.1): 0 if F_{y'} is regular,
/// 1 or 2 for a differential-algebraic equation; other values throw std::invalid_argument. The components of
/// y are given the index flag max(index, 1), those of y' the flag index + 1, being one differentiation away.
template <int N, class F>
requires(N >= 0) auto fully_implicit(F f, int index = 0) {
    return fully_implicit_problem<N, F>(std::move(f), N, detail::implicit_flags(N, index));
}
/// The same with a flag for every component, those of y and then those of y'.
template <int N, class F>
requires(N >= 0) auto fully_implicit(F f, std::vector<int> index) {
    return fully_implicit_problem<N, F>(std::move(f), N, std::move(index));
}

/// The same with n known at run time; F then gets vectors of dynamic size.
template <class F>
auto fully_implicit(F f, int n, int index = 0) {
    return fully_implicit_problem<Eigen::Dynamic, F>(std::move(f), n, detail::implicit_flags(n, index));
}
template <class F>
auto fully_implicit(F f, int n, std::vector<int> index) {
    return fully_implicit_problem<Eigen::Dynamic, F>(std::move(f), n, std::move(index));
}

}  // namespace stagecraft
