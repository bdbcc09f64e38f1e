// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <limits>

#include <stagecraft/dense_output.hpp>
#include <stagecraft/stages/order_conditions.hpp>
#include <stagecraft/stages/stage_slopes.hpp>

namespace stagecraft {

namespace detail {

/// The smallest x (Euclidean) with the linear conditions <rows[k], x> = right[k], k < count; false if they
/// contradict each other. Conditions that follow from others are left out.
template <class Scalar, class Column>
bool least_solution(std::array<Column, 4> rows, std::array<Scalar, 4> right, int count, Column& x) {
    using std::abs;
    using std::sqrt;
    x.setZero();
    for (int k = 0; k < count; ++k) {  // Gram-Schmidt, twice for the sake of rounding
        const Scalar before = sqrt(rows[k].dot(rows[k]));
        const Scalar wanted = right[k];
        for (int repeat = 0; repeat < 2; ++repeat)
            for (int l = 0; l < k; ++l) {
                const Scalar p = rows[l].dot(rows[k]);
                rows[k] -= p * rows[l];
                right[k] -= p * right[l];
            }
        const Scalar size = sqrt(rows[k].dot(rows[k]));
        if (size <= condition_tolerance<Scalar>() * before) {
            if (abs(right[k]) > condition_tolerance<Scalar>() * (abs(wanted) + before)) return false;
            rows[k].setZero();
            right[k] = Scalar(0);
            continue;
        }
        rows[k] /= size;
        right[k] /= size;
        x += right[k] * rows[k];
    }
    return true;
}

}  // namespace detail

/// The continuous solution of a method given by its tableau, brought to the form dense_output evaluates:
///   - the collocation polynomial of degree s where B(s) and C(s) hold with distinct nodes;
///   - Hermite's cubic where both ends are stages (explicit first, last row of A equal to b): order 3;
///   - else the cubic y + h sum b_j(theta) k_j with b(0) = 0, b(1) = b whose b(1/2) and b'(0) satisfy the
///     order conditions up to order 3, or to 2, or 1, as far as the stages allow, and are smallest;
///   - with a singular M, whose left slope is not known, the quadratic through both ends and the stage
///     nearest the middle (all stages where C(s) holds).
/// The conditions are looked at in the numbers, not in the facts. No form evaluates f: where y1 is no stage
/// the slope there is not used, and a method of few stages has a continuous solution of order 2 (three stages
/// without C(3), such as Lobatto IIIB) or 1 (one stage).
template <class Scalar, int N, int Stages, int MaxStages>
class stage_output {
  public:
    using vector = Eigen::Matrix<Scalar, N, 1>;
    using output = dense_output<vector, MaxStages>;

    /// Columns of z that are needed for s stages.
    static constexpr int columns(int s) { return s > 3 ? s : 3; }

    explicit stage_output(int stages) : nodes_(columns(stages)), middle_(stages), left_(stages) {}

    /// Chooses the form; `ends` is true if k_1 and k_s are the slopes at the ends, `by_value` as in
    /// stage_slopes.
    void prepare(const tableau<Scalar, Stages>& m, bool ends, bool by_value) {
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
            form_ = ends ? form::hermite : form::weights;
            nodes_.size = 3;
            nodes_.c[0] = Scalar(0);
            nodes_.c[1] = Scalar(1);
            nodes_.c[2] = Scalar(1) / 2;
            if (!ends) find_weights(m);
        }
        nodes_.finish();
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
            case form::hermite:
                z.col(0) = h * v.k.col(0);
                z.col(1) = y1 - y;
                z.col(2) = z.col(1) / Scalar(2) + (h / Scalar(8)) * (v.k.col(0) - v.k.col(s - 1));
                break;
            case form::weights:
                z.col(0).setZero();
                z.col(2).setZero();
                for (int j = 0; j < s; ++j) {
                    if (!(left_[j] == Scalar(0))) z.col(0) += (h * left_[j]) * v.k.col(j);
                    if (!(middle_[j] == Scalar(0))) z.col(2) += (h * middle_[j]) * v.k.col(j);
                }
                z.col(1) = y1 - y;
                break;
        }
    }

  private:
    enum class form { stages, one_stage, hermite, weights };

    static Scalar from_middle(const Scalar& c) {
        using std::abs;
        return abs(c - Scalar(1) / 2);
    }

    /// b(1/2) and b'(0): with b(0) = 0 and b(1) = b they determine the cubic, and the conditions up to order
    /// 3 are cubics in theta, so that they hold for every theta if they hold at these places.
    void find_weights(const tableau<Scalar, Stages>& m) {
        using column = Eigen::Matrix<Scalar, Stages, 1>;
        const int s = m.stages();
        const column one = column::Ones(s);
        column squares(s), nested(s);
        for (int i = 0; i < s; ++i) {
            squares[i] = m.c[i] * m.c[i];
            nested[i] = Scalar(0);
            for (int j = 0; j < s; ++j) nested[i] += m.A(i, j) * m.c[j];
        }
        const std::array<column, 4> rows{one, m.c, squares, nested};
        const Scalar half = Scalar(1) / 2;
        const std::array<Scalar, 4> at_middle{half, half / 4, half / 12, half / 24};
        const std::array<Scalar, 4> at_left{Scalar(1), Scalar(0), Scalar(0), Scalar(0)};
        for (const int count : {4, 2, 1})
            if (detail::least_solution(rows, at_middle, count, middle_) &&
                detail::least_solution(rows, at_left, count, left_))
                return;
    }

    interpolation_nodes<Scalar, MaxStages> nodes_;
    Eigen::Matrix<Scalar, Stages, 1> middle_, left_;  // b(1/2), b'(0)
    form form_ = form::weights;
    int stage_ = -1;
};

}  // namespace stagecraft
