// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/linear/dense_blocks.hpp>
#include <stagecraft/options.hpp>
#include <stagecraft/sensitivity/consistent_start.hpp>
#include <stagecraft/sensitivity/functionals.hpp>
#include <stagecraft/sensitivity/linear_stages.hpp>
#include <stagecraft/sensitivity/passage.hpp>
#include <stagecraft/sensitivity/stage_derivatives.hpp>
#include <stagecraft/stages/transformed.hpp>
#include <stagecraft/step/method_set.hpp>

namespace stagecraft::detail {

/// The derivatives of one functional with respect to the state and to p, and its value.
template <class Vector, class Parameters>
struct adjoint_state {
    Vector lambda;
    Parameters mu;
    typename Vector::Scalar value{0};
};

/// The transposed steps of a run, from its end to its beginning, for all functionals.
template <class Method, class Problem, class Vector, class Functionals>
class adjoint_steps {
    using scalar = typename Vector::Scalar;
    using derivatives = adjoint_derivatives<Problem, Vector>;
    using system_type = typename derivatives::system_type;
    using mass_type = typename system_type::mass_type;
    using blocks = typename unstructured<typename system_type::blocks>::type;
    using pair_type = matrix_pair<typename derivatives::matrix, mass_type>;

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
    using state = adjoint_state<Vector, parameters>;

    adjoint_steps(const Method& method, const Problem& problem, const Vector& y0, const options<scalar>& o,
                  const Functionals& functionals)
        : at_(problem, y0, o),
          methods_(make(as_tuple(method), static_cast<int>(y0.size()))),
          mass_(transposed(at_.mass())),
          functionals_(functionals),
          weights_(y0),
          states_(std::tuple_size_v<Functionals>,
                  {Vector::Zero(y0.size()), parameters::Zero(problem.p.size())}) {}

    const std::vector<state>& states() const { return states_; }
    void states(const std::vector<state>& given) { states_ = given; }
    const std::string& refuted() const { return refuted_; }

    /// Adds what the values at t1 contribute, or those at data times, of which number `time` of the union of all is here.
    void end(const Vector& y) {
        for_each([&](const auto& g, state& to) {
            if constexpr (is_end_value<std::remove_cvref_t<decltype(g)>>)
                add(to, y, [&](const auto& at, const auto& q) { return with_parameters(g.g, q, at); });
        });
    }
    void data(const scalar& t, const Vector& y) {
        for_each([&](const auto& g, state& to) {
            if constexpr (is_data_sum<std::remove_cvref_t<decltype(g)>>)
                for (std::size_t j = 0; j < g.times.size(); ++j)
                    if (scalar(g.times[j]) == t)
                        add(to, y,
                            [&](const auto& at, const auto& q) { return with_parameters(g.g, q, j, at); });
        });
    }

    /// Takes back a step that method number k has made; false if its linear equations could not be solved, or if the
    /// derivatives that the problem gives are refuted.
    template <class Output>
    bool back(const Output& output, int k) {
        return visit_at(methods_, k, [&](auto& method) {
            auto& stages = method.stages;
            const int s = stages.stages();
            at_.place(stages.method(), stages.method().A_inverse.transpose(), output);
            at_.evaluate();
            refuted_ = at_.refuted(static_cast<int>(looks_++ % s));
            if (!refuted_.empty()) return false;
            at_.relative_weights(output.y0(), weights_);
            weights_ = weights_.cwiseInverse();  // sizes of derivatives are the inverse ones
            factored_ = false;
            bool good = true;
            for_each([&](const auto& g, state& to) { good = good && back(method, g, to, output.step()); });
            return good;
        });
    }

    /// Takes back what has been passed, with `problem` that of these steps, which holds before it.
    template <class Sides>
    void back(const passage<Vector>& passed, const Sides& sides) {
        typename Sides::derivatives call;
        for_each([&](const auto& g, state& to) {
            scalar by_time =
                passed.located && !passed.terminal ? -passed.slope_behind.dot(to.lambda) : scalar(0);
            for (std::size_t i = passed.numbers.size(); i-- > 0;) {
                sides.take_change(passed.numbers[i], passed.t, passed.states[i], passed.located, call);
                const Vector lambda = to.lambda;
                to.lambda.setZero();
                by_time += call.transposed(lambda, scalar(1), to.lambda, to.mu);
            }
            if (passed.located) back_in_time(passed, sides, g, by_time, to);
        });
    }

    /// Lets the algebraic components at the start follow from the others, by the derivative of their equations, where these
    /// are of index 1: for methods that do not forget them.
    void make_consistent(const scalar& t0, const Vector& y0) {
        if constexpr (!mass_type::identity && has_entries<mass_type>) {
            at_.place(0, t0, y0);
            at_.place(1, t0, y0);
            at_.evaluate();
            const pair_type pair{transposed(at_.near_jacobian_of(0)), mass_};
            const auto add = [&](const Vector& v, Vector& out) { at_.add_by_state(0, v, out); };
            Vector x = y0;
            for (state& one : states_)
                if (solve_algebraic<blocks>(pair, one.lambda, add, x)) {
                    at_.add_by_state(0, x, one.lambda);
                    at_.add_by_parameters(0, x, one.mu);
                }
        }
    }

  private:
    template <class Visit>
    void for_each(const Visit& visit) {
        std::size_t k = 0;
        std::apply([&](const auto&... g) { (visit(g, states_[k++]), ...); }, functionals_);
    }
    template <class G>
    void add(state& to, const Vector& y, const G& g) {
        to.value += function_(g, y, at_.problem().p, scalar(1), to.lambda, to.mu);
    }

    /// What the time of an event contributes, and the move of the state to it; by_time is the derivative of all behind it by
    /// that time, with the state moving along.
    template <class Sides, class Functional>
    void back_in_time(const passage<Vector>& passed, const Sides& sides, const Functional& g, scalar by_time,
                      state& to) {
        const Vector& y = passed.states.front();
        by_time += passed.slope.dot(to.lambda);
        Vector none = Vector::Zero(y.size());
        parameters none_by_p = parameters::Zero(to.mu.size());
        if constexpr (is_integral<Functional>) {
            const auto integrand = [&](const Vector& at) {
                return function_(
                    [&](const auto& x, const auto& q) { return with_parameters(g.g, q, passed.t, x); }, at,
                    at_.problem().p, scalar(0), none, none_by_p);
            };
            by_time += integrand(y);
            if (!passed.terminal) by_time -= integrand(passed.states.back());
            to.value += passed.moved * integrand(y);
        }
        typename Sides::derivatives event;
        sides.take_event(passed.numbers.front(), passed.t, y, event);
        const scalar rate = event.along(scalar(1), passed.slope, -1)[0];
        event.transposed(Eigen::Matrix<scalar, 1, 1>(scalar(1)), -by_time / rate, to.lambda, to.mu);
        at_.place(0, passed.t_found, passed.y_found);
        at_.place(1, passed.t_found, passed.y_found);
        at_.evaluate();
        const Vector lambda = passed.moved * to.lambda;
        at_.add_both(0, lambda, to.lambda, to.mu);
    }

    template <class TransposedMethod, class Functional>
    bool back(TransposedMethod& method, const Functional& g, state& to, const scalar& h) {
        auto& stages = method.stages;
        const int s = stages.stages();
        Z_.resize(to.lambda.size(), s);
        source_.resize(to.lambda.size(), s);
        source_.setZero();
        if constexpr (is_integral<Functional>) {
            for (int i = 0; i < s; ++i) {
                Vector by_y = Vector::Zero(to.lambda.size());
                const scalar weight = h * stages.method().b[i];
                to.value +=
                    weight * function_([&](const auto& y,
                                           const auto& q) { return with_parameters(g.g, q, at_.t(i), y); },
                                       at_.y(i), at_.problem().p, weight, by_y, to.mu);
                source_.col(i) = by_y;
            }
        }
        const auto add = [&](int i, const Vector& v, Vector& f) {
            f = (method.d[i] / h) * to.lambda;
            if constexpr (is_integral<Functional>) f += source_.col(i) / h;
            at_.add_by_state(i, v, f);
        };
        const Vector none = Vector::Zero(to.lambda.size());
        const auto solve = [&] {
            return solve_linear_stages(stages, mass_, add, none, h, weights_, at_.tolerance(), Z_);
        };
        // The iteration needs one matrix near the Jacobians of all stages: mostly that of the middle one, else one of
        // those before and behind it, in turn.
        bool solved = factored_ && solve();
        for (int attempt = 0; attempt < s && !solved; ++attempt) {
            const int near = s / 2 + (attempt % 2 == 1 ? -(attempt + 1) / 2 : attempt / 2);
            const pair_type pair{transposed(at_.near_jacobian_of(near)), mass_};
            factored_ = stages.factor(pair, h);
            solved = factored_ && solve();
        }
        if (!solved) return false;
        for (int i = 0; i < s; ++i) {
            const Vector stage = h * Z_.col(i);
            if constexpr (is_integral<Functional>) to.lambda += source_.col(i);
            at_.add_both(i, stage, to.lambda, to.mu);
        }
        return true;
    }

    derivatives at_;
    methods_type methods_;
    mass_type mass_;  // transposed
    const Functionals& functionals_;
    Vector weights_;
    std::vector<state> states_;
    recorded_function<Vector, parameters> function_;
    Eigen::Matrix<scalar, Vector::RowsAtCompileTime, Eigen::Dynamic> Z_, source_;
    bool factored_ = false;
    long looks_ = 0;
    std::string refuted_;
};

}  // namespace stagecraft::detail
