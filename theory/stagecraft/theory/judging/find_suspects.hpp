// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/theory/judging/file_certificate.hpp>
#include <stagecraft/theory/judging/subject.hpp>

namespace stagecraft::theory {

namespace detail {

/// One instantiation serves Q and Q(sqrt d): a rational number in tableaux::quadratic costs what it costs
/// alone.
inline tableaux::quadratic exact_entry(const tableaux::entry& e) { return *e.exact; }
inline tableaux::ball enclosed_entry(const tableaux::entry& e) { return to_ball(e.enclosure); }

subject<tableaux::quadratic> exact_subject(const tableaux::tableau_file& file);
subject<tableaux::ball> enclosed_subject(const tableaux::tableau_file& file);

/// Names what may be wrong: single entries; else what was exchanged or lost; else two entries of a
/// row, of two rows, of b, or an entry and one of b_embedded.
void find_suspects(tableaux::tableau_file file, file_certificate& certificate);

}  // namespace detail

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/find_suspects-inl.hpp"
#endif
