// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/read_partitioned.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/json_document.hpp"
#include "stagecraft/tableaux/read.hpp"
#include "stagecraft/tableaux/read_rosenbrock.hpp"
#include "stagecraft/tableaux/reading.hpp"
#include "stagecraft/tableaux/stage_forms.hpp"

namespace stagecraft::tableaux {

namespace json_reader {

/// Whether the document, or the tableau in it, is a method of several tableaux.
STAGECRAFT_INLINE bool is_partitioned(const document& d) {
    if (!d.root.is_object()) return false;
    const json& root = d.root.contains("tableau") ? d.root["tableau"] : d.root;
    if (!root.is_object() || !root.contains("form")) return false;
    return !root["form"].is_string() || !is_stage_form(root["form"].get<std::string>());
}

STAGECRAFT_INLINE tableaux::coupling coupling_of(const document& d) {
    const std::string form = text_field(d, "form");
    std::string allowed;
    for (const auto& each : couplings) {
        if (each.name == form) return each.value;
        allowed += (allowed.empty() ? "" : ", ") + std::string(each.name);
    }
    reject(d, "/form", "form", in_quotes(form) + ", allowed: " + allowed + ", shu-osher, 2N, 2S, 3S*");
}

STAGECRAFT_INLINE claims coupled_claims(const document& d, const partitioned_file& file) {
    const claims stated = read_claims(d);
    const int largest = largest_order_of(file);
    const bool additive = file.coupling == coupling::additive;
    for (const auto& c : {counted_claims[0], counted_claims[1]})
        if ((stated.*(c.value)).value_or(0) > largest)
            reject(d, "/claims/" + std::string(c.name), "claims." + std::string(c.name),
                   "must be at most " + std::to_string(largest));
    if (stated.dense_order || stated.dense_smoothness)
        reject(d, "/claims", "claims", "dense output belongs to one of the tableaux");
    reject_rosenbrock_claims(d);
    reject_single_claims(d);
    for (const auto& c : yes_no_claims)
        if (stated.*(c.value) &&
            (additive ? c.name != "algebraically_stable" : c.name != "symplectic" && c.name != "symmetric"))
            reject(d, "/claims/" + std::string(c.name), "claims." + std::string(c.name),
                   std::string("belongs to one of the tableaux; of all together only orders and ") +
                       (additive ? "algebraically_stable" : "symplectic and symmetric") + " can be claimed");
    return stated;
}

STAGECRAFT_INLINE void read_nystrom(const document& d, const reading& how, partitioned_file& file) {
    static const std::set<std::string> known{"name",       "source",         "note",     "form", "c",
                                             "A_bar",      "b_bar",          "A",        "b",    "claims",
                                             "b_embedded", "b_bar_embedded", "tolerance"};
    require_keys(d, known, {"c", "A_bar", "b_bar", "b"});
    tableau_file position, velocity;
    velocity.b = weights(d);
    const std::size_t s = velocity.b.size();
    position.b = numbers(d, d.root["b_bar"], "/b_bar", "b_bar", s);
    position.A = rows(d, "A_bar", s);
    position.c = velocity.c = numbers(d, d.root["c"], "/c", "c", s);
    file.uses_velocity = d.root.contains("A");
    velocity.A = file.uses_velocity ? rows(d, "A", s) : std::vector(s, std::vector(s, read_entry("0")));
    if (d.root.contains("b_embedded") != d.root.contains("b_bar_embedded"))
        reject(d, "", "", "b_embedded and b_bar_embedded belong together");
    if (d.root.contains("b_embedded")) {
        velocity.b_embedded = numbers(d, d.root["b_embedded"], "/b_embedded", "b_embedded", s);
        position.b_embedded = numbers(d, d.root["b_bar_embedded"], "/b_bar_embedded", "b_bar_embedded", s);
    }
    for (auto* part : {&position, &velocity}) apply(how, *part);
    file.partners = {std::move(position), std::move(velocity)};
}

STAGECRAFT_INLINE void read_partners(const document& d, const reading& how,
                                     const std::filesystem::path& folder, partitioned_file& file) {
    require_keys(d, {"name", "source", "note", "form", "partners", "claims", "tolerance"}, {"partners"});
    const json& partners = d.root["partners"];
    const bool pair = file.coupling != coupling::additive;
    if (!partners.is_array() || partners.size() < 2 || partners.size() > (pair ? 2 : most_partners))
        reject(d, "/partners", "partners",
               "must be a list of 2" + (pair ? "" : " to " + std::to_string(most_partners)) +
                   " tableaux or names of files");
    for (std::size_t i = 0; i < partners.size(); ++i) {
        const std::string path = "/partners/" + std::to_string(i);
        const std::string part_name = "partners[" + std::to_string(i + 1) + "]";
        if (partners[i].is_string()) {
            try {
                file.partners.push_back(
                    read_tableau_file((folder / partners[i].get<std::string>()).string(), how));
            } catch (const unusable_input& e) {
                reject(d, path, part_name, e.what());
            }
        } else {
            file.partners.push_back(tableau(d.part(path, part_name, partners[i]), how));
        }
        if (file.partners[i].stages() != file.stages())
            reject(d, path, part_name, "has another number of stages than the first");
    }
}

STAGECRAFT_INLINE partitioned_file partitioned(const document& d, const reading& how,
                                               const std::filesystem::path& folder) {
    if (d.root.contains("tableau"))
        return partitioned(d.part("/tableau", "tableau", d.root["tableau"]), how, folder);
    partitioned_file file;
    file.coupling = coupling_of(d);
    file.name = text_field(d, "name");
    file.source = text_field(d, "source");
    const reading with_its_own = with_tolerance_of(d, how);
    if (file.coupling == coupling::rosenbrock) {
        rosenbrock(d, with_its_own, file);
        return file;
    }
    if (file.coupling == coupling::nystrom)
        read_nystrom(d, with_its_own, file);
    else
        read_partners(d, with_its_own, folder, file);
    file.claims = coupled_claims(d, file);
    const bool embedded = std::all_of(file.partners.begin(), file.partners.end(),
                                      [](const auto& p) { return !p.b_embedded.empty(); });
    if (file.claims.embedded_order && !embedded)
        reject(d, "/claims/embedded_order", "claims.embedded_order", "not every tableau has a b_embedded");
    return file;
}

}  // namespace json_reader

STAGECRAFT_INLINE method_file read_method_text(std::string_view text, const reading& how,
                                               const std::filesystem::path& folder) {
    const auto d = json_reader::parse(text);
    if (json_reader::is_partitioned(d)) return json_reader::partitioned(d, how, folder);
    return json_reader::tableau(d, how);
}

STAGECRAFT_INLINE method_file read_method_file(const std::string& path, const reading& how) {
    const std::string text = text_of_file(path);
    try {
        return read_method_text(text, how, std::filesystem::path(path).parent_path());
    } catch (const unusable_input& e) {
        throw unusable_input(path + ": " + e.what());
    }
}

}  // namespace stagecraft::tableaux
