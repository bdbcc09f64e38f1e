// SPDX-License-Identifier: BSL-1.0
#include "solve.hpp"

#include <cmath>
#include <ctime>
#include <map>
#include <stagecraft/integrate.hpp>
#include <stagecraft/tableaux/rounded.hpp>
#include <stdexcept>
#include <string>
#include <utility>

namespace thesis {

namespace {

template <class Scalar>
const stagecraft::transformed_tableau<Scalar>& tableau_of(const request& how) {
    using namespace stagecraft::tableaux;
    static std::map<std::string, stagecraft::transformed_tableau<Scalar>> known;
    std::string key = std::string(name(how.method)) + std::to_string(how.stages);
    for (const rational& c : how.nodes) key += " " + c.str();
    const auto found = known.find(key);
    if (found != known.end()) return found->second;
    return known
        .emplace(key, how.nodes.empty() ? transformed<Scalar>(how.method, how.stages)
                                        : transformed<Scalar>(nodal_polynomial::from_nodes(how.nodes),
                                                              construction::collocation))
        .first->second;
}

}  // namespace

template <class Scalar>
trajectory_of<Scalar> solve(const setup_of<Scalar>& s, const request& how) {
    stagecraft::options<Scalar> o;
    o.rtol = o.atol = Scalar(how.tolerance);
    if (how.steps > 0) {
        o.fixed_step = Scalar(how.end) / Scalar(how.steps);
        o.newton_iterations = 50;  // equal steps have no smaller step to fall back on
    }
    trajectory_of<Scalar> result;
    result.path.push_back({0, 0, s.y0});
    const std::clock_t start = std::clock();
    const auto r =
        stagecraft::integrate(tableau_of<Scalar>(how), s.problem, s.y0, Scalar(0), Scalar(how.end), o,
                              [&](Scalar t, const vector_of<Scalar>& y, Scalar h, const auto& output) {
                                  if constexpr (std::is_same_v<Scalar, double>)
                                      if (how.watch && !how.watch(t, y, h, {output.t0(), std::cref(output)}))
                                          return false;
                                  result.path.push_back({t, h, y});
                                  return true;
                              });
    const std::clock_t stop = std::clock();
    if (!r.ok() && r.status != stagecraft::status::stopped)
        throw std::runtime_error("a run ended with " + std::string(stagecraft::name(r.status)));
    result.report = r.report;
    result.microseconds = 1e6 * static_cast<double>(stop - start) / CLOCKS_PER_SEC;
    return result;
}

template trajectory_of<double> solve(const setup_of<double>&, const request&);
template trajectory_of<long double> solve(const setup_of<long double>&, const request&);

setup restarted(setup s, double t) {
    s.y0 = solve(s, {.stages = 5, .tolerance = 1e-13, .steps = 2000, .end = t}).path.back().y;
    return s;
}

double slope(const std::vector<double>& x, const std::vector<double>& y) {
    double mx = 0, my = 0, xy = 0, xx = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        mx += std::log(x[k]) / static_cast<double>(x.size());
        my += std::log(y[k]) / static_cast<double>(x.size());
    }
    for (std::size_t k = 0; k < x.size(); ++k) {
        xy += (std::log(x[k]) - mx) * (std::log(y[k]) - my);
        xx += (std::log(x[k]) - mx) * (std::log(x[k]) - mx);
    }
    return xy / xx;
}

}  // namespace thesis
