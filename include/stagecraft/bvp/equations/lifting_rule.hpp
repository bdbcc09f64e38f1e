// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <memory>
#include <vector>

#include <stagecraft/bvp/options.hpp>
#include <stagecraft/dense_output.hpp>
#include <stagecraft/method/legendre_rule.hpp>
#include <stagecraft/method/order_conditions.hpp>
#include <stagecraft/tableau.hpp>

namespace stagecraft::detail {

/// Throws unless the method is collocation with distinct nodes: C(s) and B(s). Its order at mesh points.
template <class Scalar, int S>
int collocation_order(const tableau<Scalar, S>& m) {
    const int s = m.stages();
    demand_bvp(s > 0 && m.A.rows() == s && m.A.cols() == s && m.c.size() == s,
               "method must be a tableau with s x s numbers in A and s in b and c");
    bool distinct = true;
    for (int i = 0; i < s; ++i)
        for (int j = 0; j < i; ++j) distinct = distinct && !(m.c[i] == m.c[j]);
    demand_bvp(distinct && stage_conditions(m, s) >= s && quadrature_conditions(m, s) >= s,
               "method must be a collocation tableau with distinct nodes: C(s) and B(s)");
    return quadrature_conditions(m, 2 * s);
}

/// The numbers by which error_estimate.hpp lifts a collocation method: m Gauss nodes, integrals and values there, and two
/// points between them where what is left over is looked at. They depend on the method alone.
template <class Scalar, int S>
struct lifting_rule {
    using matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    using row = Eigen::Matrix<Scalar, 1, Eigen::Dynamic>;
    struct point {
        Scalar theta, reach;  ///< local errors are about reach times h times the defect
        Scalar level;         ///< |P_m| there: the defect over that at the ends
        row value, integral, lagrange;
    };

    tableau<Scalar, S> method;
    int order;                    ///< at mesh points
    legendre_rule<Scalar> gauss;  ///< m nodes
    matrix integrals, twice;      ///< m x m, to the nodes; twice: their square, for y'' = g
    matrix integrals_of;  ///< integrals transposed: row l is what the value at node l adds to each of them
    matrix lagrange;      ///< m x s, from the method's nodes to the Gauss nodes
    matrix lagrange_integrals_of;  ///< s x m, the integrals of the same polynomials to the Gauss nodes
    matrix to_coefficients;        ///< values at the Gauss nodes to Legendre coefficients
    point check[2];
    interpolation_nodes<Scalar, dynamic>
        of_pieces;               ///< the Gauss nodes, for polynomials through values there
    std::vector<Scalar> ratios;  ///< k / (k + 1)
    row at_start, at_end;        ///< from values at the Gauss nodes to those at 0 and 1
    Scalar first, last;          ///< where f is evaluated first and last
    Scalar unseen{0};            ///< the most that a jump of f adds to local errors, over what is seen of it
    Scalar jump_share{1};        ///< where f jumps, that is more than this part of the last coefficients

    explicit lifting_rule(const tableau<Scalar, S>& t)
        : method(t),
          order(collocation_order(t)),
          gauss(nodes_for(order, t.stages(), t.facts.r_infinity)),
          integrals(gauss.size(), gauss.size()),
          lagrange(gauss.size(), t.stages()),
          to_coefficients(gauss.to_coefficients),
          of_pieces(gauss.size()) {
        of_pieces.size = gauss.size();
        std::copy_n(gauss.c.data(), gauss.size(), of_pieces.c.begin());
        of_pieces.finish();
        for (int k = 0; k < gauss.size(); ++k) {
            integrals.row(k) = gauss.integral(gauss.c[k]);
            lagrange.row(k) = lagrange_at(gauss.c[k]);
        }
        for (int k = 0; k <= nodes(); ++k) ratios.push_back(Scalar(k) / Scalar(k + 1));
        twice = integrals.lazyProduct(integrals);
        integrals_of = integrals.transpose();
        lagrange_integrals_of = integrals.lazyProduct(lagrange).transpose();
        check[0] = point_at(check_point(Scalar(0), Scalar(3) / 10));
        check[1] = point_at(check_point(Scalar(3) / 10, Scalar(1)));
        at_start = gauss.value(Scalar(0));
        at_end = gauss.value(Scalar(1));
        first = std::min(Scalar(method.c.minCoeff()), Scalar(gauss.c[0]));
        last = std::max(Scalar(method.c.maxCoeff()), Scalar(gauss.c[nodes() - 1]));
        look_at_jumps();
    }

    int nodes() const { return gauss.size(); }
    /// The larger one of the last two Legendre coefficients of values at the Gauss nodes, `stride` apart.
    Scalar last_coefficients(const Scalar* values, int stride) const {
        using std::abs;
        const int m = nodes();
        Scalar highest(0), before(0);
        for (int k = 0; k < m; ++k) {
            highest += to_coefficients(m - 1, k) * values[k * stride];
            before += to_coefficients(m - 2, k) * values[k * stride];
        }
        return std::max(Scalar(abs(highest)), Scalar(abs(before)));
    }
    /// legendre_values() without a division, up to P_m.
    void legendre(const Scalar& x, int most, Scalar* P) const { legendre_values(x, most, ratios, P); }

  private:
    /// p - 1, which lifts to order p, but not above s + 2: more nodes cost more than the intervals they save. As Gauss methods
    /// have R(inf) = 1 or -1 for even or odd numbers of nodes, m has the sign of the method's own, so that both carry
    /// stiff components on in the same way.
    static int nodes_for(int order, int s, double r_infinity) {
        const int m = std::min(std::max(order - 1, s + 1), s + 2);
        if (r_infinity == -1) return m % 2 == 1 ? m : m + 1;
        if (r_infinity == 1) return m % 2 == 0 ? m : m + 1;
        return m;
    }
    /// Of an f that jumps by 1 inside an interval every rule knows only between which of its points it does: both may miss
    /// the same part of its integral, and only the points of check show that there is a jump.
    void look_at_jumps() {
        using std::abs;
        std::vector<Scalar> points(method.c.data(), method.c.data() + method.stages());
        for (int k = 0; k < nodes(); ++k) points.push_back(gauss.c[k]);
        for (const auto& at : check) points.push_back(at.theta);
        std::sort(points.begin(), points.end());
        row values(nodes());
        Scalar least(1);
        for (std::size_t k = 0; k + 1 < points.size(); ++k) {
            const Scalar middle = (points[k] + points[k + 1]) / 2;
            const auto after = [&](const Scalar& theta) { return theta > middle ? Scalar(1) : Scalar(0); };
            Scalar own(0), lifted(0), seen(0);
            for (int j = 0; j < method.stages(); ++j) own += method.b[j] * after(method.c[j]);
            for (int j = 0; j < nodes(); ++j) values[j] = after(gauss.c[j]), lifted += gauss.b[j] * values[j];
            for (const auto& at : check)
                seen = std::max(seen, Scalar(at.reach * abs(at.value.dot(values) - after(at.theta))));
            const Scalar coefficients = last_coefficients(values.data(), 1);
            if (!(coefficients > Scalar(1) / 1000)) continue;  // before the first node or behind the last
            least = std::min(least, Scalar(seen / coefficients));
            for (const auto& theta : {points[k], points[k + 1]}) {
                const Scalar missed = abs(own - (1 - theta)) - abs(own - lifted);
                unseen = std::max(unseen, Scalar(missed / seen));
            }
        }
        jump_share = least / 2;
    }
    point point_at(const Scalar& theta) const {
        return {
            theta, reach(theta), level(theta), gauss.value(theta), gauss.integral(theta), lagrange_at(theta)};
    }
    /// Halfway between two nodes, where the polynomial with zeros at the collocation points is large: there the
    /// interpolated Jacobians are at their worst.
    Scalar check_point(const Scalar& from, const Scalar& to) const {
        using std::abs;
        Scalar best = (from + to) / 2, largest(0);
        for (int k = 0; k + 1 < nodes(); ++k) {
            const Scalar middle = (gauss.c[k] + gauss.c[k + 1]) / 2;
            Scalar product(1);
            for (int j = 0; j < method.stages(); ++j) product *= abs(middle - method.c[j]);
            if (middle >= from && middle <= to && product > largest) largest = product, best = middle;
        }
        return best;
    }
    /// Defects that vanish at the Gauss nodes have P_m as leading term: its largest integral over its value.
    Scalar reach(const Scalar& theta) const {
        using std::abs;
        const int m = nodes();
        row values(m + 1);
        Scalar largest(0);
        for (int k = 0; k < m; ++k) {
            legendre_integrals(gauss.c[k], m, values.data());
            largest = std::max(largest, Scalar(abs(values[m])));
        }
        return largest / level(theta);
    }
    Scalar level(const Scalar& theta) const {
        using std::abs;
        row values(nodes() + 1);
        legendre_values(theta, nodes(), values.data());
        return abs(values[nodes()]);
    }
    row lagrange_at(const Scalar& theta) const {
        const auto& c = method.c;
        row l(method.stages());
        for (int j = 0; j < method.stages(); ++j) {
            l[j] = Scalar(1);
            for (int k = 0; k < method.stages(); ++k)
                if (k != j) l[j] *= (theta - c[k]) / (c[j] - c[k]);
        }
        return l;
    }
};

/// The rule of a method; that of the method asked for last is remembered, as finding it costs as much as the solution of
/// an easy problem.
template <class Scalar, int S>
std::shared_ptr<const lifting_rule<Scalar, S>> lifting_rule_of(const tableau<Scalar, S>& method) {
    thread_local std::shared_ptr<const lifting_rule<Scalar, S>> last;
    const auto same = [&](const tableau<Scalar, S>& other) {
        return other.stages() == method.stages() && other.c == method.c && other.b == method.b &&
               other.A == method.A && other.facts.r_infinity == method.facts.r_infinity;
    };
    if (!last || !same(last->method)) last = std::make_shared<const lifting_rule<Scalar, S>>(method);
    return last;
}

/// out = the sum of q[l] times column l of W, columns of `size` numbers that lie `stride` apart. Count is the number of
/// columns where it is known at compile time, or 0.
template <int Size, int Count = 0, class Scalar>
void combine(const Scalar* q, int count, const Scalar* W, int stride, Scalar* out, int size) {
    if constexpr (Count > 0) count = Count;
    if constexpr (0 < Size && Size <= 16) {
        using column = Eigen::Matrix<Scalar, Size, 1>;
        column sum = column::Zero();
        for (int l = 0; l < count; ++l) sum += q[l] * Eigen::Map<const column>(W + l * stride);
        for (int c = 0; c < Size; ++c) out[c] = sum[c];
    } else {
        for (int c = 0; c < size; ++c) out[c] = Scalar(0);
        for (int l = 0; l < count; ++l)
            for (int c = 0; c < size; ++c) out[c] += q[l] * W[l * stride + c];
    }
}

}  // namespace stagecraft::detail
