// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <exception>

#include <stagecraft/report.hpp>
#include <stagecraft/status.hpp>

namespace stagecraft {

/// What a run returns: the last accepted state (status::event: the state at the event), always finite, and
/// why it ended. Only status::success means t = t1.
template <class Vector>
struct result {
    typename Vector::Scalar t;
    Vector y;
    stagecraft::status status;
    stagecraft::report<typename Vector::Scalar> report;
    std::exception_ptr exception;  ///< what a callable threw (status::function_threw), else null

    bool ok() const { return status == status::success; }
};

}  // namespace stagecraft
