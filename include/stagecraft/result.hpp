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
    /// What a callable threw (function_threw), or what there is to say of chattering and constraints_dependent; else null.
    std::exception_ptr exception;

    bool ok() const { return status == status::success; }
};

}  // namespace stagecraft
