// SPDX-License-Identifier: BSL-1.0
// The second translation unit: headers included twice must link once.
#include <stagecraft/tableau.hpp>
#include <stagecraft/tableaux/rational.hpp>

int stages_of_an_exact_tableau() {
    stagecraft::tableau<stagecraft::tableaux::rational> trapezoidal;
    trapezoidal.b.setConstant(2, stagecraft::tableaux::rational(1, 2));
    return trapezoidal.stages();
}
