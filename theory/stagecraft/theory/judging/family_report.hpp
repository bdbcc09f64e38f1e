// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/family.hpp>
#include <stagecraft/theory/judging/certify.hpp>
#include <stagecraft/theory/judging/stability_report.hpp>
#include <vector>

namespace stagecraft::theory {

namespace detail {

/// What the theorems on differential-algebraic problems need to know of a family's member.
dae_traits<tableaux::rational> family_traits(tableaux::family f, int s, const certificate& known);

}  // namespace detail

/// The stability report of a family's member, proved for every s: of the tableau where the nodes lie in a
/// quadratic field, else from Legendre coordinates, which leaves out the SSP radius and singular perturbation problems.
/// Throws std::invalid_argument where the family has no member with s stages.
std::vector<report_section> stability_report(tableaux::family f, int s);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/family_report-inl.hpp"
#endif
