// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/KLUSupport>
#include <Eigen/SparseCore>
#include <complex>

#include <stagecraft/linear/sparse_blocks.hpp>

namespace stagecraft {

/// Linear solvers of a sparse problem by SuiteSparse's KLU (block triangular form, made for circuits and
/// other very sparse systems) instead of Eigen's SparseLU; in double only. A problem asks for them with
///
///     using linear_solver = stagecraft::klu_blocks;
///
/// or is given them by with_linear_solver<klu_blocks>(problem) of problem/with.hpp. Needs klu.h in the
/// include path (Debian: libsuitesparse-dev, /usr/include/suitesparse) and -lklu.
using klu_blocks = sparse_blocks<double, Eigen::KLU<Eigen::SparseMatrix<double>>,
                                 Eigen::KLU<Eigen::SparseMatrix<std::complex<double>>>>;

}  // namespace stagecraft
