// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE rooted_tree
#include <boost/test/unit_test.hpp>
#include <map>
#include <set>
#include <stagecraft/method/rooted_tree.hpp>
#include <stagecraft/method/tree_table.hpp>
#include <stdexcept>
#include <vector>

using namespace stagecraft;

namespace {

const rooted_tree tau;

// Independent definitions by recursion over children, to compare the loops over level sequences with.
std::int64_t density_by_recursion(const rooted_tree& t) {
    std::int64_t r = order(t);
    for (const auto& child : children(t)) r *= density_by_recursion(child);
    return r;
}
std::int64_t symmetry_by_recursion(const rooted_tree& t) {
    std::int64_t r = 1;
    std::map<rooted_tree, int> count;
    for (const auto& child : children(t)) r *= symmetry_by_recursion(child) * ++count[child];
    return r;
}

}  // namespace

BOOST_AUTO_TEST_CASE(counts_are_those_of_the_literature) {
    const std::vector<std::int64_t> expected{1, 1, 2, 4, 9, 20, 48, 115, 286, 719, 1842, 4766, 12486, 32973};
    std::int64_t total = 0;
    for (int n = 1; n <= 14; ++n) {
        std::int64_t count = 0;
        rooted_tree last;
        for (const rooted_tree& t : trees_of_order(n)) {
            if (count > 0) BOOST_REQUIRE(t < last);  // strictly decreasing: no tree twice
            last = t;
            ++count;
            BOOST_REQUIRE_EQUAL(order(t), n);
        }
        BOOST_TEST(count == expected[n - 1]);
        BOOST_TEST(number_of_trees(n) == expected[n - 1]);
        total += count;
        if (n == 10) BOOST_TEST(total == 1205);
    }
    BOOST_TEST(total == 53272);
    BOOST_TEST(number_of_trees(20) == 12826228);
}

BOOST_AUTO_TEST_CASE(iterator_yields_canonical_forms_that_the_constructor_keeps) {
    for (const rooted_tree& t : trees_of_order(9)) {
        const std::vector<int> levels(t.levels().begin(), t.levels().end());
        BOOST_REQUIRE(rooted_tree(std::span<const int>(levels)) == t);
    }
    BOOST_TEST((rooted_tree{1, 2, 2, 3} == rooted_tree{1, 2, 3, 2}));
    BOOST_TEST((rooted_tree{1, 2, 2, 3, 2, 3, 4} == rooted_tree{1, 2, 3, 4, 2, 3, 2}));
    BOOST_TEST((rooted_tree{1, 2, 3, 3} != rooted_tree{1, 2, 3, 2}));
}

BOOST_AUTO_TEST_CASE(malformed_level_sequences_are_refused) {
    BOOST_CHECK_THROW((rooted_tree{0, 1}), std::invalid_argument);
    BOOST_CHECK_THROW((rooted_tree{1, 1}), std::invalid_argument);
    BOOST_CHECK_THROW((rooted_tree{1, 3}), std::invalid_argument);
    BOOST_CHECK_THROW((rooted_tree{2}), std::invalid_argument);
    BOOST_CHECK_THROW(rooted_tree(std::span<const int>()), std::invalid_argument);
    BOOST_CHECK_THROW(rooted_tree(std::span<const int>(std::vector<int>(21, 2))), std::invalid_argument);
    BOOST_CHECK_THROW(tall_tree(0), std::invalid_argument);
    BOOST_CHECK_THROW(tall_tree(21), std::invalid_argument);
    BOOST_CHECK_THROW(butcher_product(tall_tree(10), tall_tree(11)), std::invalid_argument);
    BOOST_CHECK_THROW(number_of_trees(21), std::invalid_argument);
    BOOST_CHECK_THROW(tree_table(0), std::invalid_argument);
    BOOST_CHECK_THROW(tree_table(21), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(densities_symmetries_and_labelings_of_order_five) {
    // Hairer-Norsett-Wanner I, table II.2.2 (there in another order): gamma and alpha of the nine trees.
    struct row {
        rooted_tree tree;
        std::int64_t density, labelings;
    };
    const std::vector<row> table{
        {join({tau, tau, tau, tau}), 5, 1},           {join({join({tau}), tau, tau}), 10, 6},
        {join({join({tau, tau}), tau}), 15, 4},       {join({join({join({tau})}), tau}), 30, 4},
        {join({join({tau}), join({tau})}), 20, 3},    {join({join({tau, tau, tau})}), 20, 1},
        {join({join({join({tau}), tau})}), 40, 3},    {join({join({join({tau, tau})})}), 60, 1},
        {join({join({join({join({tau})})})}), 120, 1}};
    std::set<rooted_tree> seen;
    for (const auto& [tree, gamma, alpha] : table) {
        BOOST_TEST(order(tree) == 5);
        BOOST_TEST(density(tree) == gamma);
        BOOST_TEST(labelings(tree) == alpha);
        seen.insert(tree);
    }
    BOOST_TEST(seen.size() == 9U);
}

BOOST_AUTO_TEST_CASE(labelings_of_an_order_sum_to_the_factorial) {
    for (int n = 1; n <= 11; ++n) {
        std::int64_t sum = 0;
        for (const rooted_tree& t : trees_of_order(n)) {
            BOOST_REQUIRE_EQUAL(density(t), density_by_recursion(t));
            BOOST_REQUIRE_EQUAL(symmetry(t), symmetry_by_recursion(t));
            BOOST_REQUIRE_EQUAL(factorial(n) % (density(t) * symmetry(t)), 0);
            sum += labelings(t);
        }
        BOOST_TEST(sum == factorial(n - 1));
    }
}

BOOST_AUTO_TEST_CASE(children_and_join_are_inverse) {
    for (const rooted_tree& t : trees_of_order(8)) BOOST_REQUIRE(join(children(t)) == t);
    BOOST_TEST((join({}) == tau));
}

BOOST_AUTO_TEST_CASE(butcher_product_attaches_at_the_root) {
    BOOST_TEST((butcher_product(tau, tau) == rooted_tree{1, 2}));
    const rooted_tree u{1, 2, 2};
    BOOST_TEST((butcher_product(u, tall_tree(2)) == rooted_tree{1, 2, 3, 2, 2}));
    BOOST_TEST((butcher_product(tall_tree(2), u) == rooted_tree{1, 2, 3, 3, 2}));
    // (u∘v)∘w = (u∘w)∘v, but in general not u∘(v∘w)
    const rooted_tree v = tall_tree(3), w{1, 2, 2, 2};
    BOOST_TEST((butcher_product(butcher_product(u, v), w) == butcher_product(butcher_product(u, w), v)));
    BOOST_TEST((butcher_product(butcher_product(u, v), w) != butcher_product(u, butcher_product(v, w))));
}

BOOST_AUTO_TEST_CASE(table_of_factors_lists_the_same_trees_as_the_iterator) {
    const tree_table table(11);
    const tree_view& view = table.view();
    for (int n = 1; n <= 11; ++n) {
        std::set<rooted_tree> from_table;
        for (std::uint32_t i = view.first[n]; i < view.first[n + 1]; ++i) {
            const rooted_tree t = view.tree(i);
            from_table.insert(t);
            BOOST_REQUIRE_EQUAL(view.rows[i].order, order(t));
            BOOST_REQUIRE_EQUAL(view.rows[i].density, density(t));
            BOOST_REQUIRE_EQUAL(view.rows[i].symmetry, symmetry(t));
            if (n < 11) BOOST_REQUIRE(view.tree(view.planted(i)) == join({t}));
        }
        BOOST_TEST(view.first[n + 1] - view.first[n] == number_of_trees(n));
        const trees_of_order range(n);
        BOOST_TEST((from_table == std::set<rooted_tree>(range.begin(), range.end())));
    }
}

BOOST_AUTO_TEST_CASE(trees_work_at_compile_time) {
    static_assert(density(rooted_tree{1, 2, 3, 3}) == 12);
    static_assert(symmetry(rooted_tree{1, 2, 3, 3}) == 2);
    static_assert(labelings(rooted_tree{1, 2, 3, 2}) == 3);
    static_assert(butcher_product(rooted_tree{1, 2}, rooted_tree{1, 2}) == rooted_tree{1, 2, 3, 2});
    constexpr fixed_tree_table<8> table;
    static_assert(table.size() == 200);
    const tree_table same(8);
    for (std::uint32_t i = 0; i < same.size(); ++i)
        BOOST_REQUIRE(table.view().tree(i) == same.view().tree(i));
}
