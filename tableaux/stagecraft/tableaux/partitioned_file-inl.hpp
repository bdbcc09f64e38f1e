// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/partitioned_file.hpp"

#include "stagecraft/compiled.hpp"

namespace stagecraft::tableaux {

STAGECRAFT_INLINE number_kind partitioned_file::kind() const {
    tableau_file all;
    for (const auto& p : partners) p.for_each_entry([&](const entry& e) { all.b.push_back(e); });
    return all.kind();
}

STAGECRAFT_INLINE std::string partner_name(const partitioned_file& file, std::size_t k) {
    if (file.coupling == coupling::nystrom) return k == 0 ? "the formula for y" : "the formula for y'";
    if (file.coupling == coupling::rosenbrock) return k == 0 ? "A" : "Gamma";
    const std::string& given = file.partners[k].name;
    return given.empty() ? "tableau " + std::to_string(k + 1) : given;
}

}  // namespace stagecraft::tableaux
