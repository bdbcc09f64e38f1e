// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <stagecraft/method/storage_form.hpp>
#include <stagecraft/tableau.hpp>

namespace stagecraft {

/// An explicit method by the registers that its steps overwrite. Made by low_storage().
template <class Scalar>
struct low_storage_method {
    using scalar = Scalar;
    storage_form form;
    std::vector<std::vector<Scalar>> rows;  ///< as registers_of takes them
    tableau<Scalar> meaning;  ///< the same method as A, b, c, with b_embedded where there is one

    int stages() const { return meaning.stages(); }
};

namespace detail {

/// std::invalid_argument where the lists do not belong together.
template <class Scalar>
void check_storage(storage_form form, const std::vector<std::vector<Scalar>>& rows) {
    const auto demand = [](bool good, const char* what) {
        if (!good) throw std::invalid_argument(std::string("low_storage(form, rows): ") + what);
    };
    const bool shu_osher = form == storage_form::shu_osher;
    const std::size_t lists = form == storage_form::williamson        ? 2
                              : form == storage_form::ketcheson       ? 4
                              : form == storage_form::ketcheson_three ? 5
                                                                      : rows.size();
    demand(
        !rows.empty() && rows.size() == lists && !(shu_osher && rows.size() % 2 == 1),
        "rows must be A and B (2N), gamma1, gamma2, delta and beta (2S), gamma1, gamma2, gamma3, delta and "
        "beta (3S*), or the rows of alpha and those of beta");
    const std::size_t s = shu_osher ? rows.size() / 2 : rows.front().size();
    bool good = s > 0;
    for (const auto& row : rows) {
        good = good && row.size() == s;
        for (const Scalar& x : row) good = good && x - x == Scalar(0);
    }
    demand(good, "the lists must be finite and have the same length, the number of stages");
}

/// The tableau that the registers mean; c are the row sums.
template <class Scalar>
tableau<Scalar> expanded(storage_form form, const std::vector<std::vector<Scalar>>& rows) {
    const auto registers = registers_of(form, rows);
    const int s = static_cast<int>(registers.size()) - 1;
    tableau<Scalar> t;
    t.A.setZero(s, s), t.b.setZero(s), t.c.setZero(s);
    for (int i = 0; i <= s; ++i) {
        const auto& r = registers[static_cast<std::size_t>(i)];
        const Scalar off = r.u - Scalar(1);
        if (off * off > Scalar(1) / Scalar(1 << 20))
            throw std::invalid_argument(
                "low_storage(form, rows): a stage does not contain the value at the beginning once");
        for (int j = 0; j < s; ++j) (i < s ? t.A(i, j) : t.b[j]) = r.f[static_cast<std::size_t>(j)];
    }
    t.c = t.A.rowwise().sum();
    return t;
}

}  // namespace detail

}  // namespace stagecraft
