// SPDX-License-Identifier: BSL-1.0
#include "page.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stagecraft/theory/exercises/html_escaped.hpp>
#include <stdexcept>

namespace thesis {

namespace {

using stagecraft::theory::html_escaped;

std::string formatted(const char* format, double x) {
    char text[40];
    std::snprintf(text, sizeof text, format, x);
    return text;
}

const char* const prologue = R"(set encoding utf8
set terminal svg size 920,560 dynamic enhanced font 'Helvetica,15' background '#ffffff' linewidth 1.6
set border 3 lc rgb '#444444'
set tics nomirror out textcolor rgb '#333333'
set grid lc rgb '#e4e4e4' lt 1 lw 0.7
set key outside bottom center horizontal Left reverse samplen 2 spacing 1.15 height 1
array colour[8] = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#56b4e9', '#777777', '#e69f00', '#000000']
)";

constexpr int markers[] = {7, 6, 5, 4, 9, 8, 13, 12};  // filled and open in turn: neighbours stay visible

// The inside of a single-quoted string of gnuplot.
std::string plain(const std::string& text) {
    std::string out;
    for (const char c : text) out += c == '\'' ? std::string("''") : std::string(1, c);
    return out;
}

void write_table(const std::string& directory, const std::string& file, const curve& c, bool positive) {
    std::ofstream out(directory + "/" + file);
    out << "# " << c.title << '\n' << std::setprecision(12);
    // Where the logarithm has no value the curve has none either.
    for (std::size_t i = 0; i < c.x.size(); ++i)
        if (!positive || c.y[i] > 0) out << c.x[i] << ' ' << c.y[i] << '\n';
    if (!out.flush()) throw std::runtime_error("cannot write " + directory + "/" + file);
}

// The values of an axis that is drawn.
struct range {
    double low = 1e300, high = 0;
    void include(double x) { low = std::min(low, x), high = std::max(high, x); }
    double decades() const { return std::log10(high / low); }
};

// Of what can be drawn: on a logarithmic axis only what is positive.
range extent(const figure& f, const std::vector<curve>& curves, std::vector<double> curve::*values) {
    range r;
    for (const curve& c : curves)
        for (std::size_t i = 0; i < c.x.size(); ++i)
            if ((!f.log_x || c.x[i] > 0) && (!f.log_y || c.y[i] > 0)) r.include((c.*values)[i]);
    return r;
}

// A curve of measured errors at x, a straight line between them on logarithmic scales.
double value_at(const curve& c, double x) {
    std::vector<std::size_t> order(c.x.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return c.x[i] < c.x[j]; });
    std::size_t k = 1;
    while (k + 1 < order.size() && c.x[order[k]] < x) ++k;
    const std::size_t i = order[k - 1], j = order[k];
    const double share = std::log(x / c.x[i]) / std::log(c.x[j] / c.x[i]);
    return c.y[i] * std::pow(c.y[j] / c.y[i], share);
}

struct triangle {
    curve sides;
    std::string label;  ///< a command of gnuplot
};

// Beside its curve, below it where no other curve is, else above; a seventh of the picture wide.
triangle triangle_at(const figure& f, const slope_mark& mark) {
    const range x = extent(f, f.curves, &curve::x), y = extent(f, f.curves, &curve::y);
    const double x0 = x.low * std::pow(x.high / x.low, 0.6), width = std::pow(x.high / x.low, 1.0 / 7),
                 x1 = x0 * width, gap = std::pow(y.high / y.low, 0.04), rise = std::pow(width, mark.slope);
    const curve& own = f.curves[mark.curve];
    const double left = value_at(own, x0), right = value_at(own, x1) / rise;
    const bool lowest = std::all_of(f.curves.begin(), f.curves.end(),
                                    [&](const curve& c) { return value_at(c, x1) >= value_at(own, x1); });
    const double foot = lowest ? std::min(left, right) / gap : std::max(left, right) * gap,
                 head = foot * rise, middle = std::sqrt(foot * head);
    std::ostringstream label;
    label << "set label 'slope " << mark.slope << "' at " << (lowest ? x1 : x0) << ',' << middle
          << (lowest ? " left offset 0.6,0" : " right offset -0.6,0") << " textcolor rgb '#555555'\n";
    if (lowest) return {{"", {x0, x1, x1, x0}, {foot, foot, head, foot}, false}, label.str()};
    return {{"", {x0, x0, x1, x0}, {foot, head, head, foot}, false}, label.str()};
}

// A logarithmic axis that ends where the curves do; one of less than two decades has marks within them.
std::string logarithmic(char axis, const range& r) {
    std::ostringstream out;
    const double margin = std::max(std::pow(r.high / r.low, 0.04), 1.1);
    out << "set logscale " << axis << "\nset " << axis << "range [" << r.low / margin << ':'
        << r.high * margin << "]\nset format " << axis << " '";
    if (r.decades() >= 2) {
        out << "10^{%T}'\n";
        return out.str();
    }
    out << (r.low >= 0.01 && r.high < 1e4 ? "%g" : "%.0l·10^{%L}") << "'\nset " << axis << "tics (";
    const char* separator = "";
    for (double decade = std::pow(10, std::floor(std::log10(r.low))); decade <= r.high; decade *= 10)
        for (const int digit : {1, 2, 5}) {
            out << separator << digit * decade;
            separator = ", ";
        }
    out << ")\n";
    return out.str();
}

// Tables of all curves and the commands that draw them.
void write_figure(const std::string& directory, const figure& f, std::ostream& script) {
    const auto data = [&](const curve& c, const std::string& file) {
        write_table(directory, file, c, f.log_y);
        return "'" + file + "' using 1:2 with ";
    };
    std::vector<curve> drawn = f.curves;
    std::string labels;
    for (const slope_mark& mark : f.slopes) {
        const triangle t = triangle_at(f, mark);
        drawn.push_back(t.sides);
        labels += t.label;
    }
    script << "set output '" << f.name << ".svg'\nset xlabel '" << plain(f.x_label)
           << "' offset 0,0.4\nset ylabel '" << plain(f.y_label) << "'\nset title '" << plain(f.title)
           << "'\nunset logscale\nunset label\nset autoscale\nset tics autofreq\nset format '%g'\nset size "
           << (f.paths ? "ratio -1" : "noratio") << '\n'
           << labels;
    script << (f.curves.size() == 1 && !f.curves[0].points ? "unset key\n" : "set key\n");
    if (f.log_x) script << logarithmic('x', extent(f, drawn, &curve::x));
    if (f.log_y)
        script << "set offsets\n" << logarithmic('y', extent(f, drawn, &curve::y));
    else
        script << "set offsets 0, 0, graph 0.04, graph 0.04\n";
    script << "plot ";
    for (std::size_t k = 0; k < drawn.size(); ++k) {
        const curve& c = drawn[k];
        script << (k > 0 ? ", " : "") << data(c, f.name + "_" + std::to_string(k + 1) + ".dat");
        if (k >= f.curves.size())
            script << "lines lc rgb '#555555' notitle";
        else  // smaller marks over larger ones: where curves meet all are seen
            script << (c.points
                           ? "linespoints ps " + general(std::max(0.4, 1.2 - 0.17 * static_cast<double>(k))) +
                                 " pt " + std::to_string(markers[k % 8])
                           : "lines")
                   << " lc rgb colour[" << k % 8 + 1 << "] title '" << plain(c.title) << "'";
    }
    script << '\n';
}

}  // namespace

std::string scientific(double x) { return formatted("%.2e", x); }
std::string decimal(double x) { return formatted("%.2f", x); }
std::string one_decimal(double x) { return formatted("%.1f", x); }
std::string general(double x) { return formatted("%g", x); }

std::string compared(bool agrees) { return agrees ? "agrees" : ""; }

std::string compared(double printed, double here, double tolerance, const std::string& reason,
                     bool reason_holds) {
    if (std::abs(here - printed) <= tolerance) return "agrees";
    return reason_holds ? "differs: " + reason : "";
}

namespace {

// In characters, not bytes.
std::size_t length(const std::string& utf8) {
    return static_cast<std::size_t>(
        std::count_if(utf8.begin(), utf8.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace

std::string table(const std::vector<finding>& findings) {
    const std::vector<std::string> head{"experiment", "here", "theory", "verdict", "in print", "printed"};
    const auto comparison = [](const finding& f) -> std::string {
        if (f.printed.empty()) return "-";
        return f.comparison.empty() ? "UNEXPLAINED" : f.comparison;
    };
    std::vector<std::vector<std::string>> rows{head};
    for (const auto& f : findings)
        rows.push_back(
            {f.experiment, f.ours, f.theory, f.agrees ? "agrees" : "DIFFERS", f.printed, comparison(f)});
    if (std::all_of(findings.begin(), findings.end(), [](const finding& f) { return f.comparison.empty(); }))
        for (auto& row : rows) row.back().clear();  // remarks are in print, not values
    std::vector<std::size_t> width(head.size(), 0);
    for (const auto& row : rows)
        for (std::size_t j = 0; j < row.size(); ++j) width[j] = std::max(width[j], length(row[j]));
    std::ostringstream out;
    for (const auto& row : rows) {
        for (std::size_t j = 0; j < row.size(); ++j)
            out << (j > 0 ? "  " : "") << row[j]
                << (j + 1 < row.size() ? std::string(width[j] - length(row[j]), ' ') : "");
        out << '\n';
    }
    return out.str();
}

void write_pages(const std::string& directory, const std::vector<outcome>& outcomes, language of_pictures) {
    if (std::system("command -v gnuplot >/dev/null 2>&1") != 0)
        throw std::runtime_error("no pictures without gnuplot; please install it (package gnuplot-nox)");
    std::filesystem::create_directories(directory);
    std::ostringstream commands;
    commands << prologue;
    for (const auto& o : outcomes)
        for (const auto& f : o.figures) write_figure(directory, f, commands);
    std::ofstream script(directory + "/figures.gp");
    script << translated_commands(commands.str(), of_pictures);
    if (!script.flush()) throw std::runtime_error("cannot write " + directory + "/figures.gp");
    std::string quoted = "'";
    for (const char c : directory) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    if (std::system(("cd " + quoted + "' && gnuplot figures.gp").c_str()) != 0)
        throw std::runtime_error("gnuplot could not draw the figures");

    std::ofstream page(directory + "/index.html");
    page << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta "
            "charset=\"utf-8\">\n<title>Experiments</title>\n<style>"
            "body{font:17px/1.5 Helvetica,Arial,sans-serif;color:#222;max-width:980px;margin:2em "
            "auto;padding:0 1em}"
            "pre{font:13px/1.35 'DejaVu Sans Mono',monospace;background:#f6f6f4;padding:1em;overflow-x:auto}"
            "img{width:100%}</style>\n</head>\n<body>\n<h1>The rolling disc: numerical experiments</h1>\n";
    std::vector<finding> all;
    for (const auto& o : outcomes) {
        page << "<h2>" << html_escaped(o.title) << "</h2>\n<pre>" << html_escaped(o.text) << "</pre>\n";
        for (const auto& d : o.drawings) {
            std::ofstream file(directory + "/" + d.name + ".svg");
            file << translated_svg(d.svg, of_pictures);
            if (!file.flush()) throw std::runtime_error("cannot write " + directory + "/" + d.name + ".svg");
            page << "<img src=\"" << d.name << ".svg\" alt=\""
                 << html_escaped(translated(d.title, of_pictures)) << "\">\n";
        }
        for (const auto& f : o.figures)
            page << "<img src=\"" << f.name << ".svg\" alt=\""
                 << html_escaped(translated(f.title, of_pictures)) << "\">\n";
        all.insert(all.end(), o.findings.begin(), o.findings.end());
    }
    page << "<h2>Summary</h2>\n<pre>" << html_escaped(table(all)) << "</pre>\n</body>\n</html>\n";
    if (!page.flush()) throw std::runtime_error("cannot write " + directory + "/index.html");
}

}  // namespace thesis
