// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <optional>
#include <stagecraft/tableaux/partitioned_file.hpp>
#include <stagecraft/tableaux/quadratic.hpp>
#include <stagecraft/tableaux/rational.hpp>
#include <stagecraft/tableaux/tableau_file.hpp>
#include <string>
#include <vector>

namespace stagecraft::theory {

/// A number of a table next to which a method is sought: known exactly as a rational number or as a surd, or to `radius`
/// about `value`.
struct sought_number {
    tableaux::rational value = 0;
    tableaux::rational radius = 0;
    bool known = true;                             ///< it is `value`
    std::optional<tableaux::quadratic> surd = {};  ///< or this, and `known` is false
    std::string name;          ///< of the first entry that has it: "A[3][2]", "explicit: b[1]"
    bool computed = false;     ///< written as an expression, 1 - p/q - ...
    bool is_quotient = false;  ///< written as p/q, and taken as rounded
};

/// Which rounded entries are one number where they are written alike, with eight digits or more.
enum class alike {
    anywhere,
    in_a_column,  ///< and on the diagonal: b as the last row of A, what the tableaux of an additive method have in common
    nowhere
};

/// The method that rounded tables are meant to be, entry by entry as indices into `numbers`. Number 0 is zero.
struct sought_method {
    using row = std::vector<std::size_t>;

    int stages = 0;
    std::vector<sought_number> numbers;
    std::vector<std::vector<row>> A;   ///< of each tableau
    std::vector<row> weights;          ///< b of each tableau, then b_embedded of each where they have it
    std::vector<row> nodes;            ///< c, different ones once
    std::vector<std::size_t> node_of;  ///< which of them a tableau has

    std::size_t partners() const { return A.size(); }
    bool is_zero(std::size_t number) const { return number == 0; }
};

/// The numbers of the files. Nodes that are left out
/// are sums of rows; those that agree within their rounding are the same.
sought_method sought(const std::vector<tableaux::tableau_file>& partners, alike same = alike::anywhere);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/existence/sought_method-inl.hpp"
#endif
