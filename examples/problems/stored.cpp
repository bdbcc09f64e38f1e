// SPDX-License-Identifier: BSL-1.0
#include "stored.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>

namespace problems {

namespace {

nlohmann::json content(const std::string& file) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error("cannot read " + file);
    return nlohmann::json::parse(in);
}

// "1/100", "pi" or a decimal number.
double number(const std::string& text) {
    if (text == "pi") return std::numbers::pi;
    const auto slash = text.find('/');
    return slash == std::string::npos ? std::stod(text)
                                      : std::stod(text.substr(0, slash)) / std::stod(text.substr(slash + 1));
}

}  // namespace

Eigen::VectorXd stored_numbers(const std::string& file, const std::string& pointer) {
    const auto all = content(file);
    const nlohmann::json::json_pointer place(pointer);
    if (!all.contains(place)) throw std::runtime_error(file + " has no " + pointer);
    const auto& digits = all.at(place);
    Eigen::VectorXd y(static_cast<Eigen::Index>(digits.size()));
    for (std::size_t i = 0; i < digits.size(); ++i)
        y[static_cast<Eigen::Index>(i)] = number(digits[i].get<std::string>());
    return y;
}

Eigen::VectorXd reference(const std::string& name) {
    return stored_numbers(STAGECRAFT_PROBLEMS_DIR "/data/" + name + ".json", "/y_end");
}

std::vector<boundary_value_case> boundary_value_cases() {
    std::vector<boundary_value_case> all;
    const auto file = content(STAGECRAFT_PROBLEMS_DIR "/../../tests/data/bvp.json");
    for (const auto& [name, entry] : file.at("cases").items()) {
        boundary_value_case c{name,
                              number(entry.at("a")),
                              number(entry.at("b")),
                              number(entry.at("p")),
                              static_cast<int>(entry.at("first_order_rhs").size()),
                              {}};
        for (const auto& point : entry.at("points")) {
            auto& row = c.points.emplace_back();
            for (const auto& x : point) row.push_back(number(x));
            row.front() = std::clamp(row.front(), c.a, c.b);
        }
        all.push_back(std::move(c));
    }
    return all;
}

}  // namespace problems
