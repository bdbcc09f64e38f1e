// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "stagecraft/theory/dae/dae_order.hpp"
#include "stagecraft/theory/judging/certificate.hpp"
#include "stagecraft/theory/stability/phase_error.hpp"
#include "stagecraft/theory/stability/sector_stability.hpp"
#include "stagecraft/theory/stability/ssp.hpp"
#include "stagecraft/theory/stability/symmetry.hpp"

namespace stagecraft::theory {

/// A titled list of claims.
struct report_section {
    std::string title;
    std::vector<claim> claims;
};

namespace detail {

std::string digits(double x);

template <class K>
claim interval_claim(const std::string& name, const stability_interval<K>& i) {
    using tableaux::bound;
    constexpr auto none = std::numeric_limits<bound>::infinity();
    if (i.infinite) return {name + " infinite", verdict::proved("no sign change"), number_range{none, none}};
    const auto low = digits(i.low.template to<double>());
    const auto high = digits(i.high.template to<double>());
    const number_range ends{tableaux::downward(i.low.template to<bound>()),
                            tableaux::upward(i.high.template to<bound>())};
    if (i.low == i.high) return {name + " " + i.low.str(), verdict::proved("exact"), ends};
    return {name + " " + low, verdict::proved("enclosed to 2^-60" + (low == high ? "" : ", up to " + high)),
            ends};
}

template <class K>
claim sector_claim(const stability_function<K>& r) {
    const auto s = largest_sector(r);
    const number_range angle{s.degrees_low, s.degrees_high};
    if (!s.exists) return {"A(alpha)-stable", verdict::refuted("for every alpha > 0"), number_range{0, 0}};
    if (s.degrees_low == 90) return {"A(alpha)-stable up to 90 degrees", verdict::proved("A-stable"), angle};
    char low[32], high[32];
    std::snprintf(low, sizeof low, "%.13f", s.degrees_low);
    std::snprintf(high, sizeof high, "%.13f", s.degrees_high);
    return {"A(alpha)-stable up to " + std::string(low) + " degrees",
            verdict::proved("not beyond " + std::string(high)), angle};
}

std::string reasons(const std::vector<hypothesis>& hypotheses);

claim prediction_claim(const std::string& problem, const order_prediction& p);

std::string error_text(const std::vector<epsilon_term>& terms);

}  // namespace detail

/// What the stability function alone decides: approximation of the exponential, poles, R(inf), A-, strong A-,
/// L-, A0-, I-stability, the sector, the intervals on both axes, and of explicit methods dispersion and dissipation.
template <class K>
std::vector<claim> function_claims(const stability_function<K>& r) {
    std::vector<claim> all;
    const auto fit = exponential_fit_of(r);
    const auto degrees = std::to_string(fit.numerator_degree) + "/" + std::to_string(fit.denominator_degree);
    all.push_back({"R(z) = " + r.text(), verdict::proved("det(I - zA + z 1 b^T) / det(I - zA)")});
    all.push_back({"R approximates e^z to order " + std::to_string(fit.order),
                   verdict::proved("degrees " + degrees + (fit.pade ? ", a Pade approximation" : "") +
                                   ", error constant " + fit.error_constant.str())});
    const auto limit = r.at_infinity();
    all.push_back(
        {"R(infinity) = " + (limit ? limit->str() : "infinity"), verdict::proved("leading coefficients")});
    const auto poles = r.poles();
    all.push_back({std::to_string(poles.left + poles.axis + poles.right) + " poles",
                   verdict::proved(std::to_string(poles.left) + " in the left half-plane, " +
                                   std::to_string(poles.axis) + " on the axis, " +
                                   std::to_string(poles.right) + " in the right half-plane")});
    try {
        all.push_back({"poles: " + text(roots_of(r.denominator)),
                       verdict::proved("enclosed; digits correctly rounded")});
    } catch (const tableaux::undecided&) {  // the count above is all that can be said
    }
    all.push_back({"A-stable", a_stable(r)});
    all.push_back({"strongly A-stable", strongly_a_stable(r)});
    all.push_back({"L-stable", l_stable(r)});
    all.push_back({"A0-stable", a0_stable(r)});
    all.push_back({"I-stable", i_stable(r)});
    all.push_back(detail::sector_claim(r));
    all.push_back(detail::interval_claim("real stability interval", real_stability_interval(r)));
    all.push_back(detail::interval_claim("imaginary stability interval", imaginary_stability_interval(r)));
    if (r.denominator.degree() == 0) {
        const auto errors = phase_errors_of(r);
        if (const auto& e = errors.dispersion)
            all.push_back({dispersion_text(e->order),
                           verdict::proved(leading_text("y - arg R(iy)", e->coefficient.str(), e->order))});
        if (const auto& e = errors.dissipation)
            all.push_back({dissipation_text(e->order),
                           verdict::proved(leading_text("1 - |R(iy)|", e->coefficient.str(), e->order))});
    }
    return all;
}

/// Everything this library decides of a tableau over an exact ordered field: what the stability function of
/// the method and of the embedded method says, the properties of the tableau itself, and the orders predicted
/// for differential-algebraic and singularly perturbed problems.
template <class K>
std::vector<report_section> stability_report(const tableau<K>& t) {
    std::vector<report_section> out;
    out.push_back({"stability function", function_claims(stability_function_of(t))});
    report_section method{"tableau", {}};
    method.claims = {{"stiffly accurate", stiffly_accurate(t)},
                     {"A regular", regular_matrix(t)},
                     {"eigenvalues of A right of the axis", eigenvalues_in_right_half_plane(t)},
                     {"DJ-irreducible", dj_irreducible(t)},
                     {"S-irreducible", s_irreducible(t)},
                     {"algebraically stable", algebraically_stable(t)},
                     {"B-stable", b_stable(t)},
                     {"AN-stable", an_stable(t)},
                     {"symplectic", symplectic(t)},
                     {"symmetric", symmetric(t)},
                     detail::interval_claim("SSP radius", ssp_radius(t))};
    out.push_back(std::move(method));
    report_section dae{"differential-algebraic and singularly perturbed problems", {}};
    dae.claims = {detail::prediction_claim("index 1", predict_index1(t)),
                  detail::prediction_claim("index 2", predict_index2(t)),
                  detail::prediction_claim("index 3", predict_index3(t))};
    const auto p = predict_singular_perturbation(t);
    if (p.applies()) {
        dae.claims.push_back({"singular perturbation: y " + detail::error_text(p.y) + ", lambda " +
                                  detail::error_text(p.lambda),
                              verdict::proved(p.theorem)});
    } else {
        dae.claims.push_back(
            {"singular perturbation: no theorem applies", verdict::proved(detail::reasons(p.hypotheses))});
    }
    out.push_back(std::move(dae));
    if (t.b_embedded.size() != 0) {
        out.push_back(
            {"embedded method: stability function", function_claims(embedded_stability_function_of(t))});
    }
    return out;
}

/// As text: titles, and one line for each claim.
std::string text(const std::vector<report_section>& report);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/stability_report-inl.hpp"
#endif
