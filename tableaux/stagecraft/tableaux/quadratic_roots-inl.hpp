// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/quadratic_roots.hpp"

#include <algorithm>
#include <stdexcept>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/sturm.hpp"

namespace stagecraft::tableaux {

STAGECRAFT_INLINE std::optional<std::vector<quadratic>> roots_in_quadratic_field(
    const polynomial<rational>& p) {
    const auto isolated = isolate_real_roots(p);
    if (static_cast<int>(isolated.size()) != p.degree()) return {};
    integer denominators(1);
    for (const auto& a : p.coefficients()) denominators = lcm(denominators, a.denominator());
    const rational scale = abs(p.leading() * rational(denominators));
    std::vector<quadratic> roots;
    auto rest = p;
    for (const auto& root : isolated) {
        const auto fine = refine(p, root, 1 / (rational(4) * scale));
        const rational n = fine.high * scale;
        integer candidate = n.numerator() / n.denominator();  // towards zero
        for (int shift = -1; shift <= 1; ++shift) {
            const rational r = rational(candidate + shift) / scale;
            if (rest(r) != 0) continue;
            roots.push_back(quadratic(r));
            rest = rest / polynomial<rational>{-r, 1};
            break;
        }
    }
    if (rest.degree() == 2) {
        const rational half = -rest[1] / (2 * rest[2]);
        const auto surd = exact_sqrt(half * half - rest[0] / rest[2]);
        if (!surd) return {};
        roots.push_back(quadratic(half) - *surd);
        roots.push_back(quadratic(half) + *surd);
    } else if (rest.degree() > 0) {
        return {};
    }
    std::sort(roots.begin(), roots.end());
    return roots;
}

STAGECRAFT_INLINE constructed<quadratic> collocation(const polynomial<rational>& w) {
    if (w.degree() < 1) throw std::invalid_argument("polynomial: its degree must be positive");
    const auto nodes = roots_in_quadratic_field(w);
    if (!nodes) {
        throw std::invalid_argument("polynomial: the roots of " + to_string(w) +
                                    " are not real and distinct in one quadratic field");
    }
    return collocation(*nodes);
}

}  // namespace stagecraft::tableaux
