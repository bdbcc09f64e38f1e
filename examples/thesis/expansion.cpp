// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include <problems/thesis/limits.hpp>
#include "experiments.hpp"

namespace thesis {

namespace {

// The order of a quantity in eps, as a line of the closing table.
finding order_line(const std::string& what, double seen, double theory, const std::string& printed = {},
                   const std::string& comparison = {}, double by = 0.05) {
    return {what, printed, decimal(seen), decimal(theory), std::abs(seen - theory) < by, comparison};
}

// y - y_0 - eps Y, relative to eps Y: smaller by eps^(1 - kappa).
void leading_term(outcome& o) {
    figure rest{"fig_expansion_rest",
                "What is left after ε·Y, relative to it",
                "ε",
                "max |y - y_0 - ε Y| / max |ε Y|",
                true,
                true,
                {}};
    const std::vector<double> eps{1e-5, 1e-6, 1e-7, 1e-8};
    o.text += "|y - y0 - eps Y| / |eps Y| and |lambda - lambda0 - eps Lambda| / |eps Lambda|, t >= 0.1\n";
    for (const double kappa : {0.25, 0.5}) {
        std::vector<double> y;
        for (const double e : eps) {
            const remainder r = after_eps_Y(e, kappa);
            y.push_back(r.y);
            o.text += "  kappa = " + decimal(kappa) + ", eps = " + scientific(e) + ": " + scientific(r.y) +
                      "  " + scientific(r.lambda) + "\n";
        }
        const double order = slope({eps.begin() + 1, eps.end()}, {y.begin() + 1, y.end()});
        rest.curves.push_back({"κ = " + decimal(kappa) + ", slope " + decimal(order), eps, y, true});
        rest.slopes.push_back({1 - kappa, rest.curves.size() - 1});
        o.findings.push_back(order_line("order of what eps Y leaves, relative, kappa = " + decimal(kappa),
                                        order, 1 - kappa, {}, {}, 0.1));
    }
    o.figures.push_back(rest);
}

// Corollary 3 with a weak spring, c = 2 sqrt(eps), beside the fixed spring of the thesis.
void corollary_3(outcome& o) {
    const std::vector<double> eps{1e-6, 1e-8, 1e-10, 1e-12};
    std::vector<double> weak, fixed, quotient, lambda;
    for (const double e : eps) {
        const double c = 2 * std::sqrt(e);
        const limit_distance d = past_the_layer(disc_regularised(form::mass_matrix, e, 0.5, {0, 0}, c, 2.0));
        weak.push_back(d.y);
        lambda.push_back(d.lambda);
        quotient.push_back(c * d.creep / d.y);
        fixed.push_back(past_the_layer(disc_regularised(form::mass_matrix, e, 0.5)).y);
    }
    o.text +=
        "\nCorollary 3: g(y) = O(sqrt(eps) (y - y0)) holds for a spring c = 2 sqrt(eps), which is strong "
        "damping\nwith sqrt(eps) for eps; at eps = 1e-12 the error is " +
        scientific(weak.back()) + " there and " + scientific(fixed.back()) + " with c = 2\n";
    o.figures.push_back({"fig_corollary_3",
                         "Corollary 3: principal damping with a fixed and with a weak spring",
                         "ε",
                         "max |y - y_0|, t ≥ 0.1 s",
                         true,
                         true,
                         {{"c = 2 √ε, slope " + decimal(slope(eps, weak)), eps, weak, true},
                          {"c = 2, slope " + decimal(slope(eps, fixed)), eps, fixed, true}},
                         false,
                         {{0.5, 0}, {1, 1}}});
    o.findings.push_back(
        order_line("Corollary 3, c = 2 sqrt(eps): |g(y)| / |y - y0|", slope(eps, quotient), 0.5));
    o.findings.push_back(order_line("Corollary 3, c = 2 sqrt(eps): y", slope(eps, weak), 0.5, "0.5",
                                    compared(0.5, slope(eps, weak), 0.05)));
    o.findings.push_back(order_line("Corollary 3, c = 2 sqrt(eps): lambda", slope(eps, lambda), 0.5, "0.5",
                                    compared(0.5, slope(eps, lambda), 0.05)));
}

// Corollary 4 in the layer, from lambda_0(0), from lambda_0(0) + (1, 1), and with (3.61) violated.
void corollary_4(outcome& o) {
    const std::vector<double> eps{1e-4, 1e-5, 1e-6, 1e-7, 1e-8};
    std::vector<double> calm, disturbed, corrected, y, violated;
    for (const double e : eps) {
        calm.push_back(within_the_layer(e, 0, 2, 2).lambda);
        const layer_distance d = within_the_layer(e, 1, 2, 2), v = within_the_layer(e, 1, 12, 2);
        y.push_back(d.y);
        disturbed.push_back(d.lambda);
        corrected.push_back(d.corrected);
        violated.push_back(v.corrected);
    }
    const double with_layer = slope(eps, corrected), without = slope(eps, disturbed);
    o.figures.push_back(
        {"fig_corollary_4",
         "Corollary 4: λ within the layer, 0 ≤ t ≤ 4√ε",
         "ε",
         "max |λ - λ_0|",
         true,
         true,
         {{"from λ_0(0), slope " + decimal(slope(eps, calm)), eps, calm, true},
          {"from λ_0(0) + (1, 1), slope " + decimal(without), eps, disturbed, true},
          {"  the same less ζ_0, slope " + decimal(with_layer), eps, corrected, true},
          {"  (3.61) violated, less ζ_0, " + decimal(slope(eps, violated)), eps, violated, true}},
         false,
         {{0.5, 3}}});
    o.text += "\nCorollary 4: from lambda0(0) + (1, 1) lambda is off by " + scientific(disturbed.back()) +
              " however small eps; less the layer term zeta_0(t/sqrt(eps)) by " +
              scientific(corrected.back()) +
              " at eps = 1e-8.\n(3.61) violated, c = 12, d = 2: " + scientific(violated.back()) +
              "; the layer oscillates and dies out, r^2 + d S r + c S is stable for every S > 0.\n";
    o.findings.push_back(order_line("Corollary 4: y from lambda(0) + (1, 1)", slope(eps, y), 0.5, "0.5",
                                    compared(0.5, slope(eps, y), 0.05)));
    o.findings.push_back(order_line("Corollary 4: lambda from lambda(0)", slope(eps, calm), 0.5, "0.5",
                                    compared(0.5, slope(eps, calm), 0.05)));
    o.findings.push_back(order_line(
        "Corollary 4: lambda from lambda(0) + (1, 1)", without, 0, "0.5",
        compared(0.5, without, 0.05, "zeta_0 is dropped, with it the order is " + decimal(with_layer),
                 std::abs(with_layer - 0.5) < 0.05)));
    o.findings.push_back(
        order_line("Corollary 4, (3.61) violated: lambda less zeta_0", slope(eps, violated), 0.5));
}

}  // namespace

outcome root_expansion() {
    outcome o{"The expansion in sqrt(eps), Corollaries 3 and 4 ((3.50) to (3.61))", {}, {}, {}};
    std::vector<double> times;
    for (int k = 1; k <= 1000; ++k) times.push_back(k / 1000.0);
    curve size{"|Y|", {}, {}, false}, force{"|Λ|", {}, {}, false};
    double largest = 0;
    for (const correction& term : disc_correction(2, times)) {
        size.x.push_back(term.t);
        size.y.push_back(term.Y.cwiseAbs().maxCoeff());
        force.x.push_back(term.t);
        force.y.push_back(term.Lambda.norm());
        largest = std::max(largest, size.y.back());
    }
    o.text = "y_1 = lambda_1 = 0: |h(y0, lambda0)| <= " + scientific(hidden_residual()) +
             " along the index-2 motion, (3.52) and (3.53) are homogeneous\nmax |Y| = " + decimal(largest) +
             ", |Y(1)| = " + decimal(size.y.back()) + ": the error at t = 1, where the disc is upright, is " +
             decimal(largest / size.y.back()) + " times smaller than on the way\n\n";
    o.figures = {{"fig_expansion",
                  "The error over ε as ε → 0, for every κ < 1 and d, c = 2",
                  "t [s]",
                  "|Y|, |Λ|",
                  false,
                  true,
                  {size, force}}};
    const double residual = hidden_residual();
    o.findings = {{"(3.53): |h(y0, lambda0)|", "y_1, lambda_1 = 0", scientific(residual), "0",
                   residual < 1e-9, compared(residual < 1e-9)}};
    leading_term(o);
    corollary_3(o);
    corollary_4(o);
    return o;
}

}  // namespace thesis
