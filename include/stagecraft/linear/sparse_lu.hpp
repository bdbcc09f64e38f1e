// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <complex>
#include <cstddef>
#include <vector>

#include <stagecraft/linear/complex_number.hpp>
#include <stagecraft/linear/sparse_elimination.hpp>

namespace stagecraft {

/// Numbers of type T, real or std::complex, as sparse_elimination takes them.
template <class T>
struct plain_column {
    using scalar = T;
    using number = T;
    T* x;
    static const number& of(const T& v) { return v; }
    const number& operator[](std::ptrdiff_t i) const { return x[i]; }
    void set(int i, const number& v) const { x[i] = v; }
};
template <class Scalar>
struct plain_column<std::complex<Scalar>> {
    using scalar = Scalar;
    using number = complex_number<Scalar>;
    std::complex<Scalar>* x;
    static number of(const std::complex<Scalar>& v) { return {v.real(), v.imag()}; }
    number operator[](std::ptrdiff_t i) const { return of(x[i]); }
    void set(int i, const number& v) const { x[i] = {v.re, v.im}; }
};

/// LU of sparse matrices with the interface of Eigen's solvers: sparse_elimination for up to `few` unknowns, which takes a
/// fraction of the operations of a solver made for many and allocates nothing from the second matrix of a pattern on,
/// and Eigen's SparseLU for more, and where the diagonal will not do for pivots. T is real or std::complex.
template <class T>
class sparse_lu {
  public:
    using matrix = Eigen::SparseMatrix<T>;
    using vector = Eigen::Matrix<T, Eigen::Dynamic, 1>;
    static constexpr int few = 256;  // beyond, the n^2 places that the order is found by are no longer little

    /// Takes the pattern of a compressed matrix.
    void analyzePattern(const matrix& a) {
        analysed_ = false;
        const std::size_t n = static_cast<std::size_t>(a.rows());
        if (a.rows() > few) return;
        place_.assign(n * n, -1);
        for (std::size_t j = 0; j < n; ++j)
            for (int k = a.outerIndexPtr()[j]; k < a.outerIndexPtr()[j + 1]; ++k)
                place_[static_cast<std::size_t>(a.innerIndexPtr()[k]) + n * j] = k;
    }
    /// Factors a matrix of that pattern.
    void factorize(const matrix& a) {
        const int n = static_cast<int>(a.rows());
        if (n <= few && few_.factor(entries{a.valuePtr(), place_.data(), static_cast<int>(a.nonZeros())}, n))
            return;
        if (!analysed_) many_.analyzePattern(a);
        analysed_ = true;
        many_.factorize(a);
    }
    Eigen::ComputationInfo info() const { return few_.factored() ? Eigen::Success : many_.info(); }
    double entries_of_factors() const {
        if (few_.factored()) return few_.entries();
        return static_cast<double>(many_.nnzL()) + static_cast<double>(many_.nnzU());
    }
    /// A^-1 b, until the next call.
    const vector& solve(const vector& b) {
        if (few_.factored()) {
            x_ = b;
            few_.solve({x_.data()});
        } else {
            x_ = many_.solve(b);
        }
        return x_;
    }

  private:
    /// The entries of a sparse matrix, asked for by their place in a dense one.
    struct entries {
        const T* values;
        const int* place;
        int count;
        bool holds(std::ptrdiff_t i) const { return place[i] >= 0; }
        int zeros(int places) const { return places - count; }
        typename plain_column<T>::number operator[](std::ptrdiff_t i) const {
            return plain_column<T>::of(values[place[i]]);
        }
    };

    sparse_elimination<plain_column<T>> few_;
    Eigen::SparseLU<matrix, Eigen::COLAMDOrdering<int>> many_;
    std::vector<int> place_;  // of every entry among the values, -1 where there is none
    vector x_;
    bool analysed_ = false;
};

}  // namespace stagecraft
