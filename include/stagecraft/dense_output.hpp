// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include <stagecraft/linear/split_lu.hpp>

namespace stagecraft {

/// The nodes of a stage polynomial besides theta = 0, in the order of the columns that hold its values, with
/// omega_j = 1 / (c_j prod_{m != j} (c_j - c_m)), so that the Lagrange basis on {0, c_1, ...} is
/// l_j(x) = omega_j x prod_{m != j} (x - c_m): no division, and exact at the nodes. A node c_j = 0 doubles
/// the node 0: its column holds the slope there, h u'(t0), as l_j(x) = omega_j x prod (x - c_m) with slope 1
/// is Hermite's function.
template <class Scalar, int MaxStages>
struct interpolation_nodes {
    workspace<Scalar, MaxStages> c, omega;
    int size = 0;
    int first_column = 0;  ///< columns before it do not enter (the first stage of Lobatto IIIC)

    explicit interpolation_nodes(int stages)
        : c(make_workspace<Scalar, MaxStages>(stages)), omega(make_workspace<Scalar, MaxStages>(stages)) {}

    void finish() {
        for (int j = 0; j < size; ++j) {
            Scalar product = c[j] == Scalar(0) ? Scalar(1) : c[j];
            for (int m = 0; m < size; ++m)
                if (m != j) product *= c[j] - c[m];
            omega[j] = Scalar(1) / product;
        }
    }

    template <class Bag>
    void carry(Bag& bag) {
        bag(size, first_column);
        for (int j = 0; j < size; ++j) bag(c[j], omega[j]);
    }

    /// l_1(x), ..., l_size(x).
    void basis(const Scalar& x, Scalar* l) const {
        Scalar prefix = x;
        for (int j = 0; j < size; ++j) {
            l[j] = prefix * omega[j];
            prefix *= x - c[j];
        }
        Scalar suffix = Scalar(1);
        for (int j = size - 1; j >= 0; --j) {
            l[j] *= suffix;
            suffix *= x - c[j];
        }
    }

    /// l_1'(x), ..., by the product rule, O(size^2) with no division.
    void basis_derivative(const Scalar& x, Scalar* l) const {
        for (int j = 0; j < size; ++j) {
            Scalar value = omega[j], slope = Scalar(0);
            slope = slope * x + value;
            value *= x;
            for (int m = 0; m < size; ++m)
                if (m != j) {
                    slope = slope * (x - c[m]) + value;
                    value *= x - c[m];
                }
            l[j] = slope;
        }
    }
};

/// Room for the values of a basis: on the stack to 64 stages, so that evaluation allocates nothing.
template <class Scalar, int MaxStages>
class basis_values {
  public:
    explicit basis_values(int size) {
        if constexpr (MaxStages < 0)
            if (size > 64) large_.resize(size);
    }
    Scalar* data() { return large_.empty() ? small_.data() : large_.data(); }
    Scalar& operator[](int i) { return data()[i]; }

  private:
    std::array<Scalar, (MaxStages > 0 ? MaxStages : 64)> small_;
    std::vector<Scalar> large_;
};

/// The collocation polynomial u of one step, u(t0 + theta h) = y0 + sum_j l_j(theta) z_j (Hairer-Wanner
/// II.IV.8). It is continuous from step to step and costs nothing unless it is evaluated.
///
/// For methods with C(s) its error is O(h^{s+1}) in y, also of index 1, O(h^s) in components of index 2 and
/// O(h^{s-1}) in those of index 3; for Lobatto IIIC (degree s - 1) one order less. A method given by its
/// tableau has the highest order that its slopes allow (step/stage_output.hpp). The ends of the steps have
/// the higher order of the method. So they are more accurate than the values between them: at tight
/// tolerances in all components, and in stiff ones always, by orders of magnitude where a stiff component
/// follows a smooth function in long steps. options.continuous makes the tolerance hold between the ends as
/// well; for methods that do not support it, options.max_step helps.
///
/// The object that a run hands out changes with the next step. A copy of it (n (s + 1) + 2 s numbers) owns
/// all that it needs and outlives the run.
template <class Vector, int MaxStages>
class dense_output {
  public:
    using scalar = typename Vector::Scalar;
    using stage_matrix = Eigen::Matrix<scalar, Vector::RowsAtCompileTime, MaxStages>;

    scalar t0() const { return t0_; }
    scalar t1() const { return t0_ + h_; }
    scalar step() const { return h_; }
    int degree() const { return nodes_.size; }

    /// u(t), meant for t within the step; outside of it the polynomial is extrapolated.
    Vector operator()(const scalar& t) const {
        Vector result(y0_.size());
        evaluate(t, result);
        return result;
    }
    /// The same into a vector that has its size already.
    void evaluate(const scalar& t, Vector& result) const {
        basis_values<scalar, MaxStages> l(nodes_.size);
        nodes_.basis((t - t0_) / h_, l.data());
        result = y0_;
        for (int j = 0; j < nodes_.size; ++j) result += l[j] * z_.col(nodes_.first_column + j);
    }

    /// u'(t), of one order less than u(t).
    Vector derivative(const scalar& t) const {
        Vector result(y0_.size());
        evaluate_derivative(t, result);
        return result;
    }
    /// The same into a vector that has its size already.
    template <class Result>
    void evaluate_derivative(const scalar& t, Result&& result) const {
        result.setZero();
        basis_values<scalar, MaxStages> l(nodes_.size);
        nodes_.basis_derivative((t - t0_) / h_, l.data());
        for (int j = 0; j < nodes_.size; ++j) result += (l[j] / h_) * z_.col(nodes_.first_column + j);
    }

    /// Adds delta (t - t0)/h, so that the end is moved by delta and the start stays.
    template <class Delta>
    void move_end(const Delta& delta) {
        for (int j = 0; j < nodes_.size; ++j) {
            const scalar part = nodes_.c[j] == scalar(0) ? scalar(1) : nodes_.c[j];  // a slope, or a value
            z_.col(nodes_.first_column + j) += part * delta;
        }
    }

    // For the steppers, which alone make one.
    using nodes_type = interpolation_nodes<scalar, MaxStages>;

    /// For n components and at most so many columns of increments; covers no step yet.
    dense_output(int n, int columns) : nodes_(columns), y0_(n), z_(n, columns) {}

    /// From here on: the step from (t, y) of length h, with increments() at `nodes`, which are copied.
    void cover(const nodes_type& nodes, const scalar& t, const scalar& h, const Vector& y) {
        nodes_ = nodes;
        cover(t, h);
        y0_ = y;
    }
    /// The same for a run that asks for no values.
    void cover(const scalar& t, const scalar& h) {
        t0_ = t;
        h_ = h;
    }

    /// All of it (checkpoint.hpp).
    template <class Bag>
    void carry(Bag& bag) {
        bag(nodes_, t0_, h_, y0_);
        for (int j = 0; j < nodes_.size; ++j) {
            auto column = z_.col(nodes_.first_column + j);
            bag(column);
        }
    }

    const nodes_type& nodes() const { return nodes_; }
    /// The state at t0().
    const Vector& y0() const { return y0_; }
    /// z_j = u at node j, less y0, in the columns from nodes().first_column; in the order of the nodes.
    stage_matrix& increments() { return z_; }
    const stage_matrix& increments() const { return z_; }

  private:
    nodes_type nodes_;
    scalar t0_{0}, h_{0};
    Vector y0_;
    stage_matrix z_;
};

}  // namespace stagecraft
