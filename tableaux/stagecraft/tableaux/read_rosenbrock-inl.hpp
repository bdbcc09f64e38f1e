// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/read_rosenbrock.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/json_document.hpp"
#include "stagecraft/tableaux/read.hpp"
#include "stagecraft/tableaux/read_partitioned.hpp"

namespace stagecraft::tableaux::json_reader {

inline bool is_zero(const entry& e) { return e.enclosure == range{0, 0}; }

/// The square matrix of that key, 0 above the diagonal and, where `strictly`, on it.
STAGECRAFT_INLINE std::vector<std::vector<entry>> lower_matrix(const document& d, const std::string& key,
                                                               std::size_t s, bool strictly) {
    auto all = rows(d, key, s);
    for (std::size_t i = 0; i < s; ++i)
        for (std::size_t k = strictly ? i : i + 1; k < s; ++k)
            if (!is_zero(all[i][k]))
                reject(d, "/" + key + "/" + std::to_string(i) + "/" + std::to_string(k),
                       key + "[" + std::to_string(i + 1) + "][" + std::to_string(k + 1) + "]",
                       "must be 0: one stage follows another");
    return all;
}

/// "gamma", a number or a list of them, on the diagonal of the matrix.
STAGECRAFT_INLINE void put_gamma(const document& d, std::vector<std::vector<entry>>& matrix, bool& one) {
    const json& given = d.root["gamma"];
    one = !given.is_array();
    const auto list = one ? std::vector(matrix.size(), number(d, given, "/gamma", "gamma"))
                          : numbers(d, given, "/gamma", "gamma", matrix.size());
    for (std::size_t i = 0; i < matrix.size(); ++i) matrix[i][i] = list[i];
}

/// The claims, none of which is beyond what is looked at or belongs to other methods.
STAGECRAFT_INLINE claims claims_of_rosenbrock(const document& d, const partitioned_file& file) {
    const claims stated = read_claims(d);
    const auto at_most = [&](const char* name, std::optional<int> claimed, int most) {
        if (claimed.value_or(0) > most)
            reject(d, std::string("/claims/") + name, std::string("claims.") + name,
                   "must be at most " + std::to_string(most));
    };
    at_most("order", stated.order, largest_order_of(file));
    at_most("embedded_order", stated.embedded_order, largest_order_of(file));
    at_most("w_order", stated.w_order, largest_w_order);
    at_most("index_1_order", stated.index_1_order, largest_index_1_order);
    for (const char* name : {"stage_order", "dense_order", "dense_smoothness", "algebraically_stable",
                             "symplectic", "symmetric"})
        if (d.root.contains("claims") && d.root["claims"].contains(name))
            reject(d, std::string("/claims/") + name, std::string("claims.") + name,
                   "is not judged of a Rosenbrock method");
    reject_single_claims(d);
    if (stated.embedded_order && file.partners[0].b_embedded.empty())
        reject(d, "/claims/embedded_order", "claims.embedded_order", "there are no embedded weights");
    return stated;
}

/// What decimals mean is decided from all numbers of the file together.
STAGECRAFT_INLINE void apply_together(const reading& how, tableau_file& values, tableau_file& matrix) {
    tableau_file all = values;
    for (auto& row : matrix.A) all.A.push_back(std::move(row));
    all.A.push_back(std::move(matrix.c));
    apply(how, all);
    const auto s = values.A.size();
    matrix.c = std::move(all.A.back());
    all.A.pop_back();
    matrix.A.assign(all.A.begin() + static_cast<std::ptrdiff_t>(s), all.A.end());
    all.A.resize(s);
    values = std::move(all);
}

STAGECRAFT_INLINE void rosenbrock(const document& d, const reading& how, partitioned_file& file) {
    const bool transformed = d.root.contains("C") || d.root.contains("m");
    file.transformed = transformed;
    if (transformed)
        require_keys(d,
                     {"name", "source", "note", "form", "a", "C", "gamma", "m", "m_embedded", "e", "c", "d",
                      "claims", "tolerance"},
                     {"a", "C", "gamma", "m"});
    else
        require_keys(d,
                     {"name", "source", "note", "form", "A", "Gamma", "gamma", "b", "b_embedded", "e", "c",
                      "d", "claims", "tolerance"},
                     {"A", "Gamma", "b"});
    const std::string weights_key = transformed ? "m" : "b";
    tableau_file values, matrix;
    values.b = numbers(d, d.root[weights_key], "/" + weights_key, weights_key, 0);
    const auto s = values.b.size();
    if (s == 0 || s > most_stages)
        reject(d, "/" + weights_key, weights_key,
               "must have 1 to " + std::to_string(most_stages) + " entries");
    values.A = lower_matrix(d, transformed ? "a" : "A", s, true);
    const bool apart = transformed || d.root.contains("gamma");
    matrix.A = lower_matrix(d, transformed ? "C" : "Gamma", s, apart);
    if (apart) put_gamma(d, matrix.A, file.one_gamma);
    const std::string embedded = transformed ? "m_embedded" : "b_embedded";
    file.difference = d.root.contains("e");
    if (file.difference && d.root.contains(embedded))
        reject(d, "/e", "e", "is the difference of the weights and " + embedded + "; one of both is enough");
    for (const auto& key : {std::string("e"), embedded})
        if (d.root.contains(key)) values.b_embedded = numbers(d, d.root[key], "/" + key, key, s);
    if (d.root.contains("c")) values.c = numbers(d, d.root["c"], "/c", "c", s);
    if (d.root.contains("d")) matrix.c = numbers(d, d.root["d"], "/d", "d", s);
    apply_together(how, values, matrix);
    matrix.b = std::vector(s, read_entry("0"));
    file.partners = {std::move(values), std::move(matrix)};
    file.claims = claims_of_rosenbrock(d, file);
}

}  // namespace stagecraft::tableaux::json_reader
