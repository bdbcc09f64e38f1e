// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <string>

namespace thesis {

inline constexpr double radius = 0.1;  // of the disc [m]
inline constexpr int corners = 36;     // of the polygon that is drawn for its rim

using point = Eigen::Vector3d;

// The disc in the laboratory frame: contact point, direction of rolling, and from the contact point to the centre.
struct placed {
    point contact, ahead, up;
    double turned;
    explicit placed(const Eigen::VectorXd& y) : turned(y[4]) {
        const double c = std::cos(y[2]), s = std::sin(y[2]);
        contact = {c * y[0] - s * y[1], s * y[0] + c * y[1], 0};
        ahead = {c, s, 0};
        up = {s * std::sin(y[3]), -c * std::sin(y[3]), std::cos(y[3])};
    }
    point rim(double angle) const {
        return contact + radius * (up + std::cos(angle) * ahead + std::sin(angle) * up);
    }
    // A spoke that pointed upwards at the start.
    point mark() const { return rim(std::acos(-1.0) / 2 - turned); }
    point centre() const { return contact + radius * up; }
};

/// Seen from above at an angle: right and up.
inline Eigen::Vector2d seen(const point& p) {
    const double turn = 0.5, tilt = 0.6;  // [rad]
    const double right = std::cos(turn) * p[0] + std::sin(turn) * p[1],
                 away = -std::sin(turn) * p[0] + std::cos(turn) * p[1];
    return {right, std::sin(tilt) * away + std::cos(tilt) * p[2]};
}

/// The disc with its coordinates x, y, alpha, beta, gamma: an SVG file.
std::string disc_sketch();

}  // namespace thesis
