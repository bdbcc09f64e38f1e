// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE far_guesses
#include <Eigen/Core>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/families.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/radau_iia_variable.hpp>

namespace sc = stagecraft;
using Eigen::Vector2d;

namespace {

// y' = -w y, eps z' = -(z - y) slope(z) - eps w y: z = y = e^{-wt} from (1, 1), and z comes back to y from elsewhere.
// Where z is far off, exp is flat on one side and steep on the other, 1 + z^2 is steeper on both.
struct slow_manifold {
    double w, eps;
    bool flat;
    template <class T>
    T slope(const T& z) const {
        using std::exp;
        return flat ? T(exp(z)) : T(1.0 + z * z);
    }
    template <class Y, class F>
    void operator()(const Y& y, F& f) const {
        f[0] = -w * y[0];
        f[1] = -(y[1] - y[0]) * slope(typename F::Scalar(y[1])) / eps - w * y[0];
    }
};

// Runs of random stiffness, tolerance, length and start: the largest error at the end, in tolerances.
template <class Method>
double worst_error(const Method& method, bool flat, bool automatic, double off, double initial_step) {
    double worst = 0;
    for (int i = 0; i < 250; ++i) {
        const auto part = [i](double irrational) { return std::fmod((i + 1) * irrational, 1.0); };
        const double eps = std::pow(10, -2 - 13 * part(std::sqrt(2)));
        const double tol = std::pow(10, -2 - 7 * part(std::sqrt(3)));
        const double t1 = 0.5 + 7.5 * part(std::sqrt(5)), w = 0.5 + 2 * part(std::sqrt(7));
        const slow_manifold equations{w, eps, flat};
        const sc::options<double> o{.rtol = tol, .atol = tol, .initial_step = initial_step};
        const auto run = [&](const auto& f) {
            return sc::integrate(method, f, Vector2d(1, 1 + off), 0, t1, o);
        };
        const auto r = automatic ? run([&](const auto&, const auto& y, auto& f) { equations(y, f); })
                                 : run([&](double, const Vector2d& y, Vector2d& f) { equations(y, f); });
        BOOST_TEST(r.ok(), "eps " << eps << ", tolerance " << tol << ": " << sc::name(r.status));
        worst = std::max(worst, (r.y.array() - std::exp(-w * t1)).abs().maxCoeff() / tol);
    }
    return worst;
}

template <class Method>
void stays_on_the_manifold(const Method& method) {
    for (const bool flat : {true, false})
        for (const bool automatic : {true, false})
            for (const double off : {0.0, 0.3})
                for (const double initial_step : {0.0, 0.1})
                    BOOST_TEST(worst_error(method, flat, automatic, off, initial_step) < 12,
                               "flat " << flat << ", automatic " << automatic << ", off " << off << ", from "
                                       << initial_step);
}

}  // namespace

// What Newton's iteration left of the stages grows when their polynomial is extrapolated, and f at a point a little off a
// stiff component's manifold says nothing about how far it will move.
BOOST_AUTO_TEST_CASE(a_stiff_component_is_not_lost_by_a_guess_that_is_far_off) {
    stays_on_the_manifold(sc::radau_iia<3>());
    stays_on_the_manifold(sc::radau_iia<5>());
    stays_on_the_manifold(sc::radau_iia<7>());
    stays_on_the_manifold(sc::radau_iia_variable());
}
