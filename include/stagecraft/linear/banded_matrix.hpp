// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <string>

namespace stagecraft {

/// Number of diagonals below and above the main one that may hold nonzeros.
struct bandwidth {
    int lower = 0;
    int upper = 0;
};

/// An n x n matrix of which only a band is stored, column by column: entry (i, j) for -upper <= i - j <=
/// lower. What a problem with a member `bandwidth()` gets as its Jacobian.
template <class Scalar>
class banded_matrix {
  public:
    using scalar = Scalar;

    /// All zero. Throws std::invalid_argument unless 0 <= lower, upper < max(n, 1).
    banded_matrix(int n, bandwidth band) : band_(band), entries_(band.lower + band.upper + 1, n) {
        const int most = n > 0 ? n - 1 : 0;
        if (band.lower < 0 || band.lower > most || band.upper < 0 || band.upper > most)
            throw std::invalid_argument("integrate: problem.bandwidth() must lie between 0 and n - 1");
        entries_.setZero();
    }

    int size() const { return static_cast<int>(entries_.cols()); }
    Eigen::Index rows() const { return entries_.cols(); }
    Eigen::Index cols() const { return entries_.cols(); }
    int lower() const { return band_.lower; }
    int upper() const { return band_.upper; }
    bool in_band(int i, int j) const { return i - j <= band_.lower && j - i <= band_.upper; }

    /// Entry (i, j), which must lie in the band.
    Scalar& operator()(int i, int j) { return entries_(band_.upper + i - j, j); }
    const Scalar& operator()(int i, int j) const { return entries_(band_.upper + i - j, j); }

    bool allFinite() const { return entries_.allFinite(); }
    void set_zero() { entries_.setZero(); }
    void setZero() { entries_.setZero(); }  ///< the same under Eigen's name, for Jacobians written for either

    /// What the next step depends on (checkpoint.hpp).
    template <class Bag>
    void carry(Bag& bag) {
        bag(entries_);
    }

  private:
    bandwidth band_;
    Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> entries_;
};

}  // namespace stagecraft
