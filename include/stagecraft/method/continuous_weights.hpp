// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include <stagecraft/method/order_conditions.hpp>
#include <stagecraft/method/orthonormal_basis.hpp>

namespace stagecraft {

namespace detail {

/// A condition <row, b(theta)> = theta^order / density, the right-hand sides of which are those of several
/// places theta.
template <class Scalar>
struct continuous_condition {
    Eigen::Matrix<Scalar, Eigen::Dynamic, 1> row;
    Scalar density;
    int order;
    Eigen::Matrix<Scalar, 1, Eigen::Dynamic> right;
};

/// Finds, column by column, the x of least Euclidean norm that satisfies the conditions. False if they
/// contradict each other. Conditions that follow from others are left out.
template <class Scalar>
bool least_solution(const std::vector<continuous_condition<Scalar>>& conditions,
                    Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& x) {
    using std::abs;
    using std::sqrt;
    const auto s = x.rows(), places = x.cols();
    orthonormal_basis<Scalar> rows(s);
    x.setZero();
    for (const auto& condition : conditions) {
        typename orthonormal_basis<Scalar>::column next(s + places);
        next << condition.row, condition.right.transpose();
        if (rows.add(next)) {
            x += next.head(s) * next.tail(places).transpose();
            continue;
        }
        const Scalar norm = sqrt(condition.row.dot(condition.row));
        for (Eigen::Index k = 0; k < places; ++k)
            if (abs(next[s + k]) > condition_tolerance<Scalar>() * (abs(condition.right[k]) + norm))
                return false;
    }
    return true;
}

}  // namespace detail

/// Weights b(theta) of a continuous solution y + h sum_j b_j(theta) k_j at the places where it is not known.
template <class Scalar>
struct continuous_weights {
    int order;                                                 ///< the conditions hold up to this one
    int degree;                                                ///< of the polynomials b_j
    Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> at;  ///< columns b'(0), b(theta_1), b(theta_2), ...

    /// theta_i = i / (degree - 1): equally spaced, 1 <= i <= degree - 2.
    Scalar place(int i) const { return Scalar(i) / Scalar(degree - 1); }
};

/// The continuous weights of the highest order q that the stages allow (Hairer-Norsett-Wanner I.II.6): b(0) =
/// 0, b(1) = b and, for each rooted tree of at most q vertices, <b(theta), phi(tau)> = theta^n / gamma(tau)
/// for every theta. With polynomials b_j of degree max(q, 3) these are identities of polynomials of that
/// degree, which hold for every theta if they hold where b is computed: b'(0) and b at degree - 2 places, or
/// one less where the slope at the right end is to be that of the last stage (`ends`). The smallest b where
/// the conditions do not determine it, and the first unit vector for b'(0) where the first stage is the left
/// end. q > 3 only up to the order p of b and largest_tree_order; `order` is min(p, q).
template <class Scalar, int Stages>
continuous_weights<Scalar> find_continuous_weights(const tableau<Scalar, Stages>& m, int p, bool ends) {
    const int s = m.stages(), order = p < largest_tree_order ? p : largest_tree_order;
    const int most = order > 3 ? order : 3;
    std::vector<detail::continuous_condition<Scalar>> all, conditions;
    visit_trees(m, most, [&](const auto& stages, const Scalar& density, int n) {
        all.push_back({stages, density, n, {}});
        return true;
    });
    continuous_weights<Scalar> best{0, 3, {}};
    for (int q = 1; q <= most && q <= (s > 3 ? s : 3); ++q) {
        continuous_weights<Scalar> next{q, q > 3 ? q : 3, {}};
        const int places = next.degree - (ends ? 2 : 1);
        conditions.clear();
        for (const auto& condition : all) {
            if (condition.order > q) break;
            conditions.push_back(condition);
            auto& right = conditions.back().right;
            right.resize(places);
            right[0] = Scalar(condition.order == 1 ? 1 : 0);
            for (int i = 1; i < places; ++i) {
                right[i] = Scalar(1) / condition.density;
                for (int n = 0; n < condition.order; ++n) right[i] *= next.place(i);
            }
        }
        next.at.resize(s, places);
        if (!detail::least_solution(conditions, next.at)) break;
        best = next;
    }
    if (order < best.order) best.order = order;
    if (m.c[0] == Scalar(0) && m.A.row(0).isZero(Scalar(0))) {
        best.at.col(0).setZero();
        best.at(0, 0) = Scalar(1);
    }
    return best;
}

}  // namespace stagecraft
