// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <optional>
#include <string>

#include <stagecraft/bvp/status.hpp>

namespace stagecraft {

/// How Newton's iteration ended on a mesh.
enum class damped_newton_end { converged, failed, non_finite };

namespace detail {

/// A number that may be measured on a mesh. M is the derivative of the conditions by the fundamental solutions of the
/// linearised problem, M_h that of the collocation equations, u the fundamental solution that answers most to a condition.
/// All are relative to the sizes of the components of y and p, whatever their units. Answers to yes or no are 1 or 0.
enum class quantity {
    // of x
    unresolved,      ///< the last Legendre coefficient of the slopes, integrated: about the error inside
    evaluable,       ///< is f finite where the error is estimated?
    error,           ///< the estimated error of x in the tolerance's norm, infinity where `evaluable` is 0
    jumps,           ///< does f seem to jump in an interval?
    size,            ///< max |y|
    next_intervals,  ///< how many intervals the mesh has that the verdict asks for
    // of the modes of the linearised problem
    missed_phase,  ///< the angle, over the whole interval, that the mesh misses of modes that turn and do not decay
    answer,        ///< the largest answer of y and p to the terms of a condition, about 1/|M|
    change,        ///< the part by which u changes with the error of x: for nonlinear f or r
    translation,    ///< the part of y' that the answers to its conditions miss (measure/translation.hpp)
    error_bound,    ///< a bound of mesh_error from the size of h f_y alone, infinity where that changes much
    mesh_error,     ///< the part by which local errors change u, and M_h is wrong; 1 where u is not resolved
    resolved,       ///< are the local errors of u small? Known where mesh_error is
    kernel_radius,  ///< the spectral radius of the errors of the modes that answer much; infinity if unresolved
    singular_end,  ///< is an end of [a, b] a regular singular point?
    // of the condition of the problem
    kappa,         ///< the relative condition number
    halved_kappa,  ///< that on the mesh halved; infinity where M is not known there
    norm,          ///< the norm of Phi in the condition's units; 0 where it is far below 1/(1000 epsilon)
    dependent,     ///< the first condition that depends on those before it; -1 if there is none
    residual,   ///< the largest residual of a fundamental solution in its own equations, beside their terms
    nonlinear,  ///< do f or r depend on y or p nonlinearly?
    contrast,   ///< the least |u(t)| over the largest: tiny where u grows along the interval
    full_size,  ///< max |y| after a full step of Newton's iteration; infinity if that does not solve the equations
    full_norm,  ///< the norm of Phi after that step, whatever it is; negative where it cannot be linearised there
    // of rounding errors
    rounding,       ///< the change of y and p by one rounding error of the conditions
    rounding_of_u,  ///< the change of u by one rounding error in every entry of the equations
    rounding_of_y,  ///< the same of y and p
    range,          ///< the largest |y_c| over the least, for the component where that is most
    count
};

/// A mesh and the solution x of the collocation equations on it, in numbers. Members are known from the start; quantities
/// cost something and are measured when a judge reads them.
template <class Scalar>
struct mesh_evidence {
    damped_newton_end newton = damped_newton_end::converged;
    bool converged = true;  ///< still so after the iterations that the error estimate asked for
    Scalar remainder{0};    ///< what Newton's iteration has left, relative
    int intervals = 1;
    int other_guesses = 0;     ///< that have not been tried yet
    bool dear = false;         ///< more evaluations of f than finer meshes for the same guess are worth
    int guess_intervals = 1;   ///< of the mesh on which the guess was last taken, halved for the next time
    int unknowns = 2;          ///< the size of y and p together
    bool trial = false;        ///< is this the first, coarse mesh, on which nothing is refused?
    bool linear = false;       ///< the same factors hold for every x
    bool changes = false;      ///< other Jacobians were found where a step of Newton's iteration led to
    bool differences = false;  ///< f_y comes from differences
    bool no_mass = true;       ///< no matrix stands before y'
    bool from_guess = true;    ///< Newton's iteration began at the user's guess
    Scalar guess_size{1};      ///< max |y| of that, and atol/rtol

    bool knows(quantity q) const { return known_[static_cast<std::size_t>(q)]; }
    const Scalar& operator[](quantity q) const { return values_[static_cast<std::size_t>(q)]; }
    void set(quantity q, const Scalar& value) {
        values_[static_cast<std::size_t>(q)] = value;
        known_.set(static_cast<std::size_t>(q));
    }

  private:
    static constexpr auto size = static_cast<std::size_t>(quantity::count);
    std::array<Scalar, size> values_{};
    std::bitset<size> known_;
};

/// Evidence as a judge reads it. The first number that is read and not known is what has to be measured; whatever is
/// concluded after that is thrown away, and the judge asked again. So it can be written as if all numbers were known, and
/// nothing is measured that no verdict needs.
template <class Scalar>
class evidence_reader {
  public:
    explicit evidence_reader(const mesh_evidence<Scalar>& e) : e_(e) {}
    const mesh_evidence<Scalar>* operator->() const { return &e_; }
    const Scalar& operator()(quantity q) const {
        if (!e_.knows(q) && !missing_) missing_ = q;
        return e_[q];
    }
    bool yes(quantity q) const { return (*this)(q) != Scalar(0); }
    bool converged() const { return e_.converged; }
    const std::optional<quantity>& missing() const { return missing_; }

  private:
    const mesh_evidence<Scalar>& e_;
    mutable std::optional<quantity> missing_;
};

/// The options on which verdicts depend.
template <class Scalar>
struct mesh_limits {
    Scalar rtol, epsilon;
    int max_intervals = 10000;
    bool adapt = true;
};

/// The next step of a search.
enum class mesh_act {
    measure,      ///< a number is missing
    finish,       ///< the run ends, with `status`
    usual_mesh,   ///< begin again at the guess, on the usual first mesh
    finer_guess,  ///< begin again at the guess, on its mesh halved
    other_guess,  ///< begin at another guess than the user's
    halve_last,   ///< Newton's iteration has failed: from the solution before it, on this mesh halved
    straight,     ///< f could not be evaluated between mesh points: from their values on a spread mesh
    resolve,      ///< a mesh halved, with points where modes have layers
    spread,       ///< a mesh that follows y, not its errors
    refine,       ///< a mesh that follows the errors
};

template <class Scalar>
struct mesh_verdict {
    mesh_act act = mesh_act::finish;
    quantity missing = quantity::count;   ///< measure: which
    mesh_act planned = mesh_act::finish;  ///< measure next_intervals: of the mesh of this act
    bool doubled = false,
         divide = false;     ///< refine: at least twice the intervals; those where f jumps for themselves
    bool unsettled = false;  ///< the condition number was looked at and does not stay
    bool family = false;     ///< M is singular at a solution: the dimension of its kernel is asked for
    bool at_place = false;   ///< f was not finite: say where
    bvp_status status = bvp_status::success;
    const char* reason = "";
    const char* cause = "";  ///< of an M that is singular
    int dependent = -1;      ///< or the condition that depends on those before it

    bool moves_on() const {
        return act == mesh_act::resolve || act == mesh_act::spread || act == mesh_act::refine;
    }
    static mesh_verdict end(bvp_status status, const char* reason) {
        mesh_verdict v;
        v.status = status, v.reason = reason;
        return v;
    }
    static mesh_verdict go(mesh_act act) {
        mesh_verdict v;
        v.act = act;
        return v;
    }
};

/// The reason of a verdict in words.
template <class Scalar>
std::string words_of(const mesh_verdict<Scalar>& v) {
    std::string reason = v.reason, cause = v.cause;
    if (v.dependent >= 0)
        cause = "condition r[" + std::to_string(v.dependent) + "] depends on those before it";
    if (!reason.empty() && !cause.empty()) reason += "; at its last iterate ";
    return reason + cause;
}

}  // namespace detail

}  // namespace stagecraft
