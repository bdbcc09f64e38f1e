// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <filesystem>
#include <stagecraft/tableaux/family.hpp>
#include <stdexcept>
#include <string>

#include "whole_number.hpp"

/// METHOD [S] as every subcommand reads it: the name of a family and its number of stages, or a tableau file.
namespace stagecraft::tool {

/// What is neither there nor looks like a path is meant as a family.
inline bool is_family(const std::string& method) {
    return method.find_first_of("./") == std::string::npos && method != "-" &&
           !std::filesystem::exists(method);
}

struct family_member {
    tableaux::family family;
    int stages;
};

/// The member of a family with `stages` stages, at most `most`. Throws std::invalid_argument that says what is
/// allowed.
inline family_member member_of_family(const std::string& method, const std::string& stages, int most) {
    const auto f = tableaux::family_from_name(method);
    const int least = tableaux::least_stages(f);
    if (stages.empty())
        throw std::invalid_argument("stages: missing after " + method + "; allowed: a whole number from " +
                                    std::to_string(least) + " to " + std::to_string(most));
    return {f, whole_number("stages", stages, least, most)};
}

/// Throws std::invalid_argument where a file is followed by a number of stages.
inline void require_no_stages(const std::string& stages) {
    if (!stages.empty()) throw std::invalid_argument("stages: a tableau file has its own number");
}

}  // namespace stagecraft::tool
