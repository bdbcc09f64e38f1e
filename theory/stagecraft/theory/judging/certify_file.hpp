// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/theory/judging/file_certificate.hpp>

namespace stagecraft::theory {

/// Judges a tableau file: order, stage order, row sums, every property claimed; where something claimed is
/// refuted, the failing conditions and the suspects; eigenvalues of A and poles of R; for rounded data the
/// nearest family. Exact data are decided; rounded and enclosed data are refuted or found consistent. What is
/// refuted as rounded decimals is tried as decimals cut off, and the certificate says so.
file_certificate certify(const tableaux::tableau_file& file);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/certify_file-inl.hpp"
#endif
