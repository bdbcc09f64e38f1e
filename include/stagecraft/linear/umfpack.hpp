// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/SparseCore>
#include <Eigen/UmfPackSupport>
#include <complex>

#include <stagecraft/linear/sparse_blocks.hpp>

namespace stagecraft {

/// Linear solvers of a sparse problem by SuiteSparse's UMFPACK (multifrontal, for systems with much fill,
/// such as discretised partial differential equations in two and three dimensions) instead of Eigen's
/// SparseLU; in double only. A problem asks for them with
///
///     using linear_solver = stagecraft::umfpack_blocks;
///
/// or is given them by with_linear_solver<umfpack_blocks>(problem) of problem/with.hpp. Needs umfpack.h in
/// the include path (Debian: libsuitesparse-dev, /usr/include/suitesparse) and -lumfpack.
using umfpack_blocks = sparse_blocks<double, Eigen::UmfPackLU<Eigen::SparseMatrix<double>>,
                                     Eigen::UmfPackLU<Eigen::SparseMatrix<std::complex<double>>>>;

}  // namespace stagecraft
