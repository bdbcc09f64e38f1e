// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>

namespace stagecraft::tableaux {

/// What Eigen is told about a number class that is exact or carries its own error bound: signed, without a
/// rounding unit, with expensive operations. Eigen::NumTraits<T> derives from it.
template <class T>
struct number_traits : Eigen::GenericNumTraits<T> {
    enum { IsSigned = 1, ReadCost = 10, AddCost = 100, MulCost = 100 };
    static T epsilon() { return 0; }
    static T dummy_precision() { return 0; }
    static int digits10() { return 0; }
};

}  // namespace stagecraft::tableaux
