// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <initializer_list>
#include <stagecraft/any_method.hpp>
#include <stagecraft/dense_method.hpp>
#include <stagecraft/low_storage.hpp>
#include <stagecraft/method/additive_method.hpp>
#include <stagecraft/method/nystrom_method.hpp>
#include <stagecraft/method/partitioned_method.hpp>
#include <stagecraft/tableaux/dense_from_file.hpp>
#include <stagecraft/tableaux/read_partitioned.hpp>
#include <stagecraft/tableaux/tableau_from_file.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

// Methods of several tableaux from their files to a run: what integrate() takes.

namespace stagecraft::tableaux {

namespace detail {

/// The file at `path`, which must have one of these forms. Throws unusable_input that names them.
inline partitioned_file read_coupled(const std::string& path, std::initializer_list<coupling> forms,
                                     const reading& how) {
    method_file file = read_method_file(path, how);
    std::string wanted;
    for (const coupling form : forms)
        wanted += (wanted.empty() ? "\"" : "\" or \"") + std::string(name(form));
    wanted += "\"";
    const auto* coupled = std::get_if<partitioned_file>(&file);
    if (coupled == nullptr) throw unusable_input(path + ": is one tableau, not of the form " + wanted);
    for (const coupling form : forms)
        if (coupled->coupling == form) return std::move(std::get<partitioned_file>(file));
    throw unusable_input(path + ": has the form \"" + std::string(name(coupled->coupling)) + "\", not " +
                         wanted);
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

/// The registers of a file that gives a method by them, each coefficient rounded once to a Real, and the tableau that they mean.
/// std::invalid_argument where it does not (file.form is empty).
template <class Real = double>
low_storage_method<Real> low_storage_of(const tableau_file& file) {
    if (!file.form) throw std::invalid_argument("low_storage_of: the file gives A and b, no registers");
    std::vector<std::vector<Real>> rows;
    for (const auto& row : file.form->rows) {
        rows.emplace_back();
        for (const entry& e : row) rows.back().push_back(rounded<Real>(e));
    }
    std::vector<Real> b_embedded;
    for (const entry& e : file.b_embedded) b_embedded.push_back(rounded<Real>(e));
    auto m = low_storage<Real>(file.form->which, std::move(rows), b_embedded);
    m.meaning.facts.order = file.claims.order.value_or(0);
    return m;
}

/// The additive (implicit-explicit) method of a file of the form "additive" with two partners, the explicit one first: each
/// entry rounded once to a Real, the orders found again (additive()). With stagecraft/additive.hpp it runs:
///
///     integrate(tableaux::read_additive("ark4.json"), split(f_explicit, f_implicit), y0, t0, t1)
///
/// Throws unusable_input, which names the file: as read_method_file, for another form or another number of partners, and
/// where a partner is not explicit, or not diagonally implicit.
template <class Real = double>
additive_method<Real> read_additive(const std::string& path, const reading& how = {}) {
    const partitioned_file file = detail::read_coupled(path, {coupling::additive}, how);
    if (file.partners.size() != 2)
        throw unusable_input(path + ": has " + std::to_string(file.partners.size()) +
                             " partners; two are run, the explicit one first");
    return detail::named_by(
        path, [&] { return additive(rounded<Real>(file.partners[0]), rounded<Real>(file.partners[1])); });
}

/// The pair of tableaux in a file of form "partitioned" or "separable", ready for integrate() (partitioned.hpp), each entry
/// rounded once. That of a separable form refuses other problems when a run begins. Throws unusable_input that names
/// the file.
template <class Real = double>
partitioned_method<Real> read_partitioned(const std::string& path, const reading& how = {}) {
    const partitioned_file file =
        detail::read_coupled(path, {coupling::partitioned, coupling::separable}, how);
    partitioned_method<Real> m;
    m.first = rounded<Real>(file.partners[0]);
    m.second = rounded<Real>(file.partners[1]);
    m.separable = file.coupling == coupling::separable;
    return m;
}

/// The Nystrom method in a file of form "nystrom", ready for integrate() (nystrom.hpp), each entry rounded once. Without A in
/// the file a run with f(t, q, v) is refused when it begins. Throws unusable_input that names the file.
template <class Real = double>
velocity_nystrom_method<Real> read_nystrom(const std::string& path, const reading& how = {}) {
    const partitioned_file file = detail::read_coupled(path, {coupling::nystrom}, how);
    const tableau<Real> position = rounded<Real>(file.partners[0]),
                        velocity = rounded<Real>(file.partners[1]);
    velocity_nystrom_method<Real> m;
    m.c = position.c;
    m.A_bar = position.A;
    m.b_bar = position.b;
    m.b_bar_embedded = position.b_embedded;
    m.b = velocity.b;
    m.b_embedded = velocity.b_embedded;
    if (file.uses_velocity) m.A = velocity.A;
    m.order = file.claims.order.value_or(0);
    return m;
}

/// The method of a file of the forms "2N", "2S", "3S*" and "shu-osher" in its own registers, for integrate() (low_storage.hpp),
/// each coefficient rounded once. Throws unusable_input that names the file.
template <class Real = double>
low_storage_method<Real> read_low_storage(const std::string& path, const reading& how = {}) {
    const method_file file = read_method_file(path, how);
    const auto* one = std::get_if<tableau_file>(&file);
    if (one == nullptr || !one->form)
        throw unusable_input(path + ": has not the form \"2N\", \"2S\", \"3S*\" or \"shu-osher\"");
    return low_storage_of<Real>(*one);
}

/// The method of a file of any kind that runs, for integrate() of stagecraft/any_method.hpp: a tableau, each entry rounded once
/// to a Real, one with its b_theta, or what read_additive and read_low_storage make. Throws unusable_input as these do, and for other forms.
template <class Real = double>
any_method<Real> read_method(const std::string& path, const reading& how = {}) {
    const method_file file = read_method_file(path, how);
    if (const auto* one = std::get_if<tableau_file>(&file)) {
        if (one->form) return low_storage_of<Real>(*one);
        if (!one->b_theta.empty()) return dense_method_of<Real>(*one);
        return rounded<Real>(*one);
    }
    const coupling form = std::get<partitioned_file>(file).coupling;
    if (form == coupling::additive) return read_additive<Real>(path, how);
    if (form == coupling::rosenbrock) throw unusable_input(path + ": no run takes a Rosenbrock method");
    throw unusable_input(path + ": methods of the form \"" + std::string(name(form)) +
                         "\" are read by read_partitioned and read_nystrom");
}

}  // namespace stagecraft::tableaux

namespace stagecraft {
using tableaux::read_additive;
using tableaux::read_low_storage;
using tableaux::read_method;
}  // namespace stagecraft
