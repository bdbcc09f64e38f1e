// SPDX-License-Identifier: BSL-1.0
#include "compete.hpp"
#include "problems.hpp"

void compete_on_diffusion(const settings& set, std::vector<curve>& curves) {
    compete(problems::brusselator{}, reference("brusselator1d_N500"), set, curves);
    compete(problems::sparse_brusselator{}, reference("brusselator1d_N500"), set, curves);
}
