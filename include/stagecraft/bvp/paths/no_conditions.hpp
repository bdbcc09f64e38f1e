// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>

namespace stagecraft::detail {

/// Conditions that nobody asks for, where f alone is looked at.
struct no_conditions {
    template <class Y, class P, class R>
    void operator()(const Y& left, const Y&, const P&, R& r) const {
        for (Eigen::Index i = 0; i < r.size(); ++i) r[i] = left[0];
    }
};

}  // namespace stagecraft::detail
