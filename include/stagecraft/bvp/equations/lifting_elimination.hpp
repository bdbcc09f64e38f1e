// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/bvp/equations/lifting_rule.hpp>
#include <stagecraft/linear/row_panel.hpp>

namespace stagecraft::detail {

/// M g = d + h f_y (integral of g) on one interval, at the Gauss nodes of a lifting rule, f_y being the polynomial through the
/// Jacobians that the equations hold: by dense elimination, or by sweeps. With M positions q' = v known, g_q = d_q +
/// h (integral of g_v), and the other components are all that is eliminated. Factors of few unknowns are kept for every
/// interval for as long as the Jacobians stay what they are. Nodes is the number of nodes where it is known at compile time,
/// or 0.
template <class Equations>
class lifting_elimination {
    using iterate = typename Equations::iterate;
    using scalar = std::decay_t<decltype(iterate{}.t[0])>;
    static constexpr int N = Equations::wide::RowsAtCompileTime, NN = N > 0 ? N *N : N,
                         S = Equations::stages > 0 ? Equations::stages : 0;

  public:
    using rule = typename Equations::rule;
    /// The number of nodes of most rules, for which the loops are compiled with it; 0 where s is known at run time alone.
    static constexpr int usual_nodes = S > 0 ? S + 2 : 0;

    lifting_elimination(const Equations& equations, std::shared_ptr<const rule> r)
        : equations_(equations), rule_(std::move(r)) {}

    const rule& lifting() const { return *rule_; }
    const std::shared_ptr<const rule>& shared_lifting() const { return rule_; }
    bool usual() const { return rule_->nodes() == usual_nodes; }
    /// Elimination costs less than sweeps as long as it has about 16 unknowns.
    bool small() const { return unknowns<0>() <= 16; }

    /// To be called before the intervals of a mesh are looked at: takes room for them, and forgets the factors of Jacobians
    /// that the equations no longer hold.
    void begin(const iterate& x) {
        const int size = unknowns<0>(), n = equations_.n(), m = rule_->nodes();
        if (version_ == equations_.version()) return;
        version_ = equations_.version();
        kept_ = small() ? x.intervals() : 1;
        panel_size_ = row_panel<scalar, 0, 0, 0>(size, size + 1, size).size();
        const Eigen::Index all = kept_;
        hJ_.resize(all * (n * n * m)), panels_.resize(all * panel_size_),
            from_.resize(static_cast<std::size_t>(all * size));
        interpolated_.assign(static_cast<std::size_t>(all), -1),
            factored_.assign(static_cast<std::size_t>(all), -1);
        x_.resize(size), moved_.resize((positions() + 1) * m);
        own_.resize(n), change_.resize(n);
    }

    /// h f_y at the nodes of interval i, n x n each, side by side.
    template <int Nodes>
    const scalar* jacobians(int i, const scalar& h) {
        const int n = equations_.n(), m = nodes<Nodes>(), s = equations_.s(), k = slot(i);
        scalar* hJ = hJ_.data() + static_cast<std::size_t>(k) * (n * n * m);
        if (std::exchange(interpolated_[k], i) == i) return hJ;
        const scalar* J = equations_.jacobians(i).data();
        for (int l = 0; l < m; ++l)
            combine<NN, S>(rule_->lagrange.data() + l * s, s, J, (n + equations_.np()) * n, hJ + l * n * n,
                           n * n);
        for (int l = 0; l < m * n * n; ++l) hJ[l] *= h;
        return hJ;
    }

    /// g from d, both n x m.
    template <int Nodes, class Columns>
    void solve(int i, const scalar& h, const Columns& d, Columns& g) {
        const scalar* hJ = jacobians<Nodes>(i, h);
        on_panel<Nodes>([&](const auto& p) { eliminate<Nodes>(p, i, h, hJ, d); });
        take<Nodes>(h, d, g);
    }

    /// The same by sweeps from node to node, which cost least where h f_y is moderate; false where they do not contract, and
    /// with a mass matrix.
    template <int Nodes, class Columns>
    bool sweep(int i, const scalar& h, const Columns& d, Columns& g) {
        using std::abs;
        if (!equations_.mass().identity()) return false;
        const int n = equations_.n(), m = nodes<Nodes>();
        const scalar* hJ = jacobians<Nodes>(i, h);
        g = d;
        scalar before(0);
        for (int k = 0; k < rule_->order + 4; ++k) {
            scalar change(0), size(0);
            for (int j = 0; j < m; ++j) {
                combine<N, Nodes>(rule_->integrals.data() + j * m, m, g.data(), n, own_.data(), n);
                combine<N>(own_.data(), n, hJ + j * n * n, n, change_.data(), n);
                for (int c = 0; c < n; ++c) {
                    const scalar value = d(c, j) + change_[c], move = abs(value - g(c, j));
                    if (move > change) change = move;
                    if (abs(value) > size) size = abs(value);
                    g(c, j) = value;
                }
            }
            if (change <= scalar(1) / 100000 * size) return true;
            if (k > 2 && !(change < before / 2)) return false;
            before = change;
        }
        return false;
    }

  private:
    template <int Nodes>
    int nodes() const {
        return Nodes > 0 ? Nodes : rule_->nodes();
    }
    template <int Nodes>
    int unknowns() const {
        return (equations_.n() - positions()) * nodes<Nodes>();
    }
    int positions() const { return equations_.positions(); }
    /// act(panel) with the sizes of the panel known at compile time where it is small; larger ones gain nothing by it.
    template <int Nodes, int M = 0, class Act>
    void on_panel(const Act& act) const {
        if constexpr (Nodes > 0 && 0 < N && 2 * M <= N) {
            constexpr int all = (N - M) * Nodes;
            if (positions() != M) return on_panel<Nodes, M + 1>(act);
            if constexpr (all <= 16) return act(row_panel<scalar, all, all + 1, all>(all, all + 1, all));
        }
        const int size = unknowns<Nodes>();
        act(row_panel<scalar, 0, 0, 0>(size, size + 1, size));
    }
    /// Where the factors of interval i are kept.
    int slot(int i) const { return kept_ > 1 ? i : 0; }

    /// The components of g that are eliminated, in x: with the factors of interval i, or with new ones.
    template <int Nodes, class Panel, class Columns>
    void eliminate(const Panel& p, int i, const scalar& h, const scalar* hJ, const Columns& d) {
        const int size = p.rows(), k = slot(i);
        scalar *a = panels_.data() + k * panel_size_, *x = x_.data();
        int* from = from_.data() + static_cast<std::size_t>(k) * size;
        if (std::exchange(factored_[k], i) == i) {
            right_sides<Nodes>(hJ, d, x, 1);
            p.forward(a, from, x);
        } else {
            write<Nodes>(p, h, hJ, a);
            right_sides<Nodes>(hJ, d, a + size, p.width());
            p.eliminate(a, from);
            for (int l = 0; l < size; ++l) x[l] = a[l * p.width() + size];
        }
        p.back(a, 0, x);
    }

    /// Unknowns and equations are ordered by components, those of each at all nodes one behind the other.
    template <int Nodes, class Panel>
    void write(const Panel& p, const scalar& h, const scalar* hJ, scalar* a) const {
        const int n = equations_.n(), m = nodes<Nodes>(), M = positions(), width = p.width();
        for (int c = M; c < n; ++c)
            for (int k = 0; k < m; ++k) {
                const scalar *once = rule_->integrals.data() + k * m, *twice = rule_->twice.data() + k * m,
                             *J = hJ + k * n * n + c;
                scalar* row = a + static_cast<std::ptrdiff_t>((c - M) * m + k) * width;
                for (int d = M; d < n; ++d) {
                    const bool velocity = d < 2 * M;
                    add_multiples<Nodes>(m, scalar(-J[d * n]), once,
                                         velocity ? scalar(-h * J[(d - M) * n]) : scalar(0),
                                         velocity ? twice : nullptr, row + (d - M) * m);
                }
                for (int l = p.columns() - 1; l < width; ++l) row[l] = scalar(0);
            }
        for_mass(equations_.mass(), M, n, [&](int row, int column, const scalar& value) {
            for (int k = 0; k < m; ++k)
                a[static_cast<std::ptrdiff_t>(row * m + k) * width + column * m + k] += value;
        });
    }

    /// d + h f_q (integral of d_q) of the components that are eliminated, `stride` apart.
    template <int Nodes, class Columns>
    void right_sides(const scalar* hJ, const Columns& d, scalar* out, int stride) {
        const int n = equations_.n(), m = nodes<Nodes>(), M = positions();
        bool moved = false;
        for (int q = 0; q < M; ++q)
            for (int k = 0; k < m; ++k) moved |= !(d(q, k) == scalar(0));
        for (int q = 0; q < M && moved; ++q)
            transform<Nodes, Nodes>(m, m, rule_->integrals_of.data(), &d(q, 0), n, moved_.data() + q * m);
        for (int c = M; c < n; ++c)
            for (int k = 0; k < m; ++k, out += stride) {
                *out = d(c, k);
                for (int q = 0; q < M && moved; ++q) *out += hJ[c + (k * n + q) * n] * moved_[q * m + k];
            }
    }

    /// g from what the elimination has left in x.
    template <int Nodes, class Columns>
    void take(const scalar& h, const Columns& d, Columns& g) {
        const int n = equations_.n(), m = nodes<Nodes>(), M = positions();
        for (int c = M; c < n; ++c)
            for (int k = 0; k < m; ++k) g(c, k) = x_[(c - M) * m + k];
        for (int q = 0; q < M; ++q) {
            transform<Nodes, Nodes>(m, m, rule_->integrals_of.data(), x_.data() + q * m, 1, moved_.data());
            for (int k = 0; k < m; ++k) g(q, k) = d(q, k) + h * moved_[k];
        }
    }

    const Equations& equations_;
    std::shared_ptr<const rule> rule_;
    long version_ = -1;
    int kept_ = 1;
    std::ptrdiff_t panel_size_ = 0;
    Eigen::Matrix<scalar, Eigen::Dynamic, 1> hJ_, panels_, x_, moved_;
    std::vector<int> from_, interpolated_, factored_;
    Eigen::Matrix<scalar, N, 1> own_, change_;
};

}  // namespace stagecraft::detail
