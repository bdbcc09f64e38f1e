// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <stagecraft/theory/export/coq_squares.hpp>
#include <stagecraft/theory/export/coq_statement.hpp>
#include <stagecraft/theory/stability/a_stability.hpp>
#include <stagecraft/theory/stability/stability_function.hpp>
#include <string>
#include <utility>
#include <vector>

/// What an exported file says of R(z).
namespace stagecraft::theory::coq {

using plane_polynomial = std::vector<polynomial<scalar>>;  ///< in u, of polynomials in y; z = -u + iy

inline polynomial<scalar> part(const plane_polynomial& p, std::size_t j) {
    return j < p.size() ? p[j] : polynomial<scalar>();
}
inline plane_polynomial sum(const plane_polynomial& p, const plane_polynomial& r, int sign = 1) {
    plane_polynomial out;
    for (std::size_t j = 0; j < std::max(p.size(), r.size()); ++j)
        out.push_back(part(p, j) + part(r, j) * polynomial<scalar>(scalar(sign)));
    return out;
}
inline plane_polynomial product(const plane_polynomial& p, const plane_polynomial& r) {
    plane_polynomial out(p.size() + r.size());
    for (std::size_t i = 0; i < p.size(); ++i)
        for (std::size_t j = 0; j < r.size(); ++j) out[i + j] = out[i + j] + p[i] * r[j];
    return out;
}

/// |p(-u + iy)|^2, by Horner's rule.
inline plane_polynomial modulus_squared(const polynomial<scalar>& p) {
    plane_polynomial re, im;
    const plane_polynomial minus_u{{}, polynomial<scalar>(scalar(-1))};
    const plane_polynomial y{polynomial<scalar>{scalar(0), scalar(1)}};
    for (int k = p.degree(); k >= 0; --k) {
        auto next = sum(product(re, minus_u), product(im, y), -1);
        im = sum(product(im, minus_u), product(re, y));
        re = sum({polynomial<scalar>(p[k])}, next);
    }
    return sum(product(re, re), product(im, im));
}

/// Whether no coefficient is negative, and those of odd powers of y vanish: then p >= 0 for u >= 0.
inline bool no_negative_coefficient(const plane_polynomial& p) {
    for (const auto& c : p)
        for (int k = 0; k <= c.degree(); ++k)
            if (k % 2 == 0 ? tableaux::sign_of(c[k]) < 0 : !(c[k] == 0)) return false;
    return true;
}

/// Whether |Q|^2 - 1 and |Q|^2 - |P|^2 have no negative coefficient: then |P/Q| <= 1 and Q != 0 for Re z <= 0.
inline bool a_stable_by_signs(const stability_function<scalar>& r) {
    const auto q = modulus_squared(r.denominator);
    return no_negative_coefficient(sum(q, {polynomial<scalar>(scalar(-1))})) &&
           no_negative_coefficient(sum(q, modulus_squared(r.numerator), -1));
}

/// Sums of squares for |Q|^2 - |P|^2, and for |Q|^2 - e with some e > 0.
struct a_stability_squares {
    half_plane_squares growth, poles;
    scalar e;
};
inline std::optional<a_stability_squares> a_stable_by_squares(const stability_function<scalar>& r) {
    const int n = std::max(r.numerator.degree(), r.denominator.degree()) + 1;
    form q(n, n), g(n, n);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            q(i, j) = r.denominator[i] * r.denominator[j];
            g(i, j) = q(i, j) - r.numerator[i] * r.numerator[j];
        }
    const auto growth = squares_on_half_plane(g);
    if (!growth) return {};
    scalar e(tableaux::rational(1, 2));
    for (int bits = 1; bits <= 40; ++bits, e /= scalar(2)) {
        form less = q;
        less(0, 0) -= e;
        if (const auto poles = squares_on_half_plane(less)) return {{*growth, *poles, e}};
    }
    return {};
}

/// A y with |R(iy)| > 1 by bisection towards one whose square is known.
inline std::optional<scalar> growth_on_axis(const stability_function<scalar>& r) {
    const auto e = e_polynomial(r);
    const auto square = tableaux::negative_point_from_zero(in_square(e));
    if (!square) return {};
    scalar low(0), high = *square + scalar(1);
    for (int k = 0; k < 400; ++k) {
        const scalar y = (low + high) / scalar(2);
        if (tableaux::sign_of(e(y)) < 0) return y;
        (tableaux::sign_of(y * y - *square) < 0 ? low : high) = y;
    }
    return {};
}

/// A point x + iy with x <= 0 and |P| > |Q|: one of a grid, on the imaginary axis where there is one, else any on that axis.
inline std::optional<std::array<scalar, 2>> point_of_growth(const stability_function<scalar>& r) {
    const auto squared = [](const polynomial<scalar>& p, const scalar& x, const scalar& y) {
        scalar re(0), im(0);
        for (int k = p.degree(); k >= 0; --k) {
            const scalar next = p[k] + x * re - y * im;
            im = x * im + y * re;
            re = next;
        }
        return scalar(re * re + im * im);
    };
    std::vector<tableaux::rational> steps{0};
    for (int k = -6; k <= 10; ++k)
        for (int m = 2; m <= 3; ++m)
            steps.push_back(k < 0 ? tableaux::rational(m, 1 << -k) : tableaux::rational(m << k));
    for (const auto& x : steps)
        for (const auto& y : steps)
            if (tableaux::sign_of(squared(r.numerator, -x, y) - squared(r.denominator, -x, y)) > 0)
                return {{scalar(-x), scalar(y)}};
    if (const auto y = growth_on_axis(r)) return {{scalar(0), *y}};
    return {};
}

/// How many zeros q needs behind it for Coq's recurrence of stages to end; nothing where it does not.
inline std::optional<int> padding(const coq_method& m, const polynomial<scalar>& q) {
    const auto vanishes = [](const coq_method::element& v) {
        return std::all_of(v.begin(), v.end(), [](const auto& x) { return x == 0; });
    };
    coq_method::element y(m.beta.size());
    const auto one = m.one();
    for (int k = 0; k <= m.stages(); ++k) {
        y = m.apply(y);
        if (k > q.degree() && vanishes(y)) return k - q.degree() - 1;
        for (std::size_t i = 0; i < y.size(); ++i) y[i] += scalar(q[k]) * one[i];
    }
    if (vanishes(m.apply(y))) return m.stages() - q.degree();
    return {};
}

inline std::vector<scalar> coefficients_of(const polynomial<scalar>& p) {
    std::vector<scalar> v;
    for (int k = 0; k <= p.degree(); ++k) v.push_back(p[k]);
    return v;
}
inline std::string definition(const char* name, const polynomial<scalar>& p) {
    return std::string("Definition ") + name + " : list coefficient :=\n  " +
           coefficients(coefficients_of(p)) + ".\n";
}

/// The theorem that |R| <= 1 on the left half-plane, where one of the two ways shows it; else nothing.
inline std::string a_stability_theorem(const stability_function<scalar>& r) {
    const std::string statement = "a_stable d_positive top bottom";
    if (a_stable_by_signs(r))
        return "(** |Q|^2 - 1 and |Q|^2 - |P|^2 at z = -u + iy have no negative coefficient. *)\n" +
               proof("a_stable_method", statement, "apply (a_stable_is_checked d_positive).");
    const auto shown = a_stable_by_squares(r);
    if (!shown) return {};
    std::string out =
        "(** |Q|^2 - |P|^2 = sum of D |h|^2 + u sum of D |k|^2 at z = -u + iy, with the pairs (D, h) and (D, "
        "k); and so is\n"
        "    |Q|^2 - e. *)\n";
    const auto define = [&out](const char* name, const std::vector<square>& items) {
        out += std::string("Definition ") + name + " : squares :=\n" + text(items) + ".\n";
    };
    define("growth_on_axis", shown->growth.on_axis);
    define("growth_inside", shown->growth.inside);
    define("poles_on_axis", shown->poles.on_axis);
    define("poles_inside", shown->poles.inside);
    return out + proof("a_stable_method", statement,
                       "apply (a_stable_by_squares d_positive _ _ growth_on_axis growth_inside " +
                           pair(shown->e) + "%Q poles_on_axis poles_inside).");
}

inline std::string a_stability_theorems(const stability_function<scalar>& r,
                                        std::vector<std::string>& proved) {
    if (const auto shown = a_stability_theorem(r); !shown.empty()) {
        const bool l = r.numerator.degree() < r.denominator.degree();
        proved.push_back(l ? "L-stable" : "A-stable");
        if (l)
            return shown + "(** And R(infinity) = 0. *)\n" +
                   proof("l_stable_method", "l_stable d_positive top bottom",
                         "apply (l_stable_is_checked a_stable_method).");
        return shown +
               "(** R(infinity) is not 0: top has the degree of bottom. *)\n"
               "Theorem not_l_stable_method : ~ l_stable d_positive top bottom.\nProof.\n"
               "  intros [_ [L _]]. apply Nat.ltb_lt in L. vm_compute in L. discriminate.\nQed.\n\n";
    }
    if (const auto z = point_of_growth(r)) {
        proved.push_back("not A-stable");
        return "(** |R(z)| > 1 at z = " + (*z)[0].str() + " + " + (*z)[1].str() + " i. *)\n" +
               proof("not_a_stable_method", "~ a_stable d_positive top bottom",
                     "apply exceeds_one_refutes, (@exceeds_is_checked d d_positive top bottom " +
                         pair((*z)[0]) + "%Q " + pair((*z)[1]) + "%Q).");
    }
    return "(** A-stability is not exported: " + comment(a_stable(r).text()) +
           ", which needs more than the signs of coefficients. *)\n\n";
}

/// The theorems on R, and in `proved` what they say in a few words.
inline std::string stability_theorems(const coq_method& m, std::vector<std::string>& proved) {
    coq_method::element one = m.one();
    tableaux::column<scalar> b(m.stages()), e(m.stages());
    for (int i = 0; i < m.stages(); ++i) {
        b[i] = m.beta[static_cast<std::size_t>(i)];
        e[i] = one[static_cast<std::size_t>(i)];
    }
    const auto r = stability_function_of<scalar>(m.matrix(), b, e);
    const auto zeros = padding(m, r.denominator);
    polynomial<scalar> g(scalar(1));
    if (!zeros) {  // the stages have poles that R has not
        const auto q = tableaux::determinant_of_one_minus_z<scalar>(m.matrix());
        g = q / r.denominator;
    }
    return "(** R(z) = top / bottom. *)\n" + definition("top", r.numerator) +
           definition("bottom", r.denominator) + (zeros ? "" : definition("G", g)) +
           theorem(m, "stability_function_of_the_method", "stability_function", "top bottom", "function",
                   std::to_string(zeros.value_or(0)) + (zeros ? " [q 1]" : " G") + " top bottom") +
           a_stability_theorems(r, proved);
}

}  // namespace stagecraft::theory::coq
