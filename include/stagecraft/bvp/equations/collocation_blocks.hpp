// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include <stagecraft/linear/mass.hpp>
#include <stagecraft/linear/row_panel.hpp>
#include <stagecraft/method/legendre_rule.hpp>
#include <stagecraft/method/remembered.hpp>
#include <stagecraft/tableau.hpp>

namespace stagecraft::detail {

/// The weights with which slopes of v at the nodes of a collocation tableau enter q at node j and at the end, where q'' = v':
/// q_j = q + c_j h v + h sum_k at_nodes(j, k) Z_k. They are A^2 and b A, which integrate through values at the nodes, and
/// what the leading term of v adds to that: P_s / s over its leading coefficient, times the divided difference of the slopes.
template <class Scalar, int S>
struct weights_of_q {
    Eigen::Matrix<Scalar, S, S> at_nodes;
    Eigen::Matrix<Scalar, S, S, Eigen::RowMajor> by_rows;
    Eigen::Matrix<Scalar, 1, S> to_end;

    weights_of_q() = default;
    explicit weights_of_q(const tableau<Scalar, S>& method)
        : at_nodes(method.A * method.A), to_end(method.b.transpose() * method.A) {
        const int k = method.stages();
        Eigen::Matrix<Scalar, Eigen::Dynamic, 1> values(k + 1), integral(k + 1), at_stages(k);
        Scalar leading(1);
        for (int j = 1; j <= k; ++j) leading *= Scalar(k + j) / Scalar(j);
        for (int j = 0; j < k; ++j) {
            legendre_values(Scalar(method.c[j]), k, values.data());
            at_stages[j] = values[k];
        }
        Eigen::Matrix<Scalar, 1, S> difference(k);
        for (int j = 0; j < k; ++j) {
            difference[j] = Scalar(1) / (Scalar(k) * leading);
            for (int l = 0; l < k; ++l)
                if (l != j) difference[j] /= method.c[j] - method.c[l];
        }
        for (int j = 0; j < k; ++j) {
            legendre_integrals(Scalar(method.c[j]), k, integral.data());
            at_nodes.row(j) += (integral[k] - method.A.row(j).dot(at_stages)) * difference;
        }
        by_rows = at_nodes;
        legendre_integrals(Scalar(1), k, integral.data());
        to_end += (integral[k] - method.b.dot(at_stages)) * difference;
    }
};

/// The equations of one interval [t, t + h] by a collocation tableau, linearised, in the unknowns y at its two
/// ends, the scaled slopes Z_j = h y'(t + c_j h) and the parameters p:
///
///     M Z_j - h f(t + c_j h, y + sum_k a_jk Z_k, p) = 0,      y_+ - y - sum_k b_k Z_k = 0.
///
/// The slopes are eliminated by rows with pivots from both kinds of equations, so that the n equations left,
/// E y + F y_+ + P p = g, are well scaled for growing and decaying modes alike: a pole of R(z) is no obstacle.
/// With `positions` = m > 0 the first m equations are q' = v, v being the next m components. Then v is a polynomial of
/// degree s as before, and q its integral, of degree s + 1, as in collocation of q'' itself (Ascher-Christiansen-Russell
/// 1981): where fast modes leave nothing of superconvergence, that gains two orders. s (n - m) unknowns are
/// eliminated instead of s n.
template <class Scalar, int N, int P, int S>
class collocation_blocks {
    static constexpr bool fixed = N > 0 && P >= 0 && S > 0;
    static constexpr int stages = S > 0 ? S : 0;

  public:
    collocation_blocks(const tableau<Scalar, S>& method, int n, int parameters, int positions)
        : method_(method),
          A_by_rows_(method.A),
          n_(n),
          np_(parameters),
          m_(positions),
          panel_(slopes() + n, slopes() + 2 * n + parameters, slopes()) {
        moved_.setZero(s());
        if (m_ > 0) twice_ = remembered(method, [&] { return weights_of_q<Scalar, S>(method); });
    }

    int n() const { return N > 0 ? N : n_; }
    int np() const { return P >= 0 ? P : np_; }
    int s() const { return S > 0 ? S : method_.stages(); }
    int positions() const { return m_; }
    int slopes() const { return s() * (n() - m_); }
    /// How many numbers apply() and recover() work on.
    int work() const { return slopes() + 2 * n() + np(); }

    /// The weights of q at the nodes and at the end.
    const auto& twice() const { return twice_.at_nodes; }
    const auto& twice_to_end() const { return twice_.to_end; }

    void resize(int intervals) {
        blocks_.resize(static_cast<Eigen::Index>(intervals) * panel_.size());
        from_.resize(static_cast<std::size_t>(intervals) * slopes());
    }

    /// Writes and eliminates interval i, given h and the Jacobians at the nodes (n x (n + n_p) each, side by
    /// side in J). Returns E, F, P as one n x (2 n + n_p) block.
    template <class Mass>
    auto factor(int i, const Scalar& h, const Scalar* J, const Mass& mass) {
        write(block(i), h, J, mass);
        on_panel([&](const auto& panel) { panel.eliminate(block(i), from(i)); });
        return condensed(i);
    }

    /// E, F, P of interval i as one n x (2 n + n_p) block.
    auto condensed(int i) {
        using rows = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
        return Eigen::Map<const rows, 0, Eigen::OuterStride<>>(
            block(i) + static_cast<std::ptrdiff_t>(slopes()) * panel_.width() + slopes(), n(), 2 * n() + np(),
            Eigen::OuterStride<>(panel_.width()));
    }

    /// Turns residuals (rho: n x s of the slope equations, nullptr where these are zero, gamma: n of the continuity, what the
    /// left sides are to become) into the right-hand sides of the eliminated equations: x holds slopes() + n numbers, the
    /// last n being g.
    void apply(int i, const Scalar* rho, const Scalar* gamma, Scalar* x) {
        for (int c = m_, l = 0; c < n(); ++c)
            for (int j = 0; j < s(); ++j, ++l) x[l] = rho ? rho[j * n() + c] : Scalar(0);
        for (int c = 0; c < n(); ++c) x[slopes() + c] = gamma[c];
        on_panel([&](const auto& panel) { panel.forward(block(i), from(i), x); });
    }

    /// The slopes Z (n x s) from what apply() left in x, once y at both ends and p are known.
    void recover(int i, const Scalar& h, Scalar* x, const Scalar* left, const Scalar* right, const Scalar* p,
                 const Scalar* rho, Scalar* z) {
        Scalar* known = x + slopes();
        for (int c = 0; c < n(); ++c) known[c] = left[c], known[n() + c] = right[c];
        for (int c = 0; c < np(); ++c) known[2 * n() + c] = p[c];
        on_panel([&](const auto& panel) { panel.back(block(i), 2 * n() + np(), x); });
        for (int c = m_, l = 0; c < n(); ++c)
            for (int j = 0; j < s(); ++j, ++l) z[j * n() + c] = x[l];
        if (m_ > 0) {
            moved_.resize(s());
            for (int c = 0; c < m_; ++c) {
                transform<stages, stages>(s(), s(), method_.A.data(), x + c * s(), 1, moved_.data());
                for (int j = 0; j < s(); ++j)
                    z[j * n() + c] = h * (left[m_ + c] + moved_[j]) + (rho ? rho[j * n() + c] : Scalar(0));
            }
        }
    }

  private:
    /// act(panel) with the sizes of the panel known at compile time where it is small.
    template <int M = 0, class Act>
    void on_panel(const Act& act) const {
        if constexpr (fixed && 2 * M <= N) {
            constexpr int q = S * (N - M);
            if (m_ != M) return on_panel<M + 1>(act);
            if constexpr (q <= 16) return act(row_panel<Scalar, q + N, q + 2 * N + P, q>(0, 0, 0));
        }
        act(panel_);
    }
    Scalar* block(int i) { return blocks_.data() + static_cast<std::size_t>(i) * panel_.size(); }
    int* from(int i) { return from_.data() + static_cast<std::size_t>(i) * slopes(); }

    /// Slopes and their equations are ordered by components, those of each at all nodes one behind the other.
    template <class Mass>
    void write(Scalar* a, const Scalar& h, const Scalar* J, const Mass& mass) const {
        const int m = m_, q = slopes(), width = panel_.width(), columns = panel_.columns();
        for (int c = m; c < n(); ++c)
            for (int j = 0; j < s(); ++j) {
                Scalar* out = a + static_cast<std::ptrdiff_t>((c - m) * s() + j) * width;
                const Scalar *once = A_by_rows_.data() + j * s(), *twice = twice_.by_rows.data() + j * s();
                const auto entry = [&](int d) { return Scalar(-h * J[(j * (n() + np()) + d) * n() + c]); };
                for (int d = m; d < n(); ++d) {
                    const bool velocity = d < 2 * m;
                    add_multiples<stages>(s(), entry(d), once,
                                          velocity ? Scalar(h * entry(d - m)) : Scalar(0),
                                          velocity ? twice : nullptr, out + (d - m) * s());
                }
                for (int d = 0; d < n(); ++d) {
                    out[q + d] = entry(d);
                    if (d >= m && d < 2 * m) out[q + d] += h * method_.c[j] * entry(d - m);
                    out[q + n() + d] = Scalar(0);
                }
                for (int d = 0; d < np(); ++d) out[q + 2 * n() + d] = entry(n() + d);
                for (int d = columns; d < width; ++d) out[d] = Scalar(0);
            }
        for_mass(mass, m, n(), [&](int r, int column, const Scalar& value) {
            for (int j = 0; j < s(); ++j)
                a[static_cast<std::ptrdiff_t>(r * s() + j) * width + column * s() + j] += value;
        });
        write_continuity(a + static_cast<std::ptrdiff_t>(q) * width, h);
    }

    void write_continuity(Scalar* a, const Scalar& h) const {
        const int m = m_, q = slopes(), width = panel_.width();
        for (int c = 0; c < n(); ++c, a += width) {
            for (int j = 0; j < width; ++j) a[j] = Scalar(0);
            a[q + c] = Scalar(-1);
            a[q + n() + c] = Scalar(1);
            for (int k = 0; k < s(); ++k)
                if (c < m)
                    a[c * s() + k] = -h * twice_.to_end[k];
                else
                    a[(c - m) * s() + k] = -method_.b[k];
            if (c < m) a[q + m + c] = -h;
        }
    }

    tableau<Scalar, S> method_;
    Eigen::Matrix<Scalar, S, S, Eigen::RowMajor> A_by_rows_;
    weights_of_q<Scalar, S> twice_;
    int n_, np_, m_;
    row_panel<Scalar, 0, 0, 0> panel_;
    Eigen::Matrix<Scalar, Eigen::Dynamic, 1> blocks_;
    std::vector<int> from_;
    Eigen::Matrix<Scalar, S, 1> moved_;
};

}  // namespace stagecraft::detail
