// SPDX-License-Identifier: BSL-1.0
#include "language.hpp"

#include <cstddef>
#include <stdexcept>

#include "words.hpp"

namespace thesis {

namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// The longest phrase that stands at `at` and ends there with its last word; none where there is none.
const phrase* phrase_at(const std::string& text, std::size_t at) {
    const phrase* longest = nullptr;
    for (const phrase& p : words) {
        const std::size_t end = at + p.english.size();
        if (text.compare(at, p.english.size(), p.english) != 0) continue;
        if (end < text.size() && is_letter(text[end]) && is_letter(text[end - 1])) continue;
        if (!longest || p.english.size() > longest->english.size()) longest = &p;
    }
    return longest;
}

// The quoted string whose inside begins at `begin`, quotes in it doubled, as gnuplot has them; `end` is past it.
std::string unquoted(const std::string& commands, std::size_t begin, std::size_t& end) {
    std::string inside;
    for (end = begin; end < commands.size(); ++end) {
        if (commands[end] == '\'') {
            ++end;
            if (end == commands.size() || commands[end] != '\'') break;
        }
        inside += commands[end];
    }
    return inside;
}

std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? std::string("''") : std::string(1, c);
    return out + "'";
}

// Whether the quote at `at` is that of a text that is read in the picture.
bool opens_a_text(const std::string& commands, std::size_t at) {
    for (const std::string before : {"title ", "xlabel ", "ylabel ", "label "})
        if (at >= before.size() && commands.compare(at - before.size(), before.size(), before) == 0)
            return true;
    return false;
}

}  // namespace

std::string translated(const std::string& text, language to) {
    if (to == language::english) return text;
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        if (!is_letter(text[at])) {
            out += text[at++];
            continue;
        }
        if (const phrase* p = phrase_at(text, at)) {
            out += p->german;
            at += p->english.size();
            continue;
        }
        std::size_t end = at;
        while (end < text.size() && is_letter(text[end])) ++end;
        const std::string word = text.substr(at, end - at);
        if (word.size() > 1)
            throw std::invalid_argument("no German for '" + word + "' in '" + text +
                                        "': add it to words.hpp");
        out += word;
        at = end;
    }
    return out;
}

std::string translated_commands(const std::string& commands, language to) {
    if (to == language::english) return commands;
    std::string out;
    for (std::size_t at = 0; at < commands.size();) {
        if (commands[at] != '\'') {
            out += commands[at++];
            continue;
        }
        const bool text = opens_a_text(commands, at);
        std::size_t end = 0;
        const std::string inside = unquoted(commands, at + 1, end);
        out += quoted(text ? translated(inside, to) : inside);
        at = end;
    }
    return out;
}

std::string translated_svg(const std::string& svg, language to) {
    if (to == language::english) return svg;
    std::string out;
    std::size_t at = 0;
    for (std::size_t open; (open = svg.find("<text", at)) != std::string::npos;) {
        const std::size_t begin = svg.find('>', open) + 1, end = svg.find("</text>", begin);
        out += svg.substr(at, begin - at) + translated(svg.substr(begin, end - begin), to);
        at = end;
    }
    return out + svg.substr(at);
}

}  // namespace thesis
