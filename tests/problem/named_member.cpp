// SPDX-License-Identifier: BSL-1.0
// What a member named `mass` may be, and where it may come from: found or not, as said here.
#define BOOST_TEST_MODULE named_member
#include <boost/test/unit_test.hpp>
#include <stagecraft/refuse/problem/checked_capabilities.hpp>

namespace sc = stagecraft;
template <class T>
constexpr bool named = sc::detail::has_member_named<T, sc::detail::mass_member>;

struct none {};
struct data {
    double mass;
};
struct function {
    int mass() const;
    int mass(int);
};
struct generic {
    template <class T>
    int mass(T);
};
struct type {
    using mass = int;
};
struct constant {
    static constexpr int mass = 1;
};
class hidden {
    int mass() const;
};
struct derived : hidden {};
struct twice : data, function {};
struct abstract {
    virtual int mass() const = 0;
    virtual ~abstract() = default;
};
struct final_none final {};
struct final_data final {
    double mass;
};
struct final_function final {
    int mass();
};
union overlay {
    double mass;
    int other;
};
using lambda = decltype([](double) {});

BOOST_AUTO_TEST_CASE(a_member_is_found_by_its_name_whatever_it_is) {
    static_assert(named<data> && named<const data> && named<function> && named<generic> && named<type>);
    static_assert(named<constant> && named<hidden> && named<derived> && named<twice> && named<abstract>);
    static_assert(!named<none> && !named<const none> && !named<lambda> && !named<void (*)(int)>);
    BOOST_TEST(named<data>);
}

BOOST_AUTO_TEST_CASE(of_final_classes_and_unions_public_data_and_single_functions_are_found) {
    static_assert(named<final_data> && named<const final_function> && named<overlay>);
    static_assert(!named<final_none>);
    BOOST_TEST(!named<final_none>);
}
