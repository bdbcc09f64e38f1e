// SPDX-License-Identifier: BSL-1.0
// Chapter 3: stability in the sense of Lyapunov.
#include <stagecraft/theory/dynamics/lyapunov.hpp>
#include <stagecraft/theory/dynamics/lyapunov_function.hpp>

#include "lecture.hpp"
#include "portrait.hpp"

namespace lecture {

namespace {

using theory::state;

const auto node = [](const auto&, const auto& x, auto& f) {
    f[0] = -x[0] - x[0] * x[1];
    f[1] = -x[0] - 2 * x[1] + x[0] * x[1];
};
const auto centre = [](const auto&, const auto& x, auto& f) {
    f[0] = 2 * x[1] - x[0] * x[1];
    f[1] = -x[0] / 2 + x[0] * x[1] * x[1];
};
const auto routh_1 = [](const auto&, const auto& x, auto& f) {
    f[0] = -x[1] + x[0] * x[0] * x[0];
    f[1] = x[0];
};
const auto routh_2 = [](const auto&, const auto& x, auto& f) {
    f[0] = -x[1] - x[0] * x[0] * x[0];
    f[1] = x[0];
};

template <class F>
std::vector<plot::curve> orbits(const F& f, const std::vector<state<double, 2>>& starts, double end) {
    std::vector<plot::curve> all;
    for (const auto& x : starts) all.push_back(solution<2>(f, x, end, 4000, 40, true));
    return all;
}

void draw(chapter& out) {
    const auto cubic = [](const auto&, const auto& x, auto& f) { f[0] = x[0] - x[0] * x[0] * x[0]; };
    std::vector<plot::curve> all;
    const std::vector<double> starts{-1, -0.2, 0, 0.1, 1, 1.5};
    for (const double x : starts) all.push_back(solution<1>(cubic, state<double, 1>(x), 6, 400, 10));
    out.pictures.push_back(curves("p50_x_minus_cube",
                                  "x' = x - x^3: 1 and -1 are asymptotically stable, 0 is unstable", all,
                                  {0, 6, -1.2, 1.6}, "t", "x", named_by_start(starts)));
    out.pictures.push_back(portrait(
        "p56_node", "x_1' = -x_1 - x_1 x_2, x_2' = -x_1 - 2 x_2 + x_1 x_2",
        orbits(node, {{-2, 2}, {-2, -2}, {-1, -2}, {2, 2}, {3, 1}, {3, 0.5}, {0.8, -2}, {0.5, -2}}, 12),
        {-3, 3.5, -3, 3}, {{0, 0}, {1, -1}}));
    out.pictures.push_back(
        portrait("p57_centre", "x_1' = 2 x_2 - x_1 x_2, x_2' = -x_1/2 + x_1 x_2^2: a centre at 0",
                 orbits(centre, {{-3, 1.5}, {-3, 0}, {-2, 0}, {-1, 0}, {-0.5, 0}, {1.5, -2}, {2.5, 0.5}}, 14),
                 {-4, 4, -2.5, 2.5}, {{0, 0}, {2, std::sqrt(0.5)}, {2, -std::sqrt(0.5)}}));
    out.pictures.push_back(curves("p57_routh_1", "Routh 1: x_1' = -x_2 + x_1^3, x_2' = x_1: x_2(t) grows",
                                  {solution<2>(routh_1, {0.1, 0}, 100, 8000, 40)}, {0, 100, -0.22, 0.22}, "t",
                                  "x_2"));
    out.pictures.push_back(curves("p58_routh_2", "Routh 2: x_1' = -x_2 - x_1^3, x_2' = x_1: x_2(t) decays",
                                  {solution<2>(routh_2, {0.1, 0}, 100, 8000, 40)}, {0, 100, -0.11, 0.11}, "t",
                                  "x_2"));
}

template <class F>
double radius_at_100(const F& f) {
    const auto orbit = solution<2>(f, {0.1, 0}, 100, 20'000, 40, true);
    return std::abs(orbit.points.back());
}

}  // namespace

chapter chapter_3() {
    chapter out;
    draw(out);
    theory::dense<rational> B(2, 2), one = theory::euclidean(2);
    B << rational(-1), rational(0), rational(-1), rational(-2);
    const auto G = theory::solve_lyapunov(B, one);
    const std::string text =
        "[" + G(0, 0).str() + ", " + G(0, 1).str() + "; " + G(1, 0).str() + ", " + G(1, 1).str() + "]";
    out.find("first portrait: G with G B + B^T G = -1", "exists", text, "[7/12, -1/12; -1/12, 1/4]",
             text == "[7/12, -1/12; -1/12, 1/4]");
    const auto a = theory::attraction_radius<2>(node, theory::origin<2>());
    out.find("first portrait: (0, 0)", "asymptotically stable",
             "attracts |x| <= " + number(a.euclidean_radius(), "%.3f"), "alpha = -1 < 0",
             a.verdict.is_proved());

    // Lemma 3.3 prints <x, x> <= gamma |x|^2 in its last line: with B it is proved, without it fails for gamma < 1
    const rational gamma(-1, 2);
    const auto H = theory::inner_product(B, gamma);
    const bool with_B = theory::bounds(gamma, H, theory::symmetric_part<rational>(H, B)),
               without_B = theory::bounds(gamma, H, H);
    out.find("Lemma 3.3: <Bx, x> <= gamma |x|^2, gamma = -1/2",
             without_B ? "holds without B" : "fails without B", with_B ? "proved" : "fails", "holds",
             with_B && !without_B);
    // Satz 3.7 prints kappa without gamma: positive then, and no solution would be bounded by e^(kappa t) decaying
    const double kappa = theory::perron_rate(gamma, H, rational(1, 10)),
                 condition =
                     (theory::largest_eigenvalue(one, H).high * theory::largest_eigenvalue(H, one).high)
                         .to<double>();
    out.find("Satz 3.7: rate kappa for |h| <= |x|/10 (misprint)", "epsilon eta_2/eta_1 > 0",
             number(kappa, "%.3f"), "gamma + epsilon eta_2/eta_1 < 0",
             kappa < 0 && std::abs(kappa + 0.5 - 0.1 * std::sqrt(condition)) < 1e-6);

    theory::state<theory::multinomial, 2> x, f;
    for (int i = 0; i < 2; ++i) x[i] = theory::multinomial::unknown(i);
    centre(0, x, f);
    const bool zero = (f[0] * x[0] * (1 - 2 * x[1] * x[1]) + f[1] * 2 * x[1] * (2 - x[0])).is_zero();
    out.find("second portrait: (0, 0)", "left open",
             zero ? "centre: V' = 0 identically" : "no first integral",
             "V = -x1 - 2 ln(1 - x1/2) - ln(1 - 2 x2^2)/2", zero);

    const double grown = radius_at_100(routh_1), shrunk = radius_at_100(routh_2);
    out.find("Routh 1 from 0.1: |x(100)|", "not asymptotically stable", number(grown, "%.5f"),
             "0.19807 (unstable)", std::abs(grown - 0.19807) < 5e-6);
    out.find("Routh 2 from 0.1: |x(100)|", "stable", number(shrunk, "%.5f"),
             "0.07570 (asymptotically stable)", std::abs(shrunk - 0.07570) < 5e-6);
    const auto v = [](const auto& y) { return y[0] * y[0] + y[1] * y[1]; };
    const auto good = theory::lyapunov_function<2>(v, routh_2),
               bad = theory::lyapunov_function<2>(v, routh_1);
    out.find("|x|^2 is a Lyapunov function of Routh 2", "yes", good.is_proved() ? "proved" : "not proved",
             "yes", good.is_proved());
    out.find("|x|^2 is a Lyapunov function of Routh 1", "no", bad.is_refuted() ? "refuted" : "not refuted",
             "d/dt |x|^2 = 2 x1^4", bad.is_refuted());
    return out;
}

}  // namespace lecture
