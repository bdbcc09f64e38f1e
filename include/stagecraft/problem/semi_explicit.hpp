// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <utility>
#include <vector>

#include <stagecraft/break_points.hpp>
#include <stagecraft/problem/parts.hpp>
#include <stagecraft/refuse/detect/refused_call.hpp>
#include <stagecraft/refuse/problem/written_argument.hpp>

namespace stagecraft {

namespace detail {

template <class S, int N>
using column = Eigen::Matrix<S, N, 1>;

/// f(t, y, z, out)
template <class F, class T, class S, class Sizes>
concept differential_equations = callable_unconverted < const F,
        const T&, const column<S, Sizes::first>
&, const column<S, Sizes::second>&, column<S, Sizes::first>& > ;
/// g(t, y, out): the constraint of a problem of index 2
template <class G, class T, class S, class Sizes>
concept constraint_without_z =
    !reads_last<const G, column<S, Sizes::second>, T, column<S, Sizes::first>>() &&
    callable_unconverted<const G, const T&, const column<S, Sizes::first>&, column<S, Sizes::second>&>;
/// g(t, y, z, out): that of a problem of index 1
template <class G, class T, class S, class Sizes>
concept constraint_with_z = callable_unconverted < const G,
        const T&, const column<S, Sizes::first>
&, const column<S, Sizes::second>&, column<S, Sizes::second>& > ;
/// What f and g write arrives.
template <class F, class Sizes, class A = column<double, Sizes::first>,
          class B = column<double, Sizes::second>>
concept differential_equations_arrive =
    !differential_equations<F, double, double, Sizes> || writes_into<const F, A, double, A, B>;
template <class G, class Sizes, class A = column<double, Sizes::first>,
          class B = column<double, Sizes::second>>
concept constraint_equations_arrive =
    (!constraint_with_z<G, double, double, Sizes> ||
     writes_into<const G, B, double, A, B>)&&(!constraint_without_z<G, double, double, Sizes> ||
                                              writes_into<const G, B, double, A>);
template <class G, class T, class S, class Sizes>
concept constraint_equations = constraint_without_z<G, T, S, Sizes> || constraint_with_z<G, T, S, Sizes>;

/// f.jacobian(t, y, z, f_y, f_z)
template <class F, class S, class Sizes>
concept differential_jacobian = requires(const F& f, const S& t, const column<S, Sizes::first>& y,
                                         const column<S, Sizes::second>& z,
                                         Eigen::Matrix<S, Sizes::first, Sizes::first>& f_y,
                                         Eigen::Matrix<S, Sizes::first, Sizes::second>& f_z) {
    f.jacobian(t, y, z, f_y, f_z);
};
/// g.jacobian(t, y, g_y) or g.jacobian(t, y, z, g_y, g_z)
template <class G, class S, class Sizes>
concept constraint_jacobian_without_z = requires(const G& g, const S& t, const column<S, Sizes::first>& y,
                                                 Eigen::Matrix<S, Sizes::second, Sizes::first>& g_y) {
    g.jacobian(t, y, g_y);
};
template <class G, class S, class Sizes>
concept constraint_jacobian_with_z = requires(const G& g, const S& t, const column<S, Sizes::first>& y,
                                              const column<S, Sizes::second>& z,
                                              Eigen::Matrix<S, Sizes::second, Sizes::first>& g_y,
                                              Eigen::Matrix<S, Sizes::second, Sizes::second>& g_z) {
    g.jacobian(t, y, z, g_y, g_z);
};
template <class G, class S, class Sizes>
concept constraint_jacobian =
    constraint_jacobian_without_z<G, S, Sizes> || constraint_jacobian_with_z<G, S, Sizes>;

/// f.domain(t, y, z)
template <class F, class Sizes>
concept domain_of_parts = requires(const F& f, const double& t, const column<double, Sizes::first>& y,
                                   const column<double, Sizes::second>& z) {
    f.domain(t, y, z);
};

}  // namespace detail

/// The semi-explicit (Hessenberg) system
///
///     y' = f(t, y, z),   0 = g(t, y, z)   index 1 where g_z is regular, or
///     y' = f(t, y, z),   0 = g(t, y)      index 2 where g_y f_z is regular
///
/// (Hairer-Wanner II.VI.1 and II.VII.1; HLR89, section 1) in the state (y; z) with M = diag(I, 0), ready for
/// `integrate`. Whether g takes z decides the index, and with it the index flags of z. Made by
/// `semi_explicit`. Sizes is a part_sizes<n, m>.
template <class Sizes, class F, class G>
class semi_explicit_problem
    : public detail::optional_jacobian<semi_explicit_problem<Sizes, F, G>,
                                       detail::differential_jacobian<F, double, Sizes> ||
                                           detail::constraint_jacobian<G, double, Sizes>>,
      public detail::optional_domain<semi_explicit_problem<Sizes, F, G>, detail::domain_of_parts<F, Sizes>>,
      public detail::optional_break_points<semi_explicit_problem<Sizes, F, G>,
                                           has_break_points<const F> || has_break_points<const G>> {
    static constexpr bool sees_z = detail::constraint_with_z<G, double, double, Sizes>;
    static constexpr bool f_fits = detail::differential_equations<F, double, double, Sizes>,
                          g_fits = detail::constraint_equations<G, double, double, Sizes>;
    static_assert(f_fits, "semi_explicit: f must be callable as f(t, y, z, out)");
    static_assert(g_fits, "semi_explicit: g must be callable as g(t, y, out) or g(t, y, z, out)");
    static_assert(
        detail::differential_equations_arrive<F, Sizes>,
        "semi_explicit: f takes out by value, or const, and what it writes is lost: write `Vector& out` "
        "or `auto& out`");
    static_assert(
        detail::constraint_equations_arrive<G, Sizes>,
        "semi_explicit: g takes out by value, or const, and what it writes is lost: write `Vector& out` "
        "or `auto& out`");
    static_assert(!(sees_z && detail::constraint_without_z<G, double, double, Sizes>),
                  "semi_explicit: g must be callable in one of its two forms, not in both");

    static_assert(!detail::has_member_named<F, detail::jacobian_member> ||
                      detail::differential_jacobian<F, double, Sizes>,
                  "semi_explicit: f.jacobian must be callable as f.jacobian(t, y, z, f_y, f_z) on a const f");
    static_assert(!detail::has_member_named<G, detail::jacobian_member> ||
                      detail::constraint_jacobian<G, double, Sizes>,
                  "semi_explicit: g.jacobian must be callable as g.jacobian(t, y, g_y), or "
                  "g.jacobian(t, y, z, g_y, g_z) where g sees z, on a const g");

    template <class T, class S>
    static constexpr bool callable =
        detail::differential_equations<F, T, S, Sizes>&& detail::constraint_equations<G, T, S, Sizes>;
    static constexpr bool analytic_f = detail::differential_jacobian<F, double, Sizes>;
    static constexpr bool analytic_g = detail::constraint_jacobian<G, double, Sizes>;

  public:
    static constexpr int size = Sizes::size;
    /// The differentiation index, if the block named above is regular.
    static constexpr int index_of_z = sees_z ? 1 : 2;
    template <class S>
    using state_vector = Eigen::Matrix<S, size, 1>;

    semi_explicit_problem(F f, G g, int n, int m)
        : f_(std::move(f)), g_(std::move(g)), parts_(n, m, "semi_explicit") {}

    /// (f; g) at x = (y; z). Run-time sizes: a const problem allocates, another one does not.
    template <class T, class S>
    requires(callable<T, S>) void operator()(const T& t, const state_vector<S>& x, state_vector<S>& out) {
        auto&& parts = parts_.template get<S>();
        evaluate(t, x, parts, out);
    }
    template <class T, class S>
    requires(callable<T, S>) void operator()(const T& t, const state_vector<S>& x,
                                             state_vector<S>& out) const {
        auto parts = parts_.template get<S>();
        evaluate(t, x, parts, out);
    }

    /// The derivative of (f; g), as jacobian(t, x, J) where f or g brings its own: f.jacobian(t, y, z, f_y,
    /// f_z), g.jacobian(t, y, g_y) or g.jacobian(t, y, z, g_y, g_z), into blocks that arrive zero. The other
    /// one is differentiated automatically and must be generic.
    template <class S, class Matrix>
    void write_jacobian(const S& t, const state_vector<S>& x, Matrix& J) const {
        const int n = parts_.first(), m = parts_.second();
        using number = dual<S, size>;
        const Eigen::Matrix<S, Sizes::first, 1> y = x.head(n);
        const Eigen::Matrix<S, Sizes::second, 1> z = x.tail(m);
        if constexpr (analytic_f) {
            Eigen::Matrix<S, Sizes::first, Sizes::first> f_y(n, n);
            Eigen::Matrix<S, Sizes::first, Sizes::second> f_z(n, m);
            f_y.setZero();
            f_z.setZero();
            f_.jacobian(t, y, z, f_y, f_z);
            J.topLeftCorner(n, n) = f_y;
            J.topRightCorner(n, m) = f_z;
        } else {
            static_assert(detail::differential_equations<F, S, number, Sizes> ||
                              detail::differential_equations<F, number, number, Sizes>,
                          "semi_explicit: g brings a Jacobian; f must bring one as well or be generic");
            const auto call = [&](const auto& a, const auto& b) {
                Eigen::Matrix<number, Sizes::first, 1> out(n);
                if constexpr (detail::differential_equations<F, number, number, Sizes>)
                    f_(detail::constant_dual<number>(t), a, b, out);
                else
                    f_(t, a, b, out);
                return out;
            };
            detail::differentiate_parts<Sizes, S>(n, m, x, n, call, J.topRows(n));
        }
        auto bottom = J.bottomRows(m);
        if constexpr (analytic_g) {
            Eigen::Matrix<S, Sizes::second, Sizes::first> g_y(m, n);
            Eigen::Matrix<S, Sizes::second, Sizes::second> g_z(m, m);
            g_y.setZero();
            g_z.setZero();
            if constexpr (sees_z)
                g_.jacobian(t, y, z, g_y, g_z);
            else
                g_.jacobian(t, y, g_y);
            bottom.leftCols(n) = g_y;
            bottom.rightCols(m) = g_z;
        } else {
            static_assert(detail::constraint_equations<G, S, number, Sizes> ||
                              detail::constraint_equations<G, number, number, Sizes>,
                          "semi_explicit: f brings a Jacobian; g must bring one as well or be generic");
            const auto call = [&](const auto& a, const auto& b) {
                Eigen::Matrix<number, Sizes::second, 1> out(m);
                if constexpr (detail::constraint_equations<G, number, number, Sizes>)
                    constraint(detail::constant_dual<number>(t), a, b, out);
                else
                    constraint(t, a, b, out);
                return out;
            };
            detail::differentiate_parts<Sizes, S>(n, m, x, m, call, bottom);
        }
    }

    /// diag(1, ..., 1, 0, ..., 0).
    Eigen::DiagonalMatrix<double, size> mass() const {
        Eigen::DiagonalMatrix<double, size> M(parts_.size());
        M.diagonal().setZero();
        M.diagonal().head(parts_.first()).setOnes();
        return M;
    }
    /// 1 for y, 1 or 2 for z.
    std::vector<int> index() const {
        std::vector<int> flags(parts_.size(), 1);
        for (int i = parts_.first(); i < parts_.size(); ++i) flags[i] = index_of_z;
        return flags;
    }

    /// The break_points() of f and of g, and f.domain(t, y, z), where there are some.
    break_times<double> jumps() const {
        break_times<double> all;
        if constexpr (has_break_points<const F>) all.add(break_times<double>(f_.break_points()));
        if constexpr (has_break_points<const G>) all.add(break_times<double>(g_.break_points()));
        return all;
    }
    template <class T, class S>
    bool within(const T& t, const state_vector<S>& x) const {
        return f_.domain(t, differential<S>(x), algebraic<S>(x));
    }

    /// The state (y; z), and its parts.
    template <class S>
    state_vector<S> state(const Eigen::Matrix<S, Sizes::first, 1>& y,
                          const Eigen::Matrix<S, Sizes::second, 1>& z) const {
        if (y.size() != parts_.first() || z.size() != parts_.second())
            throw std::invalid_argument("semi_explicit: y and z must have n and m components");
        state_vector<S> x(parts_.size());
        x.head(parts_.first()) = y;
        x.tail(parts_.second()) = z;
        return x;
    }
    template <class S>
    Eigen::Matrix<S, Sizes::first, 1> differential(const state_vector<S>& x) const {
        return x.head(parts_.first());
    }
    template <class S>
    Eigen::Matrix<S, Sizes::second, 1> algebraic(const state_vector<S>& x) const {
        return x.tail(parts_.second());
    }

  private:
    template <class T, class A, class B, class Out>
    void constraint(const T& t, const A& y, const B& z, Out& out) const {
        if constexpr (sees_z)
            g_(t, y, z, out);
        else
            g_(t, y, out);
    }
    template <class T, class S, class Parts>
    void evaluate(const T& t, const state_vector<S>& x, Parts& parts, state_vector<S>& out) const {
        const int n = parts_.first(), m = parts_.second();
        if (x.size() != n + m)
            throw std::invalid_argument("semi_explicit: the state must have n + m components");
        parts.a = x.head(n);
        parts.b = x.tail(m);
        expect_written(parts.f);
        expect_written(parts.g);
        f_(t, parts.a, parts.b, parts.f);
        constraint(t, parts.a, parts.b, parts.g);
        if (parts.f.size() != n || parts.g.size() != m)
            throw std::invalid_argument("semi_explicit: f and g must keep the sizes n and m of their output");
        out.head(n) = parts.f;
        out.tail(m) = parts.g;
    }

    F f_;
    G g_;
    detail::part_storage<Sizes> parts_;
};

/// y' = f(t, y, z), 0 = g(t, y, z) or 0 = g(t, y), with n components y and m components z known at compile
/// time.
///
/// f(t, y, z, out) writes y' into out; g(t, y, z, out) or g(t, y, out) writes the m equations. Either may be
/// a lambda. Their derivatives come from members jacobian(...) where there are some (see jacobian() above),
/// from automatic differentiation if both are generic in the scalar, else from finite differences.
template <int N, int M, class F, class G>
requires(N >= 0 && M >= 0) auto semi_explicit(F f, G g) {
    return semi_explicit_problem<part_sizes<N, M>, F, G>(std::move(f), std::move(g), N, M);
}

/// The same with n and m known at run time; the callables then get vectors of dynamic size.
template <class F, class G>
auto semi_explicit(F f, G g, int n, int m) {
    return semi_explicit_problem<part_sizes<Eigen::Dynamic, Eigen::Dynamic>, F, G>(std::move(f), std::move(g),
                                                                                   n, m);
}

namespace detail {
/// Stands in for a problem without its sizes, so that the one sentence that says so is all.
struct refused_semi_explicit {
    void operator()(const auto&, const auto&, auto&) const {}
    template <class = double>
    Eigen::Vector2d state(const auto&...) const {
        return {0, 0};
    }
    template <class = double>
    Eigen::VectorXd differential(const auto&) const {
        return {};
    }
    template <class = double>
    Eigen::VectorXd algebraic(const auto&) const {
        return {};
    }
};
}  // namespace detail

/// The sizes are missing, or stand elsewhere.
template <int... Sizes, class F>
detail::refused_semi_explicit semi_explicit(const F&, detail::anything = 0, detail::anything = 0,
                                            detail::anything = 0, detail::anything = 0) {
    static_assert(detail::never<F>,
                  "semi_explicit<n, m>(f, g): give n, the number of components of y, and m, that of z, in "
                  "angle brackets, or behind the functions where they are known at run time: "
                  "semi_explicit(f, g, n, m)");
    return {};
}

}  // namespace stagecraft
