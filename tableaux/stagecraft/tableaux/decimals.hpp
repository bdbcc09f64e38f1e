// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>
#include "stagecraft/tableaux/family.hpp"
#include "stagecraft/tableaux/nodal.hpp"

namespace stagecraft::tableaux {

/// A tableau as text: c, b and the rows of A, every number correctly rounded to `digits` significant decimal
/// digits (ties to even; zero is "0").
struct decimal_tableau {
    std::vector<std::string> c;
    std::vector<std::vector<std::string>> A;
    std::vector<std::string> b;
};

namespace rounding {

/// Takes a tableau over any scalar to text, number by number.
template <class Table, class Text>
decimal_tableau texts(const Table& t, Text text) {
    decimal_tableau out;
    for (Eigen::Index i = 0; i < t.c.size(); ++i) {
        out.c.push_back(text(t.c(i)));
        out.b.push_back(text(t.b(i)));
        out.A.emplace_back();
        for (Eigen::Index j = 0; j < t.c.size(); ++j) out.A.back().push_back(text(t.A(i, j)));
    }
    return out;
}

}  // namespace rounding

/// The decimal tableau of a method. If the nodes lie in a quadratic field the numbers are exact before they
/// are rounded, so that 1/4 to one digit is recognised as a tie. Otherwise they come from enclosures, whose
/// precision is increased until all ends agree. Cost: that of `enclose` and two conversions per entry. Throws
/// std::invalid_argument for digits < 1 and undecided where a rounding stays undecided.
decimal_tableau decimals(const nodal_polynomial& w, construction rule, int digits);

decimal_tableau decimals(family f, int s, int digits);

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/decimals-inl.hpp"
#endif
