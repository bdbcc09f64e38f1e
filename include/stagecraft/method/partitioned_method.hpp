// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <string>

#include <stagecraft/tableau.hpp>

namespace stagecraft {

/// Two tableaux of the same number of stages: `first` for q, `second` for p, of
///
///     q' = f(t, q, p), p' = g(t, q, p)
///     Q_i = q + h sum_j a_ij k_j,  P_i = p + h sum_j a^_ij l_j,  k_i = f(Q_i, P_i),  l_i = g(Q_i, P_i)
///
/// (Hairer-Lubich-Wanner, section II.2). What belongs to the second tableau has a hat in formulas. Made by partitioned(first, second).
template <class Scalar, int Stages = dynamic>
struct partitioned_method {
    using scalar = Scalar;
    static constexpr int stages_at_compile_time = Stages;
    static constexpr bool for_separable = false;
    tableau<Scalar, Stages> first, second;
    /// The order holds for f(t, p) and g(t, q) alone (trees of alternating colours); a run with others is refused.
    bool separable = false;

    int stages() const { return first.stages(); }
};

/// The same, known at compile time to be for f(t, p) and g(t, q) alone: others do not compile. Made by
/// separable(first, second).
template <class Scalar, int Stages = dynamic>
struct separable_method : partitioned_method<Scalar, Stages> {
    static constexpr bool for_separable = true;
};

namespace detail {

/// The number of stages of both, the one that is known at compile time where one is.
template <int First, int Second>
inline constexpr int common_stages = First == dynamic ? Second : First;

template <class Scalar, int To, int From>
tableau<Scalar, To> with_stages(const tableau<Scalar, From>& m) {
    tableau<Scalar, To> r;
    r.A = m.A;
    r.b = m.b;
    r.c = m.c;
    r.b_embedded = m.b_embedded;
    r.facts = m.facts;
    return r;
}

/// Of the base class that both kinds of pair have.
template <class Method, class Scalar, int First, int Second>
Method pair_of(const tableau<Scalar, First>& first, const tableau<Scalar, Second>& second, const char* who,
               bool separable) {
    constexpr int s = Method::stages_at_compile_time;
    for (const int stages : {first.stages(), second.stages()})
        if (s != dynamic && stages != s)
            throw std::invalid_argument(std::string(who) + ": both tableaux must have " + std::to_string(s) +
                                        " stages, not " + std::to_string(stages));
    if (first.stages() != second.stages())
        throw std::invalid_argument(std::string(who) + ": the first tableau has " +
                                    std::to_string(first.stages()) + " stages and the second " +
                                    std::to_string(second.stages()) + "; both must have the same number");
    Method m;
    m.first = with_stages<Scalar, s>(first);
    m.second = with_stages<Scalar, s>(second);
    m.separable = separable;
    return m;
}

}  // namespace detail

}  // namespace stagecraft
