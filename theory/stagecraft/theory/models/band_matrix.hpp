// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <stdexcept>
#include <vector>

#include "stagecraft/theory/models/fixed_buffer.hpp"

namespace stagecraft::theory {

/// A square matrix over K that is zero outside `lower` diagonals below and `upper` above the main one
/// (size - 1 of each: full). `constexpr` for class types K, so the same code proves at compile time.
template <class K>
class band_matrix {
  public:
    constexpr band_matrix() = default;
    constexpr band_matrix(int size, int lower, int upper)
        : size_(size),
          lower_(lower < size ? lower : size - 1),
          upper_(upper < size ? upper : size - 1),
          width_(lower_ + upper_ + 1),
          entries_(size_ * width_) {}

    constexpr int size() const { return size_; }
    constexpr int lower() const { return lower_; }
    constexpr int upper() const { return upper_; }
    /// First and one past the last column of row i, and row of column j, inside the band.
    constexpr int first_column(int i) const { return i < lower_ ? 0 : i - lower_; }
    constexpr int end_column(int i) const { return i + upper_ < size_ ? i + upper_ + 1 : size_; }
    constexpr int first_row(int j) const { return j < upper_ ? 0 : j - upper_; }
    constexpr int end_row(int j) const { return j + lower_ < size_ ? j + lower_ + 1 : size_; }

    /// Entry (i, j), zero outside the band.
    constexpr K operator()(int i, int j) const {
        const int k = j - i + lower_;
        if (k < 0 || k >= width_ || j < 0 || j >= size_) return K(0);
        return entries_.data()[i * width_ + k];
    }
    /// Entry (i, j) to write to. Throws std::logic_error outside the band.
    constexpr K& entry(int i, int j) {
        const int k = j - i + lower_;
        if (k < 0 || k >= width_ || j < 0 || j >= size_)
            throw std::logic_error("band_matrix: entry outside the band");
        return entries_.data()[i * width_ + k];
    }
    /// row(i)[j] is entry (i, j) for j in the band of row i.
    constexpr const K* row(int i) const { return entries_.data() + (i * width_ + lower_ - i); }

    constexpr bool is_diagonal() const { return width_ == 1; }

    constexpr band_matrix transposed() const {
        band_matrix t(size_, upper_, lower_);
        for (int i = 0; i < size_; ++i)
            for (int j = first_column(i); j < end_column(i); ++j) t.entry(j, i) = row(i)[j];
        return t;
    }

    /// Matrix product. O(size * width * width) operations.
    friend constexpr band_matrix operator*(const band_matrix& a, const band_matrix& b) {
        band_matrix product(a.size_, a.lower_ + b.lower_, a.upper_ + b.upper_);
        for (int i = 0; i < a.size_; ++i) {
            const int end = a.end_column(i);
            for (int k = a.first_column(i); k < end; ++k) {
                const K& f = a.row(i)[k];
                if (f == K(0)) continue;
                const K* const factors = b.row(k);
                const int last = b.end_column(k);
                for (int j = b.first_column(k); j < last; ++j)
                    if (!(factors[j] == K(0))) product.entry(i, j) += f * factors[j];
            }
        }
        return product;
    }

    /// Matrix times vector. O(size * (lower + upper + 1)) operations.
    constexpr std::vector<K> operator*(const std::vector<K>& v) const {
        std::vector<K> u(static_cast<std::size_t>(size_), K(0));
        for (int i = 0; i < size_; ++i) {
            K& sum = u[static_cast<std::size_t>(i)];
            for (int j = first_column(i); j < end_column(i); ++j)
                sum += row(i)[j] * v[static_cast<std::size_t>(j)];
        }
        return u;
    }

  private:
    int size_ = 0;
    int lower_ = 0;
    int upper_ = 0;
    int width_ = 1;
    fixed_buffer<K> entries_;
};

}  // namespace stagecraft::theory
