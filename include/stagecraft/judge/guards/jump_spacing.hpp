// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

namespace stagecraft {

/// Bounds the steps after a jump of f. Estimates see f at the nodes of a step only, and one that spans whole
/// periods of a right-hand side that is switched back and forth may find the same value at all of them. So
/// once a jump has been found, a step is at most half as long as the last two jumps are apart (the start
/// counts as one), or half of the way from the last jump: where jumps stay away the bound goes with them.
template <class Scalar>
class jump_spacing {
  public:
    explicit jump_spacing(const Scalar& t0) : from_(t0) {}

    /// An attempt at a step of size h from t has shown a jump, which lies between t and t + h.
    void found(const Scalar& t, const Scalar& h) {
        using std::abs;
        const Scalar gone = abs(t - from_), size = abs(h);
        if (gone < length_) {  // the same jump: fewer places are left for it
            spacing_ += gone;
            length_ = size < length_ - gone ? size : Scalar(length_ - gone);
        } else {
            spacing_ = gone - length_;
            length_ = size;
        }
        from_ = t;
        known_ = true;
    }
    bool known() const { return known_; }
    /// How far t is from the last jump, or from the start.
    Scalar since(const Scalar& t) const {
        using std::abs;
        return abs(t - from_);
    }
    /// The largest step allowed from t; 0 means any.
    Scalar largest(const Scalar& t) const {
        using std::abs;
        if (!known_) return Scalar(0);
        const Scalar since = abs(t - from_);
        return (since > spacing_ ? since : spacing_) / 2;
    }

    /// What the next step depends on (checkpoint.hpp).
    template <class Bag>
    void carry(Bag& bag) {
        bag(from_, length_, spacing_, known_);
    }

  private:
    Scalar from_, length_{0};  // where the last jump was found, and how far behind it may lie
    Scalar spacing_{0};        // from the jump before to where the last one was found
    bool known_ = false;
};

}  // namespace stagecraft
