// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE growth
#include <boost/test/unit_test.hpp>

#include <initializer_list>

#include <stagecraft/judge/guards/growth_watch.hpp>

// Growth that a step would pass over, on matrices alone: what is proved not to grow, what is seen, and what is left alone.

namespace sc = stagecraft;
using Eigen::VectorXd;

namespace {

/// y' = J y, J by rows.
struct linear {
    static constexpr bool structured = false;
    struct sums_type {
        static constexpr bool complete = true;
    };
    using mass_type = sc::identity_mass;
    Eigen::MatrixXd J;

    linear(int n, std::initializer_list<double> rows)
        : J(Eigen::Map<const Eigen::Matrix<double, -1, -1, Eigen::RowMajor>>(rows.begin(), n, n)) {}
    int size() const { return static_cast<int>(J.rows()); }
    const Eigen::MatrixXd& jacobian() const { return J; }
    static mass_type mass() { return {}; }
};

/// The real system of the stages: its shift gamma/h, and the sign of its determinant.
struct factored {
    static constexpr bool knows_determinant = true;
    double shift;
    int sign;
    int determinant_sign() const { return sign; }
    double growth_shift() const { return shift; }
};

bool proved(const linear& f, double rate, double towards = 1) {
    sc::growth_bound<double> bound;
    return bound.holds(f.J.data(), f.size(), towards, rate);
}
bool sees(const linear& f, const factored& stages, const VectorXd& slope) {
    sc::growth_watch<double> watch;
    return watch.sees(f, stages, [&]() -> const VectorXd& { return slope; });
}
/// A step of size h from where f is `slope`; the tolerance is 1e-6.
bool sees_in(const linear& f, const VectorXd& slope, double h) {
    sc::growth_watch<double> watch;
    return watch.sees_in(
        f, [&]() -> const VectorXd& { return slope; }, VectorXd::Constant(f.size(), 1e6).eval(), h);
}
const double real_pole = 3.6378;  // the real pole of Radau IIA with three stages

}  // namespace

BOOST_AUTO_TEST_CASE(logarithmic_norms_prove_that_diffusion_and_chains_do_not_grow) {
    const linear diffusion(3, {-2, 1, 0, 1, -2, 1, 0, 1, -2});
    BOOST_TEST(proved(diffusion, 0));
    BOOST_TEST(!proved(diffusion, 0, -1));  // backwards it does
    const linear chain(3, {-5, 0, 0, 5, -1, 0, 0, 1, 0});
    BOOST_TEST(proved(chain, 0));  // by its columns: nothing is made
    const linear fed(2, {-1, 100, 0, -1});
    BOOST_TEST(proved(fed, 0.5));  // in a norm with weights
    BOOST_TEST(!proved(fed, -2));
    BOOST_TEST(!proved(linear(2, {-1, 2, 2, -1}), 0.5));  // has the eigenvalue 1
    BOOST_TEST(proved(linear(2, {-1, 2, 2, -1}), 1));
}

BOOST_AUTO_TEST_CASE(the_energy_proves_that_a_structure_only_oscillates) {
    const linear spring(2, {0, 1, -100, 0});
    BOOST_TEST(proved(spring, 0.01));
    BOOST_TEST(proved(spring, 0.01, -1));
    BOOST_TEST(!proved(linear(2, {0, 1, 100, 0}), 0.01));      // a pendulum upside down
    BOOST_TEST(!proved(linear(2, {0, 1, -100, 1}), 0.01));     // damping of the wrong sign
    BOOST_TEST(proved(linear(2, {0, 1, -100, 1}), 0.01, -1));  // which backwards is the right one
    const linear two(4, {0, 0, 1, 0, 0, 0, 0, 1, -30, 10, 0, 0, 20, -40, 0, 0});
    BOOST_TEST(proved(two, 0.01));  // masses 2 : 1 make the stiffness symmetric
}

BOOST_AUTO_TEST_CASE(an_eigenvalue_beyond_the_pole_changes_the_sign_of_the_determinant) {
    const linear ignition(1, {10});
    const VectorXd small = VectorXd::Constant(1, 1e-9), none = VectorXd::Zero(1);
    BOOST_TEST(sees(ignition, {real_pole / 1, -1}, small));
    BOOST_TEST(!sees(ignition, {real_pole / 0.1, 1}, small));  // a step that follows it
    BOOST_TEST(!sees(ignition, {real_pole / 1, -1}, none));    // nothing to begin with
    BOOST_TEST(!sees(ignition, {-real_pole / 1, -1}, small));  // backwards it decays
    BOOST_TEST(sees(linear(1, {-10}), {-real_pole / 1, 1}, small));
    // An even number of them leaves the sign as it is.
    BOOST_TEST(!sees(linear(2, {10, 0, 0, 10}), {real_pole / 1, 1}, VectorXd::Constant(2, 1e-9)));
    // Nothing leads to the component that would grow.
    const linear absent(2, {10, 0, 0, -1}), fed(2, {10, 1, 0, -1});
    const VectorXd second_moves = (VectorXd(2) << 0, 1e-9).finished();
    BOOST_TEST(!sees(absent, {real_pole / 1, -1}, second_moves));
    BOOST_TEST(sees(fed, {real_pole / 1, -1}, second_moves));
}

BOOST_AUTO_TEST_CASE(pairs_and_spirals_are_found_by_powers_where_nothing_moves_by_the_tolerance) {
    const VectorXd small = VectorXd::Constant(2, 1e-10), large = VectorXd::Constant(2, 1e-3);
    const linear pair(2, {10, 0, 0, 10}), spiral(2, {5, -10, 10, 5});
    BOOST_TEST(sees_in(pair, small, 1));
    BOOST_TEST(sees_in(spiral, small, 1));
    BOOST_TEST(!sees_in(spiral, small, 1e-3));  // it does not change within the step
    BOOST_TEST(!sees_in(spiral, large, 1));     // it moves: the error estimate sees it
    BOOST_TEST(!sees_in(spiral, VectorXd::Zero(2), 1));
    BOOST_TEST(!sees_in(spiral, small, -1));  // backwards it decays
    BOOST_TEST(sees_in(linear(2, {-5, -10, 10, -5}), small, -1));
    // Decay that is far from normal: no norm above proves it, the powers show it.
    const linear swirl(2, {-1, 30, -10, -1});
    BOOST_TEST(!proved(swirl, 0.25));
    BOOST_TEST(!sees_in(swirl, small, 1));
}
