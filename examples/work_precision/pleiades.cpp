// SPDX-License-Identifier: BSL-1.0
#include "explicit.hpp"

void compete_on_pleiades(const settings& set, std::vector<curve>& curves) {
    compete_explicitly<problems::pleiades>(set, curves);
}
