// SPDX-License-Identifier: BSL-1.0
#include "compete.hpp"
#include "dopri.hpp"

bool open_dopri5(const std::string& library) {
    peers::dopri5 = peers::open_dopri(library, "dopri5_");
    return peers::dopri5 != nullptr;
}
bool open_dop853(const std::string& library) {
    peers::dop853 = peers::open_dopri(library, "dop853_");
    return peers::dop853 != nullptr;
}

void compete_on_arenstorf(const settings&, std::vector<curve>&);
void compete_on_lorenz(const settings&, std::vector<curve>&);
void compete_on_pleiades(const settings&, std::vector<curve>&);

void compete_on_nonstiff(const settings& set, std::vector<curve>& curves) {
    compete_on_arenstorf(set, curves);
    compete_on_lorenz(set, curves);
    compete_on_pleiades(set, curves);
}
