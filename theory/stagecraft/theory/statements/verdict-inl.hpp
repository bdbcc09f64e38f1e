// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/statements/verdict.hpp"

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE verdict verdict::proved(std::string argument) {
    return {theory::standing::proved, std::move(argument)};
}

STAGECRAFT_INLINE verdict verdict::consistent(std::string residual, std::string bound, std::string reason) {
    verdict v{theory::standing::consistent, std::move(reason)};
    v.residual_ = std::move(residual);
    v.bound_ = std::move(bound);
    return v;
}

STAGECRAFT_INLINE verdict verdict::inconclusive(std::string residual, std::string bound, std::string reason) {
    verdict v = consistent(std::move(residual), std::move(bound), std::move(reason));
    v.standing_ = theory::standing::inconclusive;
    return v;
}

STAGECRAFT_INLINE verdict verdict::undecided(std::string why) {
    return inconclusive({}, {}, "not decided: " + std::move(why));
}

STAGECRAFT_INLINE std::string verdict::text() const {
    std::string out(name(standing_));
    if ((is_consistent() || is_inconclusive()) && !residual_.empty())
        out += ": residual " + residual_ + ", bound " + bound_;
    if (!reason_.empty()) out += ": " + reason_;
    return out;
}

}  // namespace stagecraft::theory
