// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace stagecraft::tableaux::program_text {

inline constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

/// A word, number, text in quotes or sign of a program, in the notation that C, C++, Python, Julia, Matlab, Fortran, R
/// and Rust have in common.
struct token {
    enum class kind { word, number, text, sign, line_end };
    kind is = kind::sign;
    std::string text;  ///< of a number without suffixes, with e for its exponent; of a text what is quoted
    std::size_t line = 1;           ///< from 1
    std::size_t column = 0;         ///< from 0
    bool blank_before = false;      ///< or the beginning of a line
    std::size_t partner = nowhere;  ///< of a bracket: the token that closes or opens it
};

/// The tokens of a program, at last a line's end. Comments, docstrings and marks of a line that goes on are left out;
/// "#define NAME VALUE" is NAME = VALUE; Fortran's (/ and /) are brackets. Brackets that are not closed have no partner.
/// Linear in the source.
std::vector<token> tokens_of(std::string_view source);

bool is_sign(const token& t, std::string_view text);
bool is_open(const token& t);
bool is_close(const token& t);

}  // namespace stagecraft::tableaux::program_text

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/program_tokens-inl.hpp"
#endif
