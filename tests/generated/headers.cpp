// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE headers
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/coefficients/explicit.hpp>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/lobatto_iiia.hpp>
#include <stagecraft/coefficients/lobatto_iiib.hpp>
#include <stagecraft/coefficients/lobatto_iiic.hpp>
#include <stagecraft/coefficients/radau_ia.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <type_traits>

using namespace stagecraft;

namespace {

/// T^-1 A^-1 T has the eigenvalues in its blocks, A A^-1 = I, A 1 = c up to the rounding of doubles.
template <int S>
void expect_consistent(const transformed_tableau<double, S>& t) {
    BOOST_TEST(t.stages() == S);
    BOOST_TEST(t.gamma.size() + 2 * t.beta.size() == S);
    Eigen::MatrixXd block = Eigen::MatrixXd::Zero(S, S);
    const auto real = t.gamma.size();
    for (Eigen::Index k = 0; k < real; ++k) block(k, k) = t.gamma(k);
    for (Eigen::Index k = 0; k < t.beta.size(); ++k) {
        const auto at = real + 2 * k;
        block(at, at) = block(at + 1, at + 1) = t.alpha(k);
        block(at, at + 1) = t.beta(k);
        block(at + 1, at) = -t.beta(k);
    }
    const Eigen::MatrixXd transformed = t.T_inverse * t.A_inverse * t.T;
    const double scale = t.T_inverse.norm() * t.A_inverse.norm() * t.T.norm();
    BOOST_TEST((transformed - block).norm() < 1e-15 * S * scale);
    BOOST_TEST((t.A * t.A_inverse - Eigen::MatrixXd::Identity(S, S)).norm() <
               1e-15 * S * t.A.norm() * t.A_inverse.norm());
    BOOST_TEST((t.A.rowwise().sum() - t.c).norm() < 1e-15 * S);
    BOOST_TEST(t.b.sum() == 1.0, boost::test_tools::tolerance(1e-15));
}

}  // namespace

BOOST_AUTO_TEST_CASE(arrays_are_unpacked_into_their_places) {
    expect_consistent(gauss<1>());
    expect_consistent(gauss<9>());
    expect_consistent(radau_iia<2>());
    expect_consistent(radau_iia<9>());
    expect_consistent(radau_ia<6>());
    expect_consistent(lobatto_iiic<5>());
    const auto close = boost::test_tools::tolerance(3e-16);  // REFERENCE has 16 digits
    BOOST_TEST(radau_iia<3>().gamma(0) == 3.637834252744496, close);
    BOOST_TEST(radau_iia<3>().alpha(0) == 2.681082873627752, close);
    BOOST_TEST(radau_iia<3>().beta(0) == 3.050430199247411, close);
    static_assert(std::is_same_v<decltype(lobatto_iiia<3>()), tableau<double, 3>>);
    BOOST_TEST((radau_iia<5, float>().A == radau_iia<5>().A.cast<float>()));
    BOOST_TEST((gauss<3, float>().T_inverse == gauss<3>().T_inverse.cast<float>()));
    BOOST_TEST(
        (lobatto_iiia<3, float>().A(1, 2) == -1.0F / 24.0F && lobatto_iiia<3, float>().facts.order == 4));
    BOOST_TEST(lobatto_iiia<3>().A(1, 2) == -1.0 / 24.0);
    BOOST_TEST(lobatto_iiib<3>().A(1, 0) == 1.0 / 6.0);
    BOOST_TEST(lobatto_iiib<3>().A(0, 2) == 0.0);
}

BOOST_AUTO_TEST_CASE(facts_are_those_of_the_families) {
    static_assert(coefficients::radau_iia<5>::facts.order == 9);
    static_assert(coefficients::gauss<4>::facts.symplectic && !coefficients::radau_iia<4>::facts.symplectic);
    static_assert(coefficients::radau_iia<4>::facts.l_stable() && !coefficients::gauss<4>::facts.l_stable());
    const facts iia = radau_iia<3>().facts;
    BOOST_TEST(iia.order == 5);
    BOOST_TEST(iia.stage_order == 3);
    BOOST_TEST((iia.l_stable() && iia.algebraically_stable && !iia.symmetric));
    BOOST_TEST((radau_iia<3>().stiffly_accurate() && !gauss<3>().stiffly_accurate()));
    BOOST_TEST(iia.r_infinity == 0.0);
    BOOST_TEST(gauss<3>().facts.r_infinity == -1.0);
    BOOST_TEST((lobatto_iiia<4>().facts.symmetric && !lobatto_iiia<4>().facts.algebraically_stable));
}

// Without tables, parsers and exact arithmetic: the nearest doubles run, with their estimates, in float as well.
BOOST_AUTO_TEST_CASE(explicit_pairs_run) {
    static_assert(std::is_same_v<decltype(dormand_prince_5_4()), tableau<double, 7>>);
    static_assert(std::is_same_v<decltype(bogacki_shampine_3_2<float>()), tableau<float, 4>>);
    BOOST_TEST(dormand_prince_5_4().A(4, 3) == -212.0 / 729.0);  // Hairer-Norsett-Wanner I, table II.5.2
    BOOST_TEST(dormand_prince_5_4().b_embedded[0] == 5179.0 / 57600.0);
    BOOST_TEST(classical_rk4().b[1] == 1.0 / 3.0);
    const auto f = [](auto t, const auto& y, auto& out) {
        using std::cos;
        out[0] = y[0] * cos(t);
    };
    const auto error = [&](const auto& m, int steps) {
        const auto r = integrate(m, f, Eigen::Matrix<double, 1, 1>(1.0), 0, 1, {.fixed_step = 1.0 / steps});
        return std::abs(r.y[0] - std::exp(std::sin(1.0)));
    };
    const auto has_order = [&](const auto& m, int order, int steps) {
        BOOST_TEST(m.facts.order == order);
        const double slope = std::log2(error(m, steps) / error(m, 2 * steps));
        BOOST_TEST_CONTEXT("order " << order << ", " << m.stages() << " stages")
        BOOST_TEST((slope > order - 0.35 && slope < order + 0.7), slope);
    };
    has_order(heun_euler_2_1(), 2, 64);
    has_order(bogacki_shampine_3_2(), 3, 32);
    has_order(classical_rk4(), 4, 16);
    has_order(cash_karp_5_4(), 5, 16);
    has_order(dormand_prince_5_4(), 5, 16);
    has_order(dormand_prince_8_5_3(), 8, 4);
    const auto r = integrate(dormand_prince_8_5_3(), f, Eigen::Matrix<double, 1, 1>(1.0), 0, 1,
                             {.rtol = 1e-10, .atol = 1e-10});
    BOOST_TEST((r.ok() && std::abs(r.y[0] - std::exp(std::sin(1.0))) < 1e-9));
    const auto single = integrate(bogacki_shampine_3_2<float>(), f, Eigen::Matrix<float, 1, 1>(1.0F), 0, 1,
                                  {.rtol = 1e-4F, .atol = 1e-4F});
    BOOST_TEST((single.ok() && std::abs(single.y[0] - std::exp(std::sin(1.0F))) < 1e-3F));
}
