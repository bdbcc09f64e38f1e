// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <stdexcept>
#include <type_traits>

namespace stagecraft {

/// The Kelvin-Voigt contact that replaces the constraint 0 = G q' + b (thesis (3.3)-(3.5)): the contact point
/// may creep, z' = G q' + b, against a spring and a damper, lambda = (c/eps) z + (d/eps^kappa) z'. kappa = 1
/// is strong damping, kappa = 1/2 principal damping. As eps -> 0 the motion tends to that of the index-2
/// system.
template <class Scalar>
struct contact {
    using scalar = Scalar;
    Scalar epsilon, kappa, c, d;
    Scalar stiffness, damping;  ///< c/eps and d/eps^kappa

    /// Throws std::invalid_argument that names the parameter unless eps, c, d > 0 and 0 < kappa <= 1.
    contact(Scalar eps, Scalar k, Scalar spring, Scalar damper)
        : epsilon(eps), kappa(k), c(spring), d(damper), stiffness(0), damping(0) {
        using std::pow;
        const auto positive = [](const Scalar& x, const char* what) {
            if (!(x > Scalar(0)) || !(x - x == Scalar(0))) throw std::invalid_argument(what);
        };
        positive(epsilon, "regularised: eps must be positive and finite");
        positive(c, "regularised: c must be positive and finite");
        positive(d, "regularised: d must be positive and finite");
        if (!(kappa > Scalar(0) && kappa <= Scalar(1)))
            throw std::invalid_argument("regularised: kappa must lie in (0, 1]");
        stiffness = c / epsilon;
        damping = d / (kappa == Scalar(1) ? epsilon : Scalar(pow(epsilon, kappa)));
    }
};

namespace detail {

/// The scalar in which to compute with parameters of these types: double where all are integers.
template <class... Numbers>
using real_scalar = std::conditional_t<std::is_integral_v<std::common_type_t<Numbers...>>, double,
                                       std::common_type_t<Numbers...>>;

/// The contact with these parameters, in their common type; in double where all are integers.
template <class Eps, class Kappa, class C, class D>
auto contact_of(const Eps& eps, const Kappa& kappa, const C& c, const D& d) {
    using scalar = real_scalar<Eps, Kappa, C, D>;
    return contact<scalar>(scalar(eps), scalar(kappa), scalar(c), scalar(d));
}

}  // namespace detail

}  // namespace stagecraft
