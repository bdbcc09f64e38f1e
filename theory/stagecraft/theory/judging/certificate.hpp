// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stagecraft/tableau.hpp"
#include "stagecraft/tableaux/rational.hpp"
#include "stagecraft/theory/judging/principal_error.hpp"
#include "stagecraft/theory/models/legendre_simplifying.hpp"
#include "stagecraft/theory/stability/spectrum.hpp"
#include "stagecraft/theory/stability/stability_function.hpp"
#include "stagecraft/theory/statements/verdict.hpp"

namespace stagecraft::theory {

/// A statement about a method and what is known of it.
struct claim {
    std::string statement;
    theory::verdict verdict;
    friend bool operator==(const claim&, const claim&) = default;
};

/// Everything proved of one method: the claims in words, and the exact results they speak of. An immutable
/// value; `certify` makes it.
struct certificate {
    std::string method;
    int stages = 0;
    theory::simplifying simplifying;  ///< maximal B, C, D
    int order = 0;                    ///< proved, as a lower bound where the claim "order" says "at least"
    stability_function<tableaux::rational> R;
    std::optional<tableaux::rational> r_infinity;  ///< empty where R has a pole at infinity
    tableaux::rational error_constant;             ///< |R(z) - e^z| = error_constant |z|^{order+1} + ...
    std::optional<theory::principal_error> principal_error;  ///< where the trees of its order are few enough
    theory::spectra spectra;                                 ///< eigenvalues of A, poles of R
    tableaux::inertia weights;                               ///< signs of the weights b
    tableaux::inertia M;                                     ///< inertia of the algebraic stability matrix

    verdict order_verdict = verdict::unexamined();
    verdict a_stable = verdict::unexamined();
    verdict l_stable = verdict::unexamined();
    verdict algebraically_stable = verdict::unexamined();
    verdict b_stable = verdict::unexamined();
    verdict symplectic = verdict::unexamined();
    verdict symmetric = verdict::unexamined();
    verdict stiffly_accurate = verdict::unexamined();
    std::vector<claim> others;  ///< nodes, B, C, D, R, error constant, inertias

    /// The proved properties as the plain data that a tableau carries.
    stagecraft::facts facts() const {
        stagecraft::facts f;
        f.order = order;
        f.stage_order = simplifying.stage_order();
        f.a_stable = a_stable.is_proved();
        f.algebraically_stable = algebraically_stable.is_proved();
        f.symplectic = symplectic.is_proved();
        f.symmetric = symmetric.is_proved();
        f.r_infinity = r_infinity ? r_infinity->to<double>() : std::numeric_limits<double>::quiet_NaN();
        return f;
    }

    /// All claims in the order in which they are printed.
    std::vector<claim> claims() const {
        std::vector<claim> all{{"order " + std::to_string(order), order_verdict}};
        all.insert(all.end(), others.begin(), others.end());
        const auto add = [&](std::string statement, const theory::verdict& v) {
            all.push_back({std::move(statement), v});
        };
        add("A-stable", a_stable);
        add("L-stable", l_stable);
        add("algebraically stable", algebraically_stable);
        add("B-stable", b_stable);
        add("symplectic", symplectic);
        add("symmetric", symmetric);
        add("stiffly accurate", stiffly_accurate);
        return all;
    }

    /// One line for each claim: statement, verdict, argument or witness.
    std::string text() const {
        std::string out = method + ", " + std::to_string(stages) + (stages == 1 ? " stage\n" : " stages\n");
        const auto all = claims();
        std::size_t width = 0;
        for (const claim& c : all)
            if (c.statement.size() <= 40) width = std::max(width, c.statement.size());
        for (const claim& c : all) {
            out += "  " + c.statement;
            if (c.statement.size() <= width) out += std::string(width - c.statement.size(), ' ');
            out += "  " + c.verdict.text() + "\n";
        }
        if (!spectra.note.empty()) out += "  " + spectra.note + "\n";
        return out;
    }
};

}  // namespace stagecraft::theory
