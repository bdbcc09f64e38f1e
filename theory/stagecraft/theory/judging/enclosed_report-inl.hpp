// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/enclosed_report.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "stagecraft/compiled.hpp"
#include "stagecraft/method/simplifying_assumptions.hpp"
#include "stagecraft/tableaux/claims.hpp"
#include "stagecraft/theory/dae/dae_order.hpp"
#include "stagecraft/theory/judging/enclosed_ssp.hpp"
#include "stagecraft/theory/judging/enclosed_stability.hpp"
#include "stagecraft/theory/judging/in_its_time.hpp"
#include "stagecraft/theory/judging/order_finding.hpp"
#include "stagecraft/theory/judging/properties.hpp"
#include "stagecraft/theory/stability/phase_error.hpp"

namespace stagecraft::theory {

namespace detail {

/// What the theorems on differential-algebraic problems need to know of a tableau known by enclosures. Equalities (order
/// conditions, C(q), b in the last row) hold where the digits show them to equality_level; whether A is regular and
/// |R(infinity)| < 1 is decided for every tableau, or `open` says why not.
struct enclosed_dae_traits {
    dae_traits<tableaux::rational> traits;
    bound residual = 0, bound_on_it = 0;  ///< of the equalities
    std::string open_regular, open_limit, open_order;

    /// Whether x = y as far as the digits tell.
    bool equal(const ball& x, const ball& y) {
        const ball d = x - y;
        const bound scale = std::max({x.magnitude(), y.magnitude(), bound(1e-3L)});
        if (certainly_nonzero(d)) return false;
        if (d.radius() > equality_level * scale) {
            open_order = "the digits are too few to show an equality that the theorems need";
            return false;
        }
        residual = std::max(residual, d.magnitude());
        bound_on_it = std::max(bound_on_it, d.radius());
        return true;
    }
};

STAGECRAFT_INLINE void set_limit(const ball& value, enclosed_dae_traits& m) {
    const ball excess = value * value - ball(1);
    if (!certainly_nonzero(excess)) m.open_limit = "whether |R(infinity)| < 1: it is " + shown(value);
    m.traits.r_infinity = value.middle();
}

/// |R(infinity)| < 1 or > 1 of every tableau, or the 0, 1 or -1 that an equality makes of it.
STAGECRAFT_INLINE void set_limit(const subject<ball>& s, const enclosed_stability_function& f,
                                 enclosed_dae_traits& m) {
    auto& r = m.traits.r_infinity;
    if (m.traits.stiff) {
        r = tableaux::rational(0);
        return;
    }
    if (const auto u = unitary_of(f); u.at_infinity != 0) {
        r = tableaux::rational(u.at_infinity);
        m.residual = std::max(m.residual, u.residual);
        m.bound_on_it = std::max(m.bound_on_it, u.bound_on_it);
        return;
    }
    const auto value = value_at_infinity(s, f);
    if (!value) {
        m.open_limit = "R(infinity) is not enclosed";
        return;
    }
    set_limit(*value, m);
}

/// Methods whose first stage is the left end of the step, diagonally implicit ones with the conditions of index 2.
STAGECRAFT_INLINE void set_left_stage(const subject<ball>& s, const enclosed_stability_function& f,
                                      enclosed_dae_traits& out) {
    const auto& t = s.t;
    const int n = t.stages();
    auto& m = out.traits;
    bool left = n > 1 && t.c(0).exactly_zero();
    for (int j = 0; j < n; ++j) left = left && t.A(0, j).exactly_zero();
    // of the rest of A, up to its sign, the leading coefficient of Q is the determinant
    m.left_stage = left && static_cast<int>(f.degree) == n - 1 && certainly_nonzero(f.denominator[f.degree]);
    if (!m.left_stage || !m.stiff || !s.lower || m.order == 0) return;
    tableaux::dense<ball> inverse(n, n);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            ball sum(i == j && i > 0 ? 1 : 0);
            for (int k = j; k < i; ++k) sum = sum - t.A(i, k) * inverse(k, j);
            inverse(i, j) = i == 0 || j == 0 || j > i ? ball(0) : ball(sum / t.A(i, i));
        }
    ball limit(0);  // the error of z_n that comes back in Z_s = z_{n+1}
    for (int k = 1; k < n; ++k) limit = limit - inverse(n - 1, k) * t.A(k, 0);
    set_limit(limit, out);
    m.left_index2 = index2_local_orders_of(t, inverse, std::min(m.order, largest_left_index2_order),
                                           [&](const ball& x, const ball& y) { return out.equal(x, y); });
}

STAGECRAFT_INLINE enclosed_dae_traits enclosed_traits_of(const subject<ball>& s,
                                                         const enclosed_stability_function& f) {
    enclosed_dae_traits out;
    auto& m = out.traits;
    const auto& t = s.t;
    const int n = t.stages();
    const auto equal = [&](const ball& x, const ball& y) { return out.equal(x, y); };
    m.stages = n;
    m.simplifying = simplifying_orders_of(t, equal);
    const auto found = find_order(s, t.b, 10);
    m.order = found.order;
    while (m.order > 0 && found.up_to(m.order).relative_bound > equality_level) --m.order;
    if (m.order < std::min(found.order, order_barrier(s)))
        out.open_order = "whether the order is above " + std::to_string(m.order);
    out.residual = std::max(out.residual, found.up_to(m.order).residual);
    out.bound_on_it = std::max(out.bound_on_it, found.up_to(m.order).bound);
    m.stage_order = std::min(m.simplifying.B, m.simplifying.C);
    m.regular = static_cast<int>(f.degree) == n && certainly_nonzero(f.denominator.back());
    if (static_cast<int>(f.degree) == n && !m.regular) out.open_regular = "whether A is regular";
    m.stiff = true;
    for (int j = 0; j < n; ++j) m.stiff = m.stiff && equal(t.A(n - 1, j), t.b(j));
    bool distinct = true;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < i; ++j) distinct = distinct && certainly_nonzero(t.c(i) - t.c(j));
    m.collocation = distinct && m.stage_order >= n;
    for (int i = n; i-- > 0;)
        if (!certainly_nonzero(t.c(i))) m.zero_node = i;
    m.ends_at_one = equal(t.c(n - 1), ball(1));
    m.last_node = m.ends_at_one ? "1" : shown(t.c(n - 1));
    if (m.regular) set_limit(s, f, out);
    set_left_stage(s, f, out);
    return out;
}

/// A theorem's orders, given the equalities that the digits show; not decided where one of its other hypotheses is open.
STAGECRAFT_INLINE claim enclosed_prediction(const std::string& problem, const order_prediction& p,
                                            const enclosed_dae_traits& m) {
    claim c = prediction_claim(problem, p);
    if (!m.traits.regular && !m.traits.left_stage && m.open_regular.empty())
        return c;  // all of them ask for one or the other
    const bool limit_needed = std::any_of(p.hypotheses.begin(), p.hypotheses.end(), [](const hypothesis& h) {
        return h.name.find("R(inf)") != std::string::npos;
    });
    std::string open = m.open_regular;
    if (open.empty() && (limit_needed || m.traits.regular)) open = m.open_limit;
    if (open.empty()) open = m.open_order;
    if (!open.empty())
        c = {problem, verdict::undecided(open)};
    else if (p.applies())
        c.verdict =
            verdict::consistent(brief(m.residual), brief(m.bound_on_it),
                                p.theorem + (p.note.empty() ? "" : "; " + p.note) +
                                    ", given the conditions on its coefficients as far as the digits tell");
    return c;
}

}  // namespace detail

namespace detail {

/// Dispersion and dissipation of an explicit method: coefficients that the digits do not tell from 0 are taken for 0, where they
/// show that to equality_level; the leading ones are certainly not 0.
STAGECRAFT_INLINE std::vector<claim> enclosed_phase_errors(const enclosed_stability_function& f) {
    bound residual = 0, bound_on_it = 0;
    const auto differs = [&](const ball& d) {
        if (certainly_nonzero(d)) return true;
        residual = std::max(residual, d.magnitude());
        bound_on_it = std::max(bound_on_it, d.radius());
        return false;
    };
    const auto errors = phase_errors_of(f.numerator, differs);
    const auto said = [&](const std::string& order, const std::string& leading) -> claim {
        if (bound_on_it > equality_level)
            return {order.substr(0, order.find(' ')),
                    verdict::undecided(
                        "the digits are too few to show the terms before the leading one to be 0")};
        return {order, verdict::consistent(brief(residual), brief(bound_on_it), leading)};
    };
    std::vector<claim> all;
    if (const auto& e = errors.dispersion)
        all.push_back(
            said(dispersion_text(e->order), leading_text("y - arg R(iy)", shown(e->coefficient), e->order)));
    if (const auto& e = errors.dissipation)
        all.push_back(
            said(dissipation_text(e->order), leading_text("1 - |R(iy)|", shown(e->coefficient), e->order)));
    return all;
}

STAGECRAFT_INLINE std::vector<claim> enclosed_function_claims(const subject<ball>& s,
                                                              const enclosed_stability_function& f) {
    std::vector<claim> all;
    const auto add = [&](const char* statement, auto decide) {
        all.push_back(claimed_in_its_time(statement, 0.3, decide));
    };
    add("R(infinity)", [&] { return enclosed_limit(s, f); });
    add("A(alpha)-stable", [&] { return enclosed_sector(s, f); });
    add("real stability interval", [&] { return enclosed_real_interval(f); });
    add("imaginary stability interval", [&] { return enclosed_imaginary_interval(f); });
    if (f.degree == 0)
        for (auto& c : within_its_time(0.3, [&] { return enclosed_phase_errors(f); },
                                       {{"dispersion", verdict::undecided(out_of_its_time)}}))
            all.push_back(std::move(c));
    return all;
}

STAGECRAFT_INLINE report_section enclosed_function_section(const subject<ball>& s,
                                                           std::optional<enclosed_stability_function>& f) {
    f = within_its_time(
        0.3, [&] { return std::optional(stability_function_of(s)); }, std::nullopt);
    report_section section{"stability function, by enclosures",
                           {{"R(z)", verdict::undecided(out_of_its_time)}}};
    if (f) section.claims = enclosed_function_claims(s, *f);
    return section;
}

/// Orders by the theorems that apply.
STAGECRAFT_INLINE report_section enclosed_dae_section(const subject<ball>& s,
                                                      const enclosed_stability_function& f) {
    const auto predict = [&]() -> std::vector<claim> {
        const auto m = enclosed_traits_of(s, f);
        return {enclosed_prediction("index 1", predict_index1(m.traits), m),
                enclosed_prediction("index 2", predict_index2(m.traits), m),
                enclosed_prediction("index 3", predict_index3(m.traits), m)};
    };
    return {"differential-algebraic problems, by enclosures",
            within_its_time(0.3, predict, {{"orders", verdict::undecided(out_of_its_time)}})};
}

}  // namespace detail

STAGECRAFT_INLINE std::vector<report_section> enclosed_stability_report(const subject<ball>& s) {
    std::optional<enclosed_stability_function> f;
    std::vector<report_section> all{detail::enclosed_function_section(s, f)};
    if (f) all.push_back(detail::enclosed_dae_section(s, *f));
    report_section method{"tableau, by enclosures", {}};
    for (const auto& [property, member] : tableaux::yes_no_claims)
        method.claims.push_back({std::string(property), detail::in_its_time(0.3, [&, name = property] {
                                     return property_of(s, name);
                                 })});
    if (s.stages() <= 16)
        method.claims.push_back(
            detail::claimed_in_its_time("SSP radius", 0.5, [&] { return enclosed_ssp_radius(s); }));
    all.insert(all.begin() + 1, std::move(method));
    return all;
}

}  // namespace stagecraft::theory
