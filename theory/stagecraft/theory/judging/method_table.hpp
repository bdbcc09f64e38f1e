// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/theory/judging/file_certificate.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace stagecraft::theory {

/// The columns of `method_row`, as the first two lines of a Markdown table.
std::string method_table_head();

/// One row of a Markdown table, everything but name and source taken from what the certificate found. Of the
/// source, the part before the first semicolon.
std::string method_row(const file_certificate& c);

/// The tableau files (*.json) of a folder, by name. Throws std::invalid_argument where there is no such
/// folder.
std::vector<std::filesystem::path> tableau_files_in(const std::filesystem::path& folder);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/method_table-inl.hpp"
#endif
