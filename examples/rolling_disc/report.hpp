// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

namespace rolling_disc {

/// A table of numbers for the plotting program: one line per row. Throws std::runtime_error if `file` cannot
/// be written.
void write_table(const std::string& file, const std::string& heading,
                 const std::vector<std::vector<double>>& rows);

/// One picture of the page: file name without ".svg", its heading, and what there is to see.
struct picture {
    std::string name, heading, caption;
};

/// Draws the pictures from the tables in `directory` with gnuplot (the script report.gp) and writes
/// directory/index.html around them: `text` is shown as it is, in fixed width, above the pictures.
/// Throws std::runtime_error with what to install if gnuplot is missing, or with what it said if it fails.
void write_page(const std::string& directory, const std::string& methods, const std::string& title,
                const std::string& introduction, const std::string& text,
                const std::vector<picture>& pictures);

}  // namespace rolling_disc
