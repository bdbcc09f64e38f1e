// SPDX-License-Identifier: BSL-1.0
// Compiled as C++17: ublas of Boost 1.74, which rosenbrock4 is tied to, needs the allocator members that
// C++20 removed.
#include "odeint.hpp"

#include <boost/numeric/odeint.hpp>
#include <boost/numeric/ublas/matrix.hpp>
#include <boost/numeric/ublas/vector.hpp>

namespace peers {

bool rosenbrock4(std::vector<double>& y, double t0, double t1, double rtol, double atol, const values_at& f,
                 const values_at& jacobian, long& steps) {
    namespace odeint = boost::numeric::odeint;
    using vector = boost::numeric::ublas::vector<double>;
    using matrix = boost::numeric::ublas::matrix<double>;

    const auto n = y.size();
    vector x(n);
    std::copy(y.begin(), y.end(), x.begin());
    const auto rhs = [&](const vector& in, vector& out, double t) { f(t, &in[0], &out[0]); };
    const auto jac = [&](const vector& in, matrix& J, const double& t, vector& dfdt) {
        jacobian(t, &in[0], &J.data()[0]);         // row by row, as ublas stores it
        std::fill(dfdt.begin(), dfdt.end(), 0.0);  // every problem given to it is autonomous
    };
    bool ok = true;
    try {
        steps = static_cast<long>(
            odeint::integrate_adaptive(odeint::make_controlled<odeint::rosenbrock4<double>>(atol, rtol),
                                       std::make_pair(rhs, jac), x, t0, t1, 1e-9 * (t1 - t0)));
    } catch (const std::exception&) {
        ok = false;
    }
    std::copy(x.begin(), x.end(), y.begin());
    return ok;
}

}  // namespace peers
