// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace stagecraft::tableaux {

/// The highest order that dense output may claim: the conditions on it are looked at to this order.
inline constexpr int largest_dense_order = 10;

/// What a tableau file claims about its method. Only what is stated is judged. `order` = p claims every order
/// condition up to p, but not that order p + 1 fails. `stage_order` = q claims B(q) and C(q); a file that
/// gives c claims c = A*1 with it, unless it states stage_order 0. `dense_order`: the order of b(theta) at every
/// theta; `dense_smoothness`: 0 continuous from step to step, 1 continuously differentiable. Of Rosenbrock methods `w_order` with
/// any matrix in place of the Jacobian, `index_1_order` for y' = f(y, z), 0 = g(y, z).
struct claims {
    std::optional<int> order;
    std::optional<int> embedded_order;
    std::optional<int> stage_order;
    std::optional<int> dense_order;
    std::optional<int> dense_smoothness;
    std::optional<int> w_order;
    std::optional<int> index_1_order;
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

inline constexpr std::array<counted_claim, 7> counted_claims{{{"order", &claims::order},
                                                              {"embedded_order", &claims::embedded_order},
                                                              {"stage_order", &claims::stage_order},
                                                              {"dense_order", &claims::dense_order},
                                                              {"dense_smoothness", &claims::dense_smoothness},
                                                              {"w_order", &claims::w_order},
                                                              {"index_1_order", &claims::index_1_order}}};

/// Those that belong to Rosenbrock methods alone.
inline constexpr std::array<std::string_view, 2> rosenbrock_claims{"w_order", "index_1_order"};

inline constexpr std::array<yes_no_claim, 6> yes_no_claims{
    {{"A_stable", &claims::a_stable},
     {"L_stable", &claims::l_stable},
     {"algebraically_stable", &claims::algebraically_stable},
     {"symplectic", &claims::symplectic},
     {"symmetric", &claims::symmetric},
     {"stiffly_accurate", &claims::stiffly_accurate}}};

}  // namespace stagecraft::tableaux
