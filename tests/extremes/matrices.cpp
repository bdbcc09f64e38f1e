// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE matrices
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <problems/sparse_once.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/linear/sparse_blocks.hpp>
#include <stagecraft/tableaux/rounded.hpp>

// Singular and nearly singular matrices, states without components, and 1e5 unknowns.

namespace sc = stagecraft;
using enum sc::tableaux::family;
using V = Eigen::VectorXd;

namespace {

const auto radau = sc::tableaux::transformed<double>(radau_iia, 3);

// M y' = A y + b, M and A of any rank.
struct affine {
    Eigen::MatrixXd M, A;
    V b;
    void operator()(double, const V& y, V& f) const { f = A * y + b; }
    void jacobian(double, const V&, Eigen::MatrixXd& J) const { J = A; }
    const Eigen::MatrixXd& mass() const { return M; }
};

Eigen::MatrixXd matrix(std::initializer_list<double> entries) {
    const auto n = static_cast<Eigen::Index>(std::lround(std::sqrt(static_cast<double>(entries.size()))));
    return Eigen::Map<const Eigen::MatrixXd>(entries.begin(), n, n).transpose();
}

}  // namespace

BOOST_AUTO_TEST_CASE(singular_pencils_are_no_success) {
    // No unknown in the second equation at all; the second equation a multiple of the first; M = 0 and A of
    // rank 1.
    const affine nothing{matrix({1, 0, 0, 0}), matrix({-1, 0, 0, 0}), Eigen::Vector2d(0, 1)};
    const affine multiple{matrix({1, 0, 2, 0}), matrix({-1, 1, -2, 2}), Eigen::Vector2d(0, 0)};
    const affine rank_one{matrix({0, 0, 0, 0}), matrix({1, 1, 1, 1}), Eigen::Vector2d(1, 2)};
    for (const auto& p : {nothing, multiple, rank_one})
        for (const double step : {0.0, 0.1}) {
            const auto r = sc::integrate(radau, p, V(Eigen::Vector2d(1, 2)), 0, 1, {.fixed_step = step});
            BOOST_TEST(!r.ok());
            BOOST_TEST(r.t == 0);
            BOOST_TEST((r.y == V(Eigen::Vector2d(1, 2))));
        }
}

// eps y2' = y1 - y2: from an ordinary equation to index 1, without a change of the answer.
BOOST_AUTO_TEST_CASE(nearly_singular_mass_matrices_pass_to_the_singular_one) {
    for (int k = 0; k <= 300; k += 20) {
        const double eps = k == 300 ? 0 : std::pow(10.0, -k);
        const affine p{matrix({1, 0, 0, eps}), matrix({-1, 0, 1, -1}), Eigen::Vector2d(0, 0)};
        const double slow = eps == 1 ? 2 / std::exp(1.0) : std::exp(-1.0) / (1 - eps);  // y2(1) from y2(0)
        const double start = eps == 1 ? 1 : 1 / (1 - eps);
        const auto r =
            sc::integrate(radau, p, V(Eigen::Vector2d(1, start)), 0, 1, {.rtol = 1e-8, .atol = 1e-8});
        BOOST_TEST_CONTEXT("eps = " << eps) {
            BOOST_TEST(sc::name(r.status) == "success");
            BOOST_TEST(std::abs(r.y[0] - std::exp(-1.0)) < 1e-7);
            BOOST_TEST(std::abs(r.y[1] - slow) < 1e-7);
        }
    }
}

// A change of variables of condition 1e12: the same solution, or no success.
BOOST_AUTO_TEST_CASE(ill_conditioned_mass_matrices_give_the_right_answer_or_none) {
    for (int k = 0; k <= 18; k += 2) {
        const double d = std::pow(10.0, -k);
        const Eigen::MatrixXd M = matrix({1, 1, 1, 1 + d});
        const affine p{M, M * matrix({-1, 0, 0, -2}), Eigen::Vector2d(0, 0)};  // y' = diag(-1, -2) y
        const auto r = sc::integrate(radau, p, V(Eigen::Vector2d(1, 1)), 0, 1, {.rtol = 1e-4, .atol = 1e-4});
        BOOST_TEST_CONTEXT("d = " << d << " " << sc::name(r.status)) {
            BOOST_TEST(r.y.allFinite());
            if (d > 1e-9) BOOST_TEST(r.ok());
            // Entries of M and A carry rounding of eps / d in the second equation's variables.
            if (r.ok() && d > 1e-11)
                BOOST_TEST((r.y - Eigen::Vector2d(std::exp(-1), std::exp(-2))).norm() < 2e-3);
        }
    }
}

// gamma/h - lambda vanishes for h = gamma / lambda: another step is taken.
BOOST_AUTO_TEST_CASE(a_step_at_which_the_newton_matrix_is_singular_is_passed_by) {
    const double gamma = radau.gamma[0];
    const affine growth{matrix({1}), matrix({gamma}), V::Zero(1)};
    const auto r = sc::integrate(radau, growth, V::Ones(1).eval(), 0, 4,
                                 {.rtol = 1e-4, .atol = 1e-4, .initial_step = 1});
    BOOST_TEST(sc::name(r.status) == "success");
    BOOST_TEST(r.y[0] == std::exp(4 * gamma), boost::test_tools::tolerance(0.05));
    // Equal steps cannot pass it by.
    const auto equal = sc::integrate(radau, growth, V::Ones(1).eval(), 0, 4, {.fixed_step = 1});
    BOOST_TEST((!equal.ok() || std::isfinite(equal.y[0])));
}

BOOST_AUTO_TEST_CASE(a_state_without_components_reaches_the_end_on_every_path) {
    const auto f = [](double, const V&, V&) {};
    const auto ends = [](const auto& r) {
        BOOST_TEST(r.ok());
        BOOST_TEST((r.t == 1 && r.y.size() == 0));
    };
    for (const double step : {0.0, 0.25}) ends(sc::integrate(radau, f, V(0), 0, 1, {.fixed_step = step}));
    struct sparse {
        void operator()(double, const V&, V&) const {}
        Eigen::SparseMatrix<double> sparsity() const { return {0, 0}; }
    };
    ends(sc::integrate(radau, sparse{}, V(0), 0, 1));
}

namespace {

// u_t = u_xx on (0, 1), u = 0 at the ends, by central differences; sin(pi x) decays at the rate of the
// discrete Laplacian exactly.
struct heat {
    int n;
    double square() const { return (n + 1.0) * (n + 1.0); }
    void operator()(double, const V& y, V& f) const {
        for (int i = 0; i < n; ++i)
            f[i] = square() * ((i > 0 ? y[i - 1] : 0) - 2 * y[i] + (i + 1 < n ? y[i + 1] : 0));
    }
    Eigen::SparseMatrix<double> sparsity() const {
        Eigen::SparseMatrix<double> pattern(n, n);
        pattern.reserve(Eigen::VectorXi::Constant(n, 3));
        for (int j = 0; j < n; ++j)
            for (int i = std::max(0, j - 1); i <= std::min(n - 1, j + 1); ++i) pattern.insert(i, j) = 1;
        return pattern;
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_hundred_thousand_sparse_unknowns_are_solved_in_memory_of_their_size) {
    const heat p{100000};
    const double pi = std::acos(-1.0), half = std::sin(pi / (2 * (p.n + 1.0)));
    V start(p.n);
    for (int i = 0; i < p.n; ++i) start[i] = std::sin(pi * (i + 1) / (p.n + 1.0));
    const auto r = sc::integrate(radau, p, start, 0, 0.1, {.rtol = 1e-4, .atol = 1e-4});
    BOOST_TEST(sc::name(r.status) == "success");
    const double rate = 4 * p.square() * half * half;
    BOOST_TEST((r.y - std::exp(-0.1 * rate) * start).lpNorm<Eigen::Infinity>() < 1e-3);
    // Three colours, not 1e5 columns, and once more in the first step, where so stiff an f may have jumped.
    BOOST_TEST(r.report.f_jacobian == 3 * (r.report.jacobians + 1));
    BOOST_TEST(r.report.steps < 50);
    // A dense Jacobian would take 80 GB; the largest resident size is below a thousandth of that.
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.rfind("VmHWM:", 0) == 0) {
            const double megabytes = std::stod(line.substr(6)) / 1024;
            BOOST_TEST_MESSAGE("largest resident size " << megabytes << " MB");
#if !defined(__SANITIZE_ADDRESS__)
            BOOST_TEST(megabytes < 600);
#endif
        }
}
