// SPDX-License-Identifier: BSL-1.0
// main() of tests that are compiled with precompiled headers.
#define BOOST_TEST_MODULE stagecraft
#include <boost/test/unit_test.hpp>
