// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include <stagecraft/jacobian/reverse_functions.hpp>
#include <stagecraft/linear/banded_matrix.hpp>
#include <stagecraft/linear/mass.hpp>
#include <stagecraft/options.hpp>
#include <stagecraft/problem/system.hpp>
#include <stagecraft/report.hpp>
#include <stagecraft/sensitivity/derivative_check.hpp>
#include <stagecraft/sensitivity/matrix_products.hpp>
#include <stagecraft/sensitivity/parameters.hpp>

namespace stagecraft {

/// Where the derivatives along a step are taken: at its stages, number 0, 1, ..., and at its left end, number s. The run
/// itself is not touched. Problem is an at_parameters.
template <class Problem, class Vector>
class stage_points {
  public:
    using scalar = typename Vector::Scalar;
    using system_type = system<const Problem, Vector>;
    using matrix = typename system_type::matrix;
    using by =
        detail::parameter_derivatives<typename Problem::original, Vector, typename Problem::parameters>;
    static_assert(!system_type::opaque, "sensitivities: a problem with matrix() does not show its Jacobian");
    static_assert(system_type::sums_type::complete, "sensitivities: not of a problem with add_up");

    stage_points(const Problem& problem, const Vector& y0, const options<scalar>& o)
        : problem_(problem), system_(problem_, y0, report_), options_(o), f_(y0), small_(y0) {
        system_.take_jacobian();
    }

    const typename system_type::mass_type& mass() const { return system_.mass(); }
    const Problem& problem() const { return problem_; }
    system_type& evaluations() { return system_; }
    /// Evaluates the Jacobian that the run would use at point i, which need not be df/dy.
    const matrix& near_jacobian(int i) {
        const scalar& t = points_[static_cast<std::size_t>(i)].t;
        const Vector& y = points_[static_cast<std::size_t>(i)].y;
        if constexpr (system_type::finite_difference) {
            system_(t, y, f_);
            for (Eigen::Index j = 0; j < y.size(); ++j)
                small_[j] = absolute_tolerance(options_, j) / options_.rtol / 1000;
        }
        system_.evaluate_jacobian(t, y, f_, small_);
        return system_.jacobian();
    }

    /// The step of `method` that has the continuous solution `output`; A_inverse is that of the method, which may be given
    /// transposed.
    template <class Tableau, class Inverse, class Output>
    void place(const Tableau& method, [[maybe_unused]] const Inverse& A_inverse, const Output& output) {
        if (method.c[0] == scalar(0) && output.nodes().first_column == 0)
            throw std::invalid_argument(
                "sensitivities: the stages of Radau IA are not kept; use another method");
        const int s = method.stages();
        points_.resize(static_cast<std::size_t>(s) + 1, {scalar(0), output.y0(), output.y0()});
        for (int i = 0; i < s; ++i) {
            point& at = points_[static_cast<std::size_t>(i)];
            at.t = output.t0() + method.c[i] * output.step();
            at.y = output.y0() + output.increments().col(i);
            if constexpr (Problem::mass_depends) {
                at.slope.setZero();
                for (int j = 0; j < s; ++j)
                    at.slope += A_inverse(i, j) / output.step() * output.increments().col(j);
            }
        }
        place(s, output.t0(), output.y0());
        if constexpr (Problem::mass_depends) points_.back().slope = output.derivative(output.t0());
    }
    /// Point number i alone.
    void place(int i, const scalar& t, const Vector& y) {
        if (points_.size() <= static_cast<std::size_t>(i))
            points_.resize(static_cast<std::size_t>(i) + 1, {t, y, Vector::Zero(y.size())});
        points_[static_cast<std::size_t>(i)].t = t;
        points_[static_cast<std::size_t>(i)].y = y;
    }
    int points() const { return static_cast<int>(points_.size()); }
    const scalar& t(int i) const { return points_[static_cast<std::size_t>(i)].t; }
    const Vector& y(int i) const { return points_[static_cast<std::size_t>(i)].y; }
    const Vector& slope(int i) const { return points_[static_cast<std::size_t>(i)].slope; }

    /// 1/(|y_i| + atol_i/rtol): what sizes of the components are compared by.
    void relative_weights(const Vector& y, Vector& weights) const {
        using std::abs;
        for (Eigen::Index i = 0; i < y.size(); ++i)
            weights[i] = scalar(1) / (abs(y[i]) + absolute_tolerance(options_, i) / options_.rtol);
    }
    const scalar& tolerance() const { return options_.rtol; }
    const options<scalar>& given_options() const { return options_; }

  private:
    struct point {
        scalar t;
        Vector y, slope;
    };
    const Problem& problem_;
    report<scalar> report_;
    system_type system_;
    options<scalar> options_;
    Vector f_, small_;
    std::vector<point> points_;
};

/// J v and F w, the derivatives of f with respect to y and p in a direction, exact to rounding where f is generic.
///
/// Matrices are used where they are exact, or all there is: where df/dy comes from automatic differentiation, and where
/// parameter_jacobian is given, so that f need not be generic; then both are compared with differences of f in every step
/// (derivative_check.hpp). Otherwise f is called in dual numbers of one direction for every product: a jacobian() of the
/// problem's own, or differences within its sparsity(), may be wrong and serve the iteration alone.
template <class Problem, class Vector>
class forward_derivatives : public stage_points<Problem, Vector> {
    using base = stage_points<Problem, Vector>;
    using typename base::by;

  public:
    using typename base::matrix, typename base::scalar;
    using parameters = typename Problem::parameters;
    static constexpr bool by_matrices = by::given || base::system_type::automatic;

    forward_derivatives(const Problem& problem, const Vector& y0, const options<scalar>& o)
        : base(problem, y0, o), check_(y0, problem.p) {
        if constexpr (!by_matrices) {
            q_ = detail::promoted<number>(problem.p);
            y_ = detail::promoted<number>(y0);
            f_ = y_;
        }
    }

    /// Evaluates what is needed at point i, or at all.
    void evaluate(int i) {
        if constexpr (by_matrices) {
            const auto size = static_cast<std::size_t>(this->points());
            if (J_.size() < size) {
                J_.resize(size, this->evaluations().jacobian());
                F_.resize(size, detail::zero_matrix<typename by::matrix>(this->y(0).size(),
                                                                         this->problem().p.size()));
            }
            const auto k = static_cast<std::size_t>(i);
            J_[k] = this->near_jacobian(i);
            detail::differentiate_by_parameters<by>(this->problem(), this->t(i), this->y(i), this->slope(i),
                                                    F_[k]);
        }
    }
    void evaluate() {
        for (int i = 0; i < this->points(); ++i) evaluate(i);
    }
    /// What a comparison of the matrices at point i with differences of f says against them; empty: nothing.
    std::string refuted(int i) {
        if constexpr (by::given) {
            const auto k = static_cast<std::size_t>(i);
            return check_(this->problem(), this->t(i), this->y(i), J_[k], F_[k], this->given_options());
        }
        return {};
    }

    /// f := J v + F e_k at point i; without F where k is negative.
    void operator()(int i, const Vector& v, int k, Vector& f) {
        if constexpr (by_matrices) {
            if (k < 0)
                f.setZero();
            else
                f = F_[static_cast<std::size_t>(i)].col(k);
            detail::add_product(J_[static_cast<std::size_t>(i)], v, f);
        } else {
            for (Eigen::Index j = 0; j < v.size(); ++j) {
                y_[j].value() = this->y(i)[j];
                y_[j].derivatives()[0] = v[j];
            }
            if (k >= 0) q_[k].derivatives()[0] = scalar(1);
            this->problem().template residual<by>(this->t(i), y_, q_, this->slope(i), f_);
            if (k >= 0) q_[k].derivatives()[0] = scalar(0);
            for (Eigen::Index j = 0; j < v.size(); ++j) f[j] = f_[j].derivatives()[0];
        }
    }

  private:
    using number = dual_number<scalar, 1>;
    std::vector<matrix> J_;
    std::vector<typename by::matrix> F_;
    Eigen::Matrix<number, Vector::RowsAtCompileTime, 1> y_, f_;
    Eigen::Matrix<number, parameters::RowsAtCompileTime, 1> q_;
    derivative_check<scalar> check_;
};

/// J^T v and F^T v: of a generic f from the tape of one call at every point, at a cost that does not depend on the number
/// of parameters; else from jacobian() and parameter_adjoint() or parameter_jacobian(), compared with differences of f.
template <class Problem, class Vector>
class adjoint_derivatives : public stage_points<Problem, Vector> {
    using base = stage_points<Problem, Vector>;
    using typename base::by;

  public:
    using typename base::matrix, typename base::scalar;
    using parameters = typename Problem::parameters;
    static constexpr bool taped = !by::given && !by::adjoint_given;

    adjoint_derivatives(const Problem& problem, const Vector& y0, const options<scalar>& o)
        : base(problem, y0, o), check_(y0, problem.p) {}

    void evaluate() {
        const auto size = static_cast<std::size_t>(this->points());
        if constexpr (taped) {
            records_.resize(size);
            for (int i = 0; i + 1 < this->points(); ++i) record(i, records_[static_cast<std::size_t>(i)]);
        } else {
            if (J_.size() < size) J_.resize(size, this->evaluations().jacobian());
            for (int i = 0; i + 1 < this->points(); ++i)
                J_[static_cast<std::size_t>(i)] = this->near_jacobian(i);
            if constexpr (by::given && !by::adjoint_given) {
                F_.resize(size, detail::zero_matrix<typename by::matrix>(this->y(0).size(),
                                                                         this->problem().p.size()));
                for (int i = 0; i + 1 < this->points(); ++i)
                    detail::differentiate_by_parameters<by>(this->problem(), this->t(i), this->y(i),
                                                            this->slope(i), F_[static_cast<std::size_t>(i)]);
            }
        }
    }
    /// As forward_derivatives::refuted.
    std::string refuted(int i) {
        if constexpr (!taped) {
            const auto k = static_cast<std::size_t>(i);
            if constexpr (by::adjoint_given)
                return check_.transposed(this->problem(), this->t(i), this->y(i), J_[k],
                                         this->given_options());
            else
                return check_(this->problem(), this->t(i), this->y(i), J_[k], F_[k], this->given_options());
        }
        return {};
    }

    /// A matrix near J at point i, for the iteration.
    const matrix& near_jacobian_of(int i) {
        if constexpr (taped)
            return this->near_jacobian(i);
        else
            return J_[static_cast<std::size_t>(i)];
    }
    /// f += J^T v at point i.
    void add_by_state(int i, const Vector& v, Vector& f) {
        if constexpr (taped) {
            auto& record = sweep(i, v);
            for (int j = 0; j < f.size(); ++j) f[j] += record.operations.adjoint(j);
        } else {
            detail::add_transposed_product(J_[static_cast<std::size_t>(i)], v, f);
        }
    }
    /// q += F^T v at point i.
    void add_by_parameters(int i, const Vector& v, parameters& q) {
        if constexpr (taped) {
            auto& record = sweep(i, v);
            const int n = static_cast<int>(v.size());
            for (int j = 0; j < q.size(); ++j) q[j] += record.operations.adjoint(n + j);
        } else if constexpr (by::adjoint_given) {
            static_assert(!Problem::mass_depends, "adjoint_gradient: parameter_adjoint is not with mass(p)");
            parameters product = parameters::Zero(q.size());
            this->problem().parameter_adjoint(this->t(i), this->y(i), this->problem().p, v, product);
            q += product;
        } else {
            q += F_[static_cast<std::size_t>(i)].transpose() * v;
        }
    }

    /// Both, with one look at the tape.
    void add_both(int i, const Vector& v, Vector& f, parameters& q) {
        if constexpr (taped) {
            add_by_state(i, v, f);
            const auto& operations = records_[static_cast<std::size_t>(i)].operations;
            const int n = static_cast<int>(v.size());
            for (int j = 0; j < q.size(); ++j) q[j] += operations.adjoint(n + j);
        } else {
            add_by_state(i, v, f);
            add_by_parameters(i, v, q);
        }
    }

  private:
    using number = reverse_number<scalar>;
    struct one_call {
        tape<scalar> operations;
        std::vector<int> results;
    };
    void record(int i, one_call& to) {
        const int n = static_cast<int>(this->y(i).size()), m = static_cast<int>(this->problem().p.size());
        to.operations.start(n + m);
        Eigen::Matrix<number, Vector::RowsAtCompileTime, 1> y(n), f(n);
        Eigen::Matrix<number, parameters::RowsAtCompileTime, 1> q(m);
        for (int j = 0; j < n; ++j) y[j] = number(this->y(i)[j], &to.operations, j);
        for (int j = 0; j < m; ++j) q[j] = number(this->problem().p[j], &to.operations, n + j);
        this->problem().template residual<by>(this->t(i), y, q, this->slope(i), f);
        to.results.resize(static_cast<std::size_t>(n));
        for (int j = 0; j < n; ++j) to.results[static_cast<std::size_t>(j)] = f[j].number();
    }
    one_call& sweep(int i, const Vector& v) {
        one_call& record = records_[static_cast<std::size_t>(i)];
        record.operations.clear_adjoints();
        for (int j = 0; j < v.size(); ++j)
            record.operations.seed(record.results[static_cast<std::size_t>(j)], v[j]);
        record.operations.sweep();
        return record;
    }

    std::vector<one_call> records_;
    std::vector<matrix> J_;
    std::vector<typename by::matrix> F_;
    derivative_check<scalar> check_;
};

}  // namespace stagecraft
