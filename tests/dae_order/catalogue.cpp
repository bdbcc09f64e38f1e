// SPDX-License-Identifier: BSL-1.0
// What the theorems on index 2 promise is compared, for every exact catalogue tableau, with what the exact
// order conditions of index 2 say: a promise above them would be a wrong theorem or a wrong hypothesis.
#define BOOST_TEST_MODULE catalogue
#include <boost/test/unit_test.hpp>
#include <map>
#include <stagecraft/theory/dae/dae_order.hpp>

#include "../catalogue.hpp"

using namespace stagecraft;
using namespace stagecraft::theory;

BOOST_AUTO_TEST_CASE(no_theorem_promises_more_than_the_exact_conditions_of_index_2) {
    std::map<std::string, int> used;
    int none = 0, left = 0;
    for (const auto& [name, t] : read_once::exact_methods()) {
        const auto traits = dae_traits_of(t);
        if (traits.left_stage && traits.stiff) {  // Lobatto IIIA, ESDIRK methods
            ++left;
            BOOST_TEST(predict_index2(t).applies(), name);
            continue;
        }
        if (!traits.regular) {
            ++none;
            const auto p = predict_index2(t);
            BOOST_TEST(!p.applies(), name);
            BOOST_TEST(p.theorem == "none", name);
            continue;
        }
        const int reach = std::min(traits.simplifying.B + 1, 6);
        const auto all = index2_theorems(t, reach);
        const auto& conditions = all.back();
        for (std::size_t k = 0; k + 1 < all.size(); ++k) {
            if (!all[k].applies()) continue;
            ++used[all[k].theorem];
            if (!conditions.applies()) continue;  // |R(inf)| = 1: the local orders alone do not decide
            BOOST_TEST(std::min(*all[k].y, reach) <= *conditions.y, name + ": " + all[k].theorem);
            BOOST_TEST(std::min(*all[k].z, reach) <= *conditions.z, name + ": " + all[k].theorem);
        }
    }
    BOOST_TEST(none >= 30);  // explicit methods, Lobatto IIIB: the prediction says so
    BOOST_TEST(left >= 7);
    BOOST_TEST(used.size() == 5U);
    for (const auto& [theorem, count] : used) BOOST_TEST(count >= 2, theorem);
}
