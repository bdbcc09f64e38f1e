// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <stagecraft/method/dense_method.hpp>
#include <stagecraft/tableaux/tableau_file.hpp>
#include <stagecraft/tableaux/tableau_from_file.hpp>
#include <stdexcept>

namespace stagecraft::tableaux {

/// The tableau of a file with its b_theta, each entry rounded once to a Real. Last stages that neither b nor b_embedded asks for,
/// and that are explicit, are further stages. std::invalid_argument where the file has no b_theta.
template <class Real = double>
dense_method<Real> dense_method_of(const tableau_file& file) {
    if (file.b_theta.empty()) throw std::invalid_argument("dense_method_of: the file has no b_theta");
    const tableau<Real> whole = rounded<Real>(file);
    const int all = whole.stages();
    const auto serves_output_alone = [&](int i) {
        bool alone = whole.b[i] == Real(0) && (file.b_embedded.empty() || whole.b_embedded[i] == Real(0));
        for (int j = 0; j < all; ++j)
            alone = alone && (j < i || whole.A(i, j) == Real(0)) && (j > i || whole.A(j, i) == Real(0));
        return alone;
    };
    int s = all;
    while (s > 1 && serves_output_alone(s - 1)) --s;
    const auto head = [&](const auto& x) {
        return x.size() == 0 ? x : decltype(whole.b_embedded)(x.head(s));
    };
    dense_method<Real> m;
    m.method = {whole.A.topLeftCorner(s, s), whole.b.head(s), whole.c.head(s), head(whole.b_embedded),
                whole.facts};
    m.A_more = whole.A.bottomRows(all - s);
    m.c_more = whole.c.tail(all - s);
    std::size_t degree = 0;
    for (const auto& row : file.b_theta) degree = std::max(degree, row.size());
    m.b_theta.setZero(all, static_cast<int>(degree));
    for (std::size_t i = 0; i < file.b_theta.size(); ++i)
        for (std::size_t k = 0; k < file.b_theta[i].size(); ++k)
            m.b_theta(static_cast<int>(i), static_cast<int>(k)) = rounded<Real>(file.b_theta[i][k]);
    m.dense_order = file.claims.dense_order.value_or(0);
    return m;
}

}  // namespace stagecraft::tableaux
