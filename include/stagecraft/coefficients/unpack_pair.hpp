// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/coefficients/unpack.hpp>
#include <stagecraft/method/additive_method.hpp>
#include <stagecraft/method/nystrom_method.hpp>
#include <stagecraft/method/partitioned_method.hpp>

namespace stagecraft::coefficients {

/// The arrays of a generated `Data` with two tableaux.
template <class Data, class First, class Second>
void unpack_both(First& first, Second& second) {
    unpack(Data::c, first.c);
    unpack(Data::A, first.A);
    unpack(Data::b, first.b);
    unpack(Data::c_hat, second.c);
    unpack(Data::A_hat, second.A);
    unpack(Data::b_hat, second.b);
    first.facts.order = second.facts.order = Data::order;
}

/// The additive method, the pair of tableaux, or the Nystrom method, that the arrays of a generated `Data` hold.
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
    } else if constexpr (requires { m.explicit_part; }) {
        unpack_both<Data>(m.explicit_part, m.implicit_part);
        if constexpr (Data::embedded_order > 0) {
            m.explicit_part.b_embedded.resize(s);
            m.implicit_part.b_embedded.resize(s);
            unpack(Data::b_embedded, m.explicit_part.b_embedded);
            unpack(Data::b_hat_embedded, m.implicit_part.b_embedded);
        }
        m.order = Data::order;
        m.embedded_order = Data::embedded_order;
    } else {
        unpack_both<Data>(m.first, m.second);
        m.separable = Method::for_separable;
    }
    return m;
}

}  // namespace stagecraft::coefficients
