// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "stagecraft/tableau.hpp"
#include "stagecraft/tableaux/small_solve.hpp"
#include "stagecraft/theory/exercises/dice.hpp"
#include "stagecraft/theory/exercises/document.hpp"
#include "stagecraft/theory/statements/verdict.hpp"

namespace stagecraft::theory {

/// A statement of a solution and what the library's exact decision says of it.
struct certified_statement {
    std::string statement;  ///< plain text
    theory::verdict verdict;
    bool holds = true;  ///< what the solution says: that it is true, or that it is false

    bool agrees() const { return holds ? verdict.is_proved() : verdict.is_refuted(); }
};

/// A question, its solution, and the certificate of the solution. The solution is written from closed forms or from
/// the library's answer; each statement in `certificate` was decided by the library independently of how the exercise
/// was made up.
struct exercise {
    std::string kind;
    std::uint64_t seed = 0;
    document question, solution;
    std::vector<certified_statement> certificate;

    /// Whether every statement of the solution was confirmed.
    bool certified() const {
        return !certificate.empty() &&
               std::all_of(certificate.begin(), certificate.end(), [](const auto& c) { return c.agrees(); });
    }
};

/// The exercise for a terminal.
inline std::string to_text(const exercise& e) {
    std::string out = "Exercise " + e.kind + ", seed " + std::to_string(e.seed) + "\n\n" +
                      to_text(e.question) + "\nSolution\n\n" + to_text(e.solution) + "\nCertified\n\n";
    for (const auto& c : e.certificate) out += "    " + c.statement + ": " + c.verdict.text() + "\n";
    return out;
}

/// The exercise as a LaTeX document.
inline std::string to_latex(const exercise& e) {
    return "\\documentclass{article}\n\\usepackage{amsmath}\n\\setlength{\\parindent}{0pt}\n\\begin{document}"
           "\n"
           "\\section*{Exercise: " +
           e.kind + ", seed " + std::to_string(e.seed) + "}\n\n" + to_latex(e.question) +
           "\\subsection*{Solution}\n\n" + to_latex(e.solution) + "\\end{document}\n";
}

namespace detail {

/// Two rational numbers claimed to be equal.
inline certified_statement equal(const std::string& what, const rational& found, const rational& claimed) {
    return {what + " = " + claimed.str(),
            found == claimed ? verdict::proved("exact") : verdict::refuted("it is " + found.str())};
}

/// Entries of a tableau; `hidden` ones, counted row by row through (A, b), appear as a question mark.
inline text_block tableau_block(const tableau<rational>& t,
                                const std::vector<std::pair<int, int>>& hidden = {}) {
    text_block block{text_block::form::tableau, "", {}};
    const int s = static_cast<int>(t.b.size());
    for (int i = 0; i <= s; ++i) {
        std::vector<std::string> row;
        if (i < s) row.push_back(latex(t.c[i]));
        for (int j = 0; j < s; ++j) {
            const bool shown = std::find(hidden.begin(), hidden.end(), std::pair{i, j}) == hidden.end();
            row.push_back(!shown ? "?" : latex(i < s ? t.A(i, j) : t.b[j]));
        }
        block.rows.push_back(std::move(row));
    }
    return block;
}

inline text_block matrix_block(const std::string& before, const tableaux::dense<rational>& m) {
    text_block block{text_block::form::matrix, before, {}};
    for (Eigen::Index i = 0; i < m.rows(); ++i) {
        std::vector<std::string> row;
        for (Eigen::Index j = 0; j < m.cols(); ++j) row.push_back(latex(m(i, j)));
        block.rows.push_back(std::move(row));
    }
    return block;
}

}  // namespace detail

}  // namespace stagecraft::theory
