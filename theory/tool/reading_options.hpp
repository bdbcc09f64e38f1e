// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/reading.hpp>
#include <string>

#include "command.hpp"

namespace stagecraft::tool {

/// --decimals, --ulps and --tolerance: what the entries of a file are taken to be.
struct reading_options {
    std::string decimals = "auto", ulps = "1/2", tolerance = "0";

    void add_to(CLI::App& command) {
        command.add_option(
            "--decimals", decimals,
            "exact, rounded, or auto (default): rounded, but exact where much shorter than usual");
        command.add_option("--ulps", ulps,
                           "units of its last digit that a rounded entry may be off (default 1/2)");
        command.add_option("--tolerance", tolerance,
                           "absolute error that every entry but whole numbers may have");
    }
    /// Throws std::invalid_argument that names the option.
    tableaux::reading reading() const {
        return {tableaux::decimals_from_name(decimals), number("ulps", ulps), number("tolerance", tolerance)};
    }

  private:
    static tableaux::rational number(const char* argument, const std::string& text) {
        const std::invalid_argument refused(std::string(argument) + ": '" + text +
                                            "', allowed: a number that is not negative");
        try {
            const auto e = tableaux::read_entry(text, tableaux::exact_decimals::all());
            if (e.exact && e.exact->is_rational() && e.exact->rational_part() >= 0)
                return e.exact->rational_part();
        } catch (const std::invalid_argument&) {
            throw refused;
        }
        throw refused;
    }
};

}  // namespace stagecraft::tool
