// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <type_traits>

#include <stagecraft/bvp/measure/conditioning.hpp>

namespace stagecraft::detail {

/// The largest residual of the answer to condition k in its own equations, every row beside its largest terms.
template <class Equations, class Iterate>
auto residual_of_answer(Equations& equations, const conditioning_of<Equations>& conditioning,
                        const Iterate& x, int k) {
    using std::abs;
    using scalar = std::decay_t<decltype(x.t[0])>;
    using state = typename Equations::state;
    const int n = equations.n(), np = equations.np(), L = x.intervals();
    const auto& u = conditioning.response(k);
    const auto& p = conditioning.parameters();
    const auto& B = equations.conditions();
    scalar worst(0);
    const auto look = [&](const scalar& rest, const scalar& of) {
        if (of > scalar(0) && !(abs(rest / of) <= worst)) worst = abs(rest / of);
    };
    state most = state::Zero(n), left = most, terms = most;
    for (int i = 0; i <= L; ++i)
        for (int c = 0; c < n; ++c) most[c] = std::max(most[c], scalar(abs(u(c, i))));
    for (int r = 0; r < n + np; ++r) {
        scalar rest(r == k ? -1 : 0), of = -rest;
        for (int c = 0; c < n; ++c) {
            rest += B(r, c) * u(c, 0) + B(r, n + c) * u(c, L);
            of += (abs(B(r, c)) + abs(B(r, n + c))) * most[c];
        }
        for (int j = 0; j < np; ++j) rest += B(r, 2 * n + j) * p(j, k), of += abs(B(r, 2 * n + j) * p(j, k));
        look(rest, of);
    }
    for (int i = 0; i < L; ++i) {
        const auto E = equations.left_block(i), F = equations.right_block(i);
        const auto P = equations.parameter_block(i);
        for (int c = 0; c < n; ++c) {
            scalar rest(0), of_y(0), of_p(0);
            for (int d = 0; d < n; ++d) {
                const scalar one = E(c, d) * u(d, i), other = F(c, d) * u(d, i + 1);
                rest += one + other, of_y += abs(one) + abs(other);
            }
            for (int j = 0; j < np; ++j) rest += P(c, j) * p(j, k), of_p += abs(P(c, j) * p(j, k));
            left[c] = std::max(left[c], scalar(abs(rest)));
            terms[c] = std::max(terms[c], std::max(of_y, of_p));
        }
    }
    for (int c = 0; c < n; ++c) look(left[c], terms[c]);
    return worst;
}

/// The largest of these of all answers. Of a singular M elimination makes a regular one of its rounding errors, whose answers
/// leave the condition that they are for as it was: about 1. It is rounding errors of an M that only answers much, in whatever
/// units.
template <class Equations, class Iterate>
auto largest_residual(Equations& equations, conditioning_of<Equations>& conditioning, const Iterate& x) {
    std::decay_t<decltype(x.t[0])> worst(0);
    conditioning.fundamental();
    for (int k = 0; k < equations.n() + equations.np(); ++k) {
        const auto here = residual_of_answer(equations, conditioning, x, k);
        if (!(here <= worst)) worst = here;
    }
    return worst;
}

}  // namespace stagecraft::detail
