// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE amplifier
#include <Eigen/QR>
#include <boost/test/unit_test.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/problem/fully_implicit.hpp>

#include "../stepper/problems.hpp"

namespace sc = stagecraft;
using Eigen::VectorXd;
template <class S>
using vec8 = Eigen::Matrix<S, 8, 1>;

namespace {

// M y' - f(t, y) of the transistor amplifier: index 1, F_{y'} = M of rank 5.
struct amplifier {
    Eigen::Matrix<double, 8, 8> M = problems::transistor_amplifier{}.mass();
    template <class S>
    void operator()(const S& t, const vec8<S>& y, const vec8<S>& v, vec8<S>& out) const {
        problems::transistor_amplifier{}(t, y, out);
        for (int i = 0; i < 8; ++i) {
            out[i] = -out[i];
            for (int j = 0; j < 8; ++j)
                if (M(i, j) != 0) out[i] += M(i, j) * v[j];
        }
    }
};

// f(0, y0) = 0 in all rows but those of the capacitors: y' of least norm with M y' = f, which leaves the
// derivatives of the algebraic parts open; they are found in the first step.
vec8<double> amplifier_derivative(const vec8<double>& y) {
    vec8<double> f;
    problems::transistor_amplifier{}(0.0, y, f);
    const Eigen::Matrix<double, 8, 8> M = 1e6 * amplifier{}.M;
    return M.completeOrthogonalDecomposition().solve(1e6 * f);
}

}  // namespace

// F(t, y, y') = 0 of index 1 against the reference solution and the form with a mass matrix.
BOOST_AUTO_TEST_CASE(the_transistor_amplifier_as_implicit_equation_is_its_mass_matrix_form) {
    const VectorXd reference = problems::reference("transamp");
    const auto problem = sc::fully_implicit<8>(amplifier{}, 1);
    BOOST_TEST(problem.second_order_components == 8);
    vec8<double> y0;
    y0 << 0, 3, 3, 6, 3, 3, 6, 0;
    for (double tol : {1e-5, 1e-7}) {
        const sc::options<double> o{.rtol = tol, .atol = tol};
        const auto a = sc::integrate(sc::radau_iia<3>(), problem, problem.state(y0, amplifier_derivative(y0)),
                                     0, 0.2, o);
        const auto b = sc::integrate(sc::radau_iia<3>(), problems::transistor_amplifier{}, y0, 0, 0.2, o);
        BOOST_TEST(sc::name(a.status) == "success");
        BOOST_TEST(problems::error(VectorXd(problem.value(a.y)), reference, 1) < 30 * tol);
        BOOST_TEST(problems::error(VectorXd(b.y), reference, 1) < 30 * tol);
        BOOST_TEST_MESSAGE("steps " << a.report.steps << " mass-matrix form " << b.report.steps);
    }
}
