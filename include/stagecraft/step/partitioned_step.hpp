// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <stagecraft/dense_output.hpp>
#include <stagecraft/method/partitioned_method.hpp>
#include <stagecraft/problem/partition.hpp>
#include <stagecraft/stages/partitioned_stages.hpp>
#include <stagecraft/step/method_set.hpp>
#include <stagecraft/step/step_between_slopes.hpp>

namespace stagecraft {

/// One step of a pair of tableaux. The stages of a separable problem are evaluated one after the other where each depends on
/// evaluated ones alone (Stoermer-Verlet, symplectic Euler, Ruth, Forest-Ruth), and so are those of two strictly
/// lower triangular A; else all are solved together by simplified Newton with one factorisation of size 2 n s, down to
/// rounding. f is evaluated at the times t + h sum_j a^_ij and g at t + h sum_j a_ij in separable problems, both at
/// the latter in others: what the orders hold for, as t is one more component of q, and of p.
///
/// `separable_only`: the pair is a separable_method.
template <int Stages, class Space, bool separable_only>
class partitioned_step : public step_between_slopes<Space> {
    using Scalar = typename Space::scalar;
    using base = step_between_slopes<Space>;
    using base::left_, base::right_, base::output_wanted_;

  public:
    using vector = typename Space::vector;
    using output = typename Space::output;
    using method_type = partitioned_method<Scalar, Stages>;
    using part = detail::part_of<vector>;

    partitioned_step(const method_type& method, int n)
        : base(n),
          pair_(method),
          n_(n / 2),
          explicit_(strictly_lower(method.first) && strictly_lower(method.second)),
          order_(explicit_order(method.first, method.second)),
          systems_(method.stages(), n),
          c_(times(method.first)),
          c_hat_(times(method.second)),
          K_(n, method.stages()),
          last_K_(n, method.stages()),
          y_(n),
          f_(n),
          kept_(n),
          part_(n / 2),
          rate_(n / 2) {
        K_.setZero();
        last_K_.setZero();
        kept_.setZero();
        x_.resize(static_cast<std::size_t>(n * method.stages()));
        find_last();
    }

    template <class System>
    void prepare(const System& system, const run_demands& demands) {
        using problem = typename System::problem_type;
        constexpr bool given_parts = partitioned_right_hand_side<problem, part>;
        static_assert(
            given_parts,
            "integrate: a pair of tableaux needs a problem in two parts: partition(f, g) for q' = f, "
            "p' = g, or hamiltonian<n>(H), both of stagecraft/partitioned.hpp");
        if constexpr (given_parts) {
            constexpr bool suits = !separable_only || problem::template separable<part>;
            static_assert(
                suits,
                "integrate: the order of this pair holds for separable problems alone: partition(f, "
                "g) of f(t, p) and g(t, q), or hamiltonian<n>(T, V); take a pair of lobatto_iiia and "
                "lobatto_iiib, or gauss, for others");
            separable_ = problem::template separable<part>;
        }
        if constexpr (!System::mass_type::identity)
            throw std::invalid_argument("integrate: a pair of tableaux does not serve a problem with mass()");
        if (system.size() % 2 != 0)
            throw std::invalid_argument(
                "integrate: y0 = (q, p) must have an even number of components, as many q as p");
        if (pair_.separable && !separable_)
            throw std::invalid_argument(
                "integrate: the order of this pair holds for separable problems alone: partition(f, g) of "
                "f(t, p) and g(t, q), or hamiltonian<n>(T, V)");
        if (!demands.fixed)
            throw std::invalid_argument(
                "integrate: a pair of tableaux has no error estimate: give options.fixed_step");
        explicit_ = separable_ ? !order_.empty() : explicit_;
        output_wanted_ = demands.output;
    }

    partitioned_step& stages() { return *this; }
    /// The first of the two, by which a checkpoint knows the pair again.
    const tableau<Scalar, Stages>& method() const { return pair_.first; }
    int count() const { return pair_.stages(); }
    int order() const { return pair_.first.facts.order; }
    int coupled_stages_count() const { return count(); }
    bool implicit() const { return !explicit_; }
    bool iterates() const { return implicit(); }

    template <class System>
    bool factor(const System& system, const Scalar& h) {
        return system.measure(work::factorisation,
                              [&] { return systems_.factor(system, h, pair_.first, pair_.second); });
    }
    template <class System, class Norm>
    newton_outcome<Scalar> solve(System& system, const Scalar& t, const vector& y, const Scalar& h,
                                 const Norm& norm, const newton_limits<Scalar>& limits,
                                 typename output::stage_matrix&, long& solves) {
        if constexpr (!partitioned_right_hand_side<typename System::problem_type, part>) {
            return {};
        } else {
            if (!explicit_) return solve_together(system, t, y, h, norm, limits, solves);
            if (separable_)
                for (const part_evaluation& e : order_) evaluate(system, t, y, h, e);
            else
                for (int i = 0; i < count(); ++i) {
                    find_stage(y, h, i);
                    system(t + c_[i] * h, y_, f_);
                    K_.col(i) = f_;
                }
            newton_outcome<Scalar> done;
            done.end = newton_end::converged;
            return done;
        }
    }

    /// First guess: the slopes of the step before as a polynomial of the nodes, where these are distinct, else those of the
    /// last solution.
    void guess(const output*, const vector&, const Scalar& h, output&, const Scalar& = Scalar(1)) {
        h_ = h;
        if (explicit_ || !known_) return;
        const Scalar ratio = h / last_h_;
        for (int i = 0; i < count(); ++i) {
            K_.col(i).setZero();
            for (int j = 0; j < count(); ++j)
                K_.col(i) += lagrange(j, Scalar(1) + c_[i] * ratio) * last_K_.col(j);
        }
    }
    void advance(const vector& y, const output&, vector& y1) {
        y1 = y;
        for (int j = 0; j < count(); ++j) {
            const Scalar b = h_ * pair_.first.b[j], b_hat = h_ * pair_.second.b[j];
            if (!(b == Scalar(0))) y1.head(Eigen::fix<half>(n_)) += b * K_.col(j).head(Eigen::fix<half>(n_));
            if (!(b_hat == Scalar(0)))
                y1.tail(Eigen::fix<half>(n_)) += b_hat * K_.col(j).tail(Eigen::fix<half>(n_));
        }
    }
    void accepted() {
        known_ = true;
        if (!explicit_) {
            last_K_ = K_;
            last_h_ = h_;
        } else if (first_is_last_) {
            kept_ = K_.col(last_.stage);
        }
    }
    void replaced() { known_ = false; }

    template <class Bag>
    void carry(Bag& bag) {
        bag(known_, last_h_, kept_);
        for (int j = 0; j < count(); ++j) {
            auto column = last_K_.col(j);
            bag(column);
        }
    }

  private:
    static constexpr int half = part::RowsAtCompileTime;
    using slopes = Eigen::Matrix<Scalar, vector::RowsAtCompileTime, Stages>;
    using per_stage = Eigen::Matrix<Scalar, Stages, 1>;

    /// The row sums of A, or c where they are equal but for rounding.
    static per_stage times(const tableau<Scalar, Stages>& m) {
        using std::abs;
        per_stage c = m.c;
        for (int i = 0; i < m.stages(); ++i) {
            Scalar sum(0), size(1);
            for (int j = 0; j < m.stages(); ++j) sum += m.A(i, j), size += abs(m.A(i, j));
            if (!(abs(sum - m.c[i]) <= 8 * std::numeric_limits<Scalar>::epsilon() * size)) c[i] = sum;
        }
        return c;
    }

    /// Looks for an evaluation at the end of the step that is the first one of the next: g at q1, or f at p1.
    void find_last() {
        if (order_.empty()) return;
        for (const part_evaluation& e : order_) {
            if (e.from >= 0) continue;
            const auto& m = e.of_q ? pair_.second : pair_.first;
            const auto& c = e.of_q ? c_hat_ : c_;
            bool left = c[e.stage] == Scalar(0), right = c[e.stage] == Scalar(1);
            for (int j = 0; j < count(); ++j) {
                left = left && m.A(e.stage, j) == Scalar(0);
                right = right && m.A(e.stage, j) == m.b[j];
            }
            if (left) first_ = e, has_first_ = true;
            if (right && has_first_ && first_.of_q == e.of_q) last_ = e, first_is_last_ = true;
        }
    }

    /// y_ := (Q_i, P_i).
    void find_stage(const vector& y, const Scalar& h, int i) {
        y_ = y;
        for (int j = 0; j < count(); ++j) {
            const Scalar a = h * pair_.first.A(i, j), a_hat = h * pair_.second.A(i, j);
            if (!(a == Scalar(0))) y_.head(Eigen::fix<half>(n_)) += a * K_.col(j).head(Eigen::fix<half>(n_));
            if (!(a_hat == Scalar(0)))
                y_.tail(Eigen::fix<half>(n_)) += a_hat * K_.col(j).tail(Eigen::fix<half>(n_));
        }
    }
    /// One part of one stage.
    template <class System>
    void evaluate(System& system, const Scalar& t, const vector& y, const Scalar& h,
                  const part_evaluation& e) {
        const auto slope = [&](int j) {
            return e.of_q ? K_.col(j).head(Eigen::fix<half>(n_)) : K_.col(j).tail(Eigen::fix<half>(n_));
        };
        if (e.from >= 0) {
            slope(e.stage) = slope(e.from);
            return;
        }
        if (known_ && first_is_last_ && e.of_q == first_.of_q && e.stage == first_.stage) {
            slope(e.stage) = e.of_q ? kept_.head(Eigen::fix<half>(n_)) : kept_.tail(Eigen::fix<half>(n_));
            return;
        }
        const auto& m = e.of_q ? pair_.second : pair_.first;
        part_ = e.of_q ? y.tail(Eigen::fix<half>(n_)) : y.head(Eigen::fix<half>(n_));
        for (int j = 0; j < count(); ++j) {
            const Scalar a = h * m.A(e.stage, j);
            if (a == Scalar(0)) continue;
            if (e.of_q)
                part_ += a * K_.col(j).tail(Eigen::fix<half>(n_));
            else
                part_ += a * K_.col(j).head(Eigen::fix<half>(n_));
        }
        evaluate_part(system, t, h, e);
        slope(e.stage) = rate_;
    }
    /// rate_ := f or g of stage e at part_.
    template <class System>
    void evaluate_part(System& system, const Scalar& t, const Scalar& h, const part_evaluation& e) {
        const Scalar time = t + (e.of_q ? c_hat_ : c_)[e.stage] * h;
        system.evaluate_part(
            [&](auto& problem) {
                if constexpr (std::remove_reference_t<decltype(problem)>::template separable<part>) {
                    if (e.of_q)
                        problem.q_rate(time, part_, rate_);
                    else
                        problem.p_rate(time, part_, rate_);
                }
            },
            !e.of_q);
    }

    template <class System, class Norm>
    newton_outcome<Scalar> solve_together(System& system, const Scalar& t, const vector& y, const Scalar& h,
                                          const Norm& norm, const newton_limits<Scalar>& limits,
                                          long& solves) {
        newton_monitor<Scalar> monitor(down_to_rounding(limits));
        const int s = count(), n = 2 * n_;
        Scalar* x = x_.data();
        while (monitor.may_go_on()) {
            for (int i = 0; i < s; ++i) {
                find_stage(y, h, i);
                if (separable_) {
                    part_ = y_.tail(Eigen::fix<half>(n_));
                    evaluate_part(system, t, h, {true, i, -1});
                    f_.head(Eigen::fix<half>(n_)) = rate_;
                    part_ = y_.head(Eigen::fix<half>(n_));
                    evaluate_part(system, t, h, {false, i, -1});
                    f_.tail(Eigen::fix<half>(n_)) = rate_;
                } else {
                    system(t + c_[i] * h, y_, f_);
                }
                for (int r = 0; r < n; ++r) x[i * n + r] = f_[r] - K_(r, i);
            }
            system.measure(work::solve, [&] { systems_.solve(x); });
            ++solves;
            for (int i = 0; i < s; ++i)
                for (int r = 0; r < n; ++r) K_(r, i) += x[i * n + r];
            if (monitor.over(change(h, norm))) break;
        }
        if (monitor.outcome().end != newton_end::converged) known_ = false, K_.setZero();
        return monitor.outcome();
    }
    /// The largest change of a stage, or of y1, from the increments of the slopes.
    template <class Norm>
    Scalar change(const Scalar& h, const Norm& norm) {
        const int s = count(), n = 2 * n_;
        Scalar largest(0);
        for (int i = 0; i <= s; ++i) {
            f_.setZero();
            for (int j = 0; j < s; ++j)
                for (int r = 0; r < n; ++r) {
                    const auto& m = r < n_ ? pair_.first : pair_.second;
                    f_[r] += h * (i < s ? m.A(i, j) : m.b[j]) * x_[j * n + r];
                }
            const Scalar size = norm(f_);
            if (!(size <= largest)) largest = size;
        }
        return largest;
    }
    /// l_j(x) on the nodes c; where two of them are equal, 1 for the last stage alone.
    Scalar lagrange(int j, const Scalar& x) const {
        Scalar value(1);
        for (int m = 0; m < count(); ++m)
            for (int k = 0; k < m; ++k)
                if (c_[m] == c_[k]) return Scalar(j + 1 == count() ? 1 : 0);
        for (int m = 0; m < count(); ++m)
            if (m != j) value *= (x - c_[m]) / (c_[j] - c_[m]);
        return value;
    }

    method_type pair_;
    int n_;
    bool explicit_;
    std::vector<part_evaluation> order_;
    partitioned_systems<Scalar> systems_;
    per_stage c_, c_hat_;
    slopes K_, last_K_;  // columns (k_i, l_i), of this step and of the one before
    vector y_, f_, kept_;
    part part_, rate_;
    std::vector<Scalar> x_;
    part_evaluation first_, last_;
    Scalar h_{0}, last_h_{1};
    bool separable_ = false, known_ = false, has_first_ = false, first_is_last_ = false;
};

namespace detail {

template <class Scalar, int Stages>
struct step_for<partitioned_method<Scalar, Stages>> {
    static constexpr bool named = true;
    static constexpr int columns = 3;
    template <class Space>
    using type = partitioned_step<Stages, Space, false>;
};
template <class Scalar, int Stages>
struct step_for<separable_method<Scalar, Stages>> {
    static constexpr bool named = true;
    static constexpr int columns = 3;
    template <class Space>
    using type = partitioned_step<Stages, Space, true>;
};

}  // namespace detail

}  // namespace stagecraft
