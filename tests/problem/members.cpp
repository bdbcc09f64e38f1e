// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE members
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/event.hpp>
#include <stagecraft/observe/output_times.hpp>
#include <stagecraft/observe/solution.hpp>
#include <stagecraft/problem/found_sparsity.hpp>
#include <stagecraft/problem/fully_implicit.hpp>
#include <stagecraft/problem/semi_explicit.hpp>
#include <stagecraft/problem/with_domain.hpp>
#include <stagecraft/radau_iia_variable.hpp>
#include <string>
#include <vector>

#include "../message.hpp"

// What a problem may say of itself, or have found: a mass matrix that depends on the state, break points and a domain of the
// parts of a system, the pattern of its Jacobian; and that it has no components at all.

namespace sc = stagecraft;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

/// A capacitance 1 + v^2 that discharges: (1 + v^2) v' = -v, so that log v + v^2/2 + t is constant.
struct discharge {
    template <class T, class S>
    void operator()(const T&, const Eigen::Matrix<S, 2, 1>& y, Eigen::Matrix<S, 2, 1>& f) const {
        f = -y;
    }
    template <class T, class S>
    Eigen::Matrix<S, 2, 2> mass(const T&, const Eigen::Matrix<S, 2, 1>& y) const {
        Eigen::Matrix<S, 2, 2> M;
        M << S(1) + y[0] * y[0], S(0), S(0), S(1);
        return M;
    }
};
/// The same in doubles, of a size known when it runs.
struct discharge_of_doubles {
    void operator()(double, const VectorXd& y, VectorXd& f) const { f = -y; }
    MatrixXd mass(double, const VectorXd& y) const {
        return Vector2d(1 + y[0] * y[0], 1).asDiagonal().toDenseMatrix();
    }
};
double invariant(double t, double v) { return std::log(v) + v * v / 2 + t; }

/// y' = 1 before t = 1/2 and 2 behind; y may not exceed `most`.
struct switched {
    double most = 10;
    template <class T, class A, class B, class Out>
    void operator()(const T& t, const A&, const B& z, Out& out) const {
        out[0] = (t < 0.5 ? 1.0 : 2.0) * z[0];
    }
    std::vector<double> break_points() const { return {0.5}; }
    template <class T, class A, class B>
    bool domain(const T&, const A& y, const B&) const {
        return y[0] <= most;
    }
};
const auto unit = [](const auto&, const auto&, const auto& z, auto& out) { out[0] = z[0] - 1.0; };

/// F = v - (1 or 2), the same as one fully implicit equation.
struct switched_implicitly {
    double most = 10;
    template <class T, class A, class B, class Out>
    void operator()(const T& t, const A&, const B& v, Out& out) const {
        out[0] = v[0] - (t < 0.5 ? 1.0 : 2.0);
    }
    std::vector<double> break_points() const { return {0.5}; }
    template <class T, class A>
    bool domain(const T&, const A& y) const {
        return y[0] <= most;
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_mass_matrix_may_depend_on_the_state) {
    const auto by_hand = [](const auto&, const auto& y, auto& f) {
        f[0] = -y[0] / (1.0 + y[0] * y[0]);
        f[1] = -y[1];
    };
    for (const double tol : {1e-4, 1e-6, 1e-9}) {
        const sc::options<double> o{.rtol = tol, .atol = tol};
        const auto r = sc::integrate(sc::radau_iia<3>(), discharge{}, Vector2d(2, 1), 0, 3, o);
        const VectorXd y0 = Vector2d(2, 1);
        const auto d = sc::integrate(sc::radau_iia<3>(), discharge_of_doubles{}, y0, 0, 3, o);
        const auto e = sc::integrate(sc::radau_iia<3>(), by_hand, Vector2d(2, 1), 0, 3, o);
        BOOST_TEST((r.ok() && d.ok() && e.ok()));
        for (const double v : {r.y[0], d.y[0]})
            BOOST_TEST(std::abs(invariant(3, v) - invariant(0, 2)) < 10 * tol);
        BOOST_TEST(std::abs(r.y[1] - std::exp(-3.0)) < 10 * tol);
        // The steps are those of the explicit form, as its derivatives are.
        BOOST_TEST(r.report.steps == e.report.steps);
        BOOST_TEST(r.report.f == e.report.f);
        BOOST_TEST(d.report.steps <= 1.3 * e.report.steps);
    }
    struct singular : discharge_of_doubles {
        MatrixXd mass(double, const VectorXd&) const { return Vector2d(1, 0).asDiagonal().toDenseMatrix(); }
    };
    struct narrow : discharge_of_doubles {
        MatrixXd mass(double, const VectorXd&) const { return MatrixXd::Identity(1, 1); }
    };
    const VectorXd y0 = Vector2d(2, 1);
    BOOST_TEST(message([&] {
                   sc::integrate(sc::radau_iia<3>(), singular{}, y0, 0, 1);
               }).find("mass(t, y) is singular at y0") != std::string::npos);
    BOOST_TEST(message([&] {
                   sc::integrate(sc::radau_iia<3>(), narrow{}, y0, 0, 1);
               }).find("mass(t, y) must be n x n") != std::string::npos);
    struct farads : discharge_of_doubles {  // small is not singular
        MatrixXd mass(double, const VectorXd&) const {
            return Vector2d(1, 1e-30).asDiagonal().toDenseMatrix();
        }
        void operator()(double, const VectorXd& y, VectorXd& f) const { f = Vector2d(-y[0], -1e-30 * y[1]); }
    };
    BOOST_TEST(std::abs(sc::integrate(sc::radau_iia<3>(), farads{}, y0, 0, 1).y[1] - std::exp(-1.0)) < 1e-5);
    // A domain beside it is kept: v falls below 1 in time 0.693 + 1.5.
    const auto within = sc::with_domain(discharge{}, [](double, const Vector2d& y) { return y[0] >= 1; });
    const auto left = sc::integrate(sc::radau_iia<3>(), within, Vector2d(2, 1), 0, 3);
    BOOST_TEST(name(left.status) == "outside_domain");
    BOOST_TEST(std::abs(left.t - (std::log(2.0) + 1.5)) < 1e-5);
}

BOOST_AUTO_TEST_CASE(parts_of_a_system_hand_on_their_break_points_and_domains) {
    const auto semi = [](double most) { return sc::semi_explicit<1, 1>(switched{most}, unit); };
    const auto full = [](double most) { return sc::fully_implicit<1>(switched_implicitly{most}, {1, 1}); };
    const auto check = [](const auto& problem, const auto& bounded) {
        const auto r = sc::integrate(sc::radau_iia<3>(), problem, Vector2d(0, 1), 0, 1);
        BOOST_TEST(r.ok());
        BOOST_TEST(std::abs(r.y[0] - 1.5) < 1e-14);
        BOOST_TEST(r.report.rejected_error == 0);  // nothing is spent on finding the jump
        const auto left = sc::integrate(sc::radau_iia<3>(), bounded, Vector2d(0, 1), 0, 1);
        BOOST_TEST(name(left.status) == "outside_domain");
        BOOST_TEST(left.y[0] <= 1);
        BOOST_TEST(std::abs(left.t - 0.75) < 1e-10);
    };
    check(semi(10), semi(1));
    check(full(10), full(1));
}

BOOST_AUTO_TEST_CASE(a_pattern_is_found) {
    const int n = 60;
    // Heat with what only a positive neighbour five nodes on sends back, which NaN passes by: max(0, NaN) is 0.
    const auto heat = [](double, const VectorXd& y, VectorXd& f) {
        for (int i = 0; i < n; ++i) {
            const double left = i > 0 ? y[i - 1] : 0.0, right = i + 1 < n ? y[i + 1] : 0.0;
            f[i] = (left - 2 * y[i] + right) * n * n + std::max(0.0, y[(i + 5) % n]);
        }
    };
    const VectorXd y0 = VectorXd::LinSpaced(n, -1, 1);
    const auto sparse = sc::with_found_sparsity(heat, y0);
    BOOST_TEST(sparse.sparsity().nonZeros() == 3 * n - 2 + n);
    for (int i = 0; i < n; ++i) BOOST_TEST(sparse.sparsity().coeff(i, (i + 5) % n) == 1);
    const auto a = sc::integrate(sc::radau_iia<3>(), sparse, y0, 0, 0.1);
    const auto b = sc::integrate(sc::radau_iia<3>(), heat, y0, 0, 0.1);
    BOOST_TEST((a.ok() && b.ok()));
    BOOST_TEST((a.y - b.y).cwiseAbs().maxCoeff() < 1e-5);
    BOOST_TEST(a.report.f_jacobian * 4 < b.report.f_jacobian * 5);
    BOOST_TEST(message([&] { sc::with_found_sparsity(heat, VectorXd(0)); }).find("y0") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(no_components_are_a_state) {
    const auto none = [](const auto&, const auto&, auto&) {};
    const auto doubles = [](double, const VectorXd&, VectorXd&) {};
    const VectorXd y0(0);
    const auto ends = [](const auto& r) {
        BOOST_TEST(r.ok());
        BOOST_TEST(r.t == 1);
        BOOST_TEST(r.y.size() == 0);
    };
    sc::solution<VectorXd> y;
    ends(sc::integrate(sc::radau_iia<3>(), doubles, y0, 0, 1, {}, y));
    BOOST_TEST(y(0.3).size() == 0);
    ends(sc::integrate(sc::radau_iia_variable(), none, y0, 0, 1));
    ends(sc::integrate(sc::gauss<2>(), none, y0, 0, 1, {.fixed_step = 0.1}));
    ends(sc::integrate(sc::radau_iia<3>(), none, Eigen::Matrix<double, 0, 1>(), 0, 1));
    auto crossing = sc::events<VectorXd>(sc::event([](double t, const VectorXd&) { return t - 0.4; }, {}));
    sc::output_times<VectorXd> grid(std::vector<double>{0, 0.25, 1});
    ends(sc::integrate(sc::radau_iia<3>(), none, y0, 0, 1, {.break_points = {0.5}}, crossing));
    ends(sc::integrate(sc::radau_iia<3>(), none, y0, 0, 1, {}, grid));
    BOOST_TEST(crossing.found().size() == 1u);
    BOOST_TEST(std::abs(crossing.found()[0].t - 0.4) < 1e-12);
    BOOST_TEST(grid.filled() == 3);
}
