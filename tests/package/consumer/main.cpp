// SPDX-License-Identifier: BSL-1.0
#include <stagecraft/tableau.hpp>
#include <stagecraft/tableaux/nodal.hpp>

#ifdef WITH_theory
#include <stagecraft/theory/statements/verdict.hpp>
#endif

int stages_of_an_exact_tableau();
bool says_why();

int main() {
    stagecraft::tableau<double, 2> heun;
    heun.b << 0.5, 0.5;
    const stagecraft::tableaux::nodal_polynomial gauss(stagecraft::tableaux::family::gauss, 2);
    return heun.stages() == stages_of_an_exact_tableau() && gauss.degree() == 2 && says_why() ? 0 : 1;
}
