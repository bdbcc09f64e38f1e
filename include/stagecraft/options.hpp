// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <stdexcept>
#include <string>

#include <stagecraft/break_points.hpp>
#include <stagecraft/linear/packet.hpp>

namespace stagecraft {

/// How the next step size follows from the estimates of this one and the one before (judge/step_size.hpp).
enum class step_control { predictive, proportional_integral };

/// One number per component: {1e-6, 1e-9} (which Eigen's own matrices take for their sizes), or a vector of Eigen's.
template <class Scalar>
struct numbers_of_components : Eigen::Matrix<Scalar, Eigen::Dynamic, 1> {
    using vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    using vector::vector;
    numbers_of_components() = default;
    numbers_of_components(std::initializer_list<Scalar> x)
        : vector(vector::Map(x.begin(), static_cast<Eigen::Index>(x.size()))) {}
};

/// The options of a run; the defaults suit a first try. Step sizes are magnitudes (the direction of time is
/// that of t1 - t0), and zero means "not given". The error of component i is measured in units of atol_i +
/// rtol |y_i|; for an index-2 component it is multiplied by |h|, for an index-3 component by h^2 (HLR89,
/// section 7).
template <class Scalar = double>
struct options {
    Scalar rtol = Scalar(1) / 1000000;                ///< relative tolerance, at least 4 epsilon
    Scalar atol = Scalar(1) / 1000000;                ///< absolute tolerance, a normal number > 0
    numbers_of_components<Scalar> atol_components{};  ///< instead of atol: one per component
    Scalar fixed_step{0};  ///< > 0: equal steps of at most this size, no error estimate at all; rtol and atol
                           ///< still say where Newton's iteration ends, what it leaves drifts in invariants:
                           ///< take 1e-12 for both in long symplectic runs
    Scalar initial_step{0};  ///< 0: chosen from f(t0, y0) and the tolerances
    Scalar min_step{0};      ///< below it the run ends in status::step_underflow
    Scalar max_step{0};      ///< 0: no bound
    step_control control = step_control::predictive;
    bool continuous = false;  ///< true: the tolerance holds between the ends of the steps as well; for
        ///< families of two stages at least but Radau IA, an error with others. (Of components
        ///< that a singular M leaves algebraic it does wherever an observer looks there.)
    bool jumps = true;  ///< false: f is smooth, and the run does nothing about jumps that the error
        ///< estimate does not show in full (judge/guards/jumps.hpp); it never does where
        ///< the method shows all of them
    long max_steps = 1000000;   ///< attempts, accepted or not
    int newton_iterations = 0;  ///< at most this many per step, per stage where stages are solved one by
                                ///< one; 0: 7 + (5 s - 15)/2 as the stages grow, 50 with fixed steps
    Scalar newton_factor{0};    ///< Newton error allowed, as a fraction of the tolerance; 0: 1/50
    break_times<Scalar> break_points{};  ///< where f is known to jump (break_points.hpp)
    bool consistent_start =
        false;  ///< true: y moves to where the equations without a derivative hold, before the
                ///< first step and behind each change (run/make_consistent.hpp); nothing where M is regular
};

namespace detail {
/// Apart from the demands, of which each would write its own text together.
[[noreturn, gnu::noinline]] inline void refuse(const char* what) {
    throw std::invalid_argument(std::string("integrate: ") + what);
}
}  // namespace detail

/// Throws std::invalid_argument that names the first option out of range; n is the size of the state.
template <class Scalar>
[[gnu::cold]] void validate(const options<Scalar>& o, Eigen::Index n) {
    const auto finite = [](const Scalar& x) { return x - x == Scalar(0); };
    const auto demand = [](bool good, const char* what) {
        if (!good) detail::refuse(what);
    };
    demand(finite(o.rtol) && o.rtol > Scalar(0), "rtol must be positive and finite");
    // Below that, the rounding of y alone exceeds what Newton's iteration may leave, whatever atol is.
    demand(o.rtol >= 4 * std::numeric_limits<Scalar>::epsilon(),
           "rtol must be at least four times the epsilon of the scalar, below which it cannot be met");
    // The weight of a component that is zero is 1/atol.
    const Scalar least = std::numeric_limits<Scalar>::min();
    const char* const too_small = "atol must not be below the smallest normal number: its inverse overflows";
    if (o.atol_components.size() == 0) {
        demand(finite(o.atol) && o.atol > Scalar(0), "atol must be positive and finite");
        demand(o.atol >= least, too_small);
    } else {
        demand(o.atol_components.size() == n, "atol_components must have the size of y0");
        for (Eigen::Index i = 0; i < n; ++i) {
            demand(finite(o.atol_components[i]) && o.atol_components[i] > Scalar(0),
                   "atol_components must be positive and finite");
            demand(o.atol_components[i] >= least, too_small);
        }
    }
    demand(finite(o.fixed_step) && o.fixed_step >= Scalar(0), "fixed_step must be finite and not negative");
    demand(finite(o.initial_step) && o.initial_step >= Scalar(0),
           "initial_step must be finite and not negative");
    demand(finite(o.min_step) && o.min_step >= Scalar(0), "min_step must be finite and not negative");
    demand(o.max_step >= Scalar(0), "max_step must be a number and not negative");
    const bool bounded = o.max_step > Scalar(0);
    demand(!bounded || o.max_step >= o.min_step, "max_step must not be below min_step");
    if (o.initial_step > Scalar(0)) {
        demand(o.initial_step >= o.min_step, "initial_step must not be below min_step");
        demand(!bounded || o.initial_step <= o.max_step, "initial_step must not be above max_step");
    }
    if (o.fixed_step > Scalar(0)) {
        demand(o.initial_step == Scalar(0) && o.min_step == Scalar(0) && !bounded,
               "fixed_step leaves nothing to initial_step, min_step and max_step: give it alone");
        demand(!o.continuous, "continuous asks for an error estimate, which fixed_step does without");
    }
    demand(o.max_steps > 0, "max_steps must be positive");
    demand(o.newton_iterations >= 0, "newton_iterations must not be negative");
    demand(finite(o.newton_factor) && o.newton_factor >= Scalar(0),
           "newton_factor must be finite and not negative");
}

/// The same of a state that takes the place of one, which has n components here.
template <class Vector, class Sums>
void validate_corrected(const Vector& y, Eigen::Index n, const Sums& sums) {
    if (y.size() != n || !all_finite(y, static_cast<int>(n), sums))
        throw std::invalid_argument("integrate: the corrected state must be finite and of the same size");
}

/// Throws std::invalid_argument that names t0, t1 or y0 if it is not finite.
template <class Vector, class Scalar>
void validate_interval(const Vector& y0, const Scalar& t0, const Scalar& t1) {
    const auto finite = [](const Scalar& x) { return x - x == Scalar(0); };
    if (!finite(t0)) throw std::invalid_argument("integrate: t0 must be finite");
    if (!finite(t1) || !finite(t1 - t0)) throw std::invalid_argument("integrate: t1 must be finite");
    for (Eigen::Index i = 0; i < y0.size(); ++i)
        if (!finite(y0[i])) throw std::invalid_argument("integrate: y0 must be finite");
}

/// Thirty-two bits of a run's interval, options and number of stages, which differ where these do. Left out are
/// atol_components, which belong to the components.
template <class Scalar>
std::uint32_t fingerprint(const options<Scalar>& o, const Scalar& t0, const Scalar& t1, int stages) {
    std::uint64_t mixed = 14695981039346656037U;  // FNV-1a, by numbers
    const auto mix = [&](const Scalar& x) {
        mixed = (mixed ^ std::bit_cast<std::uint64_t>(static_cast<double>(x))) * 1099511628211U;
    };
    for (const Scalar& x : o.break_points.numbers()) mix(x);
    for (const Scalar& x : {t0, t1, o.rtol, o.atol, o.fixed_step, o.initial_step, o.min_step, o.max_step,
                            o.newton_factor, Scalar(static_cast<int>(o.control)),
                            Scalar(o.continuous ? 1 : 0), Scalar(o.jumps ? 1 : 0), Scalar(o.max_steps),
                            Scalar(o.newton_iterations), Scalar(o.consistent_start ? 1 : 0), Scalar(stages)})
        mix(x);
    return static_cast<std::uint32_t>(mixed >> 32);
}

/// The absolute tolerance of component i: its own where there are such, otherwise atol.
template <class Scalar>
Scalar absolute_tolerance(const options<Scalar>& o, Eigen::Index i) {
    return o.atol_components.size() > 0 ? o.atol_components[i] : o.atol;
}

/// weights_i := 1/(atol_i + rtol |y_i|).
template <class Vector, class Scalar>
void set_weights(const options<Scalar>& o, const Vector& y, Vector& weights) {
    using std::abs;
    const auto tolerance = [&](Eigen::Index i) {
        return Scalar(o.rtol * abs(y[i]) + absolute_tolerance(o, i));
    };
    constexpr int n = Vector::SizeAtCompileTime;
    if constexpr (0 < n && n <= 4) {  // a packet would wait until all its numbers have reached the cache
        for (Eigen::Index i = 0; i < n; ++i) weights[i] = Scalar(1) / tolerance(i);
    } else {
        for (Eigen::Index i = 0; i < y.size(); ++i) weights[i] = tolerance(i);
        weights = weights.cwiseInverse();  // in packets: a packet of quotients takes no longer than one
    }
}

}  // namespace stagecraft
