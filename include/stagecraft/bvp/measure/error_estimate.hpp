// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

#include <stagecraft/bvp/equations/lifting_elimination.hpp>
#include <stagecraft/bvp/equations/lifting_rule.hpp>
#include <stagecraft/bvp/equations/on_mesh.hpp>
#include <stagecraft/bvp/judge/lifting_pass.hpp>
#include <stagecraft/bvp/measure/hidden_jumps.hpp>
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
/// hand, driven by delta and by the residuals of the conditions. The returned solution is w less this error plus the
/// line from E_i to E_{i+1}: continuous (the aim of Enright-Muir 1999), and no worse inside an interval than at its
/// ends. (w less a line that removes delta_i would be: where solutions grow by e^{|h f_y|}, delta_i is that much larger
/// than E_i and E_{i+1}.) The defect of w is measured at two points where it is large.
template <class Equations>
class error_estimate {
  public:
    using iterate = typename Equations::iterate;
    using scalar = std::decay_t<decltype(iterate{}.t[0])>;
    using wide = typename Equations::wide;
    using column = typename Equations::column;
    using state = typename Equations::state;
    using parameters = typename Equations::parameters;
    using rule = typename Equations::rule;

    /// At the `known` points, in increasing order, f may jump.
    error_estimate(Equations& equations, detail::lifting_elimination<Equations>& elimination,
                   std::vector<scalar> known = {})
        : equations_(equations),
          elimination_(elimination),
          rule_(elimination.lifting()),
          known_(std::move(known)) {}

    int nodes() const { return rule_.nodes(); }
    int order() const { return rule_.order; }

    /// False where f is not finite at one of its points (place()). Errors relative to threshold + |y| are looked at
    /// as closely as `negligible` asks for, or only once.
    bool run(const iterate& x, const scalar& threshold, const scalar& negligible, bool closely = true) {
        const int L = x.intervals(), n = equations_.n(), m = nodes();
        threshold_ = threshold, negligible_ = negligible, passes_ = closely ? 2 : 1;
        slopes_.resize(n, m * L);
        delta_.resize(n, L);
        inner_.resize(n, L);
        removed_.resize(n, L);
        left_over_.resize(n, 2 * L);
        scale_.resize(n, 2 * L);
        d_.resize(n, m), g_.resize(n, m), moved_.resize(m);
        stage_.resize(n), own_.resize(n), off_.resize(n), most_.resize(n), small_.resize(n, n);
        swaps_.resize(static_cast<std::size_t>(n));
        marks_.assign(static_cast<std::size_t>(L), 0);
        elimination_.begin(x);
        const bool usual = elimination_.usual();
        for (int i = 0; i < L; ++i)
            if (!(usual ? lift<usual_nodes>(x, i) : lift<0>(x, i))) return false;
        if (equations_.mass().identity())
            detail::add_hidden_jumps(rule_, equations_, x, known_, slopes_, left_over_, delta_, marks_);
        jumps_ = detail::find_jumps(rule_, equations_, x, slopes_, inner_,
                                    scalar(negligible * threshold / 10), unseen_, marks_);
        solve(x);
        for (int i = 0; i < L; ++i) usual ? straighten<usual_nodes>(x, i) : straighten<0>(x, i);
        return true;
    }

    const scalar& place() const { return place_; }
    /// Local errors of the mesh values in component c of interval i.
    scalar local(int c, int i) const {
        using std::abs;
        return abs(delta_(c, i)) + unseen_(c, i);
    }
    const wide& inner() const { return inner_; }  ///< local errors between them
    const wide& removed() const {
        return removed_;
    }  ///< max |e|: errors between them that lifting has removed
    /// The global error of y_c at mesh point i, and of the parameters.
    scalar global(int c, int i) const {
        using std::abs;
        return abs(error_.y(c, i)) + by_jumps(c, i);
    }
    auto of_parameters() const {
        parameters all = error_.p.cwiseAbs();
        if (jumps_) all += by_jumps_.p.cwiseAbs();
        return all;
    }
    /// For every interval, does f seem to jump in it or at its ends?
    const std::vector<char>& jumps() const { return marks_; }
    /// Was the last estimate made on a mesh of so many intervals?
    bool knows(int intervals) const { return delta_.cols() == intervals; }
    /// The largest error of the global one and the local one in interval i, component c.
    scalar bound(int i, int c) const {
        using std::abs;
        const scalar l = global(c, i), r = global(c, i + 1);
        return (l > r ? l : r) + abs(inner_(c, i));
    }
    /// The largest of |error| / (threshold + |y|) there: the line between the global errors, and the local error, which is
    /// zero at both ends (so that it costs nothing where y is zero at a mesh point), beside y at the ends and nodes,
    /// y being taken as straight from one to the next.
    scalar relative(const iterate& x, int i, int c) const {
        using std::abs;
        const auto& method = equations_.method();
        const int s = equations_.s();
        const scalar inside = abs(inner_(c, i)),
                     steep = scalar(2 * nodes() * nodes());  // that of the integral of P_m
        const auto over = [&](const scalar& theta, const scalar& size) {
            const scalar line = abs((1 - theta) * error_.y(c, i) + theta * error_.y(c, i + 1)) +
                                (1 - theta) * by_jumps(c, i) + theta * by_jumps(c, i + 1);
            const scalar local = inside * std::min(scalar(1), scalar(steep * theta * (1 - theta)));
            return scalar((line + local) / (threshold_ + size));
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

    /// The largest |y' - f(t, y)| / (threshold + |f|) of the returned solution, at the two points of every interval.
    scalar defect(const iterate& x) const {
        using std::abs;
        const int n = equations_.n(), s = equations_.s(), np = equations_.np(), width = n + np;
        state change(n), value(n), own(n);
        scalar worst(0);
        for (int i = 0; i < x.intervals(); ++i) {
            change = error_.y.col(i + 1) - error_.y.col(i);
            const auto J = equations_.jacobians(i);
            for (const auto& at : rule_.check) {
                const int k = 2 * i + static_cast<int>(&at - rule_.check);
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

    /// From here on the returned solution means the collocation polynomial. Where the errors are not small, it is a better
    /// start for the next mesh than the corrected solution.
    void unlift(const iterate& x) {
        slopes_.resize(equations_.n(), nodes() * x.intervals()), moved_.resize(nodes());
        for (int i = 0; i < x.intervals(); ++i) collocation_slopes<0>(x, x, i, &slopes_(0, i * nodes()));
    }

    /// The returned solution on another mesh.
    iterate on(const std::vector<scalar>& t, const iterate& x) const {
        const auto& c = equations_.method().c;
        return elimination_.usual() ? detail::on_mesh<usual_nodes>(rule_, c, slopes_, x, t)
                                    : detail::on_mesh<0>(rule_, c, slopes_, x, t);
    }

    /// The returned solution as an object of its own.
    template <class Vector>
    void write(const iterate& x, solution<Vector>& out) const {
        const int m = nodes(), n = equations_.n();
        out.start(x.t.front(), x.y.col(0), x.t.back());
        out.reserve(x.intervals(), m);
        for (int i = 0; i < x.intervals(); ++i) {
            scalar* numbers = out.add(x.t[i], x.h(i), x.t[i + 1], rule_.of_pieces);
            std::copy_n(&x.y(0, i), n, numbers);
            for (int k = 0; k < m; ++k)
                detail::combine<N>(rule_.integrals.data() + k * m, m, &slopes_(0, i * m), n, numbers += n, n);
        }
    }

  private:
    static constexpr int N = wide::RowsAtCompileTime, NN = N > 0 ? N *N : N,
                         S = Equations::stages > 0 ? Equations::stages : 0,
                         usual_nodes = detail::lifting_elimination<Equations>::usual_nodes;

    template <int Nodes>
    int nodes_of() const {
        return Nodes > 0 ? Nodes : nodes();
    }

    /// The slopes, times h, of the polynomial of y (the solution's or the error's) at the nodes of interval i.
    template <int Nodes>
    void collocation_slopes(const iterate& x, const iterate& y, int i, scalar* out) {
        const int n = equations_.n(), m = nodes_of<Nodes>(), M = equations_.positions(),
                  s = S > 0 ? S : equations_.s();
        const scalar *Z = &y.Z(0, i * s), h = x.h(i);
        for (int k = 0; k < m; ++k)
            detail::combine<N, S>(rule_.lagrange.data() + k * s, s, Z, n, out + k * n, n);
        for (int c = 0; c < M; ++c) {
            detail::transform<Nodes, S>(m, s, rule_.lagrange_integrals_of.data(), Z + c + M, n,
                                        moved_.data());
            for (int k = 0; k < m; ++k) out[k * n + c] = h * (y.y(c + M, i) + moved_[k]);
        }
    }

    /// Once, and again where the interpolated Jacobians leave a defect that counts (judge/lifting_pass.hpp).
    template <int Nodes>
    bool lift(const iterate& x, int i) {
        using std::abs;
        const int m = nodes_of<Nodes>(), n = equations_.n();
        scalar *W = &slopes_(0, i * m), *delta = &delta_(0, i);
        collocation_slopes<Nodes>(x, x, i, W);
        for (int c = 0; c < n; ++c) removed_(c, i) = scalar(0);
        for (int pass = 0; pass < passes_; ++pass) {
            if (!defects<Nodes>(x, i)) return false;
            if (elimination_.small() || !elimination_.template sweep<Nodes>(i, x.h(i), d_, g_))
                elimination_.template solve<Nodes>(i, x.h(i), d_, g_);
            find_removed<Nodes>(i);
            for (int k = 0; k < n * m; ++k) W[k] -= g_.data()[k];
            detail::combine<N, Nodes>(rule_.gauss.b.data(), m, W, n, delta, n);
            scalar jump(0);
            for (int c = 0; c < n; ++c) {
                delta[c] += x.y(c, i) - x.y(c, i + 1);
                if (abs(delta[c]) > jump) jump = abs(delta[c]);
            }
            if (!check<Nodes>(x, i)) return false;
            bool counts = false;
            for (int c = 0; c < n; ++c)
                counts |= detail::lifts_again(
                    inner_(c, i), jump, scalar(threshold_ + std::min(abs(x.y(c, i)), abs(x.y(c, i + 1)))),
                    negligible_);
            if (!counts) break;
        }
        return true;
    }

    /// stage_ := y at the point of interval i to which the slopes W are integrated with these weights.
    template <int Nodes>
    void set_stage(const iterate& x, int i, const scalar* weights, const scalar* W) {
        const int n = equations_.n();
        detail::combine<N, Nodes>(weights, nodes(), W, n, stage_.data(), n);
        for (int c = 0; c < n; ++c) stage_[c] += x.y(c, i);
    }

    /// d = M w' - f(t, w), scaled by h, at the nodes; q' = v holds but for rounding errors.
    template <int Nodes>
    bool defects(const iterate& x, int i) {
        const int n = equations_.n(), m = nodes_of<Nodes>();
        const scalar h = x.h(i), *W = &slopes_(0, i * m);
        for (int k = 0; k < m; ++k) {
            set_stage<Nodes>(x, i, rule_.integrals.data() + k * m, W);
            const scalar t = x.t[i] + rule_.gauss.c[k] * h;
            const auto& f = equations_.system().f(t, stage_, x.p);
            if (!all_finite(f, n)) return fail_at(t);
            scalar* d = &d_(0, k);
            equations_.demand_second_order(f, stage_);
            for (int c = 0; c < n; ++c) d[c] = -h * f[c];
            add_mass_times(equations_.mass(), scalar(1), W + k * n, d, n);
            for (int c = 0; c < equations_.positions(); ++c) d[c] = scalar(0);
        }
        return true;
    }

    /// The largest integrals of g at the nodes: the error that lifting removes.
    template <int Nodes>
    void find_removed(int i) {
        using std::abs;
        const int n = equations_.n(), m = nodes_of<Nodes>();
        scalar* removed = &removed_(0, i);
        for (int c = 0; c < n; ++c) most_[c] = removed[c];
        for (int k = 0; k < m; ++k) {
            detail::combine<N, Nodes>(rule_.integrals.data() + k * m, m, g_.data(), n, own_.data(), n);
            for (int c = 0; c < n; ++c) most_[c] = std::max(most_[c], scalar(abs(own_[c])));
        }
        for (int c = 0; c < n; ++c) removed[c] = most_[c];
    }

    /// The defect of w off its nodes, as local error: (I - r h f_y)^-1 r h d, r being the reach of the point.
    template <int Nodes>
    bool check(const iterate& x, int i) {
        using std::abs;
        const int n = equations_.n(), m = nodes_of<Nodes>(), s = equations_.s(), width = n + equations_.np();
        const scalar h = x.h(i), *W = &slopes_(0, i * m);
        for (int c = 0; c < n; ++c) inner_(c, i) = scalar(0);
        for (int k = 0; k < 2; ++k) {
            const auto& at = rule_.check[k];
            set_stage<Nodes>(x, i, at.integral.data(), W);
            const scalar t = x.t[i] + at.theta * h;
            const auto& f = equations_.system().f(t, stage_, x.p);
            if (!all_finite(f, n)) return fail_at(t);
            detail::combine<N, Nodes>(at.value.data(), m, W, n, own_.data(), n);
            for (int c = 0; c < n; ++c) {
                off_[c] = -h * f[c];
                scale_(c, 2 * i + k) = h * (threshold_ + abs(f[c]));
            }
            add_mass_times(equations_.mass(), scalar(1), own_.data(), off_.data(), n);
            scalar largest(0);
            for (int c = 0; c < n; ++c) {
                left_over_(c, 2 * i + k) = off_[c];
                largest = std::max(largest, scalar(abs(off_[c])));
            }
            if (largest > negligible_ * threshold_ / 1000) {
                detail::combine<NN, S>(at.lagrange.data(), s, equations_.jacobians(i).data(), width * n,
                                       small_.data(), n * n);
                for (int l = 0; l < n * n; ++l) small_.data()[l] *= -at.reach * h;
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
        row_elimination::factor(small_, n, static_cast<scalar*>(nullptr), swaps_.data());
        row_elimination::apply(small_, n, static_cast<scalar*>(nullptr), swaps_.data(), off_.data());
        for (int k = n - 1; k >= 0; --k) {
            for (int j = k + 1; j < n; ++j) off_[k] -= small_(k, j) * off_[j];
            off_[k] /= small_(k, k);
        }
    }

    void solve(const iterate& x) {
        const int L = x.intervals();
        minus_ = -delta_;
        ends_ = equations_.system()
                    .conditions(x.y.col(0), x.y.col(L), x.p)
                    .head(equations_.n() + equations_.np());
        equations_.solve(x, minus_, ends_, error_);
        // Apart from the others: these have a sign, and what they make of y joins its pieces.
        if (jumps_) equations_.solve_mesh_values(unseen_, column::Zero(ends_.size()), by_jumps_);
    }
    scalar by_jumps(int c, int i) const {
        using std::abs;
        return jumps_ ? scalar(abs(by_jumps_.y(c, i))) : scalar(0);
    }

    /// w less its error plus the line between those of the mesh values.
    template <int Nodes>
    void straighten(const iterate& x, int i) {
        const int m = nodes_of<Nodes>(), n = equations_.n();
        scalar *W = &slopes_(0, i * m), *own = g_.data();
        collocation_slopes<Nodes>(x, error_, i, own);
        for (int c = 0; c < n; ++c) {
            const scalar change = error_.y(c, i + 1) - error_.y(c, i);
            for (int k = 0; k < m; ++k) W[k * n + c] += change - own[k * n + c];
        }
    }

    bool fail_at(const scalar& t) {
        place_ = t;
        return false;
    }

    Equations& equations_;
    detail::lifting_elimination<Equations>& elimination_;
    const rule& rule_;
    std::vector<scalar> known_;
    std::vector<int> swaps_;
    std::vector<char> marks_;
    wide slopes_, delta_, inner_, removed_, unseen_, left_over_, scale_, d_, g_, minus_;
    state stage_, own_, off_, most_;
    Eigen::Matrix<scalar, N, N> small_;
    Eigen::Matrix<scalar, Eigen::Dynamic, 1> moved_;
    column ends_;
    iterate error_, by_jumps_;
    scalar threshold_{0}, negligible_{0}, place_{0};
    int passes_ = 2;
    bool jumps_ = false;
};

}  // namespace stagecraft
