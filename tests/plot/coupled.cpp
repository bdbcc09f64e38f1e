// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE coupled
#include <boost/test/unit_test.hpp>
#include <complex>
#include <filesystem>
#include <stagecraft/tableaux/read_partitioned.hpp>
#include <stagecraft/theory/plot/coupled_region.hpp>
#include <string>
#include <vector>

// The stability function of an additive pair, against a step of the method.

using namespace stagecraft;
using theory::plot::complex;
using theory::plot::to_double;

namespace {

tableaux::partitioned_file pair(const std::string& name) {
    return std::get<tableaux::partitioned_file>(
        tableaux::read_method_file(STAGECRAFT_SOURCE_DIR "/tableaux/pairs/" + name + ".json"));
}

double value(const tableaux::entry& e) { return to_double(e.enclosure.middle()); }

/// One step with h = 1 for y' = z y + w y from y = 1, z y by the explicit tableau, w y by the implicit one.
complex step(const tableaux::partitioned_file& m, complex z, double w) {
    const auto &e = m.partners[0], &im = m.partners[1];
    std::vector<complex> stages;
    complex y = 1;
    for (std::size_t i = 0; i < e.b.size(); ++i) {
        complex stage = 1;
        for (std::size_t j = 0; j < i; ++j)
            stage += (z * value(e.A[i][j]) + w * value(im.A[i][j])) * stages[j];
        stages.push_back(stage / (1 - w * value(im.A[i][i])));
        y += (z * value(e.b[i]) + w * value(im.b[i])) * stages.back();
    }
    return y;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_stability_function_of_an_additive_pair_is_that_of_its_step) {
    for (const char* name : {"ars_4_4_3", "ark4", "ssp2_3_3_2", "bhr_5_5_3"}) {
        const auto m = pair(name);
        for (const double w : {0.0, -0.5, -10.0, -1000.0}) {
            const auto r = theory::plot::coupled_stability_function(m, w);
            for (const complex z : {complex(0, 0), complex(-1, 0.5), complex(0, 2)})
                BOOST_TEST(std::abs(r(z) - step(m, z, w)) < 1e-10 * (1 + std::abs(r(z))), name);
        }
    }
    BOOST_CHECK_THROW(theory::plot::coupled_stability_function(pair("ruth_3"), 0), std::invalid_argument);
    BOOST_CHECK_THROW(theory::plot::coupled_stability_function(pair("nystrom_5"), 0), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(the_window_follows_the_region_and_not_far_zeros) {
    // (1 + z)(1 + z/100): the region is about the disc around -1, and there is an island at -100.
    const theory::plot::rational_function r{{1, 1.01, 0.01}, {1}};
    const auto w = theory::plot::region_window(r);
    BOOST_TEST(w.left > -10);
    BOOST_TEST(w.left < -2);
    BOOST_TEST(w.top < 5);
}
