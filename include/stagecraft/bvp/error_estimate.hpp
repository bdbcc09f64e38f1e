// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include <stagecraft/observe/solution.hpp>
#include <stagecraft/tableau/legendre_rule.hpp>

namespace stagecraft {

/// Lifts a collocation solution of order p at the mesh points to that order everywhere, and says how wrong
/// it is. On every interval the equation e' = f_y e + d for the error of the collocation polynomial u, d = u'
/// - f(t, u), is solved from e = 0 by Gauss collocation with m = max(p, s + 1) nodes, where f_y is the
/// polynomial through the Jacobians of Newton's iteration: no new Jacobians, m evaluations of f. Then
///
///     w = u - e                             solves the equation through y_i to order m + 1,
///     delta_i = w(t_{i+1}) - y_{i+1}        is the local error of the mesh values,
///
/// and the returned solution is w less a line that removes delta_i (the aim of Enright-Muir 1999). The global
/// error of the mesh values is one more solve with the factors at hand, driven by delta; between them the
/// defect of w is measured at two points where it is large.
template <class Equations>
class error_estimate {
  public:
    using iterate = typename Equations::iterate;
    using scalar = std::decay_t<decltype(iterate{}.t[0])>;
    using wide = typename Equations::wide;
    using column = typename Equations::column;
    using matrix = typename Equations::matrix;

    error_estimate(Equations& equations, int order)
        : equations_(equations),
          order_(order),
          rule_(nodes_for(order, equations.s(), equations.method().facts.r_infinity)),
          Q_(rule_.size(), rule_.size()),
          ell_(rule_.size(), equations.s()) {
        const int m = rule_.size();
        for (int k = 0; k < m; ++k) {
            Q_.row(k) = rule_.integral(rule_.c[k]);
            ell_.row(k) = lagrange(rule_.c[k]);
        }
        check_[0] = check_point(scalar(0), scalar(3) / 10);
        check_[1] = check_point(scalar(3) / 10, scalar(1));
        for (int k = 0; k < 2; ++k) {
            check_value_[k] = rule_.value(check_[k]);
            check_integral_[k] = rule_.integral(check_[k]);
            check_ell_[k] = lagrange(check_[k]);
        }
    }

    int nodes() const { return rule_.size(); }

    /// False where f is not finite at one of its points (place() of the equations does not know them).
    bool run(const iterate& x, const scalar& floor) {
        const int L = x.intervals(), n = equations_.n(), m = nodes();
        floor_ = floor;
        slopes_.resize(n, m * L);
        delta_.resize(n, L);
        inner_.resize(n, L);
        defect_ = scalar(0);
        for (int i = 0; i < L; ++i)
            if (!lift(x, i)) return false;
        solve(x);
        return true;
    }

    const scalar& place() const { return place_; }
    const wide& local() const { return delta_; }      ///< local errors of the mesh values
    const wide& inner() const { return inner_; }      ///< local errors between them
    const iterate& global() const { return error_; }  ///< of mesh values and parameters
    const scalar& defect() const { return defect_; }
    /// The largest error of the global one and the local one in interval i, component c.
    scalar bound(int i, int c) const {
        using std::abs;
        const scalar l = abs(error_.y(c, i)), r = abs(error_.y(c, i + 1));
        return (l > r ? l : r) + abs(inner_(c, i));
    }

    /// y and the scaled slope h y' of the returned solution at t_i + theta h.
    template <class Y>
    void evaluate(const iterate& x, int i, const scalar& theta, Y&& y, Y&& slope) const {
        const int m = nodes();
        const auto W = slopes_.middleCols(i * m, m);
        const auto values = rule_.value(theta), integrals = rule_.integral(theta);
        y = x.y.col(i) - theta * delta_.col(i);
        slope = -delta_.col(i);
        for (int k = 0; k < m; ++k) {
            y += integrals[k] * W.col(k);
            slope += values[k] * W.col(k);
        }
    }

    /// From here on evaluate() means the collocation polynomial: where the errors are no longer small, what
    /// was to correct them is a worse start for the next mesh than nothing.
    void unlift(const iterate& x) {
        const int m = nodes(), s = equations_.s();
        for (int i = 0; i < x.intervals(); ++i)
            slopes_.middleCols(i * m, m) = x.Z.middleCols(i * s, s) * ell_.transpose();
        delta_.setZero();
    }

    /// The returned solution as an object of its own.
    template <class Vector>
    void write(const iterate& x, solution<Vector>& out) const {
        const int m = nodes(), n = equations_.n();
        interpolation_nodes<scalar, dynamic> at(m);
        at.size = m;
        for (int k = 0; k < m; ++k) at.c[k] = rule_.c[k];
        at.finish();
        dense_output<Vector, dynamic> piece(n, m);
        out.start(x.t.front(), x.y.col(0), x.t.back());
        for (int i = 0; i < x.intervals(); ++i) {
            piece.cover(at, x.t[i], x.h(i), Vector(x.y.col(i)));
            const auto W = slopes_.middleCols(i * m, m);
            for (int k = 0; k < m; ++k) {
                piece.increments().col(k) = -rule_.c[k] * delta_.col(i);
                for (int l = 0; l < m; ++l) piece.increments().col(k) += Q_(k, l) * W.col(l);
            }
            out(x.t[i + 1], Vector(x.y.col(i + 1)), x.h(i), piece);
        }
    }

  private:
    /// At least max(p, s + 1); as Gauss methods have R(inf) = 1 or -1 for even or odd numbers of nodes, that
    /// with the sign of the method's own, so that both carry stiff components on in the same way.
    static int nodes_for(int order, int s, double r_infinity) {
        const int m = std::max(order, s + 1);
        if (r_infinity == -1) return m % 2 == 1 ? m : m + 1;
        if (r_infinity == 1) return m % 2 == 0 ? m : m + 1;
        return m;
    }
    /// Halfway between two nodes, where the polynomial with zeros at the collocation points is large: there the
    /// interpolated Jacobians are at their worst.
    scalar check_point(const scalar& from, const scalar& to) const {
        using std::abs;
        scalar best = (from + to) / 2, largest(0);
        for (int k = 0; k + 1 < nodes(); ++k) {
            const scalar middle = (rule_.c[k] + rule_.c[k + 1]) / 2;
            scalar product(1);
            for (int j = 0; j < equations_.s(); ++j) product *= abs(middle - equations_.method().c[j]);
            if (middle >= from && middle <= to && product > largest) largest = product, best = middle;
        }
        return best;
    }
    Eigen::Matrix<scalar, 1, Eigen::Dynamic> lagrange(const scalar& theta) const {
        const auto& c = equations_.method().c;
        Eigen::Matrix<scalar, 1, Eigen::Dynamic> l(equations_.s());
        for (int j = 0; j < equations_.s(); ++j) {
            l[j] = scalar(1);
            for (int k = 0; k < equations_.s(); ++k)
                if (k != j) l[j] *= (theta - c[k]) / (c[j] - c[k]);
        }
        return l;
    }
    /// Once, and again where the interpolated Jacobians leave a defect that counts beside delta.
    bool lift(const iterate& x, int i) {
        const int m = nodes(), s = equations_.s();
        auto W = slopes_.middleCols(i * m, m);
        W = x.Z.middleCols(i * s, s) * ell_.transpose();
        interpolate_jacobians(i, x.h(i));
        for (int pass = 0; pass < 2; ++pass) {
            if (!defects(x, i)) return false;
            if (!sweep()) solve_implicitly();
            W -= g_;
            delta_.col(i) = x.y.col(i) - x.y.col(i + 1);
            for (int k = 0; k < m; ++k) delta_.col(i) += rule_.b[k] * W.col(k);
            if (!check(x, i)) return false;
            if (20 * inner_.col(i).cwiseAbs().maxCoeff() <= delta_.col(i).cwiseAbs().maxCoeff()) break;
        }
        return true;
    }

    /// d = M w' - f(t, w), scaled by h, at the nodes.
    bool defects(const iterate& x, int i) {
        const int n = equations_.n(), m = nodes();
        const scalar h = x.h(i);
        const auto W = slopes_.middleCols(i * m, m);
        U_ = W * Q_.transpose();
        d_.resize(n, m);
        for (int k = 0; k < m; ++k) {
            stage_ = x.y.col(i) + U_.col(k);
            const scalar t = x.t[i] + rule_.c[k] * h;
            const auto& f = equations_.system().f(t, stage_, x.p);
            if (!all_finite(f, n)) return fail_at(t);
            d_.col(k) = -h * f.head(n);
            add_mass_times(equations_.mass(), scalar(1), W.col(k).data(), d_.col(k).data(), n);
        }
        return true;
    }

    /// h f_y at the Gauss nodes, side by side.
    void interpolate_jacobians(int i, const scalar& h) {
        const int n = equations_.n(), m = nodes(), s = equations_.s(), width = n + equations_.np();
        const auto J = equations_.jacobians(i);
        hJ_.setZero(n, n * m);
        for (int k = 0; k < m; ++k)
            for (int j = 0; j < s; ++j)
                hJ_.middleCols(k * n, n) += (h * ell_(k, j)) * J.middleCols(j * width, n);
    }

    /// g = d + h f_y (integral of g) by iteration, which costs least where h f_y is moderate; false where it
    /// does not contract.
    bool sweep() {
        using std::abs;
        if constexpr (!std::decay_t<decltype(equations_.mass())>::identity) return false;
        const int n = equations_.n(), m = nodes();
        g_ = d_;
        scalar before(0);
        for (int k = 0; k < order_ + 4; ++k) {
            next_ = g_ * Q_.transpose();
            scalar change(0), size(0);
            for (int j = 0; j < m; ++j) {
                stage_ = d_.col(j);
                stage_.noalias() += hJ_.middleCols(j * n, n) * next_.col(j);
                for (int c = 0; c < n; ++c) {
                    const scalar move = abs(stage_[c] - g_(c, j)), value = abs(stage_[c]);
                    if (move > change) change = move;
                    if (value > size) size = value;
                }
                g_.col(j) = stage_;
            }
            if (change <= scalar(1) / 100000 * size) return true;
            if (k > 2 && !(change < before / 2)) return false;
            before = change;
        }
        return false;
    }

    /// The same by one dense factorisation, where the interval is stiff or the mass matrix singular.
    void solve_implicitly() {
        const int n = equations_.n(), m = nodes();
        matrix a(n * m, n * m);
        for (int k = 0; k < m; ++k)
            for (int l = 0; l < m; ++l) {
                a.block(k * n, l * n, n, n) = -Q_(k, l) * hJ_.middleCols(k * n, n);
                if (k != l) continue;
                matrix own = matrix::Zero(n, n);
                add_mass(equations_.mass(), scalar(1), own.data(), n);
                a.block(k * n, l * n, n, n) += own;
            }
        const column right = Eigen::Map<const column>(d_.data(), n * m);
        const column g = a.partialPivLu().solve(right);
        g_.resize(n, m);
        std::copy_n(g.data(), n * m, g_.data());
    }

    /// The defect of w off its nodes, as local error: (I - h f_y / 4)^-1 h d / 4.
    bool check(const iterate& x, int i) {
        using std::abs;
        const int n = equations_.n(), m = nodes(), s = equations_.s(), width = n + equations_.np();
        const scalar h = x.h(i);
        const auto W = slopes_.middleCols(i * m, m);
        inner_.col(i).setZero();
        for (int k = 0; k < 2; ++k) {
            stage_ = x.y.col(i) + W * check_integral_[k].transpose();
            const scalar t = x.t[i] + check_[k] * h;
            const auto& f = equations_.system().f(t, stage_, x.p);
            if (!all_finite(f, n)) return fail_at(t);
            own_ = W * check_value_[k].transpose();
            off_ = -h * f.head(n);
            add_mass_times(equations_.mass(), scalar(1), own_.data(), off_.data(), n);
            for (int c = 0; c < n; ++c) {
                const scalar defect = (abs(off_[c]) + abs(delta_(c, i))) / h / (floor_ + abs(f[c]));
                if (defect > defect_) defect_ = defect;
            }
            small_.setZero(n, n);
            const auto J = equations_.jacobians(i);
            for (int j = 0; j < s; ++j) small_ -= (reach * h * check_ell_[k][j]) * J.middleCols(j * width, n);
            add_mass(equations_.mass(), scalar(1), small_.data(), n);
            off_ = small_.partialPivLu().solve(off_);
            for (int c = 0; c < n; ++c)
                if (reach * abs(off_[c]) > inner_(c, i)) inner_(c, i) = reach * abs(off_[c]);
        }
        return true;
    }

    void solve(const iterate& x) {
        const int L = x.intervals();
        zero_.setZero(equations_.n(), equations_.s() * L);
        minus_ = -delta_;
        const column none = column::Zero(equations_.n() + equations_.np());
        equations_.solve(x, zero_, minus_, none, error_);
    }

    bool fail_at(const scalar& t) {
        place_ = t;
        return false;
    }

    Equations& equations_;
    int order_;
    legendre_rule<scalar> rule_;
    matrix Q_, ell_;
    scalar check_[2];
    const scalar reach = scalar(1) / 4;  ///< of a defect, as a part of the interval
    Eigen::Matrix<scalar, 1, Eigen::Dynamic> check_value_[2], check_integral_[2], check_ell_[2];
    wide slopes_, delta_, inner_, U_, d_, g_, next_, hJ_, zero_, minus_;
    Eigen::Matrix<scalar, wide::RowsAtCompileTime, 1> stage_, own_, off_;
    Eigen::Matrix<scalar, wide::RowsAtCompileTime, wide::RowsAtCompileTime> small_;
    iterate error_;
    scalar floor_{0}, defect_{0}, place_{0};
};

}  // namespace stagecraft
