// SPDX-License-Identifier: BSL-1.0
// The second translation unit: headers included twice must link once, in either form.
#include <stagecraft/tableau.hpp>
#include <stagecraft/tableaux/nodal.hpp>
#include <stagecraft/tableaux/rational.hpp>

#ifdef WITH_theory
#include <stagecraft/theory/statements/verdict.hpp>
#endif

#if defined(COMPILED) != defined(STAGECRAFT_COMPILED)
#error the exact part comes in the other form
#endif

int stages_of_an_exact_tableau() {
    using stagecraft::tableaux::rational;
    stagecraft::tableau<rational> trapezoidal;
    trapezoidal.b.setConstant(2, rational(1, 2));
    return trapezoidal.stages() + stagecraft::tableaux::nodal_polynomial::from_nodes({0, 1}).degree() - 2;
}

bool says_why() {
#ifdef WITH_theory
    return stagecraft::theory::verdict::proved("two nodes").text() == "proved: two nodes";
#else
    return true;
#endif
}
