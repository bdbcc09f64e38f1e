// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdlib>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <stagecraft/tableaux/read.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace stagecraft::tableaux {

namespace program_text {

inline bool opens(char ch) { return ch == '[' || ch == '{'; }
inline bool closes(char ch) { return ch == ']' || ch == '}'; }
inline bool is_blank(char ch) { return std::isspace(static_cast<unsigned char>(ch)) != 0; }
inline bool is_word(char ch) { return std::isalnum(static_cast<unsigned char>(ch)) != 0 || ch == '_'; }

/// Without comments: # and % to the end of the line, as in Python, Julia and Matlab.
inline std::string without_comments(std::string_view text) {
    std::string out;
    bool comment = false;
    for (const char ch : text) {
        comment = ch != '\n' && (comment || ch == '#' || ch == '%');
        if (!comment) out += ch;
    }
    return out;
}

/// The bracketed text that follows "NAME =" or "NAME[..][..] =", brackets included; empty where there is none.
inline std::string array_named(std::string_view text, std::string_view name) {
    for (std::size_t at = text.find(name); at != std::string_view::npos; at = text.find(name, at + 1)) {
        if (at > 0 && is_word(text[at - 1])) continue;
        std::size_t i = at + name.size();
        if (i < text.size() && is_word(text[i])) continue;
        const std::size_t sign = text.find_first_of("=:", i);
        if (sign == std::string_view::npos) break;
        const auto between = text.substr(i, sign - i);  // blanks, or sizes as in b[4]
        if (between.find_first_not_of(" \t[]0123456789sS") != std::string_view::npos) continue;
        std::size_t begin = sign + 1;
        while (begin < text.size() && !opens(text[begin]) && text[begin] != ';' && text[begin] != '\n')
            ++begin;
        if (begin == text.size() || !opens(text[begin])) continue;
        int depth = 0;
        for (i = begin; i < text.size(); ++i) {
            depth += opens(text[i]) ? 1 : closes(text[i]) ? -1 : 0;
            if (depth == 0) return std::string(text.substr(begin, i + 1 - begin));
        }
    }
    return {};
}

/// "1//2" as in Julia, "Rational(1, 2)" and "Fraction(1, 2)" as in Python, "0.5f" and "0.5L" as in C, "**".
inline std::string plain_number(std::string text) {
    const auto replace_all = [&](std::string_view from, std::string_view to) {
        for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
            text.replace(at, from.size(), to);
    };
    replace_all("//", "/");
    replace_all("**", "^");
    for (const std::string_view type : {"sympy.", "np.", "math.", "std::"}) replace_all(type, "");
    for (const std::string_view type : {"Rational", "Fraction"}) {
        for (std::size_t at = text.find(type); at != std::string::npos; at = text.find(type)) {
            text.erase(at, type.size());
            const auto comma = text.find(',', at);
            if (comma != std::string::npos) text.replace(comma, 1, ")/(");
        }
    }
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool suffix = std::string_view("fFlL").find(text[i]) != std::string_view::npos && i > 0 &&
                            (std::isdigit(static_cast<unsigned char>(text[i - 1])) || text[i - 1] == '.') &&
                            (i + 1 == text.size() || !is_word(text[i + 1]));
        if (!suffix) out += text[i];
    }
    return out;
}

/// The numbers of a row: apart by commas outside parentheses or, where there are none, by blanks.
inline std::vector<std::string> numbers_of(std::string_view row) {
    const auto split = [&](auto separates) {
        std::vector<std::string> parts(1);
        int depth = 0;
        for (const char ch : row) {
            depth += ch == '(' ? 1 : ch == ')' ? -1 : 0;
            if (depth == 0 && separates(ch))
                parts.emplace_back();
            else
                parts.back() += ch;
        }
        for (auto& p : parts) {
            p.erase(0, std::min(p.find_first_not_of(" \t\r\n"), p.size()));
            p.erase(p.find_last_not_of(" \t\r\n") + 1);
        }
        std::erase(parts, "");
        return parts;
    };
    auto parts = split([](char ch) { return ch == ','; });
    if (parts.size() == 1 && row.find(',') == std::string_view::npos) parts = split(is_blank);
    for (auto& p : parts) p = plain_number(std::move(p));
    return parts;
}

/// The rows inside the outer brackets: inner brackets, or apart by semicolons (Julia, Matlab); or one row.
inline std::vector<std::vector<std::string>> rows_of(const std::string& array) {
    const std::string_view inside = std::string_view(array).substr(1, array.size() - 2);
    std::vector<std::vector<std::string>> rows;
    std::size_t begin = 0;
    if (std::any_of(inside.begin(), inside.end(), opens)) {
        for (std::size_t i = 0; i < inside.size(); ++i) {
            if (opens(inside[i])) begin = i + 1;
            if (closes(inside[i])) rows.push_back(numbers_of(inside.substr(begin, i - begin)));
        }
        return rows;
    }
    while (begin <= inside.size()) {
        const auto end = std::min(inside.find(';', begin), inside.size());
        if (auto row = numbers_of(inside.substr(begin, end - begin)); !row.empty())
            rows.push_back(std::move(row));
        begin = end + 1;
    }
    return rows;
}

}  // namespace program_text

/// Reads arrays A, b and, where they are there, c and b_embedded (or b_hat, bhat, btilde) as a program in C,
/// Python, Julia or Matlab has them: "A = [[0, 0], [1//2, 0]]", "double b[2] = {0.0, 1.0};", "A = [0 0; 1/2
/// 0]". Short rows of an explicit method's A are filled with zeros. "order = 4" claims that order, as does
/// "embedded_order". Throws unusable_input as read_tableau, where A or b is missing too.
inline tableau_file read_program_text(std::string_view source, const reading& how = {}) {
    const std::string text = program_text::without_comments(source);
    nlohmann::json j = nlohmann::json::object();
    const auto vector_named = [&](const char* key, std::initializer_list<const char*> names) {
        for (const char* name : names)
            if (const auto array = program_text::array_named(text, name); !array.empty()) {
                std::vector<std::string> all;
                for (auto& row : program_text::rows_of(array)) all.insert(all.end(), row.begin(), row.end());
                j[key] = all;
                return;
            }
    };
    vector_named("b", {"b", "B"});
    vector_named("c", {"c", "C"});
    vector_named("b_embedded", {"b_embedded", "b_hat", "bhat", "b_tilde", "btilde", "b2", "bh"});
    for (const char* name : {"A", "a"}) {
        const auto array = program_text::array_named(text, name);
        if (array.empty()) continue;
        auto rows = program_text::rows_of(array);
        if (j.contains("b") && rows.size() + 1 == j["b"].size())
            rows.insert(rows.begin(), {});  // no first row
        for (auto& row : rows)
            if (row.size() < rows.size()) row.resize(rows.size(), "0");
        j["A"] = rows;
        break;
    }
    for (const char* key : {"order", "embedded_order", "stage_order"}) {
        const auto at = text.find(std::string("\n") + key);
        const auto sign = at == std::string::npos ? at : text.find('=', at);
        if (sign != std::string::npos) j["claims"][key] = std::atoi(text.c_str() + sign + 1);
    }
    return read_tableau(j.dump(), how);
}

}  // namespace stagecraft::tableaux
