// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <any>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include <stagecraft/dae/constraint_newton.hpp>
#include <stagecraft/jacobian/central_differences.hpp>
#include <stagecraft/linear/small_ldlt.hpp>
#include <stagecraft/refuse/problem/checked_capabilities.hpp>
#include <stagecraft/refuse/problem/written_argument.hpp>

namespace stagecraft {

namespace detail {

/// How much a projection has moved the states of a run.
template <class Scalar>
struct projection_record {
    long corrections = 0;  ///< states changed
    Scalar largest{0};     ///< largest change of a component

    template <class Vector>
    bool note(const Vector& before, const Vector& after) {
        // States of any scalar; what is told of them is not.
        const Scalar change =
            before.size() > 0 ? static_cast<Scalar>((after - before).cwiseAbs().maxCoeff()) : Scalar(0);
        if (!(change > Scalar(0))) return false;
        ++corrections;
        if (change > largest) largest = change;
        return true;
    }
};

/// In place of a projection that has been refused.
struct no_projection {
    template <class Scalar, class Vector>
    bool correct(const Scalar&, Vector&) {
        return false;
    }
    template <class Scalar, class Vector>
    void operator()(const Scalar&, const Vector&) const {}
};

/// The T that `held` holds; a new one is made if it holds none, or one of another size.
template <class T, class... Arguments>
T& kept(std::any& held, Eigen::Index size, Arguments&&... arguments) {
    auto* found = std::any_cast<T>(&held);
    if (!found || found->size() != size) found = &held.emplace<T>(std::forward<Arguments>(arguments)...);
    return *found;
}

}  // namespace detail

/// An observer that moves every accepted state onto the M equations 0 = g(t, y) by the smallest change in the
/// 2-norm (standard projection, Hairer-Lubich-Wanner IV.4): invariants of an ordinary differential equation,
/// such as the constraints that index reduction has lost, or its energy. Made by `projection_onto`.
///
/// The method keeps its order if the exact solution satisfies g = 0. Costs per step: one derivative of g (2 n
/// values of g by differences if it is neither given nor automatic), two or three values of g, and one f if
/// the method uses f at the end of the step, which is moved (FSAL, Gauss). Nothing is allocated after the
/// first step unless g does.
template <int M, class Constraint>
class projection_onto_equations {
    static_assert(M > 0, "projection_onto: the number of equations must be positive");

  public:
    explicit projection_onto_equations(Constraint g) : g_(std::move(g)) {}

    /// Called by `integrate`. Throws std::domain_error if the derivative of g has not full rank,
    /// std::runtime_error if the iteration does not converge: the run then ends with status::function_threw.
    template <class Scalar, class Vector>
    bool correct(const Scalar& t, Vector& y) {
        using std::abs;
        using multipliers = Eigen::Matrix<Scalar, M, 1>;
        const Scalar eps = std::numeric_limits<Scalar>::epsilon();
        auto& [before, change, moved, G, duals] = detail::kept<storage<Vector>>(storage_, y.size(), y.size());
        before = y;
        Scalar last(-1);
        for (int k = 0; k < 20; ++k) {
            const multipliers r = value<multipliers>(t, y);
            differentiate(t, y, moved, duals, G);
            Eigen::Matrix<Scalar, M, M> square;
            for (int i = 0; i < M; ++i)
                for (int j = 0; j <= i; ++j) square(i, j) = G.row(i).dot(G.row(j));
            for (int i = 0; i < M; ++i) square.row(i).tail(M - 1 - i).setZero();
            const small_ldlt<Scalar, M> factors(square);
            for (int i = 0; i < M; ++i)
                if (!(factors.pivot(i) > Scalar(100) * eps * square(i, i))) {
                    std::ostringstream text;
                    text << "projection_onto: the derivative of equation " << i
                         << " is zero or depends on the others at t = " << t;
                    throw std::domain_error(text.str());
                }
            const multipliers lambda = factors.solve(r);
            for (Eigen::Index i = 0; i < y.size(); ++i) change[i] = G.col(i).dot(lambda);
            const Scalar size = change.cwiseAbs().maxCoeff();
            if (!(size - size == Scalar(0))) break;
            y -= change;
            const bool rounding = size <= Scalar(16) * eps * y.cwiseAbs().maxCoeff();
            if (rounding || (last >= Scalar(0) && size > last / 2 && size * size <= eps * y.squaredNorm()))
                return record_.note(before, y);
            last = size;
        }
        std::ostringstream text;
        text << "projection_onto: Newton's iteration did not converge at t = " << t;
        throw std::runtime_error(text.str());
    }
    template <class Scalar, class Vector>
    void operator()(const Scalar&, const Vector&) const {}

    /// Number of states changed, and the largest change of a component.
    long corrections() const { return record_.corrections; }
    double largest_change() const { return record_.largest; }

  private:
    template <class Vector>
    struct storage {
        static constexpr int N = Vector::RowsAtCompileTime;
        using scalar = typename Vector::Scalar;
        Vector before, change, moved;
        Eigen::Matrix<scalar, M, N> G;
        dual_vector<scalar, N> duals;

        explicit storage(Eigen::Index n) : before(n), change(n), moved(n), G(M, n), duals(n) {}
        Eigen::Index size() const { return before.size(); }
    };

    /// g(t, y), written into a vector of M components or one of run-time size, whichever g takes.
    template <class Values, class Scalar, class Vector>
    Values value(const Scalar& t, const Vector& y) {
        using column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
        constexpr bool fixed = requires(Values & out) { g_(t, y, out); };
        constexpr bool callable = fixed || requires(column & out) { g_(t, y, out); };
        static_assert(
            callable,
            "projection_onto<M>(g): g must be callable as g(t, y, out), y of the type of the state and "
            "out `auto&`, `Eigen::Matrix<Scalar, M, 1>&` or `Eigen::VectorXd&`");
        using written = std::conditional_t<fixed, Values, column>;
        static_assert(
            !callable || detail::writes_into<Constraint, written, Scalar, Vector>,
            "projection_onto<M>(g): g takes out by value, or const, and what it writes is lost: write "
            "`Eigen::Matrix<Scalar, M, 1>& out` or `auto& out`");
        Values result;
        if constexpr (fixed) {
            g_(t, y, result);
        } else if constexpr (callable) {
            column out(M);
            g_(t, y, out);
            if (out.size() != M)
                throw std::invalid_argument("projection_onto<M>(g): g must keep the size M of its output");
            result = out;
        }
        return result;
    }

    /// g takes dual numbers for t and y.
    template <class Scalar, int N>
    static constexpr bool dual_time =
        detail::callable_unconverted<Constraint, const dual<Scalar, N>&, const dual_vector<Scalar, N>&,
                                     Eigen::Matrix<dual<Scalar, N>, M, 1>&>;

    /// g.jacobian(t, y, G) where there is one, else automatic differentiation, else central differences.
    template <class Scalar, class Vector, class Duals, class Matrix>
    void differentiate(const Scalar& t, const Vector& y, Vector& moved, Duals& duals, Matrix& G) {
        using std::cbrt;
        constexpr int N = Vector::RowsAtCompileTime;
        using number = dual<Scalar, N>;
        using values = Eigen::Matrix<number, M, 1>;
        const int n = static_cast<int>(y.size());
        constexpr bool analytic = requires { g_.jacobian(t, y, G); };
        static_assert(
            analytic || !detail::has_member_named<Constraint, detail::jacobian_member>,
            "projection_onto: g.jacobian must be callable as g.jacobian(t, y, G), G of M rows and as "
            "many columns as y");
        if constexpr (analytic) {
            g_.jacobian(t, y, G);
        } else if constexpr (dual_time<Scalar, N> ||
                             detail::callable_unconverted<Constraint, const Scalar&,
                                                          const dual_vector<Scalar, N>&, values&>) {
            values r;
            for (int first = 0; first < n; first += dual_width<N>) {
                for (int i = 0; i < n; ++i) {
                    duals[i].value() = y[i];
                    duals[i].derivatives().setZero();
                    if (i >= first && i < first + dual_width<N>)
                        duals[i].derivatives()[i - first] = Scalar(1);
                }
                if constexpr (dual_time<Scalar, N>) {
                    number time(t);
                    time.derivatives().setZero();
                    g_(time, std::as_const(duals), r);
                } else {
                    g_(t, std::as_const(duals), r);
                }
                for (int j = first; j < n && j < first + dual_width<N>; ++j)
                    for (int i = 0; i < M; ++i) G(i, j) = r[i].derivatives()[j - first];
            }
        } else {
            const auto at = [&](const Vector& x) { return value<Eigen::Matrix<Scalar, M, 1>>(t, x); };
            central_differences(y, moved, at, Scalar(cbrt(std::numeric_limits<Scalar>::epsilon())), G);
        }
    }

    Constraint g_;
    std::any storage_;  // of the state's type, which only the run knows
    detail::projection_record<double> record_;
};

/// An observer for `integrate` that keeps 0 = g(t, y), M equations: g(t, y, out) writes them; its derivative
/// is g.jacobian(t, y, G) where there is one, automatic where g is generic, else central differences. out is an
/// Eigen::Matrix<Scalar, M, 1>, or an Eigen::VectorXd of M components where g takes that (it is then made anew in every
/// call).
///
///     auto keep = projection_onto<1>(length);
///     integrate(method, reduced_pendulum, y0, t0, t1, options, keep);      // then keep.largest_change()
///
/// Together with others: observers(keep, watch); the others see corrected states.
template <int M, class Constraint>
projection_onto_equations<M, Constraint> projection_onto(Constraint g) {
    return projection_onto_equations<M, Constraint>(std::move(g));
}
/// The same for a g that says M itself, as g.count: the `invariants` of a mechanical model.
template <class Constraint>
auto projection_onto(Constraint g) {
    constexpr bool counted = requires { std::integral_constant<int, Constraint::count>(); };
    static_assert(counted,
                  "projection_onto<M>(g): give M, the number of equations 0 = g(t, y), as well: "
                  "projection_onto<1>(g)");
    if constexpr (counted)
        return projection_onto_equations<Constraint::count, Constraint>(std::move(g));
    else
        return detail::no_projection();
}

/// What a projection on a problem's own constraints does.
struct projection_options {
    /// Determine the algebraic components anew, so that the hidden constraints hold as well.
    bool hidden = false;
    /// Index 2: move along f_z, the directions of the algebraic components (projected collocation of Ascher
    /// and Petzold: Gauss methods then have order 2s in y). False, and always with index 3: the smallest
    /// change.
    bool along_algebraic = true;
};

/// An observer that moves every accepted state of a differential-algebraic problem onto its constraints
/// (those that bind the differential components, of index 2 and 3) and on request, by moving the algebraic
/// components, onto the hidden ones. Made by `projection`. Costs one Jacobian and a few f per step, with
/// `hidden` n more of each; what depends on M alone is kept from step to step. Nothing is allocated after the
/// first step unless the problem does. Stiffly accurate methods satisfy g = 0 to the tolerance of Newton's
/// iteration without any projection.
template <class Problem>
class constraint_projection {
  public:
    constraint_projection(Problem& problem, const projection_options& o) : problem_(problem), options_(o) {}

    /// A run begins: the mass matrix and the index flags are read anew.
    template <class Vector>
    void start(const typename Vector::Scalar&, const Vector&, const typename Vector::Scalar&) {
        storage_.reset();
    }
    /// Called by `integrate`; throws as consistent_initial_values does, which ends the run with
    /// status::function_threw.
    template <class Vector>
    bool correct(const typename Vector::Scalar& t, Vector& y) {
        auto& newton = detail::kept<constraint_newton<Problem, Vector>>(storage_, y.size(), problem_,
                                                                        y.size(), 1, 20, "projection");
        if (newton.system().count() == 0) return false;
        auto before = newton.system().states().take(y.size());
        before = y;
        newton.select(t, y);
        newton.bind(t, y, options_.along_algebraic && newton.system().depth() == 2);
        if (options_.hidden) newton.determine(t, y);
        return record_.note(static_cast<const Vector&>(before), y);
    }
    template <class Scalar, class Vector>
    void operator()(const Scalar&, const Vector&) const {}

    /// Number of states changed, and the largest change of a component.
    long corrections() const { return record_.corrections; }
    double largest_change() const { return record_.largest; }

  private:
    Problem& problem_;
    projection_options options_;
    std::any storage_;  // of the state's type, which only the run knows
    detail::projection_record<double> record_;
};

/// An observer for `integrate` that projects on the constraints of `problem`, which it refers to.
template <class Problem>
constraint_projection<Problem> projection(Problem& problem, const projection_options& o = {}) {
    return constraint_projection<Problem>(problem, o);
}

}  // namespace stagecraft
