// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <string>
#include <vector>

#include <stagecraft/linear/norms.hpp>
#include <stagecraft/options.hpp>
#include <stagecraft/sensitivity/linear_stages.hpp>
#include <stagecraft/sensitivity/stage_derivatives.hpp>

namespace stagecraft {

/// What sensitivities() may be told beyond the options of the run.
template <class Vector, class Parameters>
struct sensitivity_options {
    using scalar = typename Vector::Scalar;
    using matrix = Eigen::Matrix<scalar, Vector::RowsAtCompileTime, Parameters::RowsAtCompileTime>;
    const matrix* S0 = nullptr;  ///< dy0/dp; null: zero
    /// true: the steps are such that the error of S is within its tolerances too, and not that of y alone. Of column k these
    /// are rtol |S_ik| + atol_i / scale_k.
    bool control = true;
    /// How much of a change of p_k matters, positive, one number per parameter; empty: |p_k|, and 1 where that is zero.
    numbers_of_components<scalar> scale{};
    /// Times at which y and S are kept, in the order of the run, between t0 and t1: they are those of the continuous
    /// solutions.
    std::vector<scalar> times{};
};

namespace detail {

/// dy/dp along a run: with each of its steps the same step of M S' = f_y S + f_p.
template <class Problem, class Vector>
class forward_steps {
    using scalar = typename Vector::Scalar;

  public:
    using parameters = typename Problem::parameters;
    using options_type = sensitivity_options<Vector, parameters>;
    using matrix = typename options_type::matrix;

    forward_steps(const Problem& problem, const Vector& y0, const options<scalar>& o, const matrix& S0,
                  const options_type& s)
        : at_(problem, y0, o),
          S_(S0),
          S1_(S0),
          scale_(problem.p),
          column_(y0),
          weights_(y0),
          error_(y0),
          left_(y0),
          controlled_(s.control && o.fixed_step == scalar(0) && at_.evaluations().largest_index() < 2) {
        using std::abs;
        for (Eigen::Index k = 0; k < scale_.size(); ++k)
            scale_[k] = s.scale.size() > 0          ? s.scale[k]
                        : problem.p[k] == scalar(0) ? scalar(1)
                                                    : scalar(abs(problem.p[k]));
    }

    const matrix& S() const { return S_; }
    matrix& S() { return S_; }
    /// At the beginning of the last step.
    const matrix& S_before() const { return S0_; }
    /// What the derivatives that the problem gives were seen to be wrong in; empty: nothing.
    const std::string& refuted() const { return refuted_; }
    /// The linear equations of an attempt could not be solved.
    bool unsolved() const { return unsolved_; }
    auto& derivatives() { return at_; }

    /// The error of S in an attempt whose stage equations are solved, in tolerances: by the estimate that the method makes
    /// of y, in each column, of which the largest counts. Not of problems of index 2 and 3: their estimates contain what
    /// earlier steps have left in the constraints, in S with another history than in y, and short steps make that worse.
    template <class System, class Method, class Step>
    scalar error(System& system, Method& method, const Step& step) {
        if (!controlled_) return scalar(0);
        auto now = step.now();
        method.finish(step.t, step.y(), step.h, step.y1(), now);
        if (!solve(method.stages(), now)) return refused();
        const int s = method.count();
        const scalar ratio = method.estimate_ratio(at_.tolerance());
        scalar largest(0);
        long solves = 0;
        auto column = step.now();
        for (Eigen::Index k = 0; k < S_.cols(); ++k) {
            column.increments().leftCols(s) = Z_.middleCols(k * s, s);
            weigh(k);
            const auto size = [&](const Vector& x, bool) {
                return weighted_norm(x, weights_, static_cast<int>(x.size()), system.sums());
            };
            scalar one(0);
            column_ = S_.col(k);
            for (int look = 0; look < 2; ++look) {  // once more filtered, as collocation_step::estimate_again
                at_(s, column_, static_cast<int>(k), left_);
                method.estimate(system, step.h, left_, column, error_);
                one = method.error_size(system, column, ratio, error_, solves, size);
                if (one < scalar(1)) break;
                column_ = S_.col(k) + error_;
            }
            if (!(one <= largest)) largest = one;
        }
        return largest;
    }

    /// Takes the step that `run` has just made; false if its linear equations could not be solved or its derivatives are
    /// refuted.
    template <class Run>
    bool step(Run& run) {
        const auto& output = run.output();
        if (!(solved_t_ == output.t0() && solved_h_ == output.step() && solved_)) {
            if (!run.visit_last([&](auto& method) { return solve(method.stages(), output); })) {
                unsolved_ = true;
                return false;
            }
        }
        solved_ = false;
        refuted_ = at_.refuted(static_cast<int>(looks_++ % (at_.points() - 1)));
        S0_ = S_;
        S_ = S1_;
        return refuted_.empty();
    }

    /// S within the step that has been taken last, by the polynomial through its stages.
    template <class Output>
    matrix at(const Output& output, const scalar& t) const {
        const int s = at_.points() - 1;
        std::vector<scalar> l(static_cast<std::size_t>(output.nodes().size));
        output.nodes().basis((t - output.t0()) / output.step(), l.data());
        matrix result = S0_;
        for (Eigen::Index k = 0; k < S_.cols(); ++k)
            for (int j = 0; j < output.nodes().size; ++j)
                result.col(k) +=
                    l[static_cast<std::size_t>(j)] * Z_.col(k * s + output.nodes().first_column + j);
        return result;
    }

  private:
    /// Solves the stage equations of all columns with the factors that `stages` has; S1_ is what follows.
    template <class Stages, class Output>
    bool solve(Stages& stages, const Output& output) {
        const int s = stages.stages();
        at_.place(stages.method(), stages.method().A_inverse, output);
        at_.evaluate();
        at_.relative_weights(output.y0(), weights_);
        const auto d = update_weights(stages.method());
        Z_.resize(S_.rows(), s * S_.cols());
        one_.resize(S_.rows(), s);
        solved_ = false;
        const Vector weights = weights_;
        for (Eigen::Index k = 0; k < S_.cols(); ++k) {
            column_ = S_.col(k);
            const auto add = [&](int i, const Vector& v, Vector& f) { at_(i, v, static_cast<int>(k), f); };
            if (!solve_linear_stages(stages, at_.mass(), add, column_, output.step(), weights,
                                     at_.tolerance(), one_))
                return false;
            for (int j = 0; j < s; ++j) column_ += d[j] * one_.col(j);
            S1_.col(k) = column_;
            Z_.middleCols(k * s, s) = one_;
        }
        solved_ = true;
        solved_t_ = output.t0();
        solved_h_ = output.step();
        unsolved_ = false;
        return true;
    }
    /// The weights of column k, from the larger of S at both ends.
    void weigh(Eigen::Index k) {
        using std::abs;
        const auto& o = at_.given_options();
        for (Eigen::Index i = 0; i < S_.rows(); ++i) {
            const scalar a = abs(S_(i, k)), b = abs(S1_(i, k));
            weights_[i] = scalar(1) / (absolute_tolerance(o, i) / scale_[k] + o.rtol * (a < b ? b : a));
        }
    }
    scalar refused() {
        unsolved_ = true;
        return scalar(1000000);
    }

    forward_derivatives<Problem, Vector> at_;
    matrix S_, S0_, S1_;  // at the end, at the beginning of the last step, and at the end of what is tried
    parameters scale_;
    Vector column_, weights_, error_, left_;
    Eigen::Matrix<scalar, Vector::RowsAtCompileTime, Eigen::Dynamic> Z_, one_;  // s stages a column of S
    bool controlled_, solved_ = false, unsolved_ = false;
    scalar solved_t_{0}, solved_h_{0};
    long looks_ = 0;
    std::string refuted_;
};

/// A problem at its parameters that lets the steps be judged by sensitivities as well.
template <class Problem, class Parameters, class Vector>
struct with_sensitivities : at_parameters<Problem, Parameters> {
    using at_parameters<Problem, Parameters>::at_parameters;
    forward_steps<with_sensitivities, Vector>* along = nullptr;

    template <class System, class Method, class Step>
    typename Vector::Scalar further_error(System& system, Method& method, const Step& step) const {
        return along->error(system, method, step);
    }
};

}  // namespace detail

}  // namespace stagecraft
