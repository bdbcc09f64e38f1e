// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/coefficients/unpack.hpp>
#include <stagecraft/method/nystrom_method.hpp>
#include <stagecraft/method/partitioned_method.hpp>

namespace stagecraft::coefficients {

/// The pair of tableaux, or the Nystrom method, that the arrays of a generated `Data` hold.
template <class Method, class Data>
Method unpack_pair() {
    constexpr int s = Data::stages;
    Method m;
    if constexpr (requires { m.A_bar; }) {
        unpack(Data::c, m.c);
        unpack(Data::A_bar, m.A_bar);
        unpack(Data::b_bar, m.b_bar);
        unpack(Data::b, m.b);
        if constexpr (requires { Data::b_embedded; }) {
            m.b_bar_embedded.resize(s);
            m.b_embedded.resize(s);
            unpack(Data::b_bar_embedded, m.b_bar_embedded);
            unpack(Data::b_embedded, m.b_embedded);
        }
        if constexpr (requires { m.A; }) unpack(Data::A, m.A);
        m.order = Data::order;
    } else {
        unpack(Data::c, m.first.c);
        unpack(Data::A, m.first.A);
        unpack(Data::b, m.first.b);
        unpack(Data::c_hat, m.second.c);
        unpack(Data::A_hat, m.second.A);
        unpack(Data::b_hat, m.second.b);
        m.first.facts.order = m.second.facts.order = Data::order;
        m.separable = Method::for_separable;
    }
    return m;
}

}  // namespace stagecraft::coefficients
