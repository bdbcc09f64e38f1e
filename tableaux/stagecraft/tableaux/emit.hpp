// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <stagecraft/tableau.hpp>
#include <stagecraft/tableaux/family.hpp>
#include <string>

namespace stagecraft::tableaux {

/// Whether the members of a family have a regular A, so that A^-1 and T exist.
constexpr bool has_regular_matrix(family f) {
    return f == family::gauss || f == family::radau_ia || f == family::radau_iia || f == family::lobatto_iiic;
}

/// A double as a hexadecimal literal that any compiler reads back to the same bits.
std::string hexadecimal(double x);

namespace emitting {

/// One constexpr array, row by row.
template <class Matrix>
std::string array(const char* name, const Matrix& m) {
    if (m.size() == 0) return "";
    std::string out = std::string("    static constexpr double ") + name + "[] = {";
    const Eigen::Index rows = m.cols() == 1 ? 1 : m.rows();
    for (Eigen::Index i = 0; i < rows; ++i) {
        out += "\n        ";
        const Eigen::Index n = m.cols() == 1 ? m.rows() : m.cols();
        for (Eigen::Index j = 0; j < n; ++j)
            out += hexadecimal(m.cols() == 1 ? m(j, 0) : m(i, j)) + (i + 1 == rows && j + 1 == n ? ""
                                                                     : j + 1 == n                ? ","
                                                                                                 : ", ");
    }
    return out + "};\n";
}

std::string facts(const stagecraft::facts& f);

}  // namespace emitting

/// The header include/stagecraft/coefficients/<family>.hpp: s = least..most stages as constexpr arrays of
/// doubles, each the nearest to the exact number, with what `facts_of(s)` says has been proved. The first
/// line is the command that writes it. Throws as `transformed` does.
std::string coefficient_header(family f, int most, const std::function<stagecraft::facts(int)>& facts_of);

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/emit-inl.hpp"
#endif
