// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace stagecraft::tool {

/// The whole number that `text` is, between `least` and `most`. Throws std::invalid_argument that names the
/// argument and what is allowed.
inline int whole_number(std::string_view argument, const std::string& text, int least, int most) {
    std::size_t used = 0;
    long long n = 0;
    try {
        n = std::stoll(text, &used);
    } catch (const std::exception&) {
        used = 0;
    }
    if (used == 0 || used != text.size() || n < least || n > most)
        throw std::invalid_argument(std::string(argument) + ": '" + text + "' is not a whole number from " +
                                    std::to_string(least) + " to " + std::to_string(most));
    return static_cast<int>(n);
}

}  // namespace stagecraft::tool
