// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE index_3_linear
#include <array>
#include <boost/test/unit_test.hpp>
#include <stagecraft/theory/dae/dae_order.hpp>
#include <vector>

#include "../stability/methods.hpp"

// Where predict_index3 says none although a method runs, examples in exact arithmetic show that u, or z, need
// not converge: no theorem could promise it. The problem is y' = z, z' = u, 0 = y - t^k on [0, 1] in n equal
// steps from exact values; its errors at 1 are numbers of the method's field.

using namespace stagecraft;
using methods::quadratic;
using methods::rational;

namespace {

template <class K>
using column = std::vector<K>;

template <class K>
column<K> times(const typename tableau<K>::matrix& a, const column<K>& x) {
    column<K> r(static_cast<std::size_t>(a.rows()), K(0));
    for (Eigen::Index i = 0; i < a.rows(); ++i)
        for (Eigen::Index j = 0; j < a.cols(); ++j) r[i] = r[i] + a(i, j) * x[j];
    return r;
}

// The slopes X' of stages X = x + h A X': where the first stage is the left end, its slope is known.
template <class K>
class stage_equations {
  public:
    explicit stage_equations(const tableau<K>& t)
        : t_(t), left_(t.c[0] == K(0) && !tableaux::inverse<K>(t.A).has_value() ? 1 : 0) {
        const auto n = t.b.size() - left_;
        inverse_ = tableaux::inverse<K>(t.A.bottomRightCorner(n, n)).value();
    }
    column<K> slopes(const column<K>& stages, const K& x, const K& left_slope, const K& h) const {
        column<K> r;
        for (Eigen::Index i = left_; i < t_.b.size(); ++i) {
            r.push_back((stages[i] - x) / h);
            if (left_ == 1) r.back() = r.back() - t_.A(i, 0) * left_slope;
        }
        r = times<K>(inverse_, r);
        if (left_ == 1) r.insert(r.begin(), left_slope);
        return r;
    }
    /// x after the step. u has no slope at the left end; there, stiffly accurate, it is the last stage.
    K advance(const K& x, const column<K>& slopes, const K& h) const {
        K r = x;
        for (Eigen::Index i = 0; i < t_.b.size(); ++i) r = r + h * t_.b[i] * slopes[i];
        return r;
    }
    bool from_left() const { return left_ == 1; }

  private:
    const tableau<K>& t_;
    Eigen::Index left_;
    typename tableau<K>::matrix inverse_;
};

template <class K>
K power(const K& x, int k) {
    K r(1);
    for (int i = 0; i < k; ++i) r = r * x;
    return r;
}

// Errors of y, z and u at t = 1.
template <class K>
std::array<K, 3> errors(const tableau<K>& method, int k, int n) {
    const stage_equations<K> solve(method);
    const K h = K(1) / K(n);
    K t(0), y(0), z(0), u(k == 2 ? 2 : 0);
    for (int step = 0; step < n; ++step, t = t + h) {
        column<K> Y;
        for (Eigen::Index i = 0; i < method.c.size(); ++i) Y.push_back(power<K>(t + method.c[i] * h, k));
        const auto Z = solve.slopes(Y, y, z, h), U = solve.slopes(Z, z, u, h);
        y = solve.advance(y, Z, h);
        z = solve.advance(z, U, h);
        u = solve.from_left() ? U.back() : solve.advance(u, solve.slopes(U, u, K(0), h), h);
    }
    return {y - K(1), z - K(k), u - K(k * (k - 1))};
}

const std::vector<int> numbers_of_steps = {2, 4, 8, 16};

// No theorem may promise what the example refutes.
template <class K>
void expect_no_promise(const tableau<K>& method) {
    BOOST_TEST(!theory::predict_index3(method).applies());
}

}  // namespace

BOOST_AUTO_TEST_CASE(u_of_lobatto_iiia_with_two_and_three_stages_does_not_converge) {
    expect_no_promise(methods::trapezoidal());
    expect_no_promise(methods::lobatto_iiia3());
    for (const int n : numbers_of_steps) {
        const auto two = errors(methods::trapezoidal(), 3, n);
        BOOST_TEST(two[0] == 0);
        BOOST_TEST(two[1] == 0);
        BOOST_TEST(two[2] == 2);
        const auto three = errors(methods::lobatto_iiia3(), 4, n);
        BOOST_TEST(three[0] == 0);
        BOOST_TEST(three[1] == methods::q(-1, 2 * n * n));
        BOOST_TEST(three[2] == -3);
    }
}

BOOST_AUTO_TEST_CASE(u_of_gauss_with_one_and_two_stages_grows_and_z_does_not_converge) {
    expect_no_promise(methods::midpoint());
    expect_no_promise(methods::gauss2());
    for (const int n : numbers_of_steps) {
        const auto one = errors(methods::midpoint(), 2, n);
        BOOST_TEST(one[0] == 0);
        BOOST_TEST(one[1] == 1);
        BOOST_TEST(one[2] == 2 * n * n);
        const auto two = errors(methods::gauss2(), 3, n);
        BOOST_TEST((two[0] == quadratic(methods::q(-1, 6 * n * n))));
        BOOST_TEST((two[1] == quadratic(-1)));
        BOOST_TEST((two[2] == quadratic(-4 * n * n)));
    }
}

BOOST_AUTO_TEST_CASE(u_of_gauss_with_three_stages_does_not_converge) {
    expect_no_promise(methods::gauss3());
    for (const int n : numbers_of_steps) {
        const auto e = errors(methods::gauss3(), 4, n);
        BOOST_TEST((e[0] == quadratic(0)));
        BOOST_TEST((e[1] == quadratic(methods::q(3, 5 * n * n))));
        BOOST_TEST((e[2] == quadratic(methods::q(36, 5))));
    }
}

BOOST_AUTO_TEST_CASE(u_of_lobatto_iiic_and_radau_ia_with_two_stages_does_not_converge) {
    expect_no_promise(methods::lobatto_iiic2());
    expect_no_promise(methods::radau_ia2());
    for (const int n : numbers_of_steps) {
        BOOST_TEST(errors(methods::lobatto_iiic2(), 2, n)[2] == -2);
        if (n > 2) BOOST_TEST(errors(methods::radau_ia2(), 2, n)[2] == -12);
    }
}

// What the theorem promises is seen on the same problem, and no more: errors of h^2 in z and of h in u.
BOOST_AUTO_TEST_CASE(radau_iia_converges_on_the_same_problem_with_the_orders_that_are_predicted) {
    const auto predicted = theory::predict_index3(methods::radau_iia2());
    BOOST_REQUIRE(predicted.applies());
    const auto coarse = errors(methods::radau_iia2(), 3, 8), fine = errors(methods::radau_iia2(), 3, 16);
    BOOST_TEST(coarse[1] == fine[1] * rational(1 << predicted.z.value()));
    BOOST_TEST(coarse[2] == fine[2] * rational(1 << predicted.u.value()));
    for (const int n : numbers_of_steps) {
        const auto e = errors(methods::radau_iia2(), 3, n);
        BOOST_TEST(e[0] == 0);
        BOOST_TEST(e[1] == methods::q(-2, 3 * n * n));
        BOOST_TEST(e[2] == methods::q(-4, n));
    }
}
