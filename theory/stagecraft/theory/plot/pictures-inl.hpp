// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/plot/pictures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory::plot {

namespace colours {
inline constexpr const char* boundary = "lc rgb '#1f4e79' lw 2";
inline constexpr const char* zero = "pt 6 ps 0.9 lw 1.5 lc rgb '#2e7d32'";
inline constexpr const char* pole = "pt 2 ps 0.9 lw 1.5 lc rgb '#b71c1c'";
}  // namespace colours

STAGECRAFT_INLINE void zeros_and_poles(script& p, const rational_function& r) {
    p.set("set key below");
    p.points(r.roots(), colours::zero + std::string(" title 'zeros of R'"));
    p.points(r.poles(), colours::pole + std::string(" title 'poles of R'"));
}

STAGECRAFT_INLINE script region_picture(const std::string& name, const rational_function& r,
                                        const window& view, const std::string& subtitle) {
    script p;
    p.plane(view).title("Stability region: " + name, subtitle);
    p.patches(shades([&](complex z) { return std::abs(r(z)) <= 1 ? 0.0 : 1.0; }, view, 900, 450, 1),
              [](int) { return colours::inside; });
    p.legend("|R| \u2264 1 of " + name, colours::inside);
    p.lines(region_boundary(r, view), colours::boundary);
    zeros_and_poles(p, r);
    return p;
}

STAGECRAFT_INLINE line_style region_line(std::size_t k) {
    static const line_style all[most_regions] = {
        {"#1f4e79", {}}, {"#b71c1c", {10, 4}}, {"#2e7d32", {4, 4}}, {"#d17a00", {12, 4, 3, 4}},
        {"#6a1b9a", {}}, {"#00838f", {10, 4}}, {"#5d4037", {4, 4}}, {"#303030", {12, 4, 3, 4}}};
    return all[k % most_regions];
}

STAGECRAFT_INLINE std::string region_shade(std::size_t of_them, std::size_t all) {
    const double part = all < 2 ? 0.5 : static_cast<double>(of_them - 1) / static_cast<double>(all - 1);
    const auto between = [part](int pale, int dark) { return static_cast<int>(pale + part * (dark - pale)); };
    char colour[8];
    std::snprintf(colour, sizeof colour, "#%02x%02x%02x", between(0xec, 0xb4), between(0xf3, 0xcd),
                  between(0xfa, 0xe6));
    return colour;
}

STAGECRAFT_INLINE window common_window(const std::vector<named_function>& methods) {
    window all = region_window(methods.at(0).r);
    for (const auto& m : methods) {
        const window w = region_window(m.r);
        all = {std::min(all.left, w.left), std::max(all.right, w.right), std::min(all.bottom, w.bottom),
               std::max(all.top, w.top)};
    }
    return all;
}

STAGECRAFT_INLINE int regions_outside(const std::vector<named_function>& methods, complex z) {
    return static_cast<int>(std::count_if(methods.begin(), methods.end(),
                                          [z](const auto& m) { return !(std::abs(m.r(z)) <= 1); }));
}

STAGECRAFT_INLINE void require_regions(const std::vector<named_function>& methods) {
    if (methods.empty() || methods.size() > most_regions)
        throw std::invalid_argument("METHOD: " + std::to_string(methods.size()) +
                                    " methods, region takes 1 to " + std::to_string(most_regions));
}

STAGECRAFT_INLINE std::vector<patch> region_patches(const std::vector<named_function>& methods,
                                                    const window& view, int columns, int rows) {
    const int n = static_cast<int>(methods.size());
    const auto value = [&](complex z) { return (regions_outside(methods, z) + 0.5) / n; };
    return shades(value, view, columns, rows, n);
}

STAGECRAFT_INLINE script regions_picture(const std::vector<named_function>& methods, const window& view) {
    require_regions(methods);
    const std::size_t n = methods.size();
    script p;
    std::size_t longest = 0;
    for (const auto& m : methods) longest = std::max(longest, m.name.size());
    p.size.width = std::max(p.size.width, 260 + 7 * static_cast<int>(std::min<std::size_t>(longest, 140)));
    p.plane(view).title("Stability regions");
    p.patches(region_patches(methods, view, 900, 450),
              [n](int outside) { return region_shade(n - static_cast<std::size_t>(outside), n); });
    p.set("set key below left Left reverse maxcols 1 font ',12'");
    p.size.height += 22 * static_cast<int>(n + 1);
    for (std::size_t k = 0; k < n; ++k) {
        const line_style style = region_line(k);
        std::string dashes;
        for (const int length : style.dashes) dashes += (dashes.empty() ? "" : ",") + std::to_string(length);
        p.lines(region_boundary(methods[k].r, view),
                "lc rgb '" + std::string(style.colour) + "' lw 2 dt " +
                    (dashes.empty() ? "1" : "(" + dashes + ")") + " title " +
                    gnuplot_string("|R| \u2264 1 of " + methods[k].name) + " noenhanced");
    }
    p.legend("|R| \u2264 1 of all of them", region_shade(n, n));
    if (n > 1) p.legend("|R| \u2264 1 of one of them", region_shade(1, n));
    return p;
}

STAGECRAFT_INLINE script order_star_picture(const std::string& name, const star& s, const window& view,
                                            const std::string& subtitle) {
    script p;
    p.plane(view).title("Order star: " + name, subtitle);
    const double blind = s.blind_radius();
    p.patches(shades(
                  [&](complex z) {
                      if (std::abs(z) >= blind) return s.log(z).log_modulus > 0 ? 0.0 : 1.0;
                      // R e^(-z) = 1 - C z^(p+1) + ...: the sign of the leading term
                      return -(s.error_constant * std::pow(z, s.order + 1)).real() > 0 ? 0.0 : 1.0;
                  },
                  view, 700, 700, 1),
              [](int) { return colours::inside; });
    p.lines(order_star_boundary(s, view), colours::boundary);
    zeros_and_poles(p, s.r);
    return p;
}

STAGECRAFT_INLINE script grey_picture(const std::string& name, const rational_function& r,
                                      const window& view) {
    constexpr int levels = 16;
    script p;
    p.plane(view).title("min(1, |R(z)|): " + name);
    p.patches(shades([&](complex z) { return std::abs(r(z)); }, view, 360, 240, levels), [](int level) {
        char colour[8];
        const int grey = 40 + 200 * level / levels;
        std::snprintf(colour, sizeof colour, "#%02x%02x%02x", grey, grey, grey);
        return std::string(colour);
    });
    p.lines(region_boundary(r, view), "lc rgb 'black' lw 1");
    return p;
}

STAGECRAFT_INLINE script real_axis_picture(const std::vector<named_function>& methods, double from, double to,
                                           double bottom, double top) {
    static constexpr const char* colour[] = {"#b71c1c", "#2e7d32", "#1f4e79", "#e08e0b", "#6a1b9a"};
    script p;
    p.size.height = 440;
    p.title("Stability functions and the exponential on the real axis");
    const auto range = [](double a, double b) {
        return "[" + std::to_string(a) + ":" + std::to_string(b) + "]";
    };
    p.set("set xrange " + range(from, to)).set("set yrange " + range(bottom, top)).set("set xlabel 'z'");
    p.set("set key top left noenhanced").set("set xzeroaxis lt 1 lc rgb '#909090'");
    p.set("set yzeroaxis lt 1 lc rgb '#909090'");
    p.lines(graph([](double x) { return std::exp(x); }, from, to, bottom, top),
            "lc rgb 'black' lw 3 title 'e^z'");
    for (std::size_t k = 0; k < methods.size(); ++k)
        p.lines(graph([&](double x) { return methods[k].r(x).real(); }, from, to, bottom, top),
                "lc rgb '" + std::string(colour[k % 5]) + "' lw 2 title " + gnuplot_string(methods[k].name));
    return p;
}

STAGECRAFT_INLINE script e_polynomial_picture(const std::string& name, const rational_function& r,
                                              const std::vector<double>& e, const std::string& subtitle) {
    double far = 1;
    for (const complex z : r.poles()) far = std::max(far, std::abs(z));
    for (const complex z : zeros({e.begin(), e.end()}))
        if (std::abs(z.imag()) < 1e-6 * std::abs(z)) far = std::max(far, 1.3 * z.real());
    const auto value = [&](double y) {
        double sum = 0;
        for (auto k = e.size(); k-- > 0;) sum = sum * y + e[k];
        return sum;
    };
    script p;
    p.size.height = 440;
    p.title("E-polynomial: " + name, subtitle);
    p.set("set xrange [0:" + std::to_string(far) + "]").set("set xlabel 'y'").set("set ylabel 'E(y)'");
    p.set("set xzeroaxis lt 1 lc rgb '#909090'");
    if (e.empty()) p.set("set yrange [-1:1]");
    const double all = std::numeric_limits<double>::infinity();
    p.lines(graph(value, 0, far, -all, all), colours::boundary);
    return p;
}

STAGECRAFT_INLINE script tableau_picture(const std::string& name, const cells& t,
                                         const std::string& subtitle) {
    const int s = static_cast<int>(t.b.size());
    const int rows = s + (t.b_embedded.empty() ? 1 : 2);
    std::size_t longest = 4;
    double largest = 0;
    for (const auto& row : t.A)
        for (const auto& a : row) longest = std::max(longest, a.size());
    for (const auto* v : {&t.b, &t.c, &t.b_embedded})
        for (const auto& a : *v) longest = std::max(longest, a.size());
    for (const auto& row : t.values)
        for (const double a : row) largest = std::max(largest, std::abs(a));
    script p;
    const int column = 16 + 8 * static_cast<int>(longest);
    p.size = {std::max(420, column * (s + 1) + 80), 34 * rows + 110};
    p.title(name, subtitle);
    p.set("unset border\nunset tics\nunset grid\nset margins 2,2,1,4");
    p.set("set xrange [-1:" + std::to_string(s) + "]").set("set yrange [" + std::to_string(-rows) + ":0]");
    std::vector<patch> fills[2];
    for (int i = 0; i < s; ++i) {
        p.label(t.c[i], -0.5, -i - 0.5);
        for (int j = 0; j < s; ++j) {
            p.label(t.A[i][j], j + 0.5, -i - 0.5);
            const double a = t.values[i][j];
            if (a == 0) continue;
            const int strength = 1 + static_cast<int>(4 * std::sqrt(std::abs(a) / largest));
            fills[a < 0].push_back({double(j), double(j + 1), double(-i - 1), -i - 0.1, strength});
        }
        p.label(t.b[i], i + 0.5, -s - 0.5);
        if (!t.b_embedded.empty()) p.label(t.b_embedded[i], i + 0.5, -s - 1.5);
    }
    const auto tint = [](int strength, bool negative) {
        char colour[8];
        const int fade = 255 - 14 * strength;
        std::snprintf(colour, sizeof colour, "#%02x%02x%02x", negative ? 255 : fade, fade,
                      negative ? fade : 255);
        return std::string(colour);
    };
    p.patches(fills[0], [&](int k) { return tint(k, false); });
    p.patches(fills[1], [&](int k) { return tint(k, true); });
    p.lines({{{{-1, double(-s)}, {double(s), double(-s)}}, false}, {{{0, 0}, {0, double(-rows)}}, false}},
            "lc rgb 'black' lw 1.5");
    return p;
}

}  // namespace stagecraft::theory::plot
