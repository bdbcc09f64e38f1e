// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <stagecraft/linear/sparse_blocks.hpp>

namespace stagecraft {

namespace detail {

/// Calls found(i, j) for each component i of f(t, y) that becomes another one, or NaN, where y_j becomes moved(y_j); for all j
/// where it is NaN at y, as nothing is known of it then.
template <class Problem, class Moved, class Found>
void changes(Problem& f, double t, Eigen::VectorXd y, const Moved& moved, const Found& found) {
    Eigen::VectorXd before(y.size()), after(y.size());
    f(t, y, before);
    for (Eigen::Index j = 0; j < y.size(); ++j) {
        const double kept = std::exchange(y[j], moved(y[j]));
        f(t, y, after);
        y[j] = kept;
        for (Eigen::Index i = 0; i < y.size(); ++i)
            if (!(after[i] == before[i])) found(i, j);
    }
}

template <class Rhs>
struct rhs_with_found_sparsity : Rhs {
    Eigen::SparseMatrix<double> pattern;
    rhs_with_found_sparsity(Rhs r, Eigen::SparseMatrix<double> p)
        : Rhs(std::move(r)), pattern(std::move(p)) {}
    using Rhs::operator();
    const Eigen::SparseMatrix<double>& sparsity() const { return pattern; }
};

}  // namespace detail

/// Where a pattern is looked for: `by_nan` makes every component of y NaN in turn, which the components of f that depend on it
/// become as well: n + 1 evaluations of f. `by_nan_and_steps` moves it up and down by 1 + |y_j| too, at y and at y + 1, so that
/// what a comparison, min or max hides from NaN is seen, and takes the diagonal in: 5 n + 5 evaluations.
enum class pattern_search { by_nan, by_nan_and_steps };

/// The pattern of df/dy, n x n, ones where f_i is seen to depend on y_j, by calls f(t, y, f) in Eigen::VectorXd. What the
/// search does not show is not found: f that looks at y_j beyond a threshold that lies elsewhere.
template <class Problem>
Eigen::SparseMatrix<double> find_sparsity(Problem&& f, const Eigen::VectorXd& y, double t = 0,
                                          pattern_search how = pattern_search::by_nan_and_steps) {
    using std::abs;
    std::vector<Eigen::Triplet<double>> entries;
    const auto found = [&](Eigen::Index i, Eigen::Index j) {
        entries.emplace_back(static_cast<int>(i), static_cast<int>(j), 1.0);
    };
    detail::changes(
        f, t, y, [](double) { return std::numeric_limits<double>::quiet_NaN(); }, found);
    if (how == pattern_search::by_nan_and_steps) {
        for (Eigen::Index i = 0; i < y.size(); ++i) found(i, i);
        for (const double shift : {0.0, 1.0})
            for (const double sign : {1.0, -1.0})
                detail::changes(
                    f, t, y.array() + shift, [sign](double x) { return x + sign * (1 + abs(x)); }, found);
    }
    Eigen::SparseMatrix<double> pattern(y.size(), y.size());
    pattern.setFromTriplets(entries.begin(), entries.end(), [](double, double) { return 1.0; });
    return pattern;
}

/// A right-hand side of doubles with the sparsity() that find_sparsity() finds at (t0, y0), so that its Jacobian is taken in
/// groups of columns and factored sparse:
///
///     integrate(method, with_found_sparsity(f, y0), y0, t0, t1)
///
/// std::invalid_argument where y0 is empty or not finite. Worth it from about 50 components with few neighbours each.
template <class Rhs>
auto with_found_sparsity(Rhs rhs, const Eigen::VectorXd& y0, double t0 = 0) {
    if (y0.size() == 0 || !y0.allFinite())
        throw std::invalid_argument("with_found_sparsity: y0 must be finite and not empty");
    Eigen::SparseMatrix<double> pattern = find_sparsity(rhs, y0, t0);
    return detail::rhs_with_found_sparsity<Rhs>(std::move(rhs), std::move(pattern));
}

}  // namespace stagecraft
