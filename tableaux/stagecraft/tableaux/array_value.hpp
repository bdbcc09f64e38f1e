// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace stagecraft::tableaux::program_text {

/// A number as an entry of a tableau file has it ("1/2-sqrt(3)/6"), and the line it stands in.
struct cell {
    std::string text;
    std::size_t line = 0;
};

/// A number or an array of a program.
struct value {
    bool is_array = false;
    bool nested = false;                  ///< an array of arrays, or one in several rows
    bool reshaped = false;                ///< an array in one row that a program gives another shape
    bool by_columns = false;              ///< of a reshaped one: as Fortran, Julia and Matlab do
    std::vector<std::vector<cell>> rows;  ///< one row with one cell where it is a number

    std::size_t numbers() const;
    /// All cells, row after row.
    std::vector<cell> all() const;
};

/// Why something is not understood.
struct not_understood {
    std::string what;
    std::size_t line = 0;  ///< 0 where only who asked knows
};

/// A number.
value number_value(std::string text, std::size_t line);

/// The text, which must not be too long for an entry. Throws not_understood.
const std::string& bounded(const std::string& text);

/// In parentheses unless it is a number, a call or in parentheses.
std::string operand(const std::string& text);

/// x with y cell by cell, by one of + - * / ^; a number goes with every cell. Throws not_understood for other arrays.
value combined(value x, const std::string& sign, const value& y);

/// An array of numbers, or of rows. Throws not_understood for both and for more than two dimensions.
value list(std::vector<value> parts);

/// An array from what stands in its rows: numbers, or one array each. Throws not_understood for anything else.
value of_rows(std::vector<std::vector<value>> rows);

/// The same numbers in one row, to be given the shape that a tableau needs.
void reshape(value& v, bool by_columns);

/// Throws not_understood where the rows have different lengths.
void transpose(value& v);

}  // namespace stagecraft::tableaux::program_text

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/array_value-inl.hpp"
#endif
