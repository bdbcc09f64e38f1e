// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE banded_mass
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/linear/banded_blocks.hpp>
#include <stdexcept>
#include <string>

namespace sc = stagecraft;

namespace {

// The heat equation by linear finite elements, M y' = K y with M = tridiag(1, 4, 1)/6 and K = tridiag(1, -2,
// 1): sin(i w) is an eigenvector of both, w = pi / (N + 1).
constexpr int N = 9;
const double w = std::acos(-1.0) / (N + 1);

struct heat {
    void operator()(double, const Eigen::VectorXd& y, Eigen::VectorXd& f) const {
        for (int i = 0; i < N; ++i) f[i] = (i > 0 ? y[i - 1] : 0) - 2 * y[i] + (i + 1 < N ? y[i + 1] : 0);
    }
    sc::bandwidth bandwidth() const { return {1, 1}; }
};
struct with_banded_mass : heat {
    sc::banded_matrix<double> mass() const {
        sc::banded_matrix<double> m(N, {1, 1});
        for (int i = 0; i < N; ++i)
            for (int j = std::max(0, i - 1); j <= std::min(N - 1, i + 1); ++j)
                m(i, j) = i == j ? 4. / 6 : 1. / 6;
        return m;
    }
};
struct with_dense_mass : heat {
    int diagonal = 1;  // where the second entries of a row are
    Eigen::MatrixXd mass() const {
        Eigen::MatrixXd m = 4. / 6 * Eigen::MatrixXd::Identity(N, N);
        m.diagonal(diagonal).setConstant(1. / 6);
        m.diagonal(-diagonal).setConstant(1. / 6);
        return m;
    }
};

Eigen::VectorXd mode() {
    Eigen::VectorXd y(N);
    for (int i = 0; i < N; ++i) y[i] = std::sin((i + 1) * w);
    return y;
}
template <class Problem>
auto run(const Problem& p) {
    return sc::integrate(sc::radau_iia<3>(), p, mode(), 0, 5, {.rtol = 1e-9, .atol = 1e-9});
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_mass_matrix_may_be_banded) {
    const double lambda = (2 * std::cos(w) - 2) * 6 / (4 + 2 * std::cos(w));
    const Eigen::VectorXd end = std::exp(5 * lambda) * mode();
    const auto banded = run(with_banded_mass{}), dense = run(with_dense_mass{});
    BOOST_TEST(banded.ok());
    BOOST_TEST((banded.y - end).lpNorm<Eigen::Infinity>() < 1e-8);
    BOOST_TEST((banded.y - dense.y).lpNorm<Eigen::Infinity>() < 1e-14);
    BOOST_TEST((run(heat{}).y - end).lpNorm<Eigen::Infinity>() > 1e-3);  // M matters
}

BOOST_AUTO_TEST_CASE(a_mass_matrix_beyond_the_band_is_refused) {
    try {
        run(with_dense_mass{{}, 2});
        BOOST_TEST(false);
    } catch (const std::invalid_argument& e) {
        BOOST_TEST(std::string(e.what()).find("mass()") != std::string::npos);
    }
}
