// SPDX-License-Identifier: BSL-1.0
// says: partitioned(first, second): both must be tableaux of the same scalar type, lobatto_iiia<3>() with its parentheses
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/partitioned.hpp>

using Eigen::Vector4d, stagecraft::gauss, stagecraft::partitioned;

const auto pair = partitioned(gauss<2>, gauss<2>);
