// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <utility>

#include <stagecraft/linear/mass.hpp>

namespace stagecraft {

/// The mass matrix of a problem of which nobody knows at compile time whether it has one: the identity costs a branch.
template <class Scalar>
class optional_mass {
  public:
    explicit optional_mass(const identity_mass& = {}) {}
    explicit optional_mass(entry_mass<Scalar> entries) : entries_(std::move(entries)) {}

    bool identity() const { return !entries_.has_value(); }
    /// visit(mass), an identity_mass or an entry_mass.
    template <class Visit>
    void visit(const Visit& visit) const {
        if (entries_)
            visit(*entries_);
        else
            visit(identity_mass());
    }

  private:
    std::optional<entry_mass<Scalar>> entries_;
};

template <class Scalar>
void add_mass_times(const optional_mass<Scalar>& m, const Scalar& factor, const Scalar* x, Scalar* r, int n) {
    m.visit([&](const auto& mass) { add_mass_times(mass, factor, x, r, n); });
}
template <class Scalar>
void add_mass(const optional_mass<Scalar>& m, const Scalar& factor, Scalar* a, int n) {
    m.visit([&](const auto& mass) { add_mass(mass, factor, a, n); });
}

namespace detail {

template <class Scalar, class Write>
void for_mass(const optional_mass<Scalar>& m, int first, int n, const Write& write) {
    m.visit([&](const auto& mass) { for_mass(mass, first, n, write); });
}

}  // namespace detail

}  // namespace stagecraft
