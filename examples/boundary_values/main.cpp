// SPDX-License-Identifier: BSL-1.0
// The experiments of R. Maerz, "Numerik gewoehnlicher Differentialgleichungen" (lecture notes), chapters 4 to 6, on
// boundary values: build/boundary_values --all --svg DIRECTORY.
#include "../lecture/program.hpp"
#include "experiments.hpp"

int main(int argc, char** argv) {
    using namespace boundary_values;
    return lecture::program(
        argc, argv,
        "Chapters 4 to 6 of the lecture: conditioning, periodic solutions, shooting and collocation, as a "
        "table of what it prints, what comes out here and what theory says.",
        {{"conditioning", conditioning},
         {"dichotomy", dichotomy},
         {"forced", forced_oscillation},
         {"cycle", limit_cycle},
         {"growth", stoer_bulirsch},
         {"segments", shooting_segments},
         {"modes", turning_modes},
         {"splines", splines},
         {"orders", orders},
         {"factorisation", factorisation},
         {"bifurcations", bifurcations}});
}
