// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <type_traits>

#include <stagecraft/linear/mass_kernel.hpp>
#include <stagecraft/linear/norms.hpp>

namespace stagecraft {

/// The components of index 1 that M leaves algebraic, in a run of which somebody looks between the ends of the steps. At the
/// ends they satisfy their equations, so that no estimate says anything about them.
template <class Vector>
class watched_components {
  public:
    using scalar = typename Vector::Scalar;

    /// Takes storage; nothing where the entries of M are not here, or M is regular.
    template <class System>
    void find([[maybe_unused]] const System& system) {
        if constexpr (!System::mass_type::identity && has_entries<typename System::mass_type> &&
                      System::sums_type::complete) {
            const int n = system.size();
            const mass_kernel<scalar> algebraic(system.mass(), n);
            share_ = Vector::Zero(n);
            for (const auto& v : algebraic.basis())
                for (std::size_t i = 0; i < v.at.size(); ++i)
                    if (!(v.value[i] == scalar(0))) share_[v.at[i]] = scalar(1);
            system.for_each_raised([&](int i, int) { share_[i] = scalar(0); });
            const scalar count = share_.sum();
            any_ = count > scalar(0);
            using std::sqrt;
            if (any_) share_ *= scalar(sqrt(scalar(n) / count));
            weights_ = share_;
        }
    }
    bool any() const { return any_; }
    /// They are of a higher index than is said: no step is small enough for their errors between the ends.
    void forget() { any_ = false; }

    /// The root mean square over these components alone.
    template <class Sums>
    struct norm {
        const Vector& of_components;
        const Sums& all;
        const Vector& weights() const { return of_components; }
        const Sums& sums() const { return all; }
        scalar weigh(const Vector& x) const {
            return weighted_norm(x, of_components, static_cast<int>(x.size()), all);
        }
    };
    template <class Norm>
    auto of(const Norm& whole) const {
        weights_ = share_.cwiseProduct(whole.weights());
        return norm<std::remove_cvref_t<decltype(whole.sums())>>{weights_, whole.sums()};
    }

  private:
    bool any_ = false;
    Vector share_;  // 0, or as much that the mean over all components is that over these
    mutable Vector weights_;
};

/// Without a mass matrix there are none.
struct no_watched_components {};
template <class System, class Vector>
using watched_components_of =
    std::conditional_t<System::mass_type::identity, no_watched_components, watched_components<Vector>>;

}  // namespace stagecraft
