// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include <stagecraft/break_points.hpp>
#include <stagecraft/dense_output.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/jacobian/central_differences.hpp>
#include <stagecraft/jacobian/unconverted.hpp>
#include <stagecraft/observe/observers.hpp>
#include <stagecraft/owned_value.hpp>
#include <stagecraft/problem/capabilities.hpp>
#include <stagecraft/problem/parts.hpp>

namespace stagecraft {

/// The problem q(y)' = f(t, y); made by with_charge(). See there.
template <class Charge, class Rhs>
struct charge_form {
    Charge q;
    Rhs f;
};

/// The problem q(y)' = f(t, y) for integrate(): circuits whose capacitances depend on their voltages, q the charges; and
/// whatever else is a balance of something that is a function of y:
///
///     integrate(radau_iia<3>(), with_charge([](const auto& v, auto& q) { q[0] = v[0] + v[0] * v[0] * v[0] / 3; },
///                                           [](double, const auto& v, auto& i) { i[0] = -v[0]; }), v0, 0, 1)
///
/// y0, result.y and what observers see are y. Inside, the charges are unknowns too, q' = f(t, y), 0 = q - q(y): the method
/// adds up f, so that a sum of charges of which f sums to zero does not drift: it is kept to rounding inside, and of q(y) within
/// what Newton's iteration leaves of a step, a part of the tolerance. A mass(t, y), where y' is the unknown, does not do that. The
/// tolerances are those of y. Matrices are 2 n x 2 n; the steps are about those of dq/dy y' = f.
///
/// A component of q that is a constant, written without y, of a node without capacitance, makes its row 0 = f_i(t, y), an
/// algebraic equation of index 1. The other rows of dq/dy and these together determine y: std::invalid_argument at the start
/// where rows of dq/dy depend on each other, as those of both ends of a floating capacitor do (charge and current of one branch
/// would be of index 2: take the branch's charge as a component of y).
///
/// q        q(y, q) writes the charges, n of them, or q(y) returns them. f as for integrate(), with break_points() and
///          domain(t, y) where it has them. Generic in their scalars both are
///          differentiated automatically, else by differences.
/// method   As for integrate(), of those that solve index 1: implicit ones.
/// Observers with save() (checkpoints) do not compile: one is of the charges as well.
template <class Charge, class Rhs>
charge_form<Charge, Rhs> with_charge(Charge q, Rhs f) {
    return {std::move(q), std::move(f)};
}

namespace detail {

/// out := call(in...), which writes it or returns it.
template <class Call, class Out, class... In>
void written_or_returned(const Call& call, Out& out, const In&... in) {
    if constexpr (callable_unconverted<const Call, const In&..., Out&>)
        call(in..., out);
    else
        out = of_size(call(in...), out.size());
}
template <class Call, class Out, class... In>
concept writes_or_returns = callable_unconverted<const Call, const In&..., Out&> ||
    (callable_unconverted<const Call, const In&...>&& requires(const Call& call, const In&... in) {
        { call(in...) } -> owns_numbers;
        requires std::is_convertible_v<decltype(call(in...)), Out>;
    });

/// q' = f(t, y), 0 = q - q(y) in x = (q; y); where q is constant q' is left out.
template <class Charge, class Rhs, class Vector>
class charge_equations
    : public optional_domain<charge_equations<Charge, Rhs, Vector>, has_domain<const Rhs, Vector>>,
      public optional_break_points<charge_equations<Charge, Rhs, Vector>, has_break_points<const Rhs>> {
    static constexpr int N = Vector::RowsAtCompileTime, both = N < 0 ? N : 2 * N;
    template <class S>
    using part = Eigen::Matrix<S, N, 1>;
    template <class T, class S>
    static constexpr bool usable =
        writes_or_returns<Charge, part<S>, part<S>>&& writes_or_returns<Rhs, part<S>, T, part<S>>;

  public:
    using scalar = typename Vector::Scalar;
    using state = Eigen::Matrix<scalar, both, 1>;

    charge_equations(const Charge& q, const Rhs& f, const Vector& y0)
        : q_(q), f_(f), charged_(Vector::Ones(y0.size())) {
        find_uncharged(y0);
        demand_independent(y0);
    }

    template <class T, class S>
    requires(usable<T, S>) void operator()(const T& t, const Eigen::Matrix<S, both, 1>& x,
                                           Eigen::Matrix<S, both, 1>& out) const {
        const Eigen::Index n = charged_.size();
        const part<S> y = x.tail(n);
        part<S> values(n);
        written_or_returned(f_, values, t, y);
        out.head(n) = of_size(values, n);
        written_or_returned(q_, values, y);
        out.tail(n) = x.head(n) - of_size(values, n);
    }
    Eigen::DiagonalMatrix<scalar, both> mass() const {
        Eigen::DiagonalMatrix<scalar, both> M(2 * charged_.size());
        M.diagonal() << charged_, Vector::Zero(charged_.size());
        return M;
    }

    auto jumps() const { return f_.break_points(); }
    bool within(const scalar& t, const state& x) const { return f_.domain(t, value(x)); }

    state of(const Vector& y) const {
        state x(2 * y.size());
        x << charge(y), y;
        return x;
    }
    Vector value(const state& x) const { return x.tail(charged_.size()); }
    /// Tolerances: a charge is as exact as its y, of the size that they have at the start.
    options<scalar> tolerances(options<scalar> o, const Vector& y0) const {
        const Eigen::Index n = y0.size();
        validate(o, n);
        numbers_of_components<scalar> atol(2 * n);
        const auto C = capacitances(y0);
        for (Eigen::Index i = 0; i < n; ++i) {
            atol[n + i] = absolute_tolerance(o, i);
            atol[i] = scalar(0);
        }
        for (Eigen::Index i = 0; i < n; ++i)
            for (Eigen::Index j = 0; j < n; ++j) {
                using std::abs;
                atol[i] += abs(C(i, j)) * (atol[n + j] + o.rtol * abs(y0[j]));
            }
        for (Eigen::Index i = 0; i < n; ++i)
            if (!(atol[i] > scalar(0))) atol[i] = atol[n + i];
        o.atol_components = atol;
        return o;
    }

  private:
    using square = Eigen::Matrix<scalar, N, N>;
    Vector charge(const Vector& y) const {
        Vector q(y.size());
        written_or_returned(q_, q, y);
        return of_size(q, y.size());
    }
    square capacitances(const Vector& y) const {
        using std::cbrt;
        square C(y.size(), y.size());
        Vector moved = y;
        central_differences(
            y, moved, [&](const Vector& x) { return charge(x); },
            scalar(cbrt(std::numeric_limits<scalar>::epsilon())), C);
        return C;
    }
    /// A charge that stays as it is where all y are NaN, and others, is none.
    void find_uncharged(const Vector& y0) {
        const Vector at = charge(y0);
        const auto look = [&](const Vector& y) {
            const Vector other = charge(y);
            for (Eigen::Index i = 0; i < at.size(); ++i)
                if (other[i] == at[i]) same_[i] += scalar(1);
        };
        same_ = Vector::Zero(at.size());
        const Vector size = y0.cwiseAbs().array() + scalar(1);
        look(Vector::Constant(at.size(), std::numeric_limits<scalar>::quiet_NaN()));
        look(y0 + size);
        look(y0 - size);
        for (Eigen::Index i = 0; i < at.size(); ++i)
            if (same_[i] == scalar(3)) charged_[i] = scalar(0);
    }
    void demand_independent(const Vector& y0) const {
        square C = capacitances(y0);
        if (!C.allFinite()) throw bad_problem("with_charge: q must be finite about y0");
        for (Eigen::Index i = 0; i < C.rows(); ++i) {
            const scalar largest = C.row(i).cwiseAbs().maxCoeff();
            if (charged_[i] != scalar(0) && !(largest > scalar(0)))
                throw bad_problem("with_charge: component " + std::to_string(i) +
                                  " of q is written with y but does not change with it at y0: where there is "
                                  "no capacitance write q as a constant, without y");
            if (charged_[i] != scalar(0)) C.row(i) /= largest;
            if (charged_[i] == scalar(0)) C.row(i).setZero();
        }
        Eigen::FullPivLU<square> lu(C);
        lu.setThreshold(scalar(1) / 1000000);
        const auto wanted = static_cast<Eigen::Index>((charged_.array() != scalar(0)).count());
        if (lu.rank() < wanted)
            throw bad_problem("with_charge: the charges depend on each other at y0, dq/dy has rank " +
                              std::to_string(lu.rank()) + " of " + std::to_string(wanted) +
                              ": take the charges of branches as unknowns, semi_explicit() of "
                              "problem/semi_explicit.hpp");
    }

    const Charge& q_;
    const Rhs& f_;
    Vector charged_, same_;
};

template <class List, bool Exists>
struct charge_break_points {};
template <class List>
struct charge_break_points<List, true> {
    auto break_points() const { return static_cast<const List&>(*this).inner().break_points(); }
};

/// An observer of y in a run of (q; y).
template <class Observer, class Equations, class Vector>
class charge_observer
    : public optional_correction<charge_observer<Observer, Equations, Vector>,
                                 one_may_have<correct_member, Observer>>,
      public optional_change<charge_observer<Observer, Equations, Vector>,
                             one_may_have<change_member, Observer>>,
      public charge_break_points<charge_observer<Observer, Equations, Vector>, has_break_points<Observer>> {
    using scalar = typename Vector::Scalar;
    using state = typename Equations::state;

  public:
    charge_observer(Observer& observer, const Equations& equations)
        : observer_(observer), equations_(equations) {}
    const Observer& inner() const { return observer_; }

    void start(const scalar& t0, const state& x0, const scalar& t1) {
        announce(observer_, t0, equations_.value(x0), t1);
    }
    template <class Output>
    bool operator()(const scalar& t, const state& x, const scalar& h, const Output& output) {
        return tell_until(end_inside(t, x, h, output), *this, t, x, h, output);
    }
    template <class Output>
    const occurrence<state>* end_inside(const scalar& t, const state& x, const scalar& h,
                                        const Output& output) {
        const occurrence<Vector>* end =
            detail::end_inside(observer_, t, equations_.value(x), h, narrow(output));
        if (!end) return nullptr;
        end_ = {end->event, end->t, equations_.of(end->y), end->direction};
        return &end_;
    }
    template <class Output>
    bool tell(const scalar& t, const state& x, const scalar& h, const Output& output) {
        return detail::tell(observer_, t, equations_.value(x), h, narrow(output));
    }
    bool correct_all(const scalar& t, state& x) {
        return replaced(x, [&](Vector& y) { return correct_state(observer_, t, y); });
    }
    bool change_all(const scalar& t, state& x) {
        return replaced(x, [&](Vector& y) { return change_state(observer_, t, y); });
    }
    void changed(const scalar& t, const state& x) { tell_change(observer_, t, equations_.value(x)); }
    bool ends_at_start() const { return detail::ends_at_start(observer_); }
    void conclude(result<state>& r) {
        result<Vector> own{r.t, equations_.value(r.y), r.status, r.report, r.exception};
        detail::conclude(observer_, own);
        if (own.y != equations_.value(r.y)) r.y = equations_.of(own.y);
        r.t = own.t;
        r.status = own.status;
        r.exception = own.exception;
    }

  private:
    template <int Stages>
    static dense_output<Vector, Stages> narrow(const dense_output<state, Stages>& wide) {
        const Eigen::Index n = wide.y0().size() / 2;
        dense_output<Vector, Stages> y(static_cast<int>(n), static_cast<int>(wide.increments().cols()));
        y.increments() = wide.increments().bottomRows(n);
        y.cover(wide.nodes(), wide.t0(), wide.step(), Vector(wide.y0().tail(n)));
        return y;
    }
    template <class Change>
    bool replaced(state& x, const Change& change) {
        Vector y = equations_.value(x);
        if (!change(y)) return false;
        x = equations_.of(y);
        return true;
    }

    Observer& observer_;
    const Equations& equations_;
    occurrence<state> end_{};
};
template <class Observer, class Equations, class State, class Vector, class Output>
inline constexpr bool looks_between<charge_observer<Observer, Equations, State>, Vector, Output> = true;

}  // namespace detail

/// Integrates q(y)' = f(t, y), y(t0) = y0; see with_charge().
template <class Method, class Charge, class Rhs, class Derived, class Observer = no_observer>
auto integrate(const Method& method, charge_form<Charge, Rhs> problem, const Eigen::MatrixBase<Derived>& y0,
               std::type_identity_t<typename Derived::Scalar> t0,
               std::type_identity_t<typename Derived::Scalar> t1,
               const options<typename Derived::Scalar>& o = {}, Observer&& observer = {})
    -> result<typename Derived::PlainObject> {
    using vector = typename Derived::PlainObject;
    using scalar = typename vector::Scalar;
    using observer_type = std::remove_reference_t<Observer>;
    constexpr bool charge = detail::writes_or_returns<Charge, vector, vector>;
    static_assert(charge,
                  "with_charge(q, f): q must be callable as q(y, out), out by reference, or return the "
                  "charges, a vector of the type of y0 and no expression of Eigen's");
    constexpr bool rhs = detail::writes_or_returns<Rhs, vector, scalar, vector>;
    static_assert(
        rhs,
        "with_charge(q, f): f must be callable as f(t, y, out), out by reference, or return a vector "
        "of the type of y0 and no expression of Eigen's");
    constexpr bool saves = detail::has_member_named<observer_type, detail::save_member>;
    static_assert(!saves, "with_charge: no checkpoints are taken of a run with charges");
    if constexpr (charge && rhs && !saves) {
        using equations_type = detail::charge_equations<Charge, Rhs, vector>;
        const vector start = y0;
        validate_interval(start, t0, t1);
        const equations_type equations(problem.q, problem.f, start);
        const auto run = [&](auto&& watch) {
            return integrate(method, equations, equations.of(start), t0, t1, equations.tolerances(o, start),
                             watch);
        };
        auto r = [&] {
            if constexpr (std::is_same_v<std::remove_const_t<observer_type>, no_observer>)
                return run(no_observer());
            else
                return run(
                    detail::charge_observer<observer_type, equations_type, vector>(observer, equations));
        }();
        return {r.t, equations.value(r.y), r.status, r.report, r.exception};
    } else {
        return {};
    }
}

}  // namespace stagecraft
