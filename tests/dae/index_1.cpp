// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE index_1
#include <Eigen/LU>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <stagecraft/families.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/linear/mass_kernel.hpp>
#include <string>

namespace sc = stagecraft;
using Eigen::MatrixXd, Eigen::VectorXd;

namespace {

// M x' = A x of index 1 with M = P diag(1, 0) Q: for (y, z) = Q x, y' = S y and z = K y.
struct descriptor {
    MatrixXd M, A, Q, S, K;
    void operator()(double, const VectorXd& x, VectorXd& f) const { f = A * x; }
    void jacobian(double, const VectorXd&, MatrixXd& J) const { J = A; }
    MatrixXd mass() const { return M; }
    VectorXd state(const VectorXd& y) const {
        VectorXd u(M.rows());
        u << y, K * y;
        return Q.inverse() * u;
    }
};

// exp(X) by the Taylor series of X / 2^10.
MatrixXd exponential(const MatrixXd& X) {
    const MatrixXd small = X / 1024;
    MatrixXd sum = MatrixXd::Identity(X.rows(), X.cols()), term = sum;
    for (int k = 1; k < 20; ++k) sum += term = term * small / k;
    for (int k = 0; k < 10; ++k) sum = sum * sum;
    return sum;
}

class random_systems {
  public:
    MatrixXd matrix(int rows, int columns) {
        return MatrixXd::NullaryExpr(rows, columns, [&] { return number_(random_); });
    }
    // d differential and a algebraic components; P = Q = 1 where M is to be diagonal.
    descriptor system(int d, int a, bool diagonal) {
        const int n = d + a;
        const MatrixXd one = MatrixXd::Identity(n, n);
        const MatrixXd P = diagonal ? one : MatrixXd(one + 0.4 * matrix(n, n));
        const MatrixXd Q = diagonal ? one : MatrixXd(one + 0.4 * matrix(n, n));
        MatrixXd inner = 3 * matrix(n, n), D = one;
        inner.bottomRightCorner(a, a) += 4 * MatrixXd::Identity(a, a);
        inner.topLeftCorner(d, d) -= 2 * MatrixXd::Identity(d, d);
        D.bottomRightCorner(a, a).setZero();
        const MatrixXd K = -inner.bottomRightCorner(a, a).inverse() * inner.bottomLeftCorner(a, d);
        return {P * D * Q, P * inner * Q, Q, inner.topLeftCorner(d, d) + inner.topRightCorner(d, a) * K, K};
    }

  private:
    std::mt19937 random_{7};
    std::uniform_real_distribution<double> number_{-1, 1};
};

double tolerances(const VectorXd& x, const VectorXd& right, double tolerance) {
    return ((x - right).array() / (tolerance * (1 + right.array().abs()))).abs().maxCoeff();
}

template <class Method, class Problem>
std::string refusal(const Method& method, const Problem& problem, const VectorXd& y0,
                    const sc::options<double>& o) {
    try {
        return sc::name(sc::integrate(method, problem, y0, 0.0, 1.0, o).status);
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
}

// C (v_1 - v_2)' between two nodes, each with a conductance to ground, and a current into the first one.
struct floating_capacitor {
    void operator()(double t, const VectorXd& v, VectorXd& f) const { f << std::sin(t) - v[0], -0.5 * v[1]; }
    void jacobian(double, const VectorXd&, MatrixXd& J) const { J << -1, 0, 0, -0.5; }
    MatrixXd mass() const { return (MatrixXd(2, 2) << 1, -1, -1, 1).finished(); }
    // w = v_1 - v_2, v_1 = (sin t + w/2)/1.5, 1.5 w' = -w/2 + sin t / 2 ... as v_2 = 2 (sin t - v_1).
    static VectorXd at(double t, double w0) {
        // w' = -w/3 + sin t / 3: w = (sin t - 3 cos t)/10 + c exp(-t/3)
        const double w = (std::sin(t) - 3 * std::cos(t)) / 10 + (w0 + 0.3) * std::exp(-t / 3);
        const double v1 = (std::sin(t) + w / 2) / 1.5;
        return (VectorXd(2) << v1, v1 - w).finished();
    }
};

// y' = -2 z, 0 = z - 3 y^2: y = 1/(1 + 6 t).
struct quadratic {
    void operator()(double, const VectorXd& x, VectorXd& f) const { f << -2 * x[1], x[1] - 3 * x[0] * x[0]; }
    void jacobian(double, const VectorXd& x, MatrixXd& J) const { J << 0, -2, -6 * x[0], 1; }
    MatrixXd mass() const { return (MatrixXd(2, 2) << 1, 0, 0, 0).finished(); }
    static VectorXd at(double t) {
        const double y = 1 / (1 + 6 * t);
        return (VectorXd(2) << y, 3 * y * y).finished();
    }
};

const auto all_methods = [] {
    return std::vector{sc::gauss(2),     sc::gauss(3),     sc::gauss(4),        sc::radau_iia(2),
                       sc::radau_iia(3), sc::radau_iia(4), sc::lobatto_iiic(3), sc::lobatto_iiic(4)};
}();

}  // namespace

BOOST_AUTO_TEST_CASE(every_method_solves_random_linear_systems_of_index_1) {
    random_systems random;
    for (int k = 0; k < 24; ++k) {
        const descriptor problem = random.system(2, 1 + k % 3, k % 2 == 0);
        const VectorXd y0 = random.matrix(2, 1), right = problem.state(exponential(problem.S) * y0);
        const double size = std::max(1.0, exponential(problem.S).norm());
        for (const auto& method : all_methods)
            for (const double tolerance : {1e-5, 1e-8}) {
                const auto r = sc::integrate(method, problem, problem.state(y0), 0.0, 1.0,
                                             {.rtol = tolerance, .atol = tolerance});
                BOOST_TEST(r.ok(), "system " << k << ", " << method.stages() << " stages");
                BOOST_TEST(tolerances(r.y, right, tolerance) <= 10 * size, "system " << k);
                BOOST_TEST(r.report.steps < 1500);
            }
    }
}

BOOST_AUTO_TEST_CASE(starts_off_the_constraints_are_forgotten_or_refused) {
    random_systems random;
    for (int k = 0; k < 12; ++k) {
        const descriptor problem = random.system(2, 2, k % 2 == 0);
        const VectorXd y0 = random.matrix(2, 1), right = problem.state(exponential(problem.S) * y0);
        VectorXd off = VectorXd::Zero(4);
        off.tail(2) = VectorXd::Constant(2, k % 3 == 0 ? -1 : 1);
        const VectorXd x0 = problem.state(y0) + problem.Q.inverse() * off;  // the same M x
        const double size = std::max(1.0, exponential(problem.S).norm());
        for (const auto& method : all_methods) {
            const bool forgets = method.b.isApprox(method.A.row(method.stages() - 1).transpose());
            if (forgets) {
                const auto r = sc::integrate(method, problem, x0, 0.0, 1.0, {.rtol = 1e-7, .atol = 1e-7});
                BOOST_TEST(r.ok(), "system " << k << ", " << method.stages() << " stages");
                BOOST_TEST(tolerances(r.y, right, 1e-7) <= 10 * size);
            } else {
                for (const double step : {0.0, 0.01})
                    BOOST_TEST(refusal(method, problem, x0, {.fixed_step = step}).find("not consistent") !=
                               std::string::npos);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(a_refused_start_names_the_equations_and_what_helps) {
    const VectorXd off = VectorXd::Constant(2, 5);
    const std::string circuit = refusal(sc::gauss(2), floating_capacitor(), off, {}),
                      second = refusal(sc::gauss(3), quadratic(), off, {});
    BOOST_TEST(circuit.find("the combination of equations 0, 1") != std::string::npos);
    BOOST_TEST(second.find("equation 1 ") != std::string::npos);
    for (const std::string& text : {circuit, second})
        for (const char* what : {"y0", "radau_iia", "consistent_initial_values"})
            BOOST_TEST(text.find(what) != std::string::npos);
    // What is within the tolerance is no reason, nor is an M that is regular.
    const VectorXd near = quadratic::at(0) + 1e-7 * VectorXd::Unit(2, 1);
    BOOST_TEST(refusal(sc::gauss(3), quadratic(), near, {}) == "success");
}

BOOST_AUTO_TEST_CASE(gauss_keeps_its_order_on_a_floating_capacitor_and_a_nonlinear_constraint) {
    for (const auto& method : {sc::gauss(2), sc::gauss(3), sc::gauss(4)})
        for (const double tolerance : {1e-5, 1e-7, 1e-9}) {
            const sc::options<double> o{.rtol = tolerance, .atol = tolerance};
            const auto circuit =
                sc::integrate(method, floating_capacitor(), floating_capacitor::at(0, 3), 0.0, 10.0, o);
            BOOST_TEST(circuit.ok());
            BOOST_TEST(tolerances(circuit.y, floating_capacitor::at(10, 3), tolerance) <= 10);
            BOOST_TEST(circuit.report.steps < 400);  // each of 1e-9 in vain before
            const auto r = sc::integrate(method, quadratic(), quadratic::at(0), 0.0, 1.5, o);
            BOOST_TEST(r.ok());
            BOOST_TEST(tolerances(r.y, quadratic::at(1.5), tolerance) <= 10);
            BOOST_TEST(r.report.steps < 200);
        }
}

// The trapezoidal rule and its kin, whose stages begin at the start: errors fall with the order.
BOOST_AUTO_TEST_CASE(lobatto_iiia_keeps_its_order_from_a_consistent_start) {
    random_systems random;
    for (int k = 0; k < 4; ++k) {
        const descriptor problem = random.system(2, 2, k % 2 == 0);
        const VectorXd y0 = random.matrix(2, 1), right = problem.state(exponential(problem.S) * y0);
        for (const int s : {2, 3}) {
            const auto error = [&](double h) {
                const auto r = sc::integrate(sc::lobatto_iiia(s), problem, problem.state(y0), 0.0, 1.0,
                                             {.rtol = 1e-12, .atol = 1e-12, .fixed_step = h});
                BOOST_TEST(r.ok());
                return (r.y - right).norm();
            };
            BOOST_TEST(error(0.025) <= 1.3 * error(0.05) / std::pow(2, 2 * s - 2));
        }
        VectorXd off = problem.state(y0) + problem.Q.inverse() * VectorXd::Unit(4, 3);
        BOOST_TEST(refusal(sc::lobatto_iiia(3), problem, off, {.fixed_step = 0.05}).find("not consistent") !=
                   std::string::npos);
    }
}

BOOST_AUTO_TEST_CASE(the_kernel_of_a_mass_matrix_is_found_island_by_island) {
    random_systems random;
    for (int k = 0; k < 50; ++k) {
        const int n = 9;
        MatrixXd M =
            MatrixXd::Zero(n, n);  // an island of five of rank k % 5, a regular one of two, two zeros
        const int rank = k % 5;
        M.block(1, 1, 5, 5) = random.matrix(5, rank) * random.matrix(rank, 5) * std::pow(10, k % 7 - 3);
        M.block(6, 6, 2, 2) << 2, 1, 1, 2;
        sc::mass_kernel<double> kernel(sc::entry_mass<double>(M), n);
        BOOST_TEST(static_cast<int>(kernel.basis().size()) == 5 - rank + 2);
        const VectorXd x = random.matrix(n, 1);
        VectorXd inside = x, outside = x;
        kernel.project(inside);
        kernel.remove(outside);
        BOOST_TEST((inside + outside - x).norm() <= 1e-14);
        BOOST_TEST(std::abs(inside.dot(outside)) <= 1e-13);
        BOOST_TEST((M * inside).norm() <= 1e-12 * M.norm());
    }
}
