// SPDX-License-Identifier: BSL-1.0
#include <problems/stiff.hpp>
#include "compete.hpp"

#include "disc.hpp"

namespace {

/// The ellipse of eccentricity e and semi-axis 1 from Kepler's equation E - e sin E = t, by Newton.
reference_point kepler_ellipse(double t) {
    const double e = 0.6, b = std::sqrt(1 - e * e);
    double E = t;
    for (int k = 0; k < 50; ++k) E -= (E - e * std::sin(E) - t) / (1 - e * std::cos(E));
    const double w = 1 / (1 - e * std::cos(E));
    return {t, Eigen::Vector4d(std::cos(E) - e, b * std::sin(E), -w * std::sin(E), w * b * std::cos(E))};
}

}  // namespace

void compete_on_mechanics(const settings& set, std::vector<curve>& curves) {
    std::vector<reference_point> ellipse;
    for (int t = 1; t < 20; t += 2) ellipse.push_back(kepler_ellipse(t));
    compete(problems::kepler{}, reference("kepler"), set, curves, ellipse);
    const auto at = [&](const std::string& time) {
        return problems::stored_numbers(DATA_DIR "/../rolling_disc/data/disc.json", "/" + time + "/values");
    };
    compete(problems::rolling_disc{}, at("t=1.0"), set, curves, {{0.1, at("t=0.1")}, {0.5, at("t=0.5")}});
}
