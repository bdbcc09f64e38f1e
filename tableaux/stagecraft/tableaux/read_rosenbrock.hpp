// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/partitioned_file.hpp>
#include <stagecraft/tableaux/reading.hpp>

namespace stagecraft::tableaux::json_reader {

struct document;

/// A Rosenbrock or W method into `file`: {"form":"rosenbrock", "A", "Gamma", "b"}, or transformed as codes have it, {"gamma", "a", "C",
/// "m"}. Besides "b_embedded" ("m_embedded") or the difference "e" of the weights, "c" and "d" (the row sums of A and Gamma), and
/// "gamma" for a single diagonal of Gamma, which is 0 in the file then. A is strictly lower triangular, Gamma lower. Throws
/// unusable_input, which names the entry.
void rosenbrock(const document& d, const reading& how, partitioned_file& file);

}  // namespace stagecraft::tableaux::json_reader

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/read_rosenbrock-inl.hpp"
#endif
