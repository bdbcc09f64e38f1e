// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <stagecraft/tableaux/read_partitioned.hpp>
#include <stagecraft/theory/existence/nearby_method.hpp>
#include <string>
#include <tuple>
#include <vector>

namespace stagecraft::theory::detail {

/// Tables and claims on trial.
struct existence_subject {
    std::vector<tableaux::tableau_file> partners;
    tableaux::claims claims;
    tableaux::coupling coupling = tableaux::coupling::additive;
    bool alone = true;
};

/// A search and what came of it.
struct existence_attempt {
    sought_method method;
    nearby_method found;
    identity_gap gap;
    std::vector<int> orders;
    std::size_t conditions = 0;

    /// More proved first, then fewer equations left.
    auto rank() const {
        return std::tuple(found.all_equations, found.exists, orders.size(),
                          -static_cast<long>(found.not_solved.size()));
    }
};

/// How far the farthest entry is from what is written, its name, and how many times its own rounding the worst one is.
struct moved_entries {
    tableaux::bound most = 0, in_roundings = 0;
    std::string farthest = "all", worst;
    std::size_t quotients = 0;  ///< how many entries written as p/q are another number

    /// A table that is rounded from the method, as far as digits go: 64 times the rounding of each entry.
    bool is_near() const { return in_roundings <= 64; }
};

/// What a file has to be for the search. Throws tableaux::unusable_input as certify_existence.
existence_subject subject_of(const tableaux::method_file& file);

/// Searches with fewer and fewer of the equations that may be in the way of a proof. `trouble`: why the first found nothing.
existence_attempt best_attempt(const existence_subject& s, const std::vector<int>& orders, int digits,
                               std::string& trouble);

moved_entries moved(const existence_attempt& a);

/// The files with all digits; an entry that is exactly known stays, as a fraction where it was a decimal. They claim
/// orders only. Null where a digit is not decided.
nlohmann::ordered_json polished_json(const tableaux::method_file& file, const existence_attempt& a,
                                     int digits);

}  // namespace stagecraft::theory::detail

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/existence/existence_attempt-inl.hpp"
#endif
