// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/enclosed_report.hpp"

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <numbers>
#include <string>

#include "stagecraft/compiled.hpp"
#include "stagecraft/method/simplifying_assumptions.hpp"
#include "stagecraft/tableaux/claims.hpp"
#include "stagecraft/theory/dae/dae_order.hpp"
#include "stagecraft/theory/judging/order_finding.hpp"
#include "stagecraft/theory/judging/properties.hpp"
#include "stagecraft/theory/stability/ssp.hpp"

namespace stagecraft::theory {

namespace detail {

/// |Q|^2 - |P|^2 at r e^{i phi}: certainly negative where |R| > 1.
STAGECRAFT_INLINE ball margin(const enclosed_stability_function& f, double r, double phi) {
    const auto at = [&](const std::vector<ball>& p) {
        const ball x = exactly(r * std::cos(phi)), y = exactly(r * std::sin(phi));
        ball real(0), imaginary(0);
        for (auto c = p.rbegin(); c != p.rend(); ++c) {
            const ball next = real * x - imaginary * y + *c;
            imaginary = real * y + imaginary * x;
            real = next;
        }
        return real * real + imaginary * imaginary;
    };
    return at(f.denominator) - at(f.numerator);
}

/// Where |R| > 1 first happens on a ray, between the last point without and the first with certainty.
STAGECRAFT_INLINE claim first_violation(const std::string& name, const enclosed_stability_function& f,
                                        double phi) {
    constexpr double step = 1.0 / 64, last = 200;
    double low = 0, high = 0;
    for (double r = step; r <= last && high == 0; r += step) {
        if (certainly_negative(margin(f, r, phi)))
            high = r;
        else
            low = r;
    }
    const std::string reason = "looked at 64 points to each unit length";
    if (high == 0) return {name + " no end below 200", verdict::consistent("0", "none certain", reason)};
    while (high - low > 1e-12 * high) {
        const double middle = (low + high) / 2;
        if (certainly_negative(margin(f, middle, phi)))
            high = middle;
        else if (certainly_negative(-margin(f, middle, phi)))
            low = middle;
        else
            break;
    }
    return {name + " " + digits(high),
            verdict::consistent("|R| > 1 beyond for certain", brief(high - low), reason)};
}

/// Whether a point on one of the rays at the angle alpha from the negative real axis certainly has |R| > 1.
STAGECRAFT_INLINE bool violates(const enclosed_stability_function& f, double alpha) {
    for (int k = -200; k <= 200; ++k)
        if (certainly_negative(margin(f, std::exp2(k / 15.0), std::numbers::pi - alpha))) return true;
    return false;
}

/// The smallest angle, to 1e-6 degrees, for which a violation of A(alpha)-stability was found.
STAGECRAFT_INLINE claim sector_claim(const enclosed_stability_function& f) {
    constexpr double degree = std::numbers::pi / 180;
    const std::string reason = "looked at 401 points on each ray";
    if (!violates(f, 90 * degree))
        return {"A(alpha)-stable up to 90 degrees", verdict::consistent("0", "none certain", reason)};
    if (violates(f, 0)) return {"A(alpha)-stable", verdict::refuted("|R(x)| > 1 for some x < 0")};
    double low = 0, high = 90;
    while (high - low > 1e-6) (violates(f, (low + high) / 2 * degree) ? high : low) = (low + high) / 2;
    char text[32];
    std::snprintf(text, sizeof text, "%.4f", high);
    return {"A(alpha)-stable up to " + std::string(text) + " degrees",
            verdict::consistent("|R| > 1 at some point beyond", "1e-6 degrees", reason)};
}

/// What the theorems on differential-algebraic problems need to know, as far as no enclosure contradicts it: where
/// R(infinity) may be 0, 1 or -1, it is taken to be that.
STAGECRAFT_INLINE dae_traits<tableaux::rational> enclosed_dae_traits(const subject<ball>& s,
                                                                     const enclosed_stability_function& f) {
    using tableaux::rational;
    const auto& t = s.t;
    const auto equal = [](const ball& x, const ball& y) { return !certainly_nonzero(ball(x - y)); };
    dae_traits<rational> m;
    m.stages = t.stages();
    m.simplifying = simplifying_orders_of(t, equal);
    m.order = std::min(find_order(s, t.b, 10).order, order_barrier(s));
    m.stage_order = std::min(m.simplifying.B, m.simplifying.C);
    m.regular = certainly_nonzero(f.denominator.back());
    m.stiff = !rounded_stiffly_accurate(s).is_refuted();
    bool distinct = true;
    for (int i = 0; i < t.stages(); ++i)
        for (int j = 0; j < i; ++j) distinct = distinct && !equal(t.c(i), t.c(j));
    m.collocation = distinct && m.stage_order >= m.stages;
    for (int i = t.stages(); i-- > 0;)
        if (equal(t.c(i), ball(0))) m.zero_node = i;
    m.ends_at_one = equal(t.c(t.stages() - 1), ball(1));
    m.last_node = m.ends_at_one ? "1" : shown(t.c(t.stages() - 1));
    const std::size_t below = most_implicit_stages(t);
    std::size_t above = f.numerator.size() - 1;
    while (above > 0 && !certainly_nonzero(f.numerator[above])) --above;
    if (above > below || !certainly_nonzero(f.denominator[below])) return m;
    const ball limit = above < below ? ball(0) : f.numerator[above] / f.denominator[below];
    const auto special = [&](int x) { return equal(limit, ball(x)); };
    // To twelve digits, and on the side of 1 where it is.
    const rational unit(1, 1000000000000), middle = limit.middle();
    const rational printed = rational(floor(middle / unit + rational(1, 2))) * unit;
    m.r_infinity = special(0)          ? rational(0)
                   : special(1)        ? rational(1)
                   : special(-1)       ? rational(-1)
                   : abs(printed) == 1 ? middle
                                       : printed;
    return m;
}

STAGECRAFT_INLINE claim consistent_prediction(const std::string& problem, const order_prediction& p) {
    claim c = prediction_claim(problem, p);
    if (p.applies())
        c.verdict = verdict::consistent("0", "that of the entries", p.theorem);
    else
        c.verdict = verdict::inconclusive("not computed", "none", reasons(p.hypotheses));
    return c;
}

}  // namespace detail

STAGECRAFT_INLINE std::vector<report_section> enclosed_stability_report(const subject<ball>& s) {
    std::vector<report_section> out;
    const auto f = detail::stability_function_of(s.t);
    out.push_back(
        {"stability function, by enclosures",
         {detail::sector_claim(f), detail::first_violation("real stability interval", f, std::numbers::pi),
          detail::first_violation("imaginary stability interval", f, std::numbers::pi / 2)}});
    report_section method{"tableau, by enclosures", {}};
    for (const auto& [property, member] : tableaux::yes_no_claims)
        method.claims.push_back({std::string(property), property_of(s, property)});
    if (s.stages() <= 8) {
        const auto middle =
            mapped<tableaux::quadratic>(s, [](const ball& x) { return tableaux::quadratic(x.middle()); });
        auto radius = detail::interval_claim("SSP radius", ssp_radius(middle.t));
        method.claims.push_back(
            {radius.statement,
             verdict::consistent("0", "not bounded", "of the numbers as they are written")});
    }
    out.push_back(std::move(method));
    const auto m = detail::enclosed_dae_traits(s, f);
    out.push_back({"differential-algebraic problems, by enclosures",
                   {detail::consistent_prediction("index 1", predict_index1(m)),
                    detail::consistent_prediction("index 2", predict_index2(m)),
                    detail::consistent_prediction("index 3", predict_index3(m))}});
    return out;
}

}  // namespace stagecraft::theory
