// SPDX-License-Identifier: BSL-1.0
// The examples and pictures of R. Maerz, "Numerik gewoehnlicher Differentialgleichungen" (lecture notes),
// chapters 1 to 3, computed: cmake --build build --target lecture, then build/lecture --all --svg DIRECTORY.
#include "program.hpp"

int main(int argc, char** argv) {
    using namespace lecture;
    return program(argc, argv,
                   "Chapters 1 to 3 of the lecture: its pictures, and a table of what it prints, what comes "
                   "out here and "
                   "what theory says.",
                   {{"1", chapter_1}, {"2", chapter_2}, {"3", chapter_3}});
}
