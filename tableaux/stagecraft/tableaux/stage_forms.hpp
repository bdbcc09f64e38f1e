// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <set>
#include <stagecraft/tableaux/json_document.hpp>
#include <stagecraft/tableaux/tableau_file.hpp>
#include <string>
#include <utility>
#include <vector>

/// Explicit methods as codes for partial differential equations store them: by what a step overwrites.

namespace stagecraft::tableaux {

namespace json_reader {

inline entry sum_of(const entry& x, const entry& y) {
    return expression_grammar::combine(x, y, [](const auto& a, const auto& b) { return a + b; });
}
inline entry product_of(const entry& x, const entry& y) {
    return expression_grammar::combine(x, y, [](const auto& a, const auto& b) { return a * b; });
}

/// u + h sum_k f_k F_k, where u stands for the value at the beginning: a register of such a code.
struct stored {
    entry u;
    std::vector<entry> f;

    static stored nothing(std::size_t s) { return {read_entry("0"), std::vector(s, read_entry("0"))}; }
    static stored old_value(std::size_t s) { return {read_entry("1"), std::vector(s, read_entry("0"))}; }
    stored& add(const entry& factor, const stored& other) {
        u = sum_of(u, product_of(factor, other.u));
        for (std::size_t k = 0; k < f.size(); ++k) f[k] = sum_of(f[k], product_of(factor, other.f[k]));
        return *this;
    }
};

/// Text that reads as the entry again: exact, or decimals as good as it is known.
inline void write_out(entry& e) {
    if (e.exact) {
        e.text = e.exact->str();
        return;
    }
    int places = 0;
    for (rational unit(1); places < 120 && unit > e.enclosure.width(); ++places) unit /= rational(10);
    const rational shift = expression_grammar::power_of_ten(places);
    const integer digits = floor(e.enclosure.middle() * shift + rational(1, 2));
    std::string text = abs(digits).str();
    if (static_cast<int>(text.size()) <= places)
        text.insert(0, static_cast<std::size_t>(places) + 1 - text.size(), '0');
    text.insert(text.size() - static_cast<std::size_t>(places), places > 0 ? "." : "");
    e.text = (digits < 0 ? "-" : "") + text;
}

/// Stages and the value at the end to A and b; `given` are the coefficients as read. Throws where a stage does not
/// begin with u.
inline tableau_file from_registers(const document& d, const tableau_file& given,
                                   const std::vector<stored>& stages, const stored& last) {
    tableau_file file;
    file.short_decimals = given.short_decimals;
    for (std::size_t i = 0; i <= stages.size(); ++i) {
        const stored& at = i < stages.size() ? stages[i] : last;
        if (!at.u.enclosure.contains(1))
            reject(d, "", "",
                   (i < stages.size() ? "stage " + std::to_string(i + 1) : "the result") +
                       " does not contain the old value once: the coefficients of a row must sum to 1");
        auto row = at.f;
        for (entry& e : row) write_out(e);
        if (i < stages.size())
            file.A.push_back(std::move(row));
        else
            file.b = std::move(row);
    }
    return file;
}

/// The rows of a list of lists, row i of at most i + 1 entries, filled up with zeros.
inline std::vector<std::vector<entry>> triangle(const document& d, const std::string& key) {
    const json& all = d.root[key];
    if (!all.is_array() || all.empty() || all.size() > most_stages)
        reject(d, "/" + key, key, "must be a list of 1 to " + std::to_string(most_stages) + " rows");
    std::vector<std::vector<entry>> rows;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string row = key + "[" + std::to_string(i + 1) + "]";
        rows.push_back(numbers(d, all[i], "/" + key + "/" + std::to_string(i), row, 0));
        if (rows.back().size() > all.size() || rows.back().empty())
            reject(d, "/" + key + "/" + std::to_string(i), row,
                   "must have 1 to " + std::to_string(all.size()) + " entries");
        for (std::size_t k = i + 1; k < rows.back().size(); ++k)
            if (!rows.back()[k].exact || *rows.back()[k].exact != 0)
                reject(d, "/" + key + "/" + std::to_string(i) + "/" + std::to_string(k),
                       row + "[" + std::to_string(k + 1) + "]", "must be 0: the method is explicit");
        rows.back().resize(all.size(), read_entry("0"));
    }
    return rows;
}

/// u_0 = u, u_i = sum_{k<i} (alpha_ik u_k + h beta_ik f(u_k)), i = 1..s, the last being the result (Shu and
/// Osher 1988).
inline tableau_file from_shu_osher(const document& d, const reading& how) {
    tableau_file given;  // so that what decimals mean is decided from all of them
    given.A = triangle(d, "alpha");
    given.b_theta = triangle(d, "beta");
    const std::size_t s = given.A.size();
    if (given.b_theta.size() != s)
        reject(d, "/beta", "beta", "must have " + std::to_string(s) + " rows, as many as alpha");
    apply(how, given);
    std::vector<stored> values{stored::old_value(s)};
    for (std::size_t i = 0; i < s; ++i) {
        stored next = stored::nothing(s);
        for (std::size_t k = 0; k <= i; ++k) next.add(given.A[i][k], values[k]);
        for (std::size_t k = 0; k <= i; ++k) next.f[k] = sum_of(next.f[k], given.b_theta[i][k]);
        values.push_back(std::move(next));
    }
    const stored last = values.back();
    values.pop_back();
    return from_registers(d, given, values, last);
}

/// The list of that name, whose length is the number of stages.
inline std::vector<entry> one_for_each_stage(const document& d, const std::string& key) {
    auto list = numbers(d, d.root[key], "/" + key, key, 0);
    if (list.empty() || list.size() > most_stages)
        reject(d, "/" + key, key, "must have 1 to " + std::to_string(most_stages) + " entries");
    return list;
}

/// Two registers (Williamson 1980): v_i = A_i v_{i-1} + h f(u_{i-1}), u_i = u_{i-1} + B_i v_i.
inline tableau_file from_williamson(const document& d, const reading& how) {
    tableau_file given;
    given.b = one_for_each_stage(d, "B");
    const std::size_t s = given.b.size();
    given.c = numbers(d, d.root["A"], "/A", "A", s);
    apply(how, given);
    stored u = stored::old_value(s), v = stored::nothing(s);
    std::vector<stored> stages;
    for (std::size_t i = 0; i < s; ++i) {
        stages.push_back(u);
        stored next = stored::nothing(s);
        next.add(given.c[i], v);
        next.f[i] = sum_of(next.f[i], read_entry("1"));
        v = std::move(next);
        u.add(given.b[i], v);
    }
    return from_registers(d, given, stages, u);
}

/// Two registers (Ketcheson 2010, 2S): v = 0; for i = 1..s: v += delta_i u; u = gamma1_i u + gamma2_i v +
/// beta_i h f(u).
inline tableau_file from_ketcheson(const document& d, const reading& how) {
    tableau_file given;
    given.b = one_for_each_stage(d, "beta");
    const std::size_t s = given.b.size();
    for (const char* key : {"gamma1", "gamma2", "delta"})
        given.A.push_back(numbers(d, d.root[key], std::string("/") + key, key, s));
    apply(how, given);
    stored u = stored::old_value(s), v = stored::nothing(s);
    std::vector<stored> stages;
    for (std::size_t i = 0; i < s; ++i) {
        v.add(given.A[2][i], u);
        stages.push_back(u);
        stored next = stored::nothing(s);
        next.add(given.A[0][i], u).add(given.A[1][i], v);
        next.f[i] = sum_of(next.f[i], given.b[i]);
        u = std::move(next);
    }
    return from_registers(d, given, stages, u);
}

/// Whether a "form" is one of a single tableau.
inline bool is_stage_form(const std::string& form) {
    return form == "shu-osher" || form == "2N" || form == "2S";
}

/// {"form":"shu-osher","alpha","beta"}, {"form":"2N","A","B"} or {"form":"2S","gamma1","gamma2","delta",
/// "beta"} as a tableau, whose c are the row sums.
inline tableau_file from_stage_form(const document& d, const reading& how) {
    const std::set<std::string> about{"name", "source", "note", "form", "claims"};
    const auto keys = [&](std::initializer_list<const char*> own) {
        std::set<std::string> known = about;
        known.insert(own.begin(), own.end());
        require_keys(d, known, own);
    };
    const std::string form = text_field(d, "form");
    if (form == "shu-osher") {
        keys({"alpha", "beta"});
        return from_shu_osher(d, how);
    }
    if (form == "2N") {
        keys({"A", "B"});
        return from_williamson(d, how);
    }
    keys({"gamma1", "gamma2", "delta", "beta"});
    return from_ketcheson(d, how);
}

}  // namespace json_reader

}  // namespace stagecraft::tableaux
