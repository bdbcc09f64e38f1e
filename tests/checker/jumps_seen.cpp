// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE jumps_seen
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/method/blind_spots.hpp>
#include <stagecraft/theory/judging/find_suspects.hpp>
#include <stagecraft/theory/judging/jumps_seen.hpp>
#include <string>

#include "../catalogue.hpp"

namespace sc = stagecraft;
using namespace stagecraft::theory;
using read_once::catalogue, read_once::exact_methods, read_once::rounded;

namespace {

verdict of(const std::string& name) {
    for (const auto& [file, t] : exact_methods())
        if (file == name) return jumps_seen(t);
    return jumps_seen(detail::enclosed_subject(catalogue().at(name)).t);
}

}  // namespace

BOOST_AUTO_TEST_CASE(gaps_in_which_the_weights_differ_by_nothing_are_named) {
    // By hand: both last nodes of Bogacki-Shampine 5(4) are 1, with b_7 + b_8 = b^_7 + b^_8; all stages of SDIRK 4(3)
    // lie at 1/4 and beyond. Of Dormand-Prince 5(4), b_1 - b^_1 = 71/57600 = -(the sum of the others), and b_2 = b^_2.
    BOOST_TEST(of("bogacki_shampine_5_4").text() ==
               "refuted: the embedded estimate sees no jump of f in (3/4, 1)");
    BOOST_TEST(of("sdirk_4_3").text() == "refuted: the embedded estimate sees no jump of f in (0, 1/4)");
    const verdict dormand = of("dormand_prince_5_4");
    BOOST_TEST(dormand.is_proved());
    BOOST_TEST(dormand.reason().ends_with("show least in the embedded estimate, 71/57600 times their size"));
}

BOOST_AUTO_TEST_CASE(rounded_pairs_are_proved_to_see_jumps_or_left_open) {
    BOOST_TEST(of("dormand_prince_8_5_3").is_proved());
    // what is 0 up to the decimals given is not refuted
    for (const auto& [name, file] : catalogue())
        if (!file.b_embedded.empty() && file.kind() == sc::tableaux::number_kind::rounded)
            BOOST_TEST(!of(name).is_refuted(), name);
}

BOOST_AUTO_TEST_CASE(what_the_steppers_watch_is_what_the_theory_calls_blind) {
    // The steppers call a pair blind as well where the error is more than 200 times what the estimate shows.
    int blind = 0, seeing = 0;
    for (const auto& [name, file] : catalogue()) {
        if (file.b_embedded.empty()) continue;
        const auto t = rounded(name);
        Eigen::VectorXd carry;
        const auto is = sc::structure_of(t, carry);
        const Eigen::VectorXd d = t.b - t.b_embedded;
        const auto spots = sc::find_blind_spots(t, is, d, sc::classical_order(t));
        const verdict v = of(name);
        double least = 1;  // that the estimate shows of a jump, the gaps sampled
        for (int k = 0; k < 1000; ++k) {
            double sum = 0;
            for (int i = 0; i < t.stages(); ++i) sum += t.c[i] > (k + 0.5) / 1000 ? d[i] : 0;
            least = std::min(least, std::abs(sum));
        }
        ++(v.is_proved() ? seeing : blind);
        if (!v.is_proved()) BOOST_TEST(spots.count() > 0, name << ": " << v.text());
        if (v.is_proved()) BOOST_TEST((spots.count() == 0 || least < 1.0 / sc::blind_ratio), name);
        BOOST_TEST((least > 1e-14) == v.is_proved(), name << ": " << v.text());
    }
    BOOST_TEST(blind > 5);
    BOOST_TEST(seeing > 20);
}
