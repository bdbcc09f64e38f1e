// SPDX-License-Identifier: BSL-1.0
// says: partitioned(first, second): both tableaux must have the same number of stages
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/partitioned.hpp>

using Eigen::Vector4d, stagecraft::gauss, stagecraft::partitioned;

const auto pair = partitioned(gauss<2>(), gauss<3>());
