// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/reading.hpp>
#include <string>
#include <vector>

namespace stagecraft::tool {

/// How `certify` reads files and what it prints.
struct certify_options {
    tableaux::reading how;
    bool json = false;
    bool from_text = false;  ///< arrays of a program, not JSON
    bool strict = false;     ///< what looks like coefficients or a claim in a program must be used
    std::string junit;       ///< file for a JUnit report; empty: none
};

/// Exit codes: 0 nothing claimed is refuted, 1 something is, 2 unusable input, 3 a claim is beyond what the
/// digits given can test. Of several files the first of 1, 2, 3, 0 that occurs.
///
/// Prints the certificate of one tableau file ("-": standard input), those of all tableaux of one program, or a line for
/// each of several files, of text or of JSON; folders stand for the tableau files in them. Returns the exit code. Throws
/// tableaux::unusable_input, a std::invalid_argument of one line with file, line and entry, where a single file
/// is unusable or a folder has none.
int certify_files(const std::vector<std::string>& paths, const certify_options& options);

/// Prints {"exit_code": 2, "error": what}.
void print_unusable(const std::string& what);

/// Prints what differs between two tableau files; 0 nothing, 1 something. Throws tableaux::unusable_input.
int diff_files(const std::string& first, const std::string& second, const tableaux::reading& how);

/// Prints a Markdown table of what the tableaux in these files and folders are.
void print_method_table(const std::vector<std::string>& paths, const tableaux::reading& how);

}  // namespace stagecraft::tool
