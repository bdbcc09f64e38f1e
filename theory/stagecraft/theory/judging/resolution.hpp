// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/partitioned_file.hpp>
#include <stagecraft/tableaux/tableau_file.hpp>
#include <string>
#include <vector>

namespace stagecraft::theory {

/// The smallest misprint that a file whose entries have uncertainties cannot hide.
struct resolution {
    std::string size;                 ///< every change of one entry by so much refutes a claim
    std::string entry;                ///< the one that shows last
    std::vector<std::string> unseen;  ///< entries of which a change by 1 is seen by no claim
};

/// Found by changing each entry that is not zero, up and down, by the largest uncertainty of one, and by twice as much as
/// long as that does not show, and judging the claims. Cost: two judgements for each entry, and two for each doubling.
resolution resolution_of(const tableaux::tableau_file& file);
resolution resolution_of(const tableaux::partitioned_file& file);

/// "resolution: a change of one entry by 3e-25 or more shows, that of A[3][1] last"
std::string in_words(const resolution& r);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/resolution-inl.hpp"
#endif
