// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <tuple>

#include <stagecraft/refuse/detect/refused_call.hpp>
#include <stagecraft/stages/fixed_point.hpp>
#include <stagecraft/step/method_set.hpp>

namespace stagecraft {

/// A method whose stage equations are solved by fixed point iteration instead of Newton's.
template <class Scalar, int Stages>
struct fixed_point_method {
    using scalar = Scalar;
    tableau<Scalar, Stages> method;
};

/// integrate(fixed_point(gauss<3>()), problem, ...): no Jacobian is evaluated and nothing factored. For problems
/// that are not stiff, and to see where the iteration ends (stages/fixed_point.hpp): a fixed step that is too
/// large ends the run in status::newton_failed, an adaptive one is made smaller. Problems with mass() are refused
/// (std::invalid_argument), as are adaptive steps of a method without embedded weights.
template <class Scalar, int Stages>
variable_order<fixed_point_method<Scalar, Stages>> fixed_point(const tableau<Scalar, Stages>& method) {
    return {{fixed_point_method<Scalar, Stages>{method}}};  // a set of one
}

namespace detail {
struct call_of_fixed_point {
    template <class Method>
    static constexpr bool say() {
        static_assert(
            never<Method>,
            "fixed_point(method): the method must be a tableau, gauss<3>() with its parentheses, say");
        return true;
    }
};
}  // namespace detail

/// Of what is no tableau.
variable_order<fixed_point_method<double, 1>> fixed_point(detail::refused_call<detail::call_of_fixed_point>,
                                                          ...);

/// A step of such a method: a model of one_step_method.
template <int Stages, class Space>
class fixed_point_step : public step_defaults<Space> {
    using Scalar = typename Space::scalar;
    using blocks = typename Space::blocks;

  public:
    using vector = typename Space::vector;
    using output = typename Space::output;

    fixed_point_step(const fixed_point_method<Scalar, Stages>& m, int n)
        : v_(checked(m.method), n), solver_(n), output_(m.method.stages()), difference_(m.method.stages()) {
        is_ = structure_of(m.method, v_.carry);
        order_ = classical_order(m.method);
        if (m.method.b_embedded.size() == 0) return;
        const int most = order_ < largest_tree_order ? order_ : largest_tree_order;
        power_ = order_by_trees(m.method, m.method.b_embedded, most) + 1;
        for (int j = 0; j < m.method.stages(); ++j) difference_[j] = m.method.b[j] - m.method.b_embedded[j];
    }

    template <class System>
    void prepare(const System&, const run_demands& demands) {
        if constexpr (!System::mass_type::identity)
            throw std::invalid_argument("integrate: fixed_point does not serve a problem with mass()");
        if (!demands.fixed && power_ == 0)
            throw std::invalid_argument(
                "integrate: method has no embedded weights to estimate errors with; use options.fixed_step");
        if (demands.output) output_.prepare(v_.method, order_, is_, false, false);
    }

    fixed_point_step& stages() { return *this; }
    const tableau<Scalar, Stages>& method() const { return v_.method; }
    int order() const { return order_; }
    int count() const { return v_.method.stages(); }
    int coupled_stages_count() const { return count(); }
    int columns() const { return output_.columns(count()); }
    int estimate_power() const { return power_; }
    Scalar estimate_ratio(const Scalar&) const { return Scalar(1); }
    bool stiffly_accurate() const { return is_.stiffly_accurate; }
    bool has_stage_order_two() const { return stagecraft::has_stage_order_two(v_.method); }
    static constexpr bool implicit() { return false; }

    template <class System>
    static bool factor(const System&, const Scalar&) {
        return true;
    }
    template <class System, class Norm>
    newton_outcome<Scalar> solve(System& system, const Scalar& t, const vector& y, const Scalar& h,
                                 const Norm& norm, const newton_limits<Scalar>& limits,
                                 typename output::stage_matrix& Z, long&) {
        return solver_.solve(system, t, y, h, norm, limits, v_, Z);
    }
    /// The slopes of the step before are the first guess.
    void guess(const output*, const vector&, const Scalar& h, output&, const Scalar& = Scalar(1)) { h_ = h; }
    void advance(const vector& y, const output&, vector& y1) {
        v_.combine([&](int j) { return v_.method.b[j]; }, count(), h_, y1);
        y1 += y;
    }
    void finish(const Scalar& t, const vector& y, const Scalar& h, const vector& y1, output& now) {
        output_.finish(t, y, h, y1, v_, v_.k.col(count() - 1), now);
    }
    template <class System>
    int estimate(const System&, const Scalar& h, const vector&, const output&, vector& error) {
        v_.combine([&](int j) { return difference_[j]; }, count(), h, error);
        return 0;
    }
    template <class System, class Size>
    Scalar error_size(const System&, const output&, const Scalar& ratio, const vector& error, long&,
                      Size&& size) {
        return size(error, false) * ratio;
    }

  private:
    stage_slopes<vector, Stages, blocks> v_;
    fixed_point_stages<vector, Stages, blocks> solver_;
    tableau_structure is_;
    stage_output<Stages, Space> output_;
    Eigen::Matrix<Scalar, Stages, 1> difference_;
    Scalar h_{0};
    int order_ = 0, power_ = 0;
};

namespace detail {

template <class Scalar, int Stages>
struct step_for<fixed_point_method<Scalar, Stages>> {
    static constexpr int columns = Stages < 0 || Stages > 3 ? Stages : 3;
    template <class Space>
    using type = fixed_point_step<Stages, Space>;
};

}  // namespace detail

}  // namespace stagecraft
