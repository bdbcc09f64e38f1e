// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/number_brackets.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "stagecraft/compiled.hpp"

namespace stagecraft::tableaux::program_text {

STAGECRAFT_INLINE number_brackets::number_brackets(const std::vector<token>& tokens) : tokens_(tokens) {
    static constexpr std::array<std::string_view, 21> allowed{",", ";",  "+",  "-",  "*", "/", "//",
                                                              "^", "**", "(",  ")",  "[", "]", "{",
                                                              "}", "./", ".*", ".^", "&", ".", "::"};
    for (auto* count : {&numbers_, &fractions_, &words_, &others_}) count->assign(tokens.size() + 1, 0);
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const token& t = tokens[i];
        const bool number = t.is == token::kind::number;
        const bool fraction = number && (t.text.find('.') != nowhere || t.text.find('e') != nowhere);
        const bool good_sign =
            t.is == token::kind::line_end ||
            (t.is == token::kind::sign && std::find(allowed.begin(), allowed.end(), t.text) != allowed.end());
        numbers_[i + 1] = numbers_[i] + (number ? 1 : 0);
        fractions_[i + 1] = fractions_[i] + (fraction || is_sign(t, "/") || is_sign(t, "//") ? 1 : 0);
        words_[i + 1] = words_[i] + (t.is == token::kind::word ? 1 : 0);
        others_[i + 1] = others_[i] + (!number && !good_sign && t.is != token::kind::word ? 1 : 0);
    }
}

STAGECRAFT_INLINE bool number_brackets::at(std::size_t open) const {
    const auto close = tokens_[open].partner;
    if (!is_open(tokens_[open]) || close == nowhere || close < open || others_[close] != others_[open])
        return false;
    const auto numbers = numbers_[close] - numbers_[open], words = words_[close] - words_[open];
    if (numbers < 2 || words > numbers) return false;
    const bool whole = fractions_[close] == fractions_[open];
    const bool behind_word = open > 0 && !tokens_[open].blank_before &&
                             (tokens_[open - 1].is == token::kind::word || is_close(tokens_[open - 1]));
    if (is_sign(tokens_[open], "(") &&
        (behind_word || (open > 0 && tokens_[open - 1].is == token::kind::word)))
        return false;
    return !whole || (!behind_word && numbers > 2);
}

}  // namespace stagecraft::tableaux::program_text
