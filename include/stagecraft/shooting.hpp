// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/bvp/equations/guess.hpp>
#include <stagecraft/bvp/options.hpp>
#include <stagecraft/bvp/result.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/linear/two_point_matrix.hpp>
#include <stagecraft/problem/two_point.hpp>
#include <stagecraft/sensitivity/forward.hpp>

namespace stagecraft {

/// What shooting may be told.
template <class Scalar>
struct shooting_options {
    Scalar rtol = Scalar(1e-8);  ///< of the integrations and of Newton's iteration
    Scalar growth{30};  ///< a new interval begins where the norm of the fundamental matrix exceeds this
    int intervals =
        1;  ///< equal ones to begin with; with growth = infinity these are all: 1 is single shooting
    int max_intervals = 10000;
    int newton_iterations = 30;
};

/// What shooting returns. The error is not estimated (solve_bvp does that): it is about rtol times kappa1 + kappa2 of the
/// problem (Satz 5.1 of the lecture), whatever the growth of single modes.
template <class Vector>
struct shooting_result {
    using scalar = typename Vector::Scalar;
    bvp_status status = bvp_status::newton_failed;
    std::string message;
    std::vector<scalar> nodes;   ///< a = t_0 < ... < t_N = b
    std::vector<Vector> values;  ///< y there
    scalar growth{0};            ///< the largest norm of a fundamental matrix X_j(t_{j+1})
    scalar jump{0};              ///< what is left at the nodes and in the conditions, relative to 1 + |y|
    int newton_steps = 0;
    long f = 0;  ///< evaluations of f

    bool ok() const { return status == bvp_status::success; }
};

namespace detail {

/// f with a parameter vector that it does not depend on, for sensitivities to initial values; and with its Jacobian.
template <class Rhs>
struct without_parameters : Rhs {
    using Rhs::operator();
    explicit without_parameters(const Rhs& f) : Rhs(f) {}
    template <class T, class Y, class P, class F>
    void operator()(const T& t, const Y& y, const P&, F& f) const {
        static_cast<const Rhs&> (*this)(t, y, f);
    }
    template <class T, class Y, class P, class F>
    void parameter_jacobian(const T&, const Y&, const P&, F& f) const {
        f.setZero();
    }
};

template <class Rhs>
struct with_unused_parameters : without_parameters<Rhs> {
    using without_parameters<Rhs>::without_parameters;
};
template <class Rhs>
requires has_member_named<Rhs, jacobian_member>
struct with_unused_parameters<Rhs> : without_parameters<Rhs> {
    using without_parameters<Rhs>::without_parameters;
    template <class T, class Y, class P, class J>
    void jacobian(const T& t, const Y& y, const P&, J& j) const {
        Rhs::jacobian(t, y, j);
    }
};

template <class Method, class Rhs, class Conditions, class Vector>
class shots {
    using scalar = typename Vector::Scalar;
    static constexpr int N = Vector::RowsAtCompileTime;
    using square = Eigen::Matrix<scalar, N, N>;
    using wide = Eigen::Matrix<scalar, N, Eigen::Dynamic>;
    using column = Eigen::Matrix<scalar, Eigen::Dynamic, 1>;
    using none = Eigen::Matrix<scalar, 0, 1>;

  public:
    shots(const Method& method, two_point_problem<Rhs, Conditions>& problem,
          const shooting_options<scalar>& o, int n)
        : method_(method),
          plain_(problem.f),
          f_(problem.f),
          o_(o),
          n_(n),
          system_(problem.f, problem.r, n, 0, counts_) {}

    template <class Guess>
    shooting_result<Vector> run(const Guess& guess, const scalar& a, const scalar& b) {
        for (int k = 0; k < o_.intervals; ++k) result_.nodes.push_back(a + (b - a) * k / o_.intervals);
        result_.nodes.push_back(b);
        for (const scalar& t : result_.nodes) result_.values.push_back(guess_value(guess, t, n_));
        const auto at_node = [&](const scalar& t, const Vector&) {
            return Vector(guess_value(guess, t, n_));
        };
        if (!linearise(at_node)) return result_;
        const auto follow = [](const scalar&, const Vector& y) { return y; };
        for (int k = 0; k < o_.newton_iterations; ++k) {
            if (!factor_and_solve()) return result_;
            ++result_.newton_steps;
            const scalar length = size(d_);
            if (!damped_step(length))
                return end(bvp_status::newton_failed, "no decrease along Newton's direction");
            if (!linearise(follow)) return result_;
            if (length <= o_.rtol) return end(bvp_status::success, "");
        }
        return end(bvp_status::newton_failed, "Newton's iteration has not converged");
    }

  private:
    int intervals() const { return static_cast<int>(result_.nodes.size()) - 1; }

    shooting_result<Vector> end(bvp_status s, const std::string& message) {
        result_.status = s, result_.message = message;
        return result_;
    }

    /// Integrates with variational equations from every node. Where these grow too much a node is put in, with the value
    /// that value_at gives.
    template <class ValueAt>
    bool linearise(const ValueAt& value_at) {
        X_.clear();
        ends_.clear();
        result_.growth = scalar(0);
        for (int i = 0; i < intervals(); ++i) {
            const auto u = static_cast<std::size_t>(i);
            const scalar t0 = result_.nodes[u], t1 = result_.nodes[u + 1];
            const auto r = shot(result_.values[u], t0, t1);
            if (r.status != status::success && r.status != status::stopped) {
                end(bvp_status::newton_failed, "an integration fails: " + std::string(name(r.status)));
                return false;
            }
            if (r.t < t1) {
                if (intervals() >= o_.max_intervals) {
                    end(bvp_status::too_many_intervals,
                        "the fundamental matrix grows too fast for max_intervals");
                    return false;
                }
                result_.nodes.insert(result_.nodes.begin() + i + 1, r.t);
                result_.values.insert(result_.values.begin() + i + 1, value_at(r.t, r.y));
            }
            X_.push_back(r.S);
            ends_.push_back(r.y);
            result_.growth = std::max(result_.growth, scalar(r.S.norm()));
        }
        return true;
    }

    /// One integration with variational equations, until they exceed options.growth. The step control looks at y alone: where
    /// one of its steps goes far beyond, again with smaller ones.
    auto shot(const Vector& y, const scalar& t0, const scalar& t1) {
        const square one = square::Identity(n_, n_);
        const auto goes_on = [&](const scalar&, const Vector&, const square& S) {
            return !(S.norm() > o_.growth);
        };
        auto o = steps();
        for (int tries = 0;; ++tries) {
            auto r = sensitivities(method_, f_, y, Vector(Vector::Zero(n_)), t0, t1, o, &one, goes_on);
            result_.f += r.report.f;
            if (!(r.S.norm() > 3 * o_.growth) || tries > 20) return r;
            o.max_step = (o.max_step > scalar(0) ? std::min(o.max_step, scalar(r.t - t0)) : r.t - t0) / 4;
        }
    }

    /// The correction d of the values, from X_i d_i - d_{i+1} = y_{i+1} - y(t_{i+1}; y_i) and the conditions.
    bool factor_and_solve() {
        residual(result_.values, ends_);
        const auto& B = system_.conditions_jacobian();
        matrix_.start(n_, intervals(), B.topRows(n_));
        wide block(n_, 2 * n_);
        for (int i = 0; i < intervals(); ++i) {
            block << X_[static_cast<std::size_t>(i)], -square::Identity(n_, n_);
            matrix_.set(i, block);
        }
        if (matrix_.factor() > 0) {
            end(bvp_status::singular, "the matrix of Newton's iteration is singular to rounding");
            return false;
        }
        d_ = solve();
        if (!(d_.sum() - d_.sum() == scalar(0))) {
            end(bvp_status::non_finite, "a correction is not finite");
            return false;
        }
        return true;
    }

    wide solve() {
        wide d(n_, intervals() + 1);
        none p;
        matrix_.solve(gaps_, beta_, d, p);
        return d;
    }

    /// gaps_ and beta_: what is to be removed.
    void residual(const std::vector<Vector>& values, const std::vector<Vector>& ends) {
        gaps_.resize(n_, intervals());
        for (int i = 0; i < intervals(); ++i) {
            const auto u = static_cast<std::size_t>(i);
            gaps_.col(i) = values[u + 1] - ends[u];
        }
        beta_ = -system_.conditions(values.front(), values.back(), none()).head(n_);
        result_.jump = scalar(0);
        for (int i = 0; i < intervals(); ++i)
            for (int c = 0; c < n_; ++c)
                result_.jump =
                    std::max(result_.jump, relative(gaps_(c, i), values[static_cast<std::size_t>(i)][c]));
    }

    static scalar relative(const scalar& d, const scalar& y) {
        using std::abs;
        return abs(d) / (scalar(1) + abs(y));
    }
    scalar size(const wide& d) const {
        scalar largest(0);
        for (int i = 0; i <= intervals(); ++i)
            for (int c = 0; c < n_; ++c)
                largest =
                    std::max(largest, relative(d(c, i), result_.values[static_cast<std::size_t>(i)][c]));
        return largest;
    }

    /// Moves the values by lambda d, lambda = 1, 1/2, 1/4, ..., until the next correction, with the same factors, is
    /// smaller (natural monotonicity test, Deuflhard 2004).
    bool damped_step(const scalar& length) {
        const auto from = result_.values;
        for (scalar lambda(1); lambda > scalar(1) / 1000; lambda /= 2) {
            for (int i = 0; i <= intervals(); ++i)
                result_.values[static_cast<std::size_t>(i)] =
                    from[static_cast<std::size_t>(i)] + lambda * d_.col(i);
            std::vector<Vector> ends;
            bool reached = true;
            for (int i = 0; i < intervals() && reached; ++i) {
                const auto u = static_cast<std::size_t>(i);
                const auto r = integrate(method_, plain_, result_.values[u], result_.nodes[u],
                                         result_.nodes[u + 1], steps());
                result_.f += r.report.f;
                reached = r.ok();
                ends.push_back(r.y);
            }
            if (!reached) continue;
            residual(result_.values, ends);
            const scalar next = size(solve());
            if (next <= (1 - lambda / 4) * length || next <= o_.rtol) return true;
        }
        return false;
    }

    options<scalar> steps() const {
        options<scalar> o;
        o.rtol = o.atol = o_.rtol / 10;
        return o;
    }

    const Method& method_;
    Rhs& plain_;
    with_unused_parameters<Rhs> f_;
    shooting_options<scalar> o_;
    int n_;
    report<scalar> counts_;
    two_point_system<two_point_problem<Rhs, Conditions>, Vector, none> system_;
    two_point_matrix<scalar, N> matrix_;
    std::vector<square> X_;
    std::vector<Vector> ends_;
    wide gaps_, d_;
    column beta_;
    shooting_result<Vector> result_;
};

struct call_of_shooting {
    template <class Method>
    static constexpr bool say() {
        static_assert(runnable_method<Method> || never<Method>,
                      "shooting: the first argument must be a transformed_tableau or a variable_order set, "
                      "radau_iia<3>() with its parentheses, say");
        static_assert(!runnable_method<Method> || never<Method>,
                      "shooting(method, two_point(f, r), a, b, guess, options): options have no other names "
                      "than {.rtol, .growth, .intervals, .max_intervals, .newton_iterations}");
        return true;
    }
};

}  // namespace detail

/// Solves y' = f(t, y) on [a, b] with r(y(a), y(b)) = 0 by shooting: initial value problems from the nodes t_j, integrated
/// by `method` with their variational equations (sensitivity/forward.hpp), and Newton's iteration on the values
/// there.
///
/// With the default options this is multiple shooting: nodes are put in where the fundamental matrix X_j from the last
/// node exceeds options.growth, since rounding errors and the errors of Newton's start are multiplied by it; with
/// .growth = infinity it is single shooting, which fails where cond X(b) does, whatever the problem's condition.
///
/// method   As for sensitivities(): radau_iia<s>(), gauss<s>(), radau_iia_variable(), ...
/// problem  two_point(f, r) without parameters (an unknown parameter is a component with y' = 0); generic in its
///          scalar, or f with jacobian(t, y, J).
/// guess    A vector, a function of t, or a solution.
///
/// Cost of a Newton step: an integration from a to b with n sensitivities, and one or more without. The error is
/// not estimated: solve_bvp is the solver to use, and this the one to compare with, or for an f that jumps.
/// Bad arguments throw std::invalid_argument, which names the argument.
template <detail::runnable_method Method, class Rhs, class Conditions, class Guess,
          class Scalar = detail::scalar_of_method<Method>>
auto shooting(const Method& method, two_point_problem<Rhs, Conditions> problem,
              std::type_identity_t<Scalar> a, std::type_identity_t<Scalar> b, const Guess& guess,
              const shooting_options<std::type_identity_t<Scalar>>& o = {}) {
    static_assert(
        detail::usable_guess<Guess, Scalar>,
        "shooting: guess must be a vector of Eigen's (Eigen::Vector2d(0, 1), say), a function of t that "
        "returns one (no expression: write `-> Eigen::Vector2d` or .eval()), or a solution");
    using vector = decltype(detail::guess_value(guess, a));
    const auto demand = [](bool good, const char* what) {
        if (!good) throw std::invalid_argument(std::string("shooting: ") + what);
    };
    demand(a < b && a - a == Scalar(0) && b - b == Scalar(0), "a must be below b, both finite");
    demand(o.rtol - o.rtol == Scalar(0) && o.rtol >= 40 * std::numeric_limits<Scalar>::epsilon(),
           "rtol must be finite and at least forty times the epsilon of the scalar");
    demand(o.growth > Scalar(1), "growth must exceed 1");
    demand(o.intervals > 0 && o.max_intervals >= o.intervals && o.newton_iterations > 0,
           "intervals and newton_iterations must be positive, max_intervals no less than intervals");
    const int n = static_cast<int>(detail::guess_value(guess, a).size());
    demand(n > 0, "guess must have at least one component");
    return detail::shots<Method, Rhs, Conditions, vector>(method, problem, o, n).run(guess, a, b);
}

/// Another first argument, or options of names that there are not.
shooting_result<Eigen::VectorXd> shooting(detail::refused_call<detail::call_of_shooting>, detail::anything,
                                          detail::anything, detail::anything, detail::anything,
                                          const detail::misnamed_options&);
shooting_result<Eigen::VectorXd> shooting(detail::refused_call<detail::call_of_shooting>, detail::anything,
                                          detail::anything = 0, detail::anything = 0, detail::anything = 0,
                                          ...);

}  // namespace stagecraft
