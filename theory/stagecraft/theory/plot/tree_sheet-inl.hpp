// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/plot/tree_sheet.hpp"

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <stdexcept>

#include "stagecraft/compiled.hpp"
#include "stagecraft/theory/trees/tree_text.hpp"

namespace stagecraft::theory::plot {

STAGECRAFT_INLINE placed_tree placed(const rooted_tree& t) {
    const int n = order(t);
    placed_tree out;
    std::vector<int> last_at(static_cast<std::size_t>(n) + 1, -1);  // by level
    for (int i = 0; i < n; ++i) {
        const auto level = t.levels()[static_cast<std::size_t>(i)];
        out.nodes.push_back({0, level - 1, level == 1 ? -1 : last_at[level - 1U]});
        last_at[level] = i;
        out.height = std::max(out.height, level - 1);
    }
    std::vector<double> first(out.nodes.size(), -1), last(out.nodes.size(), -1);  // of the children
    double leaves = 0;
    // The preorder from its end meets children before their parent, and the rightmost of them first.
    for (auto i = out.nodes.size(); i-- > 0;) {
        auto& node = out.nodes[i];
        node.x = last[i] < 0 ? leaves++ : (first[i] + last[i]) / 2;
        if (node.parent < 0) continue;
        const auto p = static_cast<std::size_t>(node.parent);
        if (first[p] < 0) first[p] = node.x;
        last[p] = node.x;
    }
    out.width = leaves - 1;
    for (auto& node : out.nodes) node.x = out.width - node.x;
    return out;
}

namespace detail {

/// What stands beside a tree, in three lines.
struct tree_card {
    placed_tree tree;
    std::string name, name_latex, numbers, numbers_latex, condition, condition_latex;
};

STAGECRAFT_INLINE tree_card card_of(const rooted_tree& t) {
    const auto number = [](auto x) { return std::to_string(x); };
    tree_card c{placed(t), bracket(t),        "$" + bracket_latex(t) + "$",  {},
                {},        condition_text(t), "$" + condition_latex(t) + "$"};
    c.numbers = "order " + number(order(t)) + "   \u03b3 = " + number(density(t)) +
                "   \u03c3 = " + number(symmetry(t)) + "   \u03b1 = " + number(labelings(t));
    c.numbers_latex = "order " + number(order(t)) + "\\quad $\\gamma = " + number(density(t)) +
                      "$\\quad $\\sigma = " + number(symmetry(t)) +
                      "$\\quad $\\alpha = " + number(labelings(t)) + "$";
    return c;
}

/// Characters, not bytes, of a text in UTF-8.
STAGECRAFT_INLINE double characters(const std::string& text) {
    return static_cast<double>(
        std::count_if(text.begin(), text.end(), [](char ch) { return (ch & 0xc0) != 0x80; }));
}

/// Room for a formula in points in a small size, from above: a command is a sign of the size of a sum, an index is small.
STAGECRAFT_INLINE double formula_room(const std::string& latex) {
    double sum = 0, size = 1;
    for (std::size_t i = 0; i < latex.size(); ++i) {
        const char ch = latex[i];
        if (ch == '\\') {
            const auto end = latex.find_first_not_of("abcdefghijklmnopqrstuvwxyz", i + 1);
            sum += latex.compare(i, 5, "\\frac") == 0 ? 2 : 10;
            i = std::min(end, latex.size()) - 1;
        } else if (ch == '_' || ch == '^') {
            size = 0.7;
        } else if (ch == '}') {
            size = 1;
        } else if (ch != '{' && ch != '$') {
            sum += (ch == '=' ? 14 : ch == ' ' ? 1 : 5.5) * size;
        }
    }
    return 0.85 * sum;
}

struct sheet_sizes {
    static constexpr double margin = 20, page = 1060, leaf = 16, level = 18, letter = 6.7, line = 17, dot = 4;
    /// Where the words begin beside a tree that is `leaves` wide.
    static constexpr double beside(double leaves) { return 2 * dot + leaf * leaves + 18; }
};

/// One card with its left upper corner at (left, top): the tree on the foot of the row, `leaves` wide, the words in its middle.
STAGECRAFT_INLINE void place_card(drawing& d, const tree_card& c, double left, double top, double leaves,
                                  double high) {
    using s = sheet_sizes;
    const double shift = left + s::dot + s::leaf * (leaves - c.tree.width) / 2, foot = top + high - s::dot;
    const auto at = [&](const placed_tree::node& n) {
        return drawing::dot{shift + s::leaf * n.x, foot - s::level * n.height};
    };
    for (const auto& n : c.tree.nodes) {
        const auto here = at(n);
        d.dots.push_back(here);
        if (n.parent < 0) continue;
        const auto parent = at(c.tree.nodes[static_cast<std::size_t>(n.parent)]);
        d.lines.push_back({here.x, here.y, parent.x, parent.y});
    }
    const double x = left + s::beside(leaves), y = top + high / 2 + 4;
    d.texts.push_back({x, y - s::line, 11, true, c.name, c.name_latex});
    d.texts.push_back({x, y, 11, false, c.numbers, c.numbers_latex});
    d.texts.push_back({x, y + s::line, 11, true, c.condition, c.condition_latex});
}

/// The cards of one order from y down, in as many columns as the page has room for; the y below them.
STAGECRAFT_INLINE double place_cards(drawing& d, const std::vector<tree_card>& cards, double y) {
    using s = sheet_sizes;
    double room = 0, leaves = 0;
    for (const auto& c : cards) {
        leaves = std::max(leaves, c.tree.width);
        for (const auto* text : {&c.name, &c.numbers, &c.condition})
            room = std::max(room, s::letter * characters(*text));
        for (const auto* text : {&c.name_latex, &c.condition_latex})
            room = std::max(room, formula_room(*text));
    }
    const double wide = s::beside(leaves) + room + 24;
    const auto columns = std::max<std::size_t>(1, static_cast<std::size_t>((s::page - 2 * s::margin) / wide));
    for (std::size_t first = 0; first < cards.size(); first += columns) {
        const std::size_t end = std::min(first + columns, cards.size());
        double high = 3 * s::line;
        for (std::size_t k = first; k < end; ++k)
            high = std::max(high, s::level * cards[k].tree.height + 2 * s::dot);
        for (std::size_t k = first; k < end; ++k)
            place_card(d, cards[k], s::margin + wide * static_cast<double>(k - first), y, leaves, high);
        y += high + 20;
    }
    d.width = std::max(d.width, 2 * s::margin + wide * static_cast<double>(std::min(columns, cards.size())));
    return y;
}

STAGECRAFT_INLINE std::string xml_escaped(const std::string& text) {
    std::string out;
    for (const char ch : text) {
        if (ch == '&')
            out += "&amp;";
        else if (ch == '<')
            out += "&lt;";
        else
            out += ch;
    }
    return out;
}

}  // namespace detail

STAGECRAFT_INLINE drawing tree_sheet(int max_order) {
    if (max_order < 1 || max_order > most_sheet_order)
        throw std::invalid_argument("max_order: " + std::to_string(max_order) + ", allowed: 1 to " +
                                    std::to_string(most_sheet_order));
    drawing d;
    d.title = "The rooted trees to order " + std::to_string(max_order) + " and their order conditions";
    double y = 48;
    d.texts.push_back({detail::sheet_sizes::margin, 28, 16, false, d.title, d.title});
    for (int n = 1; n <= max_order; ++n) {
        std::vector<detail::tree_card> cards;
        for (const rooted_tree& t : trees_of_order(n)) cards.push_back(detail::card_of(t));
        const std::string heading = "Order " + std::to_string(n) + ": " + std::to_string(cards.size()) +
                                    (cards.size() == 1 ? " tree" : " trees");
        d.texts.push_back({detail::sheet_sizes::margin, y + 14, 13, false, heading, heading});
        y = detail::place_cards(d, cards, y + 30);
    }
    d.width = std::max(d.width, 480.0);
    d.height = y + 8;
    return d;
}

STAGECRAFT_INLINE std::string svg(const drawing& d) {
    std::ostringstream out;
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << d.width << "\" height=\"" << d.height
        << "\" viewBox=\"0 0 " << d.width << ' ' << d.height << "\">\n<title>" << detail::xml_escaped(d.title)
        << "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
        << "<g stroke=\"#404040\" stroke-width=\"1.5\">\n";
    for (const auto& l : d.lines)
        out << "<path d=\"M" << l.x1 << ' ' << l.y1 << 'L' << l.x2 << ' ' << l.y2 << "\"/>\n";
    out << "</g>\n<g fill=\"#1f4e79\">\n";
    for (const auto& p : d.dots)
        out << "<circle cx=\"" << p.x << "\" cy=\"" << p.y << "\" r=\"" << detail::sheet_sizes::dot
            << "\"/>\n";
    out << "</g>\n<g fill=\"#202020\" font-family=\"Helvetica, Arial, sans-serif\" xml:space=\"preserve\">\n";
    for (const auto& t : d.texts)
        out << "<text x=\"" << t.x << "\" y=\"" << t.y << "\" font-size=\"" << t.size << '"'
            << (t.code ? " font-family=\"DejaVu Sans Mono, Menlo, Consolas, monospace\"" : "") << '>'
            << detail::xml_escaped(t.plain) << "</text>\n";
    out << "</g>\n</svg>\n";
    return out.str();
}

STAGECRAFT_INLINE std::string tikz(const drawing& d) {
    std::ostringstream out;
    out << "% " << d.title << "; \\usepackage{tikz}\n\\begin{tikzpicture}[x=1pt,y=-1pt]\n";
    for (const auto& l : d.lines)
        out << "\\draw (" << l.x1 << ',' << l.y1 << ") -- (" << l.x2 << ',' << l.y2 << ");\n";
    for (const auto& p : d.dots) out << "\\fill (" << p.x << ',' << p.y << ") circle[radius=2.5pt];\n";
    for (const auto& t : d.texts)
        out << "\\node[anchor=base west,inner sep=0pt,font=\\"
            << (t.size > 14   ? "large"
                : t.size > 12 ? "normalsize"
                              : "footnotesize")
            << "] at (" << t.x << ',' << t.y << ") {" << t.latex << "};\n";
    out << "\\end{tikzpicture}\n";
    return out.str();
}

}  // namespace stagecraft::theory::plot
