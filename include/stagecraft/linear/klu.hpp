// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/KLUSupport>
#include <Eigen/SparseCore>
#include <complex>

#include <stagecraft/linear/sparse_blocks.hpp>

namespace stagecraft {

/// Eigen's KLU, which says how many entries its factors have (0 before there are any).
template <class Matrix>
struct klu_solver : Eigen::KLU<Matrix> {
    double entries_of_factors() const {
        return this->m_numeric ? double(this->m_numeric->lnz) + double(this->m_numeric->unz) : 0.0;
    }
};

/// Linear solvers of a sparse problem by SuiteSparse's KLU (block triangular form, made for circuits and
/// other very sparse systems) instead of Eigen's SparseLU; in double only. A problem asks for them with
///
///     using linear_solver = stagecraft::klu_blocks;
///
/// or is given them by with_linear_solver<klu_blocks>(problem) of problem/with.hpp. Needs klu.h in the
/// include path (Debian: libsuitesparse-dev, /usr/include/suitesparse) and -lklu.
using klu_blocks = sparse_blocks<double, klu_solver<Eigen::SparseMatrix<double>>,
                                 klu_solver<Eigen::SparseMatrix<std::complex<double>>>>;

}  // namespace stagecraft
