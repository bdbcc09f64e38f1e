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
/// and the global error E of the mesh values, with its slopes between them, is one more solve with the factors at
/// hand, driven by delta. The returned solution is w less this error plus the line from E_i to E_{i+1}: continuous
/// (the aim of Enright-Muir 1999), and no worse inside an interval than at its ends. (w less a line that removes
/// delta_i would be: where solutions grow by e^{|h f_y|}, delta_i is that much larger than E_i and E_{i+1}.) What
/// is left of the defect of w is measured at two points where it is large.
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
        left_over_.resize(n, 2 * L);
        scale_.resize(n, 2 * L);
        defect_ = scalar(0);
        for (int i = 0; i < L; ++i)
            if (!lift(x, i)) return false;
        solve(x);
        for (int i = 0; i < L; ++i) straighten(x, i);
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
    /// The largest of |error| / (floor + |y|) there: the line between the global errors beside y at the ends
    /// and nodes, y being taken as straight from one to the next.
    scalar relative(const iterate& x, int i, int c) const {
        using std::abs;
        const auto& method = equations_.method();
        const int s = equations_.s();
        const auto over = [&](const scalar& theta, const scalar& size) {
            return scalar(abs((1 - theta) * error_.y(c, i) + theta * error_.y(c, i + 1)) / (floor_ + size));
        };
        scalar at(0), y = x.y(c, i), least = abs(y), worst = over(at, least);
        for (int j = 0; j <= s; ++j) {
            const scalar theta = j < s ? method.c[j] : scalar(1);
            scalar value = x.y(c, j < s ? i : i + 1), here;
            if (j < s)
                for (int k = 0; k < s; ++k) value += method.A(j, k) * x.Z(c, i * s + k);
            const bool crossed = (y < scalar(0)) != (value < scalar(0));
            least = crossed ? scalar(0) : std::min(least, scalar(abs(value)));
            here = over(theta, abs(value));
            if (crossed) here = std::max(here, over(at + (theta - at) * (y / (y - value)), scalar(0)));
            if (!(here <= worst)) worst = here;
            at = theta, y = value;
        }
        return worst + abs(inner_(c, i)) / (floor_ + least);
    }

    /// y and the scaled slope h y' of the returned solution at t_i + theta h.
    template <class Y>
    void evaluate(const iterate& x, int i, const scalar& theta, Y&& y, Y&& slope) const {
        const int m = nodes();
        const auto W = slopes_.middleCols(i * m, m);
        const auto values = rule_.value(theta), integrals = rule_.integral(theta);
        y = x.y.col(i);
        slope.setZero();
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
            combine(x.Z.middleCols(i * s, s), ell_, slopes_.middleCols(i * m, m));
    }

    /// The returned solution on another mesh.
    iterate on(const std::vector<scalar>& t, const iterate& x) const {
        const int L = static_cast<int>(t.size()) - 1, n = equations_.n(), s = equations_.s();
        iterate next;
        next.t = t;
        next.p = x.p;
        next.y.resize(n, L + 1);
        next.Z.resize(n, s * L);
        Eigen::Matrix<scalar, wide::RowsAtCompileTime, 1> y(n), slope(n);
        int i = 0;
        const auto at = [&](const scalar& time) {
            while (i + 1 < x.intervals() && x.t[i + 1] < time) ++i;
            evaluate(x, i, scalar((time - x.t[i]) / x.h(i)), y, slope);
        };
        for (int k = 0; k < L; ++k) {
            at(t[k]);
            next.y.col(k) = y;
            for (int j = 0; j < s; ++j) {
                at(scalar(t[k] + equations_.method().c[j] * (t[k + 1] - t[k])));
                next.Z.col(k * s + j) = slope * ((t[k + 1] - t[k]) / x.h(i));
            }
        }
        next.y.col(L) = x.y.col(x.intervals());
        return next;
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
                piece.increments().col(k).setZero();
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
    /// out = W q^T, column by column: products of Eigen's would take half the time to compile a solver.
    template <class Columns, class Out>
    static void combine(const Columns& W, const matrix& q, Out&& out) {
        for (Eigen::Index k = 0; k < q.rows(); ++k) {
            out.col(k).setZero();
            for (Eigen::Index l = 0; l < q.cols(); ++l) out.col(k) += q(k, l) * W.col(l);
        }
    }
    /// Once, and again where the interpolated Jacobians leave a defect that counts beside delta.
    bool lift(const iterate& x, int i) {
        const int m = nodes(), s = equations_.s();
        auto W = slopes_.middleCols(i * m, m);
        combine(x.Z.middleCols(i * s, s), ell_, W);
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
        U_.resize(n, m);
        combine(W, Q_, U_);
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
        next_.resize(n, m);
        scalar before(0);
        for (int k = 0; k < order_ + 4; ++k) {
            combine(g_, Q_, next_);
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
            left_over_.col(2 * i + k) = off_;
            for (int c = 0; c < n; ++c) scale_(c, 2 * i + k) = h * (floor_ + abs(f[c]));
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

    /// w less its error plus the line between those of the mesh values; and what defect that leaves.
    void straighten(const iterate& x, int i) {
        using std::abs;
        const int n = equations_.n(), m = nodes(), s = equations_.s(), np = equations_.np(), width = n + np;
        auto W = slopes_.middleCols(i * m, m);
        change_ = error_.y.col(i + 1) - error_.y.col(i);
        for (int k = 0; k < m; ++k)
            for (int j = 0; j < s; ++j) W.col(k) -= ell_(k, j) * error_.Z.col(i * s + j);
        W.colwise() += change_;
        const auto J = equations_.jacobians(i);
        for (int k = 0; k < 2; ++k) {
            stage_ = error_.y.col(i) + check_[k] * change_;
            off_ = left_over_.col(2 * i + k).cwiseAbs();
            own_.setZero(n);
            add_mass_times(equations_.mass(), scalar(1), change_.data(), own_.data(), n);
            for (int j = 0; j < s; ++j)
                own_ -= x.h(i) * check_ell_[k][j] *
                        (J.middleCols(j * width, n) * stage_ + J.middleCols(j * width + n, np) * error_.p);
            for (int c = 0; c < n; ++c)
                defect_ = std::max(defect_, scalar((off_[c] + abs(own_[c])) / scale_(c, 2 * i + k)));
        }
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
    wide slopes_, delta_, inner_, left_over_, scale_, U_, d_, g_, next_, hJ_, zero_, minus_;
    Eigen::Matrix<scalar, wide::RowsAtCompileTime, 1> stage_, own_, off_, change_;
    Eigen::Matrix<scalar, wide::RowsAtCompileTime, wide::RowsAtCompileTime> small_;
    iterate error_;
    scalar floor_{0}, defect_{0}, place_{0};
};

}  // namespace stagecraft
