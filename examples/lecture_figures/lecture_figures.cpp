// SPDX-License-Identifier: BSL-1.0
// The figures on p. 40 and 41 of the lecture notes (section 2.2): stability functions against
// e^z on the real axis, and min(1, |R|) of the explicit Euler method, the implicit Euler method and the
// trapezoidal rule. The functions come from the tableaux. Usage: lecture_figures [FOLDER]
#include <stagecraft/tableaux/rational.hpp>
#include <stagecraft/theory/plot/pictures.hpp>

#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace {

using namespace stagecraft;
using tableaux::rational;
namespace plot = theory::plot;

tableau<rational> method(const std::vector<std::vector<rational>>& A, const std::vector<rational>& b) {
    tableau<rational> t;
    const int s = static_cast<int>(b.size());
    t.A.resize(s, s);
    t.b.resize(s);
    t.c.resize(s);
    for (int i = 0; i < s; ++i) {
        t.b(i) = b[i];
        t.c(i) = rational(0);
        for (int j = 0; j < s; ++j) {
            t.A(i, j) = A[i][j];
            t.c(i) += A[i][j];
        }
    }
    return t;
}

plot::named_function stability_function(const std::string& name, const tableau<rational>& t) {
    const auto r = theory::stability_function_of(t);
    std::cout << name << ": R(z) = " << r.text() << '\n';
    return {name, plot::in_doubles(r)};
}

}  // namespace

int main(int argc, char** argv) try {
    const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
    std::filesystem::create_directories(folder);
    const rational half(1, 2);
    const auto explicit_euler = stability_function("explicit Euler", method({{0}}, {1}));
    const auto implicit_euler = stability_function("implicit Euler", method({{1}}, {1}));
    const auto trapezoidal =
        stability_function("trapezoidal rule", method({{0, 0}, {half, half}}, {half, half}));

    const auto draw = [&](const plot::script& picture, const std::string& name) {
        plot::draw(picture, folder / name);
        std::cout << "wrote " << (folder / name).string() << '\n';
    };
    draw(plot::real_axis_picture({explicit_euler, implicit_euler, trapezoidal}, -5, 3, -3, 6),
         "p40_real_axis.svg");
    const plot::window lecture{-8, 1, -4, 4}, wide{-80, 80, -80, 80};
    draw(plot::grey_picture(explicit_euler.name, explicit_euler.r, lecture), "p41_explicit_euler.svg");
    draw(plot::grey_picture(implicit_euler.name, implicit_euler.r, lecture), "p41_implicit_euler.svg");
    draw(plot::grey_picture(trapezoidal.name, trapezoidal.r, lecture), "p41_trapezoidal_rule.svg");
    draw(plot::grey_picture(trapezoidal.name, trapezoidal.r, wide), "p41_trapezoidal_rule_wide.svg");
} catch (const std::exception& e) {
    std::cerr << "lecture_figures: " << e.what() << '\n';
    return 2;
}
