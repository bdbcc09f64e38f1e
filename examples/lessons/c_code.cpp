// SPDX-License-Identifier: BSL-1.0
// A method as C code: read exactly, rounded once, and printed in hexadecimal, which every compiler reads to the same bits.
#include <cstdio>
#include <stagecraft/tableaux/read.hpp>
#include <stagecraft/tableaux/tableau_from_file.hpp>

void print_array(const char* name, const auto& x) {
    std::printf("static const double %s", name);
    if (x.cols() > 1) std::printf("[%d]", static_cast<int>(x.rows()));
    std::printf("[%d] = {", static_cast<int>(x.cols() > 1 ? x.cols() : x.rows()));
    for (Eigen::Index i = 0; i < x.rows(); ++i) {
        if (x.cols() > 1) std::printf("%s\n    {", i ? "," : "");
        for (Eigen::Index j = 0; j < x.cols(); ++j)
            std::printf("%s%a", (x.cols() > 1 ? j : i) ? ", " : "", x(i, j));
        if (x.cols() > 1) std::printf("}");
    }
    std::puts("};");
}

int main() {
    const auto file = stagecraft::tableaux::read_tableau_file("own_tableau.json");
    const auto method = stagecraft::tableaux::rounded(file);
    std::printf("/* %s */\n", file.name.c_str());
    print_array("A", method.A);
    print_array("b", method.b);
    print_array("b_embedded", method.b_embedded);
    print_array("c", method.c);
}
