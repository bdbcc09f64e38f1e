// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <vector>

#include <stagecraft/linear/split_lu.hpp>
#include <stagecraft/tableau/collocation_functionals.hpp>
#include <stagecraft/tableau/legendre_values.hpp>

namespace stagecraft {

/// First guess of many stages by the polynomial of the step before. Beyond its step the Legendre function of degree k
/// grows like (2 + 4 h/h_before)^k: with seven stages and equal steps what Newton's iteration left of the polynomial is
/// multiplied by 10^5, and a guess that far off has been seen to lead a stiff component to where f is flat, where the
/// iteration ends though nothing is solved. So, as one does with a divergent series, every component keeps the terms
///     a_k P_k(2 x - 1),  k <= d,
/// with the d behind which they are smallest at the end of the new step: all of them for a smooth component.
template <class Scalar>
class stage_extrapolation {
  public:
    /// Room for polynomials of up to `degree` at `stages` points.
    stage_extrapolation(int degree, int stages)
        : lu_(degree + 1),
          row_(static_cast<std::size_t>(degree) + 1),
          a_(4 * row_.size()),
          at_start_(row_),
          ratios_(row_),
          grid_(row_.size() * static_cast<std::size_t>(stages)),
          to_coefficients_(row_.size() * static_cast<std::size_t>(degree)) {
        nodes_.reserve(row_.size());
        for (int k = 1; k <= degree; ++k) ratios_[k] = Scalar(k) / Scalar(k + 1);
    }

    /// Z.col(i) := u(from + c_i ratio) - u(from), u being the polynomial of `before`, ratio the new step over
    /// its step. n s (s + d) operations.
    template <class Output, class Nodes, class Stages>
    void operator()(const Output& before, const Nodes& c, int s, const Scalar& ratio, const Scalar& from,
                    Stages& Z) {
        know(before.nodes());
        const int first = before.nodes().first_column;
        legendre_values(from, degree_, ratios_, at_start_.data());
        for (int i = 0; i < s; ++i) {
            Scalar* p = grid_.data() + i * (degree_ + 1);
            legendre_values(Scalar(from + c[i] * ratio), degree_, ratios_, p);
            for (int k = 0; k <= degree_; ++k) p[k] -= at_start_[k];
        }
        const int n = static_cast<int>(Z.rows());
        int r = 0;
        for (; r + 4 <= n; r += 4) extrapolate<4>(before, first, r, s, Z);
        for (; r < n; ++r) extrapolate<1>(before, first, r, s, Z);
    }

  private:
    /// The coefficients follow from the values at these nodes.
    template <class Nodes>
    void know(const Nodes& nodes) {
        const auto end = nodes.c.begin() + nodes.size;
        if (std::equal(nodes.c.begin(), end, nodes_.begin(), nodes_.end())) return;
        nodes_.assign(nodes.c.begin(), end);
        degree_ = nodes.size;
        legendre_coefficients(nodes_, degree_, lu_, row_, to_coefficients_);
    }
    /// Components r, ..., r + W - 1 of the guess.
    template <int W, class Output, class Stages>
    void extrapolate(const Output& before, int first, int r, int s, Stages& Z) {
        const int n = static_cast<int>(Z.rows());
        for (int k = 1; k <= degree_; ++k) {
            Scalar* a = a_.data() + 4 * k;
            for (int w = 0; w < W; ++w) a[w] = Scalar(0);
            for (int j = 0; j < degree_; ++j) {
                const Scalar by = to_coefficients_[k * degree_ + j];
                const Scalar* z = before.increments().col(first + j).data() + r;
                for (int w = 0; w < W; ++w) a[w] += by * z[w];
            }
        }
        const Scalar* last = grid_.data() + (s - 1) * (degree_ + 1);
        for (int w = 0; w < W; ++w)
            for (int k = trusted(last, w) + 1; k <= degree_; ++k) a_[4 * k + w] = Scalar(0);
        for (int i = 0; i < s; ++i) {
            const Scalar* p = grid_.data() + i * (degree_ + 1);
            Scalar* z = Z.data() + i * n + r;
            for (int w = 0; w < W; ++w) z[w] = Scalar(0);
            for (int k = 1; k <= degree_; ++k)
                for (int w = 0; w < W; ++w) z[w] += p[k] * a_[4 * k + w];
        }
    }
    /// The degree d for component w, p being the functions at the last stage.
    int trusted(const Scalar* p, int w) const {
        using std::abs;
        const auto term = [&](int k) { return Scalar(abs(a_[4 * k + w] * p[k])); };
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
    split_lu<Scalar, -1> lu_;
    std::vector<Scalar> row_, a_, at_start_, ratios_, grid_, nodes_;  // a_: of four components
    std::vector<Scalar> to_coefficients_;                             // row k: z -> a_k
};

/// Of three stages at most, whose polynomial is taken as it is.
struct whole_extrapolation {
    whole_extrapolation(int, int) {}
};

}  // namespace stagecraft
