// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stdexcept>
#include <string>

/// What the exception of call() says, by default of an argument that it refuses.
template <class Exception = std::invalid_argument, class F>
std::string message(F call) {
    try {
        call();
    } catch (const Exception& e) {
        return e.what();
    }
    return "no exception";
}
