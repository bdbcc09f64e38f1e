// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string_view>
#include "stagecraft/tableaux/reading.hpp"
#include "stagecraft/tableaux/tableau_file.hpp"

namespace stagecraft::tableaux {

/// Reads arrays A, b and, where they are there, c and b_embedded (or b_hat, bhat, btilde) as a program in C,
/// Python, Julia, Matlab or Fortran has them: "A = np.array([[0, 0], [1/2, 0]])", "double b[2] = {0.0, 1.0};", "A = [0 0; 1//2
/// 0]", "a(2,2) = reshape([0, 1/2, 0, 0], [2, 2])". Short rows of an explicit method's A are filled with zeros. "order = 4" claims that order, as does
/// "embedded_order". Throws unusable_input as read_tableau, where A or b is missing too.
tableau_file read_program_text(std::string_view source, const reading& how = {});

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/program_text-inl.hpp"
#endif
