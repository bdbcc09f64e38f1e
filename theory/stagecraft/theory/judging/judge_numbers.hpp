// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <stagecraft/theory/judging/certificate.hpp>
#include <stagecraft/theory/judging/enclosed_ssp.hpp>
#include <stagecraft/theory/judging/enclosed_stability.hpp>
#include <stagecraft/theory/judging/exact_cost.hpp>
#include <stagecraft/theory/judging/file_certificate.hpp>
#include <stagecraft/theory/judging/in_its_time.hpp>
#include <stagecraft/theory/judging/stability_report.hpp>
#include <stagecraft/theory/judging/subject.hpp>
#include <string>
#include <string_view>

/// Numbers of a file: the metrics of its pair, and what it can claim, the SSP coefficient, the angle of A(alpha)-stability, the intervals of stability on both axes.

namespace stagecraft::theory {

/// What is known of the number of that name (tableaux::number_claims): exact tableaux have it enclosed to 2^-60, unless their
/// fractions are enormous, others as stability_report of enclosures has it.
template <class K>
claim number_of(const subject<K>& s, std::string_view name) {
    if constexpr (exact_scalar<K>) {
        if (determinant_bits(s) > longest_exact_determinant) return number_of(enclosed(s), name);
        if (name == "ssp_coefficient") return detail::interval_claim("SSP radius", ssp_radius(s.t));
        const auto r = stability_function_of(s.t);
        if (name == "alpha") return detail::sector_claim(r);
        return name == "real_interval"
                   ? detail::interval_claim("real stability interval", real_stability_interval(r))
                   : detail::interval_claim("imaginary stability interval", imaginary_stability_interval(r));
    } else {
        if (name == "ssp_coefficient") return enclosed_ssp_radius(s);
        const auto f = stability_function_of(s);
        if (name == "alpha") return enclosed_sector(s, f);
        return name == "real_interval" ? enclosed_real_interval(f) : enclosed_imaginary_interval(f);
    }
}

/// The verdict on the claim that a number is `claimed`, to the digits that are written (rounded or cut off), or "infinite".
verdict judge_number(const std::string& claimed, const claim& known);

/// The finding on a claimed number.
finding number_finding(std::string_view name, const std::string& claimed, const claim& known);

namespace detail {

/// Of the orders found; nothing where that takes too long.
template <class K>
std::optional<error_metrics> metrics_in_their_time(const subject<K>& s, const file_certificate& c) {
    const auto *order = c.find("order"), *embedded = c.find("embedded_order");
    if (!embedded || !order->value || !embedded->value) return std::nullopt;
    return within_its_time(
        0.2,
        [&] {
            if constexpr (exact_scalar<K>)
                return error_metrics_of(enclosed(s), *order->value, *embedded->value);
            else
                return error_metrics_of(s, *order->value, *embedded->value);
        },
        std::nullopt);
}

}  // namespace detail

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/judge_numbers-inl.hpp"
#endif
