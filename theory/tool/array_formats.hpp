// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace stagecraft::tool {

/// A tableau as arrays of a language.
struct array_format {
    std::string_view name;
    std::string_view matrix, list;  ///< before the numbers; NAME and S stand for the name and the stages
    std::string_view row_open, row_close;    ///< of a row of A
    std::string_view between_rows, between;  ///< rows, numbers
    std::string_view matrix_end, list_end;
};

/// A language that is not yet written is a line here.
inline constexpr std::array<array_format, 5> array_formats{{
    {"c", "static const double NAME[S][S] = {", "static const double NAME[S] = {", "{", "}", ",\n    ", ", ",
     "};", "};"},
    {"cpp", "constexpr std::array<std::array<double, S>, S> NAME{{", "constexpr std::array<double, S> NAME{",
     "{", "}", ",\n    ", ", ", "}};", "};"},
    {"python", "NAME = [", "NAME = [", "[", "]", ",\n    ", ", ", "]", "]"},
    {"julia", "NAME = [", "NAME = [", "", "", "\n    ", " ", "]", "]"},
    {"matlab", "NAME = [", "NAME = [", "", "", ";\n    ", ", ", "];", "];"},
}};

using numbers = std::vector<std::string>;

inline std::string joined(const numbers& all, std::string_view between) {
    std::string text;
    for (const auto& x : all) text += (text.empty() ? "" : std::string(between)) + x;
    return text;
}

inline std::string opening(std::string_view pattern, std::string_view name, std::size_t stages) {
    std::string text;
    while (!pattern.empty()) {
        const bool is_name = pattern.starts_with("NAME"), size = pattern.starts_with("S");
        text += is_name ? std::string(name)
                : size  ? std::to_string(stages)
                        : std::string(pattern.substr(0, 1));
        pattern.remove_prefix(is_name ? 4 : 1);
    }
    return text;
}

/// A, b, c, and b_embedded unless it is empty.
inline std::string as_arrays(const array_format& f, const std::vector<numbers>& A, const numbers& b,
                             const numbers& c, const numbers& b_embedded) {
    std::string text = opening(f.matrix, "A", b.size());
    for (std::size_t i = 0; i < A.size(); ++i)
        text += (i == 0 ? "" : std::string(f.between_rows)) + std::string(f.row_open) +
                joined(A[i], f.between) + std::string(f.row_close);
    text += std::string(f.matrix_end) + "\n";
    const auto list = [&](std::string_view name, const numbers& all) {
        if (!all.empty())
            text += opening(f.list, name, b.size()) + joined(all, f.between == " " ? ", " : f.between) +
                    std::string(f.list_end) + "\n";
    };
    list("b", b);
    list("c", c);
    list("b_embedded", b_embedded);
    return text;
}

/// A table of Markdown, c on the left, b below.
inline std::string as_markdown(const std::vector<numbers>& A, const numbers& b, const numbers& c,
                               const numbers& b_embedded) {
    std::string text = "| c | A |" + std::string(b.size() - 1, '|') + "\n|";
    for (std::size_t j = 0; j <= b.size(); ++j) text += "---|";
    text += "\n";
    for (std::size_t i = 0; i < A.size(); ++i) text += "| " + c[i] + " | " + joined(A[i], " | ") + " |\n";
    text += "| **b** | " + joined(b, " | ") + " |\n";
    if (!b_embedded.empty()) text += "| **b_embedded** | " + joined(b_embedded, " | ") + " |\n";
    return text;
}

}  // namespace stagecraft::tool
