// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/stage_form.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/entry.hpp"

namespace stagecraft::tableaux {

namespace detail {

/// An entry that can be added and multiplied.
struct computed_entry {
    entry e;
    computed_entry(int n) : e(expression_grammar::from_exact(n)) {}  // NOLINT: as numbers are
    explicit computed_entry(entry x) : e(std::move(x)) {}
    friend computed_entry operator+(const computed_entry& x, const computed_entry& y) {
        return computed_entry(
            expression_grammar::combine(x.e, y.e, [](const auto& a, const auto& b) { return a + b; }));
    }
    friend computed_entry operator*(const computed_entry& x, const computed_entry& y) {
        return computed_entry(
            expression_grammar::combine(x.e, y.e, [](const auto& a, const auto& b) { return a * b; }));
    }
};

/// Text that reads as the entry again: exact, or decimals as good as it is known.
STAGECRAFT_INLINE std::string written_out(const entry& e) {
    if (e.exact) return e.exact->str();
    int places = 0;
    for (rational unit(1); places < 120 && unit > e.enclosure.width(); ++places) unit /= rational(10);
    const rational shift = expression_grammar::power_of_ten(places);
    const integer digits = floor(e.enclosure.middle() * shift + rational(1, 2));
    std::string text = abs(digits).str();
    if (static_cast<int>(text.size()) <= places)
        text.insert(0, static_cast<std::size_t>(places) + 1 - text.size(), '0');
    text.insert(text.size() - static_cast<std::size_t>(places), places > 0 ? "." : "");
    return (digits < 0 ? "-" : "") + text;
}

}  // namespace detail

STAGECRAFT_INLINE tableau_file expanded(stage_form form) {
    std::vector<std::vector<detail::computed_entry>> rows;
    for (const auto& row : form.rows) {
        rows.emplace_back();
        for (const entry& e : row) rows.back().emplace_back(e);
    }
    const auto values = registers_of(form.which, rows);
    tableau_file file;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const bool last = i + 1 == values.size();
        if (const entry& u = values[i].u.e; !u.enclosure.contains(1)) {
            const std::string row = form.which == stage_form::kind::shu_osher
                                        ? "alpha[" + std::to_string(i) + "]"
                                    : last ? "the result"
                                           : "stage " + std::to_string(i + 1);
            throw std::invalid_argument(row + " contains the old value " + detail::written_out(u) +
                                        " times, not once: the coefficients of a row must sum to 1");
        }
        std::vector<entry> row;
        for (const auto& f : values[i].f) {
            row.push_back(f.e);
            row.back().text = detail::written_out(f.e);
        }
        if (last)
            file.b = std::move(row);
        else
            file.A.push_back(std::move(row));
    }
    file.form = std::move(form);
    return file;
}

}  // namespace stagecraft::tableaux
