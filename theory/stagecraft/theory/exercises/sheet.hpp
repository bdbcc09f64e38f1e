// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "stagecraft/theory/exercises/exercise.hpp"

namespace stagecraft::theory {

/// Exercises for a class, numbered, and their solutions behind all of them, or without.
struct exercise_sheet {
    std::vector<exercise> exercises;
    bool solutions = true;
};

/// `count` different exercises of a kind, the first of this seed, the others of those that follow; with an empty kind of all
/// kinds in turn. std::invalid_argument for an unknown kind, and where a hundred seeds in a row only repeat questions.
exercise_sheet make_sheet(const std::string& kind, int count, std::uint64_t seed, bool solutions = true);

std::string to_text(const exercise_sheet& sheet);
/// A document for pdflatex.
std::string to_latex(const exercise_sheet& sheet);
/// A page to be printed from a browser: one file, formulas as MathML.
std::string to_html(const exercise_sheet& sheet);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/exercises/sheet-inl.hpp"
#endif
