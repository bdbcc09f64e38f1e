// SPDX-License-Identifier: BSL-1.0
#include <problems/stiff.hpp>
#include "compete.hpp"

void compete_on_larger_systems(const settings& set, std::vector<curve>& curves) {
    compete(problems::hires{}, reference("hires"), set, curves);
    compete(problems::transistor_amplifier{}, reference("transamp"), set, curves);
}
