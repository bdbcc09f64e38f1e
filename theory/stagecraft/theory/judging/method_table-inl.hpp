// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/method_table.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

namespace detail {

/// "yes" proved, "no" refuted; in parentheses where rounded data leave it open and the file's claim is all
/// there is; "open" where it claims nothing either.
STAGECRAFT_INLINE std::string answer(const file_certificate& c, std::string_view property) {
    const finding* f = c.find(property);
    if (!f || !f->truth) return "open";
    if (f->truth->is_proved()) return "yes";
    if (f->truth->is_refuted()) return "no";
    if (!f->claimed) return "open";
    return *f->claimed == "true" ? "(yes)" : "(no)";
}

STAGECRAFT_INLINE std::string order_found(const file_certificate& c, std::string_view property) {
    const finding* f = c.find(property);
    return f && f->value ? std::to_string(*f->value) : "open";
}

/// A cell of a Markdown table: | would end it.
STAGECRAFT_INLINE std::string cell(std::string_view text) {
    std::string out;
    for (const char ch : text) {
        if (ch == '|') out += '\\';
        out += ch == '\n' ? ' ' : ch;
    }
    return out;
}

}  // namespace detail

STAGECRAFT_INLINE std::string method_table_head() {
    return "| method | stages | order (embedded) | stage order | A-stable | L-stable | algebraically stable "
           "| "
           "symplectic | entries | source |\n"
           "|---|---|---|---|---|---|---|---|---|---|\n";
}

STAGECRAFT_INLINE std::string method_row(const file_certificate& c) {
    using detail::answer, detail::cell, detail::order_found;
    std::string order = order_found(c, "order");
    if (c.find("embedded_order")) order += "(" + order_found(c, "embedded_order") + ")";
    std::string row = "|";
    for (const std::string& text :
         {cell(c.name), std::to_string(c.stages), order, order_found(c, "stage_order"), answer(c, "A_stable"),
          answer(c, "L_stable"), answer(c, "algebraically_stable"), answer(c, "symplectic"), cell(c.data),
          cell(c.source.substr(0, c.source.find(';')))})
        row += " " + text + " |";
    return row + "\n";
}

STAGECRAFT_INLINE std::vector<std::filesystem::path> tableau_files_in(const std::filesystem::path& folder) {
    if (!std::filesystem::is_directory(folder))
        throw std::invalid_argument("folder: '" + folder.string() + "' is not one");
    std::vector<std::filesystem::path> all;
    for (const auto& item : std::filesystem::directory_iterator(folder))
        if (item.path().extension() == ".json") all.push_back(item.path());
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace stagecraft::theory
