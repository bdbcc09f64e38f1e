// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <stagecraft/method/storage_form.hpp>
#include <stagecraft/tableau.hpp>
#include <stagecraft/tableaux/claims.hpp>
#include <stagecraft/tableaux/entry.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace stagecraft::tableaux {

/// Where the numbers of a tableau live, which decides what can be proved of it.
enum class number_kind {
    rational,   ///< everything is decided
    quadratic,  ///< everything is decided, in Q(sqrt d) or Q(sqrt d, sqrt e)
    enclosed,   ///< exact, but in no such field: equalities can be refuted, not proved
    rounded     ///< decimals or doubles
};

constexpr std::string_view name(number_kind k) {
    return k == number_kind::rational    ? "exact, rational"
           : k == number_kind::quadratic ? "exact, quadratic surds"
           : k == number_kind::enclosed  ? "exact, enclosed"
                                         : "rounded";
}

/// The coefficients of an explicit method as codes for partial differential equations store it (registers_of).
struct stage_form {
    using kind = storage_form;
    kind which = kind::shu_osher;
    /// Shu-Osher: the rows of alpha, filled up with zeros, then those of beta; else the lists in the order of names().
    std::vector<std::vector<entry>> rows;

    static const std::vector<std::string>& names(kind k);
    /// "beta[3][1]", "B[2]", counted from 1.
    std::string name(std::size_t row, std::size_t column) const;
};

/// A tableau as a file gives it.
struct tableau_file {
    std::string name;
    std::string source;
    std::vector<std::vector<entry>> A;
    std::vector<entry> b;
    std::vector<entry> c;           ///< empty where the file leaves it to the row sums
    std::vector<entry> b_embedded;  ///< empty where there is none
    std::vector<std::vector<entry>>
        b_theta;                     ///< coefficients of theta, theta^2, ... of each b_i(theta), or empty
    std::optional<stage_form> form;  ///< what A and b were computed from, where they do not stand in the file
    tableaux::claims claims;
    int short_decimals = 0;  ///< decimals read as exact though written with a point

    int stages() const { return static_cast<int>(b.size()); }

    template <class Visitor>
    void for_each_entry(Visitor visit) const {
        for (const auto& row : A)
            for (const auto& e : row) visit(e);
        for (const auto* v : {&b, &c, &b_embedded})
            for (const auto& e : *v) visit(e);
        for (const auto& row : b_theta)
            for (const auto& e : row) visit(e);
    }
    template <class Visitor>
    void for_each_entry(Visitor visit) {
        for (auto& row : A)
            for (auto& e : row) visit(e);
        for (auto* v : {&b, &c, &b_embedded})
            for (auto& e : *v) visit(e);
        for (auto& row : b_theta)
            for (auto& e : row) visit(e);
    }

    number_kind kind() const;
};

/// Most stages a file may have.
inline constexpr int most_stages = 64;
/// Most coefficients of a b_i(theta).
inline constexpr int largest_dense_degree = 20;
/// Largest order for which every tree is looked at: there are 53,272 up to 14. Higher ones, which a file may
/// claim as well, are proved by simplifying assumptions.
inline constexpr int largest_order = 14;

/// The tableau over Scalar, each entry sent through `convert`; a missing c becomes the row sums.
template <class Scalar, class Convert>
tableau<Scalar> to_tableau(const tableau_file& file, Convert convert) {
    const int s = file.stages();
    tableau<Scalar> t;
    t.A.resize(s, s);
    t.b.resize(s);
    t.c.resize(s);
    t.b_embedded.resize(static_cast<int>(file.b_embedded.size()));
    for (int i = 0; i < s; ++i) {
        Scalar sum = convert(file.A[i][0]);
        for (int j = 0; j < s; ++j) {
            t.A(i, j) = convert(file.A[i][j]);
            if (j > 0) sum = sum + t.A(i, j);
        }
        t.b(i) = convert(file.b[i]);
        t.c(i) = file.c.empty() ? sum : convert(file.c[i]);
        if (!file.b_embedded.empty()) t.b_embedded(i) = convert(file.b_embedded[i]);
    }
    return t;
}

/// The exact tableau over Q. Throws std::invalid_argument unless kind() is rational.
tableau<rational> to_rational(const tableau_file& file);

/// The exact tableau over Q(sqrt d) or Q(sqrt d, sqrt e). Throws std::invalid_argument unless the entries lie in one
/// such field.
tableau<quadratic> to_quadratic(const tableau_file& file);

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/tableau_file-inl.hpp"
#endif
