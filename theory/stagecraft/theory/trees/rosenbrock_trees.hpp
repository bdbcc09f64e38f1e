// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "stagecraft/theory/trees/coloured_trees.hpp"

/// The trees of Rosenbrock and W methods, and their conditions.
///
///     k_i = h f(y_0 + sum_j alpha_ij k_j) + h T sum_j Gamma_ij k_j,   y_1 = y_0 + sum_i b_i k_i

namespace stagecraft::theory {

/// Which conditions. Vertices are meagre, for f and its derivatives, or fat.
enum class rosenbrock_conditions {
    jacobian,    ///< T = f'(y_0): all rooted trees (Hairer-Wanner II.IV.7, Theorem 7.3)
    any_matrix,  ///< T arbitrary: a fat vertex is T, has one child, and its tree is to have the weight 0 (Steihaug-Wolfbrandt 1979)
    index_1      ///< y' = f(y, z), 0 = g(y, z): a fat vertex is the inverse of -g_z (Roche 1988)
};

/// One tree: its root and the subtrees there, largest row first.
struct rosenbrock_tree {
    std::vector<std::uint32_t> children;
    std::int64_t density = 1;  ///< gamma: fat vertices of index_1 do not count
    int order = 1;             ///< number of vertices; of index_1 of the meagre ones
    int level = 1;             ///< the order of a method that needs the condition
    bool fat = false;          ///< the root
    bool some_fat = false;     ///< any vertex
};

/// The trees up to a level, sorted by order. Of index_1 those whose condition is not that of a smaller tree too: a fat vertex has two
/// children or more, and none that is fat is an only child. A tree with a fat root is a condition on z, of which one order less is
/// needed. Throws std::invalid_argument for a level outside 1..10.
class rosenbrock_trees {
  public:
    rosenbrock_trees(rosenbrock_conditions which, int max_level);

    rosenbrock_conditions which() const { return which_; }
    const std::vector<rosenbrock_tree>& rows() const { return rows_; }
    /// The rows of a level.
    std::vector<std::uint32_t> of_level(int level) const;

    /// What the weight must be: 1/gamma, of trees with fat vertices of any_matrix 0.
    bool is_zero(const rosenbrock_tree& t) const {
        return which_ == rosenbrock_conditions::any_matrix && t.some_fat;
    }
    /// "dot(b, c*(A*(beta*one))) == 1/8" with beta = A + Gamma, omega its inverse and c = A*one.
    std::string condition(std::uint32_t row) const;
    /// "[tau,[tau]]", where "{...}" are the children of a fat vertex.
    std::string bracket(std::uint32_t row) const;

  private:
    struct written {
        std::string text;
        bool is_atom;
    };
    void append(bool fat, std::vector<std::uint32_t> children);
    void grow(int order, bool fat, int left, std::vector<std::uint32_t>& children);
    written vector(const rosenbrock_tree& t) const;

    rosenbrock_conditions which_;
    std::vector<rosenbrock_tree> rows_;
};

/// A Rosenbrock or W method over K, whatever form it was published in. omega is the inverse of beta = alpha + Gamma, and empty where
/// no condition of index 1 is asked for.
template <class K>
struct rosenbrock_method {
    using matrix = Eigen::Matrix<K, Eigen::Dynamic, Eigen::Dynamic>;
    using column = Eigen::Matrix<K, Eigen::Dynamic, 1>;
    matrix alpha, Gamma, beta, omega;
    column b, b_embedded;

    Eigen::Index stages() const { return b.size(); }
};

/// visit(row, weight) for the trees, level by level: the elementary weight b^T phi. An only child enters by beta, others by alpha; with
/// an arbitrary matrix a meagre vertex always takes alpha and a fat one Gamma; of index 1 a fat vertex takes omega of the product.
/// Ends where visit returns false. s^2 operations a vertex at most.
template <class K, class Weights, class Visit>
void visit_rosenbrock_trees(const rosenbrock_method<K>& m, const Weights& b, const rosenbrock_trees& trees,
                            Visit&& visit) {
    using column = typename rosenbrock_method<K>::column;
    const bool any_matrix = trees.which() == rosenbrock_conditions::any_matrix;
    const auto s = m.stages();
    const auto& rows = trees.rows();
    std::vector<column> stages, branches;  // phi, alpha phi
    const auto phi_of = [&](const rosenbrock_tree& t) {
        if (any_matrix && t.fat) return product_of<K>(m.Gamma, stages[t.children.front()]);
        if (!any_matrix && t.children.size() == 1) return product_of<K>(m.beta, stages[t.children.front()]);
        column phi(s);
        for (Eigen::Index i = 0; i < s; ++i) phi[i] = K(1);
        for (const std::uint32_t child : t.children)
            for (Eigen::Index i = 0; i < s; ++i) phi[i] = phi[i] * branches[child][i];
        return t.fat ? product_of<K>(m.omega, phi) : phi;
    };
    for (int level = 1;; ++level) {
        for (auto k = stages.size(); k < rows.size() && rows[k].order <= level; ++k) {
            stages.push_back(phi_of(rows[k]));
            branches.push_back(product_of<K>(m.alpha, stages.back()));
        }
        const auto conditions = trees.of_level(level);
        if (conditions.empty()) return;
        for (const std::uint32_t row : conditions) {
            K weight = b[0] * stages[row][0];
            for (Eigen::Index i = 1; i < s; ++i) weight = weight + b[i] * stages[row][i];
            if (!visit(row, weight)) return;
        }
    }
}

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/trees/rosenbrock_trees-inl.hpp"
#endif
