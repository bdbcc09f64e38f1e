// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE projection_cost
#include <boost/test/unit_test.hpp>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/dae/projection.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/problem/semi_explicit.hpp>

#include "../allocations.hpp"
#include "problems.hpp"

namespace sc = stagecraft;
using Eigen::Vector3d;

namespace {

const auto index_2 = sc::semi_explicit<2, 1>(dae::hlr_f{}, dae::hlr_g{});

// Allocations of a run of so many equal steps, each corrected.
template <class Method, class Problem, class Vector>
long allocations_of_run(const Method& method, const Problem& p, const Vector& y0, int steps,
                        const sc::projection_options& o) {
    auto keep = sc::projection(p, o);
    const long before = allocations;
    const auto r = sc::integrate(method, p, y0, 0, 0.4, {.fixed_step = 0.4 / steps}, keep);
    const long made = allocations - before;
    BOOST_TEST(r.ok());
    BOOST_TEST(r.report.steps == steps);
    BOOST_TEST(keep.corrections() == steps);
    return made;
}
// What each of 36 more steps allocates.
template <class Method, class Problem, class Vector>
double allocations_per_step(const Method& method, const Problem& p, const Vector& y0,
                            const sc::projection_options& o) {
    const long few = allocations_of_run(method, p, y0, 4, o), many = allocations_of_run(method, p, y0, 40, o);
    return static_cast<double>(many - few) / 36;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_projection_allocates_nothing_per_step_for_states_of_fixed_size) {
    for (const bool hidden : {false, true})
        for (const bool along : {false, true})
            BOOST_TEST(allocations_per_step(sc::gauss<2>(), index_2, Vector3d(1, 1, 1),
                                            {.hidden = hidden, .along_algebraic = along}) == 0);
    const dae::jay index_3{};
    const Eigen::Matrix<double, 5, 1> start = Eigen::Matrix<double, 5, 1>::Ones();
    BOOST_TEST(allocations_per_step(sc::radau_iia<2>(), index_3, start, {.hidden = true}) == 0);
}

// As its description says; and what would be seen above.
BOOST_AUTO_TEST_CASE(for_states_of_run_time_size_a_projection_allocates_its_matrices_in_every_step) {
    const auto open = sc::semi_explicit(dae::hlr_f{}, dae::hlr_g{}, 2, 1);
    const Eigen::VectorXd start = Vector3d(1, 1, 1);
    const double per_step = allocations_per_step(sc::gauss<2>(), open, start, {});
    BOOST_TEST(per_step > 10);
    BOOST_TEST_MESSAGE(per_step << " per step");
}
