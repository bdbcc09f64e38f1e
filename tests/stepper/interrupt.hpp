// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <boost/test/unit_test.hpp>
#include <sstream>
#include <stagecraft/integrate.hpp>

// A run that is interrupted and continued ends with the bits of the run that is not.

namespace interrupted {

/// Ends a run after so many steps and keeps its checkpoint.
template <class Vector>
struct cut_after {
    long steps;
    stagecraft::checkpoint<Vector> point{};
    bool operator()(double, const Vector&) { return --steps > 0; }
    template <class Take>
    void save(const Take& take) {
        if (steps <= 0) point = take();
    }
};

inline bool same(const stagecraft::report<double>& a, const stagecraft::report<double>& b) {
    return a.steps == b.steps && a.rejected_error == b.rejected_error &&
           a.rejected_newton == b.rejected_newton && a.f == b.f && a.f_jacobian == b.f_jacobian &&
           a.jacobians == b.jacobians && a.factorisations == b.factorisations && a.solves == b.solves &&
           a.error_solves == b.error_solves && a.smallest_step == b.smallest_step &&
           a.largest_step == b.largest_step && a.largest_stages == b.largest_stages &&
           a.smallest_stages == b.smallest_stages;
}

/// Goes on after 1/6, ..., 5/6 of the steps, each time from what has been written and read.
template <class Method, class Problem, class Vector>
void at_five_places(const Method& method, const Problem& problem, const Vector& y0, double t1,
                    const stagecraft::options<double>& o) {
    const auto whole = stagecraft::integrate(method, problem, y0, 0, t1, o);
    BOOST_TEST(whole.ok());
    BOOST_TEST(whole.report.steps >= 12);
    stagecraft::checkpoint<Vector> point;
    for (int part = 1; part <= 5; ++part) {
        const long to = whole.report.steps * part / 6, from = whole.report.steps * (part - 1) / 6;
        cut_after<Vector> cut{to - from};
        const auto until = part == 1 ? stagecraft::integrate(method, problem, y0, 0, t1, o, cut)
                                     : stagecraft::integrate(method, problem, point, t1, o, cut);
        BOOST_TEST((until.status == stagecraft::status::stopped));
        BOOST_TEST(until.report.steps == to);
        std::stringstream file;
        file << cut.point;
        file >> point;
        const auto rest = stagecraft::integrate(method, problem, point, t1, o);
        BOOST_TEST(rest.ok());
        BOOST_TEST((rest.y == whole.y));
        BOOST_TEST(same(rest.report, whole.report));
    }
}

}  // namespace interrupted
