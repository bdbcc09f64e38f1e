// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <exception>
#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <vector>

#include <stagecraft/integrate.hpp>
#include <stagecraft/jacobian/automatic.hpp>
#include <stagecraft/linear/dense_blocks.hpp>
#include <stagecraft/sensitivity/linear_stages.hpp>
#include <stagecraft/sensitivity/parameters.hpp>
#include <stagecraft/sensitivity/stage_derivatives.hpp>
#include <stagecraft/stages/transformed.hpp>

namespace stagecraft {

/// The result of a run with the value of a functional g(y(t1)) of its end and the gradient of that.
template <class Vector, class Parameters>
struct gradient_result : result<Vector> {
    typename Vector::Scalar value{0};
    Vector dy0;     ///< dg/dy0
    Parameters dp;  ///< dg/dp
};

namespace detail {

/// A problem's J^T and M^T as the solvers of stage equations take them.
template <class Matrix, class Mass>
struct transposed_system {
    using mass_type = Mass;
    Matrix J;
    Mass M;
    const Matrix& jacobian() const { return J; }
    const Mass& mass() const { return M; }
    template <class F>
    static decltype(auto) measure(work, F&& f) {
        return f();
    }
};

/// The transposed steps of a run, from its end to its beginning: lambda, the derivative of g with respect to
/// the state, and mu, that with respect to p.
template <class Method, class Problem, class Vector>
class adjoint_steps {
    using scalar = typename Vector::Scalar;
    using derivatives = stage_derivatives<Problem, Vector>;
    using blocks = typename unstructured<typename derivatives::system_type::blocks>::type;

    /// The stage equations of one method, transposed.
    template <class Tableau>
    struct transposed_method;
    template <int Stages>
    struct transposed_method<transformed_tableau<scalar, Stages>> {
        transposed_method(const transformed_tableau<scalar, Stages>& m, int n)
            : d(update_weights(m)), stages(transposed(m), n) {}
        Eigen::Matrix<scalar, Stages, 1> d;
        transformed_stages<Vector, Stages, blocks> stages;
    };
    template <class... Tableaux>
    static std::tuple<transposed_method<Tableaux>...> make(const std::tuple<Tableaux...>& methods, int n) {
        return std::apply([n](const auto&... m) { return std::tuple(transposed_method<Tableaux>(m, n)...); },
                          methods);
    }
    using methods_type = decltype(make(as_tuple(std::declval<const Method&>()), 0));

  public:
    using parameters = typename Problem::parameters;

    adjoint_steps(const Method& method, const Problem& problem, const Vector& lambda,
                  const options<scalar>& o)
        : at_(problem, lambda, o),
          methods_(make(as_tuple(method), static_cast<int>(lambda.size()))),
          mass_(transposed(at_.mass())),
          lambda_(lambda),
          weights_(lambda),
          mu_(parameters::Zero(problem.p.size())) {}

    const Vector& lambda() const { return lambda_; }
    const parameters& mu() const { return mu_; }

    /// Takes back a step that method number k has made; false if its linear equations could not be solved.
    template <class Output>
    bool back(const Output& output, int k) {
        return visit_at(methods_, k, [&](auto& method) {
            auto& stages = method.stages;
            const int s = stages.stages();
            const scalar h = output.step();
            at_.evaluate(stages.method(), output);
            at_.relative_weights(output.y0(), weights_);
            weights_ = weights_.cwiseInverse();  // sizes of derivatives are the inverse ones
            const auto add = [&](int i, const Vector& v, Vector& f) {
                f = (method.d[i] / h) * lambda_;
                add_transposed_product(at_.J(i), v, f);
            };
            Z_.resize(lambda_.size(), s);
            const Vector none = Vector::Zero(lambda_.size());
            // The iteration needs one matrix near the Jacobians of all stages: mostly that of the middle one, else one of
            // those before and behind it, in turn.
            bool solved = false;
            for (int attempt = 0; attempt < s && !solved; ++attempt) {
                const int near = s / 2 + (attempt % 2 == 1 ? -(attempt + 1) / 2 : attempt / 2);
                const transposed_system<typename derivatives::matrix, decltype(mass_)> system{
                    transposed(at_.J(near)), mass_};
                solved = stages.factor(system, h) &&
                         solve_linear_stages(stages, mass_, add, none, h, weights_, at_.tolerance(), Z_);
            }
            if (!solved) return false;
            for (int i = 0; i < s; ++i) {
                const Vector stage = h * Z_.col(i);
                add_transposed_product(at_.J(i), stage, lambda_);
                mu_.noalias() += at_.F(i).transpose() * stage;
            }
            return true;
        });
    }

  private:
    derivatives at_;
    methods_type methods_;
    std::remove_cvref_t<decltype(transposed(std::declval<const derivatives&>().mass()))> mass_;
    Vector lambda_, weights_;
    parameters mu_;
    Eigen::Matrix<scalar, Vector::RowsAtCompileTime, Eigen::Dynamic> Z_;
};

/// g is generic and returns a number.
template <class Functional, class Vector,
          class Number = dual<typename Vector::Scalar, Vector::RowsAtCompileTime>,
          class Numbers = dual_vector<typename Vector::Scalar, Vector::RowsAtCompileTime>>
concept differentiable_functional = callable_unconverted<const Functional, const Numbers&> &&
    std::is_invocable_r_v<Number, const Functional&, Numbers&>;

/// g(y) and, in `slope`, its derivative.
template <class Functional, class Vector>
typename Vector::Scalar differentiate_functional(const Functional& g, const Vector& y, Vector& slope) {
    using scalar = typename Vector::Scalar;
    constexpr int N = Vector::RowsAtCompileTime, width = dual_width<N>;
    using number = dual<scalar, N>;
    auto at = promoted<number>(y);
    scalar value(0);
    for (Eigen::Index first = 0; first < y.size(); first += width) {
        for (Eigen::Index i = first; i < y.size() && i < first + width; ++i)
            at[i].derivatives()[i - first] = scalar(1);
        const number here = g(at);
        value = here.value();
        for (Eigen::Index i = first; i < y.size() && i < first + width; ++i) {
            slope[i] = here.derivatives()[i - first];
            at[i].derivatives().setZero();
        }
    }
    return value;
}

/// Checkpoints along a run of unknown length, at most twice as many as there are steps between two.
template <class Vector>
class thinned_checkpoints {
  public:
    template <class Take>
    void save(const Take& take) {
        if (steps_++ % spacing_ != 0) return;
        points_.push_back(take());
        if (points_.size() < 2 * static_cast<std::size_t>(spacing_)) return;
        spacing_ *= 2;
        for (std::size_t k = 1; 2 * k < points_.size(); ++k) points_[k] = std::move(points_[2 * k]);
        points_.resize((points_.size() + 1) / 2);
    }
    std::vector<checkpoint<Vector>>& points() { return points_; }
    long spacing() const { return spacing_; }

  private:
    std::vector<checkpoint<Vector>> points_;
    long steps_ = 0, spacing_ = 8;
};

struct call_of_adjoint_gradient {
    template <class Method>
    static constexpr bool say() {
        static_assert(
            transformed_method<Method> || never<Method>,
            "adjoint_gradient: the first argument must be a transformed_tableau or a variable_order "
            "set, radau_iia<3>() with its parentheses, say");
        static_assert(
            !transformed_method<Method> || never<Method>,
            "adjoint_gradient(method, problem, y0, p, t0, t1, g, options): the problem must be callable as "
            "problem(t, y, p, f), y0 and p be column vectors of Eigen's (one parameter too: "
            "Eigen::Matrix<double, 1, 1>(2.0)), and options have the names that they have for integrate()");
        return true;
    }
};

}  // namespace detail

/// Integrates M y' = f(t, y, p) and differentiates a functional g(y(t1)) of the end with respect to y0 and p, at a
/// cost that does not grow with the number of parameters: by the discrete adjoint, every accepted step transposed and
/// taken back from the end. The step sizes are held fixed, so that this is, to rounding, the gradient of g of the numerical
/// solution, the one that sensitivities() would give; as there, f must have derivatives along the solution.
///
/// A Runge-Kutta method of order p has a discrete adjoint of order p (Sandu 2006): where no b_i is zero it is the method
/// b_i, b_j - b_j a_ji / b_i for the adjoint equation, together with which the method is symplectic (Hager 2000,
/// Sanz-Serna 2016). On stiff equations its stages are those of another method, of another stage order: for Radau IIA of
/// Radau IA, s - 1, so that the gradient may fall behind the solution between those of p in stiff components.
///
/// problem, p, method as in sensitivities(); g is called as g(y) with a vector of dual numbers and must be generic
/// (`const auto& y`). mass() must show its entries.
///
/// Memory: the square root of the number of steps, twice, in checkpoints and in steps, which are made again from them, bit by
/// bit. Costs the run twice, and for every step s Jacobians, a factorisation and some ten solves. Where the run
/// does not end with success there is no gradient (zeros); status::newton_failed if a step's linear equations are not
/// solved. std::invalid_argument as integrate().
template <class Method, class Problem, class DerivedY, class DerivedP, class Functional>
requires detail::run_with_parameters<Method, Problem, typename DerivedY::PlainObject,
                                     typename DerivedP::PlainObject>
auto adjoint_gradient(const Method& method, const Problem& problem, const Eigen::MatrixBase<DerivedY>& y0,
                      const Eigen::MatrixBase<DerivedP>& p,
                      std::type_identity_t<typename DerivedY::Scalar> t0,
                      std::type_identity_t<typename DerivedY::Scalar> t1, const Functional& g,
                      const options<typename DerivedY::Scalar>& o = {}) {
    using vector = typename DerivedY::PlainObject;
    using parameters = typename DerivedP::PlainObject;
    constexpr bool differentiable = detail::parameter_derivatives<Problem, vector, parameters>::exist,
                   functional = detail::differentiable_functional<Functional, vector>;
    static_assert(
        differentiable,
        "adjoint_gradient: problem(t, y, p, f) must be generic in its scalar (const auto& t, const auto& y, "
        "const auto& p, auto& f), or the problem have a member parameter_jacobian(t, y, p, F)");
    static_assert(
        functional,
        "adjoint_gradient: g is called with a vector of dual numbers and must accept any scalar and return "
        "a number: [](const auto& y) { return y[0]; }");
    using bound = at_parameters<Problem, parameters>;
    using run_type = integrator<Method, const bound, vector>;
    const bound at_p(problem, p);
    detail::thinned_checkpoints<vector> kept;
    vector start = y0;
    gradient_result<vector, parameters> r{
        {t0, start, status::success, {}, nullptr}, {}, vector::Zero(y0.size()), parameters::Zero(p.size())};
    run_type run(method, at_p, start, t0, t1, o);
    try {
        do kept.save([&] { return checkpoint_of(run); });
        while (run.step());
        r.t = run.t();
        r.y = run.y();
        r.status = run.status();
        r.report = run.counts();
        if (!r.ok()) return r;
        vector slope = start;
        if constexpr (functional) r.value = detail::differentiate_functional(g, r.y, slope);
        detail::adjoint_steps<Method, bound, vector> adjoint(method, at_p, slope, o);
        std::vector<std::pair<typename run_type::output_type, int>> steps;
        for (auto& points = kept.points(); !points.empty(); points.pop_back()) {
            run_type again(method, at_p, points.back().y, points.back().t, t1, o);
            restore(again, points.back());
            steps.clear();
            while (static_cast<long>(steps.size()) < kept.spacing() && again.t() != r.t && again.step())
                steps.emplace_back(again.output(), again.last_method());
            r.t = points.back().t;
            for (auto step = steps.rbegin(); step != steps.rend(); ++step)
                if (!adjoint.back(step->first, step->second)) {
                    r.status = status::newton_failed;
                    return r;
                }
        }
        r.t = run.t();
        r.dy0 = adjoint.lambda();
        r.dp = adjoint.mu();
    } catch (const std::invalid_argument&) {
        throw;
    } catch (...) {
        r.status = status::function_threw;
        r.exception = std::current_exception();
    }
    return r;
}

/// Other arguments.
gradient_result<Eigen::VectorXd, Eigen::VectorXd> adjoint_gradient(
    detail::refused_call<detail::call_of_adjoint_gradient>, detail::anything, detail::anything,
    detail::anything, detail::anything, detail::anything, detail::anything, const detail::misnamed_options&);
gradient_result<Eigen::VectorXd, Eigen::VectorXd> adjoint_gradient(
    detail::refused_call<detail::call_of_adjoint_gradient>, detail::anything, detail::anything = 0,
    detail::anything = 0, detail::anything = 0, detail::anything = 0, detail::anything = 0, ...);

}  // namespace stagecraft
