// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <stdexcept>
#include <type_traits>

#include <stagecraft/dense_output.hpp>
#include <stagecraft/jacobian/dual_number.hpp>
#include <stagecraft/mechanics/model.hpp>
#include <stagecraft/method/spark_method.hpp>
#include <stagecraft/stages/partitioned_stages.hpp>
#include <stagecraft/step/method_set.hpp>
#include <stagecraft/step/step_between_slopes.hpp>

namespace stagecraft {

namespace detail {

/// What a stage of a holonomic system is made of, at position q and velocity v.
template <class S, class Model>
struct stage_forces {
    coordinate_vector<S, Model> momentum;  // M v
    coordinate_vector<S, Model> force;     // F + (dM/dt) v
    Eigen::Matrix<S, Model::constraints, Model::coordinates> G;
    multiplier_vector<S, Model> g;

    stage_forces(const Model& model, const coordinate_vector<S, Model>& q,
                 const coordinate_vector<S, Model>& v, const S& t)
        : momentum(model.M(q) * v),
          force(stagecraft::force<S>(model, q, v, t)),
          G(constraint_gradient<S>(model, q, t)),
          g(position_constraint<S>(model, q, t)) {
        using rate = dual_number<S, 1>;
        coordinate_vector<rate, Model> moving;
        for (int i = 0; i < Model::coordinates; ++i) {
            moving[i].value() = q[i];
            moving[i].derivatives()[0] = v[i];
        }
        const Eigen::Matrix<rate, Model::coordinates, Model::coordinates> M = model.M(moving);
        for (int i = 0; i < Model::coordinates; ++i)
            for (int j = 0; j < Model::coordinates; ++j) force[i] += M(i, j).derivatives()[0] * v[j];
    }
};

template <class Problem>
concept holonomic_motion = requires(const Problem& p) {
    requires holonomic_model<std::remove_cvref_t<decltype(p.model())>>;
    requires fixed_size_model<std::remove_cvref_t<decltype(p.model())>>;
    requires Problem::size == 2 * Problem::n;
};

}  // namespace detail

/// One step of SPARK (Jay 1996) for p = M(q) v, p' = F + (dM/dt) v - G^T lambda, 0 = g(q, t):
///
///     Q_i = q + h sum_j a_ij V_j,  M(Q_i) V_i = p + h sum_j a^_ij (Phi_j - G_j^T Lambda_j),  0 = g(Q_i), i = 2, ..., s
///
/// and the last Lambda from G v + b = 0 at the end. Solved by Newton's iteration with M, G and G M^-1 G^T at the start of the
/// step, down to rounding: s evaluations of F, M and G an iteration, one factorisation of M and of G M^-1 G^T a step.
template <int Stages, class Space>
class spark_step : public step_between_slopes<Space> {
    using Scalar = typename Space::scalar;
    using base = step_between_slopes<Space>;
    using base::output_wanted_;
    using square = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

  public:
    using vector = typename Space::vector;
    using output = typename Space::output;

    spark_step(const spark_method<Scalar, Stages>& method, int n)
        : base(n), pair_(method.pair), n_(n / 2), end_(n) {
        const int s = count();
        const square product = square(pair_.first.A) * square(pair_.second.A);
        B_inverse_ = product.block(1, 0, s - 1, s - 1).inverse();
        V_.setZero(n_, s);
    }

    template <class System>
    void prepare(const System&, const run_demands& demands) {
        constexpr bool suits = detail::holonomic_motion<std::remove_cv_t<typename System::problem_type>>;
        static_assert(suits,
                      "integrate: spark(first, second) needs index_reduced(model) of a holonomic model, with "
                      "position constraints g, of a size known at compile time");
        if constexpr (suits) Lambda_.setZero(System::problem_type::m, count());
        if (!demands.fixed)
            throw std::invalid_argument("integrate: spark has no error estimate: give options.fixed_step");
        output_wanted_ = demands.output;
    }

    spark_step& stages() { return *this; }
    /// The first of the two, by which a checkpoint knows the pair again.
    const tableau<Scalar, Stages>& method() const { return pair_.first; }
    int count() const { return pair_.stages(); }
    int order() const { return pair_.first.facts.order; }
    int coupled_stages_count() const { return count(); }
    bool implicit() const { return false; }
    static constexpr bool iterates() { return true; }

    template <class System, class Norm>
    newton_outcome<Scalar> solve(System& system, const Scalar& t, const vector& y, const Scalar& h,
                                 const Norm& norm, const newton_limits<Scalar>& limits,
                                 typename output::stage_matrix&, long& solves) {
        newton_outcome<Scalar> outcome;
        if constexpr (detail::holonomic_motion<std::remove_cv_t<typename System::problem_type>>)
            outcome = iterate(system, t, y, h, norm, limits, solves);
        return outcome;
    }
    void guess(const output*, const vector& y, const Scalar&, output&, const Scalar& = Scalar(1)) {
        for (int i = 0; i < count(); ++i) V_.col(i) = y.tail(n_);
    }
    void advance(const vector&, const output&, vector& y1) { y1 = end_; }
    template <class Bag>
    void carry(Bag& bag) {
        for (int j = 0; j < Lambda_.cols(); ++j)
            for (int i = 0; i < Lambda_.rows(); ++i) bag(Lambda_(i, j));
    }

  private:
    template <class System, class Norm>
    newton_outcome<Scalar> iterate(System& system, const Scalar& t, const vector& y, const Scalar& h,
                                   const Norm& norm, const newton_limits<Scalar>& limits, long& solves) {
        using Model = std::remove_cvref_t<decltype(std::declval<typename System::problem_type&>().model())>;
        constexpr int n = Model::coordinates, m = Model::constraints;
        using position = coordinate_vector<Scalar, Model>;
        using multiplier = multiplier_vector<Scalar, Model>;
        const Model* model = nullptr;
        system.evaluate_part([&](auto& problem) { model = &problem.model(); }, false);
        const int s = count();
        const auto& A = pair_.first.A;
        const auto& A_hat = pair_.second.A;
        const position q = y.template head<n>(), v = y.template tail<n>();
        const mass_inverse<Scalar, Model> solve_mass(*model, q);
        const Eigen::Matrix<Scalar, m, n> G = constraint_gradient<Scalar>(*model, q, t);
        const Eigen::Matrix<Scalar, n, m> W = solve_mass.of_transposed(G);
        const small_ldlt<Scalar, m> inertia(multiplier_matrix<Scalar, Model>(G * W));
        const position p = model->M(q) * v;
        Eigen::Matrix<Scalar, n, Stages> D(n, s), rest(n, s), change(n, s);
        Eigen::Matrix<Scalar, m, Stages> g(m, s), turned(m, s), dL(m, s);
        newton_monitor<Scalar> monitor(down_to_rounding(limits));
        position last_force;
        while (monitor.may_go_on()) {
            for (int i = 0; i < s; ++i) {
                position Q = q;
                for (int j = 0; j < s; ++j) Q += (h * A(i, j)) * V_.col(j);
                system.evaluate_part(
                    [&](auto&) {
                        const detail::stage_forces<Scalar, Model> at(*model, Q, position(V_.col(i)),
                                                                     t + pair_.first.c[i] * h);
                        D.col(i) = at.force - at.G.transpose() * multiplier(Lambda_.col(i));
                        rest.col(i) = p - at.momentum;
                        g.col(i) = at.g;
                        last_force = at.force;
                    },
                    true);
            }
            for (int i = 0; i < s; ++i) {
                position r = rest.col(i);
                for (int j = 0; j + 1 < s; ++j) r += (h * A_hat(i, j)) * D.col(j);
                change.col(i) = solve_mass(r);
            }
            for (int k = 1; k < s; ++k) {
                position moved = position::Zero();
                for (int j = 0; j < s; ++j) moved += A(k, j) * change.col(j);
                turned.col(k - 1) = inertia.solve(multiplier((multiplier(g.col(k)) / h + G * moved) / h));
            }
            for (int l = 0; l + 1 < s; ++l) {
                dL.col(l).setZero();
                for (int k = 0; k + 1 < s; ++k) dL.col(l) += B_inverse_(l, k) * turned.col(k);
                Lambda_.col(l) += dL.col(l);
            }
            for (int i = 0; i < s; ++i) {
                for (int l = 0; l + 1 < s; ++l) change.col(i) -= (h * A_hat(i, l)) * (W * dL.col(l));
                V_.col(i) += change.col(i);
            }
            ++solves;
            Scalar size(0);
            for (int i = 0; i < s; ++i) {
                end_.head(n_) = h * change.col(i);
                end_.tail(n_) = h * change.col(i);
                const Scalar one = norm(end_);
                if (!(one <= size)) size = one;
            }
            if (monitor.over(size)) break;
        }
        position q1 = q, p1 = p + (h * pair_.second.b[s - 1]) * last_force;
        for (int j = 0; j < s; ++j) {
            q1 += (h * pair_.first.b[j]) * V_.col(j);
            if (j + 1 < s) p1 += (h * pair_.second.b[j]) * D.col(j);
        }
        const Scalar t1 = t + h;
        const mass_inverse<Scalar, Model> solve_end(*model, q1);
        const Eigen::Matrix<Scalar, m, n> G1 = constraint_gradient<Scalar>(*model, q1, t1);
        const Eigen::Matrix<Scalar, n, m> W1 = solve_end.of_transposed(G1);
        const small_ldlt<Scalar, m> inertia_end(multiplier_matrix<Scalar, Model>(G1 * W1));
        position v1 = solve_end(p1);
        const multiplier impulse = inertia_end.solve(velocity_constraint<Scalar>(*model, G1, q1, v1, t1));
        v1 -= W1 * impulse;
        Lambda_.col(s - 1) = impulse / (h * pair_.second.b[s - 1]);
        // Once more for what rounding has left of G v + b.
        v1 -= W1 * inertia_end.solve(velocity_constraint<Scalar>(*model, G1, q1, v1, t1));
        end_.head(n_) = q1;
        end_.tail(n_) = v1;
        return monitor.outcome();
    }

    partitioned_method<Scalar, Stages> pair_;
    int n_;
    square B_inverse_;  // of A A^, rows 2, ..., s, columns 1, ..., s - 1
    vector end_;
    Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> V_, Lambda_;  // a column a stage
};

namespace detail {

template <class Scalar, int Stages>
struct step_for<spark_method<Scalar, Stages>> {
    static constexpr bool named = true;
    static constexpr int columns = 3;
    template <class Space>
    using type = spark_step<Stages, Space>;
};

}  // namespace detail

}  // namespace stagecraft
