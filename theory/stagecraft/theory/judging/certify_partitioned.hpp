// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <ostream>
#include <stagecraft/tableaux/read_partitioned.hpp>
#include <stagecraft/tableaux/reading.hpp>
#include <stagecraft/theory/judging/certify_file.hpp>
#include <string_view>

namespace stagecraft::theory {

/// Judges a method of several tableaux: order of all together by coloured trees and which of them fails, stage
/// order, symplecticity; of additive and partitioned methods also each tableau for itself, of which the order
/// of the whole is claimed; where something is refuted, the single entries that would restore every claim.
file_certificate certify(const tableaux::partitioned_file& file);

file_certificate certify(const tableaux::method_file& file);

/// What the command does with the text of a file: the certificate to `out`, or one line to `err`.
/// Returns the exit code: 0 nothing claimed is refuted, 1 something is, 2 unusable input, 3 a claim is beyond
/// what the digits given can test.
int certify_text(std::string_view text, bool as_json, std::ostream& out, std::ostream& err,
                 const tableaux::reading& how = {});

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/certify_partitioned-inl.hpp"
#endif
