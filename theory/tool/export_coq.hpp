// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/family.hpp>
#include <stagecraft/tableaux/reading.hpp>
#include <stagecraft/theory/judging/certificate.hpp>
#include <string>

namespace stagecraft::tool {

/// Where an exported proof goes; nowhere where `path` is empty.
struct coq_options {
    std::string path;
    bool split = false;  ///< the generic part beside it, as stagecraft.v, instead of within
};

/// Writes what `certificate` proves of a family's member as a Coq file: whole, or not at all.
/// Throws std::invalid_argument, in one sentence, where there is nothing to prove, and where it cannot be written.
void export_coq(tableaux::family f, int s, const theory::certificate& certificate,
                const coq_options& options);

/// The same of a tableau file.
void export_coq(const std::string& tableau, const tableaux::reading& how, const coq_options& options);

}  // namespace stagecraft::tool
