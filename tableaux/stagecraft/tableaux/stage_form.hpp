// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/method/storage_form.hpp>
#include <stagecraft/tableaux/tableau_file.hpp>

/// From the coefficients of a form with few registers to the tableau that it means, in any numbers.

namespace stagecraft::tableaux {

using stagecraft::registers_of;
using stagecraft::stage_register;

/// The tableau that a form means, whose c are the row sums. Throws std::invalid_argument where a stage does not contain
/// the value at the beginning once.
tableau_file expanded(stage_form form);

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/stage_form-inl.hpp"
#endif
