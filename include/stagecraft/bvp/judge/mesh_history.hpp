// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <limits>

#include <stagecraft/bvp/judge/mesh_evidence.hpp>

namespace stagecraft::detail {

/// The meshes so far, in numbers. The least error, and the meshes in a row that did not halve it: these double the mesh, so
/// that the search ends by max_intervals even where the error is nothing but rounding and goes up and down.
template <class Scalar>
struct mesh_history {
    Scalar least = std::numeric_limits<Scalar>::infinity();  ///< error since the last beginning from a guess
    Scalar error = std::numeric_limits<Scalar>::infinity();  ///< the last one that was estimated
    int idle = 0;           ///< meshes in a row that did not halve the least error
    int stuck = 0;          ///< meshes in a row that took no hundredth off it
    int jumped = 0;         ///< meshes in a row on which f seemed to jump
    int failures = 0;       ///< meshes on which Newton's iteration failed, or f could not be evaluated
    bool solved = false;    ///< there is a solution on an earlier mesh
    Scalar kappa{-1};       ///< the relative condition number last looked at; negative if it never was
    Scalar first_kappa{0};  ///< and the first one
    int unsettled = 0;      ///< how often it did not stay

    /// The counts with this mesh among them, whose error is known.
    mesh_history with(const evidence_reader<Scalar>& r, const Scalar& rtol) const {
        const Scalar& now = r(quantity::error);
        mesh_history next = *this;
        next.stuck = now < 99 * least / 100 ? 0 : stuck + 1;
        next.idle = now <= rtol || now < least / 2 ? 0 : idle + 1;
        next.jumped = r.yes(quantity::jumps) ? jumped + 1 : 0;
        return next;
    }

    void add(const mesh_evidence<Scalar>& e, const mesh_verdict<Scalar>& v, const Scalar& rtol) {
        if (e.knows(quantity::error) && e[quantity::evaluable] != Scalar(0)) error = e[quantity::error];
        if (v.moves_on()) {
            *this = with(evidence_reader<Scalar>(e), rtol);
            least = std::min(least, error);
            solved = true;
        }
        if (e.knows(quantity::kappa) && !e.trial) look_at(e[quantity::kappa], v.unsettled);
        if (v.act == mesh_act::finer_guess || v.act == mesh_act::halve_last || v.act == mesh_act::straight)
            ++failures;
        if (v.act == mesh_act::finer_guess || v.act == mesh_act::usual_mesh || v.act == mesh_act::other_guess)
            least = std::numeric_limits<Scalar>::infinity(), idle = 0;
    }

  private:
    void look_at(const Scalar& now, bool unsettled_now) {
        if (kappa < Scalar(0)) first_kappa = now;
        kappa = now;
        unsettled += unsettled_now;
    }
};

}  // namespace stagecraft::detail
