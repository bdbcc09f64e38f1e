// SPDX-License-Identifier: BSL-1.0
// What sparse_blocks keeps from one factorisation to the next: the pattern, and nothing that depends on it
// once it has changed.
#define BOOST_TEST_MODULE sparse_pattern
#include <Eigen/LU>
#include <Eigen/SparseLU>
#include <boost/test/unit_test.hpp>
#include <complex>
#include <limits>
#include <problems/sparse_once.hpp>
#include <stagecraft/linear/sparse_blocks.hpp>

#include "../allocations.hpp"

namespace sc = stagecraft;

namespace {

long analyses = 0;  // by all solvers below
long inside = 0;    // allocations of theirs

// Eigen's solver, counted.
template <class T>
class watched_lu {
  public:
    using matrix = Eigen::SparseMatrix<T>;
    void analyzePattern(const matrix& a) {
        ++analyses;
        const long before = allocations;
        lu_.analyzePattern(a);
        inside += allocations - before;
    }
    void factorize(const matrix& a) {
        const long before = allocations;
        lu_.factorize(a);
        inside += allocations - before;
    }
    auto info() const { return lu_.info(); }
    template <class B>
    auto solve(const B& b) const {
        return lu_.solve(b);
    }

  private:
    Eigen::SparseLU<matrix, Eigen::COLAMDOrdering<int>> lu_;
};
using blocks = sc::sparse_blocks<double, watched_lu<double>, watched_lu<std::complex<double>>>;

using entries = std::vector<Eigen::Triplet<double>>;

Eigen::SparseMatrix<double> sparse(int n, const entries& list) {
    Eigen::SparseMatrix<double> m(n, n);
    m.setFromTriplets(list.begin(), list.end());
    return m;
}

// One real and one complex solver that live through changes of J and M, compared with dense solutions.
struct pair {
    blocks::real real;
    blocks::complex complex;
    explicit pair(int n) : real(n), complex(n) {}

    /// The larger residual.
    template <class Mass>
    double residual(const Mass& mass, const Eigen::MatrixXd& M, const Eigen::SparseMatrix<double>& J,
                    double re, double im) {
        const auto n = J.rows();
        const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, -1, 2);
        BOOST_REQUIRE(real.factor_shifted(mass, J, re));
        BOOST_REQUIRE(complex.factor_shifted(mass, J, re, im));
        Eigen::VectorXd x = b, u = b, v = b.reverse();
        real.solve(x.data());
        complex.solve(u.data(), v.data());
        const Eigen::MatrixXd dense(J);
        const Eigen::VectorXd one = (re * M - dense).fullPivLu().solve(b);
        Eigen::VectorXcd right(n);
        right.real() = b;
        right.imag() = b.reverse();
        const std::complex<double> z(re, im);
        const Eigen::VectorXcd two = (z * M - dense.cast<std::complex<double>>()).fullPivLu().solve(right);
        Eigen::VectorXcd have(n);
        have.real() = u;
        have.imag() = v;
        return std::max((x - one).norm() / one.norm(), (have - two).norm() / two.norm());
    }
    double residual(const Eigen::SparseMatrix<double>& M, const Eigen::SparseMatrix<double>& J, double re,
                    double im) {
        return residual(sc::entry_mass<double>(M), Eigen::MatrixXd(M), J, re, im);
    }
    double residual(const Eigen::SparseMatrix<double>& J, double re, double im) {
        return residual(sc::identity_mass{}, Eigen::MatrixXd::Identity(J.rows(), J.rows()), J, re, im);
    }
};

// Diagonal (left out where asked) and two far diagonals.
Eigen::SparseMatrix<double> far_coupled(int n, double scale, int without_diagonal_from) {
    entries list;
    for (int i = 0; i < n; ++i) {
        if (i < without_diagonal_from) list.emplace_back(i, i, -scale * (3 + i % 4));
        list.emplace_back(i, (i + 7) % n, scale * (1 + i % 3));
        list.emplace_back((i + 11) % n, i, -scale);
    }
    return sparse(n, list);
}

}  // namespace

BOOST_AUTO_TEST_CASE(entries_that_only_one_of_m_and_j_has_are_in_the_sum) {
    // J has no diagonal in rows 20 to 29; M has none in rows 0 to 4 and an entry (2, 25) where J has none.
    const int n = 30;
    entries list{{2, 25, 0.5}};
    for (int i = 5; i < n; ++i) list.emplace_back(i, i, 1 + 0.1 * i);
    const auto M = sparse(n, list);
    pair p(n);
    analyses = 0;
    for (const double scale : {1.0, -2.0, 30.0}) {
        BOOST_TEST(p.residual(M, far_coupled(n, scale, 20), 4, -3) < 1e-12);
        BOOST_TEST(p.residual(M, far_coupled(n, scale, 20), 1e4, 5e3) < 1e-12);
    }
    BOOST_TEST(analyses == 2);                                     // one each
    BOOST_TEST(p.residual(far_coupled(n, 1, 20), 4, -3) < 1e-12);  // another M: more and less entries
    BOOST_TEST(analyses == 4);
    BOOST_TEST(far_coupled(n, 1, 20).coeff(2, 25) == 0);
}

BOOST_AUTO_TEST_CASE(a_changed_pattern_of_j_is_seen_and_analysed_anew) {
    const int n = 24;
    pair p(n);
    analyses = 0;
    const auto solved_after = [&](const Eigen::SparseMatrix<double>& J) {
        BOOST_TEST(p.residual(J, 5, 2) < 1e-12);
        return analyses;
    };
    auto J = far_coupled(n, 1, n);
    BOOST_TEST(solved_after(J) == 2);
    J.coeffRef(3, 9) = 2;  // more: J is not compressed then
    BOOST_TEST(!J.isCompressed());
    BOOST_TEST(solved_after(J) == 4);
    J.makeCompressed();  // the same pattern, stored otherwise
    BOOST_TEST(solved_after(J) == 4);
    J.coeffRef(3, 9) = 0;  // an explicit zero stays
    BOOST_TEST(solved_after(J) == 4);
    J.prune(0.0);  // less
    BOOST_TEST(solved_after(J) == 6);
    // As many entries, one of them elsewhere: in the same column, in the same row.
    for (const auto& [i, j] : {std::pair(5, 0), std::pair(0, 5)}) {
        auto moved = far_coupled(n, 1, n);
        BOOST_TEST(moved.coeff(i, j) == 0);
        moved.coeffRef(11, 0) = 0;
        moved.prune(0.0);
        moved.coeffRef(i, j) = 1.5;
        const long before = analyses;
        BOOST_TEST(solved_after(moved) == before + 2);
    }
    auto hollow = far_coupled(n, 1, n - 1);
    BOOST_TEST(solved_after(hollow) == 12);
    BOOST_TEST(solved_after(hollow * 2) == 12);
}

BOOST_AUTO_TEST_CASE(a_refused_matrix_leaves_the_solver_usable) {
    const int n = 24;
    pair p(n);
    auto J = far_coupled(n, 1, n);
    BOOST_TEST(p.residual(J, 5, 2) < 1e-12);
    auto broken = J;
    broken.coeffRef(7, 0) = std::numeric_limits<double>::quiet_NaN();
    BOOST_TEST(!p.real.factor_shifted(sc::identity_mass{}, broken, 5.0));
    BOOST_TEST(!p.complex.factor_shifted(sc::identity_mass{}, broken, 5.0, 2.0));
    BOOST_TEST(!p.real.factor_shifted(sc::identity_mass{}, J, std::numeric_limits<double>::infinity()));
    BOOST_TEST(
        !p.complex.factor_shifted(sc::identity_mass{}, J, 1.0, std::numeric_limits<double>::infinity()));
    // The product of shift and M overflows although neither is infinite.
    const sc::entry_mass<double> heavy(Eigen::MatrixXd(Eigen::MatrixXd::Identity(n, n) * 1e200));
    BOOST_TEST(!p.real.factor_shifted(heavy, J, 1e200));
    BOOST_TEST(p.residual(J, 5, 2) < 1e-12);
}

BOOST_AUTO_TEST_CASE(refactoring_a_kept_pattern_allocates_nothing_outside_the_factorisation) {
    const int n = 200;
    auto J = far_coupled(n, 1, n - 50);
    const sc::entry_mass<double> mass(far_coupled(n, 0.1, n));
    pair p(n);
    // Allocations of one call of each, less those that the solvers made themselves.
    const auto outside = [&](double shift) {
        inside = 0;
        const long before = allocations;
        const bool real = p.real.factor_shifted(mass, J, shift),
                   complex = p.complex.factor_shifted(mass, J, shift, -shift);
        const long all = allocations - before;
        BOOST_REQUIRE(real);
        BOOST_REQUIRE(complex);
        BOOST_TEST(inside > 0);  // Eigen's SparseLU does
        return all - inside;
    };
    BOOST_TEST(outside(30) > 0);
    for (const double shift : {30.0, 7.0, 1e3}) {
        J *= 1.5;
        BOOST_TEST(outside(shift) == 0);
    }
    J.coeffRef(2, 150) = 1;
    BOOST_TEST(outside(30) > 0);
    BOOST_TEST(outside(30) == 0);
}

BOOST_AUTO_TEST_CASE(few_unknowns_allocate_nothing_from_the_second_matrix_on) {
    const int n = 200;
    auto J = far_coupled(n, 1, n - 50);
    sc::sparse_blocks<double>::real real(n);
    sc::sparse_blocks<double>::complex complex(n);
    Eigen::VectorXd x = Eigen::VectorXd::Ones(n), y = x;
    const auto taken = [&](double shift) {
        const long before = allocations;
        const bool good = real.factor_shifted(sc::identity_mass{}, J, shift) &&
                          complex.factor_shifted(sc::identity_mass{}, J, shift, -shift);
        real.solve(x.data());
        complex.solve(x.data(), y.data());
        const long all = allocations - before;
        BOOST_REQUIRE(good);
        return all;
    };
    BOOST_TEST(taken(30) > 0);
    for (const double shift : {30.0, 7.0, 1e3}) {
        J *= 1.5;
        BOOST_TEST(taken(shift) == 0);
    }
}
