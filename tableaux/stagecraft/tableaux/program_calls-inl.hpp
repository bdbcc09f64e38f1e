// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/program_calls.hpp"

#include <algorithm>
#include <cctype>

#include "stagecraft/compiled.hpp"

namespace stagecraft::tableaux::program_text {

STAGECRAFT_INLINE bool is_wrapper(std::string_view word) {
    const bool no_small =
        std::none_of(word.begin(), word.end(), [](unsigned char ch) { return std::islower(ch) != 0; });
    return no_small || std::find(wrappers.begin(), wrappers.end(), word) != wrappers.end();
}

STAGECRAFT_INLINE named_arguments named_arguments_of(const std::vector<token>& tokens, std::size_t open) {
    const auto close = tokens[open].partner;
    named_arguments out{close};
    std::size_t last_comma = open;
    for (std::size_t i = open + 1; i < close; ++i) {
        if (is_open(tokens[i]) && tokens[i].partner != nowhere) i = tokens[i].partner;
        if (is_sign(tokens[i], ",")) last_comma = i;
        if (!is_sign(tokens[i], "=")) continue;
        out.stop = std::min(out.stop, last_comma == open ? open + 1 : last_comma);
        const auto& key = tokens[i - 1].text;
        const auto& what = tokens[std::min(i + 1, close)].text;
        out.by_columns = out.by_columns || (key == "order" && what == "F");
        out.by_rows =
            out.by_rows || (key == "order" && what != "F") || (key == "byrow" && what.starts_with("T"));
    }
    return out;
}

STAGECRAFT_INLINE value wrapped_value(const std::string& full, std::vector<value> parts) {
    const auto arrays = std::count_if(parts.begin(), parts.end(), [](const value& v) { return v.is_array; });
    if (parts.size() == 1) return std::move(parts.front());
    if (arrays == 0 && parts.size() == 2) return combined(std::move(parts[0]), "/", parts[1]);
    if (arrays == 1 && parts.back().is_array) {  // Matrix(2, 2, [...])
        value v = std::move(parts.back());
        if (!v.nested) reshape(v, false);
        return v;
    }
    throw not_understood{"the arguments of '" + full + "'"};
}

STAGECRAFT_INLINE value value_of_call(call_does does, const std::string& last, std::vector<value> parts,
                                      std::size_t line) {
    value& first = parts.front();
    const bool numbers = std::none_of(parts.begin(), parts.end(), [](const value& v) { return v.is_array; });
    if (does == call_does::list || does == call_does::list_by_columns) {
        if (numbers && parts.size() == 1 && last == "c") throw not_understood{"'c(...)', an element of it,"};
        value v = numbers || parts.size() > 1 ? list(std::move(parts)) : std::move(first);
        if (does == call_does::list_by_columns && !v.nested) reshape(v, true);
        return v;
    }
    if (does == call_does::ones) {
        std::size_t n = 1;
        const std::size_t sizes = last == "fill" ? 1 : 0;
        for (std::size_t i = sizes; i < parts.size(); ++i) {
            const auto& size = parts[i].is_array ? std::string() : parts[i].rows[0][0].text;
            if (size.empty() || size.size() > 2 || size.find_first_not_of("0123456789") != nowhere)
                throw not_understood{"the arguments of '" + last + "'"};
            n *= std::stoul(size);
        }
        const std::string number = sizes > 0 ? first.rows[0][0].text : "1";
        return {
            true, false, false, false, {std::vector<cell>(std::min<std::size_t>(n, 4096), {number, line})}};
    }
    if (does == call_does::root) {
        if (!numbers || parts.size() != 1) throw not_understood{"the arguments of '" + last + "'"};
        const std::string known = last == "PetscSqrtReal" || last == "SUNRsqrt" ? "sqrt" : last;
        return number_value(bounded(known + "(" + first.rows[0][0].text + ")"), line);
    }
    if (does == call_does::square) {
        const value x = first;
        return combined(x, "*", x);
    }
    if (does == call_does::power) {
        if (!numbers || parts.size() != 2) throw not_understood{"the arguments of '" + last + "'"};
        return combined(std::move(first), "^", parts[1]);
    }
    if (!first.is_array) throw not_understood{"'" + last + "' of a number"};
    value v = std::move(first);
    if (does == call_does::transpose)
        transpose(v);
    else if (does == call_does::by_columns && v.nested && last == "matrix")
        return v;  // numpy.matrix
    else
        reshape(v, does == call_does::by_columns);
    return v;
}

}  // namespace stagecraft::tableaux::program_text
