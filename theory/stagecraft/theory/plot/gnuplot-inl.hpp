// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/plot/gnuplot.hpp"

#include <unistd.h>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory::plot {

STAGECRAFT_INLINE std::string gnuplot_string(std::string_view text) {
    std::string q = "'";
    for (const char ch : text) {
        if (ch == '\'') q += '\'';
        q += static_cast<unsigned char>(ch) < ' ' ? ' ' : ch;
    }
    return q + "'";
}

STAGECRAFT_INLINE script::script() {
    settings_ << "set encoding utf8\nunset key\nset border lc rgb '#606060'\nset tics nomirror\n"
              << "set grid lc rgb '#e4e4e4'\n";
    settings_.precision(10);
    data_.precision(10);
}

STAGECRAFT_INLINE script& script::set(const std::string& line) {
    settings_ << line << '\n';
    return *this;
}

STAGECRAFT_INLINE script& script::title(std::string_view first, std::string_view second) {
    // gnuplot's titles have no line break in single quotes: the second line is a label of its own
    settings_ << "set title " << gnuplot_string(first) << " noenhanced offset 0,"
              << (second.empty() ? "0" : "0.9") << "\n";
    if (!second.empty())
        settings_ << "set label " << gnuplot_string(second)
                  << " at graph 0.5,1 center offset character 0,0.8 noenhanced font ',11' tc rgb "
                     "'#505050'\n";
    return *this;
}

STAGECRAFT_INLINE script& script::label(std::string_view text, double x, double y, std::string_view how) {
    settings_ << "set label " << gnuplot_string(text) << " at " << x << ',' << y << ' ' << how
              << " noenhanced front\n";
    return *this;
}

STAGECRAFT_INLINE script& script::plane(const window& w) {
    require_window(w);
    settings_ << "set size ratio -1\nset xrange [" << w.left << ':' << w.right << "]\nset yrange ["
              << w.bottom << ':' << w.top << "]\nset xlabel 'Re z' offset 0,0.8\nset ylabel 'Im z'\n"
              << "set xzeroaxis lc rgb '#909090' lt 1\nset yzeroaxis lc rgb '#909090' lt 1\n"
              << "set tics front\nset border front\n";
    size.height = static_cast<int>(70 + (size.width - 90) * w.height() / w.width());
    size.height = size.height < 300 ? 300 : size.height > 1200 ? 1200 : size.height;
    return *this;
}

STAGECRAFT_INLINE script& script::lines(const std::vector<curve>& all, std::string_view style) {
    if (all.empty()) return *this;
    open_data();
    for (const curve& c : all) {
        for (const complex z : c.points) data_ << z.real() << ' ' << z.imag() << '\n';
        data_ << '\n';
    }
    return part("with lines " + std::string(style));
}

STAGECRAFT_INLINE script& script::points(const std::vector<complex>& all, std::string_view style) {
    if (all.empty()) return *this;
    open_data();
    for (const complex z : all) data_ << z.real() << ' ' << z.imag() << '\n';
    return part("with points " + std::string(style));
}

STAGECRAFT_INLINE script& script::legend(std::string_view title, std::string_view colour) {
    parts_ += std::string(parts_.empty() ? "" : ", ") + "1/0 with boxes fs solid noborder fc rgb '" +
              std::string(colour) + "' title " + gnuplot_string(title) + " noenhanced";
    return *this;
}

STAGECRAFT_INLINE std::string script::text(const std::filesystem::path& output) const {
    const std::string ending = output.extension().string();
    std::ostringstream all;
    if (ending == ".svg")
        all << "set terminal svg size " << size.width << ',' << size.height
            << " enhanced background 'white' font 'Helvetica,14'\n";
    else if (ending == ".png")
        all << "set terminal pngcairo size " << size.width << ',' << size.height << " enhanced font ',11'\n";
    else if (ending == ".pdf")
        all << "set terminal pdfcairo size " << size.width / 100.0 << ',' << size.height / 100.0
            << " enhanced\n";
    else
        throw std::invalid_argument("output: '" + output.string() + "' must end in .svg, .png or .pdf");
    // absolute: a name that begins with | would be a command to gnuplot
    all << "set output " << gnuplot_string(std::filesystem::absolute(output).string()) << '\n'
        << data_.str() << settings_.str() << "plot " << (parts_.empty() ? "1/0 notitle" : parts_)
        << "\nunset output\n";
    return all.str();
}

STAGECRAFT_INLINE script& script::part(const std::string& how) {
    data_ << "EOD\n";
    parts_ += (parts_.empty() ? "" : ", ") + ("$d" + std::to_string(blocks_)) + " " + how +
              (how.find(" title ") == std::string::npos ? " notitle" : "");
    return *this;
}

STAGECRAFT_INLINE bool on_path(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (::access(((folder.empty() ? "." : folder) + "/" + program).c_str(), X_OK) == 0) return true;
    return false;
}

STAGECRAFT_INLINE void draw(const script& picture, const std::filesystem::path& output) {
    draw(picture.text(output), output);
}

STAGECRAFT_INLINE void draw(const std::string& commands, const std::filesystem::path& output) {
    if (!on_path("gnuplot")) throw gnuplot_missing();
    std::FILE* probe = std::fopen(output.c_str(), "wb");
    if (!probe) throw std::invalid_argument("output: cannot write '" + output.string() + "'");
    std::fclose(probe);
    std::FILE* pipe = ::popen("gnuplot", "w");
    if (!pipe) throw gnuplot_missing();
    const bool written = std::fwrite(commands.data(), 1, commands.size(), pipe) == commands.size();
    const int status = ::pclose(pipe);
    if (!written || status != 0) throw std::runtime_error("gnuplot failed on " + output.string());
}

}  // namespace stagecraft::theory::plot
