// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <stdexcept>

#include <stagecraft/method/partitioned_method.hpp>

namespace stagecraft {

/// A pair of the form of Lobatto IIIA and IIIB for holonomic systems. Made by spark().
template <class Scalar, int Stages = dynamic>
struct spark_method {
    using scalar = Scalar;
    static constexpr int stages_at_compile_time = Stages;
    partitioned_method<Scalar, Stages> pair;
};

namespace detail {

/// std::invalid_argument where constraints of position at the stages 2, ..., s do not determine the multipliers of
/// 1, ..., s - 1: the form of IIIA and IIIB does (Jay 1996).
template <class Scalar, int Stages>
void check_spark(const partitioned_method<Scalar, Stages>& m) {
    const int s = m.stages();
    bool good = s > 1;
    for (int j = 0; j < s && good; ++j)
        good = m.first.A(0, j) == Scalar(0) && m.first.A(s - 1, j) == m.first.b[j] &&
               m.second.A(j, s - 1) == Scalar(0) && m.first.b[j] == m.second.b[j] &&
               !(m.first.b[j] == Scalar(0));
    if (!good)
        throw std::invalid_argument(
            "spark: the tableaux must have the form of Lobatto IIIA (first row zero, last row b) and IIIB "
            "(last "
            "column zero) of the same b: spark(lobatto_iiia<2>(), lobatto_iiib<2>()), say");
}

}  // namespace detail

}  // namespace stagecraft
