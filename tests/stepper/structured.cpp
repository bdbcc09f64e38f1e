// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE structured
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <problems/sparse_once.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/linear/banded_blocks.hpp>
#include <stagecraft/linear/sparse_blocks.hpp>

#include "interrupt.hpp"

namespace sc = stagecraft;

namespace {

constexpr int N = 24;

// A diffusion-reaction problem: y_i' = 40 (y_{i-1} - 2 y_i + y_{i+1}) + y_i (1 - y_i), y_0 = 1, y_{N+1} = 0.
struct dense_problem {
    void operator()(double, const Eigen::VectorXd& y, Eigen::VectorXd& f) const {
        const auto n = y.size();
        for (Eigen::Index i = 0; i < n; ++i) {
            const double left = i > 0 ? y[i - 1] : 1, right = i + 1 < n ? y[i + 1] : 0;
            f[i] = 40 * (left - 2 * y[i] + right) + y[i] * (1 - y[i]);
        }
    }
};
struct banded_problem : dense_problem {
    sc::bandwidth bandwidth() const { return {1, 1}; }
};
struct banded_analytic : banded_problem {
    void jacobian(double, const Eigen::VectorXd& y, sc::banded_matrix<double>& J) const {
        for (int i = 0; i < J.size(); ++i) {
            J(i, i) = -80 + 1 - 2 * y[i];
            if (i > 0) J(i, i - 1) = 40;
            if (i + 1 < J.size()) J(i, i + 1) = 40;
        }
    }
};
struct sparse_problem : dense_problem {
    Eigen::SparseMatrix<double> sparsity() const {
        Eigen::SparseMatrix<double> pattern(N, N);
        for (int i = 0; i < N; ++i)
            for (int j = std::max(0, i - 1); j <= std::min(N - 1, i + 1); ++j) pattern.insert(i, j) = 1;
        return pattern;
    }
};
struct sparse_with_mass : sparse_problem {
    Eigen::SparseMatrix<double> mass() const {
        Eigen::SparseMatrix<double> m(N, N);
        m.setIdentity();
        return m;
    }
};
// A foreign solver: counts its factorisations and passes on to the banded one.
struct counting_solver {
    inline static long factorisations = 0;
    struct real : sc::banded_blocks<double>::real {
        using sc::banded_blocks<double>::real::real;
        template <class Mass>
        bool factor_shifted(const Mass& m, const sc::banded_matrix<double>& J, double shift) {
            ++factorisations;
            return sc::banded_blocks<double>::real::factor_shifted(m, J, shift);
        }
    };
    using complex = sc::banded_blocks<double>::complex;
};
struct own_solver : banded_problem {
    using linear_solver = counting_solver;
};
struct too_wide : dense_problem {
    sc::bandwidth bandwidth() const { return {N, 0}; }
};
struct wrong_pattern : dense_problem {
    Eigen::SparseMatrix<double> sparsity() const { return {N + 1, N}; }
};

template <class Problem>
auto run(const Problem& problem) {
    const Eigen::VectorXd y0 = Eigen::VectorXd::Zero(N);
    return sc::integrate(sc::radau_iia<3>(), problem, y0, 0.0, 2.0, {.rtol = 1e-9, .atol = 1e-9});
}

}  // namespace

BOOST_AUTO_TEST_CASE(banded_and_sparse_runs_agree_with_the_dense_one) {
    const auto dense = run(dense_problem{});
    BOOST_REQUIRE(dense.ok());
    const auto agrees = [&](const auto& r) {
        BOOST_REQUIRE(r.ok());
        BOOST_TEST((r.y - dense.y).template lpNorm<Eigen::Infinity>() < 1e-8);
    };
    agrees(run(banded_problem{}));
    agrees(run(banded_analytic{}));
    agrees(run(sparse_problem{}));
    agrees(run(sparse_with_mass{}));
}

BOOST_AUTO_TEST_CASE(a_band_costs_one_evaluation_per_diagonal_and_a_pattern_one_per_colour) {
    const auto banded = run(banded_problem{});
    BOOST_TEST(banded.report.f_jacobian == 3 * banded.report.jacobians);
    const auto sparse = run(sparse_problem{});
    BOOST_TEST(sparse.report.f_jacobian == 3 * sparse.report.jacobians);
    const auto dense = run(dense_problem{});
    BOOST_TEST(dense.report.f_jacobian == N * dense.report.jacobians);
}

BOOST_AUTO_TEST_CASE(a_problem_may_bring_its_own_linear_solver) {
    counting_solver::factorisations = 0;
    const auto r = run(own_solver{});
    BOOST_REQUIRE(r.ok());
    BOOST_TEST(counting_solver::factorisations == r.report.factorisations);
}

BOOST_AUTO_TEST_CASE(a_band_or_pattern_of_the_wrong_size_is_named) {
    BOOST_CHECK_THROW(run(too_wide{}), std::invalid_argument);
    BOOST_CHECK_THROW(run(wrong_pattern{}), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(runs_go_on_from_checkpoints_with_the_bits_they_would_have) {
    const Eigen::VectorXd y0 = Eigen::VectorXd::Zero(N);
    const sc::options<double> o{.rtol = 1e-7};
    interrupted::at_five_places(sc::radau_iia<3>(), dense_problem{}, y0, 2, o);
    interrupted::at_five_places(sc::radau_iia<3>(), banded_problem{}, y0, 2, o);
    interrupted::at_five_places(sc::radau_iia<3>(), sparse_problem{}, y0, 2, o);
}
