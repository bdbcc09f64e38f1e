// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/enclosed_stability.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/routh_hurwitz.hpp"
#include "stagecraft/theory/judging/rounded_properties.hpp"
#include "stagecraft/theory/judging/subject_spectrum.hpp"
#include "stagecraft/theory/stability/enclosed_signs.hpp"
#include "stagecraft/theory/stability/sector_stability.hpp"
#include "stagecraft/theory/statements/certainty.hpp"

namespace stagecraft::theory {

namespace detail {

STAGECRAFT_INLINE std::string in_format(const char* format, bound x) {
    char text[48];
    std::snprintf(text, sizeof text, format, x);
    return text;
}

STAGECRAFT_INLINE std::string in_digits(const number_range& x) {
    const bound width = (x.high - x.low) / x.high;
    if (width <= 1e-10L) return in_format("%.12Lg", (x.low + x.high) / 2);
    const int digits = std::clamp(static_cast<int>(3 - std::log10(width)), 3, 12);
    const std::string format = "%." + std::to_string(digits) + "Lg";
    const bound outward = std::pow(bound(10), 1 - digits);
    return in_format(format.c_str(), x.low * (1 - outward)) + " to " +
           in_format(format.c_str(), x.high * (1 + outward));
}

STAGECRAFT_INLINE std::string between(const number_range& x) {
    return "between " + in_format("%.15Lg", x.low * (1 - 2e-15L)) + " and " +
           in_format("%.15Lg", x.high * (1 + 2e-15L));
}

/// What equalities a verdict rests on that the digits leave open, and how far.
struct assumptions {
    std::string text;
    bound residual = 0, bound_on_it = 0;

    void add(const std::string& what, bound left, bound uncertainty) {
        text += (text.empty() ? "" : " and ") + what;
        residual = std::max(residual, left);
        bound_on_it = std::max(bound_on_it, uncertainty);
    }
    verdict on(const std::string& what) const {
        if (text.empty()) return verdict::proved(what);
        return verdict::consistent(brief(residual), brief(bound_on_it),
                                   what + ", given " + text + " as far as the digits tell");
    }
};

STAGECRAFT_INLINE void assume_degree(const enclosed_stability_function& f, assumptions& given) {
    if (f.excess > 0 || f.excess_bound > 0)
        given.add("that P has no higher degree than Q", f.excess, f.excess_bound);
}

/// |R| on the imaginary axis: signs of |Q|^2 - |P|^2 as a polynomial in y^2, once of every table and once with its
/// coefficients set to 0 that vanish where R has the order that the digits show.
struct axis_signs {
    exponential_order order;
    std::vector<sign_piece> every, of_order;
    bound residual = 0, bound_on_it = 0;  ///< of the coefficients set to 0

    explicit axis_signs(const enclosed_stability_function& f) : order(exponential_order_of(f)) {
        const int vanish = order.order / 2 + 1;  // 1 - |R(iy)|^2 = O(y^{p+1}), and even
        const auto margin = margin_on_axis(f);
        for (std::size_t k = 0; k < std::min(margin.size(), static_cast<std::size_t>(vanish)); ++k) {
            residual = std::max(residual, margin[k].magnitude());
            bound_on_it = std::max(bound_on_it, margin[k].radius());
        }
        every = signs_on_half_line(margin);
        of_order = signs_on_half_line(margin_on_axis(f, vanish));
    }
    /// The sign right of 0, by the order where the table alone leaves it open; what comes behind that is piece `next`.
    int sign_at_zero(assumptions& given, std::size_t& next) const {
        next = 0;
        if (every.front().sign != 0) return every.front().sign;
        next = 1;
        if (of_order.front().sign == 0) return 0;
        if (of_order.front().sign > 0 && of_order.front().to < every.front().to) return 0;
        given.add("that R(z) = e^z + O(z^" + std::to_string(order.order + 1) + ")", residual, bound_on_it);
        return of_order.front().sign;
    }
};

STAGECRAFT_INLINE tableaux::polynomial<tableaux::rational> middle_polynomial(const std::vector<ball>& p,
                                                                             std::size_t degree) {
    std::vector<tableaux::rational> v;
    for (std::size_t k = 0; k <= degree; ++k)  // any table will do: one of short numbers
        v.push_back(exactly(middle(p[k])).middle());
    for (std::size_t k = 0; k <= degree; ++k)
        if (!to_range(p[k]).contains(v[k])) v[k] = p[k].middle();
    return tableaux::polynomial<tableaux::rational>(std::move(v));
}

/// Whether a pole certainly lies in the left half-plane and P does not vanish there.
STAGECRAFT_INLINE bool has_pole_on_the_left(const subject<ball>& s, const enclosed_stability_function& f) {
    const auto poles = spectra_of(s).poles;
    if (!poles) return false;
    return std::any_of(poles->begin(), poles->end(), [&](const spectral_value& v) {
        if (!certainly_negative(v.value.re)) return false;
        tableaux::complex_ball sum{0, 0};
        for (auto c = f.numerator.rbegin(); c != f.numerator.rend(); ++c)
            sum = sum * v.value + tableaux::complex_ball{*c, 0};
        return certainly_nonzero(sum.re) || certainly_nonzero(sum.im);
    });
}

/// The verdict on the poles: none left of the axis, for all tables, or a refutation. Q(iy) keeps away from 0 for all
/// of them, so none crosses the axis between two tables.
STAGECRAFT_INLINE verdict poles_on_the_right(const subject<ball>& s, const enclosed_stability_function& f) {
    if (f.degree == 0) return verdict::proved("no pole");
    if (!certainly_nonzero(f.denominator[f.degree]))
        return verdict::undecided("a pole may lie at infinity: det A is not told from 0");
    if (!all_positive(signs_on_half_line(denominator_on_axis(f))))
        return verdict::undecided("a pole may lie on the imaginary axis");
    const auto q = middle_polynomial(f.denominator, f.degree);
    if (tableaux::count_half_planes(q).left == 0) return verdict::proved("poles in the right half-plane");
    if (has_pole_on_the_left(s, f)) return verdict::refuted("a pole in the left half-plane");
    return verdict::undecided("det(I - zA) vanishes in the left half-plane, where P may vanish as well");
}

/// Q(-x)^2 - Q(x)^2, which is Q(-x)^2 - P(-x)^2 where P(z) is Q(-z) or its negative: -4 times the product of the even and
/// the odd part.
STAGECRAFT_INLINE std::vector<ball> unitary_margin(const std::vector<ball>& q) {
    std::vector<ball> out(2 * q.size(), ball(0));
    for (std::size_t i = 0; i < q.size(); i += 2)
        for (std::size_t j = 1; j < q.size(); j += 2) out[i + j] -= (q[i] * q[j]).times(4);
    return out;
}

STAGECRAFT_INLINE verdict not_decided_on_axis(const sign_piece& open) {
    const auto y = [](bound square) { return brief(std::sqrt(square)); };
    return verdict::undecided("|R(iy)| is not told from 1 " +
                              (std::isinf(open.to) ? "beyond y = " + y(open.from)
                                                   : "for y between " + y(open.from) + " and " + y(open.to)));
}

STAGECRAFT_INLINE verdict a_stable_of(const subject<ball>& s, const enclosed_stability_function& given_f) {
    if (s.strictly_lower && certainly_nonzero(s.t.b.sum()))
        return verdict::refuted("explicit: R is a polynomial and not constant");
    if (given_f.unbounded()) return verdict::refuted("R(infinity) is infinite");
    const auto f = given_f.trimmed();
    const axis_signs signs(f);
    if (const auto* bad = first_with_sign(signs.every, -1)) {
        const bound y = std::isinf(bad->to) ? 2 * std::sqrt(bad->from) + 1
                                            : (std::sqrt(bad->from) + std::sqrt(bad->to)) / 2;
        return verdict::refuted("|R(iy)| > 1 at y = " + brief(y));
    }
    const auto poles = poles_on_the_right(s, f);
    if (!poles.is_proved()) return poles;
    assumptions given;
    assume_degree(given_f, given);
    std::size_t next = 0;
    const int first = signs.sign_at_zero(given, next);
    const bool rest =
        next == signs.every.size() || (signs.every.size() == next + 1 && signs.every[next].sign > 0);
    if (first > 0 && rest)
        return given.on("|R(iy)| < 1 for all y, poles in the right half-plane, " + std::string(every_table));
    if (const auto u = unitary_of(f); u.at_infinity != 0) {
        given = {};
        given.add("that |R(iy)| = 1", u.residual, u.bound_on_it);
        return given.on("poles in the right half-plane " + std::string(every_table));
    }
    const auto open = std::find_if(signs.every.begin() + (first > 0 ? static_cast<std::ptrdiff_t>(next) : 0),
                                   signs.every.end(), [](const auto& x) { return x.sign == 0; });
    return not_decided_on_axis(open == signs.every.end() ? signs.every.front() : *open);
}

/// The sector's cosines: every table is stable at `stable`, none at `unstable`.
struct cosines {
    double stable = 2, unstable = -1;  ///< none found
};

STAGECRAFT_INLINE cosines find_cosines(const enclosed_stability_function& f) {
    const auto p = middle_polynomial(f.numerator, f.degree), q = middle_polynomial(f.denominator, f.degree);
    const double guess = guessed_cosine(stability_function<tableaux::rational>{p, q});
    const auto signs = [&](double u) { return signs_on_half_line(margin_on_ray(f, exactly(u))); };
    const auto is_stable = [&](double u) {  // then no pole is on the ray, and none comes into the sector
        return all_positive(signs(u)) && roots_in_sector(q, exactly(u).middle()) == 0;
    };
    const auto is_unstable = [&](double u) { return first_with_sign(signs(u), -1) != nullptr; };
    cosines found;
    for (const double step : {0x1p-40, 0x1p-30, 0x1p-20})
        if (found.stable > 1 && guess + step < 1 && is_stable(guess + step)) found.stable = guess + step;
    if (found.stable > 1) {  // a pole may be passed by rays beyond it: bisection of what is decided
        double low = 0, high = 1;
        for (int n = 0; n < 44; ++n) {
            const double middle = (low + high) / 2;
            (is_stable(middle) ? high : low) = middle;
        }
        if (high < 1) found.stable = high;
    }
    if (found.stable > 1) return found;
    for (double step = 0x1p-43; found.unstable < 0 && found.stable - step > 0; step *= 2)
        if (is_unstable(found.stable - step)) found.unstable = found.stable - step;
    if (found.unstable < 0) return found;
    double low = found.unstable, high = found.stable;
    for (int n = 0; n < 16; ++n) {
        const double at_stable = (low + found.stable) / 2, at_unstable = (found.unstable + high) / 2;
        (is_stable(at_stable) ? found.stable : low) = at_stable;
        (is_unstable(at_unstable) ? found.unstable : high) = at_unstable;
    }
    return found;
}

STAGECRAFT_INLINE claim interval_claim(const std::string& name, const std::vector<sign_piece>& pieces,
                                       std::size_t next, bound (*coordinate)(bound),
                                       const assumptions& given) {
    constexpr auto infinity = std::numeric_limits<bound>::infinity();
    const bool stable = next < pieces.size() && pieces[next].sign > 0;
    number_range end{next == 0 ? 0 : coordinate(pieces[next - 1].to), infinity};
    if (stable) end.low = tableaux::downward(coordinate(pieces[next].to));
    if (const auto* loss = first_with_sign(pieces, -1)) end.high = tableaux::upward(coordinate(loss->from));
    if (std::isinf(end.high) && ((stable && std::isinf(pieces[next].to)) || next == pieces.size()))
        return {name + " infinite", given.on("no end " + std::string(every_table)), no_end};
    if (std::isinf(end.high))
        return {name, verdict::undecided("at least " + brief(end.low) +
                                         "; beyond that |R| is not told from 1 by these digits")};
    return {name + " " + in_digits(end), given.on(between(end) + " " + every_table), end};
}

}  // namespace detail

STAGECRAFT_INLINE verdict rounded_a_stable(const subject<ball>& s) {
    return detail::a_stable_of(s, stability_function_of(s));
}

STAGECRAFT_INLINE verdict rounded_l_stable(const subject<ball>& s) {
    const auto f = stability_function_of(s);
    const auto a = detail::a_stable_of(s, f);
    if (a.is_refuted()) return a;
    const std::size_t degree = f.degree;
    verdict all = a;
    for (std::size_t k = degree; k < f.numerator.size(); ++k) {
        const ball& p = f.numerator[k];
        if (certainly_nonzero(p))
            return verdict::refuted("R(inf) is not 0: Q has degree " + std::to_string(degree) +
                                    ", and P the coefficient " + shown(p) + " of z^" + std::to_string(k));
        if (p.exactly_zero()) continue;
        all = both(all, open_case(p.magnitude(), p.radius(), f.denominator[degree].magnitude(), data_reason));
    }
    return all;
}

STAGECRAFT_INLINE claim enclosed_sector(const subject<ball>& s, const enclosed_stability_function& given_f) {
    const std::string name = "A(alpha)-stable";
    if (s.strictly_lower && certainly_nonzero(s.t.b.sum()))
        return {name, verdict::refuted("explicit: R is a polynomial and not constant"), number_range{0, 0}};
    if (given_f.unbounded()) return {name, verdict::refuted("R(infinity) is infinite"), number_range{0, 0}};
    const auto f = given_f.trimmed();
    const auto a = detail::a_stable_of(s, given_f);
    if (a.is_proved() || a.is_consistent()) return {name + " up to 90 degrees", a, number_range{90, 90}};
    const auto on_axis = signs_on_half_line(margin_on_ray(f, ball(1)));
    if (const auto* bad = first_with_sign(on_axis, -1))
        return {name, verdict::refuted("|R(x)| > 1 at some x < " + brief(-bad->from)), number_range{0, 0}};
    if (f.degree == 0 || !certainly_nonzero(f.denominator[f.degree]))
        return {name, verdict::undecided("a pole may lie at infinity: det A is not told from 0")};
    detail::assumptions given;
    detail::assume_degree(given_f, given);
    const auto u = detail::find_cosines(f);
    const auto degrees = [](double cosine) {
        return std::acos(static_cast<bound>(cosine)) * 180 / std::numbers::pi_v<bound>;
    };
    if (u.stable > 1)
        return {name, verdict::undecided("no angle at which these digits tell |R| from 1 was found")};
    const number_range angle{tableaux::downward(degrees(u.stable)),
                             u.unstable < 0 ? 90 : tableaux::upward(degrees(u.unstable))};
    return {name + " up to " + detail::in_digits(angle) + " degrees",
            given.on(detail::between(angle) + " degrees " + detail::every_table), angle};
}

STAGECRAFT_INLINE claim enclosed_real_interval(const enclosed_stability_function& given_f) {
    detail::assumptions given;
    const auto signs = signs_on_half_line(margin_on_ray(given_f, ball(1)), {.to_first_negative = true});
    const bool ends = first_with_sign(signs, -1) != nullptr;
    const auto identity = [](bound x) { return x; };
    if (ends || given_f.unbounded())
        return detail::interval_claim("real stability interval", signs, 0, identity, given);
    detail::assume_degree(given_f, given);
    const auto f = given_f.trimmed();
    auto margin = margin_on_ray(f, ball(1));
    if (const auto u = unitary_of(f); u.at_infinity != 0) {
        given.add("that R(z) R(-z) = 1", u.residual, u.bound_on_it);
        margin = detail::unitary_margin(f.denominator);
    }
    return detail::interval_claim("real stability interval", signs_on_half_line(margin), 0, identity, given);
}

STAGECRAFT_INLINE claim enclosed_imaginary_interval(const enclosed_stability_function& given_f) {
    const std::string name = "imaginary stability interval";
    detail::assumptions given;
    if (!given_f.unbounded() && given_f.degree > 0) detail::assume_degree(given_f, given);
    const auto f = given_f.unbounded() || given_f.degree == 0 ? given_f : given_f.trimmed();
    if (const auto u = unitary_of(f); u.at_infinity != 0) {
        given.add("that R(z) R(-z) = 1", u.residual, u.bound_on_it);
        return {name + " infinite", given.on("|R(iy)| = 1"), detail::no_end};
    }
    const detail::axis_signs signs(f);
    std::size_t next = 0;
    const int first = signs.sign_at_zero(given, next);
    if (first < 0) return {name + " 0", given.on("|R(iy)| > 1 for every small y"), number_range{0, 0}};
    if (first == 0) {
        std::string known;
        const auto y = [](bound square) { return brief(std::sqrt(square)); };
        if (const auto* good = first_with_sign(signs.every, 1))
            known += "; |R(iy)| < 1 from y = " + y(good->from) + " to " + y(good->to);
        if (const auto* bad = first_with_sign(signs.every, -1))
            known += "; |R(iy)| > 1 from y = " + y(bad->from);
        return {name, verdict::undecided("the digits leave open whether |R(iy)| > 1 for small y" + known)};
    }
    return detail::interval_claim(
        name, signs.every, next, [](bound x) { return std::sqrt(x); }, given);
}

STAGECRAFT_INLINE claim enclosed_limit(const subject<ball>& s, const enclosed_stability_function& f) {
    const std::string name = "R(infinity)";
    if (f.unbounded()) return {name + " = infinity", verdict::proved("P has a higher degree than Q")};
    detail::assumptions given;
    detail::assume_degree(f, given);
    const auto value = value_at_infinity(s, f.trimmed());
    if (!value) return {name, verdict::undecided("det A is not told from 0 by these digits")};
    if (const auto u = unitary_of(f); u.at_infinity != 0) {
        given.add("that R(z) R(-z) = 1", u.residual, u.bound_on_it);
        return {name + " = " + std::to_string(u.at_infinity), given.on("symmetric")};
    }
    const std::string within = "within " + brief(value->radius()) + " " + detail::every_table;
    if (value->radius() <= 1e-10L * value->magnitude_below())
        return {name + " = " + detail::in_format("%.12Lg", value->middle().to<bound>()), given.on(within)};
    if (certainly_nonzero(*value) || value->radius() > rounding_level)
        return {name + " = " + shown(*value), given.on(within)};
    given.add("R(infinity) = 0", value->magnitude(), value->radius());
    return {name + " = 0", given.on(within)};
}

}  // namespace stagecraft::theory
