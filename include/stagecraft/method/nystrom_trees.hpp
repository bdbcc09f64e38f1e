// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <vector>

#include <stagecraft/method/order_conditions.hpp>

namespace stagecraft {

/// The largest order up to `most` of weights b_bar, b (of q, of v) on the stages of a Nystrom method: every N-tree is
/// looked at (Hairer-Norsett-Wanner I.II.14). `A` of size 0: of f(t, q). The condition of a tree is that
/// the stages integrate a monomial kappa theta^d, d its degree, exactly: once for v, twice for q. Cost: s^2 a tree.
template <class Scalar>
class nystrom_trees {
    using column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    using square = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    struct tree {
        column stages;
        Scalar kappa;
    };

  public:
    nystrom_trees(const column& c, const square& A_bar, const square& A, int most) {
        const Eigen::Index s = c.size();
        trees_.push_back({{column::Ones(s), Scalar(1)}});
        branches_.emplace_back();
        for (int d = 1; d < most; ++d) {
            branches_.emplace_back();
            auto& now = branches_.back();
            if (d == 1) now.push_back({c, Scalar(1)});
            if (A.size() > 0)
                for (const tree& t : trees_[d - 1]) now.push_back({A * t.stages, t.kappa / Scalar(d)});
            if (d > 1)
                for (const tree& t : trees_[d - 2])
                    now.push_back({A_bar * t.stages, t.kappa / Scalar(d * (d - 1))});
            trees_.emplace_back();
            grow({column::Ones(s), Scalar(1)}, d, d, now.size());
        }
    }

    int order(const column& b_bar, const column& b) const {
        int p = 0;
        for (; p < static_cast<int>(trees_.size()); ++p) {
            for (const tree& t : trees_[p])
                if (!detail::holds<Scalar>(b.dot(t.stages), t.kappa / Scalar(p + 1))) return p;
            if (p > 0)
                for (const tree& t : trees_[p - 1])
                    if (!detail::holds<Scalar>(b_bar.dot(t.stages), t.kappa / Scalar(p * (p + 1)))) return p;
        }
        return p;
    }

  private:
    /// All products of `from` and branches of together `left` degrees, none after branch `last` of degree `degree`.
    void grow(const tree& from, int left, int degree, std::size_t last) {
        if (left == 0) {
            trees_.back().push_back(from);
            return;
        }
        for (int d = std::min(degree, left); d > 0; --d) {
            const std::size_t end = d == degree ? std::min(last, branches_[d].size()) : branches_[d].size();
            for (std::size_t k = 0; k < end; ++k)
                grow({from.stages.cwiseProduct(branches_[d][k].stages), from.kappa * branches_[d][k].kappa},
                     left - d, d, k + 1);
        }
    }
    std::vector<std::vector<tree>> trees_, branches_;  // by degree
};

}  // namespace stagecraft
