// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <concepts>
#include <limits>
#include <stdexcept>

#include <stagecraft/problem/capabilities.hpp>

namespace stagecraft {

/// Optional, for stabilised methods: `problem.spectral_radius(t, y)` returns a bound of the modulus of the eigenvalues of
/// df/dy, which lie near the negative real axis. 4 d / h^2 for the diffusion d u'' on a grid of width h, say.
template <class Problem, class Vector>
concept has_spectral_radius = requires(Problem& p, const typename Vector::Scalar& t, const Vector& y) {
    { p.spectral_radius(t, y) } -> std::convertible_to<typename Vector::Scalar>;
};

/// The spectral radius of df/dy: what the problem says, else found by the power method with differences of f
/// (Sommeijer, Shampine and Verwer 1998), whose vector is kept for the next time, at most 50 evaluations of f,
/// and a fifth more for safety. Norms are those of the tolerance. Not finite where f is not.
template <class Vector>
class spectral_radius_of {
    using scalar = typename Vector::Scalar;

  public:
    explicit spectral_radius_of(int n) : direction_(n), at_(n), f_(n) { direction_.setZero(); }

    /// f0 = f(t, y). Where the problem's own is negative or not finite at the start the run is refused (bad_problem), later
    /// it ends.
    template <class System, class Norm>
    scalar operator()(System& system, const scalar& t, const Vector& y, const Vector& f0, const Norm& norm) {
        if constexpr (has_spectral_radius<typename System::problem_type, Vector>) {
            const scalar given = system.problem().spectral_radius(t, y);
            if (!(given >= scalar(0)) || !(given - given == scalar(0))) {
                const char* text = "integrate: problem.spectral_radius(t, y) must be finite and not negative";
                if (begun_) throw std::invalid_argument(text);
                throw bad_problem(text);
            }
            begun_ = true;
            return given;
        } else {
            return found(system, t, y, f0, norm);
        }
    }
    template <class Bag>
    void carry(Bag& bag) {
        bag(direction_);
    }

  private:
    template <class System, class Norm>
    scalar found(System& system, const scalar& t, const Vector& y, const Vector& f0, const Norm& norm) {
        using std::abs;
        using std::sqrt;
        const scalar size = norm(y);
        const scalar reach =
            sqrt(std::numeric_limits<scalar>::epsilon()) * (size > scalar(1) ? size : scalar(1));
        if (!(norm(direction_) > scalar(0))) begin(f0, norm);
        scalar radius(0);
        for (int k = 0; k < 50; ++k) {
            const scalar length = norm(direction_);
            if (!(length > scalar(0)) || !(length - length == scalar(0))) break;
            at_ = y + (reach / length) * direction_;
            system(t, at_, f_);
            const scalar before = radius;
            direction_ = f_ - f0;
            radius = norm(direction_) / reach;
            if (k > 2 && abs(radius - before) <= radius / 100) break;
        }
        return radius * 6 / 5;
    }
    /// f0, which has slow components as well, and one that alternates, as the fastest of diffusion does.
    template <class Norm>
    void begin(const Vector& f0, const Norm& norm) {
        for (Eigen::Index i = 0; i < direction_.size(); ++i)
            direction_[i] = scalar(i % 2 == 0 ? 1 : -1) * (scalar(1) + scalar((i * 7919) % 101) / 101);
        const scalar length = norm(direction_), slope = norm(f0);
        direction_ /= length;
        if (slope > scalar(0)) direction_ += f0 / slope;
    }

    Vector direction_, at_, f_;
    bool begun_ = false;  // the problem has named one that can be used
};

}  // namespace stagecraft
