// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE linear_row_panel
#include <Eigen/LU>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <stagecraft/linear/row_panel.hpp>
#include <vector>

namespace {

using stagecraft::detail::row_panel;
using rows_together = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr double eps = std::numeric_limits<double>::epsilon();

// q + extra rows and q + more columns, some of whose entries are zero; the first one is, so that rows change places.
rows_together some_matrix(int q, int extra, int more, double zeros, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform;
    rows_together a(q + extra, q + more);
    for (auto& x : a.reshaped()) x = uniform(random) < zeros ? 0 : normal(random);
    a(0, 0) = 0;
    return a;
}

template <class Panel>
std::vector<double> written(const Panel& panel, const rows_together& a) {
    std::vector<double> out(panel.size());
    for (int i = 0; i < panel.rows(); ++i)
        for (int j = 0; j < panel.columns(); ++j) out[i * panel.width() + j] = a(i, j);
    return out;
}

// q unknowns from the last column as right-hand side, where those of the others are known, against complete pivoting; and
// the right-hand side once more through the factors.
void check(int q, int more, double zeros, unsigned seed) {
    const auto a = some_matrix(q, 0, more, zeros, seed);
    const row_panel<double, 0, 0, 0> panel(q, q + more, q);
    auto factors = written(panel, a);
    std::vector<int> from(q);
    panel.eliminate(factors.data(), from.data());

    const Eigen::FullPivLU<rows_together> complete(a.leftCols(q));
    if (zeros > 0 && !complete.isInvertible()) return;
    const Eigen::VectorXd known = Eigen::VectorXd::LinSpaced(more - 1, 1, 2);
    Eigen::VectorXd right(q + more - 1);
    for (int i = 0; i < q; ++i) right[i] = factors[i * panel.width() + q + more - 1];
    auto x = right;
    x.tail(more - 1) = known;
    panel.back(factors.data(), more - 1, x.data());
    const Eigen::VectorXd rest = a.col(q + more - 1) - a.middleCols(q, more - 1) * known,
                          expected = complete.solve(rest);
    BOOST_TEST((a.leftCols(q) * (x.head(q) - expected)).cwiseAbs().maxCoeff() <
               100 * q * eps * (1 + expected.cwiseAbs().maxCoeff()));

    Eigen::VectorXd again = a.col(q + more - 1);
    panel.forward(factors.data(), from.data(), again.data());
    for (int i = 0; i < q; ++i)
        BOOST_TEST(std::abs(again[i] - right[i]) <= 10 * q * eps * right.cwiseAbs().maxCoeff());
}

template <int Rows, int Columns, int Pivots>
void check_sizes(double zeros, unsigned seed) {
    const auto a = some_matrix(Pivots, Rows - Pivots, Columns - Pivots, zeros, seed);
    const row_panel<double, Rows, Columns, Pivots> fixed(0, 0, 0);
    const row_panel<double, 0, 0, 0> run_time(Rows, Columns, Pivots);
    auto one = written(fixed, a), two = written(run_time, a);
    std::vector<int> from_one(Pivots), from_two(Pivots);
    fixed.eliminate(one.data(), from_one.data());
    run_time.eliminate(two.data(), from_two.data());
    BOOST_TEST(one == two);
    BOOST_TEST(from_one == from_two);
}

}  // namespace

BOOST_AUTO_TEST_CASE(unknowns_are_those_of_complete_pivoting_at_every_size) {
    for (int q = 2; q <= 20; ++q)
        for (const double zeros : {0.0, 0.5})
            for (unsigned seed = 0; seed < 5; ++seed) check(q, 1 + q % 4, zeros, seed);
}

BOOST_AUTO_TEST_CASE(sizes_known_to_the_compiler_change_no_bit) {
    for (unsigned seed = 0; seed < 20; ++seed)
        for (const double zeros : {0.0, 0.7}) {
            check_sizes<4, 6, 1>(zeros, seed);
            check_sizes<6, 10, 4>(zeros, seed);
            check_sizes<11, 19, 7>(zeros, seed);
            check_sizes<16, 17, 16>(zeros, seed);
        }
}

BOOST_AUTO_TEST_CASE(a_column_of_zeros_leaves_the_others_finite_at_either_place_of_a_pair) {
    for (const int zero : {0, 1, 2, 3}) {
        auto a = some_matrix(5, 2, 3, 0, 7);
        a.col(zero).setZero();
        const row_panel<double, 0, 0, 0> panel(7, 8, 5);
        auto factors = written(panel, a);
        std::vector<int> from(5);
        panel.eliminate(factors.data(), from.data());
        for (int i = 5; i < 7; ++i)
            for (int j = 0; j < 8; ++j) BOOST_TEST(std::isfinite(factors[i * panel.width() + j]));
    }
}
