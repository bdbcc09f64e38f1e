// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE dual_number
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <sstream>
#include <stagecraft/jacobian/automatic.hpp>
#include <stagecraft/jacobian/reverse_functions.hpp>

using namespace stagecraft;
using wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_100::backend_type,
                                           boost::multiprecision::et_off>;
using dual2 = dual_number<double, 2>;
using dual22 = dual_number<dual2, 2>;

namespace {

constexpr int size = 17;

// Every function and operator that dual numbers have, positive arguments.
const auto functions = [](const auto& x, const auto& y) {
    using std::abs, std::acos, std::acosh, std::asin, std::asinh, std::atan, std::atan2, std::atanh,
        std::cbrt, std::ceil, std::copysign, std::cos, std::cosh, std::erf, std::erfc, std::exp, std::expm1,
        std::floor, std::fmod, std::log, std::log10, std::log1p, std::max, std::min, std::pow, std::round,
        std::sin, std::sinh, std::sqrt, std::tan, std::tanh, std::trunc;
    using S = std::remove_cvref_t<decltype(x)>;
    Eigen::Matrix<S, size, 1> r;
    r[0] = sqrt(x * y + 1) - 2 / y;
    r[1] = exp(-x / 3) * log(y);
    r[2] = sin(x) + cos(2 * y) * tan(x / 4);
    r[3] = asin(x / 4) * acos(y / 4) + atan(x * y);
    r[4] = sinh(x) - cosh(y) / tanh(x + y);
    r[5] = atan2(x, y) + abs(x - 5) + abs(y);
    r[6] = pow(x, 3) + pow(y, S(5) / 2) / 7;
    r[7] = pow(x, y) + pow(S(3) / 2, y) + pow(2 - y, 2);
    r[8] = max(x, y) * min(x, y) + max(x, S(0)) + min(S(100), y);
    r[9] = x / y - y / x + (x - y) * (1 + x);
    r[10] = 4 - x + (-y) + 3 * x - y / 2;
    r[11] = pow(sqrt(x), 4) / (1 + pow(y, -2));
    r[12] = asinh(x * y) + acosh(x + y) + atanh(x * y / 2);
    r[13] = erf(x * y) + erfc(x - y) + erf(-y);
    r[14] = expm1(x / y) + log1p(x * y) + log10(x + y) + cbrt(x / y);
    r[15] = floor(3 * x) * y + ceil(x) * x + round(2 * x - y) * y + trunc(-2 * x) * x;
    r[16] = fmod(5 * x, y) + fmod(-5 * x, y) + copysign(x * y, y - x);
    return r;
};

// By central differences in 100 digits: a method that knows nothing of the rules of differentiation.
Eigen::Matrix<wide, size, 1> difference(const wide& x, const wide& y, const wide& dx, const wide& dy) {
    const wide h("1e-30");
    return (functions(wide(x + h * dx), wide(y + h * dy)) - functions(wide(x - h * dx), wide(y - h * dy))) /
           (2 * h);
}

}  // namespace

BOOST_AUTO_TEST_CASE(derivatives_agree_with_differences_in_100_digits) {
    const double x = 1.25, y = 0.75;
    const auto r = functions(dual2(x, Eigen::Vector2d(1, 0)), dual2(y, Eigen::Vector2d(0, 1)));
    for (int k = 0; k < 2; ++k) {
        const auto expected = difference(x, y, k == 0 ? 1 : 0, k == 0 ? 0 : 1);
        for (int i = 0; i < size; ++i) {
            BOOST_TEST(r[i].value() == static_cast<double>(functions(wide(x), wide(y))[i]),
                       boost::test_tools::tolerance(1e-14));
            BOOST_TEST(r[i].derivatives()[k] == static_cast<double>(expected[i]),
                       boost::test_tools::tolerance(1e-13));
        }
    }
}

BOOST_AUTO_TEST_CASE(the_reverse_mode_agrees_with_differences_in_100_digits) {
    const double x = 1.25, y = 0.75;
    tape<double> operations;
    operations.start(2);
    const auto r =
        functions(reverse_number<double>(x, &operations, 0), reverse_number<double>(y, &operations, 1));
    const auto by_x = difference(x, y, 1, 0), by_y = difference(x, y, 0, 1),
               value = functions(wide(x), wide(y));
    const auto near = boost::test_tools::tolerance(1e-13);
    for (int i = 0; i < size; ++i) {
        operations.clear_adjoints();
        operations.seed(r[i].number(), 1);
        operations.sweep();
        BOOST_TEST(r[i].value() == static_cast<double>(value[i]), near);
        BOOST_TEST(operations.adjoint(0) == static_cast<double>(by_x[i]), near);
        BOOST_TEST(operations.adjoint(1) == static_cast<double>(by_y[i]), near);
    }
    // What is computed from plain numbers alone is on no tape, and has no adjoints to give.
    const reverse_number<double> constant = sqrt(reverse_number<double>(2)) + 1;
    BOOST_TEST(constant.number() < 0);
    BOOST_TEST(constant.value() == std::sqrt(2.0) + 1);
}

BOOST_AUTO_TEST_CASE(second_derivatives_are_dual_numbers_of_dual_numbers) {
    const wide x = 1.25, y = 0.75, h("1e-30");
    dual22 a(dual2(1.25, Eigen::Vector2d(1, 0))), b(dual2(0.75, Eigen::Vector2d(0, 1)));
    a.derivatives()[0] = 1;
    b.derivatives()[1] = 1;
    const auto r = functions(a, b);
    const Eigen::Matrix<wide, size, 1> xy =
        (difference(x, y + h, 1, 0) - difference(x, y - h, 1, 0)) / (2 * h);
    for (int i = 0; i < size; ++i) {
        BOOST_TEST(std::abs(r[i].derivatives()[0].derivatives()[1] - static_cast<double>(xy[i])) < 1e-12);
        BOOST_TEST(std::abs(r[i].derivatives()[1].derivatives()[0] - static_cast<double>(xy[i])) < 1e-12);
    }
}

// Those which 100 digits do not have, against closed forms.
BOOST_AUTO_TEST_CASE(the_other_functions_have_the_derivatives_of_their_closed_forms) {
    using one = dual_number<double, 1>;
    const auto at = [](double x) { return one(x, Eigen::Matrix<double, 1, 1>(1)); };
    const auto slope = [](const one& x) { return x.derivatives()[0]; };
    const auto near = boost::test_tools::tolerance(1e-15);
    const one x = at(1.7);
    BOOST_TEST(exp2(x).value() == std::exp2(1.7));
    BOOST_TEST(slope(exp2(x)) == std::log(2.0) * std::exp2(1.7), near);
    BOOST_TEST(slope(log2(x)) == 1 / (1.7 * std::log(2.0)), near);
    BOOST_TEST(slope(hypot(x, one(2), one(3))) == 1.7 / std::hypot(1.7, 2, 3), near);
    BOOST_TEST(slope(hypot(one(0), one(0), x)) == 1);
    BOOST_TEST(hypot(x, 2).value() == std::hypot(1.7, 2));
    BOOST_TEST(slope(atan2(1, x)) == -1 / (1 + 1.7 * 1.7), near);
    BOOST_TEST((rint(x).value() == 2 && slope(rint(x)) == 0));
    BOOST_TEST((nearbyint(x).value() == 2 && slope(nearbyint(x)) == 0));
    BOOST_TEST((remainder(x, 1).value() == std::remainder(1.7, 1.0) && slope(remainder(x, 1)) == 1));
    BOOST_TEST(
        (slope(fmod(3.5, x)) == -2 && slope(remainder(3.5, x)) == -2 && slope(remainder(3.3, x)) == -2));
    const one nan = std::numeric_limits<double>::quiet_NaN();
    BOOST_TEST((fmax(x, nan).value() == 1.7 && fmin(nan, x).value() == 1.7));
    BOOST_TEST((slope(fmax(x, 1)) == 1 && slope(fmax(x, 2.f)) == 0 && slope(fmin(2, x)) == 1));
    BOOST_TEST(
        (slope(copysign(x, -1)) == -1 && copysign(1.0, -x).value() == -1 && slope(copysign(-x, 1)) == 1));
    BOOST_TEST((signbit(-x) && !signbit(x) && signbit(one(-0.0))));
}

// What users write and what gave wrong derivatives in silence with a library of expression templates.
BOOST_AUTO_TEST_CASE(results_kept_with_auto_and_returned_keep_their_derivatives) {
    const auto energy = [](const auto& v) { return 0.5 * v.squaredNorm(); };
    dual_vector<double, 3> v;
    for (int i = 0; i < 3; ++i) v[i] = dual<double, 3>(i + 1, Eigen::Vector3d::Unit(i));
    const auto e = energy(v);
    for (int i = 0; i < 3; ++i) BOOST_TEST(e.derivatives()[i] == i + 1.0);
    const auto product = 2 * v[0] * v[1], wave = sin(product);
    const dual<double, 3> sum = wave + product;
    BOOST_TEST(sum.derivatives()[0] == 4 * (std::cos(4.0) + 1), boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(matrices_are_filled_from_numbers_of_any_type) {
    const dual22 x(dual2(2, Eigen::Vector2d(1, 0)), Eigen::Matrix<dual2, 2, 1>(dual2(1), dual2(0)));
    Eigen::Matrix<dual22, 2, 3> G;
    G << x, 0, 0, 1, 2.5f, x * x;
    BOOST_TEST(G(0, 0).derivatives()[0].value() == 1);
    BOOST_TEST(G(0, 1).value().value() == 0);
    BOOST_TEST(G(1, 0).value().value() == 1);
    BOOST_TEST(G(1, 1).value().value() == 2.5);
    BOOST_TEST(G(1, 2).derivatives()[0].value() == 4);           // d(x^2)/dx at 2
    BOOST_TEST(G(1, 2).derivatives()[0].derivatives()[0] == 2);  // its second derivative
    BOOST_TEST((3 * G * G.transpose())(1, 1).value().value() == 3 * (1 + 6.25 + 16));
    BOOST_TEST((G.row(1).norm()).value().value() == std::sqrt(1 + 6.25 + 16));
}

// As right-hand sides of plain numbers are written; each is the function of the same name without std::.
BOOST_AUTO_TEST_CASE(functions_may_be_called_with_std) {
    const dual2 x(0.75, Eigen::Vector2d(1, 0)), y(-1.25, Eigen::Vector2d(0, 1)), one = 1;
    const auto same = [](const dual2& a, const dual2& b) {
        BOOST_TEST(a.value() == b.value());
        BOOST_TEST((a.derivatives() == b.derivatives()));
    };
    same(std::sin(x) + std::cos(x) + std::tan(x), sin(x) + cos(x) + tan(x));
    same(std::asin(x) + std::acos(x) + std::atan(x), asin(x) + acos(x) + atan(x));
    same(std::sinh(x) + std::cosh(x) + std::tanh(x), sinh(x) + cosh(x) + tanh(x));
    same(std::asinh(x) + std::acosh(one + x) + std::atanh(x), asinh(x) + acosh(one + x) + atanh(x));
    same(std::exp(x) + std::exp2(x) + std::expm1(x), exp(x) + exp2(x) + expm1(x));
    same(std::log(x) + std::log2(x) + std::log10(x) + std::log1p(x), log(x) + log2(x) + log10(x) + log1p(x));
    same(std::abs(y) + std::fabs(y) + std::sqrt(x) + std::cbrt(x), abs(y) + fabs(y) + sqrt(x) + cbrt(x));
    same(std::erf(x) + std::erfc(y), erf(x) + erfc(y));
    same(std::floor(y) + std::ceil(y) + std::trunc(y) + std::round(y),
         floor(y) + ceil(y) + trunc(y) + round(y));
    same(std::rint(y) + std::nearbyint(y), rint(y) + nearbyint(y));
    same(std::pow(x, 3) + std::pow(2.0, x) + std::pow(x, y), pow(x, 3) + pow(2.0, x) + pow(x, y));
    same(std::hypot(x, y) + std::hypot(x, 2.0) + std::hypot(x, y, one),
         hypot(x, y) + hypot(x, 2.0) + hypot(x, y, one));
    same(std::atan2(x, y) + std::atan2(1.0, y), atan2(x, y) + atan2(1.0, y));
    same(std::fmod(x, y) + std::remainder(x, 0.5), fmod(x, y) + remainder(x, 0.5));
    same(std::copysign(x, y) + std::copysign(1.0, y), copysign(x, y) + copysign(1.0, y));
    same(std::max(x, y) + 2 * std::max(x, 0.0) + 3 * std::max(0, y), x + 2 * x);
    same(std::min(x, y) + 2 * std::min(x, 0.0) + 3 * std::min(0, y), y + 3 * y);
    same(std::fmax(x, y) + 2 * std::fmin(x, 0.0), x);
    same(std::clamp(x, 0.0, 1.0) + 2 * std::clamp(y, 0, 1) + std::clamp(x, y, one), 2 * x);
    BOOST_TEST((std::isfinite(x) && !std::isnan(x) && !std::isinf(x) && std::signbit(y)));
    BOOST_TEST(std::numeric_limits<dual2>::max() == std::numeric_limits<double>::max());
}

BOOST_AUTO_TEST_CASE(a_value_can_be_printed_and_choose_an_entry_of_a_table) {
    const dual2 x(2.75, Eigen::Vector2d(1, 0));
    std::ostringstream text;
    text << x;
    BOOST_TEST(text.str() == "2.75");
    BOOST_TEST((int(x) == 2 && bool(x) && !bool(dual2(0)) && int(dual22(x)) == 2));
    BOOST_TEST((!std::is_convertible_v<dual2, double> && !std::is_convertible_v<dual2, int>));
}
