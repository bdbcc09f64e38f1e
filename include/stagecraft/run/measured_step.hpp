// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include <stagecraft/judge/evidence.hpp>
#include <stagecraft/linear/mass.hpp>
#include <stagecraft/linear/mass_kernel.hpp>
#include <stagecraft/method/blind_spots.hpp>
#include <stagecraft/report.hpp>
#include <stagecraft/run/end_slope.hpp>
#include <stagecraft/run/step_plan.hpp>
#include <stagecraft/run/watched_components.hpp>
#include <stagecraft/stages/newton.hpp>

namespace stagecraft {

/// An attempt at a step from (t, y) to (t1, y1) whose stage equations are solved: its facts, and what the judge and its guards
/// may ask to be measured: vectors in, numbers out, in the norm whose tolerance is 1. Nothing is measured that is not asked
/// for, and each question is put once.
template <class Method, class System, class Norm>
class measured_step : public step_facts<typename System::scalar> {
    using scalar = typename System::scalar;
    using vector = typename Method::vector;
    using output = typename Method::output;

  public:
    /// `now` holds the stages, later the continuous solution; f what is known at one of the ends; error is room for
    /// estimates.
    measured_step(Method& m, System& system, const Norm& norm, const vector& y, const output& now,
                  end_slope<vector>& f, vector& y1, vector& error, report<scalar>& counts)
        : method_(m),
          system_(system),
          norm_(norm),
          y_(y),
          now_(now),
          f_(f),
          y1_(y1),
          error_(error),
          counts_(counts) {
        this->stages = m.count();
        this->power = m.estimate_power();
        this->index = system.largest_index();
        this->usual_iterations = stagecraft::usual_iterations(m.coupled_stages_count());
    }

    /// Where the attempt begins, how it has been planned, with which method, and what has been refused before.
    void begins(const scalar& from, const planned_step<scalar>& plan, int method_number,
                const refusals<scalar>& before, bool first_of_run) {
        this->t = from;
        this->h = plan.h;
        this->t_next = plan.t_next;
        this->smallest = plan.smallest;
        this->method = method_number;
        this->refused = before;
        this->first = first_of_run;
    }

    // Estimates of the error at the end of the step.

    /// The method's estimate; with components of index 2 and 3, compared with the state at the start as well.
    [[gnu::always_inline]] scalar estimate() {
        counts_.error_solves += method_.estimate(system_, this->h, f_.value(), now_, error_);
        if (this->index > 1) {
            const scalar s = scalar(this->power - 1);
            method_.compare_with_start(system_, now_, s / (s + scalar(1)) / this->share, error_);
        }
        return last_ = size();
    }
    /// The same once more filtered.
    [[gnu::cold]] scalar estimate_again() {
        this->once = last_;
        counts_.error_solves += method_.estimate_again(system_, this->t, y_, this->h, now_, y1_, error_);
        if (this->first && this->refused.all > 0) method_.without_start(system_, now_, error_);
        method_.advance(y_, now_, y1_);
        return size();
    }
    /// The one that is made at the right end, 0 where there is none.
    [[gnu::always_inline]] scalar estimate_right() {
        if (!method_.needs_right_value()) return scalar(0);
        const auto& f1 = f_.right(system_, this->t_next, y1_);
        const int solves = method_.estimate_right(system_, this->h, f1, now_, error_);
        counts_.error_solves += solves;
        return solves > 0 ? scalar(norm_(error_) * method_.right_ratio(this->ratio)) : scalar(0);
    }
    /// The size of the estimate made last, as step.ratio and step.share have it now.
    [[gnu::always_inline]] scalar size() {
        return method_.error_size(
            system_, now_, this->ratio, error_, counts_.error_solves,
            [this](const vector& x, bool reduced) { return reduced ? follow(x) : judged(x); });
    }
    /// The same if this step had made all of the estimate in components of index 2 and 3.
    scalar size_with_share_one() const { return norm_.shared(error_, of_index(scalar(1))) * this->ratio; }
    /// The error of what the problem carries along, where it is more than y (system::further_error).
    scalar further() { return system_.further_error(method_, *this); }

    // What guards ask.

    /// What the estimate changes by where every increment of the stages does by a rounding of y, up and down in turn.
    [[gnu::cold]] scalar rounding_of_estimate() {
        using std::abs;
        auto rounded = now_;
        auto& Z = rounded.increments();
        for (int j = 0; j < Z.cols(); ++j)
            for (int i = 0; i < Z.rows(); ++i) {
                const scalar ulp = std::numeric_limits<scalar>::epsilon() * (abs(y_[i]) + abs(Z(i, j)));
                Z(i, j) += (i + j) % 2 == 0 ? ulp : -ulp;
            }
        const vector kept = error_;
        counts_.error_solves += method_.estimate(system_, this->h, f_.value(), rounded, error_);
        const vector other = error_;
        counts_.error_solves += method_.estimate(system_, this->h, f_.value(), now_, error_);
        error_ -= other;
        const scalar change = norm_(error_) * this->ratio;
        error_ = kept;
        return change;
    }
    /// The longest step that the run has taken.
    const scalar& longest() const { return counts_.largest_step; }
    /// The step is accepted because its error is no more than that.
    void count_at_rounding() { ++counts_.at_rounding; }

    /// False where no component can have an index above 1: known to the compiler.
    static constexpr bool may_have_index() { return System::may_be_raised; }
    bool estimates_from_start() const { return method_.estimates_from_start(); }
    static constexpr bool has_identity_mass() { return System::mass_type::identity; }
    /// What an estimate of 1 stands for across a jump of f.
    scalar ratio_across_jump() const { return method_.jump_ratio(this->smooth); }
    /// True if some component of y' is the same at all nodes, and not zero; on any process.
    bool has_constant_slope() {
        scalar seen(method_.sees_constant_slope(now_) ? 1 : 0);
        norm_.sums()(&seen, 1);
        return seen > scalar(0);
    }
    /// The number of the method's blind spots for jumps of f, the power of h by which the combinations of slopes fall that
    /// see them where f is smooth, and whether the slopes are known.
    int blind_spots() const { return method_.blind_spot_count(); }
    int power_at_blind_spots() const { return method_.blind_spot_power(); }
    bool knows_slopes() const { return method_.knows_slopes(); }
    /// The largest of these combinations. Contributions of stiff components are no jump, or die out with time: where they
    /// matter, above `notable`, the method's own filter removes them, applied twice.
    scalar sign_at_blind_spots(const scalar& notable) {
        scalar largest(0);
        for (int g = 0; g < blind_spots(); ++g) {
            method_.weigh_slopes(g, this->h, error_);
            scalar next = judged(error_);
            for (int k = 0; k < 2 && next > notable && method_.damp(system_, error_); ++k) {
                ++counts_.error_solves;
                next = judged(error_);
            }
            largest = larger(largest, next);
        }
        return largest;
    }
    /// About the largest error of the continuous solution over the step.
    bool knows_output_error() const { return method_.knows_output_error(); }
    scalar output_error() { return method_.output_error(now_, norm_); }
    /// (M/(h a) - J)^-1 of the defect of the continuous solution in the middle of the widest gap between nodes and ends.
    /// Algebraic components, whose start need not be consistent, are left out: the solve takes what they do to the others
    /// away. One evaluation of f, one solve.
    [[gnu::cold]] scalar error_between_nodes() {
        if (!method_.implicit()) return scalar(0);
        find_error_between();
        drop_algebraic(system_.mass(), error_);
        return norm_(error_);
    }
    /// The same of all components (`all`), or of those that are watched between the ends of the steps.
    scalar watched_error_between(bool all) {
        find_error_between();
        return all ? norm_(error_) : only_watched().weigh(error_);
    }
    /// Components that M leaves algebraic are looked at between the ends of the steps (run/watched_components.hpp).
    bool is_watched_between() const { return has_identity_mass() ? false : watched_ != nullptr; }
    scalar watched_output_error() { return method_.output_error(now_, only_watched()); }
    void watch(const watched_components<vector>& components) { watched_ = &components; }

  private:
    /// Only where there are such components.
    typename watched_components<vector>::template norm<typename Norm::sums_type> only_watched() const {
        return watched_->of(norm_);
    }
    /// error_ := (M/(h a) - J)^-1 of the defect between the nodes.
    void find_error_between() {
        auto u = now_;
        method_.finish(this->t, y_, this->h, y1_, u);
        const scalar between = this->t + this->h * farthest_from(u.nodes());
        system_.evaluate(between, u(between), error_);
        system_.add_explicit_part(between, u(between), error_);
        const vector slope = u.derivative(between);
        add_mass_times(system_.mass(), scalar(-1), slope.data(), error_.data(), system_.size());
        counts_.error_solves += method_.solve_for_defect(system_, this->h, error_);
    }

  public:
    // What the choice among several methods asks.

    scalar decay() { return method_.decay(now_, norm_); }
    auto linear_work() { return method_.stages().linear_work(system_); }

    // What the problem asks for what it carries along (further_error).

    const vector& y() const { return y_; }
    const vector& y1() const { return y1_; }
    const output& now() const { return now_; }

  private:
    /// What an estimate of which this step has made the share `made` counts in components of index 2 and 3, whose errors are
    /// of its own order.
    scalar of_index(const scalar& made) const {
        return made * (least_ratio_of_index(this->ratio, this->index) / this->ratio);
    }
    scalar judged(const vector& x) const {
        if (!may_have_index() || this->index < 2) return norm_(x);
        return norm_.shared(x, method_.estimates_from_start() ? of_index(this->share) : scalar(1));
    }
    /// The size of x in components of index 1, whose order reduction the step control can follow. (The estimates of the
    /// others contain the violation of the constraints that earlier steps have left, divided by h and h^2; smaller steps
    /// do not reduce it. Their own weights account for their lower orders.)
    scalar follow(const vector& x) const { return norm_.shared(x, scalar(0)); }

    /// The middle of the widest gap between 0, the nodes and 1.
    template <class Nodes>
    static scalar farthest_from(const Nodes& nodes) {
        scalar widest(0), middle(0);
        for (int i = -1; i < nodes.size; ++i) {
            const scalar left = i < 0 ? scalar(0) : nodes.c[i];
            scalar right(1);
            for (int j = 0; j < nodes.size; ++j)
                if (nodes.c[j] > left && nodes.c[j] < right) right = nodes.c[j];
            if (right - left > widest) widest = right - left, middle = (left + right) / 2;
        }
        return middle;
    }
    /// Takes out of x the components whose column of M is zero (where its entries are not known, whose row sum is); of an
    /// attempt that has been refused before, all that M takes to zero.
    template <class Mass>
    void drop_algebraic(const Mass& mass, vector& x) const {
        const int n = static_cast<int>(x.size());
        if constexpr (!Mass::identity) {
            vector size = vector::Zero(n);
            if constexpr (has_entries<Mass>) {
                if (this->refused.all > 0) return mass_kernel<scalar>(mass, n).remove(x);
                for (const auto& e : mass.entries()) size[e.column] = scalar(1);
            } else {
                const vector ones = vector::Ones(n);
                add_mass_times(mass, scalar(1), ones.data(), size.data(), n);
            }
            for (int i = 0; i < n; ++i)
                if (size[i] == scalar(0)) x[i] = scalar(0);
        }
    }

    Method& method_;
    System& system_;
    const Norm& norm_;
    const vector& y_;
    const output& now_;
    end_slope<vector>& f_;
    vector &y1_, &error_;
    report<scalar>& counts_;
    const watched_components<vector>* watched_ = nullptr;
    scalar last_{0};
};

}  // namespace stagecraft
