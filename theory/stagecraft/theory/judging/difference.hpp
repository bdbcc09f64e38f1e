// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/theory/judging/file_certificate.hpp>
#include <string>
#include <vector>

namespace stagecraft::theory {

/// A tableau file and its certificate.
struct certified_file {
    tableaux::tableau_file file;
    file_certificate certificate;
};

/// What one finding says, for a comparison.
std::string in_brief(const finding& f);

/// Is every entry of the tableau known exactly?
bool all_exact(const tableaux::tableau_file& t);

/// The differences of two tableaux, a line each: entries (exact numbers that differ, others whose enclosures
/// have no number in common), then orders and properties. Empty where there are none.
std::vector<std::string> differences(const certified_file& x, const certified_file& y);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/difference-inl.hpp"
#endif
