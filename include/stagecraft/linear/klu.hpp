// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/KLUSupport>
#include <Eigen/SparseCore>
#include <complex>
#include <type_traits>

#include <stagecraft/linear/one_factor_blocks.hpp>

namespace stagecraft {

/// Eigen's KLU, which factors with the pivots of the matrix before as long as they serve, and says how many entries
/// its factors have (0 before there are any).
template <class Matrix>
class klu_solver : public Eigen::KLU<Matrix> {
    using base = Eigen::KLU<Matrix>;

  public:
    /// Factors a matrix of the pattern analysed. Without the search for pivots, a third of the work, where those there
    /// are let no entry grow to more than a thousand times the largest one of its column (klu_rgrowth; KLU's own pivots
    /// are at least a thousandth of the largest candidate).
    void factorize(const Matrix& a) {
        if (!this->m_numeric || !factor_again(a)) base::factorize(a);
    }
    double entries_of_factors() const {
        return this->m_numeric ? double(this->m_numeric->lnz) + double(this->m_numeric->unz) : 0.0;
    }

  private:
    using number = typename Matrix::Scalar;

    bool factor_again(const Matrix& a) {
        // KLU, a library in C, does not write to these.
        int *outer = const_cast<int*>(a.outerIndexPtr()), *inner = const_cast<int*>(a.innerIndexPtr());
        double* values = reinterpret_cast<double*>(const_cast<number*>(a.valuePtr()));
        const auto succeeds = [&](auto f) {
            return f(outer, inner, values, this->m_symbolic, this->m_numeric, &this->m_common) != 0;
        };
        bool done;
        if constexpr (std::is_same_v<number, double>)
            done = succeeds(klu_refactor) && succeeds(klu_rgrowth);
        else
            done = succeeds(klu_z_refactor) && succeeds(klu_z_rgrowth);
        return done && this->m_common.rgrowth > 1e-3;
    }
};

/// Linear solvers of a sparse problem by SuiteSparse's KLU (block triangular form, made for circuits and
/// other very sparse systems) instead of Eigen's SparseLU; in double only. With much fill the systems of a step share one
/// real factorisation (one_factor_blocks.hpp). A problem asks for them with
///
///     using linear_solver = stagecraft::klu_blocks;
///
/// or is given them by with_linear_solver<klu_blocks>(problem) of problem/with.hpp. Needs klu.h in the
/// include path (Debian: libsuitesparse-dev, /usr/include/suitesparse) and -lklu.
using klu_blocks = one_factor_blocks<klu_solver<Eigen::SparseMatrix<double>>,
                                     klu_solver<Eigen::SparseMatrix<std::complex<double>>>>;

}  // namespace stagecraft
