// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>

#include <stagecraft/dense_output.hpp>
#include <stagecraft/method/continuous_weights.hpp>
#include <stagecraft/method/order_conditions.hpp>
#include <stagecraft/method/structure.hpp>
#include <stagecraft/stages/stage_slopes.hpp>

namespace stagecraft {

/// The continuous solution of a method given by its tableau, brought to the form dense_output evaluates:
///   - the collocation polynomial of degree s where B(s) and C(s) hold with distinct nodes;
///   - else y + h sum b_j(theta) k_j with b(0) = 0, b(1) = b of the highest order q <= p that the slopes
///     allow, in polynomials of degree max(q, 3) (method/continuous_weights.hpp): 4 for Dormand-Prince 5(4),
///     6 for Dormand-Prince 8(5,3), 3 for the classical method. Where the first stage is explicit and the
///     slope at the right end is known too, that of the last stage (last row of A equal to b) or f(t1, y1),
///     which an explicit method asks for in its next step anyway, the slopes at the ends are these, so that u
///     is continuously differentiable over the steps, and for q <= 3 it is Hermite's cubic;
///   - with a singular M, whose left slope is not known, the quadratic through both ends and the stage
///     nearest the middle (all stages where C(s) holds).
/// Order q means that between the ends of a step an error O(h^{q+1}) is added to the O(h^p) of the ends;
/// explicit methods to order five have q >= p - 1, which loses nothing. The conditions are decided from the
/// coefficients, not from the facts. Implicit methods whose y1 is no stage do not use the slope there; with
/// few stages their continuous solution has order 2 (three stages without C(3), such as Lobatto IIIB) or 1
/// (one stage). An accepted step costs s n multiplications for each of the degree - 2 places between the
/// ends, one place less with both slopes.
template <int Stages, class Space>
class stage_output {
    using Scalar = typename Space::scalar;
    static constexpr int MaxStages = Space::columns;

  public:
    using vector = typename Space::vector;
    using output = typename Space::output;

    /// Columns of z that are needed for s stages: the quadrature conditions of order q alone ask for q nodes.
    static constexpr int columns(int s) { return s > 3 ? s : 3; }

    explicit stage_output(int stages)
        : nodes_(columns(stages)),
          weights_(stages, MaxStages < 0 ? columns(stages) : MaxStages),
          right_(make_workspace<Scalar, MaxStages>(columns(stages))),
          of_right_(make_workspace<Scalar, MaxStages>(columns(stages))) {}

    /// Chooses the form for a method of order p and the structure `is`. `by_value` as in stage_slopes;
    /// `right_value` is true if k_1 is the slope at the left end and that at the right end, which is no
    /// stage, will be known as well.
    void prepare(const tableau<Scalar, Stages>& m, int p, const tableau_structure& is, bool by_value,
                 bool right_value) {
        const int s = m.stages();
        const bool ends = is.first_same_as_last() || right_value;
        bool distinct = true;
        for (int i = 0; i < s; ++i)
            for (int j = 0; j < i; ++j) distinct = distinct && !(m.c[i] == m.c[j]);
        const bool collocation = distinct && stage_conditions(m, s) == s && quadrature_conditions(m, s) == s;
        if (collocation && (by_value ? s > 2 : !ends || s > 3)) {
            form_ = form::stages;
            nodes_.first_column = by_value ? 1 : 0;
            nodes_.size = s - nodes_.first_column;
            for (int j = 0; j < nodes_.size; ++j) nodes_.c[j] = m.c[j + nodes_.first_column];
        } else if (by_value) {
            form_ = form::one_stage;
            stage_ = -1;
            for (int i = 1; i < s; ++i)
                if (m.c[i] > Scalar(0) && m.c[i] < Scalar(1) &&
                    (stage_ < 0 || from_middle(m.c[i]) < from_middle(m.c[stage_])))
                    stage_ = i;
            nodes_.size = stage_ < 0 ? 1 : 2;
            nodes_.c[0] = Scalar(1);
            if (stage_ >= 0) nodes_.c[1] = m.c[stage_];
        } else {
            form_ = ends ? form::weights_and_ends : form::weights;
            with_right_ = right_value;
            if (right_value)
                find_weights(with_right_stage(m), p, ends);
            else
                find_weights(m, p, ends);
        }
        nodes_.finish();
        if (form_ == form::weights_and_ends) solve_for_right_slope();
    }

    /// The weights of the slopes in u' at the end of the step. Not to be called by value, nor for a method
    /// whose last stage has the slope there.
    Eigen::Matrix<Scalar, Stages, 1> right_slope(const tableau<Scalar, Stages>& m) const {
        workspace<Scalar, MaxStages> l = right_;
        nodes_.basis_derivative(Scalar(1), l.data());
        Eigen::Matrix<Scalar, Stages, 1> w = Eigen::Matrix<Scalar, Stages, 1>::Zero(m.stages());
        for (int j = 0; j < nodes_.size; ++j) {
            if (form_ != form::stages)
                w += l[j] * (j == 1 ? m.b : weights_.col(j));
            else if (nodes_.c[j] == Scalar(0))
                w[j] += l[j];
            else
                w += l[j] * m.A.row(j).transpose();
        }
        return w;
    }

    /// Fills `now` for the step from (t, y) to y1 with the slopes v and, where both ends have one, `right` at
    /// the right end; now.increments() holds z_i of the stages.
    template <class Slopes, class Slope>
    void finish(const Scalar& t, const vector& y, const Scalar& h, const vector& y1, const Slopes& v,
                const Slope& right, output& now) const {
        now.cover(nodes_, t, h, y);
        auto& z = now.increments();
        switch (form_) {
            case form::stages:
                if (nodes_.c[0] == Scalar(0)) z.col(0) = h * v.k.col(0);
                break;
            case form::one_stage:
                if (stage_ >= 0 && stage_ != 1) z.col(1) = z.col(stage_);
                z.col(0) = y1 - y;
                break;
            case form::weights:
            case form::weights_and_ends:
                weigh(0, h, v, right, z);
                z.col(1) = y1 - y;
                for (int i = 2; i < weighed_; ++i) weigh(i, h, v, right, z);
                if (form_ == form::weights) break;
                z.col(weighed_) = (h * right_[weighed_]) * right;
                for (int i = 0; i < weighed_; ++i) z.col(weighed_) += right_[i] * z.col(i);
                break;
        }
    }

  private:
    enum class form { stages, one_stage, weights, weights_and_ends };

    static Scalar from_middle(const Scalar& c) {
        using std::abs;
        return abs(c - Scalar(1) / 2);
    }

    /// m with the right end as one more stage.
    static tableau<Scalar> with_right_stage(const tableau<Scalar, Stages>& m) {
        const int s = m.stages();
        tableau<Scalar> r;
        r.A.setZero(s + 1, s + 1);
        r.A.topLeftCorner(s, s) = m.A;
        r.A.bottomLeftCorner(1, s) = m.b.transpose();
        r.b.setZero(s + 1);
        r.b.head(s) = m.b;
        r.c.setOnes(s + 1);
        r.c.head(s) = m.c;
        return r;
    }

    /// Nodes 0 (the slope), 1, theta_1, ...; the last one is left to the right slope where both ends have
    /// one.
    template <int Rows>
    void find_weights(const tableau<Scalar, Rows>& m, int p, bool ends) {
        const auto found = find_continuous_weights(m, p, ends);
        nodes_.size = found.degree;
        nodes_.c[0] = Scalar(0);
        nodes_.c[1] = Scalar(1);
        for (int i = 2; i < found.degree; ++i) nodes_.c[i] = found.place(i - 1);
        weighed_ = found.degree - (ends ? 1 : 0);
        for (int i = 0; i < weighed_; ++i) {
            if (i == 1) continue;
            const auto weights = found.at.col(i == 0 ? 0 : i - 1);
            weights_.col(i) = weights.head(weights_.rows());
            of_right_[i] = weights[weights.size() - 1];
        }
    }

    /// z_last = right_last h u'(1) + sum_j right_j z_j from the slope at 1, sum_j l_j'(1) z_j = h u'(1).
    void solve_for_right_slope() {
        nodes_.basis_derivative(Scalar(1), right_.data());
        for (int i = 0; i < weighed_; ++i) right_[i] /= -right_[weighed_];
        right_[weighed_] = Scalar(1) / right_[weighed_];
    }

    template <class Slopes, class Slope, class Matrix>
    void weigh(int i, const Scalar& h, const Slopes& v, const Slope& right, Matrix& z) const {
        z.col(i) = (h * weights_(0, i)) * v.k.col(0);
        for (int j = 1; j < weights_.rows(); ++j) z.col(i) += (h * weights_(j, i)) * v.k.col(j);
        if (with_right_) z.col(i) += (h * of_right_[i]) * right;
    }

    interpolation_nodes<Scalar, MaxStages> nodes_;
    Eigen::Matrix<Scalar, Stages, MaxStages> weights_;  // b'(0), b, b(theta_1), ..., one column a node
    workspace<Scalar, MaxStages> right_;     // the last node's value from u'(1) and those of the others
    workspace<Scalar, MaxStages> of_right_;  // weights of the slope at 1 where it is none of a stage
    form form_ = form::weights;
    int stage_ = -1;
    int weighed_ = 0;  // nodes whose values are weighed slopes, and y1
    bool with_right_ = false;
};

}  // namespace stagecraft
