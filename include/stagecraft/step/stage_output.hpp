// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>

#include <stagecraft/dense_output.hpp>
#include <stagecraft/stages/continuous_weights.hpp>
#include <stagecraft/stages/order_conditions.hpp>
#include <stagecraft/stages/stage_slopes.hpp>

namespace stagecraft {

/// The continuous solution of a method given by its tableau, brought to the form dense_output evaluates:
///   - the collocation polynomial of degree s where B(s) and C(s) hold with distinct nodes;
///   - else y + h sum b_j(theta) k_j with b(0) = 0, b(1) = b of the highest order q <= p that the stages
///     allow, in polynomials of degree max(q, 3) (stages/continuous_weights.hpp): 4 for Dormand-Prince 5(4),
///     5 for Prince-Dormand 8(7), 3 for the classical method. Where both ends are stages (explicit first,
///     last row of A equal to b) the slopes there are theirs, so that u is continuously differentiable over
///     the steps, and for q <= 3 it is Hermite's cubic;
///   - with a singular M, whose left slope is not known, the quadratic through both ends and the stage
///     nearest the middle (all stages where C(s) holds).
/// Order q means that a step adds an error O(h^{q+1}) between its ends to the O(h^p) of the ends. The
/// conditions are looked at in the numbers, not in the facts. No form evaluates f: where y1 is no stage the
/// slope there is not used, and a method of few stages has a continuous solution of order 2 (three stages
/// without C(3), such as Lobatto IIIB) or 1 (one stage). An accepted step costs s n multiplications for each
/// of the degree - 2 places between the ends, one place less with both slopes.
template <class Scalar, int N, int Stages, int MaxStages>
class stage_output {
  public:
    using vector = Eigen::Matrix<Scalar, N, 1>;
    using output = dense_output<vector, MaxStages>;

    /// Columns of z that are needed for s stages: the quadrature conditions of order q alone ask for q nodes.
    static constexpr int columns(int s) { return s > 3 ? s : 3; }

    explicit stage_output(int stages)
        : nodes_(columns(stages)),
          weights_(stages, MaxStages < 0 ? columns(stages) : MaxStages),
          right_(make_workspace<Scalar, MaxStages>(columns(stages))) {}

    /// Chooses the form for a method of order p; `ends` is true if k_1 and k_s are the slopes at the ends,
    /// `by_value` as in stage_slopes.
    void prepare(const tableau<Scalar, Stages>& m, int p, bool ends, bool by_value) {
        const int s = m.stages();
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
            find_weights(m, p, ends);
        }
        nodes_.finish();
        if (form_ == form::weights_and_ends) solve_for_right_slope();
    }

    /// The weights of the slopes in u' at the end of the step. Not with a singular M, nor of a method whose
    /// last stage has the slope there.
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

    /// Fills `now` for the step from (t, y) to y1 with the slopes v; now.z_ holds z_i of the stages.
    template <class Slopes>
    void finish(const Scalar& t, const vector& y, const Scalar& h, const vector& y1, const Slopes& v,
                output& now) const {
        now.nodes_ = &nodes_;
        now.t0_ = t;
        now.h_ = h;
        now.y0_ = y;
        auto& z = now.z_;
        const int s = v.method.stages();
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
                weigh(0, h, v, z);
                z.col(1) = y1 - y;
                for (int i = 2; i < weighed_; ++i) weigh(i, h, v, z);
                if (form_ == form::weights) break;
                z.col(weighed_) = (h * right_[weighed_]) * v.k.col(s - 1);
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

    /// Nodes 0 (the slope), 1, theta_1, ...; the last one is left to the right slope where both ends are
    /// stages.
    void find_weights(const tableau<Scalar, Stages>& m, int p, bool ends) {
        const auto found = find_continuous_weights(m, p, ends);
        nodes_.size = found.degree;
        nodes_.c[0] = Scalar(0);
        nodes_.c[1] = Scalar(1);
        for (int i = 2; i < found.degree; ++i) nodes_.c[i] = found.place(i - 1);
        weighed_ = found.degree - (ends ? 1 : 0);
        weights_.col(0) = found.at.col(0);
        for (int i = 2; i < weighed_; ++i) weights_.col(i) = found.at.col(i - 1);
    }

    /// z_last = right_last h k_s + sum_j right_j z_j from the slope at 1, sum_j l_j'(1) z_j = h k_s.
    void solve_for_right_slope() {
        nodes_.basis_derivative(Scalar(1), right_.data());
        for (int i = 0; i < weighed_; ++i) right_[i] /= -right_[weighed_];
        right_[weighed_] = Scalar(1) / right_[weighed_];
    }

    template <class Slopes, class Matrix>
    void weigh(int i, const Scalar& h, const Slopes& v, Matrix& z) const {
        z.col(i) = h * v.k.lazyProduct(weights_.col(i));
    }

    interpolation_nodes<Scalar, MaxStages> nodes_;
    Eigen::Matrix<Scalar, Stages, MaxStages> weights_;  // b'(0), b, b(theta_1), ..., one column a node
    workspace<Scalar, MaxStages> right_;
    form form_ = form::weights;
    int stage_ = -1;
    int weighed_ = 0;  // nodes whose values are weighed slopes, and y1
};

}  // namespace stagecraft
