// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE suitesparse
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <problems/sparse_once.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/linear/klu.hpp>
#include <stagecraft/linear/umfpack.hpp>
#include <stagecraft/problem/with.hpp>
#include <stagecraft/radau_iia_variable.hpp>
#include <type_traits>
#include <vector>

#include <problems/stiff.hpp>

namespace sc = stagecraft;

namespace {

template <class Problem>
auto run(const Problem& p) {
    return sc::integrate(sc::radau_iia<3>(), p, p.initial(), p.t0, p.t1, {.rtol = 1e-7, .atol = 1e-7});
}

// Of the real and of the complex solver for shift M - J, relative to the right-hand side.
template <class Blocks>
double residual(const Eigen::SparseMatrix<double>& J) {
    const auto n = J.rows();
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, -1, 2), d = b.reverse();
    typename Blocks::real real(static_cast<int>(n));
    typename Blocks::complex complex(static_cast<int>(n));
    double worst = 0;
    for (const double shift : {5.0, 5e4}) {  // the second factorisation reuses the analysis of the first
        BOOST_REQUIRE(real.factor_shifted(sc::identity_mass{}, J, shift));
        BOOST_REQUIRE(complex.factor_shifted(sc::identity_mass{}, J, shift, -2 * shift));
        Eigen::VectorXd x = b, re = b, im = d;
        real.solve(x.data());
        complex.solve(re.data(), im.data());
        worst = std::max({worst, (shift * x - J * x - b).norm(),
                          (shift * re + 2 * shift * im - J * re - b).norm(),
                          (shift * im - 2 * shift * re - J * im - d).norm()});
    }
    return worst / b.norm();
}

template <class Blocks>
bool factors(const Eigen::SparseMatrix<double>& J, double shift) {
    typename Blocks::real real(static_cast<int>(J.rows()));
    typename Blocks::complex complex(static_cast<int>(J.rows()));
    const bool one = real.factor_shifted(sc::identity_mass{}, J, shift),
               two = complex.factor_shifted(sc::identity_mass{}, J, shift, 0);
    BOOST_TEST(one == two);
    return one;
}

Eigen::SparseMatrix<double> brusselator_jacobian(int N) {
    const problems::sparse_brusselator p{{N}};
    Eigen::SparseMatrix<double> J = p.sparsity();
    p.jacobian(0, p.initial(), J);
    return J;
}

}  // namespace

BOOST_AUTO_TEST_CASE(real_and_complex_solutions_satisfy_their_equations) {
    const auto J = brusselator_jacobian(40);
    BOOST_TEST(residual<sc::klu_blocks>(J) < 1e-12);
    BOOST_TEST(residual<sc::umfpack_blocks>(J) < 1e-12);
}

BOOST_AUTO_TEST_CASE(singular_and_non_finite_matrices_are_refused) {
    Eigen::SparseMatrix<double> J(2, 2);
    J.insert(0, 0) = 1;
    J.insert(1, 1) = 2;
    for (const double shift : {1.0, 3.0}) {
        BOOST_TEST(factors<sc::klu_blocks>(J, shift) == (shift == 3));
        BOOST_TEST(factors<sc::umfpack_blocks>(J, shift) == (shift == 3));
    }
    J.coeffRef(0, 0) = std::nan("");
    BOOST_TEST(!factors<sc::klu_blocks>(J, 3));
    BOOST_TEST(!factors<sc::umfpack_blocks>(J, 3));
}

// shift - J is diagonal but for small entries at first; with the second shift its first diagonal entry is 1e-13, with
// the third one it is zero: the pivots of the first would leave three digits, and none.
BOOST_AUTO_TEST_CASE(pivots_that_no_longer_serve_are_chosen_anew) {
    Eigen::SparseMatrix<double> J(3, 3);
    J.insert(0, 0) = 2, J.insert(0, 1) = 1, J.insert(1, 0) = 1, J.insert(1, 1) = 1, J.insert(1, 2) = 1;
    J.insert(2, 1) = 1, J.insert(2, 2) = 5;
    using blocks = sc::klu_blocks;
    blocks::real real(3);
    blocks::complex complex(3);
    const Eigen::Vector3d b(1, 0.3, -0.7);
    for (const double shift : {1e3, 2 + 1e-13, 2.0, 1e3}) {
        BOOST_REQUIRE(real.factor_shifted(sc::identity_mass{}, J, shift));
        BOOST_REQUIRE(complex.factor_shifted(sc::identity_mass{}, J, shift, 0.0));
        Eigen::Vector3d x = b, re = b, im = Eigen::Vector3d::Zero();
        real.solve(x.data());
        complex.solve(re.data(), im.data());
        BOOST_TEST((shift * x - J * x - b).norm() < 1e-14 * shift);
        BOOST_TEST((re - x).norm() < 1e-14);
        BOOST_TEST(im.norm() == 0);
    }
}

BOOST_AUTO_TEST_CASE(the_brusselator_is_the_same_with_klu_umfpack_and_sparse_lu) {
    const problems::sparse_brusselator p{{100}};
    const auto with_klu = sc::with_linear_solver<sc::klu_blocks>(p);
    const auto with_umfpack = sc::with_linear_solver<sc::umfpack_blocks>(p);
    using used = sc::system<const decltype(with_klu), Eigen::VectorXd>;
    static_assert(std::is_same_v<used::blocks, sc::klu_blocks>);
    static_assert(used::analytic);  // what else the problem brings is still seen
    const auto lu = run(p), klu = run(with_klu), umfpack = run(with_umfpack);
    BOOST_REQUIRE(lu.ok());
    BOOST_REQUIRE(klu.ok());
    BOOST_REQUIRE(umfpack.ok());
    BOOST_TEST(klu.report.steps == lu.report.steps);
    BOOST_TEST(umfpack.report.steps == lu.report.steps);
    BOOST_TEST((klu.y - lu.y).lpNorm<Eigen::Infinity>() < 1e-11);
    BOOST_TEST((umfpack.y - lu.y).lpNorm<Eigen::Infinity>() < 1e-11);
    BOOST_TEST((lu.y - p.initial()).lpNorm<Eigen::Infinity>() > 0.1);
}

namespace {

// The Laplacian and `wind` times the central difference along x on k x k points, zero outside: negative definite, and
// with the wind alone skew.
Eigen::SparseMatrix<double> grid_jacobian(int k, double diffusion, double wind) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int j = 0; j < k; ++j)
        for (int i = 0; i < k; ++i) {
            const int at = i + k * j;
            entries.emplace_back(at, at, -4 * diffusion);
            if (i > 0) entries.emplace_back(at, at - 1, diffusion - wind);
            if (i + 1 < k) entries.emplace_back(at, at + 1, diffusion + wind);
            if (j > 0) entries.emplace_back(at, at - k, diffusion - wind);
            if (j + 1 < k) entries.emplace_back(at, at + k, diffusion + wind);
        }
    Eigen::SparseMatrix<double> J(k * k, k * k);
    J.setFromTriplets(entries.begin(), entries.end());
    return J;
}

// The systems of a step by Radau IIA with s = 5.
struct step_systems {
    using blocks = sc::klu_blocks;
    std::vector<blocks::real> real;
    std::vector<blocks::complex> complex;
    explicit step_systems(const Eigen::SparseMatrix<double>& J) {
        real.emplace_back(static_cast<int>(J.rows()));
        for (int k = 0; k < 2; ++k) complex.emplace_back(static_cast<int>(J.rows()));
    }
    // Factors for a step h; returns the largest relative residual of a solve with each.
    double worst(const Eigen::SparseMatrix<double>& J, double h) {
        const auto method = sc::radau_iia<5>();
        const double shift[] = {method.gamma[0] / h, method.alpha[0] / h, -method.beta[0] / h,
                                method.alpha[1] / h, -method.beta[1] / h};
        BOOST_REQUIRE(blocks::factor_all(real, complex, sc::identity_mass{}, J, shift));
        const auto n = J.rows();
        const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, -1, 2), d = b.array().sin();
        Eigen::VectorXd x = b;
        real[0].solve(x.data());
        double result = (shift[0] * x - J * x - b).norm() / b.norm();
        for (int k = 0; k < 2; ++k) {
            Eigen::VectorXd re = b, im = d;
            complex[std::size_t(k)].solve(re.data(), im.data());
            const double p = shift[1 + 2 * k], q = shift[2 + 2 * k];
            result = std::max(result, std::hypot((p * re - q * im - J * re - b).norm(),
                                                 (p * im + q * re - J * im - d).norm()) /
                                          std::hypot(b.norm(), d.norm()));
        }
        return result;
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(much_fill_is_factored_once_for_all_systems_and_while_it_serves) {
    auto J = grid_jacobian(60, 3600, 0);
    step_systems systems(J);
    BOOST_TEST(systems.worst(J, 0.01) <= 1e-2);
    BOOST_TEST(systems.complex[0].iterates());
    BOOST_TEST(systems.complex[1].iterates());
    const auto work = systems.complex[0].work();
    BOOST_TEST(work.once.step > 0);
    BOOST_TEST(work.per_stage.step == 0);
    // The real system is the one that is factored.
    Eigen::VectorXd x = Eigen::VectorXd::Ones(J.rows());
    systems.real[0].solve(x.data());
    const double gamma = sc::radau_iia<5>().gamma[0];
    BOOST_TEST((gamma / 0.01 * x - J * x - Eigen::VectorXd::Ones(J.rows())).norm() < 1e-9);
    J *= 1.1;
    BOOST_TEST(systems.worst(J, 0.012) <= 1e-2);  // another J, another step, the same factors
    BOOST_TEST(systems.real[0].setups() == 1);
    BOOST_TEST(systems.worst(J, 0.03) <= 1e-2);
    BOOST_TEST(systems.real[0].setups() == 2);
    J.coeffRef(0, 1) = std::nan("");
    const double shift[] = {600, 600, -600, 600, -600};
    BOOST_TEST(
        !step_systems::blocks::factor_all(systems.real, systems.complex, sc::identity_mass{}, J, shift));
}

BOOST_AUTO_TEST_CASE(little_fill_and_little_damping_are_factored_for_every_system) {
    const auto line = brusselator_jacobian(400);
    step_systems one_dimension(line);
    for (const double h : {0.01, 0.02}) BOOST_TEST(one_dimension.worst(line, h) < 1e-10);
    BOOST_TEST(one_dimension.real[0].setups() == 2);
    BOOST_TEST(one_dimension.complex[0].work().per_stage.step > 0);

    const auto wave = grid_jacobian(60, 0, 60);
    step_systems undamped(wave);
    BOOST_TEST(undamped.worst(wave, 1) <= 1e-2);
    BOOST_TEST(undamped.complex[0].iterates());
    for (int k = 0; k < 20; ++k) {
        Eigen::VectorXd re = Eigen::VectorXd::LinSpaced(wave.rows(), -1, 2), im = re.reverse();
        undamped.complex[0].solve(re.data(), im.data());
    }
    BOOST_TEST(undamped.worst(wave, 4) <= 1e-2);  // the other pair need not have turned out to be slow
    BOOST_TEST(!undamped.complex[0].iterates());
}

BOOST_AUTO_TEST_CASE(one_factorisation_leads_to_the_same_solution) {
    const auto J = grid_jacobian(40, 1600, 200);
    struct problem {
        const Eigen::SparseMatrix<double>& J;
        Eigen::SparseMatrix<double> sparsity() const { return J; }
        void operator()(double t, const Eigen::VectorXd& y, Eigen::VectorXd& f) const {
            f = J * y - y.cwiseProduct(y.cwiseProduct(y)) + std::cos(5 * t) * Eigen::VectorXd::Ones(y.size());
        }
        void jacobian(double, const Eigen::VectorXd& y, Eigen::SparseMatrix<double>& out) const {
            out = J;
            out.diagonal() -= 3 * y.cwiseProduct(y);
        }
    };
    const problem p{J};
    const Eigen::VectorXd y0 = Eigen::VectorXd::Ones(J.rows());
    const auto solve = [&](const auto& q) {
        return sc::integrate(sc::radau_iia_variable(), q, y0, 0.0, 1.0, {.rtol = 1e-7, .atol = 1e-9});
    };
    const auto once = solve(sc::with_linear_solver<sc::klu_blocks>(p)),
               each = solve(sc::with_linear_solver<sc::umfpack_blocks>(p));
    BOOST_REQUIRE(once.ok());
    BOOST_REQUIRE(each.ok());
    BOOST_TEST((once.y - each.y).lpNorm<Eigen::Infinity>() < 1e-8);
    BOOST_TEST(once.report.steps <= each.report.steps + each.report.steps / 5);
}
