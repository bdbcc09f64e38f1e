// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include <stagecraft/method/low_storage_method.hpp>

namespace stagecraft::coefficients {

/// The registers that the arrays of a generated `Data` hold, and the tableau that they mean.
template <class Scalar, class Data>
low_storage_method<Scalar> unpack_low_storage() {
    std::vector<std::vector<Scalar>> rows(Data::lists);
    const double* next = Data::rows;
    for (auto& row : rows)
        for (int j = 0; j < Data::stages; ++j) row.push_back(Scalar(*next++));
    low_storage_method<Scalar> m{Data::form, rows, detail::expanded(Data::form, rows)};
    if constexpr (requires { Data::b_embedded; }) {
        m.meaning.b_embedded.resize(Data::stages);
        for (int j = 0; j < Data::stages; ++j) m.meaning.b_embedded[j] = Scalar(Data::b_embedded[j]);
    }
    m.meaning.facts.order = Data::order;
    return m;
}

}  // namespace stagecraft::coefficients
