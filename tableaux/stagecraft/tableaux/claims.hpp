// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace stagecraft::tableaux {

/// The highest order that dense output may claim: the conditions on it are looked at to this order.
inline constexpr int largest_dense_order = 10;

/// What a tableau file claims about its method. Only what is stated is judged. `order` = p claims every order
/// condition up to p, but not that order p + 1 fails. `stage_order` = q claims B(q) and C(q); a file that
/// gives c claims c = A*1 with it, unless it states stage_order 0. `dense_order`: the order of b(theta) at every
/// theta; `dense_smoothness`: 0 continuous from step to step, 1 continuously differentiable. Of Rosenbrock methods `w_order` with
/// any matrix in place of the Jacobian, `index_1_order` for y' = f(y, z), 0 = g(y, z). `b`, `c` and `d`: B(p), C(q) and D(r);
/// `linear_order` for y' = A y; `weak_stage_order`: b^T A^j (k A c^(k-1) - c^k) = 0 for every j and k = 1, ..., q;
/// `effective_order`: the order of beta after the method before beta^-1 for some beta; `energy_order`: that of the change of the
/// energy of Hamiltonian systems. Numbers are written as entries are, or
/// "infinite": to the digits written, rounded or cut off; `alpha` in degrees.
struct claims {
    std::optional<int> order;
    std::optional<int> embedded_order;
    std::optional<int> stage_order;
    std::optional<int> dense_order;
    std::optional<int> dense_smoothness;
    std::optional<int> w_order;
    std::optional<int> index_1_order;
    std::optional<int> b;
    std::optional<int> c;
    std::optional<int> d;
    std::optional<int> linear_order;
    std::optional<int> weak_stage_order;
    std::optional<int> effective_order;
    std::optional<int> energy_order;
    std::optional<std::string> ssp_coefficient;
    std::optional<std::string> alpha;
    std::optional<std::string> real_interval;
    std::optional<std::string> imaginary_interval;
    std::optional<bool> a_stable;
    std::optional<bool> l_stable;
    std::optional<bool> algebraically_stable;
    std::optional<bool> symplectic;
    std::optional<bool> symmetric;
    std::optional<bool> stiffly_accurate;

    friend bool operator==(const claims&, const claims&) = default;
};

struct counted_claim {
    std::string_view name;  ///< key in the file
    std::optional<int> claims::*value;
};

struct yes_no_claim {
    std::string_view name;
    std::optional<bool> claims::*value;
};

struct number_claim {
    std::string_view name;  ///< key in the file
    std::optional<std::string> claims::*value;
};

inline constexpr std::array<counted_claim, 14> counted_claims{
    {{"order", &claims::order},
     {"embedded_order", &claims::embedded_order},
     {"stage_order", &claims::stage_order},
     {"dense_order", &claims::dense_order},
     {"dense_smoothness", &claims::dense_smoothness},
     {"w_order", &claims::w_order},
     {"index_1_order", &claims::index_1_order},
     {"B", &claims::b},
     {"C", &claims::c},
     {"D", &claims::d},
     {"linear_order", &claims::linear_order},
     {"weak_stage_order", &claims::weak_stage_order},
     {"effective_order", &claims::effective_order},
     {"energy_order", &claims::energy_order}}};

/// What R and the tableau are asked for in numbers.
inline constexpr std::array<number_claim, 4> number_claims{
    {{"ssp_coefficient", &claims::ssp_coefficient},
     {"alpha", &claims::alpha},
     {"real_interval", &claims::real_interval},
     {"imaginary_interval", &claims::imaginary_interval}}};
inline constexpr std::string_view infinite = "infinite";

/// Those that belong to Rosenbrock methods alone.
inline constexpr std::array<std::string_view, 2> rosenbrock_claims{"w_order", "index_1_order"};

/// Those that belong to a single tableau alone.
inline constexpr std::array<std::string_view, 11> single_claims{"B",
                                                                "C",
                                                                "D",
                                                                "linear_order",
                                                                "weak_stage_order",
                                                                "effective_order",
                                                                "energy_order",
                                                                "ssp_coefficient",
                                                                "alpha",
                                                                "real_interval",
                                                                "imaginary_interval"};

inline constexpr std::array<yes_no_claim, 6> yes_no_claims{
    {{"A_stable", &claims::a_stable},
     {"L_stable", &claims::l_stable},
     {"algebraically_stable", &claims::algebraically_stable},
     {"symplectic", &claims::symplectic},
     {"symmetric", &claims::symmetric},
     {"stiffly_accurate", &claims::stiffly_accurate}}};

}  // namespace stagecraft::tableaux
