// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <stagecraft/tableaux/claims.hpp>
#include <stagecraft/tableaux/tableau_file.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace stagecraft::tableaux {

/// How several tableaux with the same number of stages belong together.
enum class coupling {
    additive,     ///< y' = f_1(y) + f_2(y) + ..., implicit-explicit methods above all
    partitioned,  ///< y' = f(y, z), z' = g(y, z): the first tableau for y, the second for z
    separable,    ///< y' = f(z), z' = g(y)
    nystrom,      ///< y'' = f(t, y), or y'' = f(t, y, y') where the file has A
    rosenbrock  ///< linearly implicit: alpha, which the values of f take, and Gamma, which stands at the Jacobian
};

struct named_coupling {
    std::string_view name;  ///< "form" in the file
    tableaux::coupling value;
};
inline constexpr std::array<named_coupling, 5> couplings{{{"additive", coupling::additive},
                                                          {"partitioned", coupling::partitioned},
                                                          {"separable", coupling::separable},
                                                          {"nystrom", coupling::nystrom},
                                                          {"rosenbrock", coupling::rosenbrock}}};

constexpr std::string_view name(coupling c) {
    for (const auto& each : couplings)
        if (each.value == c) return each.name;
    return {};
}

/// A method of several tableaux as a file gives it. A Nystrom method has two: A_bar, b_bar, which make y from
/// h^2 f, and A, b, which make y' from h f; both have its c. A Rosenbrock method has two: alpha, b, c (the times of the stages, or
/// empty), and Gamma, whose c are the factors of f_t. Transformed, as codes have it (Hairer-Wanner II.IV.7), they hold a, m in place
/// of alpha, b and C with gamma on its diagonal in place of Gamma.
struct partitioned_file {
    std::string name;
    std::string source;
    tableaux::coupling coupling = coupling::additive;
    std::vector<tableau_file> partners;
    bool uses_velocity = false;  ///< Nystrom: f depends on y', A is given
    bool transformed = false;    ///< Rosenbrock: a, C, gamma, m are given
    bool one_gamma = false;      ///< Rosenbrock: the diagonal is a single number of the file
    bool difference = false;     ///< Rosenbrock: b_embedded holds e, the weights less the embedded ones
    tableaux::claims claims;     ///< on the whole: orders, symplectic

    int stages() const { return partners.front().stages(); }

    /// All entries together.
    number_kind kind() const;
};

/// What a message calls the k-th tableau: its name, or its number.
std::string partner_name(const partitioned_file& file, std::size_t k);

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/partitioned_file-inl.hpp"
#endif
