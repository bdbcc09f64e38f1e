// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/nearest_family.hpp"

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/collocation.hpp"
#include "stagecraft/tableaux/family.hpp"
#include "stagecraft/tableaux/nodal.hpp"
#include "stagecraft/tableaux/read.hpp"
#include "stagecraft/theory/judging/subject.hpp"
#include "stagecraft/theory/statements/certainty.hpp"

namespace stagecraft::theory {

namespace detail {

struct deviation {
    tableaux::bound units = 0;  ///< in units of the entry's last place
    tableaux::bound size = 0;
    theory::place place;
};

/// Unit of the last place of an entry: twice its uncertainty; that of the coarsest entry for exact ones.
STAGECRAFT_INLINE tableaux::bound unit_of(const tableaux::entry& e, tableaux::bound coarsest) {
    const auto unit = e.enclosure.width().to<tableaux::bound>();
    return e.rounded && unit > 0 ? unit : coarsest;
}

/// Largest deviation of the file from a family's member, stages taken in the order of their nodes.
STAGECRAFT_INLINE deviation deviation_from(const tableaux::tableau_file& file,
                                           const std::vector<int>& by_node,
                                           const tableau<tableaux::ball>& member) {
    using tableaux::bound;
    bound coarsest = 0;
    file.for_each_entry([&](const tableaux::entry& e) {
        if (e.rounded) coarsest = std::max(coarsest, e.enclosure.width().to<bound>());
    });
    deviation worst;
    const auto compare = [&](const place& p, const tableaux::ball& exact) {
        const auto& e = entry_at(file, p);
        const auto difference = abs(e.enclosure.middle() - exact.middle()).to<bound>();
        const bound unit = unit_of(e, coarsest);
        worst.size = std::max(worst.size, difference);
        if (difference / unit <= worst.units) return;
        worst.units = difference / unit;
        worst.place = p;
    };
    for (int i = 0; i < file.stages(); ++i) {
        const int row = by_node[static_cast<std::size_t>(i)];
        for (int j = 0; j < file.stages(); ++j)
            compare({part::A, row, by_node[static_cast<std::size_t>(j)]}, member.A(i, j));
        compare({part::b, row, 0}, member.b(i));
        if (!file.c.empty()) compare({part::c, row, 0}, member.c(i));
    }
    return worst;
}

}  // namespace detail

STAGECRAFT_INLINE std::optional<nearest_family> nearest(const tableaux::tableau_file& file) {
    const int s = file.stages();
    if (file.kind() != tableaux::number_kind::rounded || s > most_family_stages) return std::nullopt;
    const auto t = tableaux::to_tableau<tableaux::ball>(
        file, [](const tableaux::entry& e) { return to_ball(e.enclosure); });
    std::vector<int> by_node(static_cast<std::size_t>(s));
    std::iota(by_node.begin(), by_node.end(), 0);
    std::vector<tableaux::bound> nodes;
    for (int i = 0; i < s; ++i) nodes.push_back(t.c(i).middle().to<tableaux::bound>());
    std::stable_sort(by_node.begin(), by_node.end(), [&](int i, int j) {
        return nodes[static_cast<std::size_t>(i)] < nodes[static_cast<std::size_t>(j)];
    });
    std::optional<nearest_family> found;
    tableaux::bound least = 0;
    for (const tableaux::family f : tableaux::all_families) {
        if (s < tableaux::least_stages(f)) continue;
        try {
            const auto member = tableaux::enclose(tableaux::nodal_polynomial(f, s),
                                                  tableaux::construction_of(f), checker_bits);
            const auto d = detail::deviation_from(file, by_node, member);
            if (!(d.size <= farthest) || (found && !(d.units < least))) continue;
            least = d.units;
            char text[32];
            std::snprintf(text, sizeof text, "%.3Lg ulp", d.units);
            found = nearest_family{std::string(name(f)), s, text, d.units > 0 ? d.place.name() : ""};
        } catch (const tableaux::undecided&) {  // no enclosure at this precision: no comparison
        }
    }
    return found;
}

}  // namespace stagecraft::theory
