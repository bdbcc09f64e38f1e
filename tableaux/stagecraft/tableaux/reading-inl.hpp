// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/reading.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/stage_form.hpp"

namespace stagecraft::tableaux {

STAGECRAFT_INLINE decimals_are decimals_from_name(std::string_view name) {
    if (name == "auto") return decimals_are::automatic;
    if (name == "exact") return decimals_are::exact;
    if (name == "rounded") return decimals_are::rounded;
    throw std::invalid_argument("decimals: '" + std::string(name) + "', allowed: auto, exact, rounded");
}

namespace detail {

STAGECRAFT_INLINE bool terminates(const rational& x) {
    integer d = x.denominator();
    for (const int prime : {2, 5})
        while (d % prime == 0) d /= prime;
    return d == 1;
}

STAGECRAFT_INLINE exact_decimals short_decimals(const tableau_file& file) {
    std::vector<int> digits, places;
    bool fractions = false;
    file.for_each_entry([&](const entry& e) {
        if (e.digits > 2) {
            digits.push_back(e.digits);
            places.push_back(e.places);
        }
        fractions =
            fractions || (e.exact && (!e.exact->is_rational() || !terminates(e.exact->rational_part())));
    });
    if (digits.empty()) return exact_decimals::all();
    const auto quartile = [](std::vector<int>& v) {
        const auto at = v.begin() + static_cast<std::ptrdiff_t>(3 * v.size() / 4);
        std::nth_element(v.begin(), at, v.end());
        return *at;
    };
    const int usual = quartile(digits);
    if (fractions && *std::max_element(digits.begin(), digits.end()) <= 6) return exact_decimals::all();
    return {std::min(usual / 2, 10), 3 * quartile(places) / 4};
}

}  // namespace detail

STAGECRAFT_INLINE void apply(const reading& how, tableau_file& file) {
    const exact_decimals exact = how.decimals == decimals_are::automatic ? detail::short_decimals(file)
                                 : how.decimals == decimals_are::exact   ? exact_decimals::all()
                                                                         : exact_decimals{};
    const rational further = how.ulps - rational(1, 2);
    file.for_each_entry([&](entry& e) {
        if (e.rounded && exact.covers_some(e)) {
            entry again = read_entry(e.text, exact);
            // In "2.4906272*1.2" the short factor alone is exact; the text of a double is no narrower than that.
            const bool narrower = again.enclosure.width() * rational(1000) < e.enclosure.width();
            if (!again.rounded || narrower) {
                e = std::move(again);
                ++file.short_decimals;
            }
        }
        if (e.rounded && further != 0)
            e.enclosure = detail::widened(e.enclosure, further * e.enclosure.width());
        const bool whole = e.exact && e.exact->is_rational() && e.exact->rational_part().denominator() == 1;
        if (how.tolerance != 0 && !whole) {
            e.enclosure = detail::widened(e.enclosure, how.tolerance);
            e.exact.reset();
            e.rounded = true;
        }
    });
}

namespace detail {

/// The file with its entries changed; where it gives a form, the form's entries, what is computed from them, and what stands beside it.
template <class Change>
tableau_file with_entries_changed(tableau_file file, Change change) {
    if (!file.form) {
        file.for_each_entry(change);
        return file;
    }
    auto rows = file.form->rows;
    for (auto& row : rows)
        for (auto& e : row) change(e);
    try {
        tableau_file changed = expanded({file.form->which, std::move(rows)});
        file.A = std::move(changed.A);
        file.b = std::move(changed.b);
        file.form = std::move(changed.form);
        for (auto* beside : {&file.b_embedded, &file.c})
            for (auto& e : *beside) change(e);
    } catch (const std::invalid_argument&) {  // rows of alpha sum to 1 as given only
    }
    return file;
}

/// Fractions up to this denominator, 5/12 say, stand beside rounded ones as beside exact ones.
inline constexpr int largest_short_denominator = 20;

inline bool is_long_quotient(const entry& e) {
    return e.exact && e.exact->is_rational() &&
           e.exact->rational_part().denominator() > largest_exact_denominator &&
           abs(e.exact->rational_part()) * rational(e.exact->rational_part().denominator()) >
               rational(largest_exact_numerator);
}

inline bool is_printed_double(const entry& e) {
    return e.rounded && e.digits >= fewest_digits_of_double && e.digits <= most_digits_of_double;
}

}  // namespace detail

STAGECRAFT_INLINE tableau_file cut_off(tableau_file file) {
    return detail::with_entries_changed(std::move(file), [](entry& e) {
        if (!e.rounded || !(read_entry(e.text).enclosure == e.enclosure)) return;
        const rational half = e.uncertainty();
        const rational by = e.enclosure.middle() < 0 ? -half : half;
        e.enclosure = {e.enclosure.lower + by, e.enclosure.upper + by};
    });
}

STAGECRAFT_INLINE bool has_rounded_fractions(const tableau_file& file) {
    int fractions = 0, enormous = 0;
    for_each_given(file, [&](const entry& e) {
        if (!e.exact || !e.exact->is_rational()) return;
        fractions += e.exact->rational_part().denominator() > detail::largest_short_denominator ? 1 : 0;
        enormous += detail::is_long_quotient(e) ? 1 : 0;
    });
    return 2 * enormous > fractions;
}

STAGECRAFT_INLINE bool has_computed_doubles(const tableau_file& file) {
    int decimals = 0, doubles = 0;
    for_each_given(file, [&](const entry& e) {
        decimals += e.rounded && e.digits > 2 ? 1 : 0;
        doubles += detail::is_printed_double(e) ? 1 : 0;
    });
    return 2 * doubles > decimals;
}

STAGECRAFT_INLINE tableau_file rounded_quotients(tableau_file file) {
    return detail::with_entries_changed(std::move(file), [](entry& e) {
        if (!detail::is_long_quotient(e)) return;
        const rational q(e.exact->rational_part().denominator());
        e.enclosure = detail::widened(e.enclosure, rational(1) / (q * q));
        e.exact.reset();
        e.rounded = true;
    });
}

STAGECRAFT_INLINE tableau_file computed(tableau_file file, int units) {
    return detail::with_entries_changed(std::move(file), [units](entry& e) {
        if (!detail::is_printed_double(e)) return;
        const rational middle = e.enclosure.middle(), written = e.enclosure.width();
        const rational unit = middle == 0 ? written : scaled(rational(1), binary_exponent(middle) - 52);
        e.enclosure = detail::widened({middle, middle}, std::max(written, unit * rational(units)));
    });
}

STAGECRAFT_INLINE rational largest_uncertainty(const tableau_file& file) {
    rational most(0);
    for_each_given(file, [&](const entry& e) { most = std::max(most, e.uncertainty()); });
    return most;
}

}  // namespace stagecraft::tableaux
