// SPDX-License-Identifier: BSL-1.0
#include <stagecraft/tableau.hpp>

int stages_of_an_exact_tableau();

int main() {
    stagecraft::tableau<double, 2> heun;
    heun.b << 0.5, 0.5;
    return heun.stages() == stages_of_an_exact_tableau() ? 0 : 1;
}
