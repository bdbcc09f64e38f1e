// SPDX-License-Identifier: BSL-1.0
// says: problem.mass must be a member function
// says: problem.index must be a member function
// says: problem.bandwidth must be a member function
// says: problem.sparsity must be a member function
// says: problem.jacobian must be a member function
// says: problem.constant_jacobian must be a member function
// says: problem.second_order_components must be
// says: Problem::linear_solver must be a type
// says: problem.measure must be a member function
// says: problem.add_up must be a member function
// says: problem.matrix must be a member function
// says: problem.precondition is used without a Jacobian only
#include <array>
#include <stagecraft/linear/dense_blocks.hpp>
#include <stagecraft/linear/sparse_blocks.hpp>
#include <stagecraft/refuse/problem/checked_capabilities.hpp>

// Optional members that are there and cannot be used, and the same as they must be.
using Eigen::Matrix2d, Eigen::Vector2d;

#ifdef RIGHT
struct massive {
    Matrix2d mass() const;
};
struct index_flags {
    std::array<int, 2> index() const;
};
struct band {
    stagecraft::bandwidth bandwidth() const;
};
struct sparse {
    Eigen::SparseMatrix<double> sparsity() const;
};
struct derived {
    void jacobian(double, const Vector2d&, Matrix2d&) const;
};
struct constant final {
    bool constant_jacobian() const;
};
struct second_order {
    static constexpr int second_order_components = 1;
};
struct solver {
    using linear_solver = stagecraft::dense_blocks<double, 2>;
};
struct stopwatch {
    int measure(stagecraft::work) const;
};
struct distributed {
    void add_up(double*, int) const;
};
struct opaque {
    Matrix2d matrix() const;
};
struct not_opaque {
    using matrix = Matrix2d;
};
struct preconditioned {
    void precondition(double, double*) const;
    Matrix2d matrix() const;
};
#else
struct massive {
    Matrix2d mass();
};
struct index_flags {
    std::array<int, 2> index;
};
struct band {
    int bandwidth() const;
};
class sparse {
    Eigen::SparseMatrix<double> sparsity() const;
};
struct derived {
    void jacobian(double, const Vector2d&, Eigen::MatrixXd&) const;
};
struct constant final {
    bool constant_jacobian();
};
struct second_order {
    int second_order_components = 1;
};
struct solver {
    struct linear_solver {
        struct real {};
    };
};
struct stopwatch {
    int measure() const;
};
struct distributed {
    double add_up(double) const;
};
struct opaque {
    Matrix2d matrix;
};
struct not_opaque {};
struct preconditioned {
    void precondition(double, double*) const;
    void jacobian(double, const Vector2d&, Matrix2d&) const;
};
#endif

template struct stagecraft::checked_capabilities<const massive, Vector2d, Matrix2d>;
template struct stagecraft::checked_capabilities<const index_flags, Vector2d, Matrix2d>;
template struct stagecraft::checked_capabilities<const band, Vector2d, Matrix2d>;
template struct stagecraft::checked_capabilities<const sparse, Vector2d, Matrix2d>;
template struct stagecraft::checked_capabilities<const derived, Vector2d, Matrix2d>;
template struct stagecraft::checked_capabilities<const constant, Vector2d, Matrix2d>;
template struct stagecraft::checked_capabilities<const second_order, Vector2d, Matrix2d>;
template struct stagecraft::checked_capabilities<const solver, Vector2d, Matrix2d>;
template struct stagecraft::checked_capabilities<const stopwatch, Vector2d, Matrix2d>;
template struct stagecraft::checked_capabilities<const distributed, Vector2d, Matrix2d>;
template struct stagecraft::checked_capabilities<const opaque, Vector2d, Matrix2d>;
template struct stagecraft::checked_capabilities<const not_opaque, Vector2d, Matrix2d>;
template struct stagecraft::checked_capabilities<const preconditioned, Vector2d, Matrix2d>;
