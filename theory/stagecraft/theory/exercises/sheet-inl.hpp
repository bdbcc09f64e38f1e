// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/exercises/sheet.hpp"

#include <cstddef>
#include <set>
#include <stdexcept>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/theory/exercises/html.hpp"
#include "stagecraft/theory/exercises/kinds.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE exercise_sheet make_sheet(const std::string& kind, int count, std::uint64_t seed,
                                            bool solutions) {
    constexpr int most_repeated = 100;
    exercise_sheet sheet{{}, solutions};
    std::set<std::string> questions;
    const auto& kinds = exercise_kinds();
    for (int k = 0, repeated = 0; k < count; ++seed) {
        auto next =
            make_exercise(kind.empty() ? kinds[static_cast<std::size_t>(k) % kinds.size()].name : kind, seed);
        if (!questions.insert(to_text(next.question)).second) {
            if (++repeated > most_repeated)
                throw std::invalid_argument("exercise: there are not so many different ones of kind '" +
                                            kind + "'");
            continue;
        }
        repeated = 0;
        sheet.exercises.push_back(std::move(next));
        ++k;
    }
    return sheet;
}

namespace detail {

/// begin(k, e) and body(document) for every exercise, then for every solution behind `title`.
template <class Begin, class Body>
std::string in_order(const exercise_sheet& sheet, const std::string& title, Begin begin, Body body) {
    std::string out;
    int k = 0;
    for (const auto& e : sheet.exercises) out += begin(++k, e, false) + body(e.question);
    if (!sheet.solutions) return out;
    out += title;
    k = 0;
    for (const auto& e : sheet.exercises) out += begin(++k, e, true) + body(e.solution);
    return out;
}

}  // namespace detail

STAGECRAFT_INLINE std::string to_text(const exercise_sheet& sheet) {
    const auto begin = [](int k, const exercise& e, bool) {
        return std::to_string(k) + ". " + e.kind + ", seed " + std::to_string(e.seed) + "\n\n";
    };
    return detail::in_order(sheet, "Solutions\n\n", begin,
                            [](const document& d) { return to_text(d) + "\n"; });
}

STAGECRAFT_INLINE std::string to_latex(const exercise_sheet& sheet) {
    const auto begin = [](int k, const exercise& e, bool solution) {
        return "\\" + std::string(solution ? "paragraph" : "subsection") + "*{" + std::to_string(k) + ". " +
               e.kind + ", seed " + std::to_string(e.seed) + "}" + (solution ? "\\mbox{}\n\n" : "\n\n");
    };
    return "\\documentclass{article}\n\\usepackage{amsmath}\n\\setlength{\\parindent}{0pt}\n\\begin{document}"
           "\n"
           "\\section*{Exercises}\n\n" +
           detail::in_order(sheet, "\\newpage\n\\section*{Solutions}\n\n", begin,
                            [](const document& d) { return to_latex(d); }) +
           "\\end{document}\n";
}

STAGECRAFT_INLINE std::string to_html(const exercise_sheet& sheet) {
    const auto begin = [](int k, const exercise& e, bool) {
        return "<h2>" + std::to_string(k) + ". " + e.kind + " <small>seed " + std::to_string(e.seed) +
               "</small></h2>\n";
    };
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta "
           "charset=\"utf-8\">\n<title>Exercises</title>\n<style>\n"
           "body { max-width: 44em; margin: 2em auto; padding: 0 1em; font: 12pt/1.5 serif; }\n"
           "h1 { font-size: 1.5em; } h2 { font-size: 1.1em; margin-top: 1.5em; break-after: avoid; }\n"
           "small { font-weight: normal; } .solutions { break-before: page; }\n"
           ".tableau mtr > mtd:first-child { border-right: 1px solid; }\n"
           ".tableau mtr:last-child > mtd { border-top: 1px solid; }\n"
           "</style>\n</head>\n<body>\n<h1>Exercises</h1>\n" +
           detail::in_order(sheet, "<h1 class=\"solutions\">Solutions</h1>\n", begin,
                            [](const document& d) { return to_html(d); }) +
           "</body>\n</html>\n";
}

}  // namespace stagecraft::theory
