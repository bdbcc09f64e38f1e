// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <stagecraft/tableau.hpp>
#include <stagecraft/tableaux/read.hpp>
#include <stagecraft/tableaux/residue.hpp>
#include <stagecraft/tableaux/tableau_file.hpp>
#include <string>
#include <utility>
#include <vector>

namespace stagecraft::theory {

/// A tableau on trial. `nodes_given` is false where c was left to the row sums and follows A.
template <class K>
struct subject {
    tableau<K> t;
    bool nodes_given = true;
    bool strictly_lower = false;  ///< explicit by its exact zeros
    bool lower = false;           ///< diagonally implicit by its exact zeros

    int stages() const { return t.stages(); }
};

/// The part of a tableau that an entry belongs to.
enum class part { A, b, c, b_embedded };

/// A single entry, 0-based inside.
struct place {
    theory::part part = part::A;
    int row = 0;
    int column = 0;  ///< used in A only

    /// "A[6][3]", "b[2]", counted from 1.
    std::string name() const;
    friend bool operator==(const place&, const place&) = default;
};

template <class K>
const K& value_at(const subject<K>& s, const place& p) {
    switch (p.part) {
        case part::A:
            return s.t.A(p.row, p.column);
        case part::b:
            return s.t.b(p.row);
        case part::c:
            return s.t.c(p.row);
        default:
            return s.t.b_embedded(p.row);
    }
}

/// Puts `value` there; nodes that are row sums follow.
template <class K>
void put(subject<K>& s, const place& p, const K& value) {
    const_cast<K&>(value_at(std::as_const(s), p)) = value;
    if (p.part != part::A || s.nodes_given) return;
    K sum = s.t.A(p.row, 0);
    for (int j = 1; j < s.stages(); ++j) sum = sum + s.t.A(p.row, j);
    s.t.c(p.row) = sum;
}

inline const tableaux::entry& entry_at(const tableaux::tableau_file& file, const place& p) {
    const auto i = static_cast<std::size_t>(p.row);
    switch (p.part) {
        case part::A:
            return file.A[i][static_cast<std::size_t>(p.column)];
        case part::b:
            return file.b[i];
        case part::c:
            return file.c[i];
        default:
            return file.b_embedded[i];
    }
}

/// The entries of the file: of A, at most those `above` the diagonal by so much.
std::vector<place> places_of(const tableaux::tableau_file& file, int above = tableaux::most_stages);

/// All entries whose change leaves the kind of method alone: no entry above the diagonal of an explicit or
/// diagonally implicit A (on the diagonal of an explicit one), by the zeros that it has, or prints as 0.000.
std::vector<place> places_of_kind(const tableaux::tableau_file& file);

/// The tableau of the file over K; `convert` maps an entry to K.
template <class K, class Convert>
subject<K> make_subject(const tableaux::tableau_file& file, Convert convert) {
    subject<K> s{tableaux::to_tableau<K>(file, convert), !file.c.empty(), true, true};
    for (int i = 0; i < file.stages(); ++i)
        for (int j = i; j < file.stages(); ++j) {
            const auto& e = entry_at(file, {part::A, i, j});
            const bool zero = e.enclosure == tableaux::range{0, 0};
            s.strictly_lower = s.strictly_lower && zero;
            s.lower = s.lower && (zero || i == j);
        }
    return s;
}

/// The same tableau in other numbers, entry by entry.
template <class To, class K, class Convert>
subject<To> mapped(const subject<K>& s, Convert convert) {
    subject<To> r{{}, s.nodes_given, s.strictly_lower, s.lower};
    const auto map = [&](const auto& from, auto& to) {
        to.resize(from.rows(), from.cols());
        for (int i = 0; i < from.rows(); ++i)
            for (int j = 0; j < from.cols(); ++j) to(i, j) = convert(from(i, j));
    };
    map(s.t.A, r.t.A);
    map(s.t.b, r.t.b);
    map(s.t.c, r.t.c);
    map(s.t.b_embedded, r.t.b_embedded);
    return r;
}

/// The same tableau modulo 2^61 - 1; empty where a denominator vanishes there, and for enclosures.
template <class K>
std::optional<subject<tableaux::residue>> reduced_modulo_prime(const subject<K>& s) {
    if constexpr (requires(const K& x) { tableaux::residue_of(x); }) {
        bool regular = true;
        auto r = mapped<tableaux::residue>(s, [&](const K& entry) {
            const auto x = tableaux::residue_of(entry);
            regular = regular && x;
            return x.value_or(tableaux::residue());
        });
        if (regular) return r;
    }
    return std::nullopt;
}

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/subject-inl.hpp"
#endif
