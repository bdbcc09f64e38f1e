// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

namespace stagecraft::theory {

/// The weighted residuals (elementary weight - 1/gamma)/sigma of the first order with some that are not 0
/// (Hairer-Norsett-Wanner I.II.3, Theorem 3.2; the norms are those of Prince and Dormand 1981).
struct principal_error {
    int order = 0;
    std::string norm;     ///< their 2-norm
    std::string largest;  ///< the largest in size
};

/// "principal error, of order 5: 2-norm 0.00433, largest 0.00231".
std::string text(const principal_error& e);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/principal_error-inl.hpp"
#endif
