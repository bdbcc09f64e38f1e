// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/family.hpp>
#include <stagecraft/tableaux/partitioned_file.hpp>
#include <stagecraft/tableaux/read.hpp>
#include <stagecraft/tableaux/tableau_file.hpp>
#include <stagecraft/theory/plot/pictures.hpp>
#include <stagecraft/theory/stability/a_stability.hpp>

#include <optional>
#include <string>
#include <vector>

namespace stagecraft::theory::plot {

/// A method as the pictures need it.
struct subject {
    std::string name;
    rational_function r;
    std::optional<star> order_star;    ///< nothing where rounding hides the difference to the exponential
    std::vector<double> e_polynomial;  ///< coefficients of E(y), ascending
    std::string r_text;                ///< "R(z) = ...", empty where it is too long for a title
    std::string e_text;                ///< "E(y) = ..."
    cells tableau;
};

/// The s-stage member of a family: R exactly from Legendre coordinates, the tableau in doubles. Throws
/// std::invalid_argument where the family has none.
subject subject_of_family(tableaux::family f, int s);

/// The method of a tableau file: R exactly over Q or Q(sqrt d) where the data lie there, and of the middles
/// of rounded or enclosed data otherwise.
subject subject_of_file(const tableaux::tableau_file& file);

/// A Rosenbrock or W method in the same way, with no cells: R is that of beta = alpha + Gamma and b. Throws std::invalid_argument for
/// other methods of several tableaux.
subject subject_of_file(const tableaux::partitioned_file& file);

}  // namespace stagecraft::theory::plot

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/plot/method_data-inl.hpp"
#endif
