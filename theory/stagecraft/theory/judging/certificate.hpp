// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stagecraft/tableau.hpp"
#include "stagecraft/tableaux/precision.hpp"
#include "stagecraft/tableaux/rational.hpp"
#include "stagecraft/theory/judging/principal_error.hpp"
#include "stagecraft/theory/models/legendre_simplifying.hpp"
#include "stagecraft/theory/stability/spectrum.hpp"
#include "stagecraft/theory/stability/stability_function.hpp"
#include "stagecraft/theory/statements/verdict.hpp"

namespace stagecraft::theory {

/// Ends of an interval that holds a number; high may be infinity, and both are for a number that is infinite.
struct number_range {
    tableaux::bound low = 0, high = 0;
    friend bool operator==(const number_range&, const number_range&) = default;
};

/// A statement about a method and what is known of it; where it tells a number, that too.
struct claim {
    std::string statement;
    theory::verdict verdict;
    std::optional<number_range> number = std::nullopt;
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
    stagecraft::facts facts() const;

    /// All claims in the order in which they are printed.
    std::vector<claim> claims() const;

    /// One line for each claim: statement, verdict, argument or witness.
    std::string text() const;
};

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/certificate-inl.hpp"
#endif
