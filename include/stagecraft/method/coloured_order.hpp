// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include <stagecraft/method/order_conditions.hpp>
#include <stagecraft/tableau.hpp>

namespace stagecraft {

/// Largest order at which every tree of two colours is looked at.
inline constexpr int largest_coloured_order = 6;

namespace detail {

/// A rooted tree whose vertices have one of two colours, as its stages see it.
template <class Scalar>
struct coloured_tree {
    using column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    column stages, branch;  // phi(tau), and A phi(tau) with the A of its root
    Scalar density;
    int root;
    bool time = false;  // a leaf that stands for t in the function of its colour
};

/// All of n vertices for n <= most, by n; made by joining the root of one to that of another, so that most are there
/// several times. The time leaves of a colour are there where its c is not the row sums of its A.
template <class Scalar, int Stages>
class coloured_trees {
    using tree = coloured_tree<Scalar>;
    using column = typename tree::column;

  public:
    explicit coloured_trees(const std::array<const tableau<Scalar, Stages>*, 2>& parts)
        : parts_(parts), of_(2) {
        const int s = parts[0]->stages();
        const column one = column::Constant(s, Scalar(1));
        for (int k = 0; k < 2; ++k) {
            const column sums = times(k, one);
            of_[1].push_back({one, sums, Scalar(1), k});
            bool differ = false;
            for (int i = 0; i < s; ++i) differ = differ || !holds(sums[i], parts[k]->c[i]);
            if (differ) of_[1].push_back({one, parts[k]->c, Scalar(1), k, true});
        }
    }
    const std::vector<tree>& of(std::size_t n) {
        while (of_.size() <= n) grow();
        return of_[n];
    }

  private:
    column times(int k, const column& v) const {
        const int s = parts_[0]->stages();
        column product = column::Constant(s, Scalar(0));
        for (int i = 0; i < s; ++i)
            for (int j = 0; j < s; ++j) product[i] += parts_[k]->A(i, j) * v[j];
        return product;
    }
    void grow() {
        const std::size_t n = of_.size();
        std::vector<tree> next;
        for (std::size_t left = 1; left < n; ++left)
            for (const tree& u : of_[left])
                for (const tree& v : of_[n - left]) {
                    if (u.time || (v.time && v.root != u.root)) continue;
                    const column phi = u.stages.cwiseProduct(v.branch);
                    next.push_back({phi, times(u.root, phi),
                                    u.density * v.density * Scalar(int(n)) / Scalar(int(left)), u.root});
                }
        of_.push_back(std::move(next));
    }

    std::array<const tableau<Scalar, Stages>*, 2> parts_;
    std::vector<std::vector<tree>> of_;
};

}  // namespace detail

/// The order, at most `most`, of the additive method with these two tableaux for y' = f_1(t, y) + f_2(t, y) and these weights,
/// but for rounding: b_r^T phi(tau) = 1/gamma(tau) for every tree tau of two colours, r the colour of its root (Araujo, Murua,
/// Sanz-Serna, SIAM J. Numer. Anal. 34 (1997) 1926-1947). Up to order six 2688 products of s^2.
template <class Scalar, int Stages, class Weights>
int coloured_order(const tableau<Scalar, Stages>& first, const tableau<Scalar, Stages>& second,
                   const Weights& b_first, const Weights& b_second, int most = largest_coloured_order) {
    detail::coloured_trees<Scalar, Stages> trees({&first, &second});
    const std::array<const Weights*, 2> b{&b_first, &b_second};
    for (int n = 1; n <= most; ++n)
        for (const auto& tree : trees.of(static_cast<std::size_t>(n))) {
            if (tree.time) continue;
            Scalar sum(0);
            for (int i = 0; i < first.stages(); ++i) sum += (*b[tree.root])[i] * tree.stages[i];
            if (!detail::holds(Scalar(sum * tree.density), Scalar(1))) return n - 1;
        }
    return most;
}

}  // namespace stagecraft
