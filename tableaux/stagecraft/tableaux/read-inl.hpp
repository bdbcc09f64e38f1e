// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/read.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>
#include <vector>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/json_document.hpp"
#include "stagecraft/tableaux/reading.hpp"
#include "stagecraft/tableaux/stage_forms.hpp"

namespace stagecraft::tableaux {

namespace json_reader {

STAGECRAFT_INLINE std::string claim_names() {
    std::string names;
    for (const auto& c : counted_claims) names.append(names.empty() ? "" : ", ").append(c.name);
    for (const auto& c : yes_no_claims) names.append(", ").append(c.name);
    for (const auto& c : number_claims) names.append(", ").append(c.name);
    return names;
}

/// A number as an entry is written, not negative, or "infinite".
STAGECRAFT_INLINE std::string claimed_number(const document& d, const std::string& key, const json& value) {
    if (value == std::string(infinite)) return std::string(infinite);
    const entry e = number(d, value, "/claims/" + key, "claims." + in_quotes(key));
    if (e.enclosure.upper < 0)
        reject(d, "/claims/" + key, "claims." + in_quotes(key), "must not be negative");
    return e.text;
}

STAGECRAFT_INLINE tableaux::claims read_claims(const document& d) {
    tableaux::claims claims;
    if (!d.root.contains("claims")) return claims;
    const json& stated = d.root["claims"];
    if (!stated.is_object()) reject(d, "/claims", "claims", "must be an object");
    for (const auto& [key, value] : stated.items()) {
        const auto refuse = [&, &key = key](const std::string& what) {
            reject(d, "/claims/" + key, "claims." + in_quotes(key), what);
        };
        const auto counted = std::find_if(counted_claims.begin(), counted_claims.end(),
                                          [&key = key](const auto& c) { return c.name == key; });
        const auto yes_no = std::find_if(yes_no_claims.begin(), yes_no_claims.end(),
                                         [&key = key](const auto& c) { return c.name == key; });
        const auto number = std::find_if(number_claims.begin(), number_claims.end(),
                                         [&key = key](const auto& c) { return c.name == key; });
        if (number != number_claims.end()) {
            claims.*(number->value) = claimed_number(d, key, value);
        } else if (counted != counted_claims.end()) {
            if (!value.is_number_integer() || value < 0 || value > 2 * most_stages)
                refuse("must be an integer from 0 to " + std::to_string(2 * most_stages));
            claims.*(counted->value) = value.get<int>();
        } else if (yes_no != yes_no_claims.end()) {
            if (!value.is_boolean()) refuse("must be true or false");
            claims.*(yes_no->value) = value.get<bool>();
        } else {
            refuse("unknown claim; known are " + claim_names());
        }
    }
    return claims;
}

STAGECRAFT_INLINE void reject_single_claims(const document& d) {
    for (const auto claim : single_claims)
        if (const std::string key(claim); d.root.contains("claims") && d.root["claims"].contains(key))
            reject(d, "/claims/" + key, "claims." + key, "is judged of a single tableau");
}

STAGECRAFT_INLINE void reject_rosenbrock_claims(const document& d) {
    for (const auto claim : rosenbrock_claims)
        if (const std::string key(claim); d.root.contains("claims") && d.root["claims"].contains(key))
            reject(d, "/claims/" + key, "claims." + key, "only a method of the form \"rosenbrock\" has one");
}

STAGECRAFT_INLINE tableau_file tableau(const document& d, const reading& how) {
    if (!d.root.is_object()) reject(d, "", "", "a tableau must be a JSON object");
    if (d.root.contains("tableau")) return tableau(d.part("/tableau", "tableau", d.root["tableau"]), how);
    if (d.root.contains("form") && is_stage_form(text_field(d, "form"))) {
        tableau_file file = from_stage_form(d, how);
        file.name = text_field(d, "name");
        file.source = text_field(d, "source");
        file.claims = read_claims(d);
        reject_rosenbrock_claims(d);
        return file;
    }
    static const std::set<std::string> known{"name",   "source",     "note",     "A",      "b",
                                             "c",      "b_embedded", "b_theta",  "claims", "family",
                                             "stages", "digits",     "tolerance"};
    require_keys(d, known, {"A", "b"});

    tableau_file file;
    file.name = text_field(d, "name");
    file.source = text_field(d, "source");
    file.b = weights(d);
    const std::size_t s = file.b.size();
    file.A = rows(d, "A", s);
    if (d.root.contains("c")) file.c = numbers(d, d.root["c"], "/c", "c", s);
    if (d.root.contains("b_embedded"))
        file.b_embedded = numbers(d, d.root["b_embedded"], "/b_embedded", "b_embedded", s);
    if (d.root.contains("b_theta")) file.b_theta = polynomials(d, s);
    file.claims = read_claims(d);
    reject_rosenbrock_claims(d);
    for (const char* claim : {"dense_order", "dense_smoothness"})
        if (file.b_theta.empty() && d.root.contains("claims") && d.root["claims"].contains(claim))
            reject(d, std::string("/claims/") + claim, std::string("claims.") + claim, "there is no b_theta");
    if (file.claims.dense_order.value_or(0) > largest_dense_order)
        reject(d, "/claims/dense_order", "claims.dense_order",
               "must be at most " + std::to_string(largest_dense_order));
    if (file.claims.dense_smoothness.value_or(0) > 1)
        reject(d, "/claims/dense_smoothness", "claims.dense_smoothness", "must be 0 or 1");
    if (file.claims.embedded_order && file.b_embedded.empty())
        reject(d, "/claims/embedded_order", "claims.embedded_order", "there is no b_embedded");
    apply(with_tolerance_of(d, how), file);
    return file;
}

}  // namespace json_reader

STAGECRAFT_INLINE tableau_file read_tableau(std::string_view text, const reading& how) {
    return json_reader::tableau(json_reader::parse(text), how);
}

STAGECRAFT_INLINE std::string text_of_file(const std::string& path) {
    std::ostringstream text;
    if (path == "-") {
        text << std::cin.rdbuf();
        return text.str();
    }
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (std::filesystem::is_other(status))
        throw unusable_input("cannot read " + path + ": neither a file nor '-' for standard input");
    std::ifstream in(path, std::ios::binary);
    if (!in) throw unusable_input("cannot read " + path);
    if (in.peek() == std::ifstream::traits_type::eof() && !in.bad())
        throw unusable_input(path + ": the file is empty");
    if (!(text << in.rdbuf())) throw unusable_input("cannot read " + path);
    return text.str();
}

STAGECRAFT_INLINE tableau_file read_tableau_file(const std::string& path, const reading& how) {
    const std::string text = text_of_file(path);
    try {
        return read_tableau(text, how);
    } catch (const unusable_input& e) {
        throw unusable_input(path + ": " + e.what());
    }
}

}  // namespace stagecraft::tableaux
