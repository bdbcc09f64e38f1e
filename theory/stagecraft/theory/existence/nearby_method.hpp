// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <stagecraft/tableaux/ball.hpp>
#include <stagecraft/theory/existence/order_system.hpp>
#include <string>
#include <vector>

namespace stagecraft::theory {

/// What is known of a method near given tables.
struct nearby_method {
    bool exists = false;                  ///< a zero of the equations that are solved is proved
    bool all_equations = false;           ///< and these are all of them
    std::vector<tableaux::ball> numbers;  ///< enclosures of its entries, as those of the sought_method
    std::size_t equations = 0, solved = 0, unknowns = 0;
    std::vector<std::string> not_solved;  ///< names of equations that depend on the others numerically
    tableaux::bound enclosed_to = 0;      ///< radius of the box in which the zero is, and is alone
    tableaux::bound left = 0;             ///< the largest residual of equations that are not solved
    tableaux::bound least_pivot = 0;      ///< of those solved, relative to the largest
    tableaux::bound next_pivot = 0;       ///< of those not solved
    tableaux::bound contraction = 0;      ///< of Krawczyk's operator on the box
    std::string why_not;                  ///< where there is none
};

/// A method that satisfies the equations, near the numbers as they are written, by Krawczyk's operator (Neumaier, Interval
/// Methods for Systems of Equations, 5.1) over enclosures of `digits` digits and some more.
///
/// Equations in one unknown that is affine in them are solved over Q first. Of the rest as many unknowns as there are
/// independent equations are solved for, those with the largest pivots of a QR decomposition; before, all move to about the
/// nearest zero in units of their rounding. Equations that depend on others numerically are left out and named. Cost: a decomposition in long double,
/// then `digits`/16 evaluations of the equations with so many digits.
nearby_method find_nearby(const order_system& system, int digits);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/existence/nearby_method-inl.hpp"
#endif
