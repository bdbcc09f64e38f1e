// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/theory/plot/pictures.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace stagecraft::theory::plot {

/// Text with the letters that mean something to TeX escaped, root signs as formulas and control characters as blanks.
std::string tex_escaped(std::string_view text);

/// The picture of `region_picture` or, of several methods, `regions_picture` as a `tikzpicture` 10 cm wide, to be read by
/// \input in a document that loads the package tikz: filled regions, boundaries, axes with ticks, the legend below; zeros
/// and poles where there is one method. Throws std::invalid_argument for none, and for more than `most_regions`.
std::string regions_tikz(const std::vector<named_function>& methods, const window& view);

}  // namespace stagecraft::theory::plot

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/plot/region_tikz-inl.hpp"
#endif
