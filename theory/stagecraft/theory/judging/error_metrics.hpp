// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <stagecraft/tableaux/ball.hpp>
#include <stagecraft/theory/judging/subject.hpp>
#include <string>
#include <vector>

namespace stagecraft::theory {

/// The numbers by which Dormand and Prince compare embedded pairs (Prince-Dormand 1981; as Kennedy-Carpenter 2003 write them). Let
/// p be the lower of both orders, tau^(n) the error terms of order n ((elementary weight - 1/gamma)/sigma) of the method of the
/// higher order, taut^(n) those of the other one, norms the 2-norm:
/// A = |tau| of the first order that fails, B = |taut^(p+2)|/|taut^(p+1)|, C = |taut^(p+2) - tau^(p+2)|/|taut^(p+1)|,
/// E = |tau^(p+2)|/|taut^(p+1)|, and D the largest of |a_ij|, |b_i|, |c_i| of both. An estimate is good where B and C are near 1.
/// Four digits, or "not decided" where the data leave them open.
struct error_metrics {
    int order = 0;                          ///< the higher one
    int lower_order = 0;                    ///< p
    std::string A, A_embedded, B, C, D, E;  ///< A_embedded: |taut^(p+1)|
};

/// Of the tableau with weights b and b_embedded of these orders; nothing where both have the same or p + 2 is above 10. Exact
/// tableaux are looked at in enclosures of their entries. O(s^2) operations for each tree of at most p + 2 vertices.
std::optional<error_metrics> error_metrics_of(const subject<tableaux::ball>& s, int order,
                                              int embedded_order);

/// "error metrics: A^(6) = 0.0003991, A^(5) of the other = ..., B^(6) = ..., ...".
std::string text(const error_metrics& m);

nlohmann::ordered_json to_json(const error_metrics& m);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/error_metrics-inl.hpp"
#endif
