// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <stagecraft/dense_output.hpp>
#include <stagecraft/linear/mass.hpp>
#include <stagecraft/method/additive_method.hpp>
#include <stagecraft/method/embedded_estimate.hpp>
#include <stagecraft/method/structure.hpp>
#include <stagecraft/problem/system.hpp>
#include <stagecraft/stages/constrained_end.hpp>
#include <stagecraft/stages/sequential.hpp>
#include <stagecraft/step/cubic_output.hpp>
#include <stagecraft/step/one_step_method.hpp>

namespace stagecraft {

/// One step of an additive method for M y' = f_E(t, y) + f_I(t, y): the stages of its diagonally implicit tableau one after
/// the other (sequential_stages), to each of which the slopes k^E_j, M k^E_j = f_E(t + c^E_j h, Y_j), of the stages before
/// are added:
///
///     Y_i = y + h sum_{j<i} a^E_ij k^E_j + h sum_{j<=i} a^I_ij k^I_j,   M k^I_i = f_I(t + c^I_i h, Y_i).
///
/// A stage whose slope no other stage and no weight asks for is not evaluated: ARS(s, sigma, p) costs sigma evaluations of f_E and
/// solves s stages. A first stage at the left end (c and the first rows zero in both) takes over what is known there.
///
/// Error estimate: h sum_j (b_j - b_embedded_j) k_j of both parts, filtered as in tableau_step where y1 is the last stage of
/// both tableaux. Where it is that of the implicit one alone, y1 is off in stiff components by the explicit part of its last
/// weights, which is estimated as well (error_size).
///
/// Singular M (index 1; the equations without a derivative in f_I): where f_E stands in M y' = ... M^-1 f_E does not exist, and
/// values take the place of slopes. With A_r = A^I without a left stage, regular, the slopes k~ of z = h A^I k~ obey
/// M k^I_i = M k~_i + carry_i f_I(t, y) + sum_j carried_ij f_E(Y_j), carried = -A_r^-1 A^E. Where the last stage is y1 for both
/// tableaux all is done; else y1 is one stage more: M y1 is given, and the equations without a derivative hold at y1. So
/// all stages and y1 satisfy them, the step is that of the same method for the ordinary differential equation which they
/// leave, and no order is lost (Hairer-Wanner II.VI.1, the state space form).
template <int Stages, class Space>
class additive_step : public step_defaults<Space> {
    using Scalar = typename Space::scalar;
    using blocks = typename Space::blocks;
    using per_stage = Eigen::Matrix<Scalar, Stages, 1>;
    using slopes = stage_slopes<typename Space::vector, Stages, blocks>;

  public:
    using vector = typename Space::vector;
    using output = typename Space::output;
    using method_type = tableau<Scalar, Stages>;

    additive_step(const additive_method<Scalar, Stages>& m, int n)
        : v_(m.implicit_part, n),
          w_(m.explicit_part, n),
          left_explicit_(n),
          left_slope_(n),
          right_explicit_(n),
          part_(n),
          is_(structure_of(m.implicit_part, v_.carry)),
          sequential_(m.implicit_part, n, false),
          order_(m.order),
          end_(n),
          left_implicit_(n),
          right_implicit_(n),
          right_slope_(n),
          given_(n) {
        const auto &e = m.explicit_part, &i = m.implicit_part;
        const int s = m.stages();
        bool left = e.c[0] == Scalar(0);
        is_.left_stage = is_.left_stage && left;
        v_.left_stage = is_.left_stage;
        ends_in_stage_ = is_.stiffly_accurate && e.stiffly_accurate();
        if (i.b_embedded.size() > 0) {
            power_ = (m.order < m.embedded_order ? m.order : m.embedded_order) + 1;
            implicit_difference_ = i.b - i.b_embedded;
            explicit_difference_ = e.b - e.b_embedded;
            filtered_ = ends_in_stage_ && needs_filter(i, is_, implicit_difference_);
            blind_ =
                blind_to_quadrature(i, implicit_difference_) && blind_to_quadrature(e, explicit_difference_);
        }
        for (int j = 0; j < s; ++j) {
            needs_explicit_.push_back(is_asked_for(e, j, ends_in_stage_));
            needs_implicit_.push_back(is_asked_for(i, j, ends_in_stage_));
        }
        last_difference_ = e.b - e.A.row(s - 1).transpose();
        output_.prepare(i.c, is_.left_stage ? 1 : 0);
        v_.k.setZero(), w_.k.setZero();
        left_implicit_.setZero(), left_explicit_.setZero();
    }

    /// std::invalid_argument where the method has no embedded weights for adaptive steps, or cannot serve M.
    template <class System>
    void prepare(const System& system, const run_demands& demands) {
        const auto refuse = [](bool bad, const char* what) {
            if (bad) throw std::invalid_argument(what);
        };
        refuse(order_ < 1, "integrate: the additive method has order 0: weights and stages do not fit");
        refuse(!demands.fixed && power_ == 0,
               "integrate: the additive method has no b_embedded in both parts to estimate errors with; use "
               "options.fixed_step, or step_doubling(method) of method/step_doubling.hpp");
        refuse(!demands.fixed && blind_,
               "integrate: b_embedded of the additive method sees no error of y' = f(t); use "
               "options.fixed_step");
        refuse(system.largest_index() > 1,
               "integrate: an additive method serves components of index 1, problem.index() holds others");
        if constexpr (!System::mass_type::identity) {
            if (!v_.mass.prepare(system)) prepare_singular(system);
        }
        wants_slopes_ = demands.output && !by_value_;
    }

    additive_step& stages() { return *this; }
    const method_type& method() const { return v_.method; }
    int count() const { return v_.method.stages(); }
    int coupled_stages_count() const { return 1; }
    int columns() const { return output_.columns(count()); }
    int order() const { return order_; }
    int estimate_power() const { return power_; }
    Scalar estimate_ratio(const Scalar&) const { return Scalar(1); }
    bool stiffly_accurate() const { return is_.stiffly_accurate; }
    bool has_stage_order_two() const { return stagecraft::has_stage_order_two(v_.method); }
    bool forgets() const { return is_.forgets(); }
    bool implicit() const { return sequential_.implicit(); }

    template <class System>
    bool factor(const System& system, const Scalar& h) {
        return sequential_.factor(system, h) && end_.factor(system, h);
    }
    static constexpr bool knows_determinant = sequential_stages<vector, Stages, blocks>::knows_determinant;
    int determinant_sign() requires knows_determinant { return sequential_.determinant_sign(); }
    Scalar growth_shift() const { return sequential_.growth_shift(); }

    /// f_I at the left end is asked for by the first stage, or by the continuous solution.
    bool needs_left_value(bool) const {
        if (left_implicit_known_) return false;
        return (is_.left_stage && needs_implicit_[0]) || (wants_slopes_ && !slope_known_);
    }
    void begin(const vector& f0) {
        if (!needs_left_value(true)) return;
        left_implicit_ = f0;
        if (!by_value_) v_.mass.solve(left_implicit_.data());
    }

    template <class System, class Norm>
    newton_outcome<Scalar> solve(System& system, const Scalar& t, const vector& y, const Scalar& h,
                                 const Norm& norm, const newton_limits<Scalar>& limits,
                                 typename output::stage_matrix& Z, long& solves) {
        if (!find_left_slopes(system, t, y)) return {newton_end::non_finite};
        auto outcome = sequential_.solve(system, t, y, h, norm, limits, v_, Z, solves, partner{*this});
        if (by_value_ && outcome.end == newton_end::converged) {
            const int last = count() - 1;
            right_implicit_ = given_;  // that of the last stage
            add_mass_times(system.mass(), Scalar(1), v_.k.col(last).data(), right_implicit_.data(),
                           system.size());
            if (end_.exists()) {
                w_.combine([&](int j) { return last_difference_[j]; }, count(), h, part_);
                const auto end =
                    end_.solve(system, t + h, h, sequential_.last_stage(), part_, norm, limits, solves);
                if (end.iterations > outcome.iterations) outcome.iterations = end.iterations;
                outcome.end = end.end;
            }
        }
        return outcome;
    }

    void guess(const output* before, const vector& y, const Scalar& h, output& now,
               const Scalar& from = Scalar(1)) {
        h_ = h;
        slopes_known_ = false;
        v_.guessed = before != nullptr;
        if (!v_.guessed) return;
        const auto& old = before->nodes();
        basis_values<Scalar, Space::columns> l(old.size);
        for (int i = is_.left_stage ? 1 : 0; i < count(); ++i) {
            old.basis(from + v_.method.c[i] * h / before->step(), l.data());
            now.increments().col(i) = before->y0() - y;
            for (int j = 0; j < old.size; ++j)
                now.increments().col(i) += l[j] * before->increments().col(old.first_column + j);
        }
    }

    void advance(const vector& y, const output&, vector& y1) {
        if (ends_in_stage_) {
            y1 = sequential_.last_stage();
        } else if (by_value_) {
            y1 = end_.state();
        } else if (is_.stiffly_accurate) {
            w_.combine([&](int j) { return last_difference_[j]; }, count(), h_, y1);
            y1 += sequential_.last_stage();
        } else {
            v_.combine([&](int j) { return v_.method.b[j]; }, count(), h_, y1);
            w_.combine([&](int j) { return w_.method.b[j]; }, count(), h_, part_);
            y1 += part_;
            y1 += y;
        }
    }

    /// f_I(t1, y1) is asked for by the continuous solution where the last stage does not have it.
    bool ends_with_value() const { return wants_slopes_ && !is_.stiffly_accurate; }
    void end(const vector& f1) {
        right_implicit_ = f1;
        v_.mass.solve(right_implicit_.data());
        right_known_ = true;
    }
    void end_without_value(const Scalar&, const vector&, const vector&) { right_known_ = false; }
    /// The step from y to y1 = y(t1) is about to be finished: what the continuous solution asks for there.
    template <class System>
    void end_in_parts(const System& system, const Scalar& t1, const Scalar& h, const vector& y,
                      const vector& y1) {
        if (!wants_slopes_) return;
        right_explicit_known_ = find_explicit(system, t1, y1, right_explicit_);
        if (right_explicit_known_ && is_.stiffly_accurate)
            right_slope_ = right_explicit_ + v_.k.col(count() - 1);
        else if (right_explicit_known_ && right_known_)
            right_slope_ = right_explicit_ + right_implicit_;
        else  // not finite there: that of the parabola
            right_slope_ = (y1 - y) * (Scalar(2) / h) - left_slope_;
        slopes_known_ = true;
    }
    /// Hermite's cubic; where the slopes at the ends are not known the quadratic through both ends and a stage.
    void finish(const Scalar& t, const vector& y, const Scalar& h, const vector& y1, output& now) {
        if (slopes_known_)
            output_.by_slopes(t, y, h, y1, left_slope_, right_slope_, now);
        else
            output_.by_stage(t, y, h, y1, now);
    }
    void accepted() {
        left_explicit_known_ = slopes_known_ && right_explicit_known_;
        if (left_explicit_known_) left_explicit_ = right_explicit_;
        slope_known_ = slopes_known_;
        if (slope_known_) left_slope_ = right_slope_;
        left_implicit_known_ = ends_in_stage_;
        if (left_implicit_known_) {
            if (by_value_)
                left_implicit_ = right_implicit_;
            else
                left_implicit_ = v_.k.col(count() - 1);
        }
        slopes_known_ = false;
        begun_ = true;
    }
    void replaced() { left_explicit_known_ = left_implicit_known_ = slope_known_ = false; }

    template <class System>
    int estimate(const System& system, const Scalar& h, const vector&, const output&, vector& error) {
        v_.combine([&](int j) { return implicit_difference_[j]; }, count(), h, error);
        if (!by_value_) {
            w_.combine([&](int j) { return explicit_difference_[j]; }, count(), h, part_);
            error += part_;
            if (!filtered_) return 0;
            sequential_.filter(system, error);
            return 1;
        }
        w_.combine([&](int j) { return value_difference_[j]; }, count(), Scalar(1), part_);
        part_ += implicit_difference_.dot(v_.carry) * left_implicit_;
        if (!end_.exists()) {
            sequential_.filter(system, error, part_, h);
        } else {  // unfiltered but for algebraic components, which follow the others
            part_ *= h;
            add_mass_times(system.mass(), Scalar(1), error.data(), part_.data(), system.size());
            error = part_;
            end_.follow(system, h, error);
        }
        return 1;
    }
    template <class System>
    int solve_for_defect(const System& system, const Scalar&, vector& error) {
        if (!implicit()) return 0;
        sequential_.solve_first(system, error);
        return 1;
    }
    /// As in tableau_step.
    template <class System>
    int estimate_again(System& system, const Scalar&, const vector&, const Scalar&, const output&, vector&,
                       vector& error) {
        if (!implicit() || !is_.stiffly_accurate) return 0;
        sequential_.filter(system, error);
        return 1;
    }
    /// The last stage lies on the solution in stiff components; where y1 is another one, by d = h sum_j (b^E_j - a^E_sj) k^E_j, it
    /// is off by the part of d in these, whatever the embedded weights see of it. One solve.
    template <class System, class Size>
    Scalar error_size(const System& system, const output&, const Scalar& ratio, const vector& error,
                      long& solves, Size&& size) {
        const Scalar plain = size(error, false) * ratio;
        if (ends_in_stage_ || !is_.stiffly_accurate || !implicit()) return plain;
        if (by_value_)
            part_ = end_.state() - sequential_.last_stage();
        else
            w_.combine([&](int j) { return last_difference_[j]; }, count(), h_, part_);
        sequential_.stiff_part(system, part_);
        ++solves;
        const Scalar off = size(part_, false);
        return off <= plain ? plain : off;
    }

    /// What the next step depends on (checkpoint.hpp).
    template <class Bag>
    void carry(Bag& bag) {
        bag.same_method(w_.method, order_);
        bag(left_implicit_, left_explicit_, left_slope_, left_implicit_known_, left_explicit_known_,
            slope_known_);
    }

  private:
    /// The explicit part as sequential_stages asks for it.
    struct partner {
        static constexpr bool exists = true;
        additive_step& step;
        void add_known(int i, const Scalar& h, vector& r) const { step.add_explicit(i, h, r); }
        void take_carried(vector& f) const {
            if (step.by_value_) f -= step.given_;
        }
        bool needs_slope(int i) const { return step.needs_implicit_[i]; }
        template <class System>
        bool follow(const System& system, const Scalar& t, const Scalar& h, int i,
                    const vector& stage) const {
            if (!step.needs_explicit_[i]) return true;
            const bool good = step.find_explicit(system, t + step.w_.method.c[i] * h, stage, step.part_);
            step.w_.k.col(i) = step.part_;
            return good;
        }
    };

    /// True if another stage or a weight of m takes the slope of stage j; where y1 is the last stage, b is in its row.
    static bool is_asked_for(const method_type& m, int j, bool ends_in_stage) {
        bool any = !ends_in_stage && !(m.b[j] == Scalar(0));
        for (int i = j + 1; i < m.stages(); ++i) any = any || !(m.A(i, j) == Scalar(0));
        return any || (m.b_embedded.size() > 0 && !(m.b_embedded[j] == m.b[j]));
    }
    /// M is singular: how the method serves it, or why it does not.
    template <class System>
    void prepare_singular(const System& system) {
        if (!is_.regular() || !is_.stiffly_accurate)
            throw std::invalid_argument(
                "integrate: problem.mass() is singular, which the additive method cannot serve: its implicit "
                "part needs a last row equal to b and a regular A without its first stage");
        by_value_ = true;
        const int s = count();
        carried_.setZero(s, s);
        for (int i = is_.left_stage ? 1 : 0; i < s; ++i)
            for (int j = 0; j < s; ++j) {
                Scalar sum = w_.method.A(i, j);
                for (int l = 0; l < i; ++l) sum += v_.method.A(i, l) * carried_(l, j);
                carried_(i, j) = -sum / v_.method.A(i, i);
            }
        value_difference_ = explicit_difference_;
        if (power_ > 0) value_difference_ += carried_.transpose() * implicit_difference_;
        end_.prepare(system, !ends_in_stage_);
        if (!ends_in_stage_ && end_.constraints().empty())
            throw std::invalid_argument(
                "integrate: problem.mass() is singular and does not show its entries: the additive method "
                "must have a last row equal to b in both parts");
    }

  protected:
    /// f := M^-1 f_E(t, y), or f_E where M is singular. False where it is not finite.
    template <class System>
    bool find_explicit(const System& system, const Scalar& t, const vector& y, vector& f) {
        system.explicit_part(t, y, f);
        if (!all_finite(f, system.size(), system.sums())) return false;
        if (!by_value_) {
            v_.mass.solve(f.data());
            return true;
        }
        demand_no_constraint_in(f);
        return true;
    }

  private:
    /// f_E, as a value, is zero in the equations that M leaves without a derivative. Where it is not at the start the run is
    /// refused, later it ends.
    void demand_no_constraint_in(const vector& f) const {
        using std::abs;
        for (const auto& c : end_.constraints().basis()) {
            Scalar size(0);
            for (std::size_t k = 0; k < c.at.size(); ++k) size += abs(c.value[k] * f[c.at[k]]);
            if (abs(c.of(f)) <= Scalar(1000) * std::numeric_limits<Scalar>::epsilon() * size) continue;
            const std::string text =
                "integrate: f_explicit of split() is not zero in an equation that problem.mass() leaves "
                "without a derivative: equation " +
                std::to_string(c.at[0]) + " (counted from 0) belongs to f_implicit as a whole";
            if (begun_) throw std::invalid_argument(text);
            throw bad_problem(text);
        }
    }
    /// What the first stage, and the continuous solution, take of the left end.
    template <class System>
    bool find_left_slopes(const System& system, const Scalar& t, const vector& y) {
        const bool slope = wants_slopes_ && !slope_known_;
        if (!left_explicit_known_ && (slope || (is_.left_stage && needs_explicit_[0]))) {
            if (!find_explicit(system, t, y, left_explicit_)) return false;
            left_explicit_known_ = true;
        }
        if (slope) left_slope_ = left_explicit_ + left_implicit_;
        if (is_.left_stage) {
            w_.k.col(0) = left_explicit_;
            if (!by_value_) v_.k.col(0) = left_implicit_;
        }
        return true;
    }
    /// r := r + h sum_j a^E_ij k^E_j; by value what stage i takes of them instead.
    void add_explicit(int i, const Scalar& h, vector& r) {
        if (!by_value_) {
            w_.combine([&](int j) { return w_.method.A(i, j); }, i, h, part_);
            r += part_;
            return;
        }
        w_.combine([&](int j) { return carried_(i, j); }, i, Scalar(1), given_);
        given_ += v_.carry[i] * left_implicit_;
    }

  protected:                                             // what relaxed_step uses as well
    slopes v_, w_;                                       // of the implicit and of the explicit part
    std::vector<char> needs_explicit_, needs_implicit_;  // stages whose slopes are asked for
    vector left_explicit_, left_slope_, right_explicit_, part_;
    Scalar h_{0};
    bool left_explicit_known_ = false, right_explicit_known_ = false;

  private:
    tableau_structure is_;
    sequential_stages<vector, Stages, blocks> sequential_;
    int order_, power_ = 0;
    bool begun_ = false;          // a step has been accepted
    bool by_value_ = false;       // M is singular
    bool ends_in_stage_ = false;  // y1 is the last stage of both parts
    bool filtered_ = false, blind_ = false, wants_slopes_ = false;
    per_stage implicit_difference_, explicit_difference_, last_difference_;
    per_stage value_difference_;  // of the values of f_E in the estimate where M is singular
    Eigen::Matrix<Scalar, Stages, Stages> carried_;
    cubic_output<Space> output_;
    constrained_end<vector, blocks> end_;  // where y1 is no stage and M singular
    vector left_implicit_, right_implicit_, right_slope_, given_;
    bool left_implicit_known_ = false, slope_known_ = false, right_known_ = false, slopes_known_ = false;
};

}  // namespace stagecraft
