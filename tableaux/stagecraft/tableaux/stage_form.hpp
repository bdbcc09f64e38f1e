// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <stagecraft/tableaux/entry.hpp>
#include <stagecraft/tableaux/tableau_file.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// From the coefficients of a form with few registers to the tableau that it means, in any numbers.

namespace stagecraft::tableaux {

/// u + h sum_k f_k F_k, where u stands for the value at the beginning: a register of such a code.
template <class N>
struct stage_register {
    N u{0};
    std::vector<N> f;

    static stage_register nothing(std::size_t s) { return {N(0), std::vector<N>(s, N(0))}; }
    static stage_register old_value(std::size_t s) { return {N(1), std::vector<N>(s, N(0))}; }
    stage_register& add(const N& factor, const stage_register& other) {
        u = u + factor * other.u;
        for (std::size_t k = 0; k < f.size(); ++k) f[k] = f[k] + factor * other.f[k];
        return *this;
    }
    stage_register& add_slope(std::size_t k, const N& factor) {
        f[k] = f[k] + factor;
        return *this;
    }
};

/// The stages of a step and, last, its result, from the coefficients (stage_form::rows) as numbers. Shu and Osher 1988:
/// u_0 = u, u_i = sum_{k<i} (alpha_ik u_k + h beta_ik f(u_k)), i = 1..s. Williamson 1980 (2N):
/// v_i = A_i v_{i-1} + h f(u_{i-1}), u_i = u_{i-1} + B_i v_i. Ketcheson 2010 (2S): v = 0; for i = 1..s: v += delta_i u;
/// u = gamma1_i u + gamma2_i v + beta_i h f(u).
template <class N>
std::vector<stage_register<N>> registers_of(stage_form::kind kind, const std::vector<std::vector<N>>& rows) {
    using value = stage_register<N>;
    const std::size_t s = kind == stage_form::kind::shu_osher ? rows.size() / 2 : rows.front().size();
    std::vector<value> all{value::old_value(s)};
    value v = value::nothing(s);
    for (std::size_t i = 0; i < s; ++i) {
        const value& u = all.back();
        value next = value::nothing(s);
        if (kind == stage_form::kind::shu_osher) {
            for (std::size_t k = 0; k <= i; ++k) next.add(rows[i][k], all[k]).add_slope(k, rows[s + i][k]);
        } else if (kind == stage_form::kind::williamson) {
            v = value::nothing(s).add(rows[0][i], v).add_slope(i, N(1));
            next.add(N(1), u).add(rows[1][i], v);
        } else {
            v.add(rows[2][i], u);
            next.add(rows[0][i], u).add(rows[1][i], v).add_slope(i, rows[3][i]);
        }
        all.push_back(std::move(next));
    }
    return all;
}

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
inline std::string written_out(const entry& e) {
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

/// The tableau that a form means, whose c are the row sums. Throws std::invalid_argument where a stage does not contain
/// the value at the beginning once.
inline tableau_file expanded(stage_form form) {
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
