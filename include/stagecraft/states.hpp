// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <complex>
#include <concepts>
#include <type_traits>
#include <vector>

#include <stagecraft/integrate.hpp>
#include <stagecraft/owned_value.hpp>

namespace stagecraft {

namespace detail {

/// What a state may be besides a real column vector of Eigen's: its elements, how many there are at compile
/// time (-1: known at run time), the same with another real scalar. Empty for everything else.
template <class State>
struct state_form {};
template <class Element, int Count>
struct state_of_elements {
    using element = Element;
    static constexpr int count = Count;
};
template <std::floating_point T>
struct state_form<T> : state_of_elements<T, 1> {
    template <class S>
    using of = S;
};
template <std::floating_point T>
struct state_form<std::complex<T>> : state_of_elements<std::complex<T>, 1> {};
template <class T, std::size_t N>
struct state_form<std::array<T, N>> : state_of_elements<T, static_cast<int>(N)> {
    template <class S>
    using of = std::array<S, N>;
};
template <class T>
struct state_form<std::vector<T>> : state_of_elements<T, Eigen::Dynamic> {
    template <class S>
    using of = std::vector<S>;
};
template <class T, int N>
struct state_form<Eigen::Matrix<std::complex<T>, N, 1>> : state_of_elements<std::complex<T>, N> {};

template <class T>
struct real_part_of {
    using type = T;
    static constexpr int parts = 1;
};
template <class T>
struct real_part_of<std::complex<T>> {
    using type = T;
    static constexpr int parts = 2;
};

template <class State>
concept split_state = std::floating_point<typename real_part_of<typename state_form<State>::element>::type>;

/// The scalar of a state of any kind, and the vector that it is integrated as: complex elements are pairs of real
/// components, real part first.
template <class State>
struct state_parts {};
template <class State>
requires(!split_state<State> && requires { typename State::Scalar; }) struct state_parts<State> {
    using scalar = typename State::Scalar;
};
template <split_state State>
struct state_parts<State> {
    using form = state_form<State>;
    using element = typename form::element;
    using scalar = typename real_part_of<element>::type;
    static constexpr int parts = real_part_of<element>::parts, count = form::count;
    static constexpr bool complex = parts == 2;
    using vector = Eigen::Matrix < scalar, count<0 ? Eigen::Dynamic : count * parts, 1>;
};
template <split_state State>
inline constexpr bool has_own_overload<State> = true;
template <class State>
using scalar_of = typename state_parts<State>::scalar;

/// Copies the elements of a state, given as numbers one after the other, into it, and back. The state has its size.
template <class State, class Vector>
void put_into(State& y, const Vector& v) {
    using S = typename Vector::Scalar;
    if constexpr (std::is_same_v<State, S>)
        y = v[0];
    else if constexpr (requires { y.data(); })
        std::copy(v.data(), v.data() + v.size(), reinterpret_cast<S*>(y.data()));
    else
        y = State(v[0], v[1]);
}
template <class State, class Vector>
void take_out_of(const State& y, Vector& v) {
    using S = typename Vector::Scalar;
    if constexpr (std::is_same_v<State, S>) {
        v[0] = y;
    } else if constexpr (requires { y.data(); }) {
        const S* from = reinterpret_cast<const S*>(y.data());
        std::copy(from, from + v.size(), v.data());
    } else {
        v[0] = y.real();
        v[1] = y.imag();
    }
}
/// The State with elements in another scalar, where these are real.
template <class State, class S>
struct state_in {};
template <class State, class S>
requires(std::is_same_v<S, scalar_of<State>>) struct state_in<State, S> {
    using type = State;
};
template <class State, class S>
requires(!std::is_same_v<S, scalar_of<State>> && !state_parts<State>::complex) struct state_in<State, S> {
    using type = typename state_form<State>::template of<S>;
};
template <class State>
Eigen::Index elements_of(const State& y) {
    if constexpr (requires { y.size(); })
        return static_cast<Eigen::Index>(y.size());
    else
        return 1;
}

/// A right-hand side of a State as one of vectors. Real states: with all that the problem brings besides.
template <class Problem>
struct split_base : Problem {
    explicit split_base(const Problem& p) : Problem(p) {}
    const Problem& problem() const { return *this; }
};
template <class Problem>
requires(!std::is_class_v<Problem> || std::is_final_v<Problem>) struct split_base<Problem> {
    Problem p;
    explicit split_base(const Problem& q) : p(q) {}
    const Problem& problem() const { return p; }
};

template <class Problem, class T, class Y>
concept writes_state = requires(const Problem& p, const T& t, const Y& y, Y& f) {
    p(t, y, f);
};
template <class Problem, class T, class Y>
concept returns_state = requires(const Problem& p, const T& t, const Y& y) {
    { p(t, y) } -> std::convertible_to<Y>;
};
/// What a problem of a State writes is lost: it takes f by value, or const.
template <class Problem, class State>
constexpr bool loses_state() {
    using last = typename decltype(output_parameter<std::remove_cv_t<Problem>>())::type;
    if constexpr (!writes_state<Problem, scalar_of<State>, State>)
        return false;
    else if constexpr (std::is_same_v<std::remove_cv_t<last>, State> || std::is_same_v<last, const State&>)
        return true;
    else if constexpr (std::is_class_v<State>)
        return takes_copy<const Problem, State, scalar_of<State>, State>;
    else
        return false;
}
/// Where the value is returned, it is an object, not an expression of Eigen's.
template <class Problem, class T, class Y>
constexpr bool returns_owned_state() {
    if constexpr (!writes_state<Problem, T, Y> && returns_state<Problem, T, Y>)
        return owns_numbers<std::invoke_result_t<const Problem&, const T&, const Y&>>;
    else
        return true;
}
template <class Problem, class T, class Y>
concept gives_state = writes_state<Problem, T, Y> || returns_state<Problem, T, Y>;

template <class Problem, class State>
class split_problem : public split_base<Problem> {
    using form = state_parts<State>;
    using scalar = typename form::scalar;

  public:
    split_problem(const Problem& p, const State& y0) : split_base<Problem>(p), y_(y0), f_(y0) {}

    template <class T, class Y, class F>
    requires gives_state<Problem, T, typename state_in<State, typename F::Scalar>::type>
    void operator()(const T& t, const Y& y, F& f) const {
        using state = typename state_in<State, typename F::Scalar>::type;
        if constexpr (std::is_same_v<state, State>) {
            call(t, y, f, y_, f_);
        } else {
            state at{}, value{};
            if constexpr (requires { at.resize(1); }) at.resize(elements_of(y)), value.resize(elements_of(y));
            call(t, y, f, at, value);
        }
    }

  protected:
    template <class T, class Y, class F, class S>
    void call(const T& t, const Y& y, F& f, S& at, S& value) const {
        put_into(at, y);
        if constexpr (writes_state<Problem, T, S>) {
            put_into(value, f);
            this->problem()(t, std::as_const(at), value);
        } else {
            value = this->problem()(t, std::as_const(at));
        }
        if (elements_of(value) != elements_of(at)) throw size_change{};
        take_out_of(value, f);
    }
    mutable State y_, f_;  // one run calls it, so that nothing is allocated
};

/// With the problem's Jacobian: that of real states in the form that the problem would write for vectors; of complex
/// ones the complex one of an f that is differentiable in y as a complex function (J n x n, or a number for one).
template <class Problem, class State>
struct split_problem_with_jacobian : split_problem<Problem, State> {
    using split_problem<Problem, State>::split_problem;
    template <class T, class Y, class J>
    void jacobian(const T& t, const Y& y, J& out) const {
        using parts = state_parts<State>;
        put_into(this->y_, y);
        const State& at = this->y_;
        if constexpr (parts::complex) {
            using number = typename parts::element;
            const Eigen::Index n = elements_of(at);
            Eigen::Matrix<number, parts::count, parts::count> K(n, n);
            K.setZero();
            fill(t, at, K);
            for (Eigen::Index j = 0; j < n; ++j)
                for (Eigen::Index i = 0; i < n; ++i) {
                    out(2 * i, 2 * j) = out(2 * i + 1, 2 * j + 1) = K(i, j).real();
                    out(2 * i + 1, 2 * j) = K(i, j).imag();
                    out(2 * i, 2 * j + 1) = -K(i, j).imag();
                }
        } else {
            fill(t, at, out);
        }
    }

  private:
    template <class T, class K>
    void fill(const T& t, const State& at, K& out) const {
        if constexpr (requires { this->problem().jacobian(t, at, out); }) {
            this->problem().jacobian(t, at, out);
        } else {
            static_assert(
                requires { this->problem().jacobian(t, at, out(0, 0)); },
                "integrate: problem.jacobian must be a member function `void jacobian(double t, const State& "
                "y, "
                "Matrix& J) const`, State the type of y0, Matrix an Eigen matrix of its elements, n x n");
            this->problem().jacobian(t, at, out(0, 0));
        }
    }
};

/// The Problem with states of the type State as one of vectors.
template <class Problem, class State>
auto in_vectors(const Problem& problem, const State& y0) {
    using form = state_parts<State>;
    static_assert(!form::complex || !(has_mass<const Problem> || has_index<const Problem> ||
                                      has_bandwidth<const Problem> || has_sparsity<const Problem> ||
                                      has_linear_solver<Problem> || has_second_order_components<Problem>),
                  "integrate: of a problem with a complex state only jacobian() and constant_jacobian() are "
                  "used: split "
                  "it into real and imaginary parts by hand");
    if constexpr (in_parts<Problem>)
        return problem.with_each([&](const auto& part) { return in_vectors(part, y0); });
    else if constexpr (has_member_named<Problem, jacobian_member>)
        return split_problem_with_jacobian<Problem, State>(problem, y0);
    else
        return split_problem<Problem, State>(problem, y0);
}

/// A callable observer(t, y), (t, y, h) or (t, y, h, output) that takes the State, as one that takes vectors.
template <class Observer, class State>
class split_observer {
    using scalar = scalar_of<State>;
    template <class... Rest>
    static constexpr bool takes = std::is_invocable_v<Observer&, const scalar&, const State&, Rest...>;

  public:
    split_observer(Observer& observer, const State& y0) : observer_(observer), y_(y0) {}

    template <class Vector, class Output>
    requires(takes<const scalar&, const Output&>) decltype(auto) operator()(const scalar& t, const Vector& y,
                                                                            const scalar& h,
                                                                            const Output& output) {
        put_into(y_, y);
        return observer_(t, std::as_const(y_), h, output);
    }
    template <class Vector>
    requires(takes<const scalar&>) decltype(auto) operator()(const scalar& t, const Vector& y,
                                                             const scalar& h) {
        put_into(y_, y);
        return observer_(t, std::as_const(y_), h);
    }
    template <class Vector>
    requires(takes<>) decltype(auto) operator()(const scalar& t, const Vector& y) {
        put_into(y_, y);
        return observer_(t, std::as_const(y_));
    }

  private:
    Observer& observer_;
    State y_;
};

/// True if the Observer is a callable of the State without further members, which is called with that.
template <class Observer, class State, class Output>
concept observes_split =
    !std::is_same_v<std::remove_const_t<Observer>, no_observer> &&
    !has_member_named<Observer, start_member> && !has_member_named<Observer, correct_member> &&
    !has_member_named<Observer, save_member> && !has_member_named<Observer, conclude_member> &&
    !has_member_named<Observer, end_inside_member> && !has_member_named<Observer, change_member> &&
    can_observe<split_observer<Observer, State>, typename state_parts<State>::vector, Output>;

}  // namespace detail

/// result with y as a State.
template <detail::split_state State>
struct result<State> {
    detail::scalar_of<State> t;
    State y;
    stagecraft::status status;
    stagecraft::report<detail::scalar_of<State>> report;
    std::exception_ptr exception;

    bool ok() const { return status == status::success; }
};

/// integrate() for a y0 that is no real vector of Eigen's: a std::array or a std::vector, a number, and any of these,
/// or a vector of Eigen's, with complex elements:
///
///     integrate(method, [](double, double y) { return -y; }, 1.0, 0, 10).y
///     integrate(method, [](double, const std::array<double, 2>& y, auto& f) { f = {y[1], -y[0]}; }, start, 0, 10)
///
/// The problem writes or returns its value in the type of y0; a copy of it is called. It is integrated as a real vector,
/// which its values are copied into: two copies of n numbers for each evaluation, no allocation. All options and optional
/// members are those of integrate(). A complex number counts as two components, each with its own error; f need not be
/// differentiable as a complex function, unless there is a jacobian(t, y, J), which then writes the complex df/dy;
/// mass() and the like are refused there.
///
/// An observer that is a plain callable sees states of the type of y0, its output(time) vectors of Eigen's; one with
/// further members (events, at, solution, progress) sees these alone.
template <class Method, class Problem, detail::split_state State, class Observer = no_observer>
result<State> integrate(const Method& method, Problem&& problem, const State& y0,
                        std::type_identity_t<detail::scalar_of<State>> t0,
                        std::type_identity_t<detail::scalar_of<State>> t1,
                        const options<detail::scalar_of<State>>& o = {}, Observer&& observer = {}) {
    constexpr bool gives_state =
        detail::gives_state<std::remove_reference_t<Problem>, detail::scalar_of<State>, State>;
    static_assert(
        gives_state,
        "integrate: the problem must be callable as problem(t, y, f), y and f of the type of y0, or as "
        "problem(t, y) and return that type, and be const: not a std::array for a std::vector, say");
    constexpr bool object =
        !gives_state ||
        detail::returns_owned_state<std::remove_reference_t<Problem>, detail::scalar_of<State>, State>();
    static_assert(
        object,
        "integrate: the problem returns an expression of Eigen's, whose operands may be gone before it "
        "is evaluated: write `-> Eigen::Vector2cd`, the type of y0, or `return (A * y).eval();` (a "
        "number: .value())");
    constexpr bool arrives = !gives_state || !detail::loses_state<std::remove_reference_t<Problem>, State>();
    static_assert(
        arrives,
        "integrate: the problem takes f by value, or const, and what it writes is lost: write `State& f`, "
        "State the type of y0, or `auto& f`");
    if constexpr (!gives_state || !object || !arrives) {
        return {t0, y0, status::function_threw, {}, {}};
    } else {
        using form = detail::state_parts<State>;
        using vector = typename form::vector;
        const auto real_problem = detail::in_vectors(problem, y0);
        using real_type = std::remove_const_t<decltype(real_problem)>;
        vector start(detail::elements_of(y0) * form::parts);
        detail::take_out_of(y0, start);
        const auto run = [&](auto& watch) {
            const auto r = integrate(method, real_problem, start, t0, t1, o, watch);
            State y = y0;
            detail::put_into(y, r.y);
            return result<State>{r.t, y, r.status, r.report, r.exception};
        };
        using observer_type = std::remove_reference_t<Observer>;
        if constexpr (detail::runnable_method<Method>) {
            using output = typename integrator<Method, const real_type, vector>::output_type;
            if constexpr (detail::observes_split<observer_type, State, output>) {
                detail::split_observer<observer_type, State> watch(observer, y0);
                return run(watch);
            } else {
                return run(observer);
            }
        } else {
            return run(observer);
        }
    }
}

}  // namespace stagecraft
