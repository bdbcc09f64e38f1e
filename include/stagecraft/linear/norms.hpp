// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <limits>

#include <stagecraft/linear/packet.hpp>

namespace stagecraft {

/// Where every component of a vector is in this process: a sum over them is complete as it is. Norms take one of
/// these, or an object that adds up over processes: sums(x, k) replaces k numbers by their sums over all of them,
/// the same bits on each (problem/distributed.hpp).
struct complete_sums {
    static constexpr bool complete = true;
    template <class Scalar>
    void operator()(Scalar*, int) const {}
};

namespace detail {

/// The sum of term(packet or number, ...) over the vectors of n numbers at x. In packets where that is more
/// than a few, two sums at a time: an addition takes as long as four more of them that do not wait for it.
template <class Scalar, class Term, class... Pointers>
Scalar sum_of(int n, const Term& term, const Pointers*... x) {
    Scalar sum(0);
    for (int i = 0; i < n; ++i) sum += term(x[i]...);
    return sum;
}
template <class Scalar, class Term, class... Pointers>
requires(built_in<Scalar>) [[gnu::flatten]] inline Scalar
    sum_of(int n, const Term& term, const Pointers*... x) {
    using P = packet<Scalar>;
    Scalar sum(0);
    int i = 0;
    if (n >= 4 * P::size) {
        auto a = P::all(Scalar(0)), b = a;
        for (; i + 2 * P::size <= n; i += 2 * P::size) {
            a = a + term(P::load(x + i)...);
            b = b + term(P::load(x + i + P::size)...);
        }
        sum = P::sum(a + b);
    }
    for (; i < n; ++i) sum += term(x[i]...);
    return sum;
}

}  // namespace detail

/// True if the first n components of x are finite, on every process.
template <class Vector, class Sums = complete_sums>
bool all_finite(const Vector& x, int n, const Sums& sums = {}) {
    using scalar = typename Vector::Scalar;
    if constexpr (int(Vector::SizeAtCompileTime) > 0) n = int(Vector::SizeAtCompileTime);
    scalar sum = detail::sum_of<scalar>(
        n, [](const auto& v) { return v - v; }, x.data());
    sums(&sum, 1);
    return sum == typename Vector::Scalar(0);
}

/// to := x, n numbers; true if they are finite, on every process.
template <class Scalar, class Sums = complete_sums>
bool copy_finite(const Scalar* x, int n, Scalar* to, const Sums& sums = {}) {
    Scalar sum(0);
    int i = 0;
    if constexpr (built_in<Scalar>) {
        using P = packet<Scalar>;
        auto all = P::all(Scalar(0));
        for (; i + P::size <= n; i += P::size) {
            const auto v = P::load_written(x + i);
            P::store(to + i, v);
            all = all + (v - v);
        }
        sum = P::sum(all);
    }
    for (; i < n; ++i) sum += x[i] - x[i], to[i] = x[i];
    sums(&sum, 1);
    return sum == Scalar(0);
}

/// The root mean square over all processes of values whose sum of squares here is squares(unit), each multiplied by
/// `unit` first; `count` of them here. One addition over the processes, of sum and count together; a second one of
/// small multiples where the squares overflow.
template <class Scalar, class Squares, class Sums>
Scalar added_norm(Squares&& squares, int count, const Sums& sums) {
    using std::sqrt;
    Scalar part[2] = {squares(Scalar(1)), Scalar(count)};
    sums(part, 2);
    if (part[1] == Scalar(0)) return Scalar(0);
    if (part[0] - part[0] == Scalar(0)) return sqrt(part[0] / part[1]);
    using limits = std::numeric_limits<Scalar>;
    const Scalar unit = sqrt(limits::min()) * limits::epsilon();
    part[0] = squares(unit);
    part[1] = Scalar(count);
    sums(part, 2);
    return sqrt(part[0] / part[1]) / unit;
}

/// The root mean square of x_i w_i over n components, which are all of x here; 0 for n = 0. Where the squares overflow it
/// is taken relative to the largest component, so that it is finite whenever the products are; else infinite or
/// NaN.
template <class Vector, class Weights, class Sums = complete_sums>
typename Vector::Scalar weighted_norm(const Vector& x, const Weights& w, int n, const Sums& sums = {}) {
    using scalar = typename Vector::Scalar;
    using std::abs;
    using std::sqrt;
    // A size that the compiler knows, told to it: else it warns of iterations beyond it that are never made.
    if constexpr (int(Vector::SizeAtCompileTime) > 0) n = int(Vector::SizeAtCompileTime);
    if constexpr (!Sums::complete) {
        const auto squares = [&](const scalar& unit) {
            scalar sum(0);
            for (int i = 0; i < n; ++i) {
                const scalar v = x[i] * w[i] * unit;
                sum += v * v;
            }
            return sum;
        };
        return added_norm<scalar>(squares, n, sums);
    }
    if (n == 0) return scalar(0);
    scalar sum = detail::sum_of<scalar>(
        n,
        [](const auto& a, const auto& b) {
            const auto v = a * b;
            return v * v;
        },
        x.data(), w.data());
    if (sum - sum == scalar(0)) return sqrt(sum / scalar(n));
    scalar largest = scalar(0);
    for (int i = 0; i < n; ++i) {
        const scalar v = abs(x[i] * w[i]);
        if (!(v - v == scalar(0))) return v;
        if (v > largest) largest = v;
    }
    sum = scalar(0);
    for (int i = 0; i < n; ++i) {
        const scalar v = x[i] * w[i] / largest;
        sum += v * v;
    }
    return largest * sqrt(sum / scalar(n));
}

/// That norm with given weights, which it refers to: what stage solvers and norms of the run have in common.
template <class Vector, class Sums = complete_sums>
class weighted_root_mean_square {
  public:
    explicit weighted_root_mean_square(const Vector& weights, const Sums& sums = {})
        : weights_(weights), sums_(sums) {}
    const Vector& weights() const { return weights_; }
    const Sums& sums() const { return sums_; }
    typename Vector::Scalar operator()(const Vector& x) const {
        return weighted_norm(x, weights_, static_cast<int>(x.size()), sums_);
    }

  private:
    const Vector& weights_;
    [[no_unique_address]] Sums sums_;
};

}  // namespace stagecraft
