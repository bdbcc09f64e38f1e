// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "stagecraft/tableaux/small_solve.hpp"
#include "stagecraft/theory/models/band_matrix.hpp"
#include "stagecraft/theory/models/fixed_buffer.hpp"

namespace stagecraft::theory {

using tableaux::inertia;

constexpr bool is_positive_definite(const inertia& n) { return n.negative == 0 && n.zero == 0; }
constexpr bool is_nonnegative(const inertia& n) { return n.negative == 0; }
constexpr int rank(const inertia& n) { return n.positive + n.negative; }

/// Inertia of the symmetric matrix `m`, decided exactly by congruence (Sylvester's law); K is an ordered
/// field. `constexpr`, unlike tableaux::diagonalise. Rows of zeros cost nothing, the other n take O(n^3)
/// operations, O(n) for a diagonal matrix.
template <class K>
constexpr inertia inertia_of(const band_matrix<K>& m) {
    inertia found;
    fixed_buffer<int> rows(m.size());  // the rows still to be eliminated, `left` of them
    int left = 0;
    for (int i = 0; i < m.size(); ++i) {
        int others = 0;
        for (int j = m.first_column(i); j < m.end_column(i); ++j)
            if (j != i && !(m.row(i)[j] == K(0))) ++others;
        if (others > 0) {
            rows.data()[left++] = i;
        } else {
            const K& d = m.row(i)[i];
            ++(d == K(0) ? found.zero : K(0) < d ? found.positive : found.negative);
        }
    }
    std::vector<std::vector<K>> a;
    for (int i = 0; i < left; ++i) {
        a.emplace_back();
        for (int j = 0; j < left; ++j) a.back().push_back(m(rows.data()[i], rows.data()[j]));
    }
    while (!a.empty()) {
        const std::size_t n = a.size();
        std::size_t pivot = n;
        for (std::size_t i = 0; i < n && pivot == n; ++i)
            if (!(a[i][i] == K(0))) pivot = i;
        if (pivot == n) {  // zero diagonal: adding row and column j to i puts 2 a_ij there
            for (std::size_t i = 0; i < n && pivot == n; ++i)
                for (std::size_t j = 0; j < i && pivot == n; ++j) {
                    if (a[i][j] == K(0)) continue;
                    pivot = i;
                    for (std::size_t k = 0; k < n; ++k) a[i][k] += K(a[j][k]);
                    for (std::size_t k = 0; k < n; ++k) a[k][i] += K(a[k][j]);
                }
        }
        if (pivot == n) {
            found.zero += static_cast<int>(n);
            break;
        }
        std::swap(a[pivot], a[n - 1]);
        for (auto& row : a) std::swap(row[pivot], row[n - 1]);
        ++(K(0) < a[n - 1][n - 1] ? found.positive : found.negative);
        for (std::size_t i = 0; i + 1 < n; ++i) {
            const K f = a[i][n - 1] / a[n - 1][n - 1];
            if (f == K(0)) continue;
            for (std::size_t j = 0; j + 1 < n; ++j) a[i][j] -= f * a[n - 1][j];
        }
        a.pop_back();
        for (auto& row : a) row.pop_back();
    }
    return found;
}

}  // namespace stagecraft::theory
