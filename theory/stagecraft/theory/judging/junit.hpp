// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/theory/judging/file_certificate.hpp>
#include <string>
#include <vector>

namespace stagecraft::theory {

/// What became of one of several tableau files.
struct file_outcome {
    std::string path;
    int exit_code = 0;
    std::string summary;  ///< one line
};

/// The certificate in one line: the verdict, the orders, and what is refuted or untested.
std::string one_line(const file_certificate& c);

/// The exit code of several files: the first of 1, 2, 3, 0 that occurs.
int exit_code(const std::vector<file_outcome>& all);

/// The outcomes as a JUnit report: refuted files are failures, unusable ones errors, untested ones skipped.
std::string junit_text(const std::vector<file_outcome>& all);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/junit-inl.hpp"
#endif
