// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>

#include <stagecraft/judge/evidence.hpp>
#include <stagecraft/linear/mass.hpp>
#include <stagecraft/linear/mass_kernel.hpp>
#include <stagecraft/report.hpp>
#include <stagecraft/run/end_slope.hpp>
#include <stagecraft/stages/newton.hpp>
#include <stagecraft/tableau/blind_spots.hpp>

namespace stagecraft {

/// An attempt at a step from (t, y) to (t1, y1) whose stage equations are solved: where its vectors are.
template <class Vector, class Output>
struct solved_step {
    using scalar = typename Vector::Scalar;
    const Vector& y;
    end_slope<Vector>& f;  ///< f at one of the ends
    Vector& y1;
    Output& now;    ///< the stages, later the continuous solution
    Vector& error;  ///< room for estimates
};

/// The facts of such an attempt, and what the judge and its guards may ask to be measured: vectors in, numbers out, in the
/// norm whose tolerance is 1. Nothing is measured that is not asked for, and each question is put once.
template <class Method, class System, class Norm, class Vectors>
class measured_step : public step_facts<typename System::scalar> {
    using scalar = typename System::scalar;
    using vector = std::remove_cvref_t<decltype(std::declval<Vectors>().y1)>;

  public:
    measured_step(Method& method, System& system, const Norm& norm, const Vectors& vectors,
                  report<scalar>& counts)
        : method_(method), system_(system), norm_(norm), at_(vectors), counts_(counts) {
        this->first = counts.steps == 0;
        this->stages = method.count();
        this->power = method.estimate_power();
        this->index = system.largest_index();
        this->usual_iterations = stagecraft::usual_iterations(method.coupled_stages_count());
    }

    // Estimates of the error at the end of the step.

    /// The method's estimate; with components of index 2 and 3, compared with the state at the start as well.
    [[gnu::always_inline]] scalar estimate() {
        counts_.error_solves += method_.estimate(system_, this->h, at_.f.value(), at_.now, at_.error);
        if (this->index > 1) {
            const scalar s = scalar(this->power - 1);
            method_.compare_with_start(system_, at_.now, s / (s + scalar(1)) / this->share, at_.error);
        }
        return last_ = size();
    }
    /// The same once more filtered.
    scalar estimate_again() {
        this->once = last_;
        counts_.error_solves +=
            method_.estimate_again(system_, this->t, at_.y, this->h, at_.now, at_.y1, at_.error);
        if (this->first && this->refused.all > 0) method_.without_start(system_, at_.now, at_.error);
        method_.advance(at_.y, at_.now, at_.y1);
        return size();
    }
    /// The one that is made at the right end, 0 where there is none.
    [[gnu::always_inline]] scalar estimate_right() {
        if (!method_.needs_right_value()) return scalar(0);
        const auto& f1 = at_.f.right(system_, this->t_next, at_.y1);
        const int solves = method_.estimate_right(system_, this->h, f1, at_.now, at_.error);
        counts_.error_solves += solves;
        return solves > 0 ? scalar(norm_(at_.error) * method_.right_ratio(this->ratio)) : scalar(0);
    }
    /// The size of the estimate made last, as step.ratio and step.share have it now.
    [[gnu::always_inline]] scalar size() {
        return method_.error_size(
            system_, at_.now, this->ratio, at_.error, counts_.error_solves,
            [this](const vector& x, bool reduced) { return reduced ? follow(x) : judged(x); });
    }
    /// The same if this step had made all of the estimate in components of index 2 and 3.
    scalar size_with_share_one() const { return norm_.shared(at_.error, of_index(scalar(1))) * this->ratio; }
    /// The error of what the problem carries along, where it is more than y (system::further_error).
    scalar further() { return system_.further_error(method_, *this); }

    // What guards ask.

    /// False where no component can have an index above 1: known to the compiler.
    static constexpr bool may_have_index() { return System::may_be_raised; }
    bool estimates_from_start() const { return method_.estimates_from_start(); }
    static constexpr bool has_identity_mass() { return System::mass_type::identity; }
    /// What an estimate of 1 stands for across a jump of f.
    scalar ratio_across_jump() const { return method_.jump_ratio(this->smooth); }
    /// True if some component of y' is the same at all nodes, and not zero; on any process.
    bool has_constant_slope() {
        scalar seen(method_.sees_constant_slope(at_.now) ? 1 : 0);
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
            method_.weigh_slopes(g, this->h, at_.error);
            scalar next = judged(at_.error);
            for (int k = 0; k < 2 && next > notable && method_.damp(system_, at_.error); ++k) {
                ++counts_.error_solves;
                next = judged(at_.error);
            }
            largest = larger(largest, next);
        }
        return largest;
    }
    /// About the largest error of the continuous solution over the step.
    bool knows_output_error() const { return method_.knows_output_error(); }
    scalar output_error() { return method_.output_error(at_.now, norm_); }
    /// (M/(h a) - J)^-1 of the defect of the continuous solution in the middle of the widest gap between nodes and ends.
    /// Algebraic components, whose start need not be consistent, are left out: the solve takes what they do to the others
    /// away. One evaluation of f, one solve.
    scalar error_between_nodes() {
        if (!method_.implicit()) return scalar(0);
        auto u = at_.now;
        method_.finish(this->t, at_.y, this->h, at_.y1, u);
        const scalar t = this->t + this->h * farthest_from(u.nodes());
        vector error(system_.size());
        system_(t, u(t), error);
        const vector slope = u.derivative(t);
        add_mass_times(system_.mass(), scalar(-1), slope.data(), error.data(), system_.size());
        counts_.error_solves += method_.solve_for_defect(system_, this->h, error);
        drop_algebraic(system_.mass(), error);
        return norm_(error);
    }

    // What the choice among several methods asks.

    scalar decay() { return method_.decay(at_.now, norm_); }
    auto linear_work() { return method_.stages().linear_work(system_); }

    const Vectors& vectors() const { return at_; }

  private:
    /// What an estimate counts in components of index 2 and 3, whose errors are of its own order.
    scalar of_index(const scalar& share) const {
        return share * (least_ratio_of_index(this->ratio, this->index) / this->ratio);
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
    /// Takes out of x what M takes to zero; where its entries are not known, the components with a row sum of zero.
    template <class Mass>
    static void drop_algebraic(const Mass& mass, vector& x) {
        const int n = static_cast<int>(x.size());
        if constexpr (Mass::identity) {
            return;
        } else if constexpr (has_entries<Mass>) {
            mass_kernel<scalar>(mass, n).remove(x);
        } else {
            vector size = vector::Zero(n);
            const vector ones = vector::Ones(n);
            add_mass_times(mass, scalar(1), ones.data(), size.data(), n);
            for (int j = 0; j < n; ++j)
                if (size[j] == scalar(0)) x[j] = scalar(0);
        }
    }

    Method& method_;
    System& system_;
    const Norm& norm_;
    const Vectors& at_;
    report<scalar>& counts_;
    scalar last_{0};
};

}  // namespace stagecraft
