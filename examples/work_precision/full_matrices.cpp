// SPDX-License-Identifier: BSL-1.0
#include "classes.hpp"
#include "compete.hpp"

void compete_on_full_matrices(const settings& set, std::vector<curve>& curves) {
    compete(problems::allen_cahn<24>{}, reference("spectral24"), set, curves);
    compete(problems::allen_cahn<Eigen::Dynamic>{}, reference("spectral64"), set, curves);
    compete(problems::diode_ladder{}, reference("diodes20"), set, curves);
}
