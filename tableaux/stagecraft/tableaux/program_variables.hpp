// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>
#include "stagecraft/tableaux/array_text.hpp"
#include "stagecraft/tableaux/program_scan.hpp"

namespace stagecraft::tableaux::program_text {

/// A name of a program with the array, number or claim behind it.
struct variable {
    enum class kind { array, number, text, flag, other };
    enum class gathered { no, list, matrix };
    struct element {
        std::size_t row = 0, column = 0;
        cell number;
    };

    std::string name;
    std::size_t scope = 0;
    std::size_t line = 0, last_line = 0;
    kind is = kind::other;
    value array;                          ///< or the number
    std::vector<element> elements;        ///< that are assigned one by one, from 0
    std::string text;                     ///< of a text, "true" or "false"
    std::string trouble;                  ///< why it is not read, or empty
    bool by_elements = false;             ///< nothing but elements of it are assigned
    bool returned = false;                ///< by a function of this name
    bool in_array = false;                ///< an array is made of it
    bool used = false;                    ///< by another one or a tableau
    gathered gathered_as = gathered::no;  ///< an array that gather_indexed made
    std::vector<std::size_t> members{};   ///< of what

    std::string_view last() const { return last_part(name); }
    std::string owner() const { return name.substr(0, name.size() - last().size()); }
};

/// The names of a program that have arrays, numbers, texts or true and false, in order, with names replaced by what they
/// stand for; and the lines of brackets with numbers that have no name.
struct variables {
    std::vector<variable> all;
    std::vector<std::size_t> unnamed;
};

/// Throws std::invalid_argument, with the line, where the brackets of what is called as a coefficient are not closed.
variables variables_of(const program& p);

}  // namespace stagecraft::tableaux::program_text

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/program_variables-inl.hpp"
#endif
