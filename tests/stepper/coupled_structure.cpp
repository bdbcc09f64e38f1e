// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE coupled_structure
#include "methods.hpp"

#include <boost/test/unit_test.hpp>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/lobatto_iiib.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/linear/banded_blocks.hpp>
#include <stagecraft/linear/block_diagonal.hpp>

namespace sc = stagecraft;

namespace {

std::vector<double> entries(const Eigen::MatrixXd& a) { return {a.data(), a.data() + a.size()}; }

// |A - T D T^-1|, the entries of A being about one.
double defect(const Eigen::MatrixXd& a, const sc::block_diagonal_form& form) {
    const auto n = a.rows();
    Eigen::MatrixXd d = Eigen::MatrixXd::Zero(n, n);
    Eigen::Index i = 0;
    for (const double x : form.real) {
        d(i, i) = x;
        ++i;
    }
    for (const auto& x : form.pairs) {
        d.block<2, 2>(i, i) << x.real(), x.imag(), -x.imag(), x.real();
        i += 2;
    }
    return (a - Eigen::Map<const Eigen::MatrixXd>(form.T.data(), n, n) * d *
                    Eigen::Map<const Eigen::MatrixXd>(form.T_inverse.data(), n, n))
        .norm();
}

}  // namespace

BOOST_AUTO_TEST_CASE(matrices_of_methods_have_a_block_diagonal_form) {
    const auto check = [](const Eigen::MatrixXd& a, int real) {
        const auto form = sc::block_diagonal(entries(a), static_cast<int>(a.rows()));
        BOOST_REQUIRE(form.has_value());
        BOOST_TEST(static_cast<int>(form->real.size()) == real);
        BOOST_TEST(defect(a, *form) < 1e-10);
    };
    check(sc::gauss<2>().A, 0);
    check(sc::gauss<3>().A, 1);
    check(sc::gauss<9>().A, 1);
    check(sc::lobatto_iiib<3>().A, 1);  // the real one is zero
    check(sc::lobatto_iiib<4>().A, 2);
    check(Eigen::MatrixXd::Constant(1, 1, 0.5), 1);
}

BOOST_AUTO_TEST_CASE(a_matrix_without_a_basis_of_eigenvectors_has_none) {
    Eigen::Matrix2d jordan, zero = Eigen::Matrix2d::Zero();
    jordan << 0.25, 1, 0, 0.25;
    BOOST_TEST(!sc::block_diagonal(entries(jordan), 2));
    BOOST_TEST(!sc::block_diagonal(entries(zero), 2));
    jordan(1, 1) = 0.5;
    BOOST_TEST(sc::block_diagonal(entries(jordan), 2).has_value());
}

namespace {
struct chain {
    void operator()(double t, const Eigen::VectorXd& y, Eigen::VectorXd& f) const {
        const int n = static_cast<int>(y.size());
        for (int i = 0; i < n; ++i)
            f[i] = 100 * ((i > 0 ? y[i - 1] : std::sin(t)) - 2 * y[i] + (i + 1 < n ? y[i + 1] : 0));
    }
};
struct banded_chain : chain {
    sc::bandwidth bandwidth() const { return {1, 1}; }
};
}  // namespace

BOOST_AUTO_TEST_CASE(the_structure_of_the_jacobian_makes_no_difference) {
    const Eigen::VectorXd y0 = Eigen::VectorXd::Ones(4);
    const auto m = methods::lobatto_iiia_3();
    const sc::options<double> o{.rtol = 1e-10, .atol = 1e-10, .fixed_step = 0.05};
    const auto a = sc::integrate(m, chain{}, y0, 0, 1, o);
    const auto b = sc::integrate(m, banded_chain{}, y0, 0, 1, o);
    BOOST_TEST(a.ok());
    BOOST_TEST(b.ok());
    BOOST_TEST((a.y - b.y).norm() < 1e-9);
    BOOST_TEST((a.y - y0).norm() > 0.1);
}
