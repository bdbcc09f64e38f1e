// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/time_share.hpp>
#include <stagecraft/theory/judging/certificate.hpp>
#include <stagecraft/theory/statements/verdict.hpp>
#include <string>
#include <utility>

namespace stagecraft::theory::detail {

inline constexpr const char* out_of_its_time = "it took more than its share of the time (--seconds)";
inline constexpr const char* no_time_for_suspects =
    "no suspects: they were not found within the time (--seconds)";

/// What `decide` returns within a part of the time that is left (tableaux::time_share), else `late`.
template <class Decide>
auto within_its_time(double part, Decide decide, decltype(decide()) late) {
    try {
        const tableaux::time_share share(tableaux::time_share::left() * part);
        return decide();
    } catch (const tableaux::out_of_time&) {
        return late;
    }
}

/// The same for a verdict: undecided.
template <class Decide>
verdict in_its_time(double part, Decide decide) {
    return within_its_time(part, std::move(decide), verdict::undecided(out_of_its_time));
}

/// The same for a claim: its statement, undecided.
template <class Decide>
claim claimed_in_its_time(const std::string& statement, double part, Decide decide) {
    return within_its_time(part, std::move(decide), claim{statement, verdict::undecided(out_of_its_time)});
}

}  // namespace stagecraft::theory::detail
