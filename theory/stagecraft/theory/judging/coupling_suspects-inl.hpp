// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/coupling_suspects.hpp"

#include <algorithm>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

namespace detail {

STAGECRAFT_INLINE bool judged_alone(const tableaux::partitioned_file& file) {
    using tableaux::coupling;
    return file.coupling == coupling::additive || file.coupling == coupling::partitioned;
}

STAGECRAFT_INLINE tableaux::tableau_file partner_alone(const tableaux::partitioned_file& file,
                                                       std::size_t k) {
    tableaux::tableau_file alone = file.partners[k];
    alone.name = partner_name(file, k);
    if (!alone.claims.order) alone.claims.order = file.claims.order;
    if (!alone.claims.embedded_order && !alone.b_embedded.empty())
        alone.claims.embedded_order = file.claims.embedded_order;
    return alone;
}

STAGECRAFT_INLINE std::vector<coupled_place> coupled_places(const tableaux::partitioned_file& file) {
    if (file.coupling == tableaux::coupling::rosenbrock) return rosenbrock_places(file);
    const bool nystrom = file.coupling == tableaux::coupling::nystrom;
    std::vector<coupled_place> all;
    for (std::size_t k = 0; k < file.partners.size(); ++k) {
        const auto& partner = file.partners[k];
        for (const place& p : places_of_kind(partner)) {
            const bool absent = nystrom && k == 1 && p.part == part::A && !file.uses_velocity;
            const bool shared = nystrom && k == 1 && p.part == part::c;
            if (!absent && !shared) all.push_back({k, p});
        }
    }
    return all;
}

STAGECRAFT_INLINE std::string name(const coupled_place& p, const tableaux::partitioned_file& file) {
    std::string text = p.place.name();
    if (file.coupling == tableaux::coupling::rosenbrock) return rosenbrock_name(p, file);
    if (file.coupling != tableaux::coupling::nystrom) return partner_name(file, p.partner) + ": " + text;
    if (p.partner == 0 && p.place.part != part::c) text.insert(1, "_bar");
    return text;
}

STAGECRAFT_INLINE tree_table coupled_trees_claimed::table(const tableaux::partitioned_file& f,
                                                          std::optional<int> claimed) {
    if (f.coupling == tableaux::coupling::rosenbrock) claimed = 1;  // whose trees are others
    return coupled_trees(f.coupling, f.uses_velocity, static_cast<int>(f.partners.size()),
                         std::max(claimed.value_or(1), 1));
}

}  // namespace detail

}  // namespace stagecraft::theory
