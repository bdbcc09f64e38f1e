// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/dynamics/one_sided_lipschitz.hpp"

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

namespace detail {

STAGECRAFT_INLINE std::string text(const std::vector<rational>& x) {
    std::string out;
    for (const auto& a : x) out += (out.empty() ? "(" : ", ") + a.str();
    return out + ")";
}

STAGECRAFT_INLINE one_sided_constant found(const std::string& where, supremum s, std::vector<rational> point,
                                           bool exactly) {
    const std::string value = s.low == s.high ? s.low.str()
                                              : "between " + shortest(interval(s.low).low()) + " and " +
                                                    shortest(interval(s.high).high());
    const std::string at = point.empty() ? "approached at infinity"
                                         : (exactly ? "attained at " : "attained near ") + text(point);
    return {verdict::proved(where + ": " + value + ", " + at), s.low, s.high, std::move(point)};
}

STAGECRAFT_INLINE std::map<multinomial::monomial, dense<rational>> by_monomial(const dense<multinomial>& S) {
    std::map<multinomial::monomial, dense<rational>> parts;
    const dense<rational> zero = dense<rational>::Constant(S.rows(), S.cols(), rational(0));
    parts.try_emplace({}, zero);
    for (Eigen::Index i = 0; i < S.size(); ++i)
        for (const auto& [m, a] : S.data()[i].terms()) parts.try_emplace(m, zero).first->second.data()[i] = a;
    return parts;
}

}  // namespace detail

namespace detail {

STAGECRAFT_INLINE rational near_inverse_root(const rational& p) {
    const int half = tableaux::binary_exponent(p) / 2;
    const double near_one = tableaux::scaled(p, -2 * half).to<double>();
    return tableaux::scaled(theory::exactly(1 / std::sqrt(near_one)), -half);
}

}  // namespace detail

}  // namespace stagecraft::theory
