// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/partitioned_file.hpp>
#include <stagecraft/tableaux/tableau_file.hpp>
#include <stagecraft/theory/judging/file_certificate.hpp>
#include <stagecraft/theory/judging/resolution.hpp>
#include <string>
#include <vector>

namespace stagecraft::theory {

/// The data of a file understood otherwise than as they are written.
struct other_reading {
    tableaux::tableau_file file;
    std::string what;  ///< "quotients of 13 digits"
    std::string rule;  ///< how far entries may be off then, where `what` does not say it
};

struct other_coupled_reading {
    tableaux::partitioned_file file;
    std::string what, rule;
};

/// What data can be meant as that are refuted as they are written, the narrowest first: decimals cut off and not
/// rounded; quotients of many digits as rounded numbers; decimals as doubles that were computed, off by 1, 2 or 4 units
/// in the last place. From the data alone: empty where they are short fractions, surds, decimals of more digits and the
/// like.
std::vector<other_reading> other_readings(const tableaux::tableau_file& file);
std::vector<other_coupled_reading> other_readings(const tableaux::partitioned_file& file);

/// Says in `other` what the data were taken as, what fails as they are written (`written`), and which misprint need not
/// show.
void describe(const std::string& what, const std::string& rule, const resolution& resolved,
              const file_certificate& written, file_certificate& other);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/other_readings-inl.hpp"
#endif
