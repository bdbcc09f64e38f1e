// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <iosfwd>

#include <stagecraft/refuse/detect/refused_call.hpp>

namespace stagecraft {

/// The way g goes through zero as the run proceeds, which is backwards in time when t1 < t0.
enum class crossing { both, rising, falling };

/// An event that took place.
template <class Vector>
struct occurrence {
    int event;  ///< its place in the list given to events()
    typename Vector::Scalar t;
    Vector y;
    crossing direction;  ///< rising or falling
};

/// Not printed by <<.
template <class Traits, class Vector>
std::basic_ostream<char, Traits>& operator<<(std::basic_ostream<char, Traits>& out,
                                             const occurrence<Vector>&) {
    static_assert(detail::never<Vector>, "print the event's number o.event, its time o.t and its state o.y");
    return out;
}

}  // namespace stagecraft
