// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/reading.hpp>
#include <string>

namespace stagecraft::tool {

/// How `certify --exists` reads a file, and where the polished table goes; nowhere where `polished` is empty.
struct existence_options {
    tableaux::reading how;
    bool json = false;
    int digits = 60;
    std::string polished;
};

/// Prints the existence certificate of one tableau file ("-": standard input). Returns its exit code. Throws
/// tableaux::unusable_input, and std::invalid_argument where the polished table cannot be written.
int certify_existence_of(const std::string& path, const existence_options& options);

}  // namespace stagecraft::tool
