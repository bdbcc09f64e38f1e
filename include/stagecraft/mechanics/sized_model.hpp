// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <concepts>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <stagecraft/mechanics/constraint_rank.hpp>
#include <stagecraft/mechanics/start.hpp>
#include <stagecraft/owned_value.hpp>

namespace stagecraft {

/// A constrained mechanical system M q'' = F - G^T lambda, 0 = G q' + b, whose size is known at run time (chains,
/// nets, models read from a file), as a type with
///
///     int coordinates() const;  int constraints() const;            // n >= 1, 0 <= m <= n
///     matrix M() const  or  M(const Eigen::VectorXd& q) const;      // n x n, positive definite; M() is constant
///     Eigen::VectorXd F(q, v) const  or  F(q, v, double t) const;   // n forces
///     matrix G(q) const  or  G(q, t) const;                         // m x n, of full rank
///
/// where a matrix is dense, diagonal or sparse, Eigen's, and no expression, which refers to what may be gone. A sparse G
/// makes the linear algebra of the whole system sparse. Optional members: b(q, t) or b(q), what an affine or moving constraint prescribes; g(q) or g(q, t),
/// constraints of position with the gradient G. Everything lives on the heap, no size is a template parameter.
/// For a few coordinates known at compile time a mechanical_model is faster and is differentiated exactly.
template <class Model>
concept sized_mechanical_model = requires(const Model& model, const Eigen::VectorXd& q) {
    { model.coordinates() } -> std::convertible_to<int>;
    { model.constraints() } -> std::convertible_to<int>;
}
&&(
    requires(const Model& model) { model.M(); } ||
    requires(const Model& model, const Eigen::VectorXd& q) { model.M(q); }) &&
    (
        requires(const Model& model, const Eigen::VectorXd& q) { model.G(q); } ||
        requires(const Model& model, const Eigen::VectorXd& q, double t) { model.G(q, t); }) &&
    (
        requires(const Model& model, const Eigen::VectorXd& q) { model.F(q, q); } ||
        requires(const Model& model, const Eigen::VectorXd& q, double t) { model.F(q, q, t); });

namespace sized {

template <class Model>
inline constexpr bool constant_mass = requires(const Model& model) {
    model.M();
};
template <class Model>
inline constexpr bool has_position = requires(const Model& m, const Eigen::VectorXd& q) {
    m.g(q);
}
|| requires(const Model& m, const Eigen::VectorXd& q, double t) { m.g(q, t); };

template <class Model>
struct checked_returns {
    static_assert(
        detail::model_of_objects<Model, Eigen::VectorXd>,
        "M, F, G, b and g of a sized_mechanical_model must return matrices, not expressions of Eigen's, "
        "whose operands may be gone: write their types, Eigen::MatrixXd, say, in place of auto, or "
        ".eval()");
};

/// M, F, G, b and g of a model, whichever arguments they take.
template <class Model>
auto M(const Model& model, [[maybe_unused]] const Eigen::VectorXd& q) {
    if constexpr (constant_mass<Model>)
        return model.M();
    else
        return model.M(q);
}
template <class Model>
Eigen::VectorXd F(const Model& model, const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                  [[maybe_unused]] double t) {
    if constexpr (requires { model.F(q, v, t); })
        return model.F(q, v, t);
    else
        return model.F(q, v);
}
template <class Model>
auto G(const Model& model, const Eigen::VectorXd& q, [[maybe_unused]] double t) {
    if constexpr (requires { model.G(q, t); })
        return model.G(q, t);
    else
        return model.G(q);
}
template <class Model>
Eigen::VectorXd g(const Model& model, const Eigen::VectorXd& q, [[maybe_unused]] double t) {
    if constexpr (requires { model.g(q, t); })
        return model.g(q, t);
    else
        return model.g(q);
}
/// G v + b with the G there is.
template <class Model, class Matrix>
Eigen::VectorXd velocity_constraint(const Model& model, const Matrix& G, const Eigen::VectorXd& q,
                                    const Eigen::VectorXd& v, [[maybe_unused]] double t) {
    Eigen::VectorXd r = G * v;
    if constexpr (requires { model.b(q, t); })
        r += model.b(q, t);
    else if constexpr (requires { model.b(q); })
        r += model.b(q);
    return r;
}
template <class Model>
Eigen::VectorXd velocity_constraint(const Model& model, const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                                    double t) {
    return velocity_constraint(model, G(model, q, t), q, v, t);
}

template <class Model>
inline constexpr bool sparse = requires(const Model& model, const Eigen::VectorXd& q) {
    typename decltype(G(model, q, 0.0))::InnerIterator;
    G(model, q, 0.0).outerIndexPtr();
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

}  // namespace sized

namespace sized {

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
    right.head(n) = F(model, q, v, t);
    detail::check_finite(right.head(n), "F");
    right.tail(m) = (velocity_constraint(model, q - step * v, v, t - step) -
                     velocity_constraint(model, q + step * v, v, t + step)) /
                    (2 * step);
    const Eigen::VectorXd x = saddle_point(M(model, q), G(model, q, t), right);
    return {x.head(n), x.tail(m)};
}

}  // namespace sized

/// A position and a velocity of a model of a size known at run time.
struct sized_assembly {
    Eigen::VectorXd q, v;
};

/// The position near q and the velocity near v that satisfy the constraints at time t; see `assemble` for models of fixed
/// size. Throws std::invalid_argument if q or v has not coordinates() entries.
template <sized_mechanical_model Model>
sized_assembly assemble(const Model& model, Eigen::VectorXd q, Eigen::VectorXd v, double t = 0) {
    [[maybe_unused]] constexpr sized::checked_returns<Model> checked;
    const Eigen::Index n = model.coordinates();
    if (q.size() != n || v.size() != n)
        throw std::invalid_argument("assemble: q and v must have coordinates() entries");
    const auto change = [&](const Eigen::VectorXd& r) -> Eigen::VectorXd {
        Eigen::VectorXd right = Eigen::VectorXd::Zero(n + r.size());
        right.tail(r.size()) = r;
        return sized::saddle_point(sized::M(model, q), sized::G(model, q, t), right).head(n);
    };
    if constexpr (sized::has_position<Model>) {
        constexpr int most = 50;
        for (int k = 0;; ++k) {
            const Eigen::VectorXd left = sized::g(model, q, t), d = change(left);
            if (k == most || !d.allFinite()) throw std::runtime_error(detail::no_position(left));
            q -= d;
            if (d.cwiseAbs().maxCoeff() <= 2e-15 * (1 + q.cwiseAbs().maxCoeff())) break;
        }
    }
    for (int k = 0; k < 2; ++k) v -= change(sized::velocity_constraint(model, q, v, t));
    return {std::move(q), std::move(v)};
}

/// A model with redundant constraints without those that depend on others at the position where it was made: the
/// motion is the same, and the multipliers that remain are unique. Made by `independent_constraints`.
template <sized_mechanical_model Model>
class independent_model : sized::checked_returns<Model> {
  public:
    independent_model(Model model, constraint_rank rows) : model_(std::move(model)), rows_(std::move(rows)) {}

    int coordinates() const { return model_.coordinates(); }
    int constraints() const { return rows_.rank; }
    auto M() const requires(sized::constant_mass<Model>) { return model_.M(); }
    auto M(const Eigen::VectorXd& q) const requires(!sized::constant_mass<Model>) { return model_.M(q); }
    Eigen::VectorXd F(const Eigen::VectorXd& q, const Eigen::VectorXd& v, double t) const {
        return sized::F(model_, q, v, t);
    }
    Eigen::SparseMatrix<double> G(const Eigen::VectorXd& q, double t) const {
        std::vector<Eigen::Triplet<double>> entries, kept;
        sized::append(entries, sized::G(model_, q, t), 0, 0, 1);
        std::vector<int> place(model_.constraints(), -1);
        for (int k = 0; k < rows_.rank; ++k) place[rows_.independent[k]] = k;
        for (const auto& e : entries)
            if (place[e.row()] >= 0) kept.emplace_back(place[e.row()], e.col(), e.value());
        Eigen::SparseMatrix<double> result(rows_.rank, coordinates());
        result.setFromTriplets(kept.begin(), kept.end());
        return result;
    }
    Eigen::VectorXd b(const Eigen::VectorXd& q, double t) const {
        return selected(sized::velocity_constraint(model_, q, Eigen::VectorXd::Zero(coordinates()), t));
    }
    Eigen::VectorXd g(const Eigen::VectorXd& q, double t) const requires(sized::has_position<Model>) {
        return selected(sized::g(model_, q, t));
    }
    /// The rank of G and the rows that were left out.
    const constraint_rank& rows() const { return rows_; }

  private:
    Eigen::VectorXd selected(const Eigen::VectorXd& all) const {
        Eigen::VectorXd r(rows_.rank);
        for (int k = 0; k < rows_.rank; ++k) r[k] = all[rows_.independent[k]];
        return r;
    }
    Model model_;
    constraint_rank rows_;
};

/// The model with those constraints only that are independent at q and time t.
template <sized_mechanical_model Model>
independent_model<Model> independent_constraints(Model model, const Eigen::VectorXd& q, double t = 0) {
    constraint_rank rows = independent_rows(sized::G(model, q, t));
    return {std::move(model), std::move(rows)};
}

}  // namespace stagecraft
