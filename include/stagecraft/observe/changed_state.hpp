// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

namespace stagecraft::detail {

/// Lets action(t, y) change y. std::invalid_argument, which begins with `who`, where it leaves y not finite or of another
/// size; y is then as before.
template <class Action, class Scalar, class Vector>
void change_by(Action& action, const Scalar& t, Vector& y, const std::string& who) {
    const Vector before = y;
    action(t, y);
    bool good = y.size() == before.size();
    for (Eigen::Index i = 0; good && i < y.size(); ++i) good = y[i] - y[i] == Scalar(0);
    if (good) return;
    std::ostringstream message;
    message.precision(std::numeric_limits<Scalar>::max_digits10);
    message << who << " must leave y finite and of the same size, at t = " << t;
    y = before;
    throw std::invalid_argument(message.str());
}

}  // namespace stagecraft::detail
