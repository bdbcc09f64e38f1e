// SPDX-License-Identifier: BSL-1.0
#include "classes.hpp"
#include "compete.hpp"

void compete_on_chains(const settings& set, std::vector<curve>& curves) {
    compete(problems::chain<28>{}, reference("chain14"), set, curves);
    compete(problems::chain<Eigen::Dynamic>{}, reference("chain40"), set, curves);
}
