// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include <stagecraft/linear/banded_matrix.hpp>
#include <stagecraft/owned_value.hpp>
#include <stagecraft/work.hpp>

namespace stagecraft {

/// Thrown when the first evaluation shows that a problem is not what it claims to be. Leaves integrate().
struct bad_problem : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// All that a problem must have: `problem(t, y, f)` writes f(t, y) of M y' = f(t, y) into f. M is the
/// identity unless the problem has a member `mass()`. f arrives with the size of y and must be written in
/// every component; what it holds before is unspecified (NaN in builds with assertions,
/// problem/unwritten.hpp).
///
/// Every other member is optional and found by its name. A member with one of the names below that cannot be
/// used as described does not compile (refuse/problem/checked_capabilities.hpp). That includes one whose
/// requires-clause is not met: put a member that only some instances of a template have into a base class
/// that you choose. A member with a misspelt name is not found, and is then missing from the list of what was
/// found that print(out, result) begins with (report_text.hpp).
template <class Problem, class Vector>
concept right_hand_side = Eigen::MatrixBase<Vector>::ColsAtCompileTime == 1 &&
                          requires(Problem& p, const typename Vector::Scalar& t, const Vector& y, Vector& f) {
    p(t, y, f);
};

/// Optional: `problem.jacobian(t, y, J)` writes df/dy into J, an n x n matrix. J is zero at the first call
/// and later holds what was last written, so that entries which are always zero need not be written.
template <class Problem, class Vector, class Matrix>
concept has_jacobian = requires(Problem& p, const typename Vector::Scalar& t, const Vector& y, Matrix& J) {
    p.jacobian(t, y, J);
};

/// Optional: `problem.bandwidth()` returns the stagecraft::bandwidth of df/dy; jacobian(t, y, J), if there is
/// one, then writes into a banded_matrix. Include linear/banded_blocks.hpp.
template <class Problem>
concept has_bandwidth = requires(Problem& p) {
    { p.bandwidth() } -> std::convertible_to<bandwidth>;
};

/// Optional: `problem.sparsity()` returns an Eigen::SparseMatrix with the pattern of df/dy (values do not
/// matter); jacobian(t, y, J), if there is one, then writes into a sparse matrix that arrives with that
/// pattern. Include linear/sparse_blocks.hpp.
template <class Problem>
concept has_sparsity = requires(Problem& p, std::remove_cvref_t<decltype(p.sparsity())>& pattern) {
    pattern.makeCompressed();
};

/// Optional: a member type `linear_solver` names the solvers for shift M - J to use instead of the built-in ones, a model of
/// the concept linear_solver (linear/linear_solver.hpp, which says what solvers that iterate may have besides).
template <class Problem>
concept has_linear_solver = requires {
    typename Problem::linear_solver::real;
    typename Problem::linear_solver::complex;
};

/// Optional: `problem.matrix()` returns the object that jacobian(t, y, J) writes df/dy into, of any type: the
/// steppers call its rows() and cols() alone, which are the size of y, and hand it to the problem's own linear_solver
/// (factor_shifted). It must be movable. For matrices that other libraries hold, and those that are never formed.
template <class Problem>
concept has_matrix = requires(Problem& p) {
    p.matrix().rows();
    p.matrix().cols();
};

/// Optional: `problem.add_up(x, k)` makes the problem a distributed one: y is the part of the state that belongs to
/// this process, every process calls integrate() with its own, and add_up replaces k numbers at x by their sums over
/// all processes, the same bits on each. All that a run decides it decides from such sums, so that the
/// processes stay in step; options (but for atol_components), method and times must be the same on all, and are compared.
/// jacobian(), linear_solver and f may communicate as long as all processes do so together; what throws must complete its
/// communication first. A factorisation that fails on one process has failed on all.
/// An exception on one process ends the run on all: there with status::function_threw, on the others with
/// status::non_finite. (Arguments refused on one, y0 say, are std::invalid_argument on all.)
template <class Problem, class Scalar>
concept has_add_up = requires(Problem& p, Scalar* x, int k) {
    p.add_up(x, k);
};

/// Optional: `problem.mass()` returns the constant matrix M (dense, sparse or diagonal of Eigen's, or a
/// banded_matrix), singular allowed. With bandwidth() it must lie within that band. With a linear_solver of the
/// problem's own M may be an operator instead, with rows(), cols() and add_times(factor, x, r), which adds factor M x
/// to r, both pointers to n contiguous numbers; a copy of it is kept.
template <class Problem>
concept has_mass = requires(Problem& p) {
    p.mass().rows();
    p.mass().cols();
};

/// An M that is known by its products alone; add_times(factor, x, r) adds factor M x to r.
template <class Mass, class Scalar>
concept mass_operator = requires(const Mass& m, const Scalar& factor, const Scalar* x, Scalar* r) {
    m.add_times(factor, x, r);
};

/// Optional: `problem.index()` returns something indexable with size(): the differentiation index 1, 2 or 3
/// of each component (HLR89, section 7; 0 and 1 mean the same). The norms of Newton's iteration and of the
/// error estimate weigh a component by |h|^(index - 1). These weights have units: t is to be measured such that the solution
/// changes in times of about 1. Where it changes within 1e-9, components of index 2 and 3 are hardly controlled,
/// whatever their atol is.
template <class Problem>
concept has_index = requires(Problem& p) {
    requires std::integral<std::remove_cvref_t<decltype(p.index()[0])>>;
    p.index().size();
};
/// As it must be: an object, not an expression of Eigen's.
template <class Problem>
concept has_owned_index = has_index<Problem> && requires(Problem& p) {
    { p.index() } -> detail::owns_numbers;
};

/// Optional: `problem.constant_jacobian()` returns true if df/dy depends neither on t nor on y. Then J is
/// evaluated once in a run, and one Newton iteration per step is enough. If the first step contradicts the
/// claim it is ignored.
template <class Problem>
concept has_constant_jacobian = requires(Problem& p) {
    { p.constant_jacobian() } -> std::convertible_to<bool>;
};

/// Optional: `static constexpr int second_order_components = m`: the problem is a system of second order,
/// the first m components are positions q, the next m their velocities v, with q' = v and mass one in these
/// rows and columns. Eigen::Dynamic stands for n/2. With a dense J matrices of size n - m are factored.
template <class Problem>
concept has_second_order_components = requires {
    typename std::integral_constant<int, Problem::second_order_components>;
};
/// That m for a state of n components.
template <has_second_order_components Problem>
constexpr int position_components(int n) {
    return Problem::second_order_components == Eigen::Dynamic ? n / 2 : Problem::second_order_components;
}

/// Optional: `problem.domain(t, y)` returns false outside of the domain of the solution, in which no accepted state lies then
/// (problem/with_domain.hpp).
template <class Problem, class Vector>
concept has_domain = requires(Problem& p, const typename Vector::Scalar& t, const Vector& y) {
    { p.domain(t, y) } -> std::convertible_to<bool>;
};

/// A problem in two parts (problem/split.hpp): problem(t, y, f) is what implicit stages solve for, and
/// problem.explicit_part(t, y, f) writes the rest of the right-hand side. Only additive methods take it.
template <class Problem>
concept in_parts = requires {
    typename std::remove_const_t<Problem>::explicit_function;
};

/// Optional: `problem.measure(work)` returns an object that lives as long as that work takes
/// (problem/time_split.hpp).
template <class Problem>
concept has_stopwatch = requires(Problem& p) {
    p.measure(work::f);
};

}  // namespace stagecraft
