// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <iostream>
#include <stagecraft/tableaux/decimals.hpp>
#include <string>

namespace stagecraft::tool {

/// c | A over b in columns as wide as their longest number.
inline void print_text(const tableaux::decimal_tableau& t) {
    std::size_t width = 0;
    const auto widen = [&](const auto& row) {
        for (const std::string& x : row) width = std::max(width, x.size());
    };
    widen(t.c);
    widen(t.b);
    std::for_each(t.A.begin(), t.A.end(), widen);
    const auto print = [&](const std::string& x) {
        std::cout << std::string(width - x.size() + 1, ' ') << x;
    };
    for (std::size_t i = 0; i < t.c.size(); ++i) {
        print(t.c[i]);
        std::cout << " |";
        std::for_each(t.A[i].begin(), t.A[i].end(), print);
        std::cout << "\n";
    }
    std::cout << std::string(width + 2, '-') << "+" << std::string((width + 1) * t.b.size(), '-') << "\n"
              << std::string(width + 2, ' ') << "|";
    std::for_each(t.b.begin(), t.b.end(), print);
    std::cout << "\n";
}

}  // namespace stagecraft::tool
