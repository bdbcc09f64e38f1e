// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/method/additive_method.hpp>
#include <stagecraft/tableaux/read_partitioned.hpp>
#include <stagecraft/tableaux/tableau_from_file.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

// Methods of several tableaux from their files to a run: what integrate() takes.

namespace stagecraft::tableaux {

namespace detail {

/// The file at `path`, which must have that form. Throws unusable_input that names both.
inline partitioned_file read_coupled(const std::string& path, coupling form, const reading& how) {
    method_file file = read_method_file(path, how);
    const auto* coupled = std::get_if<partitioned_file>(&file);
    if (coupled == nullptr)
        throw unusable_input(path + ": is one tableau, not of the form \"" + std::string(name(form)) + "\"");
    if (coupled->coupling != form)
        throw unusable_input(path + ": has the form \"" + std::string(name(coupled->coupling)) +
                             "\", not \"" + std::string(name(form)) + "\"");
    return std::move(std::get<partitioned_file>(file));
}

/// make(), whose complaints about the method take the path in front.
template <class Make>
auto named_by(const std::string& path, Make make) {
    try {
        return make();
    } catch (const std::invalid_argument& e) {
        throw unusable_input(path + ": " + e.what());
    }
}

}  // namespace detail

/// The additive (implicit-explicit) method of a file of the form "additive" with two partners, the explicit one first: each
/// entry rounded once to a Real, the orders found again (additive()). With stagecraft/additive.hpp it runs:
///
///     integrate(tableaux::read_additive("ark4.json"), split(f_explicit, f_implicit), y0, t0, t1)
///
/// Throws unusable_input, which names the file: as read_method_file, for another form or another number of partners, and
/// where a partner is not explicit, or not diagonally implicit.
template <class Real = double>
additive_method<Real> read_additive(const std::string& path, const reading& how = {}) {
    const partitioned_file file = detail::read_coupled(path, coupling::additive, how);
    if (file.partners.size() != 2)
        throw unusable_input(path + ": has " + std::to_string(file.partners.size()) +
                             " partners; two are run, the explicit one first");
    return detail::named_by(
        path, [&] { return additive(rounded<Real>(file.partners[0]), rounded<Real>(file.partners[1])); });
}

}  // namespace stagecraft::tableaux

namespace stagecraft {
using tableaux::read_additive;
}
