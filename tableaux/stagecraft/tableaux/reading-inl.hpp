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

STAGECRAFT_INLINE tableau_file cut_off(tableau_file file) {
    if (file.form) {  // its own decimals are, not what was computed from them
        tableau_file given;
        given.A = file.form->rows;
        try {
            tableau_file cut = expanded({file.form->which, cut_off(std::move(given)).A});
            file.A = std::move(cut.A);
            file.b = std::move(cut.b);
            file.form = std::move(cut.form);
        } catch (const std::invalid_argument&) {  // rows of alpha sum to 1 as rounded only
        }
        return file;
    }
    file.for_each_entry([](entry& e) {
        if (!e.rounded || !(read_entry(e.text).enclosure == e.enclosure)) return;
        const rational half = e.uncertainty();
        const rational by = e.enclosure.middle() < 0 ? -half : half;
        e.enclosure = {e.enclosure.lower + by, e.enclosure.upper + by};
    });
    return file;
}

}  // namespace stagecraft::tableaux
