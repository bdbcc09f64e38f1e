// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE distributed
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/families.hpp>
#include <stagecraft/integrate.hpp>
#include <stdexcept>
#include <string>

#include "two_parts.hpp"

// A state spread over processes (problem.add_up), here two threads.
namespace sc = stagecraft;
using namespace two_parts;

BOOST_AUTO_TEST_CASE(radau_iia_of_three_five_and_seven_stages_takes_the_steps_of_the_whole_problem) {
    for (int s : {3, 5, 7}) {
        const auto method = sc::radau_iia(s);
        same_steps<part_of>(method, brusselator{}, 5, 6, usual);
        same_steps<part_with_mass>(method, algebraic{{}, 1}, 40, 2, {.rtol = 1e-6, .atol = 1e-10});
        same_steps<part_with_mass>(method, algebraic{{}, 2}, 3, 4, usual);
        same_steps<part_with_mass>(method, algebraic{{}, 2}, 3, 1,
                                   {.rtol = 1e-6, .atol = 1e-8, .continuous = true});
    }
}

BOOST_AUTO_TEST_CASE(a_part_of_no_components_takes_part) {
    same_steps<part_of>(sc::radau_iia(3), brusselator{}, 5, 0, usual);
}

namespace {

// How the two parts of a run end, by status; both within the time that in_two_threads gives them.
template <class Change>
std::array<sc::result<VectorXd>, 2> ends(const brusselator& problem, const sc::options<double>& o,
                                         Change change) {
    meeting with;
    return in_two_threads<part_of>(
        problem, problem.start(), 6,
        [&](const auto& part, VectorXd y) {
            change(part.rank, y);
            const auto watch = [&](double t, const VectorXd& now) {
                (void)now;
                return !(t > 2 && part.rank == 1);
            };
            return sc::integrate(sc::radau_iia(3), part, y, 0.0, 5.0, o, watch);
        },
        with);
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_throws_on_one_process_ends_the_run_on_both) {
    for (const double from : {-1.0, 1e-9, 0.7}) {
        brusselator problem;
        problem.from = from;
        const auto end = ends(problem, usual, [](int, VectorXd&) {});
        BOOST_TEST(int(end[0].status) == int(sc::status::non_finite));
        BOOST_TEST(int(end[1].status) == int(sc::status::function_threw));
        BOOST_CHECK_THROW(std::rethrow_exception(end[1].exception), std::runtime_error);
        BOOST_TEST(end[0].t == end[1].t);
        BOOST_TEST(end[0].t <= std::max(from, 0.0));
        BOOST_TEST(end[0].y.allFinite());
    }
}

BOOST_AUTO_TEST_CASE(an_observer_that_stops_on_one_process_stops_both) {
    const auto end = ends({}, usual, [](int, VectorXd&) {});
    for (const auto& r : end) BOOST_TEST(int(r.status) == int(sc::status::stopped));
    BOOST_TEST(end[0].t == end[1].t);
    BOOST_TEST(end[0].t > 2);
}

BOOST_AUTO_TEST_CASE(an_argument_refused_on_one_process_is_refused_on_both) {
    const brusselator problem;
    meeting with;
    const auto said = in_two_threads<part_of>(
        problem, problem.start(), 6,
        [](const auto& part, VectorXd y) {
            if (part.rank == 1) y[3] = NAN;
            try {
                sc::integrate(sc::radau_iia(3), part, y, 0.0, 5.0);
            } catch (const std::invalid_argument& e) {
                return std::string(e.what());
            }
            return std::string();
        },
        with);
    BOOST_TEST(said[0] == "integrate: an argument has been refused on another process");
    BOOST_TEST(said[1] == "integrate: y0 must be finite");
}

namespace {

struct doubled {  // as if another process had the same components
    static constexpr bool complete = false;
    void operator()(double* x, int k) const {
        for (int i = 0; i < k; ++i) x[i] *= 2;
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(norms_over_processes_are_finite_where_the_products_are) {
    const doubled sums;
    const VectorXd ones = VectorXd::Ones(3), large = 1e300 * ones, small = VectorXd{{3, 4, 0}};
    BOOST_TEST(sc::weighted_norm(small, ones, 3, sums) == std::sqrt(25.0 / 3),
               boost::test_tools::tolerance(1e-15));
    BOOST_TEST(sc::weighted_norm(large, ones, 3, sums) == 1e300, boost::test_tools::tolerance(1e-14));
    BOOST_TEST(!std::isfinite(sc::weighted_norm(large, large, 3, sums)));
    BOOST_TEST(std::isnan(sc::weighted_norm(VectorXd(NAN * ones), ones, 3, sums)));
    BOOST_TEST(sc::weighted_norm(VectorXd(), VectorXd(), 0, sums) == 0.0);
}
