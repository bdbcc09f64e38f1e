// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <type_traits>
#include <vector>

#include <stagecraft/dense_output.hpp>
#include <stagecraft/linear/combinations.hpp>
#include <stagecraft/method/collocation_functionals.hpp>

namespace stagecraft {

/// First guess of the stages by the polynomial of the step before, as it is; Columns is the most stages that it has
/// where known at compile time, or -1.
template <int Columns>
struct whole_extrapolation {
    whole_extrapolation(int, int) {}
    template <class Nodes>
    void prepare(const Nodes&) const {}
    /// Z.col(i) := u(from + c_i ratio) - y, u being the polynomial of `before`, ratio the new step over its step.
    template <class Output, class Vector, class Nodes, class Scalar, class Stages>
    void operator()(const Output& before, const Vector& y, const Nodes& c, int s, const Scalar& ratio,
                    const Scalar& from, Stages& Z) const {
        const auto& old = before.nodes();
        const auto& z = before.increments();
        basis_values<Scalar, Columns> l(old.size);
        for (int i = 0; i < s; ++i) {
            old.basis(from + c[i] * ratio, l.data());
            Z.col(i) = before.y0() - y;
            if constexpr (Vector::RowsAtCompileTime >= 0 && Vector::RowsAtCompileTime <= 4) {
                for (int j = 0; j < old.size; ++j) Z.col(i) += l[j] * z.col(old.first_column + j);
            } else {
                combine<true, -1>(static_cast<int>(y.size()), old.size, l.data(),
                                  z.col(old.first_column).data(), Z.col(i).data());
            }
        }
    }
};

/// First guess of many stages by the polynomial of the step before. Beyond its step the Legendre function of
/// degree k grows like (2 + 4 h/h_before)^k: with seven stages and equal steps what Newton's iteration left of the
/// polynomial is multiplied by 10^5, and a guess that far off has been seen to lead a stiff component to where f is
/// flat, where the iteration ends though nothing is solved. So, as one does with a divergent series, every component
/// keeps the terms
///     a_k P_k(2 x - 1),  k <= d,
/// with the d behind which they are smallest at the end of the new step, and all of them where the last three fall.
template <class Scalar, int Columns>
class stage_extrapolation {
  public:
    /// Room for polynomials of up to `degree` at `stages` points.
    stage_extrapolation(int degree, int stages)
        : a_(4 * (degree + 1)), last_(degree + 1), x_(stages + 1), values_(last_.size() * x_.size()) {}

    /// So that no step makes the map of these nodes.
    template <class Nodes>
    void prepare(const Nodes& nodes) const {
        coefficients_of(nodes);
    }
    /// As whole_extrapolation does it, with the terms to be trusted: n s (s + d) operations more. Of many components it pays to
    /// take the whole polynomial first and to make anew what does not fall: 3 n d. Up to three stages it is left as it is.
    template <class Output, class Vector, class Nodes, class Stages>
    void operator()(const Output& before, const Vector& y, const Nodes& c, int s, const Scalar& ratio,
                    const Scalar& from, Stages& Z) {
        const int first = before.nodes().first_column, n = static_cast<int>(Z.rows());
        const bool all = s <= 3 || n > 15;
        if (all) whole_extrapolation<Columns>(0, 0)(before, y, c, s, ratio, from, Z);
        if (s <= 3) return;
        degree_ = before.nodes().size;
        to_coefficients_ = coefficients_of(before.nodes());
        evaluate(c, s, ratio, from);
        const auto block = [&](auto width, int r) {
            if (!all || grows<width>(before, first, r)) extrapolate<width>(before, first, r, s, Z);
        };
        int r = 0;
        for (; r + 4 <= n; r += 4) block(std::integral_constant<int, 4>(), r);
        for (; r + 2 <= n; r += 2) block(std::integral_constant<int, 2>(), r);
        if (r < n) block(std::integral_constant<int, 1>(), r);
    }

  private:
    /// z -> a_k as legendre_coefficients() has it. Those of the last eight sets of nodes are kept per thread, as
    /// methods of different order take turns and runs may be short.
    template <class Nodes>
    static const Scalar* coefficients_of(const Nodes& nodes) {
        struct entry {
            std::vector<Scalar> c, map;
        };
        static thread_local std::vector<entry> known;
        const auto end = nodes.c.begin() + nodes.size;
        for (const entry& e : known)
            if (std::equal(nodes.c.begin(), end, e.c.begin(), e.c.end())) return e.map.data();
        if (known.size() == 8) known.erase(known.begin());
        known.push_back(
            {std::vector<Scalar>(nodes.c.begin(), end), legendre_coefficients<Scalar>(nodes.c, nodes.size)});
        return known.back().map.data();
    }

    /// values_[k (s + 1) + i] := P_k at stage i less P_k at the start of the step, all stages at once.
    template <class Nodes>
    void evaluate(const Nodes& c, int s, const Scalar& ratio, const Scalar& from) {
        const int points = s + 1;  // the last one is the start
        for (int i = 0; i < s; ++i) x_[i] = 2 * (from + c[i] * ratio) - 1;
        x_[s] = 2 * from - 1;
        Scalar* p = values_.data();
        for (int i = 0; i < points; ++i) p[i] = Scalar(1), p[points + i] = x_[i];
        for (int k = 1; k < degree_; ++k, p += points) {
            const Scalar share = Scalar(k) / Scalar(k + 1);
            for (int i = 0; i < points; ++i) {
                const Scalar next = x_[i] * p[points + i];
                p[2 * points + i] = next + share * (next - p[i]);
            }
        }
        for (int k = 1; k <= degree_; ++k) {
            Scalar* at = values_.data() + k * points;
            for (int i = 0; i < s; ++i) at[i] -= at[s];
            last_[k] = at[s - 1];
        }
    }
    /// a[w] := a_k of component r + w.
    template <int W, class Output>
    void coefficients(const Output& before, int first, int r, int k, Scalar* a) const {
        Scalar sum[W] = {};
        for (int j = 0; j < degree_; ++j) {
            const Scalar by = to_coefficients_[k * degree_ + j];
            const Scalar* z = before.increments().col(first + j).data() + r;
            for (int w = 0; w < W; ++w) sum[w] += by * z[w];
        }
        for (int w = 0; w < W; ++w) a[w] = sum[w];
    }
    /// Of each component alone, so that the parts of a distributed state are guessed as the whole is.
    bool falls(const Scalar& last, const Scalar& next_to_it, const Scalar& before_them) const {
        using std::abs;
        const Scalar most = abs(before_them * last_[degree_ - 2]);
        return abs(last * last_[degree_]) <= most && abs(next_to_it * last_[degree_ - 1]) <= most;
    }
    /// True if the last three terms of a component r, ..., r + W - 1 do not fall.
    template <int W, class Output>
    bool grows(const Output& before, int first, int r) const {
        if (degree_ < 3) return true;
        Scalar a[3][W];
        for (int m = 0; m < 3; ++m) coefficients<W>(before, first, r, degree_ - m, a[m]);
        bool all = true;
        for (int w = 0; w < W; ++w) all &= falls(a[0][w], a[1][w], a[2][w]);
        return !all;
    }
    /// Components r, ..., r + W - 1 of the guess.
    template <int W, class Output, class Stages>
    void extrapolate(const Output& before, int first, int r, int s, Stages& Z) {
        const int n = static_cast<int>(Z.rows()), points = s + 1;
        for (int k = 1; k <= degree_; ++k) coefficients<W>(before, first, r, k, a_.data() + W * k);
        for (int w = 0; w < W; ++w)
            for (int k = trusted<W>(w) + 1; k <= degree_; ++k) a_[W * k + w] = Scalar(0);
        for (int i = 0; i < s; ++i) {
            Scalar sum[W] = {};
            for (int k = 1; k <= degree_; ++k)
                for (int w = 0; w < W; ++w) sum[w] += values_[k * points + i] * a_[W * k + w];
            for (int w = 0; w < W; ++w) Z.data()[i * n + r + w] = sum[w];
        }
    }
    /// The degree d for component w.
    template <int W>
    int trusted(int w) const {
        using std::abs;
        if (degree_ > 2 && falls(a_[W * degree_ + w], a_[W * (degree_ - 1) + w], a_[W * (degree_ - 2) + w]))
            return degree_;
        const auto term = [&](int k) { return Scalar(abs(a_[W * k + w] * last_[k])); };
        Scalar after(0), last = term(degree_), least = last;
        int d = degree_;
        for (int k = degree_ - 1; k > 0; --k) {  // the next two terms, as every other one may vanish
            const Scalar next = last > after ? last : after;
            if (next < least) {
                least = next;
                d = k;
            }
            after = last;
            last = term(k);
        }
        return last < least ? 0 : d;
    }

    int degree_ = 0;
    const Scalar* to_coefficients_ = nullptr;    // row k: z -> a_k
    std::vector<Scalar> a_, last_, x_, values_;  // a_: of four components; last_: P_k at the last stage
};

}  // namespace stagecraft
