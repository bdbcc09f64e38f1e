// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/judge_numbers.hpp"

#include <cmath>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/claims.hpp"
#include "stagecraft/tableaux/entry.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE verdict judge_number(const std::string& claimed, const claim& known) {
    using tableaux::bound;
    if (!known.number) return known.verdict;  // open
    const auto [low, high] = *known.number;
    // What the statement says is true or not of every table, whatever the verdict on it is called.
    const verdict holds =
        known.verdict.is_refuted() ? verdict::proved(known.verdict.reason()) : known.verdict;
    const auto is = [&] { return known.statement + ": " + known.verdict.reason(); };
    if (std::isinf(low) || claimed == tableaux::infinite) {
        if (std::isinf(low) && claimed == tableaux::infinite) return holds;
        return std::isinf(high) && !std::isinf(low) ? verdict::undecided(is()) : verdict::refuted(is());
    }
    const auto e = tableaux::read_entry(claimed);
    const auto unit = e.rounded ? e.uncertainty() : tableaux::rational(0);  // cut off: one more half
    const bound least = tableaux::downward((e.enclosure.lower - unit).to<bound>()),
                most = tableaux::upward((e.enclosure.upper + unit).to<bound>());
    if (high < least || low > most) return verdict::refuted(is());
    if (least <= low && high <= most) return holds;
    if (e.rounded) return verdict::undecided("the number is not known to these digits: " + is());
    return verdict::consistent(brief(std::abs((low + high) / 2 - e.enclosure.middle().to<bound>())),
                               brief(high - low), is());
}

STAGECRAFT_INLINE finding number_finding(std::string_view name, const std::string& claimed,
                                         const claim& known) {
    finding f;
    f.name = name;
    f.claimed = claimed == tableaux::infinite ? "\"infinite\"" : nlohmann::ordered_json(claimed).dump();
    f.judgement = judge_number(claimed, known);
    return f;
}

}  // namespace stagecraft::theory
