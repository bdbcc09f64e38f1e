// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/tableau_file.hpp>
#include <stdexcept>
#include <string_view>

namespace stagecraft::tableaux {

/// Thrown for a file that cannot be used. what() is one line that names the line and the entry.
struct unusable_input : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// What a decimal in a tableau file is: the number as written, a rounded one, or what the other entries make
/// likely.
enum class decimals_are { automatic, exact, rounded };

/// The policy of that name: "auto", "exact", "rounded". Throws std::invalid_argument for another.
decimals_are decimals_from_name(std::string_view name);

/// How the numbers of a file are understood.
struct reading {
    decimals_are decimals = decimals_are::automatic;
    /// A rounded entry is uncertain by so many units of its last digit (of a double: in the last place).
    rational ulps = rational(1, 2);
    /// Every entry but whole numbers is uncertain by this much besides; for tables computed in floating point.
    rational tolerance = 0;
};

namespace detail {

/// Whether a fraction would be a finite decimal.
bool terminates(const rational& x);

/// Which decimals are read as exact where the policy is automatic. `usual` is the upper quartile of the
/// numbers of digits, decimals of one or two digits left out: a number that was rounded to 40 digits is not
/// 0.5, but by chance 1 in 10^20, so what has at most half as many digits, and at most ten, is meant as it
/// stands. So is everything where no decimal has more than two digits, and where none has more than six and
/// what is no finite decimal is written as a fraction or a surd.
exact_decimals short_decimals(const tableau_file& file);

inline range widened(const range& r, const rational& by) { return {r.lower - by, r.upper + by}; }

}  // namespace detail

/// Makes the entries what `how` says they are; counts the decimals read as exact.
void apply(const reading& how, tableau_file& file);

/// The same file with its rounded decimals understood as cut off: a value lies between the number as written and one
/// unit of the last digit away from zero. Doubles, and what a reading has widened, stay as they are,
/// and so does a form whose rows do not sum to 1 then.
tableau_file cut_off(tableau_file file);

/// Beyond this a denominator, and beyond the second its numerator, are no exact numbers where most of a file's are.
inline constexpr int largest_exact_denominator = 1000000, largest_exact_numerator = 1000;

/// Whether the file's fractions are rounded numbers in disguise: more than half of them, short ones as 5/12 left out, have denominators
/// beyond largest_exact_denominator.
bool has_rounded_fractions(const tableau_file& file);

/// The same file with its long quotients p/q understood as rounded: within 1/q^2 of the number that is meant, as the
/// convergents of its continued fraction are. Less than a change of 1 in p or q would make.
tableau_file rounded_quotients(tableau_file file);

/// Whether most of the file's decimals have the digits of a printed double: fewest_digits_of_double to 18.
bool has_computed_doubles(const tableau_file& file);
inline constexpr int fewest_digits_of_double = 14, most_digits_of_double = 18;

/// The same file with those decimals understood as computed: off by so many units in the last place of a double, and by a
/// unit of their last digit where that is more.
tableau_file computed(tableau_file file, int units);

/// Calls `visit` with each entry that the file gives: of its form, where it has one.
template <class Visit>
void for_each_given(const tableau_file& file, Visit visit) {
    if (!file.form) return file.for_each_entry(visit);
    for (const auto& row : file.form->rows)
        for (const entry& e : row) visit(e);
}

/// The largest uncertainty of an entry: of the entries that a form gives where it does.
rational largest_uncertainty(const tableau_file& file);

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/reading-inl.hpp"
#endif
