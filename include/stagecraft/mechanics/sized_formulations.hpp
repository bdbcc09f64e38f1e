// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/linear/sparse_blocks.hpp>
#include <stagecraft/mechanics/formulations.hpp>
#include <stagecraft/mechanics/sized_model.hpp>
#include <stagecraft/mechanics/spring_joints.hpp>
#include <stagecraft/problem/found_sparsity.hpp>

namespace stagecraft {

namespace sized {

/// Found once, where G is sparse.
struct no_pattern {};
struct kept_pattern {
    Eigen::SparseMatrix<double> pattern;
    const Eigen::SparseMatrix<double>& sparsity() const { return pattern; }
};

/// The smallest x with G x = r.
template <class Matrix>
Eigen::VectorXd smallest_change(const Matrix& G, const Eigen::VectorXd& r) {
    const Eigen::DiagonalMatrix<double, Eigen::Dynamic> metric(Eigen::VectorXd::Ones(G.cols()));
    Eigen::VectorXd right = Eigen::VectorXd::Zero(G.cols() + G.rows());
    right.tail(G.rows()) = r;
    return saddle_point(metric, G, right).head(G.cols());
}

}  // namespace sized

namespace detail {

/// The equations of motion of models whose size is known at run time:
///
///     q' = v,   M v' = F - G^T lambda,
///
/// with M on the left. The state is (q, v, lambda, ...) where M is constant; else the acceleration a is part of it,
/// (q, v, a, lambda, ...) with v' = a, 0 = F - G^T lambda - M a, so that M is never factored by itself; the index of a is
/// that of lambda. The Jacobian is found by differences: in groups of columns where G is sparse.
template <class Derived, sized_mechanical_model Model, class Scalar, int Multipliers>
class equations_of_motion<Derived, Model, Scalar, Multipliers>
    : checked_model<Model>,
      public std::conditional_t<sized::sparse<Model>, sized::kept_pattern, sized::no_pattern> {
  public:
    using state = Eigen::VectorXd;
    using vector = Eigen::VectorXd;

    equations_of_motion(Model model, const vector& q)
        : model_(std::move(model)), n_(model_.coordinates()), m_(model_.constraints()) {
        if (n_ < 1 || m_ < 0 || m_ > n_)
            throw std::invalid_argument("mechanical: a model needs 0 <= constraints() <= coordinates()");
        if (q.size() != n_) throw std::invalid_argument("mechanical: q must have coordinates() entries");
        const auto G = stagecraft::constraint_gradient<double>(model_, q, 0.0);
        if (G.rows() != m_ || G.cols() != n_)
            throw std::invalid_argument("mechanical: G must be constraints() x coordinates()");
    }

    int size() const { return multipliers_at() + Multipliers * m_; }

    void operator()(double t, const vector& y, vector& f) const {
        const vector q = position(y);
        const auto G = stagecraft::constraint_gradient<double>(model_, q, t);
        vector held = force<double>(model_, q, velocity(y), t);
        subtract_transposed(G, multiplier(y), held);
        f.head(n_) = velocity(y);
        if constexpr (sized::constant_mass<Model>) {
            f.segment(n_, n_) = held;
        } else {
            const vector a = y.segment(2 * n_, n_), inertia = model_.M(q) * a;
            f.segment(n_, n_) = a;
            f.segment(2 * n_, n_) = held - inertia;
        }
        static_cast<const Derived&>(*this).constrain(t, y, G, f);
    }

    Eigen::SparseMatrix<double> mass() const {
        std::vector<Eigen::Triplet<double>> entries;
        for (int i = 0; i < n_; ++i) entries.emplace_back(i, i, 1);
        if constexpr (sized::constant_mass<Model>)
            sized::append(entries, model_.M(), n_, n_, 1);
        else
            for (int i = n_; i < 2 * n_; ++i) entries.emplace_back(i, i, 1);
        Eigen::SparseMatrix<double> M(size(), size());
        M.setFromTriplets(entries.begin(), entries.end());
        return M;
    }

    /// The state with the acceleration and the multiplier that belong to (q, v) at t (mu = 0). Throws
    /// std::invalid_argument with the size of each violation if the constraints do not hold to 1e-9
    /// (relative to |q| and |v|, or absolutely), std::domain_error if M or G is singular.
    vector initial_state(const vector& q, const vector& v, double t = 0) const {
        if (q.size() != n_ || v.size() != n_)
            throw std::invalid_argument("mechanical: q and v must have coordinates() entries");
        check_start(model_, q, v, t);
        const auto [a, lambda] = sized::acceleration(model_, q, v, t);
        vector y = vector::Zero(size());
        y.head(n_) = q;
        y.segment(n_, n_) = v;
        if constexpr (!sized::constant_mass<Model>) y.segment(2 * n_, n_) = a;
        y.segment(multipliers_at(), m_) = lambda;
        static_cast<const Derived&>(*this).settle(t, y);
        return y;
    }
    /// The multiplier in a state, G there, and the forces G^T lambda of the constraints on each coordinate.
    vector multiplier(const vector& y, double = 0) const { return multipliers(y); }
    auto constraint_gradient(const vector& y, double t) const {
        return stagecraft::constraint_gradient<double>(model_, position(y), t);
    }
    vector constraint_force(double t, const vector& y) const {
        return constraint_gradient(y, t).transpose() * multiplier(y);
    }
    const Model& model() const { return model_; }
    /// The rank of G in a state and the constraints that depend on others there, or nearly; empty where none does.
    std::string dependent_constraints(double t, const vector& y) const {
        return dependence_in_words(constraint_gradient(y, t));
    }

  protected:
    /// What a formulation changes in a consistent start: nothing.
    void settle(double, vector&) const {}
    vector position(const vector& y) const { return y.head(n_); }
    vector velocity(const vector& y) const { return y.segment(n_, n_); }
    vector multipliers(const vector& y, int k = 0) const { return y.segment(multipliers_at() + k * m_, m_); }
    void put_position(const vector& q, vector& f) const { f.head(n_) = q; }
    void put_multipliers(const vector& r, vector& f, int k = 0) const {
        f.segment(multipliers_at() + k * m_, m_) = r;
    }
    std::vector<int> flags(int second, int third = std::numeric_limits<int>::max()) const {
        std::vector<int> flags(static_cast<std::size_t>(size()), 3);
        for (int i = 0; i < size() && i < third; ++i) flags[static_cast<std::size_t>(i)] = i < second ? 1 : 2;
        return flags;
    }
    int coordinates() const { return n_; }

    void find_pattern(const vector& q) {
        if constexpr (sized::sparse<Model>) {
            vector y = vector::Ones(size());
            y.head(n_) = q;
            this->pattern = find_sparsity(static_cast<const Derived&>(*this), y, 0, pattern_search::by_nan);
        }
    }
    /// Moves q, by the smallest change, until springs carry the multiplier, and v until dampers rest.
    void deflect(vector& y, double stiffness, double t) const {
        constexpr int most = 20;
        const vector v = velocity(y), lambda = multipliers(y);
        for (int k = 0;; ++k) {
            const vector q = position(y),
                         change = sized::smallest_change(
                             stagecraft::constraint_gradient<double>(model_, q, t),
                             vector(position_constraint<double>(model_, q, t) - lambda / stiffness));
            const double size = change.cwiseAbs().maxCoeff();
            if (k == most || !(size - size == 0))
                throw std::runtime_error("regularised_position: no position near q carries lambda");
            y.head(n_) -= change;
            if (size <= 1e-14 * (1 + y.head(n_).cwiseAbs().maxCoeff())) break;
        }
        const auto G = constraint_gradient(y, t);
        y.segment(n_, n_) -=
            sized::smallest_change(G, velocity_constraint<double>(model_, G, position(y), v, t));
    }

    Model model_;

  private:
    int multipliers_at() const { return (sized::constant_mass<Model> ? 2 : 3) * n_; }

    int n_, m_;
};

}  // namespace detail

/// The formulations of models whose size is known at run time, with M on the left and sparse linear algebra where G is sparse.
template <class Model, constraint_level Level>
using sized_formulation = formulation<Model, Level>;

/// The index-2 system of a model, on the level of velocity. `q` is any position that the model can be evaluated at.
template <sized_mechanical_model Model>
index_2_dae<Model> index_2(Model model, const Eigen::VectorXd& q) {
    return {std::move(model), q};
}
/// The index-3 system of a model with position constraints.
template <sized_mechanical_model Model>
requires holonomic_model<Model> index_3_dae<Model> index_3(Model model, const Eigen::VectorXd& q) {
    return {std::move(model), q};
}
/// Its stabilised index-2 system, with the constraints on both levels.
template <sized_mechanical_model Model>
requires holonomic_model<Model> stabilised_dae<Model> stabilised_index_2(Model model,
                                                                         const Eigen::VectorXd& q) {
    return {std::move(model), q};
}

/// The regularised form of a model with position constraints, every one a joint with a spring and a damper; see the
/// `regularised_position` of models of fixed size. Throws std::invalid_argument that names a parameter out of range.
template <sized_mechanical_model Model>
requires holonomic_model<Model> regularised_position_problem<Model> regularised_position(
    Model model, const Eigen::VectorXd& q, double eps, double kappa, double c, double d) {
    return {std::move(model), q, contact<double>(eps, kappa, c, d)};
}

}  // namespace stagecraft
