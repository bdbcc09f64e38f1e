// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "stagecraft/tableaux/polynomial.hpp"
#include "stagecraft/tableaux/rational.hpp"

// Short mathematical texts, written once as LaTeX and readable without it.

namespace stagecraft::theory {

using tableaux::polynomial;
using tableaux::rational;

/// A paragraph, a Butcher tableau (rows "c, a_1, ..., a_s", the last "b_1, ..., b_s") or a matrix. All texts are LaTeX,
/// formulas between dollars; the entries of rows are formulas without dollars.
struct text_block {
    enum class form { paragraph, tableau, matrix };
    form kind = form::paragraph;
    std::string text;  ///< the paragraph; what stands before a matrix ("B =")
    std::vector<std::vector<std::string>> rows;
};

using document = std::vector<text_block>;

inline text_block paragraph(std::string text) { return {text_block::form::paragraph, std::move(text), {}}; }

/// "\frac{1}{3}", "-2".
std::string latex(const rational& q);

/// "1 + \frac{1}{2} z - z^{2}", ascending.
std::string latex(const polynomial<rational>& p, const std::string& variable);

/// LaTeX as plain text, for the part of it that is used here: fractions, roots, indices, powers, Greek letters,
/// relations. "$\frac{1}{2} h^{2} \lambda \le 1$" is "1/2 h^2 lambda <= 1".
std::string plain(std::string_view text);

/// The document for a terminal.
std::string to_text(const document& d);

/// The document as the body of a LaTeX document (amsmath).
std::string to_latex(const document& d);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/exercises/document-inl.hpp"
#endif
