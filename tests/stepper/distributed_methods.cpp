// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE distributed_methods
#include <boost/test/unit_test.hpp>
#include <stagecraft/families.hpp>
#include <stagecraft/step/method_set.hpp>
#include <tuple>

#include "methods.hpp"
#include "two_parts.hpp"

// Other methods than those of distributed.cpp on a state spread over processes.
namespace sc = stagecraft;
using namespace two_parts;

BOOST_AUTO_TEST_CASE(variable_order_and_an_esdirk_method_take_the_steps_of_the_whole_problem) {
    const sc::variable_order variable{std::make_tuple(sc::radau_iia(3), sc::radau_iia(5), sc::radau_iia(7))};
    same_steps<part_of>(variable, brusselator{}, 5, 6, {.rtol = 1e-9, .atol = 1e-9});
    same_steps<part_of>(methods::tr_bdf2(), brusselator{}, 5, 6, usual);
}
