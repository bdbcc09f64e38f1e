// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE dual_number
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/jacobian/automatic.hpp>

using namespace stagecraft;
using wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_100::backend_type,
                                           boost::multiprecision::et_off>;
using dual2 = dual_number<double, 2>;
using dual22 = dual_number<dual2, 2>;

namespace {

// Every function and operator that dual numbers have, positive arguments.
const auto functions = [](const auto& x, const auto& y) {
    using std::abs, std::acos, std::asin, std::atan, std::atan2, std::cos, std::cosh, std::exp, std::log,
        std::max, std::min, std::pow, std::sin, std::sinh, std::sqrt, std::tan, std::tanh;
    using S = std::remove_cvref_t<decltype(x)>;
    Eigen::Matrix<S, 12, 1> r;
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
    return r;
};

// By central differences in 100 digits: a method that knows nothing of the rules of differentiation.
Eigen::Matrix<wide, 12, 1> difference(const wide& x, const wide& y, const wide& dx, const wide& dy) {
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
        for (int i = 0; i < 12; ++i) {
            BOOST_TEST(r[i].value() == static_cast<double>(functions(wide(x), wide(y))[i]),
                       boost::test_tools::tolerance(1e-14));
            BOOST_TEST(r[i].derivatives()[k] == static_cast<double>(expected[i]),
                       boost::test_tools::tolerance(1e-13));
        }
    }
}

BOOST_AUTO_TEST_CASE(second_derivatives_are_dual_numbers_of_dual_numbers) {
    const wide x = 1.25, y = 0.75, h("1e-30");
    dual22 a(dual2(1.25, Eigen::Vector2d(1, 0))), b(dual2(0.75, Eigen::Vector2d(0, 1)));
    a.derivatives()[0] = 1;
    b.derivatives()[1] = 1;
    const auto r = functions(a, b);
    const Eigen::Matrix<wide, 12, 1> xy = (difference(x, y + h, 1, 0) - difference(x, y - h, 1, 0)) / (2 * h);
    for (int i = 0; i < 12; ++i) {
        BOOST_TEST(std::abs(r[i].derivatives()[0].derivatives()[1] - static_cast<double>(xy[i])) < 1e-12);
        BOOST_TEST(std::abs(r[i].derivatives()[1].derivatives()[0] - static_cast<double>(xy[i])) < 1e-12);
    }
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
