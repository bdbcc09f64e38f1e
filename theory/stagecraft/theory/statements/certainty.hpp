// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/ball.hpp>
#include <stagecraft/tableaux/quadratic.hpp>
#include <stagecraft/tableaux/range.hpp>
#include <stagecraft/tableaux/rational.hpp>
#include <stagecraft/tableaux/residue.hpp>
#include <stagecraft/theory/models/stage_algebra.hpp>
#include <stagecraft/theory/statements/verdict.hpp>
#include <string>

namespace stagecraft::theory {

/// What can be said for sure of a scalar: exact fields decide, enclosures (tableaux::ball brings its own
/// overloads) where they keep away from zero, residues refute equality only.
inline bool certainly_nonzero(const tableaux::rational& x) { return x != 0; }
inline bool certainly_nonzero(const tableaux::quadratic& x) { return x != 0; }
inline bool certainly_nonzero(const tableaux::residue& x) { return !(x == tableaux::residue(0)); }
inline bool certainly_negative(const tableaux::rational& x) { return x < 0; }
inline bool certainly_negative(const tableaux::quadratic& x) { return sign(x) < 0; }

/// Bits of the enclosures used for data that no exact field holds: 115 decimal digits.
inline constexpr int checker_bits = 384;

/// A ball around the interval: its middle to checker_bits bits, its radius rounded up.
tableaux::ball to_ball(const tableaux::range& r);

/// The interval of a ball.
inline tableaux::range to_range(const tableaux::ball& x) { return {x.lower(), x.upper()}; }

/// A few digits for a message.
std::string brief(tableaux::bound x);

/// The number as a certificate prints it: exact, or "middle +- radius".
inline std::string shown(const tableaux::rational& x) { return x.str(); }
inline std::string shown(const tableaux::quadratic& x) { return x.str(); }
std::string shown(const tableaux::ball& x);

/// The same for a sentence: numbers too long to read are given to three digits.
template <class K>
std::string in_words(const K& x) {
    std::string exact = shown(x);
    if constexpr (exact_scalar<K>)
        if (exact.size() > 40) return "about " + brief(x.template to<tableaux::bound>());
    return exact;
}

/// A bound can refute something only where it is small against the quantities compared, whose size is
/// `scale`: beyond a tenth of it a verdict is inconclusive.
inline bool says_nothing(tableaux::bound bound, tableaux::bound scale) { return !(bound <= scale / 10); }

/// What is open: consistent for `reason`, or inconclusive where the bound could not have refuted.
verdict open_case(tableaux::bound residual, tableaux::bound bound, tableaux::bound scale,
                  const std::string& reason);

/// Verdict on "defect = 0", the difference of quantities of size `scale`. Over an exact field it is decided;
/// an enclosure refutes it or leaves it open for `reason`, unless it is the point 0. `name` says what the defect is.
template <class K>
verdict vanishes(const K& defect, tableaux::bound scale, const std::string& name, const std::string& reason) {
    if (certainly_nonzero(defect)) return verdict::refuted(name + " leaves " + in_words(defect));
    if constexpr (exact_scalar<K>)
        return verdict::proved(name);
    else
        return defect.exactly_zero() ? verdict::proved(name)
                                     : open_case(defect.magnitude(), defect.radius(), scale, reason);
}

/// The conjunction: refuted where one part is, proved where all are, otherwise the weakest open one.
verdict both(const verdict& x, const verdict& y);

/// The opposite statement's verdict.
verdict negation(const verdict& x);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/statements/certainty-inl.hpp"
#endif
