// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <CLI/CLI.hpp>

#include "language.hpp"

namespace thesis {

/// --language en|de of a program that draws pictures; another language ends the program with the two that there are.
inline void add_language(CLI::App& app, language& chosen) {
    app.add_option_function<std::string>(
           "--language", [&chosen](const std::string& name) { chosen = languages.at(name); },
           "of titles, axes and legends: en or de")
        ->check(CLI::IsMember({"en", "de"}))
        ->type_name("");
}

}  // namespace thesis
