// SPDX-License-Identifier: BSL-1.0
#include <problems/stored.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/mechanics/holonomic.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

#include "print_run.hpp"

namespace sc = stagecraft;
using Eigen::VectorXd;

void mechanics() {
    const auto T = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
    const auto V = [](const auto& q) { return 9.81 * (q[1] + q[3]); };
    const auto rods = [](const auto& q) {
        auto g = (0 * q.template head<2>()).eval();
        g[0] = q.template head<2>().squaredNorm() - 1;
        g[1] = (q.template tail<2>() - q.template head<2>()).squaredNorm() - 1;
        return g;
    };
    const auto model = sc::stabilised_index_2(sc::lagrangian<4, 2>(T, V, rods));
    const VectorXd end = problems::stored_numbers(DATA_DIR "/double_pendulum.json", "/y");
    print_run("mechanics", "double pendulum", "Radau IIA s = 3", sc::radau_iia<3>(), model,
              model.initial_state(Eigen::Vector4d(1, 0, 2, 0), Eigen::Vector4d::Zero()), 2, end);
}
