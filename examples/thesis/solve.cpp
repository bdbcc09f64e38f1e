// SPDX-License-Identifier: BSL-1.0
#include "solve.hpp"

#include <chrono>
#include <cmath>
#include <map>
#include <stagecraft/integrate.hpp>
#include <stagecraft/tableaux/rounded.hpp>
#include <stdexcept>
#include <string>
#include <utility>

namespace thesis {

namespace {

const stagecraft::transformed_tableau<double>& tableau_of(family f, int s) {
    static std::map<std::pair<family, int>, stagecraft::transformed_tableau<double>> known;
    const auto found = known.find({f, s});
    if (found != known.end()) return found->second;
    return known.emplace(std::pair{f, s}, stagecraft::tableaux::transformed<double>(f, s)).first->second;
}

}  // namespace

trajectory solve(const setup& s, const request& how) {
    stagecraft::options<double> o;
    o.rtol = o.atol = how.tolerance;
    if (how.steps > 0) {
        o.fixed_step = how.end / static_cast<double>(how.steps);
        o.newton_iterations = 50;  // equal steps have no smaller step to fall back on
    }
    trajectory result;
    result.path.push_back({0, 0, s.y0});
    const auto start = std::chrono::steady_clock::now();
    const auto r = stagecraft::integrate(tableau_of(how.method, how.stages), s.problem, s.y0, 0.0, how.end, o,
                                         [&](double t, const vector& y, double h) {
                                             result.path.push_back({t, h, y});
                                         });
    const auto stop = std::chrono::steady_clock::now();
    if (!r.ok()) throw std::runtime_error("a run ended with " + std::string(stagecraft::name(r.status)));
    result.report = r.report;
    result.microseconds = std::chrono::duration<double, std::micro>(stop - start).count();
    return result;
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
