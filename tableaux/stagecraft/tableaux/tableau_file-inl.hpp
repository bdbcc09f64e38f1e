// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/tableau_file.hpp"

#include <cstdint>
#include <set>
#include <stdexcept>

#include "stagecraft/compiled.hpp"

namespace stagecraft::tableaux {

STAGECRAFT_INLINE const std::vector<std::string>& stage_form::names(kind k) {
    static const std::vector<std::string> all[] = {{"alpha", "beta"},
                                                   {"A", "B"},
                                                   {"gamma1", "gamma2", "delta", "beta"},
                                                   {"gamma1", "gamma2", "gamma3", "delta", "beta"}};
    return all[static_cast<int>(k)];
}

STAGECRAFT_INLINE std::string stage_form::name(std::size_t row, std::size_t column) const {
    const std::size_t of_each = rows.size() / names(which).size();
    std::string text = names(which)[row / of_each];
    if (which == kind::shu_osher) text += "[" + std::to_string(row % of_each + 1) + "]";
    return text + "[" + std::to_string(column + 1) + "]";
}

STAGECRAFT_INLINE number_kind tableau_file::kind() const {
    bool rounded = false, enclosed = false;
    std::set<std::uint64_t> radicands;
    for_each_entry([&](const entry& e) {
        rounded |= e.rounded;
        enclosed |= !e.exact;
        if (e.exact)
            for (const auto& surd : e.exact->surds()) radicands.insert(surd.radicand);
    });
    enclosed = enclosed || !in_one_field({radicands.begin(), radicands.end()});
    return rounded              ? number_kind::rounded
           : enclosed           ? number_kind::enclosed
           : !radicands.empty() ? number_kind::quadratic
                                : number_kind::rational;
}

STAGECRAFT_INLINE tableau<rational> to_rational(const tableau_file& file) {
    if (file.kind() != number_kind::rational)
        throw std::invalid_argument("file: the entries are not rational");
    return to_tableau<rational>(file, [](const entry& e) { return e.exact->rational_part(); });
}

STAGECRAFT_INLINE tableau<quadratic> to_quadratic(const tableau_file& file) {
    if (file.kind() > number_kind::quadratic)
        throw std::invalid_argument("file: the entries do not lie in one field of at most two surds");
    return to_tableau<quadratic>(file, [](const entry& e) { return *e.exact; });
}

}  // namespace stagecraft::tableaux
