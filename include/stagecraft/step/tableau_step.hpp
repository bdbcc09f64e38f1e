// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <stdexcept>

#include <stagecraft/dense_output.hpp>
#include <stagecraft/method/blind_spots.hpp>
#include <stagecraft/method/embedded_estimate.hpp>
#include <stagecraft/method/remembered.hpp>
#include <stagecraft/method/structure.hpp>
#include <stagecraft/problem/system.hpp>
#include <stagecraft/stages/coupled.hpp>
#include <stagecraft/stages/sequential.hpp>
#include <stagecraft/step/one_step_method.hpp>
#include <stagecraft/step/stage_output.hpp>

namespace stagecraft {

/// One step of a method given by its tableau alone. The zeros of A decide how the stages are solved: one
/// after the other if A is lower triangular (explicit, DIRK, SDIRK, ESDIRK), else all together. A first stage
/// at the left end of the step takes the slope of the last stage of the step before if the last row of A is b
/// (FSAL), else f(t, y).
///
/// Error estimate: h sum_j (b_j - b_embedded_j) k_j, of order min(p, p_embedded) + 1; for a stiffly accurate
/// method it is filtered with its own matrix, (M - h a J)^-1 M, where that brings it to the size of the error
/// in stiff components and extends it to algebraic ones (Hairer-Wanner II.IV.8; embedded_estimate.hpp). A
/// method has no estimate, and runs with fixed steps only, if it has no embedded weights or these see no
/// error of a quadrature. Jumps of f between certain nodes that they do not see are seen by other
/// combinations of the slopes (method/blind_spots.hpp).
///
/// A singular M is possible if A is regular, or if the method is stiffly accurate and A is regular without
/// its first stage, which is the left end.
template <int Stages, class Space>
class tableau_step : public step_defaults<Space> {
    using Scalar = typename Space::scalar;
    using blocks = typename Space::blocks;

  public:
    using vector = typename Space::vector;
    using output = typename Space::output;
    using method_type = tableau<Scalar, Stages>;

    tableau_step(const method_type& method, int n)
        : known_(remembered(method, [&] { return look_at(checked(method)); })),
          v_(method, n),
          is_(known_.structure),
          sequential_(method, n, !is_.lower),
          implicit_(!is_.lower || sequential_.implicit()),
          coupled_(method, n, is_),
          output_(method.stages()),
          left_slope_(n),
          right_slope_(n),
          next_value_(n),
          scratch_(n) {
        v_.left_stage = is_.left_stage;
        v_.carry = known_.carry;
        left_slope_.setZero();
    }

    /// Looks at what the run asks of the method: std::invalid_argument
    /// where it has no embedded weights for adaptive steps, or cannot serve a singular mass matrix, or not
    /// with adaptive steps.
    template <class System>
    void prepare(const System& system, const run_demands& demands) {
        const bool fixed = demands.fixed;
        if (!fixed && known_.power == 0)
            throw std::invalid_argument(
                "integrate: method has no embedded weights to estimate errors with; use "
                "options.fixed_step, or step_doubling(method) of method/step_doubling.hpp");
        if constexpr (System::opaque || !has_entries<typename System::mass_type>)
            if (!is_.lower && !coupled_.splits())
                throw std::invalid_argument(
                    "integrate: method, whose A has no basis of eigenvectors, needs the entries of the "
                    "Jacobian and of M, which problem.matrix() and mass().add_times do not show");
        if constexpr (!System::mass_type::identity) {
            if ((is_.left_stage || !is_.regular()) && !v_.mass.prepare(system)) {
                if (!is_.regular() || !is_.stiffly_accurate)
                    throw std::invalid_argument(
                        "integrate: problem.mass() is singular, which method cannot serve: it needs a "
                        "regular A, or a last row equal to b and a regular A without its first stage");
                v_.by_value = true;
            }
            // Where R(infinity) is one in size nothing of an error of algebraic components ever returns.
            if (!fixed && !is_.lower && !is_.stiffly_accurate && !v_.mass.prepare(system))
                throw std::invalid_argument(
                    "integrate: problem.mass() is singular, and method, whose stages are solved together and "
                    "whose y1 is none of them, cannot estimate the errors of algebraic components; use "
                    "options.fixed_step or a transformed_tableau");
        }
        if (!fixed && known_.blind_to_quadrature)
            throw std::invalid_argument(
                "integrate: method.b_embedded sees no error of y' = f(t); use options.fixed_step or "
                "step_doubling(method)");
        ends_with_value_ =
            demands.output && !implicit() && is_.left_stage && !is_.stiffly_accurate && !v_.by_value;
        if (demands.output || implicit())
            output_.prepare(v_.method, known_.order, is_, v_.by_value, ends_with_value_);
        if (fixed) return;
        if (ends_between_nodes()) end_slope_ = output_.right_slope(v_.method);
        if (demands.jumps)
            blind_ = remembered(
                v_.method, [&] { return find_blind_spots(v_.method, is_, known_.difference, known_.order); });
        slope_from_f_ = !v_.by_value && (is_.left_stage || (blind_.count() > 0 && v_.mass.prepare(system)));
        const bool slopes_known =
            slope_from_f_ || ends_between_nodes() || (is_.stiffly_accurate && !v_.by_value);
        if (blind_.count() > 0 && !slopes_known)
            blind_ = remembered(v_.method, [&] {
                return find_blind_spots(v_.method, is_, known_.difference, known_.order, false);
            });
    }

    tableau_step& stages() { return *this; }
    const method_type& method() const { return v_.method; }
    int count() const { return v_.method.stages(); }
    /// Stages that one Newton iteration solves for together.
    int coupled_stages_count() const { return is_.lower ? 1 : count(); }
    /// Columns that the z of the continuous solution needs.
    int columns() const { return output_.columns(count()); }
    int order() const { return known_.order; }
    /// The estimate is O(h^q) with this q.
    int estimate_power() const { return known_.power; }
    /// Embedded weights estimate the error of the step itself, not of one of higher order.
    Scalar estimate_ratio(const Scalar&) const { return Scalar(1); }
    /// Of a jump of f they show a part.
    Scalar jump_ratio(const Scalar&) const { return blind_.largest_ratio; }
    bool stiffly_accurate() const { return is_.stiffly_accurate; }
    bool has_stage_order_two() const { return stagecraft::has_stage_order_two(v_.method); }
    bool forgets() const { return is_.forgets(); }
    /// False if no stage needs a Jacobian.
    bool implicit() const { return implicit_; }
    bool iterates() const { return implicit(); }
    /// True if the next step uses f at its left end.
    bool needs_left_value(bool) const {
        return !left_known_ && (is_.left_stage || (blind_.need_left_slope && slope_from_f_));
    }

    template <class System>
    bool factor(const System& system, const Scalar& h) {
        return is_.lower ? sequential_.factor(system, h) : coupled_.factor(system, h);
    }

    static constexpr bool knows_determinant = sequential_stages<vector, Stages, blocks>::knows_determinant;
    /// As in transformed_stages; a full A is not looked at (shift 0).
    int determinant_sign() requires knows_determinant { return sequential_.determinant_sign(); }
    Scalar growth_shift() const { return is_.lower ? sequential_.growth_shift() : Scalar(0); }

    template <class System, class Norm>
    newton_outcome<Scalar> solve(System& system, const Scalar& t, const vector& y, const Scalar& h,
                                 const Norm& norm, const newton_limits<Scalar>& limits,
                                 typename output::stage_matrix& Z, long& solves) {
        const auto outcome = is_.lower ? sequential_.solve(system, t, y, h, norm, limits, v_, Z, solves)
                                       : coupled_.solve(system, t, y, h, norm, limits, v_, Z, solves);
        if (v_.by_value) {
            const int last = count() - 1;
            next_value_ = v_.carry[last] * v_.left;
            add_mass_times(system.mass(), Scalar(1), v_.k.col(last).data(), next_value_.data(),
                           system.size());
        }
        return outcome;
    }

    /// A step begins: f0 = f(t, y) where needs_left_value().
    void begin(const vector& f0) {
        if (!needs_left_value(true)) return;
        if (v_.by_value) {
            v_.left = f0;
        } else {
            left_slope_ = f0;
            v_.mass.solve(left_slope_.data());
        }
    }

    /// True if the continuous solution uses f at the end of the step, which is the next step's left value.
    bool ends_with_value() const { return ends_with_value_; }
    /// A step is about to be finished: f1 = f(t1, y1).
    void end(const vector& f1) {
        right_slope_ = f1;
        v_.mass.solve(right_slope_.data());
    }
    /// The same where f is not finite there: the slope of the parabola through the ends takes its place.
    void end_without_value(const Scalar& h, const vector& y, const vector& y1) {
        right_slope_ = (y1 - y) * (Scalar(2) / h) - v_.k.col(0);
    }

    /// First guess: the continuous solution of the step before, extrapolated. `from` says where in that step
    /// this one starts: at its end (1), or together with it (0).
    void guess(const output* before, const vector& y, const Scalar& h, output& now,
               const Scalar& from = Scalar(1)) {
        h_ = h;
        if (is_.left_stage && !v_.by_value) v_.k.col(0) = left_slope_;
        v_.guessed = before != nullptr && implicit();
        if (v_.guessed) extrapolate(*before, y, h, now, from);
    }

    /// y1 := the new state.
    void advance(const vector& y, const output&, vector& y1) {
        if (is_.lower && is_.stiffly_accurate) {
            y1 = sequential_.last_stage();
        } else {
            v_.combine([&](int j) { return v_.method.b[j]; }, count(), h_, y1);
            y1 += y;
        }
    }

    /// Makes `now` the continuous solution of the accepted step from (t, y) to y1.
    void finish(const Scalar& t, const vector& y, const Scalar& h, const vector& y1, output& now) {
        if (ends_with_value_)
            output_.finish(t, y, h, y1, v_, right_slope_, now);
        else
            output_.finish(t, y, h, y1, v_, v_.k.col(count() - 1), now);
    }
    /// The slope at the end of the step becomes that of the next one's left end.
    void accepted() {
        left_known_ = is_.first_same_as_last() || blind_.need_left_slope;
        if (v_.by_value)
            v_.left = next_value_;
        else if (left_known_ && is_.stiffly_accurate)
            left_slope_ = v_.k.col(count() - 1);
        else if (left_known_)
            left_slope_ = right_slope_;
    }

    /// The state at the end of the step has been replaced: its slope is not that of the last stage.
    void replaced() { left_known_ = false; }

    /// error := the estimate. Returns the number of solves.
    template <class System>
    int estimate(const System& system, const Scalar& h, const vector&, const output&, vector& error) {
        v_.combine([&](int j) { return known_.difference[j]; }, count(), h, error);
        if (!known_.filtered) return 0;
        const Scalar factor = v_.by_value ? Scalar(h * known_.difference.dot(v_.carry)) : Scalar(0);
        if (is_.lower) {
            sequential_.filter(system, error, v_.left, factor);
        } else {
            coupled_.filter(system, error, v_, factor);
        }
        return 1;
    }
    /// error := (M/(h a) - J)^-1 error with the first a_ii that is not zero; where the stages are solved together,
    /// the last of h (I (x) M - h A (x) J)^-1 (1 (x) error).
    template <class System>
    int solve_for_defect(const System& system, const Scalar& h, vector& error) {
        if (!implicit()) return 0;
        if (is_.lower) {
            sequential_.solve_first(system, error);
        } else {
            error *= h;
            coupled_.solve_last(system, error, v_);
        }
        return 1;
    }
    /// True if f(t1, y1) is asked for before the step is accepted.
    bool needs_right_value() const {
        return ends_between_nodes() || ends_with_value_ || blind_.need_right_slope ||
               (blind_.need_left_slope && !is_.stiffly_accurate);
    }
    /// error := the part in stiff components of the filtered defect f(t1, y1) - M u'(t1) of the continuous
    /// solution: the error of y1 there, O(h^{q+2}) elsewhere, q being the order of u. f1 = f(t1, y1). For
    /// diagonally implicit methods whose y1 is no stage: in stiff components their stages lie on the
    /// solution, and y1 errs by another combination of them than the embedded weights see. Returns the
    /// number of solves, 0 where there is no such estimate. Called where needs_right_value().
    template <class System>
    int estimate_right(const System& system, const Scalar&, const vector& f1, const output&, vector& error) {
        if (!ends_between_nodes()) {
            end(f1);
            return 0;
        }
        v_.combine([&](int j) { return end_slope_[j]; }, count(), Scalar(1), next_value_);
        error = f1;
        add_mass_times(system.mass(), Scalar(-1), next_value_.data(), error.data(), system.size());
        sequential_.solve_first(system, error);
        // The slope at the end that weigh_slopes() looks at: that of f, but for stiff components, where f
        // magnifies what y1 is off by.
        right_slope_ = next_value_ + sequential_.growth_shift() * error;
        sequential_.stiff_part(system, error);
        return 2;
    }
    /// It does not stand for a part of a jump.
    static Scalar right_ratio(const Scalar& ratio) { return ratio < Scalar(1) ? ratio : Scalar(1); }
    /// The estimate once more filtered, after a rejection: stiffly accurate methods damp what stiff
    /// components that have not decayed yet leave in it (as collocation_step::estimate_again). Returns the
    /// number of solves.
    template <class System>
    int estimate_again(System& system, const Scalar&, const vector&, const Scalar&, const output&, vector&,
                       vector& error) {
        if (!is_.lower || !implicit() || !is_.stiffly_accurate) return 0;
        sequential_.filter(system, error);
        return 1;
    }
    /// Size of the estimate, which needs no correction for order reduction: it is one of y1 itself. A ratio
    /// above one (jump_ratio) is for what the filter leaves of it twice: in stiff components the estimate
    /// does not fall with h. Nor for stages that are solved together, which have no filter of their own.
    template <class System, class Size>
    Scalar error_size(const System& system, const output&, const Scalar& ratio, const vector& error,
                      long& solves, Size&& size) {
        const Scalar plain = size(error, false);
        if (!(ratio > Scalar(1)) || !implicit()) return plain * ratio;
        if (!is_.lower) return plain;
        scratch_ = error;
        for (int k = 0; k < 2; ++k) sequential_.filter(system, scratch_);
        solves += 2;
        const Scalar whole = ratio * size(scratch_, false);
        return whole <= plain ? plain : whole;
    }
    // Jumps of f (judge/guards/jumps.hpp).

    int blind_spot_count() const { return blind_.count(); }
    int blind_spot_power() const { return blind_.power; }
    /// True if the slopes are known that the combinations at blind spots ask for.
    bool knows_slopes() const { return !blind_.need_left_slope || left_known_ || slope_from_f_; }
    /// x := h times combination number g of the slopes.
    void weigh_slopes(int g, const Scalar& h, vector& x) const {
        const auto weights = blind_.weights.col(g);
        v_.combine([&](int j) { return weights[j + 1]; }, count(), h, x);
        if (blind_.need_left_slope) x += (h * weights[0]) * left_slope_;
        if (blind_.need_right_slope) x += (h * weights[count() + 1]) * right_slope_;
    }
    /// Damps stiff components of x by (M - h a J)^-1 M; false where there is no such filter.
    template <class System>
    bool damp(const System& system, vector& x) {
        if (!implicit() || !is_.lower) return false;
        sequential_.filter(system, x);
        return true;
    }

    /// What the next step depends on (checkpoint.hpp).
    template <class Bag>
    void carry(Bag& bag) {
        bag(left_slope_, v_.left, left_known_);
    }

  private:
    using per_stage = Eigen::Matrix<Scalar, Stages, 1>;
    /// What follows from the coefficients alone.
    struct coefficient_facts {
        tableau_structure structure;
        per_stage carry, difference;  // structure_of(); b - b_embedded where there are such
        int order = 0, power = 0;     // of y1; of the estimate, 0 if there is none
        bool filtered = false, blind_to_quadrature = false;
    };
    static coefficient_facts look_at(const method_type& method) {
        coefficient_facts known;
        known.structure = structure_of(method, known.carry);
        known.order = classical_order(method);
        known.difference.setZero(method.stages());
        if (method.b_embedded.size() == 0) return known;
        known.difference = method.b - method.b_embedded;
        const int most = known.order < largest_tree_order ? known.order : largest_tree_order;
        known.power = order_by_trees(method, method.b_embedded, most) + 1;
        known.filtered = needs_filter(method, known.structure, known.difference);
        known.blind_to_quadrature = stagecraft::blind_to_quadrature(method, known.difference);
        return known;
    }

    /// First guesses from the continuous solution of the step before.
    void extrapolate(const output& before, const vector& y, const Scalar& h, output& now,
                     const Scalar& from) {
        const auto& old = before.nodes();
        basis_values<Scalar, Space::columns> l(old.size);
        const bool share = v_.by_value && !is_.lower;  // of k_1, which the slopes are kept without
        for (int i = is_.left_stage && !share ? 1 : 0; i < count(); ++i) {
            const Scalar x = from + v_.method.c[i] * h / before.step();
            if (is_.lower) {
                old.basis(x, l.data());
                now.increments().col(i) = before.y0() - y;
                for (int j = 0; j < old.size; ++j)
                    now.increments().col(i) += l[j] * before.increments().col(old.first_column + j);
            } else {
                old.basis_derivative(x, l.data());
                v_.k.col(i).setZero();
                for (int j = 0; j < old.size; ++j)
                    v_.k.col(i) += (l[j] / before.step()) * before.increments().col(old.first_column + j);
                if (share && i > 0) v_.k.col(i) -= v_.carry[i] * v_.k.col(0);
            }
        }
    }
    bool ends_between_nodes() const { return is_.lower && sequential_.implicit() && !is_.stiffly_accurate; }

    coefficient_facts known_;

  protected:
    stage_slopes<vector, Stages, blocks> v_;
    Scalar h_{0};

  private:
    tableau_structure is_;
    sequential_stages<vector, Stages, blocks> sequential_;
    bool implicit_;
    coupled_stages<vector, Stages, blocks> coupled_;
    stage_output<Stages, Space> output_;
    blind_spots<Scalar> blind_;
    per_stage end_slope_;              // k -> u'(1)
    vector left_slope_, right_slope_;  // at the ends of the step; next to come is the left one
    vector next_value_;                // M k_1 of the next step where that is kept
    vector scratch_;
    bool left_known_ = false, slope_from_f_ = false, ends_with_value_ = false;
};

}  // namespace stagecraft
