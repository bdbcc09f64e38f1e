// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace problems::test_set {

/// Water through 18 tubes between 13 nodes for 17 hours (problem "water" of Mazzia-Magherini 2008; de Swart's description).
/// M y' = f, n = 49: the flows in m^3/s and resistances of the tubes, the pressures in Pa of the two nodes with buffers, and
/// of the others, of index 2. Each tube turns from laminar to turbulent at a time that depends on the solution.
struct water_tubes {
    static constexpr const char* name = "water";
    static constexpr double t0 = 0, t1 = 17 * 3600;
    static constexpr int tubes = 18, nodes = 13;
    static constexpr double viscosity = 1.31e-6, gravity = 9.8, density = 1e3, critical = 2.3e3, length = 1e3,
                            roughness = 2e-4, diameter = 1, buffer = 200,
                            area = std::numbers::pi * diameter * diameter / 4;
    static constexpr double at_rest =
        0.47519404529185289807e-1;  ///< resistance of a tube at the critical flow

    /// From node to node, in the order of the unknowns; and the node of each pressure.
    static constexpr std::array<std::array<int, 2>, tubes> ends{{{1, 2},
                                                                 {2, 3},
                                                                 {2, 6},
                                                                 {3, 4},
                                                                 {3, 5},
                                                                 {4, 5},
                                                                 {5, 10},
                                                                 {6, 5},
                                                                 {7, 4},
                                                                 {7, 8},
                                                                 {8, 5},
                                                                 {8, 10},
                                                                 {9, 8},
                                                                 {11, 9},
                                                                 {11, 12},
                                                                 {12, 7},
                                                                 {12, 8},
                                                                 {13, 11}}};
    static constexpr std::array<int, nodes> order{5, 8, 1, 2, 3, 4, 6, 7, 9, 10, 11, 12, 13};

    void operator()(double t, const auto& y, auto& f) const {
        using S = typename std::decay_t<decltype(y)>::Scalar;
        using std::abs, std::log10, std::sqrt;
        std::array<S, nodes + 1> pressure, net;
        const double hours = t / 3600, in = 1 - std::cos(std::exp(-hours) - 1);
        for (int k = 0; k < nodes; ++k) pressure[order[k]] = y[2 * tubes + k];
        net.fill(S(0.0));
        net[1] += in / 200;
        net[13] += in / 80;
        net[10] -= hours * hours * (3 * hours * hours - 92 * hours + 720) / 1e6;
        for (int k = 0; k < tubes; ++k) {
            const auto [from, to] = ends[k];
            const S &flow = y[k], &resistance = y[tubes + k], root = sqrt(resistance);
            S reynolds = abs(flow) * (diameter / (viscosity * area));
            S loss = 32 * viscosity * density * length / (area * diameter * diameter) * flow;
            if (reynolds > critical)
                loss = density * length / (area * area * diameter) * resistance * flow * flow;
            else
                reynolds = S(critical);
            f[k] = pressure[from] - pressure[to] - loss;
            f[tubes + k] =
                1 / root - 1.74 + 2 * log10(S(2 * roughness / diameter + 18.7 / (reynolds * root)));
            net[from] -= flow;
            net[to] += flow;
        }
        for (int k = 0; k < nodes; ++k) f[2 * tubes + k] = net[order[k]];
    }
    Eigen::MatrixXd mass() const {
        Eigen::VectorXd m = Eigen::VectorXd::Zero(2 * tubes + nodes);
        m.head(tubes).setConstant(density * length / area);
        m.segment(2 * tubes, 2).setConstant(buffer / (density * gravity));
        return m.asDiagonal().toDenseMatrix();
    }
    std::vector<int> index() const {
        std::vector<int> flags(2 * tubes + 2, 1);
        flags.resize(2 * tubes + nodes, 2);
        return flags;
    }
    Eigen::VectorXd initial() const {
        Eigen::VectorXd y = Eigen::VectorXd::Zero(2 * tubes + nodes);
        y.segment(tubes, tubes).setConstant(at_rest);
        y.tail(nodes).setConstant(109800);
        return y;
    }
    /// atol / rtol of each component: pressures are large.
    Eigen::VectorXd scale() const {
        Eigen::VectorXd s = Eigen::VectorXd::Ones(2 * tubes + nodes);
        s.tail(nodes).setConstant(1e6);
        return s;
    }
    /// The published values at t1.
    Eigen::VectorXd reference() const {
        Eigen::VectorXd y(2 * tubes + nodes);
        y << 0.2298488296477430e-2, 0.1188984650746585e-2, 0.1109503645730845e-2, 0.1589620100314825e-3,
            0.1030022640715102e-2, 0.8710606306836165e-3, 0.3243571480903489e-2, 0.1109503645730845e-2,
            0.7120986206521341e-3, 0.6414613963833099e-3, 0.9416978549524347e-3, 0.3403428519096511e-2,
            0.2397639310739395e-2, 0.2397639310739395e-2, 0.3348581430454180e-2, 0.1353560017035444e-2,
            0.1995021413418736e-2, 0.5746220741193575e-2, at_rest, at_rest, at_rest, at_rest, at_rest,
            at_rest, 0.4311196778792902e-1, at_rest, at_rest, at_rest, at_rest, 0.4249217433601160e-1,
            0.4732336439609648e-1, 0.4732336439609648e-1, 0.4270002118868241e-1, at_rest, at_rest,
            0.3651427026675656e-1, 0.1111268591478108e6, 0.1111270045592387e6, 0.1111271078730254e6,
            0.1111269851929858e6, 0.1111269255355337e6, 0.1111269322658045e6, 0.1111269221703983e6,
            0.1111270121140691e6, 0.1111274419515807e6, 0.1111255158881087e6, 0.1111278793439227e6,
            0.1111270995171642e6, 0.1111298338971779e6;
        return y;
    }
};

}  // namespace problems::test_set
