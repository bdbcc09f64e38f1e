// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <stagecraft/linear/banded_matrix.hpp>
#include <stagecraft/linear/mass.hpp>
#include <stagecraft/options.hpp>
#include <stagecraft/problem/system.hpp>
#include <stagecraft/report.hpp>

namespace stagecraft {

namespace detail {

template <class Scalar, class F>
void for_each_entry(const banded_matrix<Scalar>& J, F&& f) {
    for (int j = 0; j < J.size(); ++j)
        for (int i = j > J.upper() ? j - J.upper() : 0; i < J.size() && i <= j + J.lower(); ++i)
            f(i, j, J(i, j));
}

/// r += J x.
template <class Matrix, class Vector>
void add_product(const Matrix& J, const Vector& x, Vector& r) {
    r.noalias() += J * x;
}
template <class Scalar, class Vector>
void add_product(const banded_matrix<Scalar>& J, const Vector& x, Vector& r) {
    for_each_entry(J, [&](int i, int j, const Scalar& entry) { r[i] += entry * x[j]; });
}

/// r += J^T x.
template <class Matrix, class Vector>
void add_transposed_product(const Matrix& J, const Vector& x, Vector& r) {
    r.noalias() += J.transpose() * x;
}
template <class Scalar, class Vector>
void add_transposed_product(const banded_matrix<Scalar>& J, const Vector& x, Vector& r) {
    for_each_entry(J, [&](int i, int j, const Scalar& entry) { r[j] += entry * x[i]; });
}

template <class Matrix>
requires requires(const Matrix& J) { J.transpose(); }
Matrix transposed(const Matrix& J) { return J.transpose(); }
template <class Scalar>
banded_matrix<Scalar> transposed(const banded_matrix<Scalar>& J) {
    banded_matrix<Scalar> result(J.size(), {J.upper(), J.lower()});
    for_each_entry(J, [&](int i, int j, const Scalar& entry) { result(j, i) = entry; });
    return result;
}
inline identity_mass transposed(const identity_mass& M) { return M; }
template <class Scalar>
entry_mass<Scalar> transposed(const entry_mass<Scalar>& M) {
    return M.transposed();
}

}  // namespace detail

/// df/dy and df/dp at the stages of an accepted step of y' = f(t, y, p), p being that of the Problem, an
/// at_parameters. Evaluated anew, so that the run itself is not touched.
template <class Problem, class Vector>
class stage_derivatives {
  public:
    using scalar = typename Vector::Scalar;
    using system_type = system<const Problem, Vector>;
    using matrix = typename system_type::matrix;
    using parameter_matrix =
        Eigen::Matrix<scalar, Vector::RowsAtCompileTime, Problem::parameters::RowsAtCompileTime>;
    static_assert(!system_type::opaque, "sensitivities: a problem with matrix() does not show its Jacobian");
    static_assert(system_type::sums_type::complete, "sensitivities: not of a problem with add_up");

    stage_derivatives(const Problem& problem, const Vector& y0, const options<scalar>& o)
        : problem_(problem), system_(problem_, y0, report_), options_(o), y_(y0), f_(y0), small_(y0) {
        system_.take_jacobian();
    }

    const typename system_type::mass_type& mass() const { return system_.mass(); }
    const matrix& J(int i) const { return J_[static_cast<std::size_t>(i)]; }
    const parameter_matrix& F(int i) const { return F_[static_cast<std::size_t>(i)]; }

    /// Of the step of `method` that has the continuous solution `output`.
    template <class Tableau, class Output>
    void evaluate(const Tableau& method, const Output& output) {
        const std::size_t s = static_cast<std::size_t>(method.stages());
        if (method.c[0] == scalar(0) && output.nodes().first_column == 0)
            throw std::invalid_argument(
                "sensitivities: the stages of Radau IA are not kept; use another method");
        while (J_.size() < s) {
            J_.push_back(system_.jacobian());
            F_.push_back(parameter_matrix::Zero(y_.size(), problem_.p.size()));
        }
        for (std::size_t i = 0; i < s; ++i) {
            const Eigen::Index k = static_cast<Eigen::Index>(i);
            const scalar t = output.t0() + method.c[k] * output.step();
            y_ = output.y0() + output.increments().col(k);
            if constexpr (system_type::finite_difference) {
                system_(t, y_, f_);
                for (Eigen::Index j = 0; j < y_.size(); ++j)
                    small_[j] = absolute_tolerance(options_, j) / options_.rtol / 1000;
            }
            system_.evaluate_jacobian(t, y_, f_, small_);
            J_[i] = system_.jacobian();
            problem_.differentiate(t, y_, F_[i]);
        }
    }

    /// 1/(|y_i| + atol_i/rtol): what sizes of the components are compared by.
    void relative_weights(const Vector& y, Vector& weights) const {
        using std::abs;
        for (Eigen::Index i = 0; i < y.size(); ++i)
            weights[i] = scalar(1) / (abs(y[i]) + absolute_tolerance(options_, i) / options_.rtol);
    }
    const scalar& tolerance() const { return options_.rtol; }

  private:
    const Problem& problem_;
    report<scalar> report_;
    system_type system_;
    options<scalar> options_;
    Vector y_, f_, small_;
    std::vector<matrix> J_;
    std::vector<parameter_matrix> F_;
};

}  // namespace stagecraft
