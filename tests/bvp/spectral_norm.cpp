// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE bvp_spectral_norm
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/bvp/measure/conditioning.hpp>
#include <vector>

namespace {

/// Against the largest of all singular values, which Jacobi's method finds.
template <class Matrix>
void check(const Matrix& a) {
    std::vector<double> values;
    const double all = stagecraft::detail::spectral_norm(a, &values);
    BOOST_TEST(all == *std::max_element(values.begin(), values.end()));
    BOOST_TEST(std::abs(stagecraft::detail::spectral_norm(a) - all) <= 1e-14 * all);
}

}  // namespace

BOOST_AUTO_TEST_CASE(norms_are_those_of_all_singular_values) {
    Eigen::Matrix4d a;
    a << 4, -2, 7, 1, 0, 3, -5, 2, 6, 6, 1, -8, -3, 2, 9, 5;
    for (const double factor : {1.0, 1e-200, 1e200}) check(Eigen::Matrix4d(factor * a));
    check(Eigen::Matrix3d(a.topLeftCorner<3, 3>()));
    check(Eigen::Matrix<double, 3, 4>(a.topRows<3>()));
    check(Eigen::MatrixXd(Eigen::MatrixXd::Constant(6, 6, 2) + Eigen::MatrixXd::Identity(6, 6)));
    check(Eigen::Matrix3d(Eigen::Vector3d(1e-8, 1, 1e8).asDiagonal()));
}

// Eigenvalues that are the same, or nearly: powers take long to tell them apart.
BOOST_AUTO_TEST_CASE(norms_are_right_where_singular_values_coincide) {
    const Eigen::Matrix4d turn = Eigen::Vector4d(1, 2, -3, 1) * Eigen::RowVector4d(1, 2, -3, 1) * 2 / 15;
    const Eigen::Matrix4d reflection = Eigen::Matrix4d::Identity() - turn;
    for (const double apart : {0.0, 1e-15, 1e-12, 1e-8, 1e-4, 0.1}) {
        const Eigen::Vector4d values(1 - apart, 1, 1 - apart / 3, 0.5);
        const Eigen::Matrix4d a = reflection * values.asDiagonal();
        BOOST_TEST(std::abs(stagecraft::detail::spectral_norm(a) - 1) <= 1e-14);
    }
    BOOST_TEST(stagecraft::detail::spectral_norm(Eigen::Matrix3d(Eigen::Matrix3d::Zero())) == 0);
}
