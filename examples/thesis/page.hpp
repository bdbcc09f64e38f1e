// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "language.hpp"

namespace thesis {

/// One curve of a figure.
struct curve {
    std::string title;
    std::vector<double> x, y;
    bool points = false;  ///< markers at the values, as for measured errors
};

/// A triangle that shows a slope beside the curve that it belongs to.
struct slope_mark {
    double slope;
    std::size_t curve = 0;
};

/// One figure: `name` is the file name without ".svg".
struct figure {
    std::string name, title, x_label, y_label;
    bool log_x = false, log_y = true;
    std::vector<curve> curves;
    bool paths = false;                   ///< x and y are places: one scale for both
    std::vector<slope_mark> slopes = {};  ///< both axes logarithmic
};

/// A picture that an experiment draws itself: `svg` is the whole file.
struct drawing {
    std::string name, title, svg;
};

/// One line of the closing table.
struct finding {
    std::string experiment, printed, ours, theory;
    bool agrees;  ///< ours with theory
    /// How `printed` compares with ours: "agrees", or the reason why it differs; empty where the thesis prints
    /// no value. The table says UNEXPLAINED where a printed value has none.
    std::string comparison = {};
};

/// "agrees" if |here - printed| <= tolerance. Otherwise the reason, provided that what it rests on was
/// measured here; else nothing, and the table says UNEXPLAINED.
std::string compared(bool agrees);
std::string compared(double printed, double here, double tolerance, const std::string& reason = {},
                     bool reason_holds = false);

/// What an experiment has to say: a page of text, figures, and lines for the closing table.
struct outcome {
    std::string title, text;
    std::vector<figure> figures;
    std::vector<finding> findings;
    std::vector<drawing> drawings = {};
};

/// "1.23e-04", "4.82", "4.8", and as many digits as the number was written with.
std::string scientific(double x);
std::string decimal(double x);
std::string one_decimal(double x);
std::string general(double x);

/// The closing table.
std::string table(const std::vector<finding>& findings);

/// Writes the tables, the pictures (SVG by gnuplot), their texts in that language, and index.html into `directory`.
/// Throws std::runtime_error if that fails, naming what to install if gnuplot is missing.
void write_pages(const std::string& directory, const std::vector<outcome>& outcomes,
                 language of_pictures = language::english);

}  // namespace thesis
