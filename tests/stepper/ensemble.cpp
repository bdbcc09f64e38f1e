// SPDX-License-Identifier: BSL-1.0
// Compiled and run with ThreadSanitizer where that runs (tests/stepper/CMakeLists.txt).
#define BOOST_TEST_MODULE ensemble
#include <atomic>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <set>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/ensemble.hpp>
#include <stagecraft/integrate.hpp>
#include <stdexcept>
#include <string>
#include <thread>

namespace sc = stagecraft;
using V1 = Eigen::Matrix<double, 1, 1>;

BOOST_AUTO_TEST_CASE(results_come_in_order_and_are_those_of_one_thread) {
    const auto decay = [](int k) {
        const auto f = [rate = k + 1.0](double, const V1& y, V1& out) { out = -rate * y; };
        return sc::integrate(sc::radau_iia<3>(), f, V1(1.0), 0.0, 1.0, {.rtol = 1e-8, .atol = 1e-10});
    };
    const auto one = sc::ensemble(20, decay, 1), four = sc::ensemble(20, decay, 4),
               all = sc::ensemble(20, decay);
    BOOST_TEST(four.size() == 20u);
    for (std::size_t k = 0; k < 20; ++k) {
        BOOST_TEST(four[k].y[0] == one[k].y[0]);
        BOOST_TEST(all[k].y[0] == one[k].y[0]);
        BOOST_TEST(std::abs(four[k].y[0] - std::exp(-(static_cast<double>(k) + 1))) < 1e-8);
    }
    BOOST_TEST(sc::ensemble(0, decay).empty());
}

BOOST_AUTO_TEST_CASE(the_first_exception_is_kept_and_no_run_is_begun_after_it) {
    std::atomic<int> begun{0};
    const auto run = [&](int k) {
        ++begun;
        if (k == 5) throw std::domain_error("run 5");
        return k;
    };
    for (const int threads : {1, 3}) {
        begun = 0;
        BOOST_CHECK_EXCEPTION(sc::ensemble(1000, run, threads), std::domain_error,
                              [](const auto& e) { return std::string(e.what()) == "run 5"; });
        BOOST_TEST(begun >= 6);
        if (threads == 1) BOOST_TEST(begun == 6);
    }
    BOOST_CHECK_THROW(sc::ensemble(-1, run), std::invalid_argument);
    BOOST_CHECK_THROW(sc::ensemble(1, run, -1), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(as_many_threads_as_asked_for_take_part) {
    std::atomic<int> present{0};
    const auto meet = [&](int) {  // ends only when both are here
        ++present;
        while (present < 2) std::this_thread::yield();
        return std::this_thread::get_id();
    };
    const auto ids = sc::ensemble(2, meet, 2);
    BOOST_TEST((std::set(ids.begin(), ids.end()).size() == 2u));
}
