// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <stdexcept>

#include <stagecraft/dense_output.hpp>
#include <stagecraft/linear/norms.hpp>
#include <stagecraft/method/dense_method.hpp>
#include <stagecraft/method/order_conditions.hpp>
#include <stagecraft/step/method_set.hpp>
#include <stagecraft/step/tableau_step.hpp>

namespace stagecraft {

/// One step of a tableau whose continuous solution is the published one. Its further stages are evaluated once a step has been
/// accepted and somebody looks between the ends; one that is f(t1, y1) is the next step's first slope. Where the slopes do
/// not exist, with a singular M or values of f that are not finite, the continuous solution is that of tableau_step.
template <int Stages, class Space>
class dense_step : public tableau_step<Stages, Space> {
    using base = tableau_step<Stages, Space>;
    using Scalar = typename Space::scalar;
    using matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

  public:
    using vector = typename Space::vector;
    using output = typename Space::output;

    dense_step(const dense_method<Scalar, Stages>& m, int n)
        : base(m.method, n),
          known_(checked(m)),
          nodes_(std::max(m.degree(), 1)),
          more_(n, m.further_stages()),
          right_(n),
          stage_(n),
          f_(n) {
        more_.setZero();
        choose_nodes();
        for (int e = 0; e < m.further_stages(); ++e)
            if (is_right_end(e)) right_end_ = e;
    }

    template <class System>
    void prepare(const System& system, const run_demands& demands) {
        base::prepare(system, demands);
        published_ = !this->v_.by_value;
        wanted_ = demands.output && published_;
    }
    dense_step& stages() { return *this; }
    int columns() const { return std::max(base::columns(), known_.degree()); }
    bool ends_with_value() const { return base::ends_with_value() || (wanted_ && right_end_ >= 0); }
    void begin(const vector& f0) {
        right_known_ = false;
        base::begin(f0);
    }
    template <class System, class Norm>
    newton_outcome<Scalar> solve(System& system, const Scalar& t, const vector& y, const Scalar& h,
                                 const Norm& norm, const newton_limits<Scalar>& limits,
                                 typename output::stage_matrix& Z, long& solves) {
        system_ = &system;
        evaluate_ = [](void* s, const Scalar& at, const vector& x, vector& f) {
            System& of_run = *static_cast<System*>(s);
            of_run(at, x, f);
            return all_finite(f, of_run.size(), of_run.sums());
        };
        return base::solve(system, t, y, h, norm, limits, Z, solves);
    }
    void end(const vector& f1) {
        base::end(f1);
        right_ = f1;
        this->v_.mass.solve(right_.data());
        right_known_ = true;
    }
    void finish(const Scalar& t, const vector& y, const Scalar& h, const vector& y1, output& now) {
        if (!published_ || !find_further_slopes(t, y, h)) {
            base::finish(t, y, h, y1, now);
            return;
        }
        now.cover(nodes_, t, h, y);
        auto& z = now.increments();
        for (int j = 0; j < nodes_.size; ++j) {
            if (nodes_.c[j] == Scalar(1) && ends_in_y1_) {
                z.col(j) = y1 - y;
                continue;
            }
            this->v_.combine([&](int i) { return weights_(i, j); }, this->count(), h, stage_);
            for (int e = 0; e < more_.cols(); ++e)
                stage_ += (h * weights_(this->count() + e, j)) * more_.col(e);
            z.col(j) = stage_;
        }
    }

  private:
    static const dense_method<Scalar, Stages>& checked(const dense_method<Scalar, Stages>& m) {
        const int s = m.stages(), all = s + m.further_stages(), d = m.degree();
        const bool fits = d > 0 && m.b_theta.rows() == all && m.A_more.rows() == m.further_stages() &&
                          (m.further_stages() == 0 || m.A_more.cols() == all);
        bool later = false;
        for (int e = 0; fits && e < m.further_stages(); ++e)
            for (int j = s + e; j < all; ++j) later = later || !(m.A_more(e, j) == Scalar(0));
        if (!fits || later)
            throw std::invalid_argument(
                "integrate: dense_method: b_theta must have a row, and A_more a column, for each stage and "
                "each further one, which take earlier ones alone");
        if (Space::columns > 0 && d > Space::columns)
            throw std::invalid_argument(
                "integrate: dense_method: b_theta of a higher degree than there are stages needs a tableau "
                "of run-time size");
        return m;
    }
    /// Places between the ends, denser near these, and both ends: 0 stands for the slope there.
    void choose_nodes() {
        const int d = known_.degree(), all = this->count() + known_.further_stages();
        nodes_.size = d;
        weights_.setZero(all, d);
        for (int j = 0; j < d; ++j) {
            const Scalar x = Scalar(d == 1 ? 1 : j) / Scalar(d == 1 ? 1 : d - 1);
            nodes_.c[j] = x * x * (Scalar(3) - 2 * x);
            for (int i = 0; i < all; ++i)
                weights_(i, j) =
                    nodes_.c[j] == Scalar(0) ? known_.b_theta(i, 0) : known_.weight(i, nodes_.c[j]);
        }
        nodes_.finish();
        using std::abs;
        ends_in_y1_ = true;
        for (int i = 0; i < all; ++i) {
            const Scalar off = weights_(i, d - 1) - (i < this->count() ? known_.method.b[i] : Scalar(0));
            ends_in_y1_ = ends_in_y1_ && abs(off) < Scalar(1) / 100000000;
        }
    }
    /// Whether further stage e is f(t1, y1).
    bool is_right_end(int e) const {
        bool same = known_.c_more[e] == Scalar(1);
        for (Eigen::Index j = 0; j < known_.A_more.cols(); ++j)
            same = same && detail::holds(known_.A_more(e, j),
                                         j < known_.method.b.size() ? known_.method.b[j] : Scalar(0));
        return same;
    }
    bool find_further_slopes(const Scalar& t, const vector& y, const Scalar& h) {
        for (int e = 0; e < more_.cols(); ++e) {
            if (e == right_end_ && right_known_) {
                more_.col(e) = right_;
                continue;
            }
            this->v_.combine([&](int j) { return known_.A_more(e, j); }, this->count(), h, stage_);
            for (int j = 0; j < e; ++j) stage_ += (h * known_.A_more(e, this->count() + j)) * more_.col(j);
            stage_ += y;
            if (!evaluate_(system_, Scalar(t + known_.c_more[e] * h), stage_, f_)) return false;
            this->v_.mass.solve(f_.data());
            more_.col(e) = f_;
        }
        return true;
    }

    dense_method<Scalar, Stages> known_;
    interpolation_nodes<Scalar, Space::columns> nodes_;
    matrix weights_;  // b_i at the nodes, b_i'(0) at the node 0
    Eigen::Matrix<Scalar, vector::RowsAtCompileTime, Eigen::Dynamic> more_;
    vector right_, stage_, f_;
    int right_end_ = -1;
    bool published_ = true, wanted_ = true, right_known_ = false, ends_in_y1_ = true;
    void* system_ = nullptr;  // of the run, which lives as long as its steps
    bool (*evaluate_)(void*, const Scalar&, const vector&, vector&) = nullptr;
};

namespace detail {

template <class Scalar, int Stages>
struct step_for<dense_method<Scalar, Stages>> {
    static constexpr bool named = true;
    static constexpr int columns = step_for<tableau<Scalar, Stages>>::columns;
    template <class Space>
    using type = dense_step<Stages, Space>;
};

}  // namespace detail

}  // namespace stagecraft
