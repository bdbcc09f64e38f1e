// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <stagecraft/break_points.hpp>
#include <utility>
#include <vector>

namespace problems::test_set {

/// A charge pump: an n-channel MOS transistor and two capacitors, described by charges (problem "pump" of Mazzia-Magherini
/// 2008; Günther, Denk and Feldmann's model of the transistor). M y' = f, n = 9: the charges of gate, source capacitor,
/// source, drain capacitor and drain, three voltages, and the current through the source of the input, of index 2. The charges
/// have kinks in the voltages, which no time tells, the input has corners, which break_points() tells.
///
/// Published in s, C and V; here in ns, pC, V and mA, so that time and the solution are of size 1.
struct charge_pump {
    static constexpr const char* name = "pump";
    static constexpr double t0 = 0, t1 = 1200;
    static constexpr double threshold = 0.2, gamma = 0.035, phi = 1.01, oxide = 4, source = 1.6, drain = 0.4;

    /// The input in V: 20 from 60 to 110 ns of each 120, corners at 50 and 120.
    static double pulse(double t) {
        const double s = std::fmod(t, 120.0);
        return s < 50 ? 0.0 : s < 60 ? 2 * (s - 50) : s < 110 ? 20.0 : 2 * (120 - s);
    }
    /// Charges of the gate, and of source and drain alike, for the voltages of the gate over bulk, source and drain.
    template <class S>
    static std::pair<S, S> charges(const S& bulk, const S& over_source, const S& over_drain) {
        using std::sqrt;
        const double flat = threshold - gamma * sqrt(phi) - phi;
        const S high = over_source > over_drain ? over_source : over_drain,
                low = over_source > over_drain ? over_drain : over_source;
        const S root = sqrt(S(phi - (high - bulk))), onset = threshold + gamma * (root - sqrt(phi));
        if (bulk <= flat) return {S(oxide * (bulk - flat)), S(0.0)};
        if (high <= onset)
            return {S(oxide * gamma * (sqrt(S(gamma * gamma / 4 + bulk - flat)) - gamma / 2)), S(0.0)};
        const S a = high - onset, b = low > onset ? S(low - onset) : S(0.0);
        const S channel = a + b - a * b / (a + b);
        return {S(oxide * (2.0 / 3.0 * channel + gamma * root)), S(-oxide / 3.0 * channel)};
    }

    void operator()(double t, const auto& y, auto& f) const {
        using S = typename std::decay_t<decltype(y)>::Scalar;
        const auto [at_gate, at_ends] = charges<S>(y[5], S(y[5] - y[6]), S(y[5] - y[7]));
        f[0] = -y[8];
        f[1] = f[2] = S(0.0);
        f[3] = pulse(t) - y[5];
        f[4] = y[0] - at_gate;
        f[5] = y[1] - source * y[6];
        f[6] = y[2] - at_ends;
        f[7] = y[3] - drain * y[7];
        f[8] = y[4] - at_ends;
    }
    Eigen::MatrixXd mass() const {
        Eigen::MatrixXd M = Eigen::MatrixXd::Zero(9, 9);
        M(0, 0) = M(1, 1) = M(1, 2) = M(2, 3) = M(2, 4) = 1;
        return M;
    }
    std::vector<int> index() const { return {1, 1, 1, 1, 1, 1, 1, 1, 2}; }
    static stagecraft::break_times<double> break_points() {
        return stagecraft::every(120.0, {50.0, 60.0, 110.0, 120.0});
    }
    Eigen::VectorXd initial() const {
        const auto [at_gate, at_ends] = charges(0.0, 0.0, 0.0);
        Eigen::VectorXd y = Eigen::VectorXd::Zero(9);
        y[0] = at_gate, y[2] = y[4] = at_ends;
        return y;
    }
    /// At t1, from the left. GAMD in quadruple precision; without voltage the charge of the gate, and its slope while the input
    /// falls by 2 V in a ns, are closed forms as well.
    Eigen::VectorXd reference() const {
        Eigen::VectorXd y = Eigen::VectorXd::Zero(9);
        y[0] = 0.126280042987675933170893, y[8] = 0.152255686815577679043511;
        return y;
    }
};

}  // namespace problems::test_set
