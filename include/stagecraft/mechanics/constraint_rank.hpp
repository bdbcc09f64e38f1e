// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace stagecraft {

/// Which rows of a matrix of constraints are independent.
struct constraint_rank {
    int rank = 0;
    std::vector<int> independent;  ///< increasing row numbers, `rank` of them
    std::vector<int> dependent;    ///< the others: zero, or combinations of the independent ones
    double volume = 1;  ///< spanned by the independent ones, each of length 1: near 0 if nearly dependent
};

namespace detail {

/// In plain loops, which every mechanical program can compile without noticing.
inline constraint_rank rank_of_rows(std::vector<std::vector<double>> rows, double tolerance, int most) {
    const auto product = [](const std::vector<double>& a, const std::vector<double>& b) {
        double sum = 0;
        for (std::size_t j = 0; j < a.size(); ++j) sum += a[j] * b[j];
        return sum;
    };
    const auto scale = [](std::vector<double>& a, double by) {
        for (double& x : a) x /= by;
    };
    for (auto& row : rows) {
        double largest = 0;
        for (const double x : row) largest = std::max(largest, std::abs(x));
        if (!(largest > 0)) continue;
        scale(row, largest);
        scale(row, std::sqrt(product(row, row)));
    }
    constexpr double nearly = 1 + 1e-8;  // of rows as far as each other the first is taken
    std::vector<bool> taken(rows.size(), false);
    constraint_rank r;
    while (r.rank < most) {
        std::size_t next = rows.size();
        double distance = tolerance;
        for (std::size_t k = 0; k < rows.size(); ++k)
            if (const double d = std::sqrt(product(rows[k], rows[k])); !taken[k] && d > nearly * distance)
                next = k, distance = d;
        if (next == rows.size()) break;
        ++r.rank, r.volume *= distance;
        taken[next] = true;
        scale(rows[next], distance);
        for (std::size_t k = 0; k < rows.size(); ++k)
            for (int twice = 0; twice < 2 && !taken[k]; ++twice) {
                const double along = product(rows[next], rows[k]);
                for (std::size_t j = 0; j < rows[k].size(); ++j) rows[k][j] -= along * rows[next][j];
            }
    }
    for (std::size_t k = 0; k < rows.size(); ++k)
        (taken[k] ? r.independent : r.dependent).push_back(static_cast<int>(k));
    return r;
}

}  // namespace detail

/// The rank of G and its rows, each measured by its own length: the row farthest from the span of those taken before is
/// taken (Gram-Schmidt orthogonalisation with pivoting) until all that are left lie in it to `tolerance`, or `most` are taken.
/// rows^2 x columns operations. Rows with entries that are not finite count as dependent.
template <class Matrix>
constraint_rank independent_rows(const Matrix& G, double tolerance = 1e-10,
                                 int most = std::numeric_limits<int>::max()) {
    if constexpr (requires { G(0, 0); }) {
        std::vector<std::vector<double>> rows(static_cast<std::size_t>(G.rows()));
        for (std::size_t k = 0; k < rows.size(); ++k)
            for (int j = 0; j < G.cols(); ++j)
                rows[k].push_back(static_cast<double>(G(static_cast<int>(k), j)));
        return detail::rank_of_rows(std::move(rows), tolerance, most);
    } else {
        return independent_rows(Eigen::MatrixXd(G), tolerance, most);
    }
}

namespace detail {

/// "G has rank 3 of 4 here; constraints that depend on others: 3".
inline std::string rank_in_words(const constraint_rank& r) {
    std::string text = "G has rank " + std::to_string(r.rank) + " of " +
                       std::to_string(r.independent.size() + r.dependent.size()) +
                       " here; constraints that depend on others: ";
    for (std::size_t k = 0; k < r.dependent.size(); ++k)
        text += (k == 0 ? "" : ", ") + std::to_string(r.dependent[k]);
    return text;
}

/// The same where rows of G depend on each other, or nearly: by less than a run that fails beside a singular position may
/// be away from it. Empty where they do not.
template <class Matrix>
std::string dependence_in_words(const Matrix& G) {
    constexpr double nearly = 1e-2;
    const constraint_rank r = independent_rows(G, nearly);
    return r.dependent.empty() ? std::string() : rank_in_words(r);
}

/// Throws std::domain_error for a G of which constraint k depends on those before it.
template <class Matrix>
void refuse_dependent(const Matrix& G, int k) {
    constraint_rank r = independent_rows(G, 1e-6);
    if (r.dependent.empty()) {  // nearly so: the inertia is singular to rounding
        --r.rank;
        r.independent.erase(r.independent.begin() + k);
        r.dependent.push_back(k);
    }
    throw std::domain_error("mechanical: " + rank_in_words(r) +
                            " (independent_constraints<rank>(model, q) leaves such constraints out)");
}

}  // namespace detail

}  // namespace stagecraft
