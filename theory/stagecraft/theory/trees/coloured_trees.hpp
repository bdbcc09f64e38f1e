// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <stagecraft/method/tree_table.hpp>
#include <stagecraft/tableaux/partitioned_file.hpp>
#include <stagecraft/theory/trees/tree_weights.hpp>
#include <string>
#include <utility>
#include <vector>

namespace stagecraft::theory {

/// Which trees belong to a form of system, by the colours of a vertex and of what may hang at it. Additive and
/// partitioned: any (P-trees, Hairer-Norsett-Wanner I.II.15). Separable: the colours alternate. Nystrom
/// (N-trees, I.II.14): colour 0 stands for y, whose derivative is y', so it bears one child at most, and that
/// is of colour 1; colour 1 stands for y', whose derivative is f(y) or f(y, y').
struct admits_coupling {
    tableaux::coupling coupling;
    bool uses_velocity;

    constexpr bool operator()(const tree_row& left, const tree_row& right) const {
        if (coupling == tableaux::coupling::separable) return left.colour != right.colour;
        if (coupling != tableaux::coupling::nystrom) return true;
        if (left.colour == 0) return left.order == 1 && right.colour == 1;
        return uses_velocity || right.colour == 0;
    }
};

/// The trees of orders 1..max_order for a method of so many tableaux.
tree_table coupled_trees(tableaux::coupling c, bool uses_velocity, int partners, int max_order);

/// A method of several tableaux over K: matrices and weights by colour, c for Nystrom methods only.
template <class K>
struct coloured_method {
    using matrix = Eigen::Matrix<K, Eigen::Dynamic, Eigen::Dynamic>;
    using column = Eigen::Matrix<K, Eigen::Dynamic, 1>;
    bool nystrom = false;
    std::vector<matrix> A;
    std::vector<column> b;
    column c;
};

/// M v, sum by sum.
template <class K>
typename coloured_method<K>::column product_of(const typename coloured_method<K>::matrix& M,
                                               const typename coloured_method<K>::column& v) {
    typename coloured_method<K>::column product(v.size());
    for (Eigen::Index i = 0; i < v.size(); ++i) {
        product[i] = M(i, 0) * v[0];
        for (Eigen::Index j = 1; j < v.size(); ++j) product[i] = product[i] + M(i, j) * v[j];
    }
    return product;
}

/// visit(row, weight) for each tree with a condition, by the number of vertices: the elementary weight
/// b^T phi, which the condition wants to be 1/gamma (gamma does not depend on the colours: Hairer-Norsett-
/// Wanner I.II.15, Theorem 15.9, and II.14, Theorem 14.10). A vertex multiplies A phi of its children, each
/// with the A of the child's colour. Ends where visit returns false. s^2 operations a tree.
template <class K, class Visit>
void visit_coloured_trees(const coloured_method<K>& m, const tree_view& trees, Visit&& visit) {
    using column = typename coloured_method<K>::column;
    const auto s = m.b.front().size();
    column one(s);
    for (Eigen::Index i = 0; i < s; ++i) one[i] = K(1);
    std::vector<column> stages, branches;  // phi and A phi, by row of the table
    for (std::uint32_t row = 0; row < trees.rows.size(); ++row) {
        const tree_row& t = trees.rows[row];
        const auto colour = static_cast<std::size_t>(t.colour);
        if (m.nystrom && colour == 0 && t.order == 1) {  // y itself: no condition
            stages.push_back(one);
            branches.push_back(m.c);
            continue;
        }
        column phi = one;
        if (m.nystrom && colour == 0)
            phi = stages[t.right];
        else if (t.order > 1)
            for (Eigen::Index i = 0; i < s; ++i) phi[i] = stages[t.left][i] * branches[t.right][i];
        K weight = m.b[colour][0] * phi[0];
        for (Eigen::Index i = 1; i < s; ++i) weight = weight + m.b[colour][i] * phi[i];
        if (!visit(row, weight)) return;
        if (t.order == trees.max_order) continue;
        branches.push_back(product_of<K>(m.A[colour], phi));
        stages.push_back(std::move(phi));
    }
}

/// Bit k is set where a vertex of the tree has colour k.
unsigned colours_of(const tree_view& trees, std::uint32_t row);

/// How conditions name the coefficients of each colour: "", "_hat" for a pair, "_1", "_2", ... for more;
/// "_bar", "" for Nystrom methods.
std::string colour_suffix(bool nystrom, std::size_t partners, std::int32_t colour);

/// Conditions and coloured trees as text.
class coloured_text {
  public:
    coloured_text(const tree_view& trees, bool nystrom, std::size_t partners)
        : trees_(trees), nystrom_(nystrom), partners_(partners) {}

    /// "dot(b, c_hat*(A*c)) == 1/8": in the expression language.
    std::string condition(std::uint32_t row) const;
    /// Brackets with the colour's suffix at each vertex: "[tau_hat,[tau]]_hat".
    std::string bracket(std::uint32_t row) const;

  private:
    struct written {
        std::string text;
        bool is_atom;
    };
    std::string suffix(std::uint32_t row) const;
    /// Rows of the subtrees, the smallest first.
    std::vector<std::uint32_t> children(std::uint32_t row) const;
    /// The stage vector at the root.
    written vector(std::uint32_t row) const;

    tree_view trees_;
    bool nystrom_;
    std::size_t partners_;
};

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/trees/coloured_trees-inl.hpp"
#endif
