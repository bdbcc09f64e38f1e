// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

namespace stagecraft::detail {

/// Matrices of one type for temporary use. A matrix returns to the pool when it goes out of scope and is
/// handed out again to the next request for its size, so that repeated requests for the same sizes allocate
/// nothing. A copy of a pool is empty.
template <class Matrix>
class matrix_pool {
  public:
    /// A matrix that returns to its pool.
    class loan : public Matrix {
      public:
        loan(matrix_pool& pool, Matrix&& m) : Matrix(std::move(m)), pool_(&pool) {}
        loan(loan&& other) noexcept
            : Matrix(std::move(static_cast<Matrix&>(other))), pool_(std::exchange(other.pool_, nullptr)) {}
        loan& operator=(const loan& other) {
            Matrix::operator=(static_cast<const Matrix&>(other));
            return *this;
        }
        ~loan() {
            if (pool_) pool_->spare_.push_back(std::move(static_cast<Matrix&>(*this)));
        }
        using Matrix::operator=;

      private:
        matrix_pool* pool_;
    };

    matrix_pool() = default;
    matrix_pool(const matrix_pool&) {}
    matrix_pool& operator=(const matrix_pool&) { return *this; }

    /// A matrix of this size with unspecified entries.
    loan take(Eigen::Index rows, Eigen::Index cols = 1) {
        for (std::size_t k = spare_.size(); k-- > 0;) {
            if (spare_[k].size() != rows * cols) continue;
            std::swap(spare_[k], spare_.back());
            Matrix found = std::move(spare_.back());
            spare_.pop_back();
            found.resize(rows, cols);
            return loan(*this, std::move(found));
        }
        spare_.reserve(++made_);  // coming back allocates nothing
        return loan(*this, Matrix::Zero(rows, cols));
    }

  private:
    std::vector<Matrix> spare_;
    std::size_t made_ = 0;
};

/// The same for types that need no heap: nothing is kept.
template <class Matrix>
requires(Matrix::MaxSizeAtCompileTime != Eigen::Dynamic) class matrix_pool<Matrix> {
  public:
    using loan = Matrix;
    loan take(Eigen::Index rows, Eigen::Index cols = 1) {
        Matrix m;
        m.resize(rows, cols);
        return m;
    }
};

/// Pools for computations with dense matrices of run-time size with at most Max rows and columns, which then
/// need no heap; Max may be Eigen::Dynamic.
template <class Scalar, int Max>
class workspace {
  public:
    using scalar = Scalar;
    using matrix_type = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, Max, Max>;
    using vector_type = Eigen::Matrix<Scalar, Eigen::Dynamic, 1, Eigen::ColMajor, Max, 1>;
    using index_type = Eigen::Matrix<int, Eigen::Dynamic, 1, Eigen::ColMajor, Max, 1>;
    using matrix = typename matrix_pool<matrix_type>::loan;
    using vector = typename matrix_pool<vector_type>::loan;
    using indices = typename matrix_pool<index_type>::loan;

    matrix take(Eigen::Index rows, Eigen::Index cols) { return matrices_.take(rows, cols); }
    vector take(Eigen::Index size) { return vectors_.take(size); }
    indices take_indices(Eigen::Index size) { return indices_.take(size); }

  private:
    matrix_pool<matrix_type> matrices_;
    matrix_pool<vector_type> vectors_;
    matrix_pool<index_type> indices_;
};

}  // namespace stagecraft::detail
