// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <stagecraft/method/rooted_tree.hpp>
#include <stagecraft/tableaux/quadratic.hpp>
#include <string>
#include <vector>

/// Numbers, lists and trees as Coq reads them.
namespace stagecraft::theory::coq {

/// "-3", "(1 # 2)" in the scope of Q.
inline std::string text(const tableaux::rational& x) {
    if (x.denominator() == 1) return x < 0 ? "(" + x.str() + ")" : x.str();
    return "(" + x.numerator().str() + " # " + x.denominator().str() + ")";
}

/// The pair of x + y sqrt(d).
inline std::string pair(const tableaux::quadratic& x) {
    return "(" + text(x.rational_part()) + ", " + text(x.surd_part()) + ")";
}

/// "[a; b; c]", broken into lines of at most 110 characters that begin with `indent`.
inline std::string list(const std::vector<std::string>& items, const std::string& indent) {
    std::string out = "[";
    std::size_t line = indent.size();
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (i > 0) {
            const bool full = line + items[i].size() > 110;
            out += full ? ";\n" + indent + " " : "; ";
            line = full ? indent.size() : line + 2;
        }
        out += items[i];
        line += items[i].size();
    }
    return out + "]";
}

/// A list of coefficients: "map q [1; (1 # 2)]" where all are rational, a list of pairs else.
inline std::string coefficients(const std::vector<tableaux::quadratic>& v, const std::string& indent = "  ") {
    const bool rational = std::all_of(v.begin(), v.end(), [](const auto& x) { return x.is_rational(); });
    std::vector<std::string> items;
    for (const auto& x : v) items.push_back(rational ? text(x.rational_part()) : pair(x));
    return (rational ? "map q " : "") + list(items, indent) + "%Q";
}

/// The same of a matrix, a row on each line.
inline std::string coefficients(const std::vector<std::vector<tableaux::quadratic>>& rows) {
    std::string out;
    for (const auto& row : rows) out += (out.empty() ? "  [ " : ";\n    ") + coefficients(row, "      ");
    return out + " ]";
}

/// A tree by grafting: [graft t u] has the subtree u more than t.
inline std::string text(const rooted_tree& t) {
    std::string out = "leaf";
    for (const rooted_tree& child : children(t)) out = "(graft " + out + " " + text(child) + ")";
    return out;
}

/// The tree whose root has n - 1 leaves.
inline std::string bushy(int n) {
    std::string out = "leaf";
    for (int k = 1; k < n; ++k) out = "(graft " + out + " leaf)";
    return out;
}

/// Words that end no comment and open no string in one.
inline std::string comment(std::string words) {
    for (char& c : words)
        if (c == '"' || c == '\n' || c == '\r') c = c == '"' ? '\'' : ' ';
    for (const char* mark : {"(*", "*)"})
        for (auto i = words.find(mark); i != std::string::npos; i = words.find(mark))
            words.insert(i + 1, " ");
    return words;
}

}  // namespace stagecraft::theory::coq
