// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/LU>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "stagecraft/theory/dynamics/evaluate.hpp"
#include "stagecraft/theory/statements/verdict.hpp"

namespace stagecraft::theory {

using interval_vector = Eigen::Matrix<interval, Eigen::Dynamic, 1>;
using interval_matrix = Eigen::Matrix<interval, Eigen::Dynamic, Eigen::Dynamic>;

/// All zeros of a system in a box. proved: each box in `zeros` contains exactly one, and there is no other.
/// consistent: the limit of boxes was reached or boxes became too small; other zeros can lie in `undecided`.
struct zeros_in_box {
    theory::verdict verdict = verdict::proved();
    std::vector<interval_vector> zeros;
    std::vector<interval_vector> undecided;
};

struct krawczyk_limits {
    std::size_t boxes = 20'000;
    double smallest = 1e-10;  ///< boxes narrower than this (in their widest side) are not divided
};

namespace detail {

enum class krawczyk_finding { none, unique, open };

interval_vector centre_of(const interval_vector& x);

/// One step of Krawczyk's operator K(X) = m - Y F(m) + (1 - Y F'(X)) (X - m), Y near F'(m)^-1: disjoint from
/// X means no zero in X, inside X exactly one (Neumaier, Interval Methods for Systems of Equations, 5.1). X
/// becomes its intersection with K(X).
template <class F, class J>
krawczyk_finding krawczyk_step(const F& f, const J& jacobian, interval_vector& x) {
    const interval_vector m = centre_of(x), fx = f(x);
    for (Eigen::Index i = 0; i < fx.size(); ++i)
        if (!fx[i].contains(0.0)) return krawczyk_finding::none;
    const interval_matrix slope = jacobian(x);
    const auto n = x.size();
    Eigen::MatrixXd middle(n, n);
    for (Eigen::Index i = 0; i < slope.size(); ++i) {
        if (!slope.data()[i].bounded()) return krawczyk_finding::open;
        middle.data()[i] = slope.data()[i].middle();
    }
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(middle);
    if (!lu.isInvertible()) return krawczyk_finding::open;
    const Eigen::MatrixXd inverse = lu.inverse();
    if (!inverse.allFinite()) return krawczyk_finding::open;
    const interval_matrix Y = inverse.unaryExpr([](double a) { return interval(a); });
    interval_matrix rest = -(Y * slope);
    for (Eigen::Index i = 0; i < n; ++i) rest(i, i) += 1;
    const interval_vector k = m - Y * f(m) + rest * (x - m);
    bool inside = true;
    for (Eigen::Index i = 0; i < n; ++i) {
        if (disjoint(k[i], x[i])) return krawczyk_finding::none;
        inside = inside && k[i].inside(x[i]);
        x[i] = intersection(k[i], x[i]);
    }
    return inside ? krawczyk_finding::unique : krawczyk_finding::open;
}

bool overlap(const interval_vector& a, const interval_vector& b);

Eigen::Index widest_side(const interval_vector& x);

/// Narrows a box that contains exactly one zero until nothing changes.
template <class F, class J>
interval_vector polished(const F& f, const J& jacobian, interval_vector x) {
    for (int k = 0; k < 50; ++k) {
        interval_vector next = x;
        if (krawczyk_step(f, jacobian, next) == krawczyk_finding::none) return x;
        const double before = x[widest_side(x)].width(), after = next[widest_side(next)].width();
        x = next;
        if (after > 0.9 * before) break;
    }
    return x;
}

}  // namespace detail

/// The zeros of f(x) = 0, n equations for n unknowns, in a box, by Krawczyk's operator and bisection. f and
/// jacobian map interval_vectors to enclosures. A zero on a face where boxes meet is found from a box a
/// little wider, so zeros just outside the start can be found too; they are left out unless they reach it.
template <class F, class J>
zeros_in_box all_zeros(const F& f, const J& jacobian, const interval_vector& start,
                       const krawczyk_limits& limits = {}) {
    using detail::krawczyk_finding;
    for (Eigen::Index i = 0; i < start.size(); ++i)
        if (!start[i].bounded()) throw std::invalid_argument("box: must be bounded");
    zeros_in_box found;
    std::vector<interval_vector> open{start};
    std::size_t count = 0;
    while (!open.empty()) {
        if (++count > limits.boxes) break;
        interval_vector x = std::move(open.back());
        open.pop_back();
        // a little wider, so that a zero on the boundary is inside
        interval_vector wider = x;
        for (Eigen::Index i = 0; i < x.size(); ++i) {
            const double margin = 0.05 * x[i].width() + 1e-12;
            wider[i] = x[i] + interval(-margin, margin);
        }
        interval_vector k = wider;
        const auto finding = detail::krawczyk_step(f, jacobian, k);
        if (finding == krawczyk_finding::none) continue;
        if (finding == krawczyk_finding::unique) {
            const interval_vector zero = detail::polished(f, jacobian, k);
            bool known = !detail::overlap(zero, start);
            for (const auto& z : found.zeros) known = known || detail::overlap(z, zero);
            if (!known) found.zeros.push_back(zero);
            continue;  // wider holds no other
        }
        bool empty = false;
        for (Eigen::Index i = 0; i < x.size() && !empty; ++i) {
            if (disjoint(k[i], x[i]))
                empty = true;
            else
                x[i] = intersection(k[i], x[i]);
        }
        if (empty) continue;
        const auto side = detail::widest_side(x);
        if (x[side].width() < limits.smallest) {
            found.undecided.push_back(std::move(x));
            continue;
        }
        interval_vector left = x;
        left[side] = interval(x[side].low(), x[side].middle());
        x[side] = interval(x[side].middle(), x[side].high());
        open.push_back(std::move(x));
        open.push_back(std::move(left));
    }
    for (auto& x : open) found.undecided.push_back(std::move(x));
    const std::string zeros = std::to_string(found.zeros.size()) + " in the box, each unique in its part";
    found.verdict =
        found.undecided.empty()
            ? verdict::proved(zeros)
            : verdict::consistent(zeros, std::to_string(found.undecided.size()) + " boxes undecided",
                                  "the limit of boxes was reached, or zeros are not simple");
    return found;
}

/// Whether f(c, t) = 0 for all t (lecture, Definition 1.13), f polynomial in x and t: exact.
template <int N, class F>
bool is_equilibrium(F&& f, const state<rational, N>& c) {
    static_assert(evaluates_in<F, multinomial, N>,
                  "is_equilibrium needs f in polynomial arithmetic: take t, x and out as auto");
    state<multinomial, N> x, out;
    for (int i = 0; i < N; ++i) x[i] = multinomial(c[i]);
    f(multinomial::unknown(0), x, out);
    for (int i = 0; i < N; ++i)
        if (!out[i].is_zero()) return false;
    return true;
}

/// The equilibria f(c) = 0 of an autonomous f in a box.
template <int N, class F>
zeros_in_box equilibria(F&& f, const box<N>& where, const krawczyk_limits& limits = {}) {
    require_bounded<N>(where);
    return all_zeros(
        [&](const interval_vector& x) { return interval_vector(enclosed<N>(f, box<N>(x))); },
        [&](const interval_vector& x) { return interval_matrix(enclosed_jacobian<N>(f, box<N>(x))); },
        interval_vector(where), limits);
}

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/dynamics/krawczyk-inl.hpp"
#endif
