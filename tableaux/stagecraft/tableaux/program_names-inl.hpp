// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/program_names.hpp"

#include <algorithm>
#include <cctype>

#include "stagecraft/compiled.hpp"

namespace stagecraft::tableaux::program_text {

STAGECRAFT_INLINE std::vector<std::string_view> words_of(std::string_view list) {
    std::vector<std::string_view> words;
    for (std::size_t begin = 0; begin < list.size();) {
        const auto end = std::min(list.find(' ', begin), list.size());
        words.push_back(list.substr(begin, end - begin));
        begin = end + 1;
    }
    return words;
}

STAGECRAFT_INLINE std::string lower(std::string_view text) {
    std::string out(text);
    std::transform(out.begin(), out.end(), out.begin(), [](unsigned char ch) { return std::tolower(ch); });
    return out;
}

STAGECRAFT_INLINE std::optional<claim_name> claim_in(std::string_view name) {
    const std::string last = lower(name.substr(name.find_last_of(".:>") + 1));
    std::optional<claim_name> best;
    if (last.size() > longest_name) return best;
    std::size_t longest = 0;
    for (const auto& [word, key] : claim_words) {
        if (word.starts_with("->")) {
            if (name.ends_with(word)) return claim_name{std::string(key), {}, {}};
            continue;
        }
        if (word.starts_with("=")) {
            if (last == word.substr(1)) return claim_name{std::string(key), {}, {}};
            continue;
        }
        const auto at = last.find(lower(word));
        if (at == last.npos || word.size() <= longest) continue;
        const bool begins = at == 0 || last[at - 1] == '_';
        const bool ends = at + word.size() == last.size() || last[at + word.size()] == '_';
        if (!begins || !ends) continue;
        longest = word.size();
        best = claim_name{std::string(key), last.substr(0, at), last.substr(at + word.size())};
    }
    return best;
}

STAGECRAFT_INLINE bool is_coefficient(std::string_view name) {
    for (const auto& d : dialects)
        for (const auto list : {d.A, d.b, d.c, d.embedded})
            for (const auto word : words_of(list))
                if (name == word) return true;
    return false;
}

STAGECRAFT_INLINE std::optional<dense_word::written> dense_as(std::string_view name) {
    for (const auto& d : dense_words)
        for (const auto word : words_of(d.words))
            if (name == word) return d.as;
    return std::nullopt;
}

STAGECRAFT_INLINE bool is_diagonal_word(std::string_view name) {
    return name == "gamma" || name == "\xCE\xB3" || name == "g";
}

STAGECRAFT_INLINE bool is_single_coefficient(std::string_view name) {
    const auto digit = name.find_first_of("0123456789");
    if (digit == name.npos || digit == 0 || name.find_first_not_of("0123456789_", digit) != name.npos)
        return false;
    auto word = name.substr(0, digit);
    while (word.size() > 1 && word.back() == '_') word.remove_suffix(1);
    if (word == "alpha" || word == "beta" || word == "gamma" || word == "a" || word == "A") return true;
    return is_coefficient(word);
}

}  // namespace stagecraft::tableaux::program_text
