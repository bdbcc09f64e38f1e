// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/bvp/judge/mesh_evidence.hpp>

namespace stagecraft::detail {

/// Says whether M is regular, of which a mesh shows only M_h. With u the fundamental solution that answers most to the
/// conditions, u + e solves the exact equations with the same conditions, where e is what Green's function makes of the
/// local errors of u. If M is singular, M_h is its own error, and e = -u. So e well below u means that M is regular, e like u
/// that nothing is known on this mesh.
template <class Scalar>
class regularity_judge {
  public:
    /// An error of x may change u by this part where M of a nonlinear problem depends on x: at double solutions, in which M
    /// vanishes, it changes all of it.
    static constexpr double change_by_error = 0.01;
    /// Modes that turn by more than this unseen (radian) leave open what the conditions make of them.
    static constexpr double visible_phase = 1e-3;
    /// With a smaller answer M is singular only if the mesh is wrong by more than 1/30, which is seen in x as well.
    static constexpr double small_answer = 30;
    /// M_h wrong by less than this part of itself shows M, though the part is only estimated.
    static constexpr double safe_part = 0.25;
    /// A bound of the errors below this part needs no estimate, which costs a solve.
    static constexpr double small_bound = 0.05;

    explicit regularity_judge(const evidence_reader<Scalar>& r) : r_(r) {}

    struct finding {
        bool undecided;
        bool resolved;  ///< as far as they had to be looked at, are the local errors of u small?
    };

    /// Undecided where this mesh cannot show whether M is regular: the local errors are small, but their effect on u is
    /// comparable with u. `error` is that of x where M changes with it, else 0.
    finding decide(const Scalar& error) const {
        if (error > Scalar(0)) {
            if (r_(quantity::answer) * error > Scalar(change_by_error) &&
                !(r_(quantity::change) < Scalar(change_by_error)))
                return {true, true};
            if (r_(quantity::translation) > Scalar(safe_part)) return {true, true};
        }
        if (!turns() && r_(quantity::answer) < Scalar(small_answer)) return {false, true};
        if (!(mesh_error() < Scalar(safe_part))) return {turns() || resolved(), resolved()};
        // Another mode, which answers less than u, may be wrong by more.
        const bool hidden = r_->unknowns > 1 && !(r_(quantity::error_bound) < Scalar(small_bound)) &&
                            !(r_(quantity::kernel_radius) < Scalar(safe_part));
        return {hidden, resolved()};
    }

    /// Do modes turn between both ends, neither growing nor decaying by much, by an angle that the mesh does not show?
    bool turns() const { return r_(quantity::missed_phase) > Scalar(visible_phase); }

    /// The part by which M_h is wrong. The bound does not hold for the modes that a mass matrix makes.
    Scalar mesh_error() const { return r_(bounded() ? quantity::error_bound : quantity::mesh_error); }
    bool resolved() const { return bounded() || r_.yes(quantity::resolved); }

  private:
    bool bounded() const { return r_->no_mass && r_(quantity::error_bound) < Scalar(small_bound); }

    const evidence_reader<Scalar>& r_;
};

}  // namespace stagecraft::detail
