// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/exercises/exercise.hpp"

#include <algorithm>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE bool exercise::certified() const {
    return !certificate.empty() &&
           std::all_of(certificate.begin(), certificate.end(), [](const auto& c) { return c.agrees(); });
}

STAGECRAFT_INLINE std::string to_text(const exercise& e) {
    std::string out = "Exercise " + e.kind + ", seed " + std::to_string(e.seed) + "\n\n" +
                      to_text(e.question) + "\nSolution\n\n" + to_text(e.solution) + "\nCertified\n\n";
    for (const auto& c : e.certificate) out += "    " + c.statement + ": " + c.verdict.text() + "\n";
    return out;
}

STAGECRAFT_INLINE std::string to_latex(const exercise& e) {
    return "\\documentclass{article}\n\\usepackage{amsmath}\n\\setlength{\\parindent}{0pt}\n\\begin{document}"
           "\n"
           "\\section*{Exercise: " +
           e.kind + ", seed " + std::to_string(e.seed) + "}\n\n" + to_latex(e.question) +
           "\\subsection*{Solution}\n\n" + to_latex(e.solution) + "\\end{document}\n";
}

namespace detail {

STAGECRAFT_INLINE certified_statement equal(const std::string& what, const rational& found,
                                            const rational& claimed) {
    return {what + " = " + claimed.str(),
            found == claimed ? verdict::proved("exact") : verdict::refuted("it is " + found.str())};
}

STAGECRAFT_INLINE text_block tableau_block(const tableau<rational>& t,
                                           const std::vector<std::pair<int, int>>& hidden) {
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

STAGECRAFT_INLINE text_block matrix_block(const std::string& before, const tableaux::dense<rational>& m) {
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
