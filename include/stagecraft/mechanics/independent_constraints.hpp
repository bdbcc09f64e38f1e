// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include <stagecraft/mechanics/constraint_rank.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

namespace stagecraft {

namespace detail {

/// Row numbers, which the copies of a model have in common.
template <int Rank>
using row_numbers = std::shared_ptr<std::array<int, Rank>>;

template <int Rank>
std::array<int, Rank> numbers_in(const constraint_rank& r) {
    std::array<int, Rank> rows{};
    for (int k = 0; k < Rank; ++k) rows[k] = r.independent[k];
    return rows;
}

/// The rows of G to keep. Throws std::domain_error unless G has this rank.
template <int Rank, class Matrix>
row_numbers<Rank> rows_of_rank(const Matrix& G) {
    static_assert(
        Rank >= 1 && Rank <= Matrix::RowsAtCompileTime,
        "independent_constraints<rank>: the rank of G lies between 1 and the number of constraints");
    const constraint_rank r = independent_rows(G);
    if (r.rank != Rank)
        throw std::domain_error(
            "independent_constraints<" + std::to_string(Rank) + ">: " +
            (r.dependent.empty() ? "G has rank " + std::to_string(r.rank) + " here" : rank_in_words(r)));
    return std::make_shared<std::array<int, Rank>>(numbers_in<Rank>(r));
}

template <int Rank, class Matrix>
auto kept_rows(const Matrix& all, const std::array<int, Rank>& rows) {
    Eigen::Matrix<typename Matrix::Scalar, Rank, Matrix::ColsAtCompileTime> r;
    for (int j = 0; j < r.cols(); ++j)
        for (int k = 0; k < Rank; ++k) r(k, j) = all(rows[k], j);
    return r;
}

/// By how much the rows that are kept are farther from being dependent than a quarter of what others would be.
template <class Matrix, std::size_t Rank>
double kept_row_margin(const Matrix& G, const std::array<int, Rank>& rows) {
    constexpr int most = Rank;
    const constraint_rank kept = independent_rows(kept_rows<most>(G, rows));
    return (kept.rank < most ? 0 : kept.volume) - independent_rows(G, 1e-10, most).volume / 4;
}
/// Keeps those that are farthest from being dependent, where G has the rank.
template <class Matrix, std::size_t Rank>
void choose_rows(const Matrix& G, std::array<int, Rank>& rows) {
    constexpr int most = Rank;
    if (const constraint_rank r = independent_rows(G, 1e-10, most); r.rank == most)
        rows = numbers_in<most>(r);
}

/// dG/dt of the constraints that are kept, where the model has G_rate.
template <class Model, int Rank>
struct kept_rate : Model {
    row_numbers<Rank> rows;
};
template <has_constraint_rate Model, int Rank>
struct kept_rate<Model, Rank> : Model {
    row_numbers<Rank> rows;
    template <class S>
    Eigen::Matrix<S, Rank, Model::coordinates> G_rate(const coordinate_vector<S, Model>& q,
                                                      const coordinate_vector<S, Model>& v) const {
        const Eigen::Matrix<S, Model::constraints, Model::coordinates> all = Model::G_rate(q, v);
        return kept_rows<Rank>(all, *rows);
    }
};

template <int Rank, class Constraint>
struct kept_constraints {
    Constraint all;
    row_numbers<Rank> rows;

    template <int Coordinates>
    auto gradient_of_all(const Eigen::Matrix<double, Coordinates, 1>& q, double t) const {
        using energy = refused_energy;
        using parts = lagrangian_parts<energy, energy, Constraint, no_forces>;
        return lagrangian_model<Coordinates, Rank, parts>(parts{{}, {}, all, {}}).template G<double>(q, t);
    }
    template <class... Arguments>
    requires std::is_invocable_v<const Constraint&, const Arguments&...>
    auto operator()(const Arguments&... q) const {
        static_assert(owns_numbers<std::invoke_result_t<const Constraint&, const Arguments&...>>,
                      "independent_constraints<rank>(constraint, q): the constraint returns an expression of "
                      "Eigen's, whose operands may be gone: write its type or .eval()");
        return kept_rows<Rank>(all(q...), *rows);
    }
};

}  // namespace detail

/// A model with `Rank` of its constraints. Made by `independent_constraints`.
template <class Model, int Rank>
class independent_model_of_rank : public detail::kept_rate<Model, Rank> {
    using base = detail::kept_rate<Model, Rank>;
    template <class S>
    using vector = coordinate_vector<S, Model>;

  public:
    static constexpr int constraints = Rank;

    independent_model_of_rank(Model model, detail::row_numbers<Rank> kept)
        : base{std::move(model), std::move(kept)} {}

    template <class S>
    Eigen::Matrix<S, Rank, Model::coordinates> G(const vector<S>& q, const S& t) const {
        return detail::kept_rows<Rank>(constraint_gradient<S>(all(), q, t), *base::rows);
    }
    template <class S>
    Eigen::Matrix<S, Rank, 1> b(const vector<S>& q, const S& t) const
        requires(has_prescribed_velocity<Model>) {
        return detail::kept_rows<Rank>(prescribed_velocity<S>(all(), q, t), *base::rows);
    }
    template <class S>
    Eigen::Matrix<S, Rank, 1> g(const vector<S>& q, const S& t) const requires(
        requires(const Model& m) { m.g(q); } || requires(const Model& m) { m.g(q, t); }) {
        multiplier_vector<S, Model> values;
        if constexpr (requires(const Model& m) { m.g(q, t); })
            values = all().g(q, t);
        else
            values = all().g(q);
        return detail::kept_rows<Rank>(values, *base::rows);
    }

    /// G of all constraints, those left out as well.
    auto gradient_of_all(const vector<double>& q, double t) const {
        return constraint_gradient<double>(all(), q, t);
    }

  private:
    const Model& all() const { return *this; }
};

/// A model whose constraints depend on others (a door on three hinges, a table on four legs), with those `Rank` of them
/// that are independent at q and time t: the motion is the same, and the multipliers that remain are unique. How a
/// force is shared among dependent constraints is no question that rigid bodies answer; `regularised_position` gives
/// each its stiffness. Constraints that depend on others along the whole motion are meant: those left out are
/// not looked at again, and where those kept lose rank on the way the run ends in status::constraints_dependent, or the
/// motion leaves the others; rows_chosen_anew (rows_chosen_anew.hpp) lets a run keep others there. Copies have their choice
/// in common.
/// Throws std::domain_error with the rank of G if it is another one, as in a singular position.
template <int Rank, class Model>
requires requires { Model::coordinates; }
independent_model_of_rank<Model, Rank> independent_constraints(
    Model model, const std::type_identity_t<coordinate_vector<double, Model>>& q, double t = 0) {
    const auto rows = detail::rows_of_rank<Rank>(constraint_gradient<double>(model, q, t));
    return {std::move(model), rows};
}

/// The same for the constraint of a `lagrangian`, which may have as many rows as coordinates and more:
///
///     const auto model = lagrangian<4, 3>(T, V, independent_constraints<3>(constraint, q));
template <int Rank, class Constraint, int Coordinates>
requires(!requires {
    Constraint::coordinates;
}) auto independent_constraints(Constraint constraint, const Eigen::Matrix<double, Coordinates, 1>& q,
                                double t = 0) {
    static_assert(Coordinates > 0,
                  "independent_constraints<rank>(constraint, q): q must be a vector of fixed size");
    constexpr bool generic = !detail::constraint_in_plain_time<Constraint, Coordinates>;
    static_assert(generic,
                  "independent_constraints<rank>(constraint, q): the constraint must take t of any scalar as "
                  "well, as it is differentiated automatically: [](const auto& q, const auto& t) { ... }");
    detail::kept_constraints<Rank, Constraint> kept{std::move(constraint), nullptr};
    if constexpr (generic) kept.rows = detail::rows_of_rank<Rank>(kept.gradient_of_all(q, t));
    return kept;
}

}  // namespace stagecraft
