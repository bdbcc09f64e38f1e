// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <stagecraft/linear/elimination.hpp>
#include <stagecraft/linear/sparse_elimination.hpp>

namespace stagecraft {

/// Room for an n x n matrix that is written before it is read; most often, where J has few entries, it is neither.
template <class Scalar>
std::unique_ptr<Scalar[]> unwritten(int n) {
    return std::make_unique_for_overwrite<Scalar[]>(static_cast<std::size_t>(n) *
                                                    static_cast<std::size_t>(n));
}

/// LU with row pivoting of a dense real matrix of any size (float or double), blocked for the cache; where most
/// entries are zero and the diagonal will do for pivots, the zeros are left out.
template <class Scalar>
class dense_lu {
  public:
    explicit dense_lu(int n) : n_(n), a_(unwritten<Scalar>(n)), pivot_(n) {}

    Scalar* entries() { return a_.get(); }
    /// False if the matrix is singular or not finite.
    bool factor() { return (zeros_matter_ && sparse_.factor({a_.get()}, n_)) || lu().factor(odd_); }
    /// All zeros are treated as other numbers from now on.
    void ignore_zeros() { zeros_matter_ = false; }
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
    elimination<real_column<Scalar>> lu() { return {{a_.get()}, pivot_.data(), n_}; }
    int n_;
    std::unique_ptr<Scalar[]> a_;
    std::vector<int> pivot_;
    sparse_elimination<real_column<Scalar>> sparse_;
    bool odd_ = false, zeros_matter_ = true;
};

/// The same for a complex matrix kept as real and imaginary part; pivots are compared by |re| + |im|.
template <class Scalar>
class dense_complex_lu {
  public:
    explicit dense_complex_lu(int n)
        : n_(n), re_(unwritten<Scalar>(n)), im_(unwritten<Scalar>(n)), pivot_(n) {}

    Scalar* real_entries() { return re_.get(); }
    Scalar* imaginary_entries() { return im_.get(); }
    bool factor() {
        bool odd;
        return (zeros_matter_ && sparse_.factor({re_.get(), im_.get()}, n_)) || lu().factor(odd);
    }
    void ignore_zeros() { zeros_matter_ = false; }
    void solve(Scalar* x, Scalar* y) { sparse_.factored() ? sparse_.solve({x, y}) : lu().solve({x, y}); }

  private:
    elimination<complex_column<Scalar>> lu() { return {{re_.get(), im_.get()}, pivot_.data(), n_}; }
    int n_;
    std::unique_ptr<Scalar[]> re_, im_;
    std::vector<int> pivot_;
    sparse_elimination<complex_column<Scalar>> sparse_;
    bool zeros_matter_ = true;
};

}  // namespace stagecraft
