// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/linear/petsc.hpp>

/// A distributed problem with one matrix for all its runs, which counts what they cost.
template <class Problem>
struct petsc_counted : Problem {
    using Problem::Problem;
    stagecraft::petsc_matrix J = Problem::matrix();
    stagecraft::petsc_matrix matrix() const { return J; }
};
