// SPDX-License-Identifier: BSL-1.0
// Lecture, sections 2.1.1 and 2.2: methods from V_s, C_s and N_s, and linear systems mode by mode. All exact.
#define BOOST_TEST_MODULE construction
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/tableaux/exact_tableau.hpp>
#include <stagecraft/tableaux/simplifying.hpp>
#include <stagecraft/tableaux/small_solve.hpp>
#include <stagecraft/theory/stability/stability_function.hpp>

using namespace stagecraft;
using tableaux::construction;
using tableaux::dense;
using tableaux::family;
using tableaux::quadratic;
using tableaux::rational;

namespace {

using matrix = dense<quadratic>;

matrix times(const matrix& a, const matrix& b) {
    matrix c(a.rows(), b.cols());
    for (Eigen::Index i = 0; i < a.rows(); ++i) {
        for (Eigen::Index j = 0; j < b.cols(); ++j) {
            c(i, j) = 0;
            for (Eigen::Index k = 0; k < a.cols(); ++k) c(i, j) = c(i, j) + a(i, k) * b(k, j);
        }
    }
    return c;
}

bool equal(const matrix& a, const matrix& b) {
    for (Eigen::Index i = 0; i < a.size(); ++i)
        if (!(a.data()[i] == b.data()[i])) return false;
    return true;
}

/// The lecture's auxiliary matrices for nodes c, and b = e_H^T V^-1.
struct auxiliary {
    matrix V, C, N, B;

    explicit auxiliary(const tableaux::column<quadratic>& c) {
        const auto s = c.size();
        V.resize(s, s);
        C.resize(s, s);
        N.resize(s, s);
        B = matrix::Constant(s, s, quadratic(0));
        matrix e(1, s);
        for (Eigen::Index k = 0; k < s; ++k) {
            const quadratic weight(static_cast<int>(k) + 1);
            e(0, k) = quadratic(1) / weight;
            for (Eigen::Index i = 0; i < s; ++i) {
                V(i, k) = 1;
                for (Eigen::Index j = 0; j < k; ++j) V(i, k) = V(i, k) * c[i];
                C(i, k) = V(i, k) * c[i] / weight;
                N(i, k) = e(0, k);
            }
        }
        const matrix b = times(e, *tableaux::inverse<quadratic>(V));
        for (Eigen::Index i = 0; i < s; ++i) B(i, i) = b(0, i);
    }
    matrix minus(const matrix& a, const matrix& b) const {
        matrix d = a;
        for (Eigen::Index i = 0; i < a.size(); ++i) d.data()[i] = a.data()[i] - b.data()[i];
        return d;
    }
    /// D(s): V^T B A = (N - C)^T B.
    matrix by_d() const {
        const matrix Vt = V.transpose(), right = minus(N, C).transpose();
        return times(*tableaux::inverse<quadratic>(B),
                     times(*tableaux::inverse<quadratic>(Vt), times(right, B)));
    }
    /// As printed: V^-T B^-1 (N - C^T) B.
    matrix by_d_as_printed() const {
        const matrix Vt = V.transpose(), Ct = C.transpose();
        return times(*tableaux::inverse<quadratic>(Vt),
                     times(*tableaux::inverse<quadratic>(B), times(minus(N, Ct), B)));
    }
    matrix by_c() const { return times(C, *tableaux::inverse<quadratic>(V)); }
    /// First column b_1 (1, ..., 1)^T, and C(s - 1).
    matrix by_first_column() const {
        matrix left = V, right = C;
        const auto last = V.cols() - 1;
        for (Eigen::Index i = 0; i <= last; ++i) {
            left(i, last) = i == 0 ? 1 : 0;  // A e_1
            right(i, last) = B(0, 0);
        }
        return times(right, *tableaux::inverse<quadratic>(left));
    }
};

/// x_1 of one step for x' = B x, exactly: (1 (x) I - h A (x) B) K = 1 (x) B x, x_1 = x + h sum b_j K_j.
matrix linear_step(const tableau<quadratic>& t, const matrix& B, const matrix& x, const quadratic& h) {
    const auto s = t.b.size(), n = B.rows();
    matrix M(s * n, s * n), right(s * n, 1);
    const matrix Bx = times(B, x);
    for (Eigen::Index i = 0; i < s; ++i)
        for (Eigen::Index p = 0; p < n; ++p) {
            right(i * n + p, 0) = Bx(p, 0);
            for (Eigen::Index j = 0; j < s; ++j)
                for (Eigen::Index q = 0; q < n; ++q)
                    M(i * n + p, j * n + q) = quadratic(i == j && p == q ? 1 : 0) - h * t.A(i, j) * B(p, q);
        }
    const matrix k = *tableaux::solve<quadratic>(M, right);
    matrix y = x;
    for (Eigen::Index j = 0; j < s; ++j)
        for (Eigen::Index p = 0; p < n; ++p) y(p, 0) = y(p, 0) + h * t.b[j] * k(j * n + p, 0);
    return y;
}

}  // namespace

BOOST_AUTO_TEST_CASE(v_s_c_s_and_n_s_give_every_family_exactly) {
    int methods = 0;
    for (const family f : tableaux::all_families) {
        for (int s = tableaux::least_stages(f); s <= 4; ++s) {
            const auto t = tableaux::exact_tableau(f, s);
            if (!t) continue;
            ++methods;
            const auxiliary m(t->c);
            for (int i = 0; i < s; ++i) BOOST_TEST((m.B(i, i) == t->b[i]));
            const auto rule = tableaux::construction_of(f);
            const matrix A = rule == construction::collocation ? m.by_c()
                             : rule == construction::adjoint   ? m.by_d()
                                                               : m.by_first_column();
            BOOST_TEST(equal(A, t->A), name(f) << " " << s);
        }
    }
    BOOST_TEST(methods >= 20);
}

BOOST_AUTO_TEST_CASE(the_printed_formula_for_d_s_gives_no_radau_ia_method) {
    const auto t = *tableaux::exact_tableau(family::radau_ia, 2);
    const auxiliary m(t.c);
    const matrix printed = m.by_d_as_printed();
    BOOST_TEST(!equal(printed, t.A));
    BOOST_TEST((printed(0, 0) == quadratic(rational(1, 2)) && printed(0, 1) == quadratic(rational(-11, 12))));
    BOOST_TEST((printed(1, 0) == quadratic(rational(1, 2)) && printed(1, 1) == quadratic(rational(5, 12))));
    BOOST_TEST(equal(m.by_d(), t.A));
}

BOOST_AUTO_TEST_CASE(lemma_2_10_needs_distinct_nodes_and_no_positive_weights) {
    const auto q = [](int a, int b) {
        return quadratic(rational(tableaux::integer(a), tableaux::integer(b)));
    };
    // Nodes 1/10, 1/5, 48/61: b_1 = -50/1257 < 0, B(4).
    tableaux::column<quadratic> c(3);
    c << q(1, 10), q(1, 5), q(48, 61);
    const auxiliary m(c);
    tableau<quadratic> t;
    t.c = c;
    t.b = m.B.diagonal();
    BOOST_TEST((t.b[0] == q(-50, 1257)));
    // 1. B(3 + 1), C(3) => D(1), and 2. B(3 + 1), D(3) => C(1), both with a negative weight.
    t.A = m.by_c();
    const auto from_c = tableaux::simplifying_orders_of(t);
    BOOST_TEST((from_c.B == 4 && from_c.C == 3 && from_c.D == 1));
    t.A = m.by_d();
    const auto from_d = tableaux::simplifying_orders_of(t);
    BOOST_TEST((from_d.B == 4 && from_d.C == 1 && from_d.D == 3));
    // A node moved: B(3) only, and neither conclusion.
    c[2] = q(4, 5);
    const auxiliary moved(c);
    t.c = c, t.b = moved.B.diagonal(), t.A = moved.by_c();
    const auto without_b = tableaux::simplifying_orders_of(t);
    BOOST_TEST((without_b.B == 3 && without_b.C == 3 && without_b.D == 0));
    // Equal nodes: b and A of the one-stage midpoint rule, split; B(2), C(1) stay, D(1) does not.
    tableau<quadratic> twice;
    twice.c = tableaux::column<quadratic>::Constant(2, q(1, 2));
    twice.b = twice.c;
    twice.A = matrix(2, 2);
    twice.A << q(1, 1), q(-1, 2), q(1, 1), q(-1, 2);
    const auto equal_nodes = tableaux::simplifying_orders_of(twice);
    BOOST_TEST((equal_nodes.B == 2 && equal_nodes.C >= 1 && equal_nodes.D == 0));
}

BOOST_AUTO_TEST_CASE(d_of_s_and_b_of_s_leave_no_weight_0_which_lemma_2_10_divides_by) {
    // Nodes x, 1/4, 5/6: b_1 = 0, since (t - 1/4)(t - 5/6) has the integral 0 over [0, 1]. D(3) fixes b_1 a_1j = sum_k
    // (V^-T)_1k b_j (1 - c_j^k)/k, which would have to be 0 for all j; for no x it is.
    const auto q = [](int a, int b) {
        return quadratic(rational(tableaux::integer(a), tableaux::integer(b)));
    };
    for (const int x : {0, 1, 3, 7, 11, 12}) {
        tableaux::column<quadratic> c(3);
        c << q(x, 12), q(1, 4), q(5, 6);
        if (c[0] == c[1]) continue;
        const auxiliary m(c);
        BOOST_TEST((m.B(0, 0) == 0));
        const matrix Vt = m.V.transpose(), right = m.minus(m.N, m.C).transpose(),
                     weighted = times(*tableaux::inverse<quadratic>(Vt), times(right, m.B));
        BOOST_TEST(!(weighted(0, 0) == 0 && weighted(0, 1) == 0 && weighted(0, 2) == 0));
    }
}

BOOST_AUTO_TEST_CASE(section_2_2_every_mode_of_a_linear_system_is_multiplied_by_r_of_h_sigma_exactly) {
    const std::vector<tableau<quadratic>> methods{
        *tableaux::exact_tableau(family::gauss, 1),        *tableaux::exact_tableau(family::gauss, 2),
        *tableaux::exact_tableau(family::radau_iia, 2),    *tableaux::exact_tableau(family::radau_ia, 2),
        *tableaux::exact_tableau(family::lobatto_iiia, 3), *tableaux::exact_tableau(family::lobatto_iiic, 2)};
    matrix T(3, 3), x(3, 1);
    T << quadratic(1), quadratic(2), quadratic(0), quadratic(-1), quadratic(1), quadratic(3), quadratic(2),
        quadratic(0), quadratic(1);
    x << quadratic(3), quadratic(-1), quadratic(5);
    const std::vector<int> sigma{-1, -7, -100};
    matrix D = matrix::Constant(3, 3, quadratic(0));
    for (int k = 0; k < 3; ++k) D(k, k) = sigma[static_cast<std::size_t>(k)];
    const matrix Ti = *tableaux::inverse<quadratic>(T), B = times(T, times(D, Ti));
    const quadratic h(rational(3, 8));
    for (const auto& t : methods) {
        const auto r = theory::stability_function_of(t);
        matrix y = x, modes = times(Ti, x);
        for (int n = 0; n < 3; ++n) {
            y = linear_step(t, B, y, h);
            const matrix now = times(Ti, y);
            for (int k = 0; k < 3; ++k) {
                modes(k, 0) = modes(k, 0) * r(h * quadratic(sigma[static_cast<std::size_t>(k)]));
                BOOST_TEST((now(k, 0) == modes(k, 0)));
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(section_2_2_a_defective_matrix_has_no_modes_and_grows_before_it_decays) {
    matrix B(2, 2), x(2, 1);
    B << quadratic(-1), quadratic(100), quadratic(0), quadratic(-1);
    x << quadratic(0), quadratic(1);
    const auto t = *tableaux::exact_tableau(family::gauss, 1);
    const quadratic h(rational(1, 2));
    // |R(h sigma)| = 3/5 < 1 for the only eigenvalue, and yet |x_1| > |x_0|
    BOOST_TEST((theory::stability_function_of(t)(quadratic(rational(-1, 2))) == quadratic(rational(3, 5))));
    matrix y = linear_step(t, B, x, h);
    BOOST_TEST((quadratic(10) < y(0, 0)));
    for (int n = 1; n < 40; ++n) y = linear_step(t, B, y, h);
    BOOST_TEST((y(0, 0) * y(0, 0) + y(1, 0) * y(1, 0) < quadratic(rational(1, 1000))));
}
