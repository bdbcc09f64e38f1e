// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include <stagecraft/dense_output.hpp>
#include <stagecraft/method/embedded_estimate.hpp>
#include <stagecraft/method/low_storage_method.hpp>
#include <stagecraft/method/order_conditions.hpp>
#include <stagecraft/step/method_set.hpp>
#include <stagecraft/step/step_between_slopes.hpp>

namespace stagecraft {

/// One step of a method by its registers. Of its own it has two vectors, the stage u and f(u); the second register of 2N, 2S
/// and 3S*, what Shu and Osher's later rows are added up in, and h sum_i (b_i - b_embedded_i) f(u_i) stand in the columns
/// of the continuous solution, which is made of the ends when all of them are done. Two vectors more, the slopes at the
/// ends, where somebody looks at that solution.
template <class Space>
class low_storage_step : public in_place_step<Space> {
    using Scalar = typename Space::scalar;
    using base = in_place_step<Space>;
    using base::left_, base::right_, base::output_wanted_;
    using list = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  public:
    using vector = typename Space::vector;
    using output = typename Space::output;
    using method_type = low_storage_method<Scalar>;

    low_storage_step(const method_type& m, int n)
        : base(n, false, m.meaning), m_(m), order_(classical_order(m.meaning)), u_(n), f_(n) {
        const auto& t = m_.meaning;
        if (m_.form == storage_form::shu_osher) more_.resize(n, assign_columns() - 2);
        if (t.b_embedded.size() == 0) return;
        difference_ = t.b - t.b_embedded;
        power_ =
            order_by_trees(t, t.b_embedded, order_ < largest_tree_order ? order_ : largest_tree_order) + 1;
        blind_ = blind_to_quadrature(t, difference_);
    }

    template <class System>
    void prepare(const System&, const run_demands& demands) {
        base::template refuse_mass<System>("low-storage");
        const auto refuse = [](bool bad, const char* what) {
            if (bad) throw std::invalid_argument(what);
        };
        refuse(order_ < 1, "integrate: the low-storage method has order 0: its coefficients do not fit");
        refuse(!demands.fixed && power_ == 0,
               "integrate: the low-storage method has no b_embedded to estimate errors with; use "
               "options.fixed_step");
        refuse(!demands.fixed && blind_,
               "integrate: b_embedded of the low-storage method sees no error of y' = f(t); use "
               "options.fixed_step");
        output_wanted_ = demands.output;
        estimated_ = !demands.fixed;
        if (output_wanted_) left_.setZero(u_.size()), right_.setZero(u_.size());
    }

    low_storage_step& stages() { return *this; }
    int count() const { return m_.stages(); }
    int order() const { return order_; }
    int estimate_power() const { return power_; }

    bool needs_left_value(bool) const { return true; }
    void begin(const vector& f0) {
        f_ = f0;
        base::begin(f0);
    }

    template <class System, class Norm>
    newton_outcome<Scalar> solve(System& system, const Scalar& t, const vector& y, const Scalar& h,
                                 const Norm&, const newton_limits<Scalar>&, typename output::stage_matrix& Z,
                                 long&) {
        u_ = y;
        for (int i = 0; i < count(); ++i) {
            if (i > 0) system(Scalar(t + m_.meaning.c[i] * h), u_, f_);
            if (estimated_) add(Z.col(error_column), Scalar(h * difference_[i]), i == 0);
            if (m_.form == storage_form::shu_osher)
                next_of_rows(i, y, h, Z);
            else
                next_of_registers(i, y, h, Z);
        }
        newton_outcome<Scalar> done;
        done.end = newton_end::converged;
        done.iterations = 1;  // the step is chosen as that of an explicit tableau
        return done;
    }
    void advance(const vector&, const output&, vector& y1) { y1 = u_; }

    template <class System>
    int estimate(const System&, const Scalar&, const vector&, const output& now, vector& error) {
        error = now.increments().col(error_column);
        return 0;
    }

  private:
    static constexpr int error_column = 1;

    const Scalar& at(std::size_t which, int i) const { return m_.rows[which][static_cast<std::size_t>(i)]; }
    /// x := x + factor f(u), or factor f(u).
    template <class Column>
    void add(Column&& x, const Scalar& factor, bool first) {
        if (first)
            x = factor * f_;
        else
            x += factor * f_;
    }

    /// u := the next stage, by the second register v.
    template <class Matrix>
    void next_of_registers(int i, const vector& y, const Scalar& h, Matrix& Z) {
        auto v = Z.col(0);
        if (m_.form == storage_form::williamson) {
            if (i > 0) v *= at(0, i);
            add(v, h, i == 0);
            u_ += at(1, i) * v;
            return;
        }
        const bool three = m_.form == storage_form::ketcheson_three;
        const Scalar &delta = at(three ? 3 : 2, i), change = h * at(three ? 4 : 3, i);
        if (i == 0)
            v = delta * u_;
        else if (!(delta == Scalar(0)))
            v += delta * u_;
        if (at(1, i) == Scalar(0))
            u_ = at(0, i) * u_ + change * f_;
        else
            u_ = at(0, i) * u_ + at(1, i) * v + change * f_;
        if (three && !(at(2, i) == Scalar(0))) u_ += at(2, i) * y;
    }

    // Shu and Osher's form: what row i takes of a stage k < i is added up in a column of its own, as soon as u_k and f(u_k) are
    // there; what it takes of u_0 = y is added in the end.

    bool takes(int i, int k) const {
        return (k > 0 && !(alpha(i, k) == Scalar(0))) || !(beta(i, k) == Scalar(0));
    }
    const Scalar& alpha(int i, int k) const { return at(static_cast<std::size_t>(i), k); }
    const Scalar& beta(int i, int k) const { return at(static_cast<std::size_t>(count() + i), k); }
    /// Where row i is added up (-1: nowhere) and from which stage on, in as few columns as there are rows at work at once.
    /// Returns how many these are, 2 at least.
    int assign_columns() {
        const int s = count();
        std::vector<int> busy_until;
        column_.setConstant(s, -1), begins_.setConstant(s, s);
        for (int k = 0; k < s; ++k)
            for (int i = k + 1; i < s; ++i) {
                if (begins_[i] < s || !takes(i, k)) continue;
                begins_[i] = k;
                int c = 0;
                while (c < static_cast<int>(busy_until.size()) &&
                       busy_until[static_cast<std::size_t>(c)] >= k)
                    ++c;
                if (c == static_cast<int>(busy_until.size())) busy_until.push_back(0);
                busy_until[static_cast<std::size_t>(c)] = i;
                column_[i] = c;
            }
        return busy_until.size() < 2 ? 2 : static_cast<int>(busy_until.size());
    }
    /// u := u_{k + 1}.
    template <class Matrix>
    void next_of_rows(int k, const vector& y, const Scalar& h, Matrix& Z) {
        for (int i = k + 1; i < count(); ++i)
            if (column_[i] >= 0 && begins_[i] <= k)
                in_column(column_[i], Z, [&](auto x) {
                    const Scalar of_stage = k > 0 ? alpha(i, k) : Scalar(0);
                    if (begins_[i] == k)
                        x = of_stage * u_ + (h * beta(i, k)) * f_;
                    else if (takes(i, k))
                        x += of_stage * u_ + (h * beta(i, k)) * f_;
                });
        u_ = alpha(k, k) * u_ + (h * beta(k, k)) * f_;
        if (k > 0 && !(alpha(k, 0) == Scalar(0))) u_ += alpha(k, 0) * y;
        if (column_[k] >= 0) in_column(column_[k], Z, [&](auto x) { u_ += x; });
    }
    template <class Matrix, class Use>
    void in_column(int c, Matrix& Z, const Use& use) {
        if (c < 2)
            use(Z.col(c == 0 ? 0 : 2));
        else
            use(more_.col(c - 2));
    }

    method_type m_;
    int order_, power_ = 0;
    bool blind_ = false, estimated_ = false;
    list difference_;                  // b - b_embedded
    Eigen::VectorXi column_, begins_;  // of the rows of Shu and Osher's form
    vector u_, f_;
    Eigen::Matrix<Scalar, vector::RowsAtCompileTime, Eigen::Dynamic> more_;
};

namespace detail {

template <class Scalar>
struct step_for<low_storage_method<Scalar>> {
    static constexpr bool named = true;
    static constexpr int columns = 3;
    template <class Space>
    using type = low_storage_step<Space>;
};

}  // namespace detail

}  // namespace stagecraft
