// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE bvp_reference
#include <boost/test/unit_test.hpp>

#include "end_values.hpp"
#include "reference.hpp"

// The systems of two equations of data/bvp.json.

namespace {

// All of them as one type, so that the solver is instantiated once.
struct equations {
    std::string kind;
    double p;

    template <class T, class Y>
    void operator()(const T& t, const Y& y, Y& f) const {
        using std::cos;
        using std::exp;
        using std::sin;
        using std::sinh;
        f[0] = y[1];
        if (kind == "bratu") f[1] = -p * exp(y[0]);
        if (kind == "troesch") f[1] = p * sinh(p * y[0]);
        if (kind == "t1") f[1] = y[0] / p;
        if (kind == "t7")
            f[1] = (y[0] - t * y[1] - pi * t * sin(pi * t) - (1 + pi * pi * p) * cos(pi * t)) / p;
        if (kind == "t20") f[1] = (1 - y[1] * y[1]) / p;
        if (kind == "t30") f[1] = (y[0] - y[0] * y[1]) / p;
        if (kind == "sb") f[1] = 110 * y[0] + y[1];
    }
};

auto boundary_values(const std::string& kind, double p) {
    const auto shock = [p](double x) {
        return 1 + p * (std::abs(x) / p + std::log1p(std::exp(-2 * std::abs(x) / p)) - std::log(2.0));
    };
    if (kind == "troesch") return end_values{0, 1};
    if (kind == "t1") return end_values{1, 0};
    if (kind == "t7") return end_values{-1, 1};
    if (kind == "t20") return end_values{shock(0.745), shock(0.255)};
    if (kind == "t30") return end_values{-7.0 / 6, 1.5};
    if (kind == "sb") return end_values{1, 1};
    return end_values{0, 0};
}

// The stated guesses: zero, or the line through the boundary values.
auto guess(const std::string& kind, const end_values& e) {
    return [line = kind == "troesch" || kind == "t20" || kind == "t30", e](double t) {
        return line ? Eigen::Vector2d(e.left + (e.right - e.left) * t, e.right - e.left)
                    : Eigen::Vector2d(0, 0);
    };
}

}  // namespace

BOOST_AUTO_TEST_CASE(answers_are_within_the_tolerance_and_their_error_is_known) {
    for (const auto& reference : problems::boundary_value_cases()) {
        const std::string& name = reference.name;
        const std::string kind = name.substr(0, name.find('_'));
        if (reference.equations != 2) continue;
        if (name == "t20_1e-3") continue;  // not from this guess
        const double p = reference.p;
        const end_values values = boundary_values(kind, p);
        BOOST_TEST_CONTEXT(name) {
            // In t7_1e-8 the rounding errors of the sum on the right, times 1e8, leave 1e-8 in y' near the layer (not in y).
            for (const double tolerance : {1e-5, name == "t7_1e-8" ? 1e-7 : 1e-10})
                check(reference, tolerance,
                      sc::solve_bvp(sc::gauss<5>(), sc::two_point(equations{kind, p}, values), reference.a,
                                    reference.b, guess(kind, values), {.rtol = tolerance}));
        }
    }
}
