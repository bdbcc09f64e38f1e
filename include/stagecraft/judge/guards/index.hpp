// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <stagecraft/judge/evidence.hpp>

namespace stagecraft {

/// Problems with components z of index 2 and u of index 3. A stiffly accurate method compares its stages with z_n, and so
/// the estimate shows what two steps have made: by u'(0) - z_n it is the error (-1)^s K h^s of the derivative of the
/// collocation polynomial at the left end, less that of z_n, s K h^s of the step before (the nodal polynomial of Radau IIA
/// has slopes in this proportion at 1 and 0). This step hands on the share
///     s g / (s + g),  g = (h_n / h_{n-1})^s,
/// of it; z_n hands nothing on, and without the share an error once made would ask for ever smaller steps. (HLR89, Theorems
/// 4.4 and 6.1: |h| e_z and h^2 e_u are O(h^{s+1}) for Radau IIA.)
///
/// Cost: numbers alone; one norm in the first attempts at a step.
template <class Scalar>
class index_guard : public guard_defaults {
  public:
    /// After a method of other order z_n has an error that g knows nothing of. One of higher order leaves little, as if g
    /// were infinite. One of lower order leaves more than this step makes, which is why it has been given up: what z_n
    /// brings into index 3, s e_z / h, counts then, the share 1/(s - 1). As z_n does not change with the step, both end
    /// where smaller steps make g smaller.
    template <class Step>
    void begin(Step& step) {
        using std::abs;
        using std::pow;
        if (!step.may_have_index() || step.index < 2 || !step.estimates_from_start()) return;
        const Scalar s = Scalar(step.power - 1);
        step.share = s;  // z_0 is taken to be consistent
        if (step.last.h == Scalar(0)) return;
        const Scalar grown = pow(abs(step.h / step.last.h), s), regular = s * grown / (s + grown);
        const int change = step.method - step.last.method;
        if (change == 0 || (change < 0 && is_refused_often(step)))
            step.share = regular;
        else if (change > 0)
            step.share = regular * (s - Scalar(1)) < Scalar(1) ? regular : Scalar(1) / (s - Scalar(1));
    }

    /// z_n has an error of some twenty tolerances at most. In the first attempts at a step, what the estimate shows beyond
    /// twice that is not from z_n: the iteration may have gone to another solution of the constraints. After many attempts
    /// an error that no longer falls with the step is from z_n: the iteration of the step before has left so much in the
    /// constraints that it takes |h| e_z of this order to mend it in one step of any length. A smaller step cannot reduce
    /// it, so z is ignored in this step.
    template <class Step>
    Scalar estimated(Step& step, const Scalar& error) {
        if (!step.may_have_index() || !(step.share < Scalar(1))) return error;
        if (!is_refused_often(step))
            return larger(error, Scalar(step.size_with_share_one() - most_inherited()));
        const bool filtered_again = step.once > Scalar(0);
        if (filtered_again && error >= Scalar(1) && error < most_inherited() && !step.refused.falls(error)) {
            step.share = Scalar(0);
            return step.size();
        }
        return error;
    }

    /// An error that many refusals have not explained was there before: no trend that goes on.
    template <class Step>
    void accepted(const Step& step, outlook<Scalar>& seen) {
        if (step.may_have_index() && step.share < Scalar(1) && is_refused_often(step)) seen.continues = false;
    }

  private:
    static Scalar most_inherited() { return Scalar(40); }
    /// What three smaller steps have not taken away, no smaller step will.
    template <class Step>
    static bool is_refused_often(const Step& step) {
        return step.refused.for_error > 3;
    }
};

}  // namespace stagecraft
