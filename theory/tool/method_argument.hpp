// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <filesystem>
#include <stagecraft/tableaux/family.hpp>
#include <stdexcept>
#include <string>
#include <vector>

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

/// METHOD as one of several: a family with its number of stages, or a file without one.
struct method_words {
    std::string method, stages;
};

/// METHOD [S] METHOD [S] ..., a family also as `radau_iia:3`. Throws std::invalid_argument where a number stands in the place of a
/// method.
inline std::vector<method_words> methods_of(const std::vector<std::string>& words) {
    const auto number = [](const std::string& w) {
        return w.find_first_not_of("0123456789") == std::string::npos;
    };
    std::vector<method_words> all;
    for (std::size_t k = 0; k < words.size(); ++k) {
        const std::string& word = words[k];
        const auto colon = word.find(':');
        if (number(word) && !std::filesystem::exists(word)) {
            if (!all.empty() && !is_family(all.back().method))
                throw std::invalid_argument("stages: a tableau file has its own number");
            throw std::invalid_argument("METHOD: '" + word +
                                        "', allowed: a family and one number of stages, or a tableau file");
        }
        if (!is_family(word))
            all.push_back({word, ""});
        else if (colon != std::string::npos)
            all.push_back({word.substr(0, colon), word.substr(colon + 1)});
        else if (k + 1 < words.size())
            all.push_back({word, words[++k]});
        else
            all.push_back({word, ""});
    }
    return all;
}

/// Throws std::invalid_argument where a file is followed by a number of stages.
inline void require_no_stages(const std::string& stages) {
    if (!stages.empty()) throw std::invalid_argument("stages: a tableau file has its own number");
}

}  // namespace stagecraft::tool
