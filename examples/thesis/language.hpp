// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <map>
#include <string>

namespace thesis {

/// Of titles, axes and legends of pictures. What programs print is English.
enum class language { english, german };

/// What --language takes.
inline const std::map<std::string, language> languages{{"en", language::english}, {"de", language::german}};

/// A text of a picture in that language: every phrase of the table in words.hpp is replaced, at each place the longest that
/// stands there. Throws std::invalid_argument, with the word and the text, where a word of two letters or more has no entry: no
/// picture has half its words in another language.
std::string translated(const std::string& text, language to);

/// Commands of gnuplot, their titles, labels and legends translated; nothing else that is quoted.
std::string translated_commands(const std::string& commands, language to);

/// An SVG file, the contents of its text elements translated.
std::string translated_svg(const std::string& svg, language to);

}  // namespace thesis
