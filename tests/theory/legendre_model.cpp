// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE legendre_model
#include <boost/test/unit_test.hpp>
#include <stagecraft/tableaux/exact_collocation.hpp>
#include <stagecraft/tableaux/fixed_rational.hpp>
#include <stagecraft/theory/models/legendre_simplifying.hpp>
#include <stagecraft/theory/models/stage_algebra.hpp>
#include <stagecraft/theory/stability/algebraic_stability.hpp>
#include <stagecraft/theory/stability/nodal_stability.hpp>
#include <stagecraft/theory/stability/schwarz.hpp>

// The model against the matrices (a_ij) of the same methods, made from Lagrange polynomials on rational
// nodes: the two share no formula.

using namespace stagecraft;
using namespace stagecraft::theory;
using tableaux::construction;
using tableaux::rational;
using poly = tableaux::polynomial<rational>;
using model = legendre_model<rational>;

static_assert(stage_algebra<model>);
static_assert(stage_algebra<legendre_model<tableaux::fixed_rational>>);

namespace {

using nodes = std::vector<rational>;

rational over(int n, int d) { return {n, d}; }

// Radau and Lobatto nodes where they are rational, and nodes of no family.
const std::vector<nodes> node_sets{{over(1, 2)},
                                   {over(1, 1)},
                                   {over(0, 1)},
                                   {over(1, 3), over(1, 1)},
                                   {over(0, 1), over(2, 3)},
                                   {over(0, 1), over(1, 1)},
                                   {over(0, 1), over(1, 2), over(1, 1)},
                                   {over(0, 1), over(1, 3), over(4, 5)},
                                   {over(1, 4), over(1, 2), over(3, 4)},
                                   {over(0, 1), over(1, 3), over(2, 3), over(1, 1)},
                                   {over(1, 7), over(2, 5), over(1, 2), over(8, 9)}};

tableau<rational> matrices(const nodes& c, construction rule) {
    const auto s = static_cast<Eigen::Index>(c.size());
    const auto at = [&](Eigen::Index i) { return c[static_cast<std::size_t>(i)]; };
    tableau<rational> t;
    t.A.resize(s, s);
    t.b.resize(s);
    t.c.resize(s);
    const auto lagrange = tableaux::lagrange_basis(c);
    for (Eigen::Index j = 0; j < s; ++j) {
        const poly antiderivative = integral(lagrange[static_cast<std::size_t>(j)]);
        t.c[j] = at(j);
        t.b[j] = antiderivative(rational(1));
        for (Eigen::Index i = 0; i < s; ++i) t.A(i, j) = antiderivative(at(i));
    }
    const auto collocation = t.A;
    if (rule == construction::adjoint) {  // b_i a_ij + b_j a*_ji = b_i b_j
        for (Eigen::Index i = 0; i < s; ++i)
            for (Eigen::Index j = 0; j < s; ++j) t.A(i, j) = t.b[j] * (1 - collocation(j, i) / t.b[i]);
    }
    if (rule == construction::lobatto_iiic) {  // C(s-1) on the nodes but the first, whose column is known
        const auto rest = tableaux::lagrange_basis(nodes(c.begin() + 1, c.end()));
        for (Eigen::Index i = 0; i < s; ++i) {
            t.A(i, 0) = t.b[0];
            for (Eigen::Index j = 1; j < s; ++j) {
                const poly& l = rest[static_cast<std::size_t>(j - 1)];
                t.A(i, j) = integral(l)(at(i)) - t.b[0] * l(rational(0));
            }
        }
    }
    return t;
}

struct method {
    tableau<rational> matrix;
    theory::legendre_model<rational> legendre;
};

std::vector<method> methods() {
    std::vector<method> all;
    for (const nodes& c : node_sets) {
        const auto w = tableaux::nodal_polynomial::from_nodes(c);
        for (const auto rule :
             {construction::collocation, construction::adjoint, construction::lobatto_iiic}) {
            if (rule == construction::lobatto_iiic && (c.front() != 0 || c.size() < 2)) continue;
            all.push_back({matrices(c, rule), model(w.legendre(), rule)});
        }
    }
    return all;
}

// The stage vector with Legendre coordinates u: its values on the nodes.
tableaux::column<rational> values(const std::vector<rational>& u, const tableau<rational>& t) {
    const poly p = tableaux::from_legendre(u);
    tableaux::column<rational> v(t.c.size());
    for (Eigen::Index i = 0; i < v.size(); ++i) v[i] = p(t.c[i]);
    return v;
}

std::vector<rational> unit(int s, int k) {
    std::vector<rational> e(static_cast<std::size_t>(s));
    e[static_cast<std::size_t>(k)] = 1;
    return e;
}

// Whether A, b, c, 1 and the product are the same in both coordinates.
bool same_algebra(const tableau<rational>& t, const model& m) {
    const int s = m.stages();
    bool same = values(m.c(), t) == t.c;
    for (int k = 0; k < s; ++k) {
        const auto u = unit(s, k);
        const auto x = values(u, t), ax = values(m.apply(u), t);
        rational b(0);
        for (Eigen::Index i = 0; i < s; ++i) {
            rational sum(0);
            for (Eigen::Index j = 0; j < s; ++j) sum += t.A(i, j) * x[j];
            same = same && sum == ax[i];
            b += t.b[i] * x[i];
        }
        same = same && b == m.dot_b(u);
        for (int l = 0; l < s; ++l) {
            const auto v = unit(s, l);
            const auto y = values(v, t), product = values(m.multiply(u, v), t);
            for (Eigen::Index i = 0; i < s; ++i) same = same && product[i] == x[i] * y[i];
            same = same && m.inner(u, v) == m.dot_b(m.multiply(u, v));
        }
    }
    return same;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_ring_modulo_w_is_the_algebra_of_the_stages) {
    BOOST_TEST(methods().size() == 27U);
    for (const auto& [t, m] : methods()) BOOST_TEST(same_algebra(t, m));
    const auto gauss = model(tableaux::family::gauss, 1);
    auto wrong = matrices({over(1, 2)}, construction::collocation);
    BOOST_TEST(same_algebra(wrong, gauss));
    wrong.A(0, 0) += over(1, 1000);
    BOOST_TEST(!same_algebra(wrong, gauss));
}

BOOST_AUTO_TEST_CASE(simplifying_assumptions_agree_with_the_sums_over_the_stages) {
    for (const auto& [t, m] : methods()) {
        const auto sums = tableaux::simplifying_orders_of(t);
        const auto found = simplifying_of(m);
        const int limit = 2 * m.stages() + 1;  // where the sums stop looking
        BOOST_TEST(sums.B == found.b);
        BOOST_TEST(sums.C == std::min(found.c, limit));
        BOOST_TEST(sums.D == std::min(found.d, limit));
    }
}

BOOST_AUTO_TEST_CASE(stability_functions_agree_with_determinants_of_the_matrices) {
    for (const auto& [t, m] : methods()) {
        BOOST_TEST((stability_function_of(m) == stability_function_of(t)));
        if (!is_tridiagonal(m.A())) continue;
        BOOST_TEST((tridiagonal_r_infinity(m.A()) == stability_function_of(t).at_infinity()));
    }
}

BOOST_AUTO_TEST_CASE(a_schwarz_form_gives_the_E_polynomial) {
    int forms = 0;
    for (const auto& [t, m] : methods()) {
        const auto form = schwarz_form_of(m.A());
        if (!form) continue;
        ++forms;
        const auto r = stability_function_of(t);
        BOOST_TEST((e_polynomial(r) == poly::monomial(2 * form->size, form->leading_e())));
        BOOST_TEST(form->is_a_stable() == a_stable(r).is_proved());
    }
    BOOST_TEST(forms >= 10);
    const auto w = tableaux::nodal_polynomial::from_nodes(node_sets.back());
    BOOST_TEST(!schwarz_form_of(model(w.legendre(), construction::collocation).A()).has_value());
}

BOOST_AUTO_TEST_CASE(inertias_agree_with_the_weights_and_the_matrix_M) {
    for (const auto& [t, m] : methods()) {
        tableaux::inertia signs;
        for (Eigen::Index i = 0; i < t.b.size(); ++i)
            ++(t.b[i] < 0 ? signs.negative : t.b[i] == 0 ? signs.zero : signs.positive);
        BOOST_TEST((inertia_of(m.gram()) == signs));
        BOOST_TEST((inertia_of(algebraic_stability_matrix(m)) == stability_matrix_inertia(t)));
        BOOST_TEST(is_algebraically_stable(m) == algebraically_stable(t).is_proved());
    }
}

BOOST_AUTO_TEST_CASE(inertia_is_exact_where_the_diagonal_is_zero) {
    band_matrix<rational> m(3, 2, 2);
    m.entry(0, 2) = m.entry(2, 0) = 1;
    BOOST_TEST((inertia_of(m) == tableaux::inertia{.positive = 1, .zero = 1, .negative = 1}));
    m.entry(1, 1) = over(1, 1000000);
    BOOST_TEST((inertia_of(m) == tableaux::inertia{.positive = 2, .zero = 0, .negative = 1}));
}

BOOST_AUTO_TEST_CASE(what_does_not_determine_A_is_refused) {
    const auto inner = tableaux::nodal_polynomial::from_nodes({over(1, 4), over(3, 4)});
    BOOST_CHECK_THROW(model(inner.legendre(), construction::lobatto_iiic), std::invalid_argument);
    // The midpoint rule with a second node of weight zero.
    const auto idle = tableaux::nodal_polynomial::from_nodes({over(1, 2), over(5, 6)});
    BOOST_CHECK_THROW(model(idle.legendre(), construction::adjoint), std::invalid_argument);
    BOOST_CHECK_NO_THROW(model(idle.legendre(), construction::collocation));
    BOOST_CHECK_THROW(model({1, 2}, construction::collocation), std::invalid_argument);  // w_s is not 1
    BOOST_CHECK_THROW(model(tableaux::family::lobatto_iiic, 1), std::invalid_argument);
}
