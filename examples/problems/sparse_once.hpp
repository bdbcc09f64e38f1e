// SPDX-License-Identifier: BSL-1.0
// Eigen's sparse LU, which takes six seconds to compile: a file that includes this one leaves it to eigen_once.cpp.
#pragma once

#include <Eigen/SparseLU>
#include <complex>

namespace Eigen {

extern template void SparseLU<SparseMatrix<double>>::analyzePattern(const SparseMatrix<double>&);
extern template void SparseLU<SparseMatrix<double>>::factorize(const SparseMatrix<double>&);
extern template void SparseLU<SparseMatrix<std::complex<double>>>::analyzePattern(
    const SparseMatrix<std::complex<double>>&);
extern template void SparseLU<SparseMatrix<std::complex<double>>>::factorize(
    const SparseMatrix<std::complex<double>>&);

}  // namespace Eigen
