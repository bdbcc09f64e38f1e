// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <string>
#include <utility>

#include <stagecraft/dense_output.hpp>
#include <stagecraft/step/hermite_output.hpp>
#include <stagecraft/step/one_step_method.hpp>
#include <stagecraft/tableau.hpp>

namespace stagecraft {

/// What the steps of methods for problems that are not stiff have in common: no filter of the estimate, no stage at the end
/// that counts as y1, no factors unless a model has some, and a continuous solution by the slopes at both ends, which are
/// evaluated where somebody looks at it and a model does not know them anyhow. A model hides what it knows better.
template <class Space, int Columns = hermite_output<Space>::cubic_columns>
class step_between_slopes : public step_defaults<Space> {
  public:
    using vector = typename Space::vector;
    using scalar = typename Space::scalar;
    using output = typename Space::output;

    static constexpr int columns() { return Columns; }
    static constexpr int estimate_power() { return 1; }
    static constexpr int coupled_stages_count() { return 1; }
    static scalar estimate_ratio(const scalar&) { return scalar(1); }
    static constexpr bool stiffly_accurate() { return false; }
    static constexpr bool has_stage_order_two() { return false; }

    bool needs_left_value(bool) const { return output_wanted_; }
    void begin(const vector& f0) {
        if (output_wanted_) left_ = f0;
    }
    bool ends_with_value() const { return output_wanted_; }
    void end(const vector& f1) { right_ = f1; }
    void end_without_value(const scalar& h, const vector& y, const vector& y1) {
        right_ = (y1 - y) * (scalar(2) / h) - left_;
    }
    void finish(const scalar& t, const vector& y, const scalar& h, const vector& y1, output& now) const {
        if (output_wanted_)
            output_.cubic(t, y, h, y1, left_, right_, now);
        else
            now.cover(t, h);
    }

    template <class System>
    static bool factor(const System&, const scalar&) {
        return true;
    }
    /// There is none: equal steps.
    template <class System>
    static int estimate(const System&, const scalar&, const vector&, const output&, vector& error) {
        error.setZero();
        return 0;
    }
    template <class System, class Size>
    static scalar error_size(const System&, const output&, const scalar& ratio, const vector& error, long&,
                             Size&& size) {
        return size(error, false) * ratio;
    }

  protected:
    /// `room` false: a model makes room for the slopes where it finds that they are wanted.
    explicit step_between_slopes(int n, bool room = true) : output_(Columns) {
        if (room) left_.setZero(n), right_.setZero(n);
    }

    vector left_, right_;  // slopes at the ends of the step
    hermite_output<Space> output_;
    bool output_wanted_ = true;
};

/// The same of explicit methods that step in place, and have no tableau of stages to solve for: they serve M = 1.
template <class Space>
class in_place_step : public step_between_slopes<Space> {
    using base = step_between_slopes<Space>;

  public:
    using typename base::output;
    using typename base::scalar;
    using typename base::vector;

    /// What a checkpoint knows the method again by.
    const tableau<scalar>& method() const { return known_as_; }
    static constexpr bool implicit() { return false; }
    static constexpr bool iterates() { return false; }
    void guess(const output*, const vector&, const scalar&, output&, const scalar& = scalar(1)) {}

  protected:
    in_place_step(int n, bool room, tableau<scalar> known_as)
        : base(n, room), known_as_(std::move(known_as)) {}

    /// Throws std::invalid_argument where the problem has a mass matrix; `kind` of method.
    template <class System>
    static void refuse_mass([[maybe_unused]] const char* kind) {
        if constexpr (!System::mass_type::identity)
            throw std::invalid_argument("integrate: a " + std::string(kind) +
                                        " method does not serve a problem with mass()");
    }

  private:
    tableau<scalar> known_as_;
};

}  // namespace stagecraft
