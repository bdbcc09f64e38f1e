// SPDX-License-Identifier: BSL-1.0
#include "wide.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/formulations.hpp>
#include <stagecraft/tableaux/rounded.hpp>
#include <stdexcept>
#include <string>

#include <problems/rolling_disc/disc.hpp>

namespace thesis {

namespace {

using fifty =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using state = Eigen::Matrix<fifty, 12, 1>;
using stagecraft::tableaux::family;

std::vector<state> run(family f, int stages, int steps) {
    static const auto dae = stagecraft::index_2<fifty>(rolling_disc::disc<fifty>());
    static const state start =
        dae.initial_state(rolling_disc::initial_position<fifty>(), rolling_disc::initial_velocity<fifty>());
    stagecraft::options<fifty> o;
    o.rtol = o.atol = fifty("1e-44");
    o.fixed_step = fifty(1) / (5 * steps);
    o.newton_iterations = 200;  // simplified: some 7 digits an iteration
    std::vector<state> path{start};
    const auto r =
        stagecraft::integrate(stagecraft::tableaux::transformed<fifty>(f, stages), dae, start, 0,
                              fifty(1) / 5, o, [&](const fifty&, const state& y) { path.push_back(y); });
    if (!r.ok()) throw std::runtime_error("a run ended with " + std::string(stagecraft::name(r.status)));
    return path;
}

}  // namespace

std::vector<wide_error> errors_at_50_digits(family f, int stages, const std::vector<int>& steps) {
    static const std::vector<state> exact = run(family::radau_iia, 12, 48);
    std::vector<wide_error> errors;
    for (const int n : steps) {
        const std::vector<state> path = run(f, stages, n);
        wide_error worst{0, 0};
        for (std::size_t k = 1; k < path.size(); ++k) {
            const state d = path[k] - exact[k * 48 / static_cast<std::size_t>(n)];
            worst.y = std::max(worst.y, static_cast<double>(d.head<10>().cwiseAbs().maxCoeff()));
            worst.lambda = std::max(worst.lambda, static_cast<double>(d.tail<2>().cwiseAbs().maxCoeff()));
        }
        errors.push_back(worst);
    }
    return errors;
}

}  // namespace thesis
