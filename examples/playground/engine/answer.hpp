// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <exception>
#include <new>
#include <nlohmann/json.hpp>
#include <stagecraft/tableaux/precision.hpp>
#include <stagecraft/tableaux/program_text.hpp>
#include <stagecraft/tableaux/read_partitioned.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace playground {

namespace tableaux = stagecraft::tableaux;
using json = nlohmann::ordered_json;

inline json refusal(int exit_code, std::string what) {
    for (char& c : what)
        if (c == '\n') c = ' ';
    return {{"error", std::move(what)}, {"exit_code", exit_code}};
}

/// The JSON that `work` makes, or its exception as one line with the exit code that it has in the command. The text
/// stays where it is until the next call.
template <class Work>
const char* answered(Work work) {
    static std::string kept;
    json answer;
    try {
        answer = work();
    } catch (const std::invalid_argument& e) {
        answer = refusal(2, e.what());
    } catch (const tableaux::undecided& e) {
        answer = refusal(3, std::string("not decided: ") + e.what());
    } catch (const std::bad_alloc&) {
        answer = refusal(3, "not decided: the memory of this page is used up");
    } catch (const std::exception& e) {
        answer = refusal(1, e.what());
    }
    kept = answer.dump(-1, ' ', false, json::error_handler_t::replace);
    return kept.c_str();
}

/// How a text is read: `from` is "json", "text" or, by its first character, "auto".
inline bool is_program_text(std::string_view text, std::string_view from) {
    if (from == "text" || from == "json") return from == "text";
    if (from != "auto")
        throw std::invalid_argument("from: '" + std::string(from) + "', allowed: auto, json, text");
    const auto first = text.find_first_not_of(" \t\r\n");
    return first != text.npos && text[first] != '{';
}

/// The one tableau that a text holds.
inline tableaux::tableau_file only_tableau(std::string_view text, std::string_view from,
                                           std::string_view decimals) {
    const tableaux::reading how{tableaux::decimals_from_name(decimals)};
    if (is_program_text(text, from)) {
        auto program = tableaux::read_program_text(text, how);
        if (program.tableaux.size() == 1) return std::move(program.tableaux.front());
    } else {
        const auto file = tableaux::read_method_text(text, how);
        if (const auto* one = std::get_if<tableaux::tableau_file>(&file)) return *one;
    }
    throw std::invalid_argument("text: several tableaux; this is for one");
}

}  // namespace playground
