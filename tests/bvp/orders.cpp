// SPDX-License-Identifier: BSL-1.0
// Collocation of boundary value problems at 50 digits: the orders that the exact tableau has, at mesh points, between
// them, of the lifted solution, and of algebraic components.
#define BOOST_TEST_MODULE bvp_orders
#include <Eigen/LU>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/tableaux/exact_tableau.hpp>
#include <stagecraft/tableaux/rounded.hpp>
#include <stagecraft/theory/dae/dae_order.hpp>
#include <string>
#include <vector>

namespace sc = stagecraft;
using enum sc::tableaux::family;
using sc::tableaux::construction;
using sc::tableaux::nodal_polynomial;
using sc::tableaux::rational;
using fifty =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using vector = Eigen::Matrix<fifty, Eigen::Dynamic, 1>;
using none = Eigen::Matrix<fifty, 0, 1>;

namespace {

/// ordinary: 1/(1+t), 1/(1+t)^2, with terms that vanish on the solution. index_1: y' = -y z, 0 = (y^2 - z) (1 + y z), y = (1+2t)^{-1/2}, z = 1/(1+2t).
struct rhs {
    bool index_1;
    template <class Y>
    void operator()(const fifty&, const Y& y, Y& f) const {
        if (index_1) {
            f[0] = -y[0] * y[1];
            f[1] = (y[0] * y[0] - y[1]) * (y[0] * y[1] + 1);
        } else {
            const auto d = y[0] * y[0] - y[1];
            f[0] = -y[1] + d * (y[0] + 1);
            f[1] = -2 * y[0] * y[1] - d * y[1];
        }
    }
    Eigen::DiagonalMatrix<fifty, Eigen::Dynamic> mass() const {
        Eigen::DiagonalMatrix<fifty, Eigen::Dynamic> m(2);
        m.diagonal() << 1, index_1 ? 0 : 1;
        return m;
    }
    vector exact(const fifty& t) const {
        vector y(2);
        const fifty r = 1 / (1 + t), z = 1 / (1 + 2 * t);
        if (index_1)
            y << sqrt(z), z;
        else
            y << r, r * r;
        return y;
    }
};

/// The first component at the left end and the second at the right, or y at the right end and the constraint at the left one.
struct ends {
    bool index_1;
    template <class Y>
    void operator()(const Y& left, const Y& right, Y& r) const {
        r[0] = index_1 ? right[0] - 1 / sqrt(fifty(2)) : left[0] - 1;
        r[1] = index_1 ? left[0] * left[0] - left[1] : right[1] - fifty(4) / 9;
    }
};

/// Errors at t = 1/4, a mesh point: of both components, of the constraint's z there; at 3/10 of an interval, of the
/// collocation polynomial and of the returned solution.
struct errors {
    vector node, z_imposed, between, lifted;
};

errors of(const sc::tableau<fifty>& m, bool index_1, int intervals) {
    using problem = sc::two_point_problem<rhs, ends>;
    problem p{{index_1}, {index_1}};
    sc::bvp_options<fifty> o;
    o.rtol = fifty("1e-40"), o.intervals = intervals, o.adapt = false, o.conditioning = false;
    sc::report<fifty> counts;
    sc::two_point_system<problem, vector, none> functions(p.f, p.r, 2, 0, counts);
    sc::detail::bvp_solver<Eigen::Dynamic, vector, none> solver(m, functions, none(), o);
    const auto answer = solver.run([&](const fifty& t) { return p.f.exact(t); }, fifty(0), fifty(1) / 2);
    BOOST_TEST(sc::name(answer.status) == std::string("tolerance_not_met"));  // by one mesh it cannot be
    const auto& x = solver.solution_on_mesh();
    const int half = intervals / 2, s = m.stages();
    const fifty theta = fifty(3) / 10, h = x.h(half), t = x.t[half], inside = t + theta * h;
    // u(theta) = y + sum_k w_k Z_k with sum_k w_k c_k^{q-1} = theta^q / q.
    Eigen::Matrix<fifty, Eigen::Dynamic, Eigen::Dynamic> moments(s, s);
    vector powers(s);
    for (int q = 0; q < s; ++q) {
        powers[q] = pow(theta, q + 1) / (q + 1);
        for (int k = 0; k < s; ++k) moments(q, k) = q == 0 ? fifty(1) : fifty(moments(q - 1, k) * m.c[k]);
    }
    const vector w = moments.partialPivLu().solve(powers);
    vector u = x.y.col(half);
    for (int k = 0; k < s; ++k) u += w[k] * x.Z.col(half * s + k);
    vector imposed = x.y.col(half) - p.f.exact(t);
    imposed[1] = x.y(0, half) * x.y(0, half) - p.f.exact(t)[1];
    return {vector(x.y.col(half) - p.f.exact(t)), imposed, vector(u - p.f.exact(inside)),
            vector(answer.y(inside) - p.f.exact(inside))};
}

double slope(const fifty& coarse, const fifty& fine) {
    return static_cast<double>(fifty(log(abs(fifty(coarse / fine))) / log(fifty(2))));
}
void is(const vector& coarse, const vector& fine, int order) {
    for (int c = 0; c < 2; ++c) {
        const double k = slope(coarse[c], fine[c]);
        BOOST_TEST(std::abs(k - order) < 0.05, k << " is not " << order);
    }
}

sc::tableau<fifty> collocation_at(const std::vector<rational>& nodes) {
    return sc::tableaux::rounded<fifty>(nodal_polynomial::from_nodes(nodes), construction::collocation);
}
int certified(const std::vector<rational>& nodes) {
    return sc::theory::classical_order(
        sc::tableaux::exact_tableau(nodal_polynomial::from_nodes(nodes), construction::collocation).value());
}

struct member {
    sc::tableaux::family f;
    int s, intervals;
};

}  // namespace

BOOST_AUTO_TEST_CASE(mesh_points_show_the_order_of_the_tableau_and_points_between_s_plus_1_unless_lifted) {
    for (const auto& m : {member{gauss, 2, 64}, member{gauss, 3, 64}, member{lobatto_iiia, 3, 64},
                          member{lobatto_iiia, 4, 64}, member{radau_iia, 2, 64}, member{radau_iia, 3, 256}})
        BOOST_TEST_CONTEXT(name(m.f) << " s = " << m.s) {
            const int order = 2 * m.s - (m.f == gauss ? 0 : m.f == radau_iia ? 1 : 2);
            BOOST_TEST(sc::theory::classical_order(sc::tableaux::exact_tableau(m.f, m.s).value()) == order);
            const auto t = sc::tableaux::rounded<fifty>(m.f, m.s);
            const errors a = of(t, false, m.intervals), b = of(t, false, 2 * m.intervals),
                         c = of(t, false, 4 * m.intervals);
            is(b.node, c.node, order);
            is(b.lifted, c.lifted, order);
            is(b.between, c.between, m.s + 1);
            // What is left when the leading power of h is eliminated: the next even one for symmetric methods.
            const fifty power = pow(fifty(2), order);
            is(power * b.node - a.node, power * c.node - b.node, order + (m.f == radau_iia ? 1 : 2));
        }
}

BOOST_AUTO_TEST_CASE(a_node_moved_by_1e_3_takes_the_order_away_that_the_certificate_takes_away) {
    const rational moved(1, 1000);
    for (const bool lobatto : {true, false}) {
        const auto nodes = [&](const rational& d) {
            return lobatto ? std::vector<rational>{0, rational(1, 2) + d, 1}
                           : std::vector<rational>{rational(1, 3) + d, 1};
        };
        const int order = lobatto ? 4 : 3;
        BOOST_TEST(certified(nodes(0)) == order);
        BOOST_TEST(certified(nodes(moved)) == order - 1);
        // The part of the error that is odd in the distance: without h^order, which is common to both sides.
        const auto odd = [&](int intervals) {
            return vector(of(collocation_at(nodes(moved)), false, intervals).node -
                          of(collocation_at(nodes(-moved)), false, intervals).node);
        };
        is(odd(64), odd(128), order - 1);
    }
}

BOOST_AUTO_TEST_CASE(index_1_shows_the_orders_of_theorem_vi_1_1_and_2s_with_the_constraint_imposed) {
    for (const auto& m :
         {member{gauss, 2, 64}, member{gauss, 3, 64}, member{radau_iia, 2, 64}, member{radau_iia, 3, 256}})
        BOOST_TEST_CONTEXT(name(m.f) << " s = " << m.s) {
            const auto predicted = sc::theory::predict_index1(sc::tableaux::exact_tableau(m.f, m.s).value());
            BOOST_REQUIRE(predicted.applies());
            const int order = 2 * m.s - (m.f == gauss ? 0 : 1), order_z = m.f == radau_iia ? order
                                                                          : m.s % 2 == 0   ? m.s
                                                                                           : m.s + 1;
            BOOST_TEST(*predicted.y == order);
            BOOST_TEST(*predicted.z == order_z);
            const auto t = sc::tableaux::rounded<fifty>(m.f, m.s);
            const errors a = of(t, true, m.intervals), b = of(t, true, 2 * m.intervals);
            const double y = slope(a.node[0], b.node[0]), z = slope(a.node[1], b.node[1]),
                         imposed = slope(a.z_imposed[1], b.z_imposed[1]);
            BOOST_TEST(std::abs(y - order) < 0.05, y << " is not " << order);
            BOOST_TEST(std::abs(z - order_z) < 0.05, z << " is not " << order_z);
            BOOST_TEST(std::abs(imposed - order) < 0.05, imposed << " is not " << order);
        }
}
