// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "whole_number.hpp"

namespace stagecraft::tool {

/// Declares one subcommand and its options; its callback does the work and throws std::invalid_argument for
/// input that is not allowed.
using declare = void (*)(CLI::App&);

/// The subcommands that the linked files bring.
inline std::vector<declare>& declarations() {
    static std::vector<declare> all;
    return all;
}

/// At namespace scope in a source file: `static const command families{[](CLI::App& app) { ... }};`
struct command {
    explicit command(declare d) { declarations().push_back(d); }
};

/// Text with control characters as \x1b, so that a name in a file cannot act on a terminal; ends of lines stay.
inline std::string printable(std::string_view text) {
    static constexpr char digits[] = "0123456789abcdef";
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto ch = static_cast<unsigned char>(text[i]);
        const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0;
        const bool high = ch == 0xc2 && next >= 0x80 && next < 0xa0;  // U+0080 to U+009F in UTF-8
        if (high) ++i;
        const unsigned char code = high ? static_cast<unsigned char>(next) : ch;
        if (!high && ((ch >= 0x20 && ch != 0x7f) || ch == '\n'))
            out += text[i];
        else
            (out += "\\x") += {digits[code / 16], digits[code % 16]};
    }
    return out;
}

}  // namespace stagecraft::tool
