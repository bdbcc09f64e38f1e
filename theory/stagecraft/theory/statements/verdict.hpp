// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace stagecraft::theory {

/// What is known of a statement. Only exact arithmetic proves or refutes an equality; an enclosure refutes
/// equalities and decides inequalities; whatever is left is consistent, never "true up to a tolerance", and
/// inconclusive where the data are so coarse that nothing could have been refuted. A statement that nobody has
/// looked at is unexamined: it claims nothing.
enum class standing { proved, refuted, consistent, inconclusive, unexamined };

constexpr std::string_view name(standing s) {
    switch (s) {
        case standing::proved:
            return "proved";
        case standing::refuted:
            return "refuted";
        case standing::consistent:
            return "consistent";
        case standing::inconclusive:
            return "inconclusive";
        case standing::unexamined:
            break;
    }
    return "not examined";
}

/// The outcome for one statement: proved | refuted with a witness | consistent with residual, bound, reason |
/// inconclusive, the bound being as large as what it should bound; unexamined before.
class verdict {
  public:
    /// Unexamined.
    verdict() = default;

    /// Decided true. `argument` names the theorem or computation that decides it.
    static verdict proved(std::string argument = {});

    /// Decided false. `witness` is what anyone can check: a tree and its residual, a y with |R(iy)| > 1, a
    /// pole, a negative pivot.
    static verdict refuted(std::string witness) { return {theory::standing::refuted, std::move(witness)}; }

    /// Undecided: the computed `residual` does not exceed `bound`, the most that `reason` (rounded data,
    /// say) can cause.
    static verdict consistent(std::string residual, std::string bound, std::string reason);

    /// Undecided and untested: `bound` reaches the size of the quantities compared, so no residual could have
    /// refuted the statement.
    static verdict inconclusive(std::string residual, std::string bound, std::string reason);

    /// Inconclusive without a residual or a bound: why no method at hand decides it.
    static verdict undecided(std::string why);

    /// Not looked at.
    static verdict unexamined() { return {}; }

    theory::standing standing() const { return standing_; }
    bool is_proved() const { return standing_ == theory::standing::proved; }
    bool is_refuted() const { return standing_ == theory::standing::refuted; }
    bool is_consistent() const { return standing_ == theory::standing::consistent; }
    bool is_inconclusive() const { return standing_ == theory::standing::inconclusive; }

    /// The argument of a proof, the witness of a refutation, the reason of an open case.
    const std::string& reason() const { return reason_; }
    const std::string& residual() const { return residual_; }  ///< of an open case
    const std::string& bound() const { return bound_; }        ///< of an open case

    /// "proved: ...", "refuted: ...", "consistent: residual r, bound b: ...", "inconclusive: ...",
    /// "inconclusive: not decided: ...".
    std::string text() const;

    friend bool operator==(const verdict&, const verdict&) = default;

  private:
    verdict(theory::standing s, std::string reason) : standing_(s), reason_(std::move(reason)) {}

    theory::standing standing_ = theory::standing::unexamined;
    std::string reason_;
    std::string residual_;
    std::string bound_;
};

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/statements/verdict-inl.hpp"
#endif
