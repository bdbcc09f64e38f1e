// SPDX-License-Identifier: BSL-1.0
// The thesis' rolling disc as index-2 system, with what the peers want to know of it.
#pragma once

#include <array>
#include <stagecraft/mechanics/formulations.hpp>

#include <problems/rolling_disc/disc.hpp>

namespace problems {

struct rolling_disc {
    using dae = decltype(stagecraft::index_2(::rolling_disc::disc<>{}));
    static constexpr const char* name = "disc";
    static constexpr int size = dae::size, second_order_components = dae::n;
    static constexpr double t0 = 0, t1 = 1, atol_scale = 1;
    dae system = stagecraft::index_2(::rolling_disc::disc<>{});

    Eigen::Matrix<double, size, 1> initial() const {
        return system.initial_state(::rolling_disc::initial_position(), ::rolling_disc::initial_velocity());
    }
    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, size, 1>& y, Eigen::Matrix<S, size, 1>& f) const {
        system(t, y, f);
    }
    void jacobian(double t, const Eigen::Matrix<double, size, 1>& y,
                  Eigen::Matrix<double, size, size>& J) const {
        system.jacobian(t, y, J);
    }
    Eigen::Matrix<double, size, size> mass() const { return system.mass(); }
    std::array<int, size> index() const { return system.index(); }
};

}  // namespace problems
