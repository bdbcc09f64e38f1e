// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/other_readings.hpp"

#include <algorithm>
#include <cstdlib>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/reading.hpp"
#include "stagecraft/theory/statements/certainty.hpp"

namespace stagecraft::theory {

namespace detail {

/// "quotients of 13 digits": those that the usual denominator has, of the long ones.
STAGECRAFT_INLINE std::string quotient_words(const tableaux::tableau_file& file) {
    std::vector<std::size_t> digits;
    tableaux::for_each_given(file, [&](const tableaux::entry& e) {
        if (!e.exact || !e.exact->is_rational()) return;
        const tableaux::integer q = e.exact->rational_part().denominator();
        if (q > tableaux::largest_exact_denominator) digits.push_back(q.str().size());
    });
    const auto middle = digits.begin() + static_cast<std::ptrdiff_t>(digits.size() / 2);
    std::nth_element(digits.begin(), middle, digits.end());
    return "quotients of " + std::to_string(*middle) + " digits";
}

inline constexpr const char* quotient_rule = ", each p/q within 1/q^2 of the number that is meant";

/// Units of its last digit, or in the last place of a double, that a computed entry is taken to be off.
inline constexpr int units_of_computed[] = {1, 2, 4};

STAGECRAFT_INLINE std::string computed_words(int units) {
    return "doubles computed to " + std::to_string(units) + (units == 1 ? " unit" : " units") +
           " in the last place";
}

}  // namespace detail

STAGECRAFT_INLINE std::vector<other_reading> other_readings(const tableaux::tableau_file& file) {
    std::vector<other_reading> all;
    const bool quotients = tableaux::has_rounded_fractions(file);
    const bool rounded = file.kind() == tableaux::number_kind::rounded;
    const auto base = quotients ? rounded_quotients(file) : file;
    if (rounded) all.push_back({cut_off(file), "decimals cut off, not rounded", ""});
    if (quotients) all.push_back({base, detail::quotient_words(file), detail::quotient_rule});
    if (!has_computed_doubles(file)) return all;
    for (const int units : detail::units_of_computed)
        all.push_back({computed(base, units), detail::computed_words(units), ""});
    return all;
}

STAGECRAFT_INLINE void describe(const std::string& what, const std::string& rule, const resolution& resolved,
                                const file_certificate& written, file_certificate& other) {
    std::string refuted;
    for (const finding& f : written.findings)
        if (f.judgement && f.judgement->is_refuted() && refuted.empty()) refuted = f.name;
    other.notes.insert(
        other.notes.begin(),
        {"taken as " + what + rule + (refuted.empty() ? "" : ": refuted otherwise (" + refuted + ")"),
         in_words(resolved)});
    tableaux::bound most = 0;
    std::string residual = "0";
    for (const finding& f : other.findings) {
        const verdict* v = f.judgement ? &*f.judgement : f.truth ? &*f.truth : nullptr;
        if (!v || v->residual().empty() || f.name.find("order") == std::string::npos) continue;
        const auto size = std::strtold(v->residual().c_str(), nullptr);
        if (size > most) residual = v->residual();
        most = std::max(most, size);
    }
    if (written.nearest) other.nearest = written.nearest;  // in units of the digits given
    other.taken_as = {what, residual, resolved.entry.empty() ? "none" : resolved.size};
}

STAGECRAFT_INLINE std::vector<other_coupled_reading> other_readings(const tableaux::partitioned_file& file) {
    std::vector<other_coupled_reading> all;
    const auto add = [&](const std::string& what, const char* rule, auto change) {
        all.push_back({file, what, rule});
        for (auto& partner : all.back().file.partners) partner = change(partner);
    };
    const auto quotients = std::find_if(file.partners.begin(), file.partners.end(),
                                        [](const auto& p) { return tableaux::has_rounded_fractions(p); });
    if (quotients != file.partners.end())
        add(detail::quotient_words(*quotients), detail::quotient_rule, tableaux::rounded_quotients);
    if (std::none_of(file.partners.begin(), file.partners.end(), tableaux::has_computed_doubles)) return all;
    for (const int units : detail::units_of_computed)
        add(detail::computed_words(units), "",
            [units](const tableaux::tableau_file& p) { return computed(p, units); });
    return all;
}

}  // namespace stagecraft::theory
