// SPDX-License-Identifier: BSL-1.0
#include "report.hpp"

#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stagecraft/theory/exercises/html_escaped.hpp>
#include <stdexcept>

namespace rolling_disc {

namespace {

using stagecraft::theory::html_escaped;

std::string read(const std::string& file) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error("cannot read " + file);
    std::ostringstream all;
    all << in.rdbuf();
    return all.str();
}

// An argument of a shell command.
std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

// gnuplot's SVG without the XML prologue, its ids made unique, so that several can live in one page.
std::string inlined(const std::string& directory, const std::string& name) {
    std::string svg = read(directory + "/" + name + ".svg");
    const auto start = svg.find("<svg");
    if (start == std::string::npos) throw std::runtime_error(name + ".svg is not a picture");
    svg.erase(0, start);
    for (const std::string mark : {"id='", "href='#", "id=\"", "href=\"#", "url(#"})
        for (auto at = svg.find(mark); at != std::string::npos; at = svg.find(mark, at + mark.size()))
            svg.insert(at + mark.size(), name + "_");
    return svg;
}

const char* const style = R"(
body { font: 17px/1.5 Helvetica, Arial, sans-serif; color: #222; background: #fff; max-width: 960px; margin: 2em auto; padding: 0 1em; }
h1 { font-size: 1.7em; } h2 { font-size: 1.2em; margin: 2em 0 0.3em; }
pre { font: 13px/1.35 "DejaVu Sans Mono", Menlo, monospace; background: #f6f6f4; padding: 1em; overflow-x: auto; }
svg { width: 100%; height: auto; } p.caption { color: #444; margin-top: 0; }
)";

}  // namespace

void write_table(const std::string& file, const std::string& heading,
                 const std::vector<std::vector<double>>& rows) {
    std::ofstream out(file);
    out << "# " << heading << '\n' << std::setprecision(17);
    for (const auto& row : rows) {
        for (std::size_t k = 0; k < row.size(); ++k) out << (k > 0 ? " " : "") << row[k];
        out << '\n';
    }
    if (!out.flush()) throw std::runtime_error("cannot write " + file);
}

void write_page(const std::string& directory, const std::string& methods, const std::string& title,
                const std::string& introduction, const std::string& text,
                const std::vector<picture>& pictures) {
    if (std::system("command -v gnuplot >/dev/null 2>&1") != 0)
        throw std::runtime_error("no pictures without gnuplot; please install it (package gnuplot-nox)");
    const std::string log = directory + "/gnuplot.log";
    const std::string command = "gnuplot -e " + quoted("dir='" + directory + "'; methods='" + methods + "'") +
                                " " + quoted(std::string(ROLLING_DISC_SOURCE) + "/report.gp") + " 2>" +
                                quoted(log);
    if (std::system(command.c_str()) != 0) throw std::runtime_error("gnuplot failed:\n" + read(log));

    std::ofstream page(directory + "/index.html");
    page << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         << "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>"
         << html_escaped(title) << "</title>\n<style>" << style << "</style>\n</head>\n<body>\n<h1>"
         << html_escaped(title) << "</h1>\n<p>" << html_escaped(introduction) << "</p>\n<pre>"
         << html_escaped(text) << "</pre>\n";
    for (const auto& p : pictures)
        page << "<h2>" << html_escaped(p.heading) << "</h2>\n<p class=\"caption\">" << html_escaped(p.caption)
             << "</p>\n"
             << inlined(directory, p.name) << '\n';
    page << "</body>\n</html>\n";
    if (!page.flush()) throw std::runtime_error("cannot write " + directory + "/index.html");
}

}  // namespace rolling_disc
