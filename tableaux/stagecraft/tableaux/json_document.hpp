// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <set>
#include <stagecraft/tableaux/reading.hpp>
#include <string>
#include <string_view>
#include <vector>

/// JSON documents whose errors name line and entry, and the arrays of numbers in them.

namespace stagecraft::tableaux {

namespace json_reader {

using nlohmann::json;

/// Printable and short: what a message may quote of a hostile file.
std::string in_quotes(std::string_view text);

/// A JSON object in a text: the whole of it, or one that stands at the path `at` and is called `within`.
struct document {
    std::string_view text;
    json root;
    std::string at = {};
    std::string within = {};

    document part(const std::string& path, const std::string& part_name, const json& value) const;
};

/// Raises unusable_input for the entry at a path in the document.
[[noreturn]] void reject(const document& d, const std::string& path, const std::string& entry_name,
                         const std::string& what);

document parse(std::string_view text);

entry number(const document& d, const json& value, const std::string& path, const std::string& entry_name);

std::vector<entry> numbers(const document& d, const json& value, const std::string& path,
                           const std::string& vector_name, std::size_t expected);

/// Throws for a key that is not known, and where a required one is missing.
void require_keys(const document& d, const std::set<std::string>& known,
                  std::initializer_list<const char*> required);

/// b, whose length is the number of stages.
std::vector<entry> weights(const document& d);

/// The square matrix of that key.
std::vector<std::vector<entry>> rows(const document& d, const std::string& key, std::size_t s);

/// b_theta: for each stage the coefficients of theta, theta^2, ...
std::vector<std::vector<entry>> polynomials(const document& d, std::size_t s);

std::string text_field(const document& d, const char* key);

/// The reading with the larger of its tolerance and the document's, "tolerance": "1e-12".
reading with_tolerance_of(const document& d, reading how);

}  // namespace json_reader

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/json_document-inl.hpp"
#endif
