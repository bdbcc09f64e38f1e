// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace stagecraft {

/// How an explicit method is written by what a step overwrites (registers_of says what each computes).
enum class storage_form {
    shu_osher,       ///< alpha and beta, row by row
    williamson,      ///< 2N: A and B
    ketcheson,       ///< 2S: gamma1, gamma2, delta and beta
    ketcheson_three  ///< 3S*: gamma1, gamma2, gamma3, delta and beta
};

/// u + h sum_k f_k F_k, where u stands for the value at the beginning: a register of such a code.
template <class N>
struct stage_register {
    N u{0};
    std::vector<N> f;

    static stage_register nothing(std::size_t s) { return {N(0), std::vector<N>(s, N(0))}; }
    static stage_register old_value(std::size_t s) { return {N(1), std::vector<N>(s, N(0))}; }
    stage_register& add(const N& factor, const stage_register& other) {
        u = u + factor * other.u;
        for (std::size_t k = 0; k < f.size(); ++k) f[k] = f[k] + factor * other.f[k];
        return *this;
    }
    stage_register& add_slope(std::size_t k, const N& factor) {
        f[k] = f[k] + factor;
        return *this;
    }
};

/// The stages of a step and, last, its result, from the coefficients as numbers, a list in the order of storage_form, Shu-Osher:
/// the rows of alpha, then those of beta. Shu and Osher 1988: u_0 = u, u_i = sum_{k<i} (alpha_ik u_k + h beta_ik f(u_k)),
/// i = 1..s. Williamson 1980 (2N): v_i = A_i v_{i-1} + h f(u_{i-1}), u_i = u_{i-1} + B_i v_i. Ketcheson 2010 (2S): v = 0;
/// for i = 1..s: v += delta_i u; u = gamma1_i u + gamma2_i v + beta_i h f(u). 3S*: gamma3_i times the value at the
/// beginning besides.
template <class N>
std::vector<stage_register<N>> registers_of(storage_form form, const std::vector<std::vector<N>>& rows) {
    using value = stage_register<N>;
    const std::size_t s = form == storage_form::shu_osher ? rows.size() / 2 : rows.front().size();
    std::vector<value> all{value::old_value(s)};
    value v = value::nothing(s);
    for (std::size_t i = 0; i < s; ++i) {
        const value& u = all.back();
        value next = value::nothing(s);
        if (form == storage_form::shu_osher) {
            for (std::size_t k = 0; k <= i; ++k) next.add(rows[i][k], all[k]).add_slope(k, rows[s + i][k]);
        } else if (form == storage_form::williamson) {
            v = value::nothing(s).add(rows[0][i], v).add_slope(i, N(1));
            next.add(N(1), u).add(rows[1][i], v);
        } else {
            const bool three = form == storage_form::ketcheson_three;
            v.add(rows[three ? 3 : 2][i], u);
            next.add(rows[0][i], u).add(rows[1][i], v).add_slope(i, rows[three ? 4 : 3][i]);
            if (three) next.add(rows[2][i], all.front());
        }
        all.push_back(std::move(next));
    }
    return all;
}

}  // namespace stagecraft
