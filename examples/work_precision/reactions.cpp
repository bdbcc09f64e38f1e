// SPDX-License-Identifier: BSL-1.0
#include <problems/stiff.hpp>
#include "compete.hpp"

void compete_on_reactions(const settings& set, std::vector<curve>& curves) {
    compete(problems::van_der_pol{}, reference("vdpol"), set, curves);
    compete(problems::robertson{}, reference("rober"), set, curves);
    compete(problems::oregonator{}, reference("orego"), set, curves);
}
