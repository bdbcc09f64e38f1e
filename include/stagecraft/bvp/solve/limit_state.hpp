// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

#include <stagecraft/bvp/judge/limit_modes.hpp>
#include <stagecraft/bvp/options.hpp>

namespace stagecraft::detail {

/// The equation near the limit that solutions approach, seen through f and its Jacobian. Functions is two_point_functions.
template <class Vector, class Parameters, class Functions>
class limit_state : public directions_of_approach<typename Vector::Scalar> {
  public:
    using scalar = typename Vector::Scalar;
    using dense = Eigen::Matrix<scalar, Eigen::Dynamic, Eigen::Dynamic>;
    using spectrum = limit_spectrum<scalar>;
    using limit_function = std::function<Vector(const scalar&, const Parameters&)>;

    /// rtol is that of the solution: what limit is off by stays in it.
    limit_state(Functions& functions, limit_function limit, const scalar& a, const scalar& rtol)
        : functions_(functions),
          limit_(std::move(limit)),
          a_(a),
          n_(functions.size()),
          most_(std::min(scalar(1e-6),
                         std::max(scalar(rtol / 10), 1000 * std::numeric_limits<scalar>::epsilon()))) {}

    Vector limit(const scalar& t, const Parameters& p) const { return limit_(t, p); }

    /// Looks at the limit at t; throws where it is none.
    void look(const scalar& t, const Parameters& p) {
        const scalar length = t - a_, far = a_ + 16 * length, twice = a_ + 32 * length;
        demand(limit_(t, p).allFinite(), "limit must be finite and write every component");
        demand_solution(t, far, twice, p);
        const dense A = linearisation(t, p);
        const spectrum here(A);
        const char* fault =
            fault_of(here, spectrum(linearisation(far, p)), spectrum(linearisation(twice, p)));
        demand(!fault, fault ? fault : "");
        this->split(A, here);
    }
    /// What drives y - limit in the directions that do not decay, at y near the limit, beside the linear part: integrated
    /// from the end on it is what of them is left out there. Of the last linearisation that was looked at.
    Vector driving(const scalar& t, const Vector& y, const Parameters& p) {
        const Vector off = y - limit_(t, p);
        return this->others * (f(t, y, p) - slope_of_limit(t, p) - this->linear * off);
    }
    /// The part of y - limit in the directions that do not decay.
    Vector undecaying(const scalar& t, const Vector& y, const Parameters& p) const {
        return this->others * (y - limit_(t, p));
    }
    /// A length over which y - limit falls to a hundredth, by the eigenvalues at its end: the conditions there are wrong by the
    /// square of what is left.
    scalar first_length(const Parameters& p) {
        scalar length(10);
        for (int k = 0; k < 8; ++k) {
            const spectrum at(linearisation(a_ + length, p));
            if (!at.known || at.decaying == 0) break;
            const scalar next = std::min(scalar(1000), scalar(scalar(4.6) / at.slowest()));
            if (!(next > 0)) break;
            length = (length + next) / 2;
        }
        return length;
    }

  private:
    static void demand(bool good, const std::string& what) {
        demand_bvp(good, ("to_infinity(limit): " + what).c_str());
    }
    Vector f(const scalar& t, const Vector& y, const Parameters& p) { return functions_.f(t, y, p).head(n_); }
    dense linearisation(const scalar& t, const Parameters& p) {
        const Vector y = limit_(t, p);
        functions_.f(t, y, p);
        return functions_.jacobian(t).topLeftCorner(n_, n_);
    }
    Vector slope_of_limit(const scalar& t, const Parameters& p) {
        using std::abs;
        const scalar h = (1 + abs(t)) / 1000;
        const auto across = [&](const scalar& d) -> Vector {
            return limit_(scalar(t + d), p) - limit_(scalar(t - d), p);
        };
        return (8 * across(h) - across(2 * h)) / (12 * h);
    }
    /// f(t, limit) - limit', relative to the sizes that cancel in it.
    scalar defect(const scalar& t, const Parameters& p) {
        const Vector y = limit_(t, p), slope = slope_of_limit(t, p);
        const scalar size = linearisation(t, p).norm() * y.norm() + slope.norm();
        return (f(t, y, p) - slope).norm() / (1 + size);
    }
    void demand_solution(const scalar& t, const scalar& far, const scalar& twice, const Parameters& p) {
        const scalar here = defect(t, p), there = defect(far, p), beyond = defect(twice, p);
        scalar least = std::numeric_limits<scalar>::infinity();
        for (const scalar& d : {here, there, beyond})
            if (d < least) least = d;
        demand(least - least == scalar(0), "f or its Jacobian is not finite at limit");
        std::ostringstream text;
        text.precision(2);
        const bool falls = there < scalar(0.8) * here && beyond < scalar(0.8) * there;
        if (least > most_ && falls_exponentially(twice, beyond, p)) return;
        if (falls)
            text << "f(t, limit) - limit' falls like a power of t, from " << here << " at t = " << t << " to "
                 << beyond << " at t = " << twice
                 << ", and so does y - limit: no interval is long enough; give a finite b with conditions "
                    "there, or a limit that follows y, limit(t, out)";
        else
            text << "limit must be a solution of y' = f(t, y), an equilibrium if it is constant; f - limit' "
                    "is "
                 << least << " beside the terms in f at t = " << t << " and beyond, and may be " << most_
                 << " (give limit to the digits that rtol asks for)";
        demand(least <= most_, text.str());
    }
    /// Does the defect, which is `last` at t, fall to what it may be, and then by far more than powers of t do over twice the
    /// time, before it is rounding? A wave may pass zero at one of the times.
    bool falls_exponentially(scalar t, scalar last, const Parameters& p) {
        scalar earlier = last, now = last;
        for (int k = 0; k < 16 && now > 1000 * std::numeric_limits<scalar>::epsilon(); ++k) {
            t = a_ + 2 * (t - a_);
            now = defect(t, p);
            if (now <= most_ && now < std::max(scalar(last / 100), scalar(earlier / 10000))) return true;
            earlier = last, last = now;
        }
        return false;
    }
    Functions& functions_;
    limit_function limit_;
    scalar a_;
    int n_;
    scalar most_;  // of the defect
};

}  // namespace stagecraft::detail
