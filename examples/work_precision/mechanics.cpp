// SPDX-License-Identifier: BSL-1.0
#include "compete.hpp"
#include "problems.hpp"

#include "disc.hpp"

namespace {

Eigen::VectorXd disc_reference() {
    std::ifstream in(std::string(DATA_DIR) + "/../../rolling_disc/data/disc.json");
    const auto values = nlohmann::json::parse(in).at("t=1.0").at("values");
    Eigen::VectorXd y(values.size());
    for (Eigen::Index i = 0; i < y.size(); ++i) y[i] = std::stod(values[i].get<std::string>());
    return y;
}

}  // namespace

void compete_on_mechanics(const settings& set, std::vector<curve>& curves) {
    compete(problems::kepler{}, reference("kepler"), set, curves);
    compete(problems::rolling_disc{}, disc_reference(), set, curves);
}
