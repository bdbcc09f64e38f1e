// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE dense_output
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <problems/equations.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/solution.hpp>
#include <stagecraft/radau_iia_variable.hpp>
#include <vector>

namespace sc = stagecraft;

namespace {

// The largest errors of u and u', component by component, over [0, 1] between the ends of the steps.
template <int N>
struct errors {
    Eigen::Matrix<double, N, 1> value, slope;
};

template <int Stages, int N, class Problem, class Exact>
errors<N> measure(const Problem& problem, double h, Exact&& exact) {
    using vector = Eigen::Matrix<double, N, 1>;
    sc::solution<vector> u;
    const auto r = sc::integrate(sc::radau_iia<Stages>(), problem, exact(0.0).value, 0, 1,
                                 {.rtol = 1e-14, .atol = 1e-14, .fixed_step = h}, u);
    BOOST_REQUIRE(r.ok());
    errors<N> worst{vector::Zero(), vector::Zero()};
    for (int k = 1; k < 16 * u.steps(); ++k) {
        const double t = k * h / 16;
        const errors<N> e = exact(t);
        worst.value = worst.value.cwiseMax((u(t) - e.value).cwiseAbs());
        worst.slope = worst.slope.cwiseMax((u.derivative(t) - e.slope).cwiseAbs());
    }
    return worst;
}

// Observed orders between two step sizes against those expected of each component's value; slopes have one
// less.
template <int Stages, int N, class Problem, class Exact>
void check(const Problem& problem, Exact&& exact, const std::array<int, N>& expected, double h) {
    const auto coarse = measure<Stages, N>(problem, h, exact),
               fine = measure<Stages, N>(problem, h / 2, exact);
    for (int i = 0; i < N; ++i) BOOST_TEST_CONTEXT("s = " << Stages << ", component " << i) {
            BOOST_TEST(std::abs(std::log2(coarse.value[i] / fine.value[i]) - expected[i]) < 0.15);
            BOOST_TEST(std::abs(std::log2(coarse.slope[i] / fine.slope[i]) - (expected[i] - 1)) < 0.15);
        }
}

// Each component a e^(k t).
template <int N>
auto exponentials(const std::array<double, N>& k) {
    return [k](double t) {
        errors<N> e;
        for (int i = 0; i < N; ++i) e.value[i] = std::exp(k[i] * t), e.slope[i] = k[i] * e.value[i];
        return e;
    };
}

// y' = y z, 0 = y^2 - z^2 (index 1): y = z = 1 / (1 - t / 2) with y' = y z / 2.
struct index_one {
    template <class S>
    void operator()(const S&, const Eigen::Matrix<S, 2, 1>& y, Eigen::Matrix<S, 2, 1>& f) const {
        f[0] = y[0] * y[1] / 2;
        f[1] = y[0] * y[0] - y[1] * y[1];
    }
    Eigen::DiagonalMatrix<double, 2> mass() const { return Eigen::DiagonalMatrix<double, 2>(1, 0); }
};

}  // namespace

// The polynomial of degree s interpolates stages of order s + 1 (index 1), whose z lie on the constraint.
BOOST_AUTO_TEST_CASE(continuous_output_of_index_1_has_order_s_plus_1_in_y_and_z) {
    const auto exact = [](double t) {
        const double v = 1 / (1 - t / 2);
        return errors<2>{{v, v}, {v * v / 2, v * v / 2}};
    };
    check<2, 2>(index_one{}, exact, {3, 3}, 1. / 64);
    check<3, 2>(index_one{}, exact, {4, 4}, 1. / 64);
}

// Stage orders of Radau IIA for index 2: s + 1 in y, s in z (HLR89, section 4), and so is the polynomial.
BOOST_AUTO_TEST_CASE(continuous_output_of_index_2_has_order_s_plus_1_in_y_and_s_in_z) {
    check<2, 3>(equations::index_two{}, exponentials<3>({1, -2, 2}), {3, 3, 2}, 1. / 64);
    check<3, 3>(equations::index_two{}, exponentials<3>({1, -2, 2}), {4, 4, 3}, 1. / 64);
}

// For index 3: s + 1, s, s - 1 in y, z, u.
BOOST_AUTO_TEST_CASE(continuous_output_of_index_3_loses_an_order_with_each_level) {
    check<3, 5>(equations::index_three{}, exponentials<5>({2, -1, 2, -1, 1}), {4, 4, 3, 3, 2}, 1. / 32);
}

namespace {

// What was seen in the middle of a step, and the continuous solution to be asked for it again.
struct copied_step {
    double t, value;
    std::function<Eigen::Matrix<double, 1, 1>(double)> u;
};

// y' = -y. Not inlined: the run and all it held are gone when it returns.
template <class Method>
[[gnu::noinline]] std::vector<copied_step> copied_steps(const Method& method) {
    using vector = Eigen::Matrix<double, 1, 1>;
    std::vector<copied_step> kept;
    sc::integrate(
        method, [](double, const auto& y, auto& f) { f[0] = -y[0]; }, vector(1.0), 0, 1,
        {.rtol = 1e-6, .atol = 1e-6},
        [&](double t, const vector&, double h, const auto& output) {
            const double middle = t - h / 2;
            kept.push_back({middle, output(middle)[0], output});
        });
    return kept;
}

[[gnu::noinline]] void overwrite_the_stack() {
    volatile double numbers[20000];
    for (auto& x : numbers) x = 1e300;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_copied_output_is_as_good_after_the_run_as_within_it) {
    for (const auto& kept :
         {copied_steps(sc::radau_iia<3>()), copied_steps(sc::radau_iia_variable<2, 3>())}) {
        overwrite_the_stack();
        BOOST_TEST(kept.size() > 1u);
        for (const auto& k : kept) {
            BOOST_TEST(k.u(k.t)[0] == k.value);
            BOOST_TEST(std::abs(k.value - std::exp(-k.t)) < 1e-4);
        }
    }
}
