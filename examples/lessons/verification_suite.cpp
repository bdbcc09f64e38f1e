// SPDX-License-Identifier: BSL-1.0
// A verification suite for a code that is not yours: it reads the tables that the code computes with and asks
// whether they can be the method that they claim to be, to the last bit of a double.
#include <iostream>
#include <stagecraft/tableaux/entry.hpp>
#include <stagecraft/theory/models/matrix_model.hpp>
#include <stagecraft/theory/statements/certainty.hpp>
#include <stagecraft/theory/trees/tree_order.hpp>
#include <stagecraft/theory/trees/tree_text.hpp>

namespace their_code {  // in your suite: #include "their_code.h"
const double a[4][4] = {{}, {1 / 2.}, {0, 3 / 4.}, {2 / 9., 1 / 3., 4 / 9.}};
const double b[4] = {2 / 9., 1 / 3., 4 / 9., 0}, b_hat[4] = {7 / 24., 1 / 4., 1 / 3., 1 / 8.};
}  // namespace their_code

using namespace stagecraft;
using tableaux::ball;  // a number with a bound: here a double, give or take half a unit in its last place
ball enclosed(double x) { return theory::to_ball(tableaux::entry_from_double(x).enclosure); }

bool check(const char* name, const double (&a)[4][4], const double (&b)[4], int order) {
    tableau<ball> t;
    t.A.resize(4, 4), t.b.resize(4), t.c.resize(4);
    for (int i = 0; i < 4; ++i) {
        t.b(i) = enclosed(b[i]), t.c(i) = 0;
        for (int j = 0; j < 4; ++j) t.A(i, j) = enclosed(a[i][j]), t.c(i) += t.A(i, j);
    }
    const auto failing = theory::failing_conditions(theory::matrix_model(t), order);
    std::cout << name << (failing.empty() ? ": consistent with" : ": not of") << " order " << order << '\n';
    for (const auto& f : failing) std::cout << "  fails: " << theory::condition_text(f.tree) << '\n';
    return failing.empty();
}

int main() {
    using namespace their_code;
    bool good = check("b", a, b, 3) & check("b_hat", a, b_hat, 2);
    double wrong[4][4] = {
        {}, {1 / 2.}, {0, 0.7500000000000002}, {2 / 9., 1 / 3., 4 / 9.}};  // two units too much
    good &= !check("a mistyped", wrong, b, 3);
    return good ? 0 : 1;
}
