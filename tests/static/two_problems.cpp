// SPDX-License-Identifier: BSL-1.0
// Two boundary value problems of the same size. Whatever is compiled for the second one alone has its name in its own:
// tests/static/second_problem adds that up.
#include <cstdio>
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/coefficients/gauss.hpp>

using Eigen::Vector2d;

struct first_problem {  // Troesch: y'' = 10 sinh 10 y
    void operator()(double, const auto& y, auto& f) const {
        using std::sinh;
        f[0] = y[1], f[1] = 10 * sinh(10 * y[0]);
    }
};
struct second_problem {  // y'' = 2 y^3 + y'
    void operator()(double, const auto& y, auto& f) const {
        f[0] = y[1], f[1] = 2 * y[0] * y[0] * y[0] + y[1];
    }
};
struct ends_of_first_problem {
    void operator()(const auto& left, const auto& right, auto& r) const {
        r[0] = left[0], r[1] = right[0] - 1.0;
    }
};
struct ends_of_second_problem {
    void operator()(const auto& left, const auto& right, auto& r) const {
        r[0] = left[0] - 1.0, r[1] = right[0] - 0.5;
    }
};

static double middle_of_first_problem() {
    return stagecraft::solve_bvp(stagecraft::gauss<3>(),
                                 stagecraft::two_point(first_problem(), ends_of_first_problem()), 0.0, 1.0,
                                 Vector2d(0, 0))
        .y(0.5)[0];
}
[[gnu::noinline]] static double middle_of_second_problem() {
    return stagecraft::solve_bvp(stagecraft::gauss<3>(),
                                 stagecraft::two_point(second_problem(), ends_of_second_problem()), 0.0, 1.0,
                                 Vector2d(0, 0))
        .y(0.5)[0];
}

int main() { std::printf("%.6f %.6f\n", middle_of_first_problem(), middle_of_second_problem()); }
