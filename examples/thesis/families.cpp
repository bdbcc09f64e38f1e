// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <stagecraft/tableaux/exact_tableau.hpp>
#include <stagecraft/theory/dae/dae_order.hpp>

#include <problems/thesis/solve.hpp>
#include "experiments.hpp"
#include "wide.hpp"

namespace thesis {

namespace {

struct orders {
    int y, lambda;
};

// What HLR89 has for s stages (table of section 4; Theorems 4.6 and 4.8 to 4.10; section 5 for Lobatto IIIC).
orders promised(family f, int s) {
    switch (f) {
        case family::gauss:
            return s % 2 == 1 ? orders{s + 1, s - 1} : orders{s, s - 2};
        case family::radau_ia:
            return {s, s - 1};
        case family::lobatto_iiic:
            return {2 * s - 2, s - 1};
        default:
            return {2 * s - 1, s};
    }
}

const char* display(family f) {
    switch (f) {
        case family::gauss:
            return "Gauss";
        case family::radau_ia:
            return "Radau IA";
        case family::lobatto_iiic:
            return "Lobatto IIIC";
        default:
            return "Radau IIA";
    }
}

int classical_order(family f, int s) {
    return f == family::gauss ? 2 * s : f == family::lobatto_iiic ? 2 * s - 2 : 2 * s - 1;
}

// Every theorem on index 2, decided exactly for the 3-stage member: which hypothesis fails, and with what.
std::string theorems(const stagecraft::tableau<stagecraft::tableaux::quadratic>& t) {
    std::string text;
    for (const auto& p : stagecraft::theory::index2_theorems(t)) {
        std::string failing;
        for (const auto& h : p.hypotheses)
            if (!h.verdict.is_proved())
                failing += (failing.empty() ? "" : "; ") + h.name + " fails: " + h.verdict.reason();
        text += "    " + p.theorem + ": ";
        text += p.applies() ? "y " + std::to_string(*p.y) + ", lambda " + std::to_string(*p.z) : failing;
        text += '\n';
    }
    return text;
}

// Section 4.1.2: Radau IIA-3 does not satisfy C(4). The thesis prints the sum with c_1^3 for c_j^3, and its value
// with c_j^3.
void example_for_c_4(outcome& o) {
    const auto t = *stagecraft::tableaux::exact_tableau(family::radau_iia, 3);
    double sum = 0, with_c_1 = 0;
    const double c1 = t.c(0).to<double>();
    for (int j = 0; j < 3; ++j) {
        const double a = t.A(0, j).to<double>();
        sum += a * std::pow(t.c(j).to<double>(), 3);
        with_c_1 += a * std::pow(c1, 3);
    }
    const double right = std::pow(c1, 4) / 4;
    o.findings.push_back({"C(4): sum a_1j c_j^3", "0.0069", scientific(sum), "> " + scientific(right),
                          sum > right, compared(0.0069, sum, 5e-5)});
    o.findings.push_back(
        {"C(4): c_1^4/4", "0.00014", scientific(right), "", right < sum, compared(0.00014, right, 5e-6)});
    o.findings.push_back(
        {"C(4): sum a_1j c_1^3, as printed", "0.0069", scientific(with_c_1), "c_1^4",
         std::abs(with_c_1 / (4 * right) - 1) < 1e-12,
         compared(0.0069, with_c_1, 5e-5, "c_1^3 stands for c_j^3", std::abs(sum - 0.0069) < 5e-5)});
}

}  // namespace

outcome other_methods() {
    outcome o{"Beyond the thesis: other families, 2 to 9 stages, at 50 digits (index-2 system)", {}, {}, {}};
    constexpr int least = 2, most = 9;
    const std::vector<int> steps{12, 24, 48}, last_two{24, 48};
    figure fy{"fig_families_y",
              "Index-2 system with 5 stages, 50 digits: error in q, q'",
              "h [s]",
              "maximum error",
              true,
              true,
              {}};
    figure fl{"fig_families_lambda",
              "Index-2 system with 5 stages, 50 digits: error in λ",
              "h [s]",
              "maximum error",
              true,
              true,
              {}};
    figure fs{"fig_stages",
              "Index-2 system, s stages, h = 1/240 s",
              "s",
              "maximum error in q, q'",
              false,
              true,
              {}};
    o.text =
        "Equal steps over [0, 0.2]; orders between h = 1/120 and 1/240 s, in brackets what theory has;\n"
        "loss: classical order minus order of y, stages minus order of lambda.\n\n";
    for (const family f : {family::radau_iia, family::gauss, family::radau_ia, family::lobatto_iiic}) {
        const std::string name = display(f);
        const auto exact = stagecraft::tableaux::exact_tableau(f, 3);
        o.text += name + ", hypotheses decided exactly for s = 3:\n" + theorems(*exact);
        const auto best = stagecraft::theory::predict_index2(*exact);
        o.findings.push_back({"theorems for " + name + " 3: y, lambda", "",
                              std::to_string(*best.y) + ", " + std::to_string(*best.z),
                              std::to_string(promised(f, 3).y) + ", " + std::to_string(promised(f, 3).lambda),
                              *best.y == promised(f, 3).y && *best.z == promised(f, 3).lambda});
        finding of_y{"order of y, " + name + " 2 to 9", "", "", "", true},
            of_lambda{"order of lambda, " + name + " 2 to 9", "", "", "", true};
        curve stages{name, {}, {}, true};
        for (int s = least; s <= most; ++s) {
            const auto e = errors_at_50_digits(f, s, s == 5 ? steps : last_two);
            const wide_error &coarse = e[e.size() - 2], &fine = e.back();
            const double y = std::log2(coarse.y / fine.y), lambda = std::log2(coarse.lambda / fine.lambda);
            const orders theory = promised(f, s);
            const auto add = [](finding& row, double seen, int expected) {
                const std::string gap = row.theory.empty() ? "" : " ";
                row.ours += gap + one_decimal(seen);
                row.theory += gap + std::to_string(expected);
                row.agrees = row.agrees && seen > expected - 0.3;
            };
            add(of_y, y, theory.y);
            add(of_lambda, lambda, theory.lambda);
            o.text += "  s = " + std::to_string(s) + ": y " + decimal(y) + " (" + std::to_string(theory.y) +
                      "), loss " + std::to_string(classical_order(f, s) - theory.y) + "; lambda " +
                      decimal(lambda) + " (" + std::to_string(theory.lambda) + "), loss " +
                      std::to_string(s - theory.lambda) + "; errors at h = 1/240: " + scientific(fine.y) +
                      ", " + scientific(fine.lambda) + "\n";
            stages.x.push_back(s);
            stages.y.push_back(fine.y);
            if (s == 5) {
                curve cy{name, {}, {}, true}, cl = cy;
                for (std::size_t k = 0; k < steps.size(); ++k) {
                    cy.x.push_back(0.2 / steps[k]), cy.y.push_back(e[k].y);
                    cl.x.push_back(0.2 / steps[k]), cl.y.push_back(e[k].lambda);
                }
                cy.title += ", order " + one_decimal(y);
                cl.title += ", order " + one_decimal(lambda);
                fy.curves.push_back(cy);
                fl.curves.push_back(cl);
            }
        }
        o.text += '\n';
        of_y.theory = ">= " + of_y.theory;
        of_lambda.theory = ">= " + of_lambda.theory;
        o.findings.push_back(of_y);
        o.findings.push_back(of_lambda);
        if (f == family::radau_iia)
            o.findings.push_back({"error falls with every stage, s = 2 ... 9", "",
                                  scientific(stages.y.back()), "h^(2s-1)",
                                  std::is_sorted(stages.y.rbegin(), stages.y.rend())});
        fs.curves.push_back(stages);
    }
    fy.slopes = {{9, 0}, {5, 2}};
    fl.slopes = {{5, 0}, {4, 2}};
    example_for_c_4(o);
    o.figures = {fy, fl, fs};
    return o;
}

}  // namespace thesis
