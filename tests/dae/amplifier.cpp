// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE amplifier
#include <boost/test/unit_test.hpp>
#include <problems/equations.hpp>
#include <problems/stored.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/dae/consistent.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/problem/fully_implicit.hpp>

namespace sc = stagecraft;
using Eigen::VectorXd;
template <class S>
using vec8 = Eigen::Matrix<S, 8, 1>;

namespace {

// M y' - f(t, y) of the transistor amplifier: index 1, F_{y'} = M of rank 5.
struct amplifier {
    Eigen::Matrix<double, 8, 8> M = equations::transistor_amplifier{}.mass();
    template <class S>
    void operator()(const S& t, const vec8<S>& y, const vec8<S>& v, vec8<S>& out) const {
        equations::transistor_amplifier{}(t, y, out);
        for (int i = 0; i < 8; ++i) {
            out[i] = -out[i];
            for (int j = 0; j < 8; ++j)
                if (M(i, j) != 0) out[i] += M(i, j) * v[j];
        }
    }
};

}  // namespace

// F(t, y, y') = 0 of index 1 against the reference solution and the form with a mass matrix.
BOOST_AUTO_TEST_CASE(the_transistor_amplifier_as_implicit_equation_is_its_mass_matrix_form) {
    const VectorXd reference = problems::reference("transamp");
    const auto problem = sc::fully_implicit<8>(amplifier{}, 1);
    BOOST_TEST(problem.second_order_components == 8);
    vec8<double> y0;
    y0 << 0, 3, 3, 6, 3, 3, 6, 0;
    // y' from F(0, y0, v) = 0 and, as F_v has rank 5, the three constraints of f differentiated. By hand: row
    // 3 gives v_3, the sum of the first two rows differentiated v_1 = v_2.
    const auto start =
        sc::consistent_initial_values(problem, 0, problem.state(y0, vec8<double>(vec8<double>::Zero())));
    BOOST_TEST(start.check.constraints.size() == 8 + 3);
    BOOST_TEST(start.check.within(1e-12));
    BOOST_TEST((problem.value(start.y) - y0).norm() < 1e-14);
    const double slope = 1e-6 / 0.026, v3 = -3 / 9000.0 / 2e-6, driven = 0.1 * 200 * 3.14159265358979323846;
    BOOST_TEST(start.y[10] == v3, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(start.y[8] == start.y[9], boost::test_tools::tolerance(1e-12));
    BOOST_TEST(start.y[8] == (driven / 1000 + 0.01 * slope * v3) / (1 / 1000.0 + 2 / 9000.0 + 0.01 * slope),
               boost::test_tools::tolerance(1e-12));
    for (double tol : {1e-5, 1e-7}) {
        const sc::options<double> o{.rtol = tol, .atol = tol};
        const auto a = sc::integrate(sc::radau_iia<3>(), problem, start.y, 0, 0.2, o);
        const auto b = sc::integrate(sc::radau_iia<3>(), equations::transistor_amplifier{}, y0, 0, 0.2, o);
        BOOST_TEST(sc::name(a.status) == "success");
        BOOST_TEST(problems::error(VectorXd(problem.value(a.y)), reference, 1) < 30 * tol);
        BOOST_TEST(problems::error(VectorXd(b.y), reference, 1) < 30 * tol);
        BOOST_TEST_MESSAGE("steps " << a.report.steps << " mass-matrix form " << b.report.steps);
    }
}
