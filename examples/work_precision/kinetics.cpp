// SPDX-License-Identifier: BSL-1.0
#include "classes.hpp"
#include "compete.hpp"

void compete_on_kinetics(const settings& set, std::vector<curve>& curves) {
    compete(problems::pollution{}, reference("pollution"), set, curves);
    compete(problems::network{}, reference("network60"), set, curves);
}
