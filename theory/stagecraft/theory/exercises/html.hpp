// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <string_view>

#include "stagecraft/theory/exercises/document.hpp"

namespace stagecraft::theory {

/// A text of document.hpp as HTML, its formulas as MathML, which browsers draw by themselves.
std::string html(std::string_view text);

/// The document as HTML: paragraphs, tableaux and matrices.
std::string to_html(const document& d);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/exercises/html-inl.hpp"
#endif
