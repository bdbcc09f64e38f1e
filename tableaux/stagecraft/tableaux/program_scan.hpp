// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>
#include "stagecraft/tableaux/program_tokens.hpp"

/// What a program assigns, without understanding the program: names, where they stand, and the tokens behind them.

namespace stagecraft::tableaux::program_text {

/// Where names belong together: within brackets (a struct, a dictionary, a call, a body), or in a class, function or case.
struct scope {
    std::size_t parent = nowhere;
    std::string name;  ///< of the variable, class, function or case; empty where it has none
};

/// "NAME = VALUE", "NAME: VALUE" and the like, wherever it stands.
struct assignment {
    std::string name;  ///< as written: "heun.A", "B->b", "A_heun"
    std::size_t scope = 0;
    std::size_t line = 0;
    std::size_t begin = 0, end = 0;    ///< tokens of the value
    std::vector<std::size_t> index{};  ///< tokens where the index brackets behind the name begin
    std::size_t sign = 0;              ///< token of "=" or what stands for it
    bool element = false;              ///< a statement that begins "NAME[..] =", not a declaration
    bool changes = false;              ///< "+=" and the like
    bool closed = true;                ///< its brackets are
    bool list = false;  ///< the value is a list without brackets: "A << 0, 1;", "DATA A /0, 1/"
    bool by_columns = false;
    bool returned = false;     ///< by a function of this name
    bool one_of_many = false;  ///< "x, NAME = f(y)"
};

/// "NAME(...)" for a name that `registers` asks for.
struct registration {
    std::string name;
    std::size_t scope = 0;
    std::size_t line = 0;
    std::size_t open = 0;  ///< token of the parenthesis
};

/// No program has deeper ones that matter.
inline constexpr int deepest_scope = 64;

struct program {
    std::vector<token> tokens;
    std::vector<scope> scopes;  ///< the first is the whole program
    std::vector<assignment> assignments;
    std::vector<registration> registrations;

    /// Whether one of the scopes contains the other.
    bool related(std::size_t x, std::size_t y) const;
    /// The nearest name of a scope or of those around it.
    std::string name_of(std::size_t scope) const;
};

/// All assignments in order; those in a scope called `claims` belong to the scope around it. Linear in the source.
program scan(std::string_view source);

}  // namespace stagecraft::tableaux::program_text

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/program_scan-inl.hpp"
#endif
