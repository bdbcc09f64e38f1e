// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/exact_collocation.hpp>
#include <stagecraft/tableaux/quadratic.hpp>
#include <stagecraft/tableaux/rational.hpp>
#include <vector>

/// Published methods as exact tableaux, typed in from the literature.
namespace methods {

using stagecraft::tableaux::quadratic;
using stagecraft::tableaux::rational;

template <class K>
stagecraft::tableau<K> make(const std::vector<std::vector<K>>& a, const std::vector<K>& b,
                            const std::vector<K>& c) {
    stagecraft::tableau<K> t;
    const auto s = static_cast<Eigen::Index>(b.size());
    t.A.resize(s, s);
    t.b.resize(s);
    t.c.resize(s);
    for (Eigen::Index i = 0; i < s; ++i) {
        const auto r = static_cast<std::size_t>(i);
        t.b[i] = b[r];
        t.c[i] = c[r];
        for (Eigen::Index j = 0; j < s; ++j) {
            const auto k = static_cast<std::size_t>(j);
            t.A(i, j) = k < a[r].size() ? a[r][k] : K(0);  // rows may stop at the last non-zero entry
        }
    }
    return t;
}

inline rational q(int n, int d = 1) { return {n, d}; }

inline auto explicit_euler() { return make<rational>({{}}, {1}, {0}); }
inline auto implicit_euler() { return make<rational>({{1}}, {1}, {1}); }
inline auto midpoint() { return make<rational>({{q(1, 2)}}, {1}, {q(1, 2)}); }
inline auto trapezoidal() { return make<rational>({{}, {q(1, 2), q(1, 2)}}, {q(1, 2), q(1, 2)}, {0, 1}); }
inline auto heun2() { return make<rational>({{}, {1}}, {q(1, 2), q(1, 2)}, {0, 1}); }
inline auto kutta3() {
    return make<rational>({{}, {q(1, 2)}, {-1, 2}}, {q(1, 6), q(2, 3), q(1, 6)}, {0, q(1, 2), 1});
}
inline auto rk4() {
    return make<rational>({{}, {q(1, 2)}, {0, q(1, 2)}, {0, 0, 1}}, {q(1, 6), q(1, 3), q(1, 3), q(1, 6)},
                          {0, q(1, 2), q(1, 2), 1});
}
inline auto ssp33() {
    return make<rational>({{}, {1}, {q(1, 4), q(1, 4)}}, {q(1, 6), q(1, 6), q(2, 3)}, {0, 1, q(1, 2)});
}
/// Ketcheson's ten-stage method of order 4 (2008).
inline auto ssp104() {
    std::vector<std::vector<rational>> a(10);
    for (int i = 1; i < 5; ++i) a[static_cast<std::size_t>(i)].assign(static_cast<std::size_t>(i), q(1, 6));
    for (int i = 5; i < 10; ++i) {
        a[static_cast<std::size_t>(i)].assign(5, q(1, 15));
        a[static_cast<std::size_t>(i)].insert(a[static_cast<std::size_t>(i)].end(),
                                              static_cast<std::size_t>(i - 5), q(1, 6));
    }
    return make<rational>(a, std::vector<rational>(10, q(1, 10)),
                          {0, q(1, 6), q(1, 3), q(1, 2), q(2, 3), q(1, 3), q(1, 2), q(2, 3), q(5, 6), 1});
}

inline quadratic surd(const rational& a, const rational& b, unsigned d) { return {a, b, d}; }

inline auto gauss2() {
    return stagecraft::tableaux::collocation<quadratic>(
               {surd(q(1, 2), q(-1, 6), 3), surd(q(1, 2), q(1, 6), 3)})
        .tableau;
}
inline auto gauss3() {
    return stagecraft::tableaux::collocation<quadratic>(
               {surd(q(1, 2), q(-1, 10), 15), q(1, 2), surd(q(1, 2), q(1, 10), 15)})
        .tableau;
}
inline auto radau_iia2() { return stagecraft::tableaux::collocation<rational>({q(1, 3), 1}).tableau; }
inline auto radau_iia3() {
    return stagecraft::tableaux::collocation<quadratic>(
               {surd(q(2, 5), q(-1, 10), 6), surd(q(2, 5), q(1, 10), 6), 1})
        .tableau;
}
inline auto radau_ia2() {
    return make<rational>({{q(1, 4), q(-1, 4)}, {q(1, 4), q(5, 12)}}, {q(1, 4), q(3, 4)}, {0, q(2, 3)});
}
/// Hairer-Wanner II, Table IV.5.5.
inline auto radau_ia3() {
    const rational n = q(1, 9);
    return make<quadratic>({{n, surd(q(-1, 18), q(-1, 18), 6), surd(q(-1, 18), q(1, 18), 6)},
                            {n, surd(q(88, 360), q(7, 360), 6), surd(q(88, 360), q(-43, 360), 6)},
                            {n, surd(q(88, 360), q(43, 360), 6), surd(q(88, 360), q(-7, 360), 6)}},
                           {n, surd(q(16, 36), q(1, 36), 6), surd(q(16, 36), q(-1, 36), 6)},
                           {0, surd(q(6, 10), q(-1, 10), 6), surd(q(6, 10), q(1, 10), 6)});
}
inline auto lobatto_iiia3() { return stagecraft::tableaux::collocation<rational>({0, q(1, 2), 1}).tableau; }
inline auto lobatto_iiib3() {
    return make<rational>({{q(1, 6), q(-1, 6), 0}, {q(1, 6), q(1, 3), 0}, {q(1, 6), q(5, 6), 0}},
                          {q(1, 6), q(2, 3), q(1, 6)}, {0, q(1, 2), 1});
}
inline auto lobatto_iiic2() {
    return make<rational>({{q(1, 2), q(-1, 2)}, {q(1, 2), q(1, 2)}}, {q(1, 2), q(1, 2)}, {0, 1});
}
inline auto lobatto_iiic3() {
    return make<rational>(
        {{q(1, 6), q(-1, 3), q(1, 6)}, {q(1, 6), q(5, 12), q(-1, 12)}, {q(1, 6), q(2, 3), q(1, 6)}},
        {q(1, 6), q(2, 3), q(1, 6)}, {0, q(1, 2), 1});
}
/// Hairer-Wanner II, Table IV.5.12.
inline auto lobatto_iiic4() {
    const rational n = q(1, 12);
    return make<quadratic>({{n, surd(0, q(-1, 12), 5), surd(0, q(1, 12), 5), -n},
                            {n, q(1, 4), surd(q(10, 60), q(-7, 60), 5), surd(0, q(1, 60), 5)},
                            {n, surd(q(10, 60), q(7, 60), 5), q(1, 4), surd(0, q(-1, 60), 5)},
                            {n, q(5, 12), q(5, 12), n}},
                           {n, q(5, 12), q(5, 12), n},
                           {0, surd(q(1, 2), q(-1, 10), 5), surd(q(1, 2), q(1, 10), 5), 1});
}

}  // namespace methods
