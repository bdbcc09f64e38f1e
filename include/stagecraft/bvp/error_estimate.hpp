// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <memory>
#include <type_traits>
#include <vector>

#include <stagecraft/bvp/hidden_jumps.hpp>
#include <stagecraft/bvp/lifting_elimination.hpp>
#include <stagecraft/bvp/lifting_rule.hpp>
#include <stagecraft/linear/almost_block_diagonal.hpp>
#include <stagecraft/observe/solution.hpp>

namespace stagecraft {

/// Lifts a collocation solution of order p at the mesh points to order min(p, s + 3) everywhere, and says how wrong
/// it is. On every interval the equation e' = f_y e + d for the error of the collocation polynomial u, d = u'
/// - f(t, u), is solved from e = 0 by Gauss collocation with m nodes, at most s + 3, where f_y is the
/// polynomial through the Jacobians of Newton's iteration: no new Jacobians, m evaluations of f. Then
///
///     w = u - e                             solves the equation through y_i to order m + 1,
///     delta_i = w(t_{i+1}) - y_{i+1}        is the local error of the mesh values,
///
/// and the global error E of the mesh values, with its slopes between them, is one more solve with the factors at
/// hand, driven by delta and by what is left of the conditions. The returned solution is w less this error plus the
/// line from E_i to E_{i+1}: continuous (the aim of Enright-Muir 1999), and no worse inside an interval than at its
/// ends. (w less a line that removes delta_i would be: where solutions grow by e^{|h f_y|}, delta_i is that much larger
/// than E_i and E_{i+1}.) What is left of the defect of w is measured at two points where it is large.
template <class Equations>
class error_estimate {
  public:
    using iterate = typename Equations::iterate;
    using scalar = std::decay_t<decltype(iterate{}.t[0])>;
    using wide = typename Equations::wide;
    using column = typename Equations::column;
    using matrix = typename Equations::matrix;
    using rule = typename Equations::rule;

    /// At the `known` points, in increasing order, f may jump.
    error_estimate(Equations& equations, std::shared_ptr<const rule> r, std::vector<scalar> known = {})
        : equations_(equations), rule_(std::move(r)), known_(std::move(known)) {}

    int nodes() const { return rule_->nodes(); }
    int order() const { return rule_->order; }

    /// False where f is not finite at one of its points (place()). Errors relative to floor + |y| are looked at
    /// as closely as `negligible` asks for, or only once.
    bool run(const iterate& x, const scalar& floor, const scalar& negligible, bool closely = true) {
        const int L = x.intervals(), n = equations_.n(), m = nodes();
        floor_ = floor, negligible_ = negligible, passes_ = closely ? 2 : 1;
        slopes_.resize(n, m * L);
        delta_.resize(n, L);
        inner_.resize(n, L);
        raised_.resize(n, L);
        left_over_.resize(n, 2 * L);
        scale_.resize(n, 2 * L);
        d_.resize(n, m), g_.resize(n, m), hJ_.resize(n, n * m);
        const bool usual = nodes() == usual_nodes;
        for (int i = 0; i < L; ++i)
            if (!(usual ? lift<usual_nodes>(x, i) : lift<0>(x, i))) return false;
        if constexpr (std::decay_t<decltype(equations_.mass())>::identity)
            detail::add_hidden_jumps(*rule_, equations_, x, known_, slopes_, left_over_, delta_);
        solve(x);
        for (int i = 0; i < L; ++i) straighten(x, i);
        return true;
    }

    const scalar& place() const { return place_; }
    const wide& local() const { return delta_; }      ///< local errors of the mesh values
    const wide& inner() const { return inner_; }      ///< local errors between them
    const wide& raised() const { return raised_; }    ///< what the lifting has removed between them: max |e|
    const iterate& global() const { return error_; }  ///< of mesh values and parameters
    /// The largest error of the global one and the local one in interval i, component c.
    scalar bound(int i, int c) const {
        using std::abs;
        const scalar l = abs(error_.y(c, i)), r = abs(error_.y(c, i + 1));
        return (l > r ? l : r) + abs(inner_(c, i));
    }
    /// The largest of |error| / (floor + |y|) there: the line between the global errors, and the local error, which is
    /// zero at both ends (so that it costs nothing where y is zero at a mesh point), beside y at the ends and nodes,
    /// y being taken as straight from one to the next.
    scalar relative(const iterate& x, int i, int c) const {
        using std::abs;
        const auto& method = equations_.method();
        const int s = equations_.s();
        const scalar inside = abs(inner_(c, i)),
                     steep = scalar(2 * nodes() * nodes());  // that of the integral of P_m
        const auto over = [&](const scalar& theta, const scalar& size) {
            const scalar line = abs((1 - theta) * error_.y(c, i) + theta * error_.y(c, i + 1));
            const scalar local = inside * std::min(scalar(1), scalar(steep * theta * (1 - theta)));
            return scalar((line + local) / (floor_ + size));
        };
        scalar at(0), y = x.y(c, i), worst = over(at, abs(y));
        for (int j = 0; j <= s; ++j) {
            const scalar theta = j < s ? method.c[j] : scalar(1);
            scalar value = x.y(c, j < s ? i : i + 1), here;
            if (j < s)
                for (int k = 0; k < s; ++k) value += method.A(j, k) * x.Z(c, i * s + k);
            here = over(theta, abs(value));
            if ((y < scalar(0)) != (value < scalar(0)))
                here = std::max(here, over(at + (theta - at) * (y / (y - value)), scalar(0)));
            if (!(here <= worst)) worst = here;
            at = theta, y = value;
        }
        return worst;
    }

    /// The largest |y' - f(t, y)| / (floor + |f|) of the returned solution, at the two points of every interval.
    scalar defect(const iterate& x) const {
        using std::abs;
        const int n = equations_.n(), s = equations_.s(), np = equations_.np(), width = n + np;
        column change(n), value(n), own(n);
        scalar worst(0);
        for (int i = 0; i < x.intervals(); ++i) {
            change = error_.y.col(i + 1) - error_.y.col(i);
            const auto J = equations_.jacobians(i);
            for (const auto& at : rule_->check) {
                const int k = 2 * i + static_cast<int>(&at - rule_->check);
                value = error_.y.col(i) + at.theta * change;
                own.setZero();
                add_mass_times(equations_.mass(), scalar(1), change.data(), own.data(), n);
                for (int j = 0; j < s; ++j)
                    for (int d = 0; d < width; ++d) {
                        const scalar by = x.h(i) * at.lagrange[j] * (d < n ? value[d] : error_.p[d - n]);
                        for (int c = 0; c < n; ++c) own[c] -= by * J(c, j * width + d);
                    }
                for (int c = 0; c < n; ++c)
                    worst = std::max(worst, scalar((abs(left_over_(c, k)) + abs(own[c])) / scale_(c, k)));
            }
        }
        return worst;
    }

    /// From here on the returned solution means the collocation polynomial: where the errors are no longer small,
    /// what was to correct them is a worse start for the next mesh than nothing.
    void unlift(const iterate& x) {
        for (int i = 0; i < x.intervals(); ++i) collocation_slopes<0>(x, i);
    }

    /// The returned solution on another mesh.
    iterate on(const std::vector<scalar>& t, const iterate& x) const {
        const int L = static_cast<int>(t.size()) - 1, n = equations_.n(), s = equations_.s(), m = nodes();
        iterate next;
        next.t = t;
        next.p = x.p;
        next.y.resize(n, L + 1);
        next.Z.resize(n, s * L);
        wide coefficients(n, m);
        column P(m + 1);
        int i = 0, known = -1;
        const auto go_to = [&](const scalar& time) {
            while (i + 1 < x.intervals() && x.t[i + 1] < time) ++i;
            for (int k = 0; k < m && i != known; ++k)
                detail::combine<N>(rule_->to_coefficients.row(k).data(), m, &slopes_(0, i * m), n,
                                   &coefficients(0, k), n);
            known = i;
            legendre_values(scalar((time - x.t[i]) / x.h(i)), m, P.data());
        };
        for (int k = 0; k < L; ++k) {
            go_to(t[k]);
            next.y.col(k) = x.y.col(i) + (P[0] + P[1]) / 2 * coefficients.col(0);  // P_0 + P_1 = 2 theta
            for (int l = 1; l < m; ++l)
                next.y.col(k) += (P[l + 1] - P[l - 1]) / scalar(2 * (2 * l + 1)) * coefficients.col(l);
            for (int j = 0; j < s; ++j) {
                go_to(scalar(t[k] + equations_.method().c[j] * (t[k + 1] - t[k])));
                auto Z = next.Z.col(k * s + j);
                detail::combine<N>(P.data(), m, coefficients.data(), n, Z.data(), n);
                Z *= (t[k + 1] - t[k]) / x.h(i);
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
        for (int k = 0; k < m; ++k) at.c[k] = rule_->gauss.c[k];
        at.finish();
        dense_output<Vector, dynamic> piece(n, m);
        out.start(x.t.front(), x.y.col(0), x.t.back());
        for (int i = 0; i < x.intervals(); ++i) {
            piece.cover(at, x.t[i], x.h(i), Vector(x.y.col(i)));
            for (int k = 0; k < m; ++k)
                detail::combine<N>(rule_->integrals.row(k).data(), m, &slopes_(0, i * m), n,
                                   piece.increments().col(k).data(), n);
            out(x.t[i + 1], Vector(x.y.col(i + 1)), x.h(i), piece);
        }
    }

  private:
    static constexpr int N = wide::RowsAtCompileTime, NN = N > 0 ? N *N : N, M = Equations::positions,
                         S = Equations::stages > 0 ? Equations::stages : 0;
    /// The number of nodes of most rules, for which the loops are compiled with it; 0 where s is known at run time alone.
    static constexpr int usual_nodes = S > 0 ? S + 2 : 0;
    using vector = Eigen::Matrix<scalar, N, 1>;

    template <int Nodes>
    int nodes_of() const {
        return Nodes > 0 ? Nodes : nodes();
    }

    template <int Nodes>
    void collocation_slopes(const iterate& x, int i) {
        const int n = equations_.n(), m = nodes_of<Nodes>();
        for (int k = 0; k < m; ++k) slopes_at(x, x, i, k, &slopes_(0, i * m + k), n);
    }

    /// The slopes, times h, of the polynomials of y (the solution's or the error's) at node k of interval i.
    void slopes_at(const iterate& x, const iterate& y, int i, int k, scalar* out, int n) const {
        const int s = S > 0 ? S : equations_.s();
        const scalar* Z = &y.Z(0, i * s);
        detail::combine<N, S>(rule_->lagrange.data() + k * s, s, Z, n, out, n);
        const scalar* integrals = rule_->lagrange_integrals.data() + k * s;
        for (int c = 0; c < M; ++c) {
            scalar v = y.y(c + M, i);
            for (int j = 0; j < s; ++j) v += integrals[j] * Z[j * n + c + M];
            out[c] = x.h(i) * v;
        }
    }

    /// Once, and again where the interpolated Jacobians leave a defect that counts beside delta and the tolerance.
    template <int Nodes>
    bool lift(const iterate& x, int i) {
        using std::abs;
        const int m = nodes_of<Nodes>(), n = equations_.n();
        collocation_slopes<Nodes>(x, i);
        interpolate_jacobians<Nodes>(i, x.h(i));
        raised_.col(i).setZero();
        for (int pass = 0; pass < passes_; ++pass) {
            if (!defects<Nodes>(x, i)) return false;
            // Elimination costs less than sweeps as long as it has about 16 unknowns.
            const bool small = (n - M) * m <= 16;
            if (small || !elimination_.template sweep<Nodes>(*rule_, equations_.mass(), hJ_, d_, g_))
                eliminate<Nodes>(x.h(i), small && pass > 0);
            raise<Nodes>(i);
            for (int k = 0; k < n * m; ++k) slopes_.data()[n * m * i + k] -= g_.data()[k];
            detail::combine<N, Nodes>(rule_->gauss.b.data(), m, &slopes_(0, i * m), n, &delta_(0, i), n);
            delta_.col(i) += x.y.col(i) - x.y.col(i + 1);
            if (!check<Nodes>(x, i)) return false;
            bool counts = false;
            const scalar jump = delta_.col(i).cwiseAbs().maxCoeff();
            for (int c = 0; c < n; ++c)
                counts |=
                    inner_(c, i) > negligible_ * (floor_ + std::min(abs(x.y(c, i)), abs(x.y(c, i + 1)))) &&
                    20 * inner_(c, i) > jump;
            if (!counts) break;
        }
        return true;
    }

    /// d = M w' - f(t, w), scaled by h, at the nodes.
    template <int Nodes>
    bool defects(const iterate& x, int i) {
        const int n = equations_.n(), m = nodes_of<Nodes>();
        const scalar h = x.h(i);
        const scalar* W = &slopes_(0, i * m);
        stage_.resize(n);
        for (int k = 0; k < m; ++k) {
            detail::combine<N, Nodes>(rule_->integrals.data() + k * m, m, W, n, stage_.data(), n);
            stage_ += x.y.col(i);
            const scalar t = x.t[i] + rule_->gauss.c[k] * h;
            const auto& f = equations_.system().f(t, stage_, x.p);
            if (!all_finite(f, n)) return fail_at(t);
            for (int c = 0; c < n; ++c) d_(c, k) = -h * f[c];
            add_mass_times(equations_.mass(), scalar(1), W + k * n, d_.col(k).data(), n);
        }
        return true;
    }

    /// h f_y at the Gauss nodes, side by side.
    template <int Nodes>
    void interpolate_jacobians(int i, const scalar& h) {
        const int n = equations_.n(), m = nodes_of<Nodes>(), s = equations_.s(), width = n + equations_.np();
        const auto J = equations_.jacobians(i);
        for (int k = 0; k < m; ++k) {
            detail::combine<NN, S>(rule_->lagrange.data() + k * s, s, J.data(), width * n, &hJ_(0, k * n),
                                   n * n);
            for (int l = 0; l < n * n; ++l) hJ_.data()[k * n * n + l] *= h;
        }
    }

    template <int Nodes>
    void eliminate(const scalar& h, bool again) {
        if (again)
            elimination_.template solve_again<Nodes>(*rule_, h, hJ_, d_, g_);
        else
            elimination_.template solve<Nodes>(*rule_, equations_.mass(), h, hJ_, d_, g_);
    }

    /// The largest integrals of g at the nodes: what the lifting removes.
    template <int Nodes>
    void raise(int i) {
        using std::abs;
        const int n = equations_.n(), m = nodes_of<Nodes>();
        own_.resize(n);
        most_.setZero(n);
        for (int k = 0; k < m; ++k) {
            detail::combine<N, Nodes>(rule_->integrals.data() + k * m, m, g_.data(), n, own_.data(), n);
            for (int c = 0; c < n; ++c)
                if (abs(own_[c]) > most_[c]) most_[c] = abs(own_[c]);
        }
        raised_.col(i) = raised_.col(i).cwiseMax(most_);
    }

    /// The defect of w off its nodes, as local error: (I - r h f_y)^-1 r h d, r being the reach of the point.
    template <int Nodes>
    bool check(const iterate& x, int i) {
        using std::abs;
        const int n = equations_.n(), m = nodes_of<Nodes>(), s = equations_.s(), width = n + equations_.np();
        const scalar h = x.h(i);
        const scalar* W = &slopes_(0, i * m);
        stage_.resize(n), own_.resize(n), off_.resize(n), small_.resize(n, n);
        inner_.col(i).setZero();
        for (int k = 0; k < 2; ++k) {
            const auto& at = rule_->check[k];
            detail::combine<N, Nodes>(at.integral.data(), m, W, n, stage_.data(), n);
            stage_ += x.y.col(i);
            const scalar t = x.t[i] + at.theta * h;
            const auto& f = equations_.system().f(t, stage_, x.p);
            if (!all_finite(f, n)) return fail_at(t);
            detail::combine<N, Nodes>(at.value.data(), m, W, n, own_.data(), n);
            for (int c = 0; c < n; ++c) {
                off_[c] = -h * f[c];
                scale_(c, 2 * i + k) = h * (floor_ + abs(f[c]));
            }
            add_mass_times(equations_.mass(), scalar(1), own_.data(), off_.data(), n);
            left_over_.col(2 * i + k) = off_;
            if (off_.cwiseAbs().maxCoeff() > negligible_ * floor_ / 1000) {
                detail::combine<NN, S>(at.lagrange.data(), s, equations_.jacobians(i).data(), width * n,
                                       small_.data(), n * n);
                small_ *= -at.reach * h;
                add_mass(equations_.mass(), scalar(1), small_.data(), n);
                solve_small();
            }
            for (int c = 0; c < n; ++c)
                if (at.reach * abs(off_[c]) > inner_(c, i)) inner_(c, i) = at.reach * abs(off_[c]);
        }
        return true;
    }

    /// off = small^-1 off.
    void solve_small() {
        const int n = equations_.n();
        swaps_.resize(static_cast<std::size_t>(n));
        row_elimination::factor(small_, n, static_cast<scalar*>(nullptr), swaps_.data());
        row_elimination::apply(small_, n, static_cast<scalar*>(nullptr), swaps_.data(), off_.data());
        for (int k = n - 1; k >= 0; --k) {
            for (int j = k + 1; j < n; ++j) off_[k] -= small_(k, j) * off_[j];
            off_[k] /= small_(k, k);
        }
    }

    void solve(const iterate& x) {
        const int L = x.intervals();
        zero_.setZero(equations_.n(), equations_.s() * L);
        minus_ = -delta_;
        ends_ = equations_.system()
                    .conditions(x.y.col(0), x.y.col(L), x.p)
                    .head(equations_.n() + equations_.np());
        equations_.solve(x, zero_, minus_, ends_, error_);
    }

    /// w less its error plus the line between those of the mesh values.
    void straighten(const iterate& x, int i) {
        const int m = nodes();
        own_.resize(equations_.n());
        off_ = error_.y.col(i + 1) - error_.y.col(i);
        for (int k = 0; k < m; ++k) {
            slopes_at(x, error_, i, k, own_.data(), equations_.n());
            slopes_.col(i * m + k) += off_ - own_;
        }
    }

    bool fail_at(const scalar& t) {
        place_ = t;
        return false;
    }

    Equations& equations_;
    std::shared_ptr<const rule> rule_;
    std::vector<scalar> known_;
    std::vector<int> swaps_;
    wide slopes_, delta_, inner_, raised_, left_over_, scale_, d_, g_, hJ_, zero_, minus_;
    vector stage_, own_, off_, most_;
    Eigen::Matrix<scalar, N, N> small_;
    detail::lifting_elimination<scalar, N, M> elimination_;
    column ends_;
    iterate error_;
    scalar floor_{0}, negligible_{0}, place_{0};
    int passes_ = 2;
};

}  // namespace stagecraft
