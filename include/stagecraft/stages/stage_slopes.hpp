// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>
#include <utility>

#include <stagecraft/linear/combinations.hpp>
#include <stagecraft/linear/lanes.hpp>
#include <stagecraft/linear/mass_solver.hpp>
#include <stagecraft/tableau.hpp>

namespace stagecraft {

/// What the stages of a plain tableau are computed into: the slopes k_i with M k_i = f(t + c_i h, Y_i),
/// Y_i = y + h sum_j a_ij k_j. They exist for every A; for an implicit stage k_i is found from Y_i, not from
/// f, so that stiffness does not magnify what Newton's iteration leaves.
///
/// The first stage may be the left end of the step (first row of A and c_1 zero). With a singular M its slope
/// is not determined by f, but M k_1 = f(t, y) is all that the other stages ask for. `by_value` then is true,
/// `left` holds M k_1, the slopes are those that k_1 = 0 would give, and the true ones obey
/// M k_i = M k.col(i) + carry[i] left.
template <class Vector, int Stages, class Blocks>
struct stage_slopes {
    using vector = Vector;
    using Scalar = typename Vector::Scalar;
    static constexpr int N = Vector::RowsAtCompileTime;

    stage_slopes(const tableau<Scalar, Stages>& m, int n) : method(m), k(n, m.stages()), left(n) {
        k.setZero();
        left.setZero();
        carry.setZero(m.stages());
    }

    int first_needed() const { return by_value ? 1 : 0; }

    /// r := h sum over j < last of coefficient(j) k_j.
    template <class Coefficients>
    void combine(const Coefficients& coefficient, int last, const Scalar& h, vector& r) const {
        if constexpr (built_in<Scalar> && fits_lanes<N>) {
            lanes<Scalar, N> sum{};
            if constexpr (Stages > 0)
                if (last == Stages && !by_value) {  // to look for zeros would take as long as to add them
                    [&]<int... j>(std::integer_sequence<int, j...>) {
                        (sum.add(h * coefficient(j), k.data() + j * N), ...);
                    }
                    (std::make_integer_sequence<int, Stages>());
                    sum.store(r.data());
                    return;
                }
            for (int j = first_needed(); j < last; ++j) {
                const Scalar a = coefficient(j);
                if (!(a == Scalar(0))) sum.add(h * a, k.data() + j * N);
            }
            sum.store(r.data());
            return;
        }
        std::array<combination_term<Scalar>, combined_terms> term;
        const int n = static_cast<int>(r.size());
        std::size_t count = 0;
        bool begun = false;
        const auto sum = [&] {
            const std::span<const combination_term<Scalar>> terms(term.data(), count);
            if (begun)
                combine_terms<true>(n, terms, h, k.data(), r.data(), r.data());
            else
                combine_terms<false>(n, terms, h, k.data(), r.data(), r.data());
            begun = true;
            count = 0;
        };
        for (int j = first_needed(); j < last; ++j) {
            const Scalar a = coefficient(j);
            if (a == Scalar(0)) continue;
            if (count == combined_terms) sum();
            term[count++] = {a, static_cast<std::ptrdiff_t>(j) * n};
        }
        if (count > 0)
            sum();
        else
            r.setZero();
    }

    tableau<Scalar, Stages> method;
    Eigen::Matrix<Scalar, N, Stages> k;
    vector left;
    Eigen::Matrix<Scalar, Stages, 1> carry;
    bool left_stage = false;  ///< the first stage is the left end; k_1 (or left) is known beforehand
    bool by_value = false;
    bool guessed = false;  ///< the stepper has given a first guess
    mass_solver<Scalar, Blocks> mass;
};

}  // namespace stagecraft
