// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "stagecraft/tableaux/simplifying.hpp"
#include "stagecraft/theory/dynamics/krawczyk.hpp"
#include "stagecraft/theory/dynamics/tableau_numbers.hpp"

namespace stagecraft::theory {

/// Whether f vanishes at a fixed point of a method: equilibrium (it does), ghost (it does not), both proved, or
/// undecided.
enum class fixed_point_kind { equilibrium, ghost, undecided };

/// Fixed points found in a box; kinds[k] belongs to zeros[k], which is (x, X_1, ..., X_s).
struct fixed_points_in_box : zeros_in_box {
    std::vector<fixed_point_kind> kinds;
    int count(fixed_point_kind kind) const;
    int ghosts() const { return count(fixed_point_kind::ghost); }
};

namespace detail {

/// The equations of points that come back after `period` steps of size h: for each step n its start x_n and stages
/// X_n1, ..., X_ns, N numbers each, with X_ni - x_n - h sum_j a_ij f(X_nj) = 0 and x_n + h sum_j b_j f(X_nj) = x_(n+1),
/// where x_period is x_0. Enclosures of the residual and of its Jacobian.
template <int N, class F>
class returning_points {
  public:
    template <class K>
    returning_points(const tableau<K>& method, F f, const rational& h, int period)
        : f_(std::move(f)), s_(method.b.size()), period_(period) {
        const interval step(h);
        ha_ = method.A.unaryExpr([&](const K& x) { return step * enclosed_number(x); });
        hb_ = method.b.unaryExpr([&](const K& x) { return step * enclosed_number(x); });
    }
    Eigen::Index size() const { return N * (s_ + 1) * period_; }

    interval_vector residual(const interval_vector& x) const {
        interval_vector r = interval_vector::Zero(size());
        for (int n = 0; n < period_; ++n) {
            if (period_ > 1) r.segment<N>(start(n)) = x.segment<N>(start(n)) - x.segment<N>(next(n));
            for (Eigen::Index i = 0; i < s_; ++i)
                r.segment<N>(stage(n, i)) = x.segment<N>(stage(n, i)) - x.segment<N>(start(n));
            for (Eigen::Index j = 0; j < s_; ++j) {
                const box<N> fj = enclosed<N>(f_, box<N>(x.segment<N>(stage(n, j))));
                for (int k = 0; k < N; ++k) {
                    // a stage without a weight has a value all the same
                    if (!fj[k].bounded()) r[stage(n, j) + k] = interval::whole();
                    r[start(n) + k] += hb_[j] * fj[k];
                    for (Eigen::Index i = 0; i < s_; ++i) r[stage(n, i) + k] -= ha_(i, j) * fj[k];
                }
            }
        }
        return r;
    }
    interval_matrix jacobian(const interval_vector& x) const {
        interval_matrix D = interval_matrix::Zero(size(), size());
        for (int n = 0; n < period_; ++n) {
            for (int k = 0; k < N; ++k) {
                if (period_ > 1) {
                    D(start(n) + k, start(n) + k) = 1;
                    D(start(n) + k, next(n) + k) = -1;
                }
                for (Eigen::Index i = 0; i < s_; ++i) {
                    D(stage(n, i) + k, stage(n, i) + k) = 1;
                    D(stage(n, i) + k, start(n) + k) = -1;
                }
            }
            for (Eigen::Index j = 0; j < s_; ++j) {
                const auto J = enclosed_jacobian<N>(f_, box<N>(x.segment<N>(stage(n, j))));
                for (int k = 0; k < N; ++k) {
                    for (int m = 0; m < N; ++m) {
                        if (!J(k, m).bounded()) D(stage(n, j) + k, stage(n, j) + m) = interval::whole();
                        D(start(n) + k, stage(n, j) + m) += hb_[j] * J(k, m);
                        for (Eigen::Index i = 0; i < s_; ++i)
                            D(stage(n, i) + k, stage(n, j) + m) -= ha_(i, j) * J(k, m);
                    }
                }
            }
        }
        return D;
    }
    zeros_in_box zeros(const box<N>& where, const krawczyk_limits& limits) const {
        return all_zeros([this](const interval_vector& x) { return residual(x); },
                         [this](const interval_vector& x) { return jacobian(x); },
                         where.replicate(size() / N, 1), limits);
    }
    /// Whether exactly one solution lies in x.
    bool unique_in(interval_vector x) const {
        return krawczyk_step([this](const interval_vector& y) { return residual(y); },
                             [this](const interval_vector& y) { return jacobian(y); },
                             x) == krawczyk_finding::unique;
    }

  private:
    Eigen::Index start(int n) const { return N * (s_ + 1) * n; }
    Eigen::Index next(int n) const { return start((n + 1) % period_); }
    Eigen::Index stage(int n, Eigen::Index i) const { return start(n) + N * (i + 1); }

    F f_;
    Eigen::Index s_;
    int period_;
    interval_matrix ha_;
    interval_vector hb_;
};

/// The box that holds all parts of `length` numbers of z, a little widened.
interval_vector hull_of_parts(const interval_vector& z, Eigen::Index length);

template <int N, class F>
fixed_point_kind kind_of(const returning_points<N, F>& map, F& f, const interval_vector& z) {
    const box<N> fx = enclosed<N>(f, box<N>(z.head<N>()));
    for (int k = 0; k < N; ++k)
        if (!fx[k].contains(0.0)) return fixed_point_kind::ghost;
    // One zero of f in a box, and one fixed point with its stages in that box: they are the same.
    const interval_vector around = hull_of_parts(z, N);
    interval_vector x = around;
    const bool vanishes =
        krawczyk_step(
            [&](const interval_vector& y) { return interval_vector(enclosed<N>(f, box<N>(y))); },
            [&](const interval_vector& y) { return interval_matrix(enclosed_jacobian<N>(f, box<N>(y))); },
            x) == krawczyk_finding::unique;
    return vanishes && map.unique_in(around.replicate(z.size() / N, 1)) ? fixed_point_kind::equilibrium
                                                                        : fixed_point_kind::undecided;
}

template <int N, class K>
void require_search(const tableau<K>& method, const rational& h, const box<N>& where) {
    tableaux::require_shape(method);
    require_step(h);
    require_bounded<N>(where);
}

}  // namespace detail

/// The fixed points of any method for an autonomous f that evaluates in intervals, x and all its stages X_i in the box:
/// the zeros of (sum_j b_j f(X_j), X_i - x - h sum_j a_ij f(X_j)) by Krawczyk's operator and bisection, each with
/// what it is. A method of one stage and b_1 != 0 has no ghosts: f(X_1) = 0 makes X_1 = x. Where the limits of the
/// search or a zero that is not simple leave boxes open, the verdict is consistent and they are listed. Throws
/// std::invalid_argument for h <= 0 and for a box that is not bounded. Cost: grows like that of bisection in N (s + 1)
/// unknowns.
template <int N, class K, class F>
fixed_points_in_box ghosts_in(const tableau<K>& method, F f, const rational& h, const box<N>& where,
                              const krawczyk_limits& limits = {}) {
    detail::require_search<N>(method, h, where);
    const detail::returning_points<N, F> map(method, f, h, 1);
    fixed_points_in_box found{map.zeros(where, limits), {}};
    const bool one_stage = method.b.size() == 1 && !(method.b[0] == K(0));
    for (const auto& z : found.zeros)
        found.kinds.push_back(one_stage ? fixed_point_kind::equilibrium : detail::kind_of<N>(map, f, z));
    return found;
}

/// The points of period two, likewise: x_0, its stages, x_1 != x_0 and its stages in the box; a cycle is found from
/// both of its points. What may be a fixed point and could not be told from a cycle is listed as undecided.
template <int N, class K, class F>
zeros_in_box two_cycles_in(const tableau<K>& method, F f, const rational& h, const box<N>& where,
                           const krawczyk_limits& limits = {}) {
    detail::require_search<N>(method, h, where);
    const detail::returning_points<N, F> once(method, f, h, 1), twice(method, f, h, 2);
    const zeros_in_box all = twice.zeros(where, limits);
    zeros_in_box found;
    found.undecided = all.undecided;
    for (const auto& z : all.zeros) {
        const interval_vector first = z.template head<N>(), second = z.template segment<N>(z.size() / 2);
        if (!detail::overlap(first, second)) {
            found.zeros.push_back(z);
            continue;
        }
        // A fixed point, taken twice the only solution near: no cycle.
        const interval_vector around = detail::hull_of_parts(z, once.size());
        if (!(once.unique_in(around) && twice.unique_in(around.replicate(2, 1))))
            found.undecided.push_back(z);
    }
    const std::string points = std::to_string(found.zeros.size()) + " points of period two in the box";
    found.verdict =
        found.undecided.empty()
            ? verdict::proved(points)
            : verdict::consistent(points, std::to_string(found.undecided.size()) + " boxes undecided",
                                  "the limit of boxes was reached, or zeros are not simple");
    return found;
}

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/dynamics/ghosts_in_box-inl.hpp"
#endif
