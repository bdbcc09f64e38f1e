// SPDX-License-Identifier: BSL-1.0
#include "classes.hpp"
#include "compete.hpp"

void compete_on_diffusion(const settings& set, std::vector<curve>& curves) {
    compete(problems::brusselator200{}, reference("bruss200"), set, curves);
    compete(problems::front{}, reference("front400"), set, curves);
    compete(problems::brusselator{}, reference("brusselator1d_N500"), set, curves);
    compete(problems::sparse_brusselator{}, reference("brusselator1d_N500"), set, curves);
}
