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
#include <stdexcept>

namespace thesis {

namespace {

std::string formatted(const char* format, double x) {
    char text[40];
    std::snprintf(text, sizeof text, format, x);
    return text;
}

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text)
        out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    return out;
}

const char* const prologue = R"(set encoding utf8
set terminal svg size 920,520 dynamic enhanced font 'Helvetica,15' background '#ffffff' linewidth 1.6
set border 3 lc rgb '#444444'
set tics nomirror out textcolor rgb '#333333'
set grid lc rgb '#e4e4e4' lt 1 lw 0.7
set key outside right top Left reverse samplen 2 spacing 1.15
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

// A right-angled triangle of the given slope, below all curves and as wide as a factor of 2 in x; several
// stand side by side from the right.
curve triangle(const figure& f, std::size_t which) {
    double right = 0, left = 1e300, floor = 1e300;
    for (const curve& c : f.curves)
        for (const double x : c.x) right = std::max(right, x), left = std::min(left, x);
    const double width = std::pow(right / left, 0.15);
    const double x1 = right / std::pow(width, 0.5 + 1.5 * static_cast<double>(which)), x0 = x1 / width;
    for (const curve& c : f.curves)
        for (std::size_t i = 0; i < c.x.size(); ++i)
            if (c.x[i] <= x1 * width && c.x[i] >= x0 / width && c.y[i] > 0) floor = std::min(floor, c.y[i]);
    const double slope = f.slopes[which], head = floor / 4, foot = head / std::pow(width, slope);
    return {"slope " + general(slope), {x0, x1, x1, x0}, {foot, foot, head, foot}, false};
}

// Tables of all curves and the commands that draw them.
void write_figure(const std::string& directory, const figure& f, std::ostream& script) {
    const auto data = [&](const curve& c, const std::string& file) {
        write_table(directory, file, c, f.log_y);
        return "'" + file + "' using 1:2 with ";
    };
    script << "set output '" << f.name << ".svg'\nset xlabel '" << plain(f.x_label) << "'\nset ylabel '"
           << plain(f.y_label) << "'\nset title '" << plain(f.title)
           << "'\nunset logscale\nset format '%g'\nset size " << (f.paths ? "ratio -1" : "noratio") << '\n';
    if (f.log_x) script << "set logscale x\nset format x '10^{%T}'\n";
    if (f.log_y) script << "set logscale y\nset format y '10^{%T}'\n";
    script << "plot ";
    for (std::size_t k = 0; k < f.curves.size(); ++k) {
        const curve& c = f.curves[k];
        script << (k > 0 ? ", " : "") << data(c, f.name + "_" + std::to_string(k + 1) + ".dat")
               << (c.points ? "linespoints ps 0.7 pt " + std::to_string(markers[k % 8]) : "lines")
               << " lc rgb colour[" << k % 8 + 1 << "] title '" << plain(c.title) << "'";
    }
    for (std::size_t k = 0; k < f.slopes.size(); ++k) {
        const curve c = triangle(f, k);
        script << ", " << data(c, f.name + "_slope_" + std::to_string(k + 1) + ".dat")
               << "lines lc rgb '#555555' dt " << k + 1 << " title '" << c.title << "'";
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

void write_pages(const std::string& directory, const std::vector<outcome>& outcomes) {
    if (std::system("command -v gnuplot >/dev/null 2>&1") != 0)
        throw std::runtime_error("no pictures without gnuplot; please install it (package gnuplot-nox)");
    std::filesystem::create_directories(directory);
    std::ofstream script(directory + "/figures.gp");
    script << prologue;
    for (const auto& o : outcomes)
        for (const auto& f : o.figures) write_figure(directory, f, script);
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
        page << "<h2>" << escaped(o.title) << "</h2>\n<pre>" << escaped(o.text) << "</pre>\n";
        for (const auto& d : o.drawings) {
            std::ofstream file(directory + "/" + d.name + ".svg");
            file << d.svg;
            if (!file.flush()) throw std::runtime_error("cannot write " + directory + "/" + d.name + ".svg");
            page << "<img src=\"" << d.name << ".svg\" alt=\"" << escaped(d.title) << "\">\n";
        }
        for (const auto& f : o.figures)
            page << "<img src=\"" << f.name << ".svg\" alt=\"" << escaped(f.title) << "\">\n";
        all.insert(all.end(), o.findings.begin(), o.findings.end());
    }
    page << "<h2>Summary</h2>\n<pre>" << escaped(table(all)) << "</pre>\n</body>\n</html>\n";
    if (!page.flush()) throw std::runtime_error("cannot write " + directory + "/index.html");
}

}  // namespace thesis
