// SPDX-License-Identifier: BSL-1.0
#include "proof.hpp"

#include <stagecraft/tableaux/exact_tableau.hpp>
#include <stagecraft/theory/judging/certify.hpp>

#include <problems/rolling_disc/surd_tableau.hpp>

namespace rolling_disc {

using stagecraft::tableaux::family;

std::string exact_tableau_text() {
    return print(stagecraft::tableaux::exact_tableau(family::radau_iia, 3).value());
}

std::string certificate_text() { return stagecraft::theory::certify(family::radau_iia, 3).text(); }

}  // namespace rolling_disc
