// SPDX-License-Identifier: BSL-1.0
#pragma once

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
    bool certified() const;
};

/// The exercise for a terminal.
std::string to_text(const exercise& e);

/// The exercise as a LaTeX document.
std::string to_latex(const exercise& e);

namespace detail {

/// Two rational numbers claimed to be equal.
certified_statement equal(const std::string& what, const rational& found, const rational& claimed);

/// Entries of a tableau; `hidden` ones, counted row by row through (A, b), appear as a question mark.
text_block tableau_block(const tableau<rational>& t, const std::vector<std::pair<int, int>>& hidden = {});

text_block matrix_block(const std::string& before, const tableaux::dense<rational>& m);

}  // namespace detail

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/exercises/exercise-inl.hpp"
#endif
