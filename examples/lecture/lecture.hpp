// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/exact_tableau.hpp>
#include <stagecraft/theory/dynamics/rk_map.hpp>
#include <stagecraft/theory/plot/gnuplot.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "../thesis/page.hpp"

namespace lecture {

using namespace stagecraft;
using stagecraft::tableaux::rational;
namespace plot = stagecraft::theory::plot;

/// A picture of the lecture; `name` is the file name without ".svg".
struct picture {
    std::string name;
    plot::script script;
};

/// What a chapter has to show: pictures, and lines for the table printed / here / theory / verdict.
struct chapter {
    std::vector<picture> pictures;
    std::vector<thesis::finding> findings;

    void find(const std::string& what, const std::string& printed, const std::string& here,
              const std::string& theory, bool agrees) {
        findings.push_back({what, printed, here, theory, agrees});
    }
};

chapter chapter_1();
chapter chapter_2();
chapter chapter_3();

inline std::string number(double x, const char* format = "%.8g") {
    char text[40];
    std::snprintf(text, sizeof text, format, x);
    return text;
}

/// A tableau from rows of A and b; c = A 1.
inline tableau<rational> method(const std::vector<std::vector<rational>>& A, const std::vector<rational>& b) {
    tableau<rational> t;
    const auto s = static_cast<Eigen::Index>(b.size());
    t.A.resize(s, s);
    t.b.resize(s);
    t.c.resize(s);
    for (Eigen::Index i = 0; i < s; ++i) {
        t.b[i] = b[static_cast<std::size_t>(i)];
        t.c[i] = 0;
        for (Eigen::Index j = 0; j < s; ++j) {
            t.A(i, j) = A[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
            t.c[i] += t.A(i, j);
        }
    }
    return t;
}

/// The solution of x' = f from x at t = 0 by Gauss-2 with equal steps, until `end` or until it leaves `reach`:
/// points (t, x_1), or (x_1, x_2) with `phase`.
template <int N, class F>
plot::curve solution(const F& f, theory::state<double, N> x, double end, int steps, double reach,
                     bool phase = false) {
    static const auto gauss_2 = theory::in_doubles(*tableaux::exact_tableau(tableaux::family::gauss, 2));
    plot::curve c;
    const double h = end / steps;
    for (int n = 0; n <= steps; ++n) {
        if (phase)
            c.points.emplace_back(x[0], x[N - 1]);
        else
            c.points.emplace_back(n * h, x[N - 1]);
        const auto next = theory::rk_step<N>(gauss_2, f, x, h, n * h);
        if (!next || !(next->norm() < reach)) break;
        x = *next;
    }
    return c;
}

/// A picture of curves over t or in the plane. The title and the names may have sub- and superscripts, x_1 and x^2. With
/// `names`, one for each curve, they have colours and a legend.
inline picture curves(const std::string& name, const std::string& title, const std::vector<plot::curve>& all,
                      const plot::window& view, const std::string& x = "t", const std::string& y = "x",
                      const std::vector<std::string>& names = {}) {
    static constexpr std::array colours{"#1f4e79", "#d55e00", "#009e73", "#cc79a7", "#777777", "#e69f00"};
    plot::script p;
    p.size = {720, 480};
    p.set("set title " + plot::gnuplot_string(title) + " enhanced");
    p.set("set xrange [" + number(view.left) + ":" + number(view.right) + "]");
    p.set("set yrange [" + number(view.bottom) + ":" + number(view.top) + "]");
    p.set("set xlabel '" + x + "'").set("set ylabel '" + y + "'");
    p.set("set xzeroaxis lc rgb '#909090' lt 1").set("set yzeroaxis lc rgb '#909090' lt 1");
    if (names.empty())
        p.lines(all, "lc rgb '" + std::string(colours[0]) + "' lw 2");
    else
        p.set("set key outside bottom center horizontal height 1");
    for (std::size_t k = 0; k < names.size(); ++k)
        p.lines({all.at(k)}, "lc rgb '" + std::string(colours[k % colours.size()]) + "' lw 2 title " +
                                 plot::gnuplot_string(names[k]));
    return {name, std::move(p)};
}

/// "x(0) = a" for each start a.
inline std::vector<std::string> named_by_start(const std::vector<double>& starts) {
    std::vector<std::string> names;
    for (const double x : starts) names.push_back("x(0) = " + number(x));
    return names;
}

}  // namespace lecture
