// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <stagecraft/method/order_conditions.hpp>
#include <stagecraft/method/orthonormal_basis.hpp>
#include <stagecraft/method/structure.hpp>

namespace stagecraft {

/// What an embedded estimate h sum_i d_i k_i shows of a jump of f. If f jumps by J at t + theta h, between
/// two nodes, the estimate is h J sum_{c_i > theta} d_i, while the error of y1 is h J (sum_{c_i > theta} b_i
/// - (1 - theta)). Most pairs show at least a hundredth of that error. Some show nothing of a jump between
/// certain nodes, such as Bogacki-Shampine 5(4) beyond 3/4; and a pair without a left stage shows nothing of
/// a jump before its first node. At these blind spots other combinations of the slopes, including those at
/// both ends of the step, take the place of the estimate:
///     h (w_0 k_left + sum_i w_i k_i + w_{s+1} k_right)
/// is as large as the error of y1 if f jumps at the blind spot, and O(h^power) where f is smooth, because w
/// is orthogonal to the elementary weights of all trees of fewer than `power` vertices. If an end is a stage,
/// its own weight (w_0 or w_{s+1}) is zero.
template <class Scalar>
struct blind_spots {
    Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> weights;  ///< s + 2 rows, a column each
    int power = 0;
    Scalar largest_ratio{1};  ///< of the error of y1 to the estimate, where the pair is not blind

    bool need_left_slope = false, need_right_slope = false;  ///< slopes at ends that are no stages

    int count() const { return static_cast<int>(weights.cols()); }
};

namespace detail {

/// An orthonormal basis of the elementary weights of the trees of at most `most` vertices, tree by tree, over
/// the left end, the stages and the right end of a step.
template <class Scalar>
struct weights_basis {
    using column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    orthonormal_basis<Scalar> basis;
    std::vector<int> order;  ///< of the tree that each vector belongs to

    template <int Stages>
    weights_basis(const tableau<Scalar, Stages>& m, int most) : basis(m.stages() + 2) {
        const int s = m.stages();
        visit_trees(m, most, [&](const auto& stages, const Scalar& density, int n) {
            column x(s + 2);
            x[0] = Scalar(n == 1 ? 1 : 0);
            x.segment(1, s) = stages;
            x[s + 1] = Scalar(n) / density;
            if (basis.add(x)) order.push_back(n);
            return static_cast<int>(basis.count()) < s + 2;
        });
    }

    /// x := its part orthogonal to the trees of at most q vertices.
    void project_out(column& x, int q) const {
        basis.project_out(
            x, static_cast<std::size_t>(std::upper_bound(order.begin(), order.end(), q) - order.begin()));
    }
};

}  // namespace detail

/// A pair is blind to jumps between two nodes if y1 errs by more than this times what the estimate shows. Up to it the
/// step control asks a smaller tolerance of a jump instead (largest_ratio).
inline constexpr int blind_ratio = 200;
/// The same where nothing can be watched instead: a ratio above it comes from weights that cancel but for rounding.
inline constexpr int blind_ratio_unwatched = 10000;
/// A combination serves another blind spot as well if it shows at least 1/this of the error there.
inline constexpr int shown_fraction = 3;
/// The largest sum |w_i| of a combination: larger ones show more of what is smooth than of a jump.
inline constexpr int largest_combination = 20;

/// The blind spots of the pair with weights b and b - d, p its order, `is` its structure. Of the combinations that see a
/// spot the one of highest power with weights up to `largest_combination` is taken. If the slopes at the ends are not
/// known, nothing is `watched`: a spot then begins at blind_ratio_unwatched, and has no combination.
template <class Scalar, int Stages, class Weights>
blind_spots<Scalar> find_blind_spots(const tableau<Scalar, Stages>& m, const tableau_structure& is,
                                     const Weights& d, int p, bool watched = true) {
    using std::abs;
    using column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    const int s = m.stages(), most = p < largest_tree_order ? p : largest_tree_order;
    std::vector<Scalar> nodes{Scalar(0), Scalar(1)};
    for (int i = 0; i < s; ++i)
        if (m.c[i] > Scalar(0) && m.c[i] < Scalar(1)) nodes.push_back(m.c[i]);
    std::sort(nodes.begin(), nodes.end());
    blind_spots<Scalar> found;
    found.weights.resize(s + 2, 0);
    std::optional<detail::weights_basis<Scalar>> trees;  // few pairs ask for it
    for (std::size_t g = 0; g + 1 < nodes.size(); ++g) {
        const Scalar from = nodes[g], to = nodes[g + 1];
        if (detail::holds(from, to)) continue;
        column behind = column::Zero(s + 2);
        behind[s + 1] = Scalar(1);
        Scalar estimate(0), weight(0);
        for (int i = 0; i < s; ++i)
            if (m.c[i] > (from + to) / 2) {
                behind[i + 1] = Scalar(1);
                estimate += d[i];
                weight += m.b[i];
            }
        const Scalar error =
            std::max<Scalar>(abs(weight - (Scalar(1) - from)), abs(weight - (Scalar(1) - to)));
        if (error <= (watched ? blind_ratio : blind_ratio_unwatched) * abs(estimate)) {
            found.largest_ratio = std::max<Scalar>(found.largest_ratio, error / abs(estimate));
            continue;
        }
        bool seen = !watched;
        for (int k = 0; k < found.count(); ++k)
            seen = seen || shown_fraction * abs(found.weights.col(k).dot(behind)) >= error;
        if (!seen && !trees) trees.emplace(m, most);
        for (int q = found.count() > 0 ? found.power - 1 : most; q > 0 && !seen; --q) {
            column w = behind;
            trees->project_out(w, q);
            const Scalar sum = w.dot(behind);
            if (!(sum > detail::condition_tolerance<Scalar>())) continue;
            w *= error / sum;
            if (q > 1 && !(w.cwiseAbs().sum() <= Scalar(largest_combination))) continue;
            found.weights.conservativeResize(Eigen::NoChange, found.count() + 1);
            found.weights.col(found.count() - 1) = w;
            found.power = q + 1;
            seen = true;
        }
    }
    const auto join = [&](int end, int stage) {
        found.weights.row(stage) += found.weights.row(end);
        found.weights.row(end).setZero();
    };
    if (is.left_stage) join(0, 1);
    if (is.stiffly_accurate) join(s + 1, s);
    found.need_left_slope = !found.weights.row(0).isZero(Scalar(0));
    found.need_right_slope = !found.weights.row(s + 1).isZero(Scalar(0));
    return found;
}

}  // namespace stagecraft
