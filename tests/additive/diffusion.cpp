// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE diffusion
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/additive.hpp>
#include <stagecraft/coefficients/additive.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/linear/banded_blocks.hpp>
#include <stagecraft/linear/sparse_blocks.hpp>
#include <stagecraft/problem/matrix_free.hpp>

// The Brusselator in one dimension (Hairer-Wanner II.IV.1), its diffusion implicit, through every kind of linear solver.

namespace sc = stagecraft;
using Eigen::VectorXd;

namespace {

constexpr int cells = 60, n = 2 * cells;  // u and v of a cell after each other
constexpr double dx = 1.0 / (cells + 1), alpha = 0.02;

struct reaction {
    void operator()(double, const VectorXd& y, VectorXd& f) const {
        for (int i = 0; i < n; i += 2) {
            const double u = y[i], v = y[i + 1], uuv = u * u * v;
            f[i] = 1 + uuv - 4 * u;
            f[i + 1] = 3 * u - uuv;
        }
    }
};
// Generic where `Scalar` is not double: derivatives of dense matrices and of products are automatic then.
struct diffusion {
    template <class Y, class F>
    void operator()(double, const Y& y, F& f) const {
        using number = typename Y::Scalar;
        for (int i = 0; i < n; ++i) {
            const double end = i % 2 == 0 ? 1 : 3;  // u and v at both ends
            const number left = i < 2 ? number(end) : y[i - 2], right = i >= n - 2 ? number(end) : y[i + 2];
            f[i] = alpha / (dx * dx) * (left - 2 * y[i] + right);
        }
    }
    bool constant_jacobian() const { return true; }
};
struct banded_diffusion : diffusion {
    sc::bandwidth bandwidth() const { return {2, 2}; }
};
struct sparse_diffusion : diffusion {
    Eigen::SparseMatrix<double> sparsity() const {
        Eigen::SparseMatrix<double> pattern(n, n);
        for (int i = 0; i < n; ++i)
            for (int j = i - 2; j <= i + 2; j += 2)
                if (0 <= j && j < n) pattern.insert(i, j) = 1;
        return pattern;
    }
};
struct preconditioned_diffusion : diffusion {
    /// One matrix for u and for v: Thomas' elimination of shift + alpha / dx^2 (-1, 2, -1), of another alpha.
    void precondition(double shift, double* x) const {
        const double off = -1.2 * alpha / (dx * dx), middle = shift - 2 * off;
        for (int k = 0; k < 2; ++k) {
            std::array<double, cells> c;
            double pivot = middle;
            for (int i = 0; i < cells; ++i) {
                if (i > 0) pivot = middle - off * c[i - 1];
                c[i] = off / pivot;
                x[2 * i + k] = (x[2 * i + k] - (i > 0 ? off * x[2 * i - 2 + k] : 0)) / pivot;
            }
            for (int i = cells - 2; i >= 0; --i) x[2 * i + k] -= c[i] * x[2 * i + 2 + k];
        }
    }
};
// The whole as one function.
struct both : banded_diffusion {
    void operator()(double t, const VectorXd& y, VectorXd& f) const {
        VectorXd r(n);
        reaction()(t, y, r);
        diffusion::operator()(t, y, f);
        f += r;
    }
    bool constant_jacobian() const { return false; }
};

VectorXd start() {
    VectorXd y(n);
    for (int i = 0; i < cells; ++i) y[2 * i] = 1 + std::sin(2 * M_PI * (i + 1) * dx), y[2 * i + 1] = 3;
    return y;
}
const VectorXd& reference() {
    static const VectorXd y =
        sc::integrate(sc::radau_iia<5>(), both(), start(), 0, 2, {.rtol = 1e-11, .atol = 1e-11}).y;
    return y;
}
template <class Implicit, class Method = decltype(sc::ark4())>
auto run(Implicit implicit, double tolerance, const Method& m = sc::ark4()) {
    const auto r = sc::integrate(m, sc::split(reaction(), implicit), start(), 0, 2,
                                 {.rtol = tolerance, .atol = tolerance});
    BOOST_TEST(sc::name(r.status) == "success");
    const double error = ((r.y - reference()).array() / (1 + reference().array().abs())).abs().maxCoeff();
    BOOST_TEST(error < 5 * tolerance, error << " of " << tolerance);
    return r;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_tolerance_holds_and_one_jacobian_serves_the_run) {
    for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
        const auto banded = run(banded_diffusion(), tolerance);
        BOOST_TEST(banded.report.jacobians == 1);
        BOOST_TEST(banded.report.f_jacobian ==
                   2 * 5);  // columns of five colours, by differences to both sides
        run(banded_diffusion(), tolerance, sc::ark3());
        run(banded_diffusion(), tolerance, sc::ark5());
    }
}

BOOST_AUTO_TEST_CASE(dense_sparse_and_matrix_free_linear_algebra_take_the_same_steps) {
    const auto banded = run(banded_diffusion(), 1e-6), sparse = run(sparse_diffusion(), 1e-6),
               dense = run(diffusion(), 1e-6),
               free = run(sc::matrix_free(preconditioned_diffusion(), n), 1e-6);
    for (const auto* other : {&sparse, &dense, &free}) {
        BOOST_TEST(std::abs(other->report.steps - banded.report.steps) <= 2);
        BOOST_TEST((other->y - banded.y).lpNorm<Eigen::Infinity>() < 1e-6);  // the tolerance
    }
    BOOST_TEST(dense.report.f_jacobian == (n + 7) / 8);  // automatically, eight columns at once
    BOOST_TEST((sparse.report.found.jacobian == sc::jacobian_source::differences));
    BOOST_TEST(free.report.linear_iterations > 0);
}
