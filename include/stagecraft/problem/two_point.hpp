// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include <stagecraft/jacobian/unconverted.hpp>
#include <stagecraft/problem/system.hpp>
#include <stagecraft/problem/two_point_functions.hpp>
#include <stagecraft/refuse/problem/checked_call.hpp>
#include <stagecraft/refuse/problem/checked_capabilities.hpp>

namespace stagecraft {

/// A two-point boundary value problem M y' = f(t, y, p) on [a, b], r(y(a), y(b), p) = 0, as one value.
template <class Rhs, class Conditions>
struct two_point_problem {
    Rhs f;
    Conditions r;
};

/// The problem of a right-hand side f(t, y, out), or f(t, y, p, out) with unknown parameters p, and conditions
/// r(left, right, out) or r(left, right, p, out), which write n + n_p numbers: with algebraic components (mass(),
/// index 1) their equations at one end are among them. f may bring jacobian(t, y, J)
/// (with parameters jacobian(t, y, p, J), J being n x (n + n_p)), mass() and index() as for integrate(); what
/// it does not bring, and the derivatives of r, come from automatic differentiation or differences.
template <class Rhs, class Conditions>
two_point_problem<Rhs, Conditions> two_point(Rhs f, Conditions r) {
    static_assert(!in_parts<Rhs>,
                  "two_point(f, r): f is the whole right-hand side: write the sum of the "
                  "parts of split(f_explicit, f_implicit)");
    return {std::move(f), std::move(r)};
}

namespace detail {

/// What conditions write into: an R whose entries begin as NaN, and a spare number that is written instead where there is
/// no such entry, in every build. Conditions that ask for an R meet it behind the entries of an R of fixed size.
template <class R>
struct condition_values : R {
    using scalar = typename R::Scalar;
    scalar spare{std::numeric_limits<double>::quiet_NaN()};

    explicit condition_values(Eigen::Index n) : R(n) {
        for (Eigen::Index i = 0; i < n; ++i) this->coeffRef(i) = spare;
    }
    using R::operator=;
    using R::operator();
    scalar& operator[](Eigen::Index i) { return i >= 0 && i < this->size() ? this->coeffRef(i) : spare; }
    scalar& operator()(Eigen::Index i) { return (*this)[i]; }
};

/// Whether conditions can be called with these arguments and an R to write into.
template <class Conditions, class R, class... Arguments>
concept writes_watched_conditions = writes_last<Conditions, condition_values<R>, Arguments...> &&
    callable_unconverted<Conditions, const Arguments&..., std::add_lvalue_reference_t<condition_values<R>>>;
template <class Conditions, class R, class... Arguments>
concept writes_conditions = writes_watched_conditions<Conditions, R, Arguments...> ||
    (writes_last<Conditions, R, Arguments...>&& callable_unconverted<Conditions, const Arguments&..., R&>);

/// Calls r with an R of m numbers to write, which go to out[first] and behind. `count` says in words how many these are.
template <class R, class Conditions, class Out, class Count, class... Arguments>
void write_conditions(Conditions& r, int m, const Count& count, Out& out, int first,
                      const Arguments&... arguments) {
    condition_values<R> value(m);
    if constexpr (std::is_invocable_v<Conditions&, const Arguments&..., condition_values<R>&>)
        r(arguments..., value);
    else
        r(arguments..., static_cast<R&>(value));
    if (value.size() != m || value.spare == value.spare)
        throw bad_problem("solve_bvp: the conditions must write " + count() + ", not " +
                          (value.size() != m ? std::to_string(value.size()) : "more"));
    for (int i = 0; i < m; ++i) out[first + i] = value[i];
}

/// Whether f and r can be called as two_point() says with states of the type Vector and these Parameters.
template <class Rhs, class Conditions, class Vector, class Parameters>
struct checked_two_point {
    static constexpr int N = Vector::RowsAtCompileTime, P = Parameters::RowsAtCompileTime;
    using scalar = typename Vector::Scalar;
    using values = Eigen::Matrix<scalar, added<N, P>, 1>;
    static constexpr bool alone = P == 0;
    static constexpr bool rhs = alone ? writes_last<Rhs, Vector, scalar, Vector>
                                      : writes_last<Rhs, Vector, scalar, Vector, Parameters>;
    static constexpr bool conditions =
        alone ? writes_conditions<Conditions, values, Vector, Vector>
              : writes_conditions<Conditions, values, Vector, Vector, Parameters>;
    static constexpr bool writes_through = [] {
        if constexpr (!rhs || !conditions)
            return true;  // these come first
        else if constexpr (alone)
            return writes_into<Rhs, Vector, scalar, Vector> &&
                   writes_into<Conditions, values, Vector, Vector>;
        else
            return writes_into<Rhs, Vector, scalar, Vector, Parameters> &&
                   writes_into<Conditions, values, Vector, Vector, Parameters>;
    }();
};

/// f as a function of z = (y, p), with n_p trailing zeros so that it is square.
template <class Rhs, int N, int P>
struct joint_rhs {
    Rhs& f;
    int n, parameters;

    template <class T, class Z, class Out>
    requires(P == 0 && callable_unconverted<Rhs, const T&, const Z&, Out&>) void operator()(const T& t,
                                                                                            const Z& z,
                                                                                            Out& out) {
        f(t, z, out);
    }
    template <class T, class Z, class Out, class U = typename Z::Scalar, class Y = Eigen::Matrix<U, N, 1>,
              class Q = Eigen::Matrix<U, P, 1>>
    requires(P != 0 && callable_unconverted<Rhs, const T&, const Y&, const Q&, Y&>) void operator()(
        const T& t, const Z& z, Out& out) {
        const Y y = z.head(n);
        const Q p = z.tail(parameters);
        Y value(n);
        for (int i = 0; i < n; ++i) value[i] = U(std::numeric_limits<double>::quiet_NaN());
        f(t, y, p, value);
        if (value.size() != n) throw size_change{};
        for (int i = 0; i < n; ++i) out[i] = value[i];
        for (int i = 0; i < parameters; ++i) out[n + i] = U(0);
    }
};

/// The same where f brings its own Jacobian.
template <class Rhs, int N, int P>
struct joint_rhs_with_jacobian : joint_rhs<Rhs, N, P> {
    using joint_rhs<Rhs, N, P>::operator();
    template <class T, class Z, class J>
    void jacobian(const T& t, const Z& z, J& j) {
        if constexpr (P == 0) {
            this->f.jacobian(t, z, j);
        } else {
            using number = typename Z::Scalar;
            const Eigen::Matrix<number, N, 1> y = z.head(this->n);
            const Eigen::Matrix<number, P, 1> p = z.tail(this->parameters);
            Eigen::Matrix<number, N, added<N, P>> own(this->n, this->n + this->parameters);
            own.setZero();
            this->f.jacobian(t, y, p, own);
            j.setZero();
            j.topRows(this->n) = own;
        }
    }
};

/// r as a function of (left, right, p), with trailing zeros so that it is square.
template <class Conditions, int N, int P>
struct joint_conditions {
    Conditions& r;
    int n, parameters;

    template <class T, class X, class Out, class U = typename X::Scalar, class Y = Eigen::Matrix<U, N, 1>,
              class R = Eigen::Matrix<U, added<N, P>, 1>>
    requires(P == 0 && writes_conditions<Conditions, R, Y, Y>) void operator()(const T&, const X& x,
                                                                               Out& out) {
        const Y left = x.head(n), right = x.segment(n, n);
        write<R>(out, left, right);
    }
    template <class T, class X, class Out, class U = typename X::Scalar, class Y = Eigen::Matrix<U, N, 1>,
              class Q = Eigen::Matrix<U, P, 1>, class R = Eigen::Matrix<U, added<N, P>, 1>>
    requires(P != 0 && writes_conditions<Conditions, R, Y, Y, Q>) void operator()(const T&, const X& x,
                                                                                  Out& out) {
        const Y left = x.head(n), right = x.segment(n, n);
        const Q p = x.tail(parameters);
        write<R>(out, left, right, p);
    }

  private:
    template <class R, class Out, class... Arguments>
    void write(Out& out, const Arguments&... arguments) {
        const int m = n + parameters;
        const auto count = [this] {
            return "n + n_p numbers, n = " + std::to_string(n) + ", n_p = " + std::to_string(parameters);
        };
        write_conditions<R>(r, m, count, out, 0, arguments...);
        for (int i = m; i < 2 * n + parameters; ++i) out[i] = typename R::Scalar(0);
    }
};

}  // namespace detail

/// The functions of a two_point_problem.
template <class Problem, class Vector, class Parameters>
class two_point_system : public two_point_functions<typename Vector::Scalar, Vector::RowsAtCompileTime,
                                                    Parameters::RowsAtCompileTime> {
    using Rhs = decltype(Problem::f);
    using Conditions = decltype(Problem::r);

  public:
    using base = two_point_functions<typename Vector::Scalar, Vector::RowsAtCompileTime,
                                     Parameters::RowsAtCompileTime>;
    using typename base::ends, typename base::joint, typename base::joint_square, typename base::ends_square;
    using scalar = typename Vector::Scalar;
    static constexpr int N = base::N, P = base::P;
    using rhs_type =
        std::conditional_t<detail::has_member_named<Rhs, detail::jacobian_member>,
                           detail::joint_rhs_with_jacobian<Rhs, N, P>, detail::joint_rhs<Rhs, N, P>>;
    using conditions_type = detail::joint_conditions<Conditions, N, P>;

    two_point_system(Rhs& f, Conditions& r, int n, int parameters, report<scalar>& counts)
        : base(n, parameters, counts, system<rhs_type, joint>::finite_difference,
               system<conditions_type, ends>::finite_difference),
          problem_rhs_(f),
          rhs_{joint_of(f, n, parameters)},
          conditions_{r, n, parameters},
          f_(rhs_, joint::Zero(n + parameters), counts),
          r_(conditions_, ends::Zero(2 * n + parameters), ignored_) {
        static_assert(!has_bandwidth<Rhs> && !has_sparsity<Rhs>, "solve_bvp: Jacobians are dense");
        f_.take_jacobian();
        r_.take_jacobian();
    }

    optional_mass<scalar> mass() const override {
        using type = decltype(make_mass<scalar>(std::declval<Rhs&>(), 0));
        if constexpr (has_entries<type>)
            return optional_mass<scalar>(make_mass<scalar>(problem_rhs_, this->size()));
        else
            throw bad_problem("solve_bvp: problem.mass() must be a matrix whose entries can be looked at");
    }

  private:
    static rhs_type joint_of(Rhs& f, int n, int parameters) {
        if constexpr (detail::has_member_named<Rhs, detail::jacobian_member>)
            return {{f, n, parameters}};
        else
            return {f, n, parameters};
    }

    void evaluate(const scalar& t, const joint& z, joint& out) override { f_(t, z, out); }
    const joint_square& differentiate(const scalar& t, const joint& z, const joint& f,
                                      const joint& negligible) override {
        f_.evaluate_jacobian(t, z, f, negligible);
        return f_.jacobian();
    }
    void evaluate_conditions(const ends& x, ends& out) override { r_(scalar(0), x, out); }
    const ends_square& differentiate_conditions(const ends& x, const ends& r,
                                                const ends& negligible) override {
        r_.evaluate_jacobian(scalar(0), x, r, negligible);
        return r_.jacobian();
    }

    Rhs& problem_rhs_;
    rhs_type rhs_;
    conditions_type conditions_;
    report<scalar> ignored_;
    system<rhs_type, joint> f_;
    system<conditions_type, ends> r_;
};

}  // namespace stagecraft
