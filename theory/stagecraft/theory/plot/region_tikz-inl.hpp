// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/plot/region_tikz.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <sstream>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory::plot {

STAGECRAFT_INLINE std::string tex_escaped(std::string_view text) {
    static constexpr std::string_view special = "#$%&_{}";
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char ch = text[i];
        if (text.substr(i, 3) == "\u221a") {
            out += "$\\surd$";
            i += 2;
        } else if (special.find(ch) != std::string_view::npos) {
            out.append("\\").push_back(ch);
        } else if (ch == '\\') {
            out += "\\textbackslash{}";
        } else if (ch == '~' || ch == '^') {
            out.append("\\").append(1, ch).append("{}");
        } else if (ch == '<' || ch == '>' || ch == '|') {
            out.append("$").append(1, ch).append("$");
        } else {
            out += static_cast<unsigned char>(ch) < ' ' ? ' ' : ch;
        }
    }
    return out;
}

namespace detail {

inline constexpr double tikz_width = 10;  // cm

/// A picture in centimetres, y upwards from the lower edge of the window.
struct tikz_plane {
    window view;
    double scale;
    std::ostringstream text;

    explicit tikz_plane(const window& w) : view(w), scale(tikz_width / w.width()) {
        text << std::fixed << std::setprecision(3);
    }
    complex at(complex z) const { return scale * (z - complex(view.left, view.bottom)); }
    tikz_plane& point(complex cm) {
        text << '(' << cm.real() << ',' << cm.imag() << ')';
        return *this;
    }
    tikz_plane& write(std::string_view what) {
        text << what;
        return *this;
    }
};

STAGECRAFT_INLINE std::string xcolor(std::string_view colour) {
    std::string name = "stagecraft";
    for (const char ch : colour.substr(1)) name += ch;
    return name;
}

STAGECRAFT_INLINE void define_colours(tikz_plane& p, std::vector<std::string> all) {
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    for (const std::string& c : all) {
        std::string html = c.substr(1);
        std::transform(html.begin(), html.end(), html.begin(), [](char ch) {
            return ch >= 'a' && ch <= 'f' ? static_cast<char>(ch - 'a' + 'A') : ch;
        });
        p.write("\\definecolor{" + xcolor(c) + "}{HTML}{" + html + "}\n");
    }
}

/// The parts of a curve near the window, without points closer than a fifth of a millimetre: TeX has no lengths above 5 m.
STAGECRAFT_INLINE void draw_curve(tikz_plane& p, const curve& c, const std::string& style) {
    complex last = 0;
    bool drawing = false;
    for (std::size_t k = 0; k < c.points.size(); ++k) {
        const complex z = p.at(c.points[k]);
        if (p.view.distance(c.points[k]) > 0.1 * p.view.diagonal()) {
            if (drawing) p.write(";\n");
            drawing = false;
        } else if (!drawing) {
            p.write("\\draw[" + style + "] ").point(last = z);
            drawing = true;
        } else if (std::abs(z - last) > 0.02 || k + 1 == c.points.size()) {
            p.write(" -- ").point(last = z);
        }
    }
    if (drawing) p.write(";\n");
}

/// 1, 2 or 5 times a power of 10, so that there are four to ten ticks.
STAGECRAFT_INLINE double tick_distance(double length) {
    const double power = std::pow(10.0, std::floor(std::log10(length / 4)));
    for (const double m : {5.0, 2.0})
        if (m * power <= length / 4) return m * power;
    return power;
}

STAGECRAFT_INLINE std::string tick_text(double x) {
    std::ostringstream text;
    text << std::setprecision(6) << (std::abs(x) < 1e-12 ? 0.0 : x);
    return "$" + text.str() + "$";
}

STAGECRAFT_INLINE void draw_axes(tikz_plane& p) {
    const window& w = p.view;
    const double high = p.scale * w.height();
    if (w.left < 0 && w.right > 0)
        p.write("\\draw[gray] ")
            .point({p.at(0).real(), 0})
            .write(" -- ")
            .point({p.at(0).real(), high})
            .write(";\n");
    if (w.bottom < 0 && w.top > 0)
        p.write("\\draw[gray] ")
            .point({0, p.at(0).imag()})
            .write(" -- ")
            .point({tikz_width, p.at(0).imag()})
            .write(";\n");
    p.write("\\draw ").point({0, 0}).write(" rectangle ").point({tikz_width, high}).write(";\n");
    const double d = tick_distance(w.width()), e = std::max(d, tick_distance(w.height()));
    for (double x = std::ceil(w.left / d) * d; x <= w.right + 1e-9 * d; x += d)
        p.write("\\draw ")
            .point({p.at(x).real(), 0})
            .write(" -- +(0,0.12) node[below=4pt,font=\\footnotesize] {" + tick_text(x) + "};\n");
    for (double y = std::ceil(w.bottom / e) * e; y <= w.top + 1e-9 * e; y += e)
        p.write("\\draw ")
            .point({0, p.at({0, y}).imag()})
            .write(" -- +(0.12,0) node[left=5pt,font=\\footnotesize] {" + tick_text(y) + "};\n");
    p.write("\\node[below] at ").point({tikz_width / 2, -0.55}).write(" {Re $z$};\n");
    p.write("\\node[rotate=90,above] at ").point({-0.95, high / 2}).write(" {Im $z$};\n");
}

/// One line of the legend, the k-th below the picture.
STAGECRAFT_INLINE void legend_line(tikz_plane& p, int k, const std::string& sample, const std::string& text) {
    const double y = -1.6 - 0.5 * k;
    p.write(sample).point({0, y - 0.12}).write(sample[1] == 'f' ? " rectangle " : " -- ");
    p.point({0.8, y + (sample[1] == 'f' ? 0.12 : -0.12)}).write(";\n\\node[right] at ");
    p.point({0.9, y}).write(" {" + text + "};\n");
}

STAGECRAFT_INLINE void mark(tikz_plane& p, const std::vector<complex>& all, const std::string& colour,
                            const std::string& sign) {
    for (const complex z : all)
        if (p.view.contains(z))
            p.write("\\node[" + xcolor(colour) + ",inner sep=0pt] at ")
                .point(p.at(z))
                .write(" {" + sign + "};\n");
}

}  // namespace detail

STAGECRAFT_INLINE std::string regions_tikz(const std::vector<named_function>& methods, const window& view) {
    require_regions(methods);
    require_window(view);
    static const std::string zero = "#2e7d32", pole = "#b71c1c";
    const std::size_t n = methods.size();
    const auto shade = [n](int outside) { return region_shade(n - static_cast<std::size_t>(outside), n); };
    detail::tikz_plane p(view);
    p.write("% stability regions; \\usepackage{tikz}\n\\begin{tikzpicture}\n");
    std::vector<std::string> colours{zero, pole};
    for (std::size_t k = 0; k < n; ++k) {
        colours.emplace_back(region_line(k).colour);
        colours.push_back(shade(static_cast<int>(k)));
    }
    detail::define_colours(p, colours);
    p.write("\\begin{scope}\n\\clip ").point({0, 0}).write(" rectangle ");
    p.point(p.scale * complex(view.width(), view.height())).write(";\n");
    for (const patch& q : region_patches(methods, view, 600, 300))
        p.write("\\fill[" + detail::xcolor(shade(q.level)) + "] ")
            .point(p.at({q.left, q.bottom - 0.1 * (q.top - q.bottom)}))
            .write(" rectangle ")
            .point(p.at({q.right, q.top}))
            .write(";\n");
    const auto style = [](std::size_t k) {
        const line_style line = region_line(k);
        std::string out = detail::xcolor(line.colour) + ",line width=1pt";
        for (std::size_t i = 0; i < line.dashes.size(); ++i)
            out += (i == 0 ? ",dash pattern=" : " ") + std::string(i % 2 == 0 ? "on " : "off ") +
                   std::to_string(line.dashes[i]) + "pt";
        return out;
    };
    for (std::size_t k = 0; k < n; ++k)
        for (const curve& c : region_boundary(methods[k].r, view)) detail::draw_curve(p, c, style(k));
    p.write("\\end{scope}\n");
    detail::draw_axes(p);
    int line = 0;
    for (std::size_t k = 0; k < n; ++k)
        detail::legend_line(p, line++, "\\draw[" + style(k) + "] ",
                            "$|R| \\le 1$ of " + tex_escaped(methods[k].name));
    if (n == 1) {
        detail::mark(p, methods[0].r.roots(), zero, "$\\circ$");
        detail::mark(p, methods[0].r.poles(), pole, "$\\times$");
        detail::legend_line(p, line++, "\\fill[" + detail::xcolor(shade(0)) + "] ",
                            "$|R| \\le 1$; $\\circ$ zeros and $\\times$ poles of $R$");
    } else {
        detail::legend_line(p, line++, "\\fill[" + detail::xcolor(shade(0)) + "] ",
                            "$|R| \\le 1$ of all of them");
        detail::legend_line(p, line++, "\\fill[" + detail::xcolor(region_shade(1, n)) + "] ",
                            "$|R| \\le 1$ of one of them");
    }
    p.write("\\end{tikzpicture}\n");
    return p.text.str();
}

}  // namespace stagecraft::theory::plot
