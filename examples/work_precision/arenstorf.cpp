// SPDX-License-Identifier: BSL-1.0
#include "explicit.hpp"

void compete_on_arenstorf(const settings& set, std::vector<curve>& curves) {
    compete_explicitly<problems::arenstorf>(set, curves);
}
