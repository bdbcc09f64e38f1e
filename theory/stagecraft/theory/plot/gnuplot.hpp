// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/theory/plot/region.hpp>

#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace stagecraft::theory::plot {

/// Thrown where the program gnuplot cannot be found.
struct gnuplot_missing : std::runtime_error {
    gnuplot_missing()
        : std::runtime_error("gnuplot is not installed (Debian: apt-get install gnuplot-nox)") {}
};

/// A gnuplot string: single quotes expand neither backquotes nor macros; control characters become blanks.
std::string gnuplot_string(std::string_view text);

/// Size of a picture in pixels.
struct canvas {
    int width = 640;
    int height = 640;
};

/// A gnuplot script in the making: settings, then the parts of one plot command.
class script {
  public:
    script();

    canvas size;

    /// One line of gnuplot, as it stands.
    script& set(const std::string& line);
    script& title(std::string_view first, std::string_view second = {});
    script& label(std::string_view text, double x, double y, std::string_view how = "center");
    /// The axes of the complex plane, drawn to scale, their ticks over what is filled.
    script& plane(const window& w);
    /// Filled patches, `colour(level)` as "#rrggbb"; neighbouring rows overlap a little to hide the seams.
    template <class Colour>
    script& patches(const std::vector<patch>& all, Colour colour) {
        if (all.empty()) return *this;
        open_data();
        for (const patch& p : all)
            data_ << p.left << ' ' << p.bottom << ' ' << p.left << ' ' << p.right << ' ' << p.bottom << ' '
                  << p.top + 0.1 * (p.top - p.bottom) << " 0x" << std::string(colour(p.level)).substr(1)
                  << '\n';
        return part("with boxxyerror fs solid noborder fc rgb variable");
    }
    script& lines(const std::vector<curve>& all, std::string_view style);
    script& points(const std::vector<complex>& all, std::string_view style);

    /// A patch of a colour "#rrggbb" in the legend.
    script& legend(std::string_view title, std::string_view colour);

    /// The script, writing to `output`; the name's ending decides: .svg, .png or .pdf. Throws
    /// std::invalid_argument for another ending.
    std::string text(const std::filesystem::path& output) const;

  private:
    void open_data() { data_ << "$d" << ++blocks_ << " << EOD\n"; }
    script& part(const std::string& how);

    std::ostringstream settings_;
    std::ostringstream data_;
    std::string parts_;
    int blocks_ = 0;
};

/// Whether a program of that name lies on the PATH.
bool on_path(const std::string& program);

/// Draws the picture into the file `output`. Throws gnuplot_missing without gnuplot, std::invalid_argument
/// for a file that cannot be written, std::runtime_error where gnuplot fails.
void draw(const script& picture, const std::filesystem::path& output);
/// The same from the whole text of a script, which writes to `output`.
void draw(const std::string& commands, const std::filesystem::path& output);

}  // namespace stagecraft::theory::plot

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/plot/gnuplot-inl.hpp"
#endif
