// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

namespace stagecraft::tool {

/// Prints the certificate of the tableau file at `path`. Returns 0 when nothing claimed is refuted,
/// otherwise 1. Throws tableaux::unusable_input, a std::invalid_argument of one line with file, line and
/// entry.
int certify_file(const std::string& path, bool json);

}  // namespace stagecraft::tool
