// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE krylov
#include <Eigen/LU>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/families.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/linear/krylov_blocks.hpp>
#include <stagecraft/linear/sparse_blocks.hpp>
#include <stagecraft/problem/matrix_free.hpp>
#include <stagecraft/problem/with.hpp>
#include <type_traits>

namespace sc = stagecraft;
using Eigen::MatrixXd, Eigen::VectorXd;
using sparse = Eigen::SparseMatrix<double>;

namespace {

// The Brusselator with diffusion 1/10 on a periodic k x k grid (Hairer-Wanner II.IV.10).
struct brusselator {
    int k = 12;
    double diffusion() const { return 0.1 * k * k; }
    int at(int i, int j) const { return 2 * ((i + k) % k + k * ((j + k) % k)); }
    template <class Visit>
    void each(Visit visit) const {
        for (int j = 0; j < k; ++j)
            for (int i = 0; i < k; ++i)
                visit(at(i, j), std::array{at(i - 1, j), at(i + 1, j), at(i, j - 1), at(i, j + 1)});
    }
    void operator()(double, const VectorXd& y, VectorXd& f) const {
        each([&](int p, const auto& next) {
            const double u = y[p], v = y[p + 1];
            f[p] = 1 + u * u * v - 4.4 * u - 4 * diffusion() * u;
            f[p + 1] = 3.4 * u - u * u * v - 4 * diffusion() * v;
            for (const int q : next)
                for (int c = 0; c < 2; ++c) f[p + c] += diffusion() * y[q + c];
        });
    }
    template <class Add>
    void entries(const VectorXd& y, Add add) const {
        each([&](int p, const auto& next) {
            const double u = y[p], v = y[p + 1];
            add(p, p, 2 * u * v - 4.4 - 4 * diffusion());
            add(p, p + 1, u * u);
            add(p + 1, p, 3.4 - 2 * u * v);
            add(p + 1, p + 1, -u * u - 4 * diffusion());
            for (const int q : next)
                for (int c = 0; c < 2; ++c) add(p + c, q + c, diffusion());
        });
    }
    VectorXd start() const {
        VectorXd y(2 * k * k);
        for (int j = 0; j < k; ++j)
            for (int i = 0; i < k; ++i) {
                const double p = double(i) / k, q = double(j) / k;
                y[at(i, j)] = 22 * q * std::pow(1 - q, 1.5);
                y[at(i, j) + 1] = 27 * p * std::pow(1 - p, 1.5);
            }
        return y;
    }
};
struct sparse_brusselator : brusselator {
    sparse sparsity() const {
        std::vector<Eigen::Triplet<double>> places;
        entries(VectorXd::Zero(2 * k * k), [&](int i, int j, double) { places.emplace_back(i, j, 0.0); });
        sparse J(2 * k * k, 2 * k * k);
        J.setFromTriplets(places.begin(), places.end());
        return J;
    }
    void jacobian(double, const VectorXd& y, sparse& J) const {
        entries(y, [&](int i, int j, double value) { J.coeffRef(i, j) = value; });
    }
};

// J as a product, preconditioned by its diagonal.
struct product {
    const brusselator* of;
    VectorXd y, diagonal;
    Eigen::Index rows() const { return y.size(); }
    Eigen::Index cols() const { return y.size(); }
    void add_times(double factor, const double* x, double* r) const {
        of->entries(y, [&](int i, int j, double value) { r[i] += factor * value * x[j]; });
    }
    void precondition(double shift, double* x) const {
        for (Eigen::Index i = 0; i < y.size(); ++i) x[i] /= shift - diagonal[i];
    }
};
struct without_matrix : brusselator {
    using linear_solver = sc::krylov_blocks;
    product matrix() const { return {this, start(), start()}; }
    void jacobian(double, const VectorXd& y, product& J) const {
        J.y = y;
        entries(y, [&](int i, int j, double value) {
            if (i == j) J.diagonal[i] = value;
        });
    }
};

// Nothing but f and a preconditioner; Generic: f takes states of any scalar type.
template <bool Generic>
struct preconditioned_heat {
    int n;
    double rate() const { return 0.1 * (n + 1.0) * (n + 1.0); }
    template <class Vector>
    requires(Generic || std::is_same_v<Vector, VectorXd>) void operator()(double t, const Vector& u,
                                                                          Vector& f) const {
        for (int i = 0; i < n; ++i) {
            f[i] = -2 * rate() * u[i] - u[i] * u[i] * u[i] + std::cos(t);
            if (i > 0) f[i] += rate() * u[i - 1];
            if (i + 1 < n) f[i] += rate() * u[i + 1];
        }
    }
    // (shift + 2 rate) x_i - rate (x_i-1 + x_i+1) = r_i, by elimination (Thomas).
    void precondition(double shift, double* x) const {
        const double d = shift + 2 * rate();
        VectorXd left(n);
        for (int i = 0; i < n; ++i) {
            const double pivot = d - (i > 0 ? rate() * left[i - 1] : 0);
            left[i] = rate() / pivot;
            x[i] = (x[i] + (i > 0 ? rate() * x[i - 1] : 0)) / pivot;
        }
        for (int i = n - 2; i >= 0; --i) x[i] += left[i] * x[i + 1];
    }
    MatrixXd jacobian_at(const VectorXd& u) const {
        MatrixXd J = MatrixXd::Zero(n, n);
        for (int i = 0; i < n; ++i) {
            J(i, i) = -2 * rate() - 3 * u[i] * u[i];
            if (i > 0) J(i, i - 1) = J(i - 1, i) = rate();
        }
        return J;
    }
};
template <bool Generic>
struct with_matrix : preconditioned_heat<Generic> {
    void jacobian(double, const VectorXd& u, MatrixXd& J) const { J = this->jacobian_at(u); }
};

// The product of its J with a vector beside that of the matrix, and a run beside one with the matrix.
template <bool Generic>
void runs_without_a_matrix(double accuracy) {
    const int n = 40;
    const VectorXd u0 = (VectorXd::LinSpaced(n, 1, n) * (M_PI / (n + 1))).array().sin();
    const auto problem = sc::matrix_free(preconditioned_heat<Generic>{n}, n);
    auto J = problem.matrix();
    problem.jacobian(0.3, u0, J);
    const VectorXd v = VectorXd::LinSpaced(n, -1, 2), exact = problem.jacobian_at(u0) * v;
    VectorXd r = VectorXd::Ones(n);
    J.add_times(-2, v.data(), r.data());
    BOOST_TEST((r - VectorXd::Ones(n) + 2 * exact).norm() <= accuracy * exact.norm());
    for (const int s : {3, 5}) {
        const sc::options<double> o{.rtol = 1e-7, .atol = 1e-7};
        const auto free = sc::integrate(sc::radau_iia(s), problem, u0, 0.0, 2.0, o);
        const auto dense = sc::integrate(sc::radau_iia(s), with_matrix<Generic>{{n}}, u0, 0.0, 2.0, o);
        BOOST_TEST(free.ok());
        BOOST_TEST(double(free.report.steps) <= 1.1 * double(dense.report.steps) + 1);
        BOOST_TEST((free.y - dense.y).template lpNorm<Eigen::Infinity>() <= 3e-7);
    }
}

// Residuals of a real system and a pair, relative to their right-hand sides.
template <class Mass, class Matrix>
std::array<double, 2> residuals(const Mass& mass, const MatrixXd& M, const Matrix& J, const MatrixXd& whole,
                                double re, double im) {
    const int n = static_cast<int>(M.rows());
    sc::krylov_blocks::real real(n);
    sc::krylov_blocks::complex pair(n);
    BOOST_TEST(real.factor_shifted(mass, J, re));
    BOOST_TEST(pair.factor_shifted(mass, J, re, im));
    const VectorXd b = VectorXd::LinSpaced(n, -1, 2).array().sin(),
                   c = VectorXd::LinSpaced(n, 0, 40).array().cos();
    VectorXd x = b, u = b, v = c;
    real.solve(x.data());
    pair.solve(u.data(), v.data());
    const MatrixXd A = re * M - whole;
    return {(b - A * x).norm() / b.norm(),
            std::hypot((b - A * u + im * M * v).norm(), (c - A * v - im * M * u).norm()) /
                std::hypot(b.norm(), c.norm())};
}

}  // namespace

BOOST_AUTO_TEST_CASE(real_systems_and_pairs_are_solved_to_a_hundredth) {
    const sparse_brusselator problem{{6}};
    const int n = 72;
    sparse J = problem.sparsity();
    problem.jacobian(0, problem.start(), J);
    const MatrixXd identity = MatrixXd::Identity(n, n);
    MatrixXd M = 2 * identity;
    for (int i = 0; i + 1 < n; ++i) M(i, i + 1) = 0.3;
    const product by_product{&problem, problem.start(), MatrixXd(J).diagonal()};
    for (const double re : {1e4, 300.0, 40.0})
        for (const double im : {0.8 * re, -2 * re}) {
            for (const double r : residuals(sc::identity_mass(), identity, J, J, re, im))
                BOOST_TEST(r <= 0.0101);
            for (const double r : residuals(sc::entry_mass<double>(M), M, J, J, re, im))
                BOOST_TEST(r <= 0.0101);
            for (const double r : residuals(sc::identity_mass(), identity, by_product, J, re, im))
                BOOST_TEST(r <= 0.0101);
        }
    J.coeffRef(0, 0) = NAN;
    sc::krylov_blocks::real real(n);
    BOOST_TEST(!real.factor_shifted(sc::identity_mass(), J, 1.0));
}

BOOST_AUTO_TEST_CASE(runs_take_about_the_steps_of_direct_solvers) {
    const sparse_brusselator problem;
    const VectorXd y0 = problem.start();
    const sc::options<double> o{.rtol = 1e-6, .atol = 1e-6};
    for (const int s : {3, 5}) {
        const auto method = sc::radau_iia(s);
        const auto direct = sc::integrate(method, problem, y0, 0.0, 0.5, o);
        const auto krylov =
            sc::integrate(method, sc::with_linear_solver<sc::krylov_blocks>(problem), y0, 0.0, 0.5, o);
        const auto free = sc::integrate(method, without_matrix{}, y0, 0.0, 0.5, o);
        for (const auto& r : {krylov, free}) {
            BOOST_TEST(r.ok());
            BOOST_TEST(double(r.report.steps) <= 1.1 * double(direct.report.steps) + 1);
            BOOST_TEST(double(r.report.solves) <= 1.15 * double(direct.report.solves) + 1);
            BOOST_TEST((r.y - direct.y).lpNorm<Eigen::Infinity>() <= 3e-6);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_right_hand_side_and_a_preconditioner_suffice) {
    runs_without_a_matrix<true>(1e-14);
    runs_without_a_matrix<false>(1e-6);
    BOOST_CHECK_THROW(sc::matrix_free(preconditioned_heat<true>{3}, -1), std::invalid_argument);
}

// A factorisation costs some forty solves with it and J: the Jacobian is kept longer than by its contraction alone.
BOOST_AUTO_TEST_CASE(what_a_factorisation_costs_is_told_to_the_step_control) {
    const sparse_brusselator problem;
    sparse J = problem.sparsity();
    problem.jacobian(0, problem.start(), J);
    const int n = static_cast<int>(J.rows());
    sc::krylov_blocks::real real(n);
    BOOST_TEST(real.factor_shifted(sc::identity_mass(), J, 300.0));
    BOOST_TEST(real.work().step > 5 * real.work().iteration);
    sc::krylov_blocks::complex pair(n);
    BOOST_TEST(pair.factor_shifted(sc::identity_mass(), J, 300.0, 200.0));
    BOOST_TEST(pair.work().iteration > 1.5 * real.work().iteration);
    const product by_product{&problem, problem.start(), MatrixXd(J).diagonal()};
    sc::krylov_blocks::real free(n);
    BOOST_TEST(free.factor_shifted(sc::identity_mass(), by_product, 300.0));
    BOOST_TEST(free.work().step == 0);
    const auto r = sc::integrate(sc::radau_iia(3), sc::with_linear_solver<sc::krylov_blocks>(problem),
                                 problem.start(), 0.0, 0.5, {.rtol = 1e-6, .atol = 1e-6});
    BOOST_TEST(r.ok());
    BOOST_TEST(2 * r.report.jacobians <= r.report.steps);
}
