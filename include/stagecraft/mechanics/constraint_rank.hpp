// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <string>
#include <vector>

namespace stagecraft {

/// Which rows of a matrix of constraints are independent.
struct constraint_rank {
    int rank = 0;
    std::vector<int> independent;  ///< increasing row numbers, `rank` of them
    std::vector<int> dependent;    ///< the others: zero, or combinations of the independent ones
};

/// The rank of G and its rows, each measured by its own length: the row farthest from the span of those taken before is
/// taken (Gram-Schmidt orthogonalisation with pivoting) until all that are left lie in it to `tolerance`.
/// rows^2 x columns operations. Rows with entries that are not finite count as dependent.
template <class Matrix>
constraint_rank independent_rows(const Matrix& G, double tolerance = 1e-10) {
    Eigen::MatrixXd rest = Eigen::MatrixXd(G).transpose();  // one column for each constraint
    const Eigen::Index m = rest.cols();
    for (Eigen::Index k = 0; k < m; ++k)
        if (const double largest = rest.col(k).cwiseAbs().maxCoeff(); largest > 0) {
            rest.col(k) /= largest;
            rest.col(k) /= rest.col(k).norm();
        }
    std::vector<bool> taken(static_cast<std::size_t>(m), false);
    constraint_rank r;
    for (; r.rank < m; ++r.rank) {
        Eigen::Index next = -1;
        double distance = tolerance;
        for (Eigen::Index k = 0; k < m; ++k)
            if (!taken[static_cast<std::size_t>(k)] && rest.col(k).norm() > distance * (1 + 1e-8))
                next = k, distance = rest.col(k).norm();
        if (next < 0) break;
        taken[static_cast<std::size_t>(next)] = true;
        const Eigen::VectorXd direction = rest.col(next) / distance;
        for (Eigen::Index k = 0; k < m; ++k)
            if (!taken[static_cast<std::size_t>(k)])
                for (int twice = 0; twice < 2; ++twice) rest.col(k) -= direction * direction.dot(rest.col(k));
    }
    for (int k = 0; k < m; ++k)
        (taken[static_cast<std::size_t>(k)] ? r.independent : r.dependent).push_back(k);
    return r;
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

/// Throws std::domain_error for a G of which constraint k depends on those before it.
inline void refuse_dependent(const Eigen::MatrixXd& G, int k) {
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
