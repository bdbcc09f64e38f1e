// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include "stagecraft/refuse/detect/refused_call.hpp"
#include "stagecraft/tableaux/nodal.hpp"
#include "stagecraft/theory/judging/certificate.hpp"
#include "stagecraft/theory/models/legendre_model.hpp"
#include "stagecraft/theory/stability/nodal_stability.hpp"

namespace stagecraft::theory {

namespace detail {

using tableaux::rational;
using exact_model = legendre_model<rational>;

std::string text(const tableaux::inertia& n);

certificate certify(const exact_model& m, std::string method, std::string about_nodes);

}  // namespace detail

/// Everything that exact arithmetic decides of a family's member with s stages: maximal B, C, D; the order;
/// R(z), R(infinity), error constant; A-, L-, algebraic and B-stability; symmetry, symplecticity, stiff
/// accuracy; poles of R and eigenvalues of A for s <= largest_spectrum. O(s^2) operations on exact integers,
/// some milliseconds for s = 50; the poles take up to ten more. Throws std::invalid_argument where the family
/// has no member with s stages.
certificate certify(tableaux::family f, int s);

/// The same for a method on a user's own nodes. General nodes make A full in its last column or altogether:
/// A-stability then takes Sturm's theorem and Routh-Hurwitz, and the order may take a search for a failing
/// tree (up to order 20; where none is found the claim says "at least").
/// Throws std::invalid_argument where the construction does not determine A (see legendre_model).
certificate certify(const tableaux::nodal_polynomial& nodes, tableaux::construction rule);

namespace detail {
struct call_of_certify {
    template <class T>
    static constexpr bool say() {
        static_assert(!sizeof(T),
                      "certify(tableaux::family::radau_iia, 3), or certify(nodes, "
                      "tableaux::construction::collocation) with nodes = "
                      "tableaux::nodal_polynomial::from_nodes({0, rational(1, 3), 1}); what a file holds is "
                      "certified by judging/certify_file.hpp");
        return true;
    }
};
}  // namespace detail

/// Doubles, which prove nothing, or nodes without their construction.
certificate certify(stagecraft::detail::refused_call<detail::call_of_certify>,
                    stagecraft::detail::anything = 0);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/certify-inl.hpp"
#endif
