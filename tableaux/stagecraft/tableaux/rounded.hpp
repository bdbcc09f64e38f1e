// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <stagecraft/tableau.hpp>
#include <stagecraft/tableaux/collocation.hpp>
#include <stagecraft/tableaux/correct_rounding.hpp>
#include <stagecraft/tableaux/exact_tableau.hpp>
#include <stagecraft/tableaux/transformed.hpp>
#include <string>

namespace stagecraft::tableaux {

/// Runs `attempt(bits)` with more and more bits while it throws undecided; after six doublings gives up with
/// the last such error.
template <class Attempt>
auto widening(int bits, Attempt attempt) {
    for (int repeat = 0;; ++repeat, bits *= 2) {
        try {
            return attempt(bits);
        } catch (const undecided& reason) {
            if (repeat == 6)
                throw undecided(std::string(reason.what()) + " (with " + std::to_string(bits) + " bits)");
        }
    }
}

/// Bits to start with, so that `target` correct bits of every entry remain: a family loses some five bits
/// whenever s doubles, other nodes about 1.3 a stage.
int working_bits(int target, const nodal_polynomial& w);

namespace rounding {

/// Where the exact entry is rational it takes the place of its enclosure: a zero of a user's rational nodes
/// and a number half-way between two doubles are then decided.
template <class Exact, class Enclosed>
void sharpen(const Exact& exact, Enclosed& entries, int bits) {
    for (Eigen::Index i = 0; i < exact.rows(); ++i)
        for (Eigen::Index j = 0; j < exact.cols(); ++j)
            if (exact(i, j).is_rational()) entries(i, j) = ball(exact(i, j).rational_part(), bits);
}
void sharpen_basic(const std::optional<tableau<quadratic>>& exact, tableau<ball>& t, int bits);

/// Every entry rounded; throws undecided, naming the entry, where one cannot be.
template <class Real, class From, class To>
void matrix(const From& from, To& to, const char* name) {
    to.resize(from.rows(), from.cols());
    for (Eigen::Index i = 0; i < from.rows(); ++i)
        for (Eigen::Index j = 0; j < from.cols(); ++j) {
            const auto value = nearest<Real>(from(i, j));
            if (!value)
                throw undecided("round: entry (" + std::to_string(i + 1) + "," + std::to_string(j + 1) +
                                ") of " + name + " is undecided");
            to(i, j) = *value;
        }
}

template <class Real>
void basic(const tableau<ball>& from, tableau<Real>& to) {
    matrix<Real>(from.A, to.A, "A");
    matrix<Real>(from.b, to.b, "b");
    matrix<Real>(from.c, to.c, "c");
}

}  // namespace rounding

/// c, b and A of a method given by its nodes and construction, rounded once from proved enclosures: for
/// double and long double every entry is the nearest one, for a multiprecision float it is good to a few
/// units of the last place. `known` is copied into the result. Throws undecided where a rounding stays
/// undecided (an entry half-way between two numbers, or an irrational way to write 0).
template <class Real = double>
tableau<Real> rounded(const nodal_polynomial& w, construction rule, const stagecraft::facts& known = {}) {
    const auto exact = exact_tableau(w, rule);
    return widening(working_bits(significand_bits<Real>, w), [&](int bits) {
        tableau<ball> from = enclose(w, rule, bits);
        rounding::sharpen_basic(exact, from, bits);
        tableau<Real> t;
        rounding::basic(from, t);
        t.facts = known;
        return t;
    });
}

/// The same for the s-stage member of a family. Throws std::invalid_argument if it has none.
template <class Real = double>
tableau<Real> rounded(family f, int s, const stagecraft::facts& known = {}) {
    return rounded<Real>(nodal_polynomial(f, s), construction_of(f), known);
}

/// The tableau together with A^-1, its eigenvalues and the transformation T, all rounded as above. A must be
/// regular: Gauss, Radau IA and IIA, Lobatto IIIC, and collocation on a user's nodes without 0; otherwise
/// std::invalid_argument.
template <class Real = double>
transformed_tableau<Real> transformed(const nodal_polynomial& w, construction rule,
                                      const stagecraft::facts& known = {}) {
    inverse_form_of(w, rule);
    const auto exact = exact_tableau(w, rule);
    std::optional<tableau<quadratic>::matrix> inverse;
    if (exact) inverse = exact_inverse(exact->A);
    return widening(significand_bits<Real> + 32 + 3 * w.degree(), [&](int bits) {
        transformed_tableau<ball> from = enclose_transformed(w, rule, bits);
        rounding::sharpen_basic(exact, from, bits);
        if (inverse) rounding::sharpen(*inverse, from.A_inverse, bits);
        transformed_tableau<Real> t;
        rounding::basic<Real>(from, t);
        rounding::matrix<Real>(from.A_inverse, t.A_inverse, "A^-1");
        rounding::matrix<Real>(from.T, t.T, "T");
        rounding::matrix<Real>(from.T_inverse, t.T_inverse, "T^-1");
        rounding::matrix<Real>(from.gamma, t.gamma, "gamma");
        rounding::matrix<Real>(from.alpha, t.alpha, "alpha");
        rounding::matrix<Real>(from.beta, t.beta, "beta");
        t.facts = known;
        return t;
    });
}

template <class Real = double>
transformed_tableau<Real> transformed(family f, int s, const stagecraft::facts& known = {}) {
    return transformed<Real>(nodal_polynomial(f, s), construction_of(f), known);
}

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/rounded-inl.hpp"
#endif
