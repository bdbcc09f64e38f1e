// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <vector>

namespace stagecraft::detail {

/// A periodic orbit that passes near an equilibrium, in numbers.
template <class Scalar>
struct slow_passage {
    Scalar period{0}, p{0};
    Scalar distance{1};  ///< from the equilibrium, relative to the size of the orbit; 1 where none is near
    /// The rates at which solutions near the equilibrium come in and go out: the real parts nearest to 0 of the eigenvalues
    /// on both sides, without sign; 0 where it is no saddle.
    Scalar in{0}, out{0};
};

/// Does the period grow without bound along a path of orbits? Near an orbit homoclinic to a saddle the period grows by 1/in +
/// 1/out for every factor e by which the orbit comes closer to the saddle (Kuznetsov 2004, section 6.2), p approaching the
/// homoclinic one like the square of that distance or faster. So the orbit is taken for homoclinic where p no longer
/// changes by the tolerance while the distance halves, its square does not count, and it has halved twice by that law. Slow
/// orbits of other kinds (relaxation oscillations, canards) do not: they are near no saddle, or do not come closer.
template <class Scalar>
class growing_period {
  public:
    /// The law is kept up to this factor: an orbit may pass two saddles, or one twice.
    static constexpr double kept = 3;

    void add(const slow_passage<Scalar>& now) { all_.push_back(now); }
    /// With p known to `tolerance`, relative to 1 + |p|.
    bool unbounded(const Scalar& tolerance) const {
        using std::abs;
        if (all_.empty()) return false;
        const auto& now = all_.back();
        const auto *half = twice_as_far(now), *quarter = half ? twice_as_far(*half) : nullptr;
        return quarter && abs(now.p - half->p) <= tolerance * (1 + abs(now.p)) &&
               now.distance * now.distance <= tolerance && keeps(*quarter, *half) && keeps(*half, now);
    }

  private:
    /// The last point before this one at which the distance was at least twice as large, if it has decreased since.
    const slow_passage<Scalar>* twice_as_far(const slow_passage<Scalar>& from) const {
        for (const auto* at = &from; at != all_.data();) {
            const auto* later = at--;
            if (!(at->distance > later->distance)) return nullptr;
            if (at->distance >= 2 * from.distance) return at;
        }
        return nullptr;
    }
    static bool keeps(const slow_passage<Scalar>& a, const slow_passage<Scalar>& b) {
        using std::log;
        if (!(b.in > Scalar(0)) || !(b.out > Scalar(0)) || !(b.period > a.period)) return false;
        const Scalar law = (1 / b.in + 1 / b.out) * log(a.distance / b.distance) / (b.period - a.period);
        return law < Scalar(kept) && law * Scalar(kept) > Scalar(1);
    }

    std::vector<slow_passage<Scalar>> all_;
};

}  // namespace stagecraft::detail
