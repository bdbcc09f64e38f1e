// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "stagecraft/tableaux/array_value.hpp"
#include "stagecraft/tableaux/program_tokens.hpp"

namespace stagecraft::tableaux::program_text {

/// A place in tokens [begin, end), and what blanks and ends of lines mean there.
class token_cursor {
  public:
    token_cursor(const std::vector<token>& tokens, std::size_t begin, std::size_t end)
        : tokens_(tokens), at_(begin), end_(end) {}

    /// What `parse` returns; where it does not understand something, the line is told.
    template <class Parse>
    auto located(Parse parse) {
        try {
            return parse();
        } catch (not_understood& e) {
            if (e.line == 0) e.line = tokens_[std::min(at_, tokens_.size() - 1)].line;
            throw;
        }
    }

  protected:
    /// Where blanks and lines separate numbers, and where the brackets at work end.
    struct context {
        bool blanks_separate = false, in_brackets = false;
    };

    [[noreturn]] void fail(const std::string& what) const {
        const auto& t = tokens_[std::min(at_, tokens_.size() - 1)];
        throw not_understood{what.substr(0, 60), t.line};
    }

    bool more() const { return at_ < end_; }
    const token& here() const { return tokens_[at_]; }
    bool sign(std::string_view text) const { return more() && is_sign(here(), text); }
    bool accept(std::string_view text) {
        if (!sign(text)) return false;
        ++at_;
        return true;
    }
    void skip_lines() {
        while (more() && here().is == token::kind::line_end) ++at_;
    }

    /// In rows of numbers that blanks separate "1 -2" are two numbers and "1 - 2" is one.
    bool separates(const token& sign) const {
        return context_.blanks_separate && sign.blank_before && at_ + 1 < end_ &&
               !tokens_[at_ + 1].blank_before;
    }

    /// Outside square and curly brackets an expression may go on with an operator in the next line.
    /// In them, where commas separate the numbers, only with one that stands alone, as Python allows: "-1" is a new row.
    void skip_lines_before_operator() {
        if (!more() || here().is != token::kind::line_end || context_.blanks_separate) return;
        auto next = at_;
        while (next < end_ && tokens_[next].is == token::kind::line_end) ++next;
        static constexpr std::string_view operators("+-*/.");
        const bool is_operator = next + 1 < end_ && tokens_[next].is == token::kind::sign &&
                                 operators.find(tokens_[next].text[0]) != operators.npos;
        if (is_operator && (!context_.in_brackets || tokens_[next + 1].blank_before)) at_ = next;
    }

    std::size_t closing() const {
        const auto close = here().partner;
        if (close == nowhere || close >= end_) fail("the brackets are not closed");
        return close;
    }

    /// Goes into the brackets that are here, up to `end`, and returns what to leave them with.
    std::pair<std::size_t, context> enter(std::size_t end, context inside) {
        ++at_;
        return {std::exchange(end_, end), std::exchange(context_, inside)};
    }
    void leave(const std::pair<std::size_t, context>& outer, std::size_t close) {
        std::tie(end_, context_) = outer;
        at_ = close + 1;
    }

    const std::vector<token>& tokens_;
    std::size_t at_, end_;
    context context_;
};

}  // namespace stagecraft::tableaux::program_text
