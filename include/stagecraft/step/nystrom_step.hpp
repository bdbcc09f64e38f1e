// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <type_traits>

#include <stagecraft/dense_output.hpp>
#include <stagecraft/method/nystrom_method.hpp>
#include <stagecraft/method/nystrom_trees.hpp>
#include <stagecraft/method/remembered.hpp>
#include <stagecraft/problem/second_order.hpp>
#include <stagecraft/step/method_set.hpp>
#include <stagecraft/step/step_between_slopes.hpp>

namespace stagecraft {

/// One step of a Nystrom method: s evaluations of f, one less where the last stage is the next step's first. Estimate:
/// h^2 sum (b_bar - b_bar_embedded) k in q and h sum (b - b_embedded) k in v, of the order of the weaker of the two
/// methods, which is found from the N-trees up to order 9 (6 with f(t, q, v)).
///
/// Method: nystrom_method or velocity_nystrom_method.
template <class Method, class Space>
class nystrom_step : public step_between_slopes<Space, hermite_output<Space>::quintic_columns> {
    using base = step_between_slopes<Space, hermite_output<Space>::quintic_columns>;
    using base::left_, base::right_, base::output_, base::output_wanted_;  // slopes (v, a)
    using Scalar = typename Space::scalar;
    static constexpr int Stages = Method::stages_at_compile_time;
    static constexpr bool may_use_velocity = requires(const Method& m) { m.A; };

  public:
    using vector = typename Space::vector;
    using output = typename Space::output;
    using part = detail::part_of<vector>;

    nystrom_step(const Method& method, int n)
        : base(n), m_(method), n_(n / 2), K_(n / 2, method.stages()), q_(n / 2), v_(n / 2), a_(n / 2) {
        detail::check_nystrom(m_, velocity_matrix());
        K_.setZero();
        v_.setZero();
        as_tableau_.A = m_.A_bar;
        as_tableau_.b = m_.b;
        as_tableau_.c = m_.c;
        as_tableau_.b_embedded = m_.b_embedded;
        const int s = m_.stages();
        const auto is_row = [&](int i, const auto& weights_bar, const auto& weights, const Scalar& c) {
            bool same = m_.c[i] == c;
            for (int j = 0; j < s; ++j) {
                same = same && m_.A_bar(i, j) == weights_bar[j];
                if (has_velocity()) same = same && velocity_matrix()(i, j) == weights[j];
            }
            return same;
        };
        const typename Method::vector zero = Method::vector::Zero(s);
        begins_left_ = is_row(0, zero, zero, Scalar(0));
        ends_right_ = s > 1 && is_row(s - 1, m_.b_bar, m_.b, Scalar(1));
    }

    template <class System>
    void prepare(const System&, const run_demands& demands) {
        using problem = typename System::problem_type;
        constexpr bool of_second_order = second_order_right_hand_side<problem, part>;
        static_assert(
            of_second_order,
            "integrate: a Nystrom method needs second_order(f) of stagecraft/nystrom.hpp, with f(t, "
            "q) for q'' = f and the state (q, v)");
        if constexpr (of_second_order) {
            constexpr bool velocity = problem::template uses_velocity<part>;
            constexpr bool suits = may_use_velocity || !velocity;
            static_assert(
                suits,
                "integrate: this Nystrom method is for q'' = f(t, q): with f(t, q, v) it would have "
                "order 1; take one with velocity terms, nystrom_4() say, or a Runge-Kutta tableau");
            if (velocity && !has_velocity())
                throw std::invalid_argument(
                    "integrate: this Nystrom method is for q'' = f(t, q): with f(t, q, v) it would have "
                    "order 1; take one with A, or a Runge-Kutta tableau");
            uses_velocity_ = velocity;
        }
        if constexpr (!System::mass_type::identity)
            throw std::invalid_argument("integrate: a Nystrom method does not serve a problem with mass()");
        output_wanted_ = demands.output;
        if (demands.fixed) return;
        if (m_.b_embedded.size() == 0)
            throw std::invalid_argument(
                "integrate: method has no embedded weights to estimate errors with; use options.fixed_step");
        power_ = remembered(as_tableau_, [&] { return find_power(); });
        if (power_ == 1)
            throw std::invalid_argument(
                "integrate: method.b_bar_embedded and b_embedded are of order 0: use options.fixed_step");
    }

    nystrom_step& stages() { return *this; }
    /// A_bar, b, c and b_embedded, by which a checkpoint knows the method again.
    const tableau<Scalar, Stages>& method() const { return as_tableau_; }
    int count() const { return m_.stages(); }
    int order() const { return m_.order; }
    int estimate_power() const { return power_; }
    bool implicit() const { return false; }
    static constexpr bool iterates() { return false; }

    bool needs_left_value(bool) const { return !left_known_ && (begins_left_ || output_wanted_); }
    void begin(const vector& f0) {
        if (needs_left_value(true)) left_ = f0;
    }
    bool ends_with_value() const { return output_wanted_ && !ends_right_; }

    template <class System, class Norm>
    newton_outcome<Scalar> solve(System& system, const Scalar& t, const vector& y, const Scalar& h,
                                 const Norm&, const newton_limits<Scalar>&, typename output::stage_matrix&,
                                 long&) {
        newton_outcome<Scalar> done;
        done.end = newton_end::converged;
        if constexpr (second_order_right_hand_side<typename System::problem_type, part>)
            for (int i = 0; i < count(); ++i) {
                if (i == 0 && begins_left_) {
                    K_.col(0) = left_.tail(n_);
                    continue;
                }
                q_ = y.head(n_) + (h * m_.c[i]) * y.tail(n_);
                add(
                    h * h, [&](int j) { return m_.A_bar(i, j); }, i, q_);
                if (uses_velocity_ && has_velocity()) {
                    v_ = y.tail(n_);
                    add(
                        h, [&](int j) { return velocity_matrix()(i, j); }, i, v_);
                }
                system.evaluate_part(
                    [&](auto& problem) { problem.acceleration(Scalar(t + m_.c[i] * h), q_, v_, a_); }, true);
                K_.col(i) = a_;
            }
        return done;
    }
    void guess(const output*, const vector&, const Scalar& h, output&, const Scalar& = Scalar(1)) { h_ = h; }
    void advance(const vector& y, const output&, vector& y1) {
        q_ = y.head(n_) + h_ * y.tail(n_);
        add(
            h_ * h_, [&](int j) { return m_.b_bar[j]; }, count(), q_);
        a_ = y.tail(n_);
        add(
            h_, [&](int j) { return m_.b[j]; }, count(), a_);
        y1.head(n_) = q_;
        y1.tail(n_) = a_;
        if (ends_right_) {
            right_.head(n_) = a_;
            right_.tail(n_) = K_.col(count() - 1);
        }
    }
    void finish(const Scalar& t, const vector& y, const Scalar& h, const vector& y1, output& now) {
        output_.quintic(t, y, h, y1, left_, right_, now);
    }
    void accepted() {
        left_known_ = ends_right_ || ends_with_value();
        if (left_known_) left_ = right_;
    }
    void replaced() { left_known_ = false; }

    template <class System>
    int estimate(const System&, const Scalar& h, const vector&, const output&, vector& error) {
        q_.setZero();
        add(
            h * h, [&](int j) { return m_.b_bar[j] - m_.b_bar_embedded[j]; }, count(), q_);
        error.head(n_) = q_;
        q_.setZero();
        add(
            h, [&](int j) { return m_.b[j] - m_.b_embedded[j]; }, count(), q_);
        error.tail(n_) = q_;
        return 0;
    }

    template <class Bag>
    void carry(Bag& bag) {
        bag(left_, left_known_);
    }

  private:
    using column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    using square = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

    const auto& velocity_matrix() const {
        if constexpr (may_use_velocity)
            return m_.A;
        else
            return no_matrix_;
    }
    bool has_velocity() const { return velocity_matrix().size() > 0; }

    /// One more than the order of the weaker of the two methods.
    int find_power() const {
        const nystrom_trees<Scalar> trees(m_.c, m_.A_bar, square(velocity_matrix()), has_velocity() ? 6 : 9);
        const int main = trees.order(m_.b_bar, m_.b), other = trees.order(m_.b_bar_embedded, m_.b_embedded);
        return (main < other ? main : other) + 1;
    }
    /// x += factor sum_j weight(j) k_j.
    template <class Weight>
    void add(const Scalar& factor, const Weight& weight, int count, part& x) const {
        for (int j = 0; j < count; ++j) {
            const Scalar w = factor * weight(j);
            if (!(w == Scalar(0))) x += w * K_.col(j);
        }
    }

    Method m_;
    square no_matrix_;
    tableau<Scalar, Stages> as_tableau_;
    int n_, power_ = 1;
    Eigen::Matrix<Scalar, part::RowsAtCompileTime, Stages> K_;
    part q_, v_, a_;
    Scalar h_{0};
    bool begins_left_ = false,
         ends_right_ = false;  // the first stage is the left end, the last one the right end
    bool uses_velocity_ = false, left_known_ = false;
};

namespace detail {

template <class Scalar, int Stages>
struct step_for<nystrom_method<Scalar, Stages>> {
    static constexpr bool named = true;
    static constexpr int columns = 5;
    template <class Space>
    using type = nystrom_step<nystrom_method<Scalar, Stages>, Space>;
};
template <class Scalar, int Stages>
struct step_for<velocity_nystrom_method<Scalar, Stages>> {
    static constexpr bool named = true;
    static constexpr int columns = 5;
    template <class Space>
    using type = nystrom_step<velocity_nystrom_method<Scalar, Stages>, Space>;
};

}  // namespace detail

}  // namespace stagecraft
