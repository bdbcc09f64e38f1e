// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/linear/sparse_blocks.hpp>
#include <stagecraft/mechanics/contact.hpp>
#include <stagecraft/mechanics/sized_model.hpp>
#include <stagecraft/refuse/detect/refused_call.hpp>

namespace stagecraft {

/// On which level the constraints of a formulation stand.
enum class constraint_level { velocity, position, both };

namespace sized {

/// Found once, where G is sparse.
struct no_pattern {};
struct kept_pattern {
    Eigen::SparseMatrix<double> pattern;
    const Eigen::SparseMatrix<double>& sparsity() const { return pattern; }
};

/// The pattern of df/dy at y: every component is made NaN in turn, and the components of f that become NaN depend
/// on it. n + 1 evaluations of f.
template <class Problem>
Eigen::SparseMatrix<double> dependencies(const Problem& f, Eigen::VectorXd y) {
    const int n = static_cast<int>(y.size());
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd out(n);
    for (int j = 0; j < n; ++j) {
        const double kept = std::exchange(y[j], std::numeric_limits<double>::quiet_NaN());
        f(0.0, y, out);
        y[j] = kept;
        for (int i = 0; i < n; ++i)
            if (!(out[i] == out[i])) entries.emplace_back(i, j, 1);
    }
    Eigen::SparseMatrix<double> pattern(n, n);
    pattern.setFromTriplets(entries.begin(), entries.end());
    return pattern;
}

/// The smallest x with G x = r.
template <class Matrix>
Eigen::VectorXd smallest_change(const Matrix& G, const Eigen::VectorXd& r) {
    const Eigen::DiagonalMatrix<double, Eigen::Dynamic> metric(Eigen::VectorXd::Ones(G.cols()));
    Eigen::VectorXd right = Eigen::VectorXd::Zero(G.cols() + G.rows());
    right.tail(G.rows()) = r;
    return saddle_point(metric, G, right).head(G.cols());
}

}  // namespace sized

/// The equations of motion of a sized_mechanical_model, ready for `integrate`:
///
///     q' = v,   M v' = F - G^T lambda,   0 = G v + b (velocity) or 0 = g(q) (position),
///
/// on both levels with q' = v - N^T mu (Gear, Gupta and Leimkuhler 1985; Hairer-Wanner II, (VII.1.48)), where N has
/// the rows of G divided by their lengths, so that mu is a velocity (see `stabilised_dae`). The state is
/// (q, v, lambda[, mu]) where M is constant; else the acceleration a is part of it, (q, v, a, lambda[, mu]) with
/// v' = a, 0 = F - G^T lambda - M a, so that M is never factored by itself. Index 2 in a, lambda, mu on the level
/// of velocity and on both, on that of position 2 in v and 3 in a and lambda. The Jacobian is found by differences:
/// in groups of columns where G is sparse. With a contact (mechanics/contact.hpp) the constraint of position
/// becomes 0 = g + (d/c) eps^(1-kappa) (G v + b) - (eps/c) lambda, of index 2 in a and lambda where kappa is 1.
/// Made by index_2, index_3, stabilised_index_2 and regularised_position.
template <sized_mechanical_model Model, constraint_level Level>
class sized_formulation
    : sized::checked_returns<Model>,
      public std::conditional_t<sized::sparse<Model>, sized::kept_pattern, sized::no_pattern> {
  public:
    using vector = Eigen::VectorXd;

    /// q is a position that the model can be evaluated at; sizes are checked and the sparsity is found there.
    sized_formulation(Model model, const vector& q) : sized_formulation(std::move(model), q, {}) {}
    sized_formulation(Model model, const vector& q, std::optional<contact<double>> k)
        : model_(std::move(model)), contact_(std::move(k)) {
        n_ = model_.coordinates();
        m_ = model_.constraints();
        if (n_ < 1 || m_ < 0 || m_ > n_)
            throw std::invalid_argument("mechanical: a model needs 0 <= constraints() <= coordinates()");
        if (q.size() != n_) throw std::invalid_argument("mechanical: q must have coordinates() entries");
        const auto G = sized::G(model_, q, 0.0);
        if (G.rows() != m_ || G.cols() != n_)
            throw std::invalid_argument("mechanical: G must be constraints() x coordinates()");
        if constexpr (sized::sparse<Model>) {
            vector y = vector::Ones(size());
            y.head(n_) = q;
            this->pattern = sized::dependencies(*this, y);
        }
    }

    int size() const { return multipliers_at() + (Level == constraint_level::both ? 2 : 1) * m_; }

    void operator()(double t, const vector& y, vector& f) const {
        const vector q = y.head(n_), v = y.segment(n_, n_), lambda = y.segment(multipliers_at(), m_);
        const auto G = sized::G(model_, q, t);
        const vector force = sized::F(model_, q, v, t) - G.transpose() * lambda;
        f.head(n_) = v;
        if constexpr (sized::constant_mass<Model>) {
            f.segment(n_, n_) = force;
        } else {
            const vector a = y.segment(2 * n_, n_), inertia = sized::M(model_, q) * a;
            f.segment(n_, n_) = a;
            f.segment(2 * n_, n_) = force - inertia;
        }
        if constexpr (Level != constraint_level::position)
            f.segment(multipliers_at(), m_) = sized::velocity_constraint(model_, G, q, v, t);
        if constexpr (Level != constraint_level::velocity) f.tail(m_) = sized::g(model_, q, t);
        if (contact_)
            f.tail(m_) +=
                contact_->damping / contact_->stiffness * sized::velocity_constraint(model_, G, q, v, t) -
                lambda / contact_->stiffness;
        if constexpr (Level == constraint_level::both) {
            const vector lengths = (G.cwiseProduct(G) * vector::Ones(n_)).cwiseSqrt();
            f.head(n_) -= G.transpose() * y.tail(m_).cwiseQuotient(lengths);
        }
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

    std::vector<int> index() const {
        const bool third = Level == constraint_level::position && !(contact_ && contact_->kappa == 1);
        std::vector<int> flags(size(), third ? 3 : 2);
        for (int i = 0; i < 2 * n_; ++i) flags[i] = i < n_ || !third ? 1 : 2;
        return flags;
    }

    /// The state with the acceleration and the multiplier that belong to (q, v) at t (mu = 0). Throws
    /// std::invalid_argument with the size of the largest violation if the constraints do not hold to 1e-9
    /// (relative to 1 + |q| and 1 + |v|), std::domain_error if M or G is singular. With a contact q is moved, by the
    /// smallest change, until the springs carry the multiplier, and v until the dampers rest: both by O(eps); throws
    /// std::runtime_error if there is no such q nearby.
    vector initial_state(vector q, vector v, double t = 0) const {
        check(q, v, t);
        const auto [a, lambda] = sized::acceleration(model_, q, v, t);
        if constexpr (sized::has_position<Model>)
            if (contact_) deflect(q, v, lambda, t);
        vector y = vector::Zero(size());
        y.head(n_) = q;
        y.segment(n_, n_) = v;
        if constexpr (!sized::constant_mass<Model>) y.segment(2 * n_, n_) = a;
        y.segment(multipliers_at(), m_) = lambda;
        return y;
    }
    /// The multiplier in a state, G there, and the forces G^T lambda of the constraints on each coordinate.
    vector multiplier(const vector& y, double = 0) const { return y.segment(multipliers_at(), m_); }
    auto constraint_gradient(const vector& y, double t) const {
        return sized::G(model_, vector(y.head(n_)), t);
    }
    vector constraint_force(double t, const vector& y) const {
        return sized::G(model_, vector(y.head(n_)), t).transpose() * multiplier(y);
    }
    const Model& model() const { return model_; }

  private:
    void deflect(vector& q, vector& v, const vector& lambda, double t) const {
        constexpr int most = 20;
        for (int k = 0;; ++k) {
            const vector change = sized::smallest_change(
                sized::G(model_, q, t), vector(sized::g(model_, q, t) - lambda / contact_->stiffness));
            const double size = change.cwiseAbs().maxCoeff();
            if (k == most || !(size - size == 0))
                throw std::runtime_error("regularised_position: no position near q carries lambda");
            q -= change;
            if (size <= 1e-14 * (1 + q.cwiseAbs().maxCoeff())) break;
        }
        v -= sized::smallest_change(sized::G(model_, q, t), sized::velocity_constraint(model_, q, v, t));
    }

    int multipliers_at() const { return (sized::constant_mass<Model> ? 2 : 3) * n_; }

    void check(const vector& q, const vector& v, double t) const {
        if (q.size() != n_ || v.size() != n_)
            throw std::invalid_argument("mechanical: q and v must have coordinates() entries");
        std::ostringstream violated;
        const auto look = [&](const char* what, const vector& r, double allowed) {
            Eigen::Index at = 0;
            const double largest = r.size() == 0 ? 0 : r.cwiseAbs().maxCoeff(&at);
            if (!(largest <= allowed)) violated << "; " << what << " constraint " << at << " is " << r[at];
        };
        if constexpr (sized::has_position<Model>)
            look("position", sized::g(model_, q, t), 1e-9 * (1 + q.cwiseAbs().maxCoeff()));
        look("velocity", sized::velocity_constraint(model_, q, v, t), 1e-9 * (1 + v.cwiseAbs().maxCoeff()));
        if (const std::string text = violated.str(); !text.empty()) detail::refuse_start(text, t);
    }

    Model model_;
    std::optional<contact<double>> contact_;
    int n_ = 0, m_ = 0;
};

/// The index-2 system of a model, on the level of velocity. `q` is any position that the model can be evaluated at.
template <sized_mechanical_model Model>
sized_formulation<Model, constraint_level::velocity> index_2(Model model, const Eigen::VectorXd& q) {
    return {std::move(model), q};
}
/// The index-3 system of a model with position constraints.
template <sized_mechanical_model Model>
requires sized::has_position<Model> sized_formulation<Model, constraint_level::position> index_3(
    Model model, const Eigen::VectorXd& q) {
    return {std::move(model), q};
}
/// Its stabilised index-2 system, with the constraints on both levels.
template <sized_mechanical_model Model>
requires sized::has_position<Model> sized_formulation<Model, constraint_level::both> stabilised_index_2(
    Model model, const Eigen::VectorXd& q) {
    return {std::move(model), q};
}

/// The regularised form of a model with position constraints, every one a joint with a spring and a damper; see the
/// `regularised_position` of models of fixed size. Throws std::invalid_argument that names a parameter out of range.
template <sized_mechanical_model Model>
requires sized::has_position<Model> sized_formulation<Model, constraint_level::position> regularised_position(
    Model model, const Eigen::VectorXd& q, double eps, double kappa, double c, double d) {
    return {std::move(model), q, contact<double>(eps, kappa, c, d)};
}

/// Of models of a size known at run time these are not formed: without a scalar to differentiate by, dG/dt would be a
/// difference, and its derivative in the Jacobian a difference of differences.
template <sized_mechanical_model Model, class... Numbers>
sized_formulation<Model, constraint_level::velocity> index_reduced(Model model, const Numbers&...) {
    static_assert(
        detail::never<Model>,
        "index_reduced, baumgarte and invariants need a mechanical_model of fixed size; for a size known at "
        "run time take stabilised_index_2(model, q), which does not drift, or index_2(model, q)");
    return {std::move(model), Eigen::VectorXd()};
}
template <sized_mechanical_model Model, class... Numbers>
auto baumgarte(Model model, const Numbers&... numbers) {
    return index_reduced(std::move(model), numbers...);
}
template <sized_mechanical_model Model>
auto invariants(Model model) {
    return index_reduced(std::move(model));
}
template <sized_mechanical_model Model, class... Numbers>
sized_formulation<Model, constraint_level::velocity> regularised(Model model, const Numbers&...) {
    static_assert(detail::never<Model>,
                  "regularised needs a mechanical_model of fixed size; for a size known at run time take "
                  "regularised_position(model, q, eps, kappa, c, d), or index_2(model, q), its limit");
    return {std::move(model), Eigen::VectorXd()};
}

}  // namespace stagecraft
