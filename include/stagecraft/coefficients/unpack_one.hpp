// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <limits>

#include <stagecraft/coefficients/unpack.hpp>

namespace stagecraft::coefficients {

/// The tableau that the arrays of a generated `Data` hold, with its order; what else is known of it the file's certificate says.
template <class Tableau, class Data>
Tableau unpack_one() {
    Tableau m;
    m.A.resize(Data::stages, Data::stages);
    m.b.resize(Data::stages);
    m.c.resize(Data::stages);
    unpack(Data::A, m.A);
    unpack(Data::b, m.b);
    unpack(Data::c, m.c);
    if constexpr (requires { Data::b_embedded; }) {
        m.b_embedded.resize(Data::stages);
        unpack(Data::b_embedded, m.b_embedded);
    }
    m.facts.order = Data::order;
    m.facts.r_infinity = std::numeric_limits<double>::quiet_NaN();
    return m;
}

}  // namespace stagecraft::coefficients
