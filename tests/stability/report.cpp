// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE report
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <stagecraft/tableaux/exact_tableau.hpp>
#include <stagecraft/theory/judging/family_report.hpp>
#include <stagecraft/theory/judging/stability_report.hpp>

#include "methods.hpp"

using namespace stagecraft;
using namespace stagecraft::theory;
using stagecraft::tableaux::quadratic;

namespace {

/// The line "  statement  verdict: ..." that begins with `statement`, or nothing.
std::string line(const std::string& text, const std::string& statement) {
    const auto at = text.find("\n  " + statement);
    if (at == std::string::npos) return {};
    return text.substr(at + 3, text.find('\n', at + 1) - at - 3);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_report_states_every_decision_with_its_reason) {
    const auto report = text(stability_report(methods::radau_iia3()));
    BOOST_TEST(line(report, "L-stable") ==
               "L-stable  proved: E(y) = 1/3600*y^6 >= 0, poles in the right half-plane, R(inf) = 0");
    BOOST_TEST(line(report, "R approximates").starts_with("R approximates e^z to order 5"));
    BOOST_TEST(line(report, "poles: ") ==
               "poles: 3.63783425274, 2.68108287363 +- 3.05043019925 i  proved: "
               "enclosed; digits correctly rounded");
    BOOST_TEST(line(report, "index 2") ==
               "index 2: y O(h^5), z O(h^3)  proved: Hairer-Wanner II, Theorem VII.4.9");
    BOOST_TEST(line(report, "singular perturbation")
                   .starts_with("singular perturbation: y O(h^5) + O(eps h^4), lambda O(h^5) + O(eps h^3)"));
    BOOST_TEST(line(report, "A(alpha)") == "A(alpha)-stable up to 90 degrees  proved: A-stable");
    BOOST_TEST(line(report, "real stability interval").starts_with("real stability interval infinite"));
}

BOOST_AUTO_TEST_CASE(the_report_says_where_no_theorem_applies_and_covers_the_embedded_method) {
    auto t = methods::rk4();
    t.b_embedded.resize(4);
    t.b_embedded << methods::q(0), methods::q(1), methods::q(0), methods::q(0);
    const auto sections = stability_report(t);
    BOOST_TEST(sections.back().title == "embedded method: stability function");
    const auto report = text(sections);
    BOOST_TEST(
        line(report, "index 1") ==
        "index 1: a theorem on the order applies  refuted: not: A is regular (det A = 0); not: |R(inf)| "
        "<= 1 (R(inf) is infinite)");
    BOOST_TEST(line(report, "real stability interval").starts_with("real stability interval 2.785293563405"));
    BOOST_TEST(line(report, "A-stable").starts_with("A-stable  refuted: |R(iy)| > 1"));
    // Houwen-Sommeijer 1987: log R(z) - z = -z^5/120 + z^6/144 + ...
    BOOST_TEST(line(report, "dispersion") ==
               "dispersion order 4  proved: y - arg R(iy) = 1/120*y^5 + O(y^7)");
    BOOST_TEST(line(report, "dissipation") ==
               "dissipation order 5  proved: 1 - |R(iy)| = 1/144*y^6 + O(y^8)");
    BOOST_TEST(line(text({sections.back()}), "R approximates").starts_with("R approximates e^z to order 2"));
    t.b_embedded.resize(0);
    BOOST_TEST(stability_report(t).size() == 3U);
}

// 1 + z: arctan y = y - y^3/3 + ..., |1 + iy| = 1 + y^2/2 + ...; z + z^2/2 as well: y - arg R = -y^3/6, 1 - |R| = -y^4/8.
BOOST_AUTO_TEST_CASE(phase_errors_are_those_of_the_closed_forms) {
    const auto check = [](const std::vector<quadratic>& r, int order, const char* turned, int kept,
                          const char* lost) {
        const auto e = phase_errors_of(r, [](const quadratic& d) { return !(d == quadratic(0)); });
        BOOST_TEST(e.dispersion.value().order == order);
        BOOST_TEST(e.dispersion.value().coefficient.str() == turned);
        BOOST_TEST(e.dissipation.value().order == kept);
        BOOST_TEST(e.dissipation.value().coefficient.str() == lost);
    };
    using tableaux::rational;
    check({1, 1}, 2, "1/3", 1, "-1/2");
    check({1, 1, rational(1, 2)}, 2, "-1/6", 3, "-1/8");
    const std::vector<quadratic> rest{1};  // R = 1 turns nothing and loses nothing
    const auto e = phase_errors_of(rest, [](const quadratic& d) { return !(d == quadratic(0)); });
    BOOST_TEST(e.dispersion.value().coefficient.str() == "1");
    BOOST_TEST(!e.dissipation);
}

BOOST_AUTO_TEST_CASE(families_have_the_report_of_their_tableau_and_beyond_it_that_of_legendre_coordinates) {
    for (const auto f : tableaux::all_families) {
        const int s = std::max(2, tableaux::least_stages(f));
        const auto t = tableaux::exact_tableau(f, s);
        BOOST_REQUIRE(t.has_value());
        const auto exact = text(stability_report(*t));
        BOOST_TEST(text(stability_report(f, s)) == exact);
        // The traits that longer members take: the same theorems apply to the short one.
        const auto m = theory::detail::family_traits(f, s, certify(f, s));
        const auto expected = dae_traits_of(*t);
        BOOST_TEST(m.order == expected.order);
        BOOST_TEST((m.simplifying == expected.simplifying));
        BOOST_TEST(m.regular == expected.regular);
        BOOST_TEST(m.stiff == expected.stiff);
        BOOST_TEST(m.collocation == expected.collocation);
        BOOST_TEST(m.zero_node == expected.zero_node);
        BOOST_TEST(m.ends_at_one == expected.ends_at_one);
        BOOST_TEST(m.r_infinity.has_value() == expected.r_infinity.has_value());
        if (m.r_infinity) BOOST_TEST((quadratic(*m.r_infinity) == *expected.r_infinity));
    }
    const auto radau = text(stability_report(tableaux::family::radau_iia, 6));
    BOOST_TEST(line(radau, "index 2") ==
               "index 2: y O(h^11), z O(h^6)  proved: Hairer-Wanner II, Theorem VII.4.9");
}

BOOST_AUTO_TEST_CASE(sectors_are_printed_to_thirteen_places) {
    const auto claims = function_claims(pade<methods::rational>(0, 5));
    const auto found = std::find_if(claims.begin(), claims.end(), [](const claim& c) {
        return c.statement.starts_with("A(alpha)-stable up to 79.11386457319");
    });
    BOOST_TEST((found != claims.end()));
}
