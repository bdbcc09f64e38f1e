// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE concrete_state
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/dae/projection.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/problem/semi_explicit.hpp>

namespace sc = stagecraft;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

template <class Problem, class Scalar = double, int N = 2>
constexpr bool generic(const Problem&) {
    return sc::automatically_differentiable<Problem, Scalar, N>;
}

struct overloaded {
    void operator()(double, const Vector2d& y, Vector2d& f) const { f = -y; }
    template <class F>
    void operator()(double, const VectorXd& y, F& f) const {
        f = -y;
    }
};

struct both {
    void operator()(double, const Vector2d& y, Vector2d& f) const { f = -y; }
    void operator()(const auto&, const auto& y, auto& f) const { f = -y; }
};

struct last final {
    void operator()(const auto&, const auto& y, auto& f) const { f = -y; }
};

const auto decay = [](double, const VectorXd& y, auto& f) { f = -y; };

}  // namespace

BOOST_AUTO_TEST_CASE(generic_is_what_takes_dual_numbers_without_a_conversion) {
    // None of these is called, and `f = -y` would not compile with f of dual numbers and y of numbers.
    static_assert(!generic(decay));
    static_assert(!generic([](auto, const VectorXd& y, auto& f) { f = -y; }));
    static_assert(!generic([](const auto&, VectorXd y, auto&& f) { f = -y; }));
    static_assert(!generic([](double, const Vector2d& y, auto& f) mutable { f = -y; }));
    static_assert(!generic<decltype(decay), long double, Eigen::Dynamic>(decay));
    static_assert(!generic(overloaded{}));
    static_assert(!generic(+[](double, const Vector2d& y, Vector2d& f) { f = -y; }));

    static_assert(generic([](const auto&, const auto& y, auto& f) { f = -y; }));
    static_assert(generic([](auto, auto y, auto& f) { f = -y; }));
    static_assert(generic([](double, const auto& y, auto& f) { f = -y; }));
    static_assert(generic([](int, auto&& y, auto&& f) { f = -y; }));
    static_assert(generic([](const auto&, const auto& y, auto& f) mutable { f = -y; }));
    static_assert(generic([]<class Y>(double, const Eigen::MatrixBase<Y>& y, auto& f) { f = -y; }));
    static_assert(
        generic([]<class S>(const S&, const Eigen::Vector2<S>& y, Eigen::Vector2<S>& f) { f = -y; }));
    static_assert(generic(both{}));
    static_assert(generic(last{}));
    const auto in_double_time = [](double, const auto& y, auto& f) { f = -y; };
    static_assert(generic<decltype(in_double_time), long double>(in_double_time));
}

BOOST_AUTO_TEST_CASE(
    a_right_hand_side_of_plain_states_that_writes_anything_is_differentiated_by_differences) {
    const auto r = sc::integrate(sc::radau_iia<3>(), decay, VectorXd(VectorXd::Ones(1)), 0, 1);
    BOOST_TEST(r.ok());
    BOOST_TEST((r.report.found.jacobian == sc::jacobian_source::differences));
    BOOST_TEST(std::abs(r.y[0] - std::exp(-1.0)) < 1e-5);
}

BOOST_AUTO_TEST_CASE(so_are_both_parts_of_semi_explicit_systems) {
    using one = Eigen::Matrix<double, 1, 1>;
    const auto f = [](double, const one& y, const auto& z, auto& out) { out[0] = z[0] - 2 * y[0]; };
    const auto g = [](double, const auto& y, const one& z, auto& out) { out[0] = z[0] - y[0]; };
    const auto r = sc::integrate(sc::radau_iia<3>(), sc::semi_explicit<1, 1>(f, g), Vector2d(1, 1), 0, 1);
    BOOST_TEST(r.ok());
    BOOST_TEST((r.report.found.jacobian == sc::jacobian_source::differences));
    BOOST_TEST(std::abs(r.y[0] - std::exp(-1.0)) < 1e-5);
}

BOOST_AUTO_TEST_CASE(so_are_boundary_value_problems) {
    const auto f = [](double, const Vector2d& y, auto& out) {
        out[0] = y[1];
        out[1] = y[0];
    };
    const auto ends = [](const Vector2d& left, const Vector2d& right, auto& r) {
        r[0] = left[0] - 1;
        r[1] = right[0];
    };
    const auto r =
        sc::solve_bvp(sc::gauss<3>(), sc::two_point(f, ends), 0, 1, Vector2d(0, 0), {.rtol = 1e-6});
    BOOST_TEST(r.ok());
    BOOST_TEST(std::abs(r.y(0.5)[0] - std::sinh(0.5) / std::sinh(1.0)) < 1e-6);
}

BOOST_AUTO_TEST_CASE(so_are_invariants_which_may_be_written_into_a_vector_of_run_time_size) {
    const auto circle = [](double, const VectorXd& y, VectorXd& f) {
        f[0] = y[1];
        f[1] = -y[0];
    };
    const auto length = [](double, const VectorXd& y, auto& g) { g[0] = y.squaredNorm() - 1; };
    const auto of_run_time_size = [](double, const VectorXd& y, VectorXd& g) { g[0] = y.squaredNorm() - 1; };
    const VectorXd y0 = Vector2d(0, 1);
    const auto run = [&](auto g) {
        auto keep = sc::projection_onto<1>(g);
        const auto r = sc::integrate(sc::radau_iia<3>(), circle, y0, 0, 10, {}, keep);
        BOOST_TEST(r.ok());
        BOOST_TEST(keep.corrections() > 0);
        BOOST_TEST(std::abs(r.y.norm() - 1) < 1e-14);
        BOOST_TEST(std::abs(r.y[0] - std::sin(10.0)) < 1e-3);
    };
    run(length);
    run(of_run_time_size);
}
