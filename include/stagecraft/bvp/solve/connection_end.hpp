// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <string>
#include <utility>

#include <stagecraft/bvp/judge/limit_modes.hpp>
#include <stagecraft/bvp/options.hpp>

namespace stagecraft::detail {

/// The equilibrium at one end of a connecting orbit of y' = f(y, p), seen in the direction of time in which the orbit approaches
/// it: forwards at the end, backwards at the beginning. Functions is two_point_functions.
template <class Vector, class Parameters, class Functions>
class connection_end : public directions_of_approach<typename Vector::Scalar> {
  public:
    using scalar = typename Vector::Scalar;
    using dense = Eigen::Matrix<scalar, Eigen::Dynamic, Eigen::Dynamic>;

    connection_end(Functions& functions, std::string name, bool forwards)
        : functions_(functions), name_(std::move(name)), n_(functions.size()), forwards_(forwards) {}

    Vector y;  ///< the equilibrium

    /// How many directions leave it.
    int leaving() const { return static_cast<int>(this->away.rows()); }

    /// Newton's iteration for the equilibrium at p, from the guess.
    void find(const Vector& guess, const Parameters& p) {
        demand(guess.size() == n_ && guess.allFinite(), "must be finite and have n components");
        y = guess;
        for (int k = 0; k < 50; ++k) {
            const Vector f = functions_.f(scalar(0), y, p).head(n_);
            const dense A = functions_.jacobian(scalar(0)).topLeftCorner(n_, n_);
            const Vector step = A.partialPivLu().solve(f);
            if (!step.allFinite()) break;
            y -= step;
            if (step.norm() <= scalar(1e-9) * (1 + y.norm())) return;
        }
        demand(false, "must be near an equilibrium, at which f_y is regular: Newton's iteration finds none");
    }
    /// Looks at the directions at the equilibrium.
    void look(const Parameters& p) {
        functions_.f(scalar(0), y, p);
        dense A = functions_.jacobian(scalar(0)).topLeftCorner(n_, n_);
        if (!forwards_) A = -A;
        const limit_spectrum<scalar> modes(A);
        demand(modes.known, "f_y is not finite there");
        int none = 0;
        for (const scalar& rate : modes.rates) none += rate >= -modes.none && rate <= modes.none;
        demand(none == 0, ("is not hyperbolic: f_y has " + std::to_string(none) +
                           " eigenvalue(s) on the imaginary axis there, so that orbits need not approach it "
                           "exponentially")
                              .c_str());
        demand(modes.decaying > 0, forwards_ ? "is approached by no orbit: all eigenvalues of f_y there have "
                                               "positive real parts"
                                             : "is left by no orbit: all eigenvalues of f_y there have "
                                               "negative real parts");
        this->split(A, modes);
    }
    /// What drives an orbit at `at` in the directions that leave the equilibrium, beside the linear part: integrated from the end
    /// on, it is what of them is left out there.
    Vector driving(const Vector& at, const Parameters& p) const {
        Vector f = functions_.f(scalar(0), at, p).head(n_);
        if (!forwards_) f = -f;
        return this->others * (f - this->linear * (at - y));
    }

  private:
    void demand(bool good, const char* what) const {
        demand_bvp(good, (name_ + ' ' + what).c_str(), "connecting_orbit");
    }

    Functions& functions_;
    std::string name_;
    int n_;
    bool forwards_;
};

}  // namespace stagecraft::detail
