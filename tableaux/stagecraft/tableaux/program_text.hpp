// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>
#include "stagecraft/tableaux/reading.hpp"
#include "stagecraft/tableaux/tableau_file.hpp"

namespace stagecraft::tableaux {

/// A tableau of a program that cannot be used, and why.
struct unusable_tableau {
    std::string name;
    std::string what;  ///< with the line
};

/// The tableaux of a program, in order; those that cannot be used; and whatever else of it looks like coefficients or like
/// a claim.
struct program_tableaux {
    std::vector<tableau_file> tableaux;
    std::vector<unusable_tableau> unusable;
    std::vector<std::string> unused;  ///< "E (line 12)", "order (line 3): no whole number"
};

/// Reads every tableau of a program in C, C++, Python, Julia, Matlab, Fortran, R or Rust: arrays A and b, and where they are
/// there c and embedded weights, or the difference of both sets of weights. `dialects` in program_names.hpp has the words
/// for them. Arrays belong together where their names begin and end alike ("heun_A" and "heun_b", "At" and "bt") and where
/// they stand in the same brackets, class, function or case; a name that comes again begins the next tableau. Elements may
/// be assigned one by one. A tableau's name is that prefix, or "name = '...'", or that of the variable, class, function or
/// case. Factors, sums, transpositions, roots, fractions and names of numbers are understood as value_of says. A may be a
/// packed lower triangle, with or without its diagonal, and short rows of an explicit method are filled with zeros.
/// "order = 4" and the other words of `claim_words` are claims, also within "claims = {...}" and where a function returns
/// it; a claim outside of all tableaux belongs to the only one that it can belong to.
///
/// Nothing that looks like coefficients or a claim is left out without being told in `unused`. Throws unusable_input, with
/// the line, where brackets of coefficients are not closed, and where there is no tableau. Linear in the source, but for
/// the arithmetic of the entries.
program_tableaux read_program_text(std::string_view source, const reading& how = {});

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/program_text-inl.hpp"
#endif
