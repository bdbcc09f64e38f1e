// SPDX-License-Identifier: BSL-1.0
// says: write jacobian(t, y, J), J of the type of matrix()
// says: give the problem a linear_solver
// says: second_order_components cannot be used in a distributed problem
// says: problem.matrix needs jacobian(t, y, J)
// says: consistent initial values, hidden constraints and projections are not found
// says: observers with correct()
#include <stagecraft/dae/consistent.hpp>
#include <stagecraft/linear/dense_blocks.hpp>
#include <stagecraft/observe/observer.hpp>
#include <stagecraft/problem/system.hpp>

// What cannot be done with a part of the state alone, and the same with all of it.
using Eigen::MatrixXd, Eigen::VectorXd;

struct decay {
    void operator()(double, const VectorXd& y, VectorXd& f) const { f = -y; }
};
struct with_solver : decay {
    using linear_solver = stagecraft::dense_blocks<double, Eigen::Dynamic>;
};
struct with_jacobian : decay {
    void jacobian(double, const VectorXd&, MatrixXd& J) const { J.setIdentity(); }
};
struct complete : with_solver {
    void jacobian(double, const VectorXd&, MatrixXd& J) const { J.setIdentity(); }
};
#ifdef RIGHT
template <class Problem>
using part = Problem;
constexpr bool cut = false;
#else
template <class Problem>
struct part : Problem {
    void add_up(double*, int) const {}
};
constexpr bool cut = true;
#endif
struct without_jacobian : part<with_solver> {};
struct without_solver : part<with_jacobian> {};
struct of_second_order : part<complete> {
    static constexpr int second_order_components = Eigen::Dynamic;
};
struct opaque : decay {
    MatrixXd matrix() const;
#ifdef RIGHT
    using linear_solver = stagecraft::dense_blocks<double, Eigen::Dynamic>;
    void jacobian(double, const VectorXd&, MatrixXd& J) const { J.setIdentity(); }
#endif
};
template class stagecraft::system<const without_jacobian, VectorXd>;
template class stagecraft::system<const without_solver, VectorXd>;
template class stagecraft::system<const of_second_order, VectorXd>;
template struct stagecraft::detail::checked_distribution<
    opaque, double, stagecraft::has_jacobian<opaque, VectorXd, MatrixXd>>;
template class stagecraft::constraint_system<const part<complete>, VectorXd>;

struct correction {
    bool correct(double, VectorXd&) const { return false; }
};
struct run {
    static constexpr bool distributed = cut;
    double t() const;
    const VectorXd& y() const;
    void replace_state(const VectorXd&);
};
void corrected(correction& watch, run& of, VectorXd& y) { stagecraft::detail::correct(watch, of, y); }
