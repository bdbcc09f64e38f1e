// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE combinations
#include <Eigen/Core>
#include <boost/test/unit_test.hpp>
#include <limits>
#include <span>
#include <stagecraft/linear/combinations.hpp>
#include <stagecraft/linear/norms.hpp>
#include <vector>

namespace sc = stagecraft;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// Sizes around every packet and block of packets.
const std::vector<int> sizes{0, 1, 2, 3, 4, 5, 7, 8, 9, 15, 16, 17, 31};

bool close(const VectorXd& x, const VectorXd& y) {
    return x.size() == 0 || (x - y).lpNorm<Eigen::Infinity>() < 64 * std::numeric_limits<double>::epsilon();
}

template <int Count>
void check(int n) {
    const MatrixXd in = MatrixXd::Random(n, Count);
    const VectorXd c = VectorXd::Random(Count), base = VectorXd::Random(n), sum = in * c;
    VectorXd fixed = base, any = base, added = base;
    sc::combine<false, Count>(n, Count, c.data(), in.data(), fixed.data());
    sc::combine<false, -1>(n, Count, c.data(), in.data(), any.data());
    sc::combine<true, -1>(n, Count, c.data(), in.data(), added.data());
    BOOST_TEST(close(fixed, sum));
    BOOST_TEST(close(any, sum));
    BOOST_TEST(close(added, base + sum));

    std::vector<sc::combination_term<double>> terms;
    for (int j = Count - 1; j >= 0; --j) terms.push_back({c[j], std::ptrdiff_t{j} * n});
    VectorXd alone(n), onto(n), in_place = base;
    const std::span<const sc::combination_term<double>> all(terms);
    sc::combine_onto(n, all, 2.0, in.data(), base.data(), onto.data());
    sc::combine_onto(n, all, 0.5, in.data(), in_place.data(), in_place.data());
    BOOST_TEST(close(onto, base + 2 * sum));
    if (Count <= sc::combined_terms) {
        sc::combine_terms<false>(n, all, 2.0, in.data(), base.data(), alone.data());
        BOOST_TEST(close(alone, 2 * sum));
    }
    BOOST_TEST(close(in_place, base + 0.5 * sum));

    const VectorXd w = VectorXd::Random(n);
    const double squares = (in.array().colwise() * w.array()).square().sum();
    BOOST_TEST(std::abs(sc::weighted_squares<Count>(n, Count, in.data(), w.data()) - squares) < 1e-13);
    BOOST_TEST(std::abs(sc::weighted_squares<-1>(n, Count, in.data(), w.data()) - squares) < 1e-13);
}

}  // namespace

BOOST_AUTO_TEST_CASE(combinations_of_vectors_are_those_of_a_product_at_every_size_around_the_packets) {
    for (const int n : sizes) BOOST_TEST_CONTEXT("n = " << n) {
            check<1>(n);
            check<3>(n);
            check<4>(n);
            check<9>(n);
            check<12>(n);
            check<25>(n);
        }
}

BOOST_AUTO_TEST_CASE(a_number_that_is_not_finite_shows_in_the_sum_of_squares) {
    for (const int n : {1, 2, 3, 9})
        for (int i = 0; i < n; ++i) {
            VectorXd x = VectorXd::Ones(n);
            const VectorXd w = VectorXd::Ones(n);
            x[i] = std::numeric_limits<double>::quiet_NaN();
            const double sum = sc::weighted_squares<1>(n, 1, x.data(), w.data());
            BOOST_TEST(!(sum - sum == 0));
        }
}

BOOST_AUTO_TEST_CASE(a_copy_tells_of_every_number_that_is_not_finite) {
    for (const int n : sizes) BOOST_TEST_CONTEXT("n = " << n) {
            VectorXd x = VectorXd::Random(n), copy = VectorXd::Zero(n);
            BOOST_TEST(sc::copy_finite(x.data(), n, copy.data()));
            BOOST_TEST((copy == x));
            for (int i = 0; i < n; ++i)
                for (const double bad :
                     {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                      std::numeric_limits<double>::quiet_NaN()}) {
                    VectorXd y = x;
                    y[i] = bad;
                    BOOST_TEST(!sc::copy_finite(y.data(), n, copy.data()));
                }
        }
}
