// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE entry
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/test/unit_test.hpp>
#include <stagecraft/tableaux/entry.hpp>
#include <stagecraft/tableaux/polynomial_text.hpp>

using namespace stagecraft::tableaux;

namespace {
std::string exact(std::string_view text) { return read_entry(text).exact.value().str(); }

std::string complaint(std::string_view text) {
    try {
        read_entry(text);
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
    return "none";
}
}  // namespace

BOOST_AUTO_TEST_CASE(expressions_are_evaluated_exactly) {
    BOOST_TEST(exact("-3544/2565") == "-3544/2565");
    BOOST_TEST(exact("\xE2\x88\x92"
                     "3/4") == "-3/4");
    BOOST_TEST(exact(" 1 / 2 - 1/6 * sqrt( 3 ) ") == "1/2-1/6*sqrt(3)");
    BOOST_TEST(exact("(4-sqrt(6))/10") == "2/5-1/10*sqrt(6)");
    BOOST_TEST(exact("1/(3-sqrt(5))") == "3/4+1/4*sqrt(5)");
    BOOST_TEST(exact("-2^2") == "-4");
    BOOST_TEST(exact("2^-2") == "1/4");
    BOOST_TEST(exact("2^3^2") == "512");
    BOOST_TEST(exact("8-4-2") == "2");
    BOOST_TEST(exact("8/4/2") == "1");
    BOOST_TEST(exact("--1") == "1");
    BOOST_TEST(exact("2*-3") == "-6");
    BOOST_TEST(exact("010") == "10");
    BOOST_TEST(exact("3^(1/2)") == "sqrt(3)");
    BOOST_TEST(exact("(8/27)^(2/3)") == "4/9");
    BOOST_TEST(exact("cbrt(-8)") == "-2");
    BOOST_TEST(exact("sqrt(2)^2") == "2");
    BOOST_TEST(exact("sqrt(3+2*sqrt(2))") == "1+sqrt(2)");
    BOOST_TEST(exact("1^(10^9)") == "1");
    BOOST_TEST(exact("(-1)^(10^9+1)") == "-1");
    BOOST_TEST(exact("0^(10^9)") == "0");
}

BOOST_AUTO_TEST_CASE(decimals_are_uncertain_by_half_a_unit_of_the_last_digit) {
    const entry x = read_entry("0.25");
    BOOST_TEST(x.rounded);
    BOOST_TEST(!x.exact);
    BOOST_TEST(x.enclosure.lower == rational(49, 200));
    BOOST_TEST(x.enclosure.upper == rational(51, 200));
    BOOST_TEST(read_entry("-1.5e-3").uncertainty() == rational(1, 20000));
    BOOST_TEST(read_entry(".5").uncertainty() == rational(1, 20));
    BOOST_TEST(read_entry("3.").uncertainty() == rational(1, 2));
    BOOST_TEST(read_entry("1e2").uncertainty() == 50);
    BOOST_TEST(read_entry("2*0.25").uncertainty() == rational(1, 100));
    BOOST_TEST(!read_entry("1/4").rounded);
}

BOOST_AUTO_TEST_CASE(whole_numbers_with_a_point_are_exact_in_expressions) {
    // as programs divide: SUN_RCONST(439.0)/SUN_RCONST(216.0)
    BOOST_TEST(exact("439.0/216.0") == "439/216");
    BOOST_TEST(exact("-1./3.") == "-1/3");
    BOOST_TEST(exact("(4.0-sqrt(6.0))/10.0") == "2/5-1/10*sqrt(6)");
    BOOST_TEST(read_entry("439.0/216.0").digits == 0);
    BOOST_TEST(read_entry("2.0*0.25").uncertainty() == rational(1, 100));  // of 0.25 alone
    BOOST_TEST(read_entry("2.5/3.0").rounded);
    BOOST_TEST(read_entry("2.00*3").rounded);  // two places are a measured 2
    BOOST_TEST(read_entry("2.0").rounded);
    BOOST_TEST(read_entry("-2.0").rounded);
}

BOOST_AUTO_TEST_CASE(a_double_is_uncertain_by_half_an_ulp) {
    const entry x = entry_from_double(0.1);
    BOOST_TEST(x.enclosure.contains(rational(1, 10)));
    BOOST_TEST(!x.enclosure.contains(rational(1, 10) + scaled(1, -56)));
    BOOST_TEST(x.enclosure.middle() == scaled(rational(0x1999999999999a), -56));
    BOOST_TEST(entry_from_double(-0.5).enclosure.middle() == rational(-1, 2));
    BOOST_TEST(entry_from_double(0).enclosure.middle() == 0);
    BOOST_CHECK_THROW(entry_from_double(std::nan("")), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(three_or_nested_surds_are_enclosed_to_a_hundred_digits_and_two_are_exact) {
    BOOST_TEST(exact("sqrt(3)+sqrt(2)") == "sqrt(2)+sqrt(3)");
    BOOST_TEST(exact("1/(sqrt(7)-sqrt(5))") == "1/2*sqrt(5)+1/2*sqrt(7)");
    BOOST_TEST(exact("sqrt(5+2*sqrt(6))") == "sqrt(2)+sqrt(3)");
    using wide = boost::multiprecision::cpp_bin_float_100;
    for (const auto& [text, value] :
         {std::pair("sqrt(2)+sqrt(3)+sqrt(5)", wide(sqrt(wide(2)) + sqrt(wide(3)) + sqrt(wide(5)))),
          std::pair("1/(2-cbrt(2))", wide(1 / (2 - cbrt(wide(2))))),
          std::pair("5^(2/3)-3^(-1/4)", wide(pow(wide(5), wide(2) / 3) - pow(wide(3), wide(-1) / 4))),
          std::pair("sqrt(3/7-2/7*sqrt(6/5))", wide(sqrt(wide(3) / 7 - wide(2) / 7 * sqrt(wide(6) / 5)))),
          std::pair("1/(sqrt(5)-sqrt(7)+sqrt(2))",
                    wide(1 / (sqrt(wide(5)) - sqrt(wide(7)) + sqrt(wide(2)))))}) {
        const entry x = read_entry(text);
        BOOST_TEST(!x.exact);
        BOOST_TEST(!x.rounded);
        BOOST_TEST(x.enclosure.width() < scaled(1, -350));
        BOOST_TEST(abs(wide(x.enclosure.middle().to<wide>() - value)) < wide("1e-98"));
    }
}

BOOST_AUTO_TEST_CASE(a_long_product_of_surds_keeps_a_narrow_enclosure) {
    std::string text = "1";
    for (int i = 0; i < 60; ++i) text += "*(sqrt(2)+sqrt(3)+sqrt(5))/(sqrt(5)+sqrt(3)+sqrt(2))";
    const range r = read_entry(text).enclosure;
    BOOST_TEST(r.contains(1));
    BOOST_TEST(r.width() < scaled(1, -380));
    BOOST_TEST(bit_size(r.lower) < 1000);
}

BOOST_AUTO_TEST_CASE(what_is_wrong_is_said) {
    BOOST_TEST(complaint("1/0") == "division by zero");
    BOOST_TEST(complaint("1/(1-sqrt(4)/2)") == "division by zero");
    BOOST_TEST(complaint("0^-1") == "division by zero");
    BOOST_TEST(complaint("1/0.0") == "division by zero");
    BOOST_TEST(complaint("sqrt(-2)") == "square root of a negative number");
    BOOST_TEST(complaint("sqrt(1-sqrt(2))") == "square root of a negative number");
    BOOST_TEST(complaint("sqrt(sqrt(2)-sqrt(3))") == "square root of a negative number");
    BOOST_TEST(complaint("phi/2") == "unknown symbol 'phi'");
    BOOST_TEST(complaint("1+tan(2)") == "unknown symbol 'tan'");
    BOOST_TEST(complaint("sqrtx(2)") == "unknown symbol 'sqrtx'");
    BOOST_TEST(complaint("nan") == "unknown symbol 'nan'");
    BOOST_TEST(complaint("inf") == "unknown symbol 'inf'");
    BOOST_TEST(complaint("") == "is empty");
    BOOST_TEST(complaint("1+") == "ends too early");
    BOOST_TEST(complaint("(1") == "ends too early");
    BOOST_TEST(complaint("1)") == "unexpected ')' at character 2");
    BOOST_TEST(complaint("1 2") == "unexpected '2' at character 3");
    BOOST_TEST(complaint("2sqrt(2)") == "a * is missing before 'sqrt'");
    BOOST_TEST(complaint("(1+pi) cos(2)") == "a * is missing before 'cos'");
    BOOST_TEST(complaint("2(3)") == "a * is missing before '('");
    BOOST_TEST(complaint("2tan(1)") == "unknown symbol 'tan'");
    BOOST_TEST(complaint("1e99999999999999999999") == "non-finite: exponent 99999999999999999999");
    BOOST_TEST(complaint("1,5") == "unexpected ',' at character 2");
    BOOST_TEST(complaint("2^(1/13)") ==
               "an exponent must be an integer or a fraction with a denominator up to 12");
    BOOST_TEST(complaint("(-8)^(1/3)") == "root of a negative number");
    BOOST_TEST(complaint("2^(10^9)") == "too large a power");
    BOOST_TEST(complaint("(1/3)^(-10^9)") == "too large a power");
    BOOST_TEST(complaint("9^9^9^9^9^9") == "too large a power");
    BOOST_TEST(complaint("1e999999999").substr(0, 10) == "non-finite");
    BOOST_TEST(complaint("1e400").substr(0, 10) == "non-finite");
    BOOST_TEST(complaint(std::string(4000, '(')) == "nested too deeply");
    BOOST_TEST(complaint(std::string(4000, '-') + "1") == "nested too deeply");
    BOOST_TEST(complaint(std::string(5000, '1')) == "longer than 4096 characters");
}

BOOST_AUTO_TEST_CASE(the_deepest_accepted_nesting_is_read) {
    std::string text = "1";
    for (int i = 0; i < 100; ++i) text = "(" + text + "+1)";
    BOOST_TEST(exact(text) == "101");
}

BOOST_AUTO_TEST_CASE(polynomials_are_read_exactly) {
    using poly = polynomial<rational>;
    const poly radau{rational(-1, 10), rational(9, 10), rational(-9, 5), 1};
    BOOST_TEST((read_polynomial("x^3-9/5*x^2+9/10*x-1/10") == radau));
    BOOST_TEST((read_polynomial("(x-1)*(x^2-4/5*x+1/10)") == radau));
    BOOST_TEST((read_polynomial("(10*x^3-18*x^2+9*x-1)/sqrt(100)") == radau));
    BOOST_TEST((read_polynomial("-x^2+2^-1") == poly{rational(1, 2), 0, -1}));
    for (const auto* bad : {"y", "xx", "1/x", "x^x", "sqrt(x)", "x^65", "0.5*x", "sqrt(2)*x", "x/0", "x+",
                            "2x", "x^(-1)", "x^(1/2)", "((x^64)^64)"})
        BOOST_CHECK_THROW(read_polynomial(bad), std::invalid_argument);
    BOOST_TEST(complaint("x") == "unknown symbol 'x'");
}
