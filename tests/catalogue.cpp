// SPDX-License-Identifier: BSL-1.0
#include "catalogue.hpp"

#include <filesystem>
#include <stagecraft/tableaux/read.hpp>
#include <stagecraft/tableaux/tableau_from_file.hpp>

namespace read_once {

using namespace stagecraft;

const std::map<std::string, tableaux::tableau_file>& catalogue() {
    static const auto all = [] {
        std::map<std::string, tableaux::tableau_file> files;
        for (const auto& e : std::filesystem::directory_iterator(STAGECRAFT_SOURCE_DIR "/tableaux/catalogue"))
            if (e.path().extension() == ".json")
                files.emplace(e.path().stem().string(), tableaux::read_tableau_file(e.path().string()));
        return files;
    }();
    return all;
}

const std::vector<std::pair<std::string, exact_tableau>>& exact_methods() {
    static const auto all = [] {
        std::vector<std::pair<std::string, exact_tableau>> found;
        for (const auto& [name, file] : catalogue())
            if (file.kind() <= tableaux::number_kind::quadratic)
                found.emplace_back(name, tableaux::to_quadratic(file));
        return found;
    }();
    return all;
}

tableau<double> rounded(const std::string& name) { return tableaux::rounded<double>(catalogue().at(name)); }

}  // namespace read_once
