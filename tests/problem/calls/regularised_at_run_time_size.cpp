// SPDX-License-Identifier: BSL-1.0
// says: take regularised_position(model, q, eps, kappa, c, d)
// lines: 8
#include <stagecraft/mechanics/sized_formulations.hpp>

struct pendulum {
    int coordinates() const { return 2; }
    int constraints() const { return 1; }
    Eigen::MatrixXd M() const { return Eigen::MatrixXd::Identity(2, 2); }
    Eigen::VectorXd F(const Eigen::VectorXd&, const Eigen::VectorXd&) const { return Eigen::Vector2d(0, -1); }
    Eigen::MatrixXd G(const Eigen::VectorXd& q) const { return q.transpose(); }
};

auto size() { return stagecraft::regularised(pendulum(), 1e-8, 1, 2, 2).size(); }
