// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/reading.hpp>
#include <stagecraft/theory/judging/file_certificate.hpp>
#include <string>
#include <string_view>

/// The checker, compiled once (certify_file.cpp) for the command and for all tests of it.
namespace certify_once {

/// theory::certify of a tableau given as JSON text. Throws tableaux::unusable_input.
stagecraft::theory::file_certificate certify(std::string_view text);
/// The same for a file.
stagecraft::theory::file_certificate certify_file(const std::string& path);
/// theory::certify of a method of one or several tableaux; partners are files relative to `folder`.
stagecraft::theory::file_certificate certify_method(std::string_view text, const std::string& folder = ".");
/// theory::certify_text: what the command prints, and its exit code.
int exit_code(std::string_view text, bool as_json, std::string& out, std::string& err,
              const stagecraft::tableaux::reading& how = {});

}  // namespace certify_once
