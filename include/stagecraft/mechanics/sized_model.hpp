// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <stagecraft/mechanics/constraint_rank.hpp>
#include <stagecraft/mechanics/start.hpp>
#include <stagecraft/refuse/mechanics/checked_model.hpp>

namespace stagecraft {

/// What models of a size known at run time need: their saddle-point systems are solved by sparse LU.
namespace sized {

template <class Model>
inline constexpr bool constant_mass = requires(const Model& model) {
    model.M();
};
template <class Model>
inline constexpr bool sparse = requires(const Model& model, const Eigen::VectorXd& q) {
    constraint_gradient<double>(model, q, 0.0).outerIndexPtr();
};

/// Appends the entries of a dense, diagonal or sparse matrix, moved to (row, column), times `factor`.
template <class Matrix>
void append(std::vector<Eigen::Triplet<double>>& entries, const Matrix& m, int row, int column, double factor,
            bool transposed = false) {
    const auto add = [&](Eigen::Index i, Eigen::Index j, double x) {
        if (transposed) std::swap(i, j);
        entries.emplace_back(row + static_cast<int>(i), column + static_cast<int>(j), factor * x);
    };
    if constexpr (requires { m.outerIndexPtr(); }) {
        for (Eigen::Index k = 0; k < m.outerSize(); ++k)
            for (typename Matrix::InnerIterator it(m, k); it; ++it) add(it.row(), it.col(), it.value());
    } else if constexpr (requires { m(0, 0); }) {
        for (Eigen::Index j = 0; j < m.cols(); ++j)
            for (Eigen::Index i = 0; i < m.rows(); ++i) add(i, j, m(i, j));
    } else {
        for (Eigen::Index i = 0; i < m.rows(); ++i) add(i, i, m.diagonal()[i]);
    }
}

/// (x, y) of M x + G^T y = a, G x = b with (a, b) = right. Throws std::domain_error that names the constraints that
/// depend on others or have no gradient, or says that M is singular: found by solving for a vector that is known.
template <class Mass, class Gradient>
Eigen::VectorXd saddle_point(const Mass& M, const Gradient& G, const Eigen::VectorXd& right) {
    const Eigen::Index m = G.rows(), n = G.cols();
    std::vector<Eigen::Triplet<double>> entries;
    append(entries, M, 0, 0, 1);
    double heaviest = 0, steepest = 0;
    for (const auto& e : entries) heaviest = std::max(heaviest, std::abs(e.value()));
    const std::size_t gradient = entries.size();
    append(entries, G, static_cast<int>(n), 0, 1);
    for (std::size_t k = gradient; k < entries.size(); ++k)
        steepest = std::max(steepest, std::abs(entries[k].value()));
    append(entries, G, 0, static_cast<int>(n), 1, true);
    Eigen::SparseMatrix<double> K(n + m, n + m);
    K.setFromTriplets(entries.begin(), entries.end());
    Eigen::SparseLU<Eigen::SparseMatrix<double>> lu(K);
    if (lu.info() == Eigen::Success) {
        Eigen::VectorXd known = Eigen::VectorXd::Ones(n + m);
        known.tail(m) *= heaviest / steepest;
        const Eigen::VectorXd product = K * known, found = lu.solve(product), error = found - known;
        if ((error.array().abs() <= 1e-3 * known.array()).all()) return lu.solve(right);
    }
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(n), steep = G.cwiseAbs() * ones;
    const constraint_rank found = independent_rows(G, 1e-6);
    for (const int k : found.dependent)
        if (steep[k] == 0)
            throw std::domain_error("mechanical: constraint " + std::to_string(k) +
                                    " has a row of zeros in G here");
    if (found.dependent.empty())
        throw std::domain_error("mechanical: M is singular here, or M or G is not finite");
    throw std::domain_error("mechanical: " + detail::rank_in_words(found) +
                            " (independent_constraints(model, q) leaves such constraints out)");
}

/// Acceleration and multiplier that belong to (q, v) at t: M a + G^T lambda = F, G a = -d/dt (G v + b) with v
/// held fixed, solved as one sparse system. The derivative of G along the motion is a central difference, good to
/// about ten digits. Throws as saddle_point does, and where F is not finite.
template <class Model>
std::pair<Eigen::VectorXd, Eigen::VectorXd> acceleration(const Model& model, const Eigen::VectorXd& q,
                                                         const Eigen::VectorXd& v, double t) {
    const int n = model.coordinates(), m = model.constraints();
    const double step = 6e-6 / (1 + v.cwiseAbs().maxCoeff());  // eps^(1/3) of a position of size 1
    Eigen::VectorXd right(n + m);
    right.head(n) = force<double>(model, q, v, t);
    detail::check_finite(right.head(n), "F");
    right.tail(m) = (velocity_constraint<double>(model, q - step * v, v, t - step) -
                     velocity_constraint<double>(model, q + step * v, v, t + step)) /
                    (2 * step);
    const Eigen::VectorXd x =
        saddle_point(mass_matrix<double>(model, q), constraint_gradient<double>(model, q, t), right);
    return {x.head(n), x.tail(m)};
}

}  // namespace sized

/// The position near q and the velocity near v that satisfy the constraints at time t; see `assemble` for models of fixed
/// size. Throws std::invalid_argument if q or v has not coordinates() entries.
template <sized_mechanical_model Model>
assembly<double, Model> assemble(const Model& model, const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                                 double t = 0) {
    const Eigen::Index n = model.coordinates();
    if (q.size() != n || v.size() != n)
        throw std::invalid_argument("assemble: q and v must have coordinates() entries");
    return detail::assembled<double>(
        model, q, v, t, [&](const Eigen::VectorXd& at, const Eigen::VectorXd& r) {
            Eigen::VectorXd right = Eigen::VectorXd::Zero(n + r.size());
            right.tail(r.size()) = r;
            const Eigen::VectorXd x = sized::saddle_point(mass_matrix<double>(model, at),
                                                          constraint_gradient<double>(model, at, t), right);
            return Eigen::VectorXd(x.head(n));
        });
}

/// A model with redundant constraints without those that depend on others at the position where it was made: the
/// motion is the same, and the multipliers that remain are unique. Made by `independent_constraints`.
template <sized_mechanical_model Model>
class independent_model : public Model, checked_model<Model> {
  public:
    independent_model(Model model, constraint_rank rows) : Model(std::move(model)), rows_(std::move(rows)) {}

    int constraints() const { return rows_.rank; }
    Eigen::SparseMatrix<double> G(const Eigen::VectorXd& q, double t) const {
        std::vector<Eigen::Triplet<double>> entries, kept;
        sized::append(entries, constraint_gradient<double>(all(), q, t), 0, 0, 1);
        std::vector<int> place(all().constraints(), -1);
        for (int k = 0; k < rows_.rank; ++k) place[rows_.independent[k]] = k;
        for (const auto& e : entries)
            if (place[e.row()] >= 0) kept.emplace_back(place[e.row()], e.col(), e.value());
        Eigen::SparseMatrix<double> result(rows_.rank, all().coordinates());
        result.setFromTriplets(kept.begin(), kept.end());
        return result;
    }
    Eigen::VectorXd b(const Eigen::VectorXd& q, double t) const {
        return selected(velocity_constraint<double>(all(), q, Eigen::VectorXd::Zero(q.size()), t));
    }
    Eigen::VectorXd g(const Eigen::VectorXd& q, double t) const requires holonomic_model<Model> {
        return selected(position_constraint<double>(all(), q, t));
    }
    /// The rank of G and the rows that were left out.
    const constraint_rank& rows() const { return rows_; }

  private:
    const Model& all() const { return *this; }
    Eigen::VectorXd selected(const Eigen::VectorXd& all) const {
        Eigen::VectorXd r(rows_.rank);
        for (int k = 0; k < rows_.rank; ++k) r[k] = all[rows_.independent[k]];
        return r;
    }
    constraint_rank rows_;
};

/// The model with those constraints only that are independent at q and time t.
template <sized_mechanical_model Model>
independent_model<Model> independent_constraints(Model model, const Eigen::VectorXd& q, double t = 0) {
    constraint_rank rows = independent_rows(constraint_gradient<double>(model, q, t));
    return {std::move(model), std::move(rows)};
}

}  // namespace stagecraft
