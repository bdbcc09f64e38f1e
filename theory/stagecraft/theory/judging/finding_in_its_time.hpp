// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <stagecraft/theory/judging/file_certificate.hpp>
#include <stagecraft/theory/judging/in_its_time.hpp>
#include <string>
#include <utility>

namespace stagecraft::theory::detail {

/// Undecided, and so is the claim where there is one.
inline finding not_found_in_time(const std::string& name, std::optional<int> claimed) {
    finding late;
    late.name = name;
    (claimed ? late.judgement : late.truth) = verdict::undecided(out_of_its_time);
    if (claimed) late.claimed = std::to_string(*claimed);
    return late;
}

/// The finding of this name that `decide` returns within a part of the time that is left; undecided else.
template <class Decide>
finding found_in_its_time(const std::string& name, std::optional<int> claimed, double part, Decide decide) {
    return within_its_time(part, std::move(decide), not_found_in_time(name, claimed));
}

}  // namespace stagecraft::theory::detail
