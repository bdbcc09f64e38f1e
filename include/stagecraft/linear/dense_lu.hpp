// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <vector>

#include <stagecraft/linear/elimination.hpp>
#include <stagecraft/linear/sparse_elimination.hpp>

namespace stagecraft {

/// LU with row pivoting of a dense real matrix of any size (float or double), blocked for the cache; where most
/// entries are zero and the diagonal will do for pivots, the zeros are left out.
template <class Scalar>
class dense_lu {
  public:
    explicit dense_lu(int n) : n_(n), a_(static_cast<std::size_t>(n) * n), pivot_(n) {}

    Scalar* entries() { return a_.data(); }
    /// False if the matrix is singular or not finite.
    bool factor() { return sparse_.factor({a_.data()}, n_) || lu().factor(odd_); }
    void solve(Scalar* x) { sparse_.factored() ? sparse_.solve({x}) : lu().solve({x}); }
    /// Sign of the determinant of the matrix last factored.
    bool negative_determinant() const {
        bool negative = false;
        if (sparse_.factored()) {
            for (int k = 0; k < n_; ++k) negative ^= sparse_.inverse_pivot(k) < Scalar(0);
            return negative;
        }
        negative = odd_;
        for (int k = 0; k < n_; ++k) negative ^= a_[k + static_cast<std::size_t>(k) * n_] < Scalar(0);
        return negative;
    }

  private:
    elimination<real_column<Scalar>> lu() { return {{a_.data()}, pivot_.data(), n_}; }
    int n_;
    std::vector<Scalar> a_;
    std::vector<int> pivot_;
    sparse_elimination<real_column<Scalar>> sparse_;
    bool odd_ = false;
};

/// The same for a complex matrix kept as real and imaginary part; pivots are compared by |re| + |im|.
template <class Scalar>
class dense_complex_lu {
  public:
    explicit dense_complex_lu(int n)
        : n_(n), re_(static_cast<std::size_t>(n) * n), im_(re_.size()), pivot_(n) {}

    Scalar* real_entries() { return re_.data(); }
    Scalar* imaginary_entries() { return im_.data(); }
    bool factor() {
        bool odd;
        return sparse_.factor({re_.data(), im_.data()}, n_) || lu().factor(odd);
    }
    void solve(Scalar* x, Scalar* y) { sparse_.factored() ? sparse_.solve({x, y}) : lu().solve({x, y}); }

  private:
    elimination<complex_column<Scalar>> lu() { return {{re_.data(), im_.data()}, pivot_.data(), n_}; }
    int n_;
    std::vector<Scalar> re_, im_;
    std::vector<int> pivot_;
    sparse_elimination<complex_column<Scalar>> sparse_;
};

}  // namespace stagecraft
