// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE inexact_newton
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/families.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/linear/krylov_blocks.hpp>
#include <stagecraft/problem/matrix_free.hpp>
#include <stagecraft/problem/with.hpp>
#include <stagecraft/stages/newton.hpp>
#include <stagecraft/stages/separate_blocks.hpp>

namespace sc = stagecraft;
using Eigen::VectorXd;

namespace {

// u_t = u_xx / 10 + u - u^3 on (0, 1) with u = 0 at both ends, and how often it is preconditioned: by the diffusion alone.
struct allen_cahn {
    int n;
    inline static long cycles;
    double rate() const { return 0.1 * (n + 1.0) * (n + 1.0); }
    template <class Vector>
    void operator()(double, const Vector& u, Vector& f) const {
        for (int i = 0; i < n; ++i) {
            f[i] = u[i] - u[i] * u[i] * u[i] - 2 * rate() * u[i];
            if (i > 0) f[i] += rate() * u[i - 1];
            if (i + 1 < n) f[i] += rate() * u[i + 1];
        }
    }
    // (shift + 2 rate) x_i - rate (x_i-1 + x_i+1) = r_i, by elimination (Thomas).
    void precondition(double shift, double* x) const {
        ++cycles;
        VectorXd left(n);
        for (int i = 0; i < n; ++i) {
            const double pivot = shift + 2 * rate() - (i > 0 ? rate() * left[i - 1] : 0);
            left[i] = rate() / pivot;
            x[i] = (x[i] + (i > 0 ? rate() * x[i - 1] : 0)) / pivot;
        }
        for (int i = n - 2; i >= 0; --i) x[i] += left[i] * x[i + 1];
    }
};

// krylov_blocks without solve_leaving: every solve is to a hundredth.
struct usual_blocks {
    template <class Solver>
    struct usual {
        Solver solver;
        explicit usual(int n) : solver(n) {}
        template <class... Arguments>
        bool factor_shifted(const Arguments&... arguments) {
            return solver.factor_shifted(arguments...);
        }
        template <class... Parts>
        void solve(Parts... x) {
            solver.solve(x...);
        }
    };
    using real = usual<sc::krylov_blocks::real>;
    using complex = usual<sc::krylov_blocks::complex>;
};

// Solvers that note what they are told.
struct noting {
    inline static std::vector<double> parts;
    struct real {
        explicit real(int) {}
        void solve_leaving(double part, double*) { parts.push_back(part); }
    };
    struct complex {
        explicit complex(int) {}
        static double usual_part() { return 1.0 / 64; }
        void solve_leaving(double part, double*, double*) { parts.push_back(part); }
    };
};

}  // namespace

BOOST_AUTO_TEST_CASE(the_last_solves_of_a_step_are_no_more_exact_than_its_tolerance_asks) {
    const int n = 100;
    const VectorXd x = VectorXd::LinSpaced(n, 1, n) / (n + 1), u0 = 20 * x.array() * (1 - x.array()).pow(3);
    const auto problem = sc::matrix_free(allen_cahn{n}, n);
    long cycles = 0, usual_cycles = 0;
    for (const int s : {3, 5})
        for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7}) {
            const auto run = [&](const auto& p, long& sum) {
                allen_cahn::cycles = 0;
                const auto r =
                    sc::integrate(sc::radau_iia(s), p, u0, 0.0, 1.0, {.rtol = tolerance, .atol = tolerance});
                sum += allen_cahn::cycles;
                BOOST_TEST(r.ok());
                return r;
            };
            const auto usual = run(sc::with_linear_solver<usual_blocks>(problem), usual_cycles);
            const auto r = run(problem, cycles);
            BOOST_TEST(std::abs(r.report.steps - usual.report.steps) <= 1);
            BOOST_TEST((r.y - usual.y).lpNorm<Eigen::Infinity>() <= tolerance / 10);
        }
    BOOST_TEST(10 * cycles <= 9 * usual_cycles);
}

BOOST_AUTO_TEST_CASE(the_systems_of_a_step_leave_about_as_much_each) {
    sc::separate_blocks<double, noting> blocks(1, 1, 3);
    const int system = 0;
    double x[7] = {};
    const auto told = [&](double part, const std::vector<double>& sizes) {
        noting::parts.clear();
        blocks.solve_leaving(system, x, part, sizes);
        return noting::parts;
    };
    BOOST_TEST(told(0.125, {2, 4, 0.5, 3e-9}) == (std::vector{0.25, 0.125, 0.25, 0.25}));
    BOOST_TEST(told(1.0 / 64, {2, 4, 0.5, 0}) == (std::vector{1.0 / 32, 1.0 / 64, 0.125, 0.25}));
    BOOST_TEST(told(0, {2, 4, 0.5, 1}) == (std::vector{0.0, 1.0 / 64, 0.1, 1.0 / 16}));
}

BOOST_AUTO_TEST_CASE(what_a_solve_was_told_it_may_leave_is_taken_to_be_left) {
    for (const double size : {0.2, 1.0}) {
        sc::inexact_newton_monitor<double> monitor(sc::newton_limits<double>{0.02, 1e-12, 1e-10, 10});
        BOOST_TEST(monitor.may_leave(5) == 0);
        BOOST_TEST(!monitor.over(200));
        const double part = monitor.may_leave(0.005);  // an increment of 0.2 is to be expected
        BOOST_TEST(part == 0.05, boost::test_tools::tolerance(1e-12));
        BOOST_TEST(monitor.over(size) == (size < 0.5));
        BOOST_TEST((monitor.outcome().end == sc::newton_end::converged) == (size < 0.5));
        BOOST_TEST(monitor.may_leave(1e-9) == 0.25);
    }
}
