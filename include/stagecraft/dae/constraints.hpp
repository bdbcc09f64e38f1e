// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>

#include <stagecraft/dae/rank.hpp>
#include <stagecraft/jacobian/automatic.hpp>
#include <stagecraft/jacobian/central_differences.hpp>
#include <stagecraft/problem/capabilities.hpp>
#include <stagecraft/problem/make_mass.hpp>
#include <stagecraft/problem/unwritten.hpp>

namespace stagecraft {

/// What makes a problem M x' = f(t, x) with singular M differential-algebraic, read off M, f and the index
/// flags (Hairer-Wanner II.VII.1):
///
///     constraints                 0 = c(t, x) = L f, the rows of L spanning the left null space of M;
///     hidden constraints          0 = h(t, x) = U (c_t + c_x x'), where U c_x N = 0, N the right null space
///                                 of M: combinations that do not see the algebraic components,
///                                 differentiated;
///     those of index 3            0 = h_t + h_x x', combined and differentiated once more in the same way.
///
/// The largest index flag of the problem says how often: 1 (or no flags) not at all, 2 once, 3 twice. In
/// semi-explicit form the constraints are 0 = g and h = g_t + g_y f.
///
/// Only M x' = f enters of x', so that a multiple of N added to it changes nothing. The second
/// differentiation takes U as constant, which it is in Hessenberg form. First derivatives are automatic if
/// the problem is generic, its own if it has a dense Jacobian, else central differences; h_x and the
/// derivative of the third kind are differences of these. Costs O(n^2) storage and once an O(n^3)
/// decomposition of M: a tool for starting a run and for looking at it. What the functions return refers to
/// this object, which must live longer; repeated calls allocate nothing.
template <class Problem, class Vector>
class constraint_system {
  public:
    using scalar = typename Vector::Scalar;
    static_assert(
        !has_add_up<Problem, scalar>,
        "problem.add_up: consistent initial values, hidden constraints and projections are not found "
        "for a distributed problem, of which one process sees a part");
    static constexpr int N = Vector::RowsAtCompileTime;
    /// Of constraints and hidden constraints there are at most 3 N: on the stack for small fixed sizes.
    static constexpr int most = N > 0 && N <= 16 && std::is_floating_point_v<scalar> ? 3 * N
                                                                                     : int(Eigen::Dynamic);
    using workspace = detail::workspace<scalar, most>;
    using vector = typename workspace::vector;
    using matrix = typename workspace::matrix;
    using kept_matrix = typename workspace::matrix_type;
    using kept_vector = typename workspace::vector_type;
    using state = typename detail::matrix_pool<Vector>::loan;
    static constexpr bool generic = automatically_differentiable<Problem, scalar, N>;

    /// Which combinations are differentiated: the rows of `once` combine constraints, those of `twice` the
    /// hidden constraints.
    struct selection {
        kept_matrix once, twice;
    };
    /// f and its derivatives at one point.
    struct linearisation {
        state f, f_t;
        matrix J;
    };

    /// `time_scale`: a time over which the problem changes little, for difference quotients in t where t = 0;
    /// used by problems that are not generic. Throws std::invalid_argument if it is not positive and finite,
    /// and for a mass matrix of another size.
    constraint_system(Problem& problem, Eigen::Index n, scalar time_scale = scalar(1))
        : problem_(problem), n_(static_cast<int>(n)), time_scale_(time_scale), engine_(n_) {
        if (!(time_scale > scalar(0)) || !(time_scale - time_scale == scalar(0)))
            throw std::invalid_argument("time_scale must be positive and finite");
        if constexpr (has_index<Problem>)
            for (int i = 0; i < static_cast<int>(problem.index().size()); ++i)
                depth_ = std::max(depth_, static_cast<int>(problem.index()[i]));
        const auto mass = make_mass<scalar>(problem, n);
        kept_matrix M = kept_matrix::Zero(n_, n_);
        if constexpr (std::decay_t<decltype(mass)>::identity)
            M.setIdentity();
        else
            for (const auto& e : mass.entries()) M(e.row, e.column) += e.value;
        const scalar zero = scalar(n_ + 1) * std::numeric_limits<scalar>::epsilon() * scalar(8);
        const auto scale = detail::scale_rows(work_, M, kept_matrix(M));
        const detail::rank_revealing<workspace> decomposed(work_, M, zero);
        directions_ = decomposed.kernel();
        combinations_ = detail::rank_revealing<workspace>(work_, M.transpose(), zero).kernel().transpose();
        detail::reduce_rows(combinations_, zero);
        for (int i = 0; i < n_; ++i) combinations_.col(i) *= scale[i];
        for (int i = 0; i < count(); ++i)
            combinations_.row(i) /= scalar(combinations_(i, largest(combinations_.row(i))));
        inverse_.resize(n_, n_);
        for (int i = 0; i < n_; ++i)
            inverse_.col(i) = decomposed.solve(kept_vector(scale[i] * kept_vector::Unit(n_, i)));
    }

    int size() const { return n_; }
    /// Number of constraints, the rank deficiency of M.
    int count() const { return static_cast<int>(combinations_.rows()); }
    /// The largest index flag.
    int depth() const { return depth_; }
    /// Columns that span the algebraic directions N.
    const kept_matrix& algebraic_directions() const { return directions_; }
    /// The equation that leads constraint i: the row of largest coefficient in it.
    int row(int i) const { return largest(combinations_.row(i)); }
    /// Storage for what is computed with these; it belongs to this object as well.
    workspace& work() { return work_; }
    detail::matrix_pool<Vector>& states() { return states_; }

    linearisation linearise(const scalar& t, const Vector& x) {
        linearisation at{states_.take(n_), states_.take(n_), work_.take(n_, n_)};
        evaluate(t, x, at.f);
        differentiate(t, x, at.f, at.J);
        if constexpr (differentiable_with_dual_time<Problem, scalar, N>) {
            using dual_state = dual_vector<scalar, N>;
            auto y = duals_.take(n_), f = duals_.take(n_);
            dual<scalar, N> time(t);
            time.derivatives().setZero();
            if (time.derivatives().size() > 0) time.derivatives()[0] = scalar(1);
            for (int i = 0; i < n_; ++i) {
                y[i].value() = x[i];
                y[i].derivatives().setZero();
            }
            problem_(time, static_cast<const dual_state&>(y), static_cast<dual_state&>(f));
            for (int i = 0; i < n_; ++i) at.f_t[i] = f[i].derivatives()[0];
        } else {
            using std::abs;
            const scalar step = root() * std::max(scalar(abs(t)), time_scale_);
            state up = states_.take(n_), down = states_.take(n_);
            evaluate(t + step, x, up);
            evaluate(t - step, x, down);
            at.f_t = (up - down) / (2 * step);
        }
        return at;
    }

    /// c = L f.
    vector constraints(const scalar& t, const Vector& x) {
        state f = states_.take(n_);
        evaluate(t, x, f);
        return detail::product(work_, combinations_, f);
    }
    /// c_x.
    matrix constraint_jacobian(const linearisation& at) {
        return detail::product(work_, combinations_, at.J);
    }

    /// An x' with M x' = f, up to a multiple of N and what the constraints violate.
    vector slope(const Vector& f) { return detail::product(work_, inverse_, f); }
    /// The same differentiated by the algebraic directions: M^+ f_x N, f_z in semi-explicit form.
    matrix slope_by_algebraic(const linearisation& at) {
        return detail::product(work_, inverse_, detail::product(work_, at.J, directions_));
    }

    /// Finds the combinations to differentiate at (t, x).
    void select(const scalar& t, const Vector& x, selection& s) {
        if (depth_ < 2 || count() == 0) {
            s.once.resize(0, count());
            s.twice.resize(0, 0);
            return;
        }
        s.once =
            detail::invisible_combinations(work_, constraint_jacobian(linearise(t, x)), directions_, zero());
        if (depth_ < 3 || s.once.rows() == 0)
            s.twice.resize(0, s.once.rows());
        else
            s.twice = detail::invisible_combinations(work_, hidden_jacobian(t, x, s), directions_,
                                                     difference_zero());
    }

    /// U (c_t + c_x x').
    vector hidden(const scalar& t, const Vector& x, const selection& s) {
        if (s.once.rows() == 0) return work_.take(0);
        const linearisation at = linearise(t, x);
        vector along = detail::product(work_, at.J, slope(at.f));
        along += at.f_t;
        return detail::product(work_, s.once, detail::product(work_, combinations_, along));
    }

    /// Its derivative by x, by differences.
    matrix hidden_jacobian(const scalar& t, const Vector& x, const selection& s) {
        return differences(
            x, [&](const Vector& moved) { return hidden(t, moved, s); }, static_cast<int>(s.once.rows()),
            root());
    }

    /// The derivative of `hidden` along the solution, combined by s.twice: its differences in direction (1,
    /// x'), extrapolated once.
    vector twice_hidden(const scalar& t, const Vector& x, const selection& s) {
        using std::abs;
        using std::pow;
        if (s.twice.rows() == 0) return work_.take(0);
        const vector v = slope(linearise(t, x).f);
        const scalar speed = v.size() > 0 ? v.cwiseAbs().maxCoeff() : scalar(0);
        const scalar size = x.cwiseAbs().maxCoeff();
        const scalar along = speed > scalar(0) && size > scalar(0) ? scalar(size / speed) : time_scale_;
        const scalar delta = pow(std::numeric_limits<scalar>::epsilon(), scalar(1) / scalar(5)) * along;
        state at = states_.take(n_);
        const auto difference = [&](const scalar& d) {
            at = x + d * v;
            vector result = hidden(t + d, at, s);
            at = x - d * v;
            result = (result - hidden(t - d, at, s)) / (2 * d);
            return result;
        };
        vector result = difference(delta / 2);
        result = (4 * result - difference(delta)) / 3;
        return detail::product(work_, s.twice, result);
    }

    /// All of them, one after the other.
    vector all(const scalar& t, const Vector& x, const selection& s) {
        vector result = work_.take(count() + s.once.rows() + s.twice.rows());
        result.head(count()) = constraints(t, x);
        result.segment(count(), s.once.rows()) = hidden(t, x, s);
        result.tail(s.twice.rows()) = twice_hidden(t, x, s);
        return result;
    }
    /// Their derivatives by x: exact for the constraints, differences for the others. Those of `twice_hidden`, itself
    /// a difference, need increments that are seen in it: a multiplier that is zero is moved like the largest component.
    matrix all_jacobian(const scalar& t, const Vector& x, const selection& s) {
        matrix result = work_.take(count() + s.once.rows() + s.twice.rows(), n_);
        result.topRows(count()) = constraint_jacobian(linearise(t, x));
        if (s.once.rows() > 0) result.middleRows(count(), s.once.rows()) = hidden_jacobian(t, x, s);
        if (s.twice.rows() > 0)
            result.bottomRows(s.twice.rows()) = differences(
                x, [&](const Vector& moved) { return twice_hidden(t, moved, s); },
                static_cast<int>(s.twice.rows()), wide_root(), scalar(1));
        return result;
    }

    /// Index of the entry of largest modulus.
    template <class Row>
    static int largest(const Row& row) {
        Eigen::Index best = 0;
        row.cwiseAbs().maxCoeff(&best);
        return static_cast<int>(best);
    }

    /// Below it, relative to its row, an entry of c_x N counts as zero.
    static scalar zero() {
        using std::sqrt;
        return generic ? scalar(1000) * std::numeric_limits<scalar>::epsilon()
                       : scalar(sqrt(std::numeric_limits<scalar>::epsilon()) * 10);
    }
    static scalar difference_zero() {
        using std::sqrt;
        return sqrt(std::numeric_limits<scalar>::epsilon()) * scalar(10);
    }

    /// Corrections below this part of the state may be noise: rounding, or with index 3 what is left of it (eps^(2/3)
    /// where derivatives are differences) by a difference over eps^(1/5), times what scales may differ by.
    scalar noise() const {
        using std::pow;
        const scalar eps = std::numeric_limits<scalar>::epsilon();
        if (depth_ < 3) return 1000 * eps;
        return 100 * pow(eps, (generic ? scalar(4) / scalar(5) : scalar(7) / scalar(15)));
    }

  private:
    static scalar root() {
        using std::cbrt;
        return cbrt(std::numeric_limits<scalar>::epsilon());
    }
    static scalar wide_root() {
        using std::sqrt;
        return sqrt(root());
    }

    void evaluate(const scalar& t, const Vector& x, Vector& f) {
        expect_written(f);
        problem_(t, x, f);
    }

    /// J = f_x at (t, x), where f is known.
    void differentiate(const scalar& t, const Vector& x, const Vector& f, kept_matrix& J) {
        using square = Eigen::Matrix<scalar, N, N>;
        if constexpr (generic) {
            engine_(problem_, t, x, f, J);
        } else if constexpr (has_jacobian<Problem, Vector, square> && std::is_same_v<square, kept_matrix>) {
            J.setZero(n_, n_);
            problem_.jacobian(t, x, J);
        } else if constexpr (has_jacobian<Problem, Vector, square>) {
            square own = square::Zero(n_, n_);
            problem_.jacobian(t, x, own);
            J = own;
        } else {
            J = differences(
                x,
                [&](const Vector& moved) {
                    state value = states_.take(n_);
                    evaluate(t, moved, value);
                    return value;
                },
                n_, root());
        }
    }

    template <class F>
    matrix differences(const Vector& x, F&& value, int rows, const scalar& relative,
                       const scalar& floor = scalar(1) / 1000) {
        matrix result = work_.take(rows, n_);
        state moved = states_.take(n_);
        central_differences<Vector>(x, moved, value, relative, result, floor);
        return result;
    }

    using automatic = std::conditional_t<generic, automatic_jacobian<scalar, N>, int>;

    Problem& problem_;
    int n_, depth_ = 1;
    scalar time_scale_;
    workspace work_;
    detail::matrix_pool<Vector> states_;
    detail::matrix_pool<dual_vector<scalar, N>> duals_;
    automatic engine_;
    kept_matrix combinations_, directions_, inverse_;  // L, N, M^+
};

}  // namespace stagecraft
