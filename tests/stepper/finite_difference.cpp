// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE finite_difference
#include <boost/test/unit_test.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

namespace {

template <class S>
using vec3 = Eigen::Matrix<S, 3, 1>;

struct generic_robertson {
    template <class S>
    void operator()(const S&, const vec3<S>& y, vec3<S>& f) const {
        const S slow = 0.04 * y[0] - 1e4 * y[1] * y[2], fast = 3e7 * y[1] * y[1];
        f[0] = -slow;
        f[1] = slow - fast;
        f[2] = fast;
    }
};
// The same, callable with doubles only.
struct plain_robertson {
    void operator()(double t, const vec3<double>& y, vec3<double>& f) const { generic_robertson{}(t, y, f); }
};

template <class Problem>
auto run(const Problem& problem, double tol) {
    return stagecraft::integrate(stagecraft::radau_iia<3>(), problem, vec3<double>(1, 0, 0), 0.0, 40.0,
                                 {.rtol = tol, .atol = 1e-4 * tol});
}

}  // namespace

BOOST_AUTO_TEST_CASE(differences_serve_as_well_as_automatic_derivatives_on_a_badly_scaled_problem) {
    for (const double tol : {1e-3, 1e-5, 1e-7, 1e-9}) {
        const auto exact = run(generic_robertson{}, tol), differences = run(plain_robertson{}, tol);
        BOOST_REQUIRE(exact.ok());
        BOOST_REQUIRE(differences.ok());
        BOOST_TEST((differences.y - exact.y).cwiseQuotient(exact.y).lpNorm<Eigen::Infinity>() < 10 * tol);
        BOOST_TEST(differences.report.steps < 1.3 * exact.report.steps + 5);
        BOOST_TEST(differences.report.rejected() < 10);
        BOOST_TEST(differences.report.f_jacobian == 3 * differences.report.jacobians);
    }
}
