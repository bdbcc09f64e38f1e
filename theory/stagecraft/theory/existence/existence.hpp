// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <stagecraft/tableaux/read_partitioned.hpp>
#include <stagecraft/theory/statements/verdict.hpp>
#include <string>
#include <vector>

namespace stagecraft::theory {

/// From the digits of a rounded table to a theorem on a method near them.
struct existence_certificate {
    std::string name, source;
    /// proved: there is a method with all orders claimed near these entries. refuted: a claim of the table is, so that it is
    /// not rounded from such a method. inconclusive: some conditions are enclosed only, or the search found nothing.
    theory::standing standing = theory::standing::inconclusive;
    std::string theorem;             ///< what is proved, in words; else what is not and why
    std::vector<std::string> notes;  ///< how, and what is not part of it
    int order = 0;                   ///< proved; 0 where nothing is
    std::optional<int> embedded_order;
    std::string distance;  ///< of the farthest entry from what is written
    std::string farthest;  ///< its name
    std::string box;       ///< radius of the enclosures of the entries
    nlohmann::ordered_json
        polished;  ///< the table with all digits asked for, as read_method_text reads it; null where there is none

    /// 0 proved, 1 refuted, 3 otherwise.
    int exit_code() const;
};

/// Whether there is a method of exactly the orders that a file claims (of b and b_embedded; of additive, partitioned and
/// separable methods all coupling conditions), near its entries, with its zeros, with the rational entries that it writes
/// exactly, and with row sums c = A 1. Entries that are written alike are alike (diagonals; b as the last row of A).
///
/// First `certify` judges the file: what it refutes, is refused. Then order_system writes down equations from which all
/// conditions follow, and find_nearby encloses a zero of as many as are independent; what is left must follow from these
/// as polynomials. Cost: that of `certify`, and seconds; of twelve stages and order 8 up to a minute, less where the
/// time_share is shorter. Throws tableaux::unusable_input for Nystrom methods and for forms of low storage, and
/// std::invalid_argument for digits outside 5 to 4000.
existence_certificate certify_existence(const tableaux::method_file& file, int digits = 60);

nlohmann::ordered_json to_json(const existence_certificate& c);

/// The certificate for a reader, several lines.
std::string to_text(const existence_certificate& c);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/existence/existence-inl.hpp"
#endif
