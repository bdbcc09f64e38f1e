// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <map>
#include <stagecraft/tableaux/tableau_file.hpp>
#include <string>
#include <utility>
#include <vector>

/// The catalogue, read in one file (catalogue.cpp): JSON and the expressions in it take longer to compile than most tests.
namespace read_once {

/// The files by their names.
const std::map<std::string, stagecraft::tableaux::tableau_file>& catalogue();

using exact_tableau = stagecraft::tableau<stagecraft::tableaux::quadratic>;

/// Those whose entries are rational or lie in one quadratic field, by name.
const std::vector<std::pair<std::string, exact_tableau>>& exact_methods();

/// One of them in the nearest doubles, as a stepper takes it.
stagecraft::tableau<double> rounded(const std::string& name);

}  // namespace read_once
