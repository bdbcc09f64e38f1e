// SPDX-License-Identifier: BSL-1.0
// says: with nodes = tableaux::nodal_polynomial::from_nodes(
// lines: 11
#include <stagecraft/theory/judging/certify.hpp>

auto run() {
    return stagecraft::theory::certify(stagecraft::tableaux::nodal_polynomial::from_nodes({0, {1, 3}, 1}));
}
