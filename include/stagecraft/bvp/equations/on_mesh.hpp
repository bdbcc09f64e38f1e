// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <type_traits>
#include <vector>

#include <stagecraft/linear/row_panel.hpp>

namespace stagecraft::detail {

/// The polynomials of degree m on the intervals of x, whose slopes times h at the m Gauss nodes of a lifting rule are given
/// (n x m for every interval), as values on the mesh t and slopes at the nodes c of its intervals. Nodes is m where
/// it is known at compile time, or 0.
template <int Nodes, class Rule, class Collocation, class Wide, class Iterate>
Iterate on_mesh(const Rule& rule, const Collocation& c, const Wide& slopes, const Iterate& x,
                const decltype(Iterate::t)& t) {
    using scalar = std::decay_t<decltype(x.t[0])>;
    using column = Eigen::Matrix<scalar, Eigen::Dynamic, 1>;
    constexpr int N = Wide::RowsAtCompileTime;
    const int L = static_cast<int>(t.size()) - 1, n = static_cast<int>(slopes.rows()),
              s = static_cast<int>(c.size()), m = Nodes > 0 ? Nodes : rule.nodes();
    Iterate next;
    next.t = t;
    next.p = x.p;
    next.y.resize(n, L + 1);
    next.Z.resize(n, s * L);
    Wide coefficients(n, m);
    column P(m + 1), integrals(m);
    int i = 0, known = -1;
    const auto go_to = [&](const scalar& time) {
        while (i + 1 < x.intervals() && x.t[i + 1] < time) ++i;
        if (known != i)
            for (int k = 0; k < m; ++k)
                combine<N, Nodes>(rule.to_coefficients.data() + k * m, m, &slopes(0, i * m), n,
                                  &coefficients(0, k), n);
        known = i;
        rule.legendre(scalar((time - x.t[i]) / x.h(i)), m, P.data());
    };
    for (int k = 0; k < L; ++k) {
        const scalar h = t[k + 1] - t[k];
        go_to(t[k]);
        integrals[0] = (P[0] + P[1]) / 2;  // P_0 + P_1 = 2 theta
        for (int l = 1; l < m; ++l) integrals[l] = (P[l + 1] - P[l - 1]) / scalar(2 * (2 * l + 1));
        combine<N, Nodes>(integrals.data(), m, coefficients.data(), n, &next.y(0, k), n);
        for (int d = 0; d < n; ++d) next.y(d, k) += x.y(d, i);
        for (int j = 0; j < s; ++j) {
            go_to(scalar(t[k] + c[j] * h));
            scalar* Z = &next.Z(0, k * s + j);
            combine<N, Nodes>(P.data(), m, coefficients.data(), n, Z, n);
            for (int d = 0; d < n; ++d) Z[d] *= h / x.h(i);
        }
    }
    next.y.col(L) = x.y.col(x.intervals());
    return next;
}

}  // namespace stagecraft::detail
