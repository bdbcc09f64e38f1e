// SPDX-License-Identifier: BSL-1.0
// says: certify(tableaux::family::radau_iia, 3), or certify(nodes,
// lines: 11
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/theory/judging/certify.hpp>

auto run() { return stagecraft::theory::certify(stagecraft::radau_iia<3>()); }
