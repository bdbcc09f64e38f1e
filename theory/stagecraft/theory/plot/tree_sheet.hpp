// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/method/rooted_tree.hpp>
#include <string>
#include <vector>

namespace stagecraft::theory::plot {

/// Largest order of a sheet: all trees to order 10 are 1205.
inline constexpr int most_sheet_order = 10;

/// Where the nodes of a tree are drawn: leaves side by side, a distance of 1 apart, and each other node in the middle of its
/// outermost children; the root is at the bottom.
struct placed_tree {
    struct node {
        double x;    ///< from 0, the leftmost
        int height;  ///< above the root
        int parent;  ///< its index; -1 of the root, which comes first
    };
    std::vector<node> nodes;  ///< in the preorder of the level sequence
    double width = 0;
    int height = 0;
};
placed_tree placed(const rooted_tree& t);

/// Lines, dots and words on a page; x to the right and y down, in pixels of SVG or points of TikZ.
struct drawing {
    struct line {
        double x1, y1, x2, y2;
    };
    struct dot {
        double x, y;
    };
    struct words {
        double x, y;  ///< left end of the base line
        double size;
        bool code;  ///< in letters of one width
        std::string plain, latex;
    };
    std::string title;
    double width = 0, height = 0;
    std::vector<line> lines;
    std::vector<dot> dots;
    std::vector<words> texts;
};

/// The rooted trees to order `max_order`, order by order, each drawn and beside it its bracket notation, order,
/// density gamma, symmetry sigma, number of monotonic labelings alpha (Hairer-Norsett-Wanner I.II.2) and order condition.
/// Throws std::invalid_argument for an order outside 1 to `most_sheet_order`.
drawing tree_sheet(int max_order);

/// As a picture of its own, on white, so that it can be read on any page.
std::string svg(const drawing& d);

/// As a `tikzpicture`, to be read by \input in a document that loads the package tikz.
std::string tikz(const drawing& d);

}  // namespace stagecraft::theory::plot

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/plot/tree_sheet-inl.hpp"
#endif
