// SPDX-License-Identifier: BSL-1.0
// Pictures of methods.
#include "stagecraft/theory/plot/coupled_region-inl.hpp"
#include "stagecraft/theory/plot/curve-inl.hpp"
#include "stagecraft/theory/plot/gnuplot-inl.hpp"
#include "stagecraft/theory/plot/method_data-inl.hpp"
#include "stagecraft/theory/plot/pictures-inl.hpp"
#include "stagecraft/theory/plot/region-inl.hpp"
#include "stagecraft/theory/plot/region_tikz-inl.hpp"
#include "stagecraft/theory/plot/tree_sheet-inl.hpp"
