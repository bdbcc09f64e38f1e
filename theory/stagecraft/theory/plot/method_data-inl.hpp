// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/plot/method_data.hpp"

#include <algorithm>
#include <cstdio>
#include <initializer_list>
#include <stdexcept>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/rounded.hpp"
#include "stagecraft/tableaux/tableau_file.hpp"
#include "stagecraft/theory/models/legendre_model.hpp"
#include "stagecraft/theory/stability/rosenbrock_function.hpp"

namespace stagecraft::theory::plot {

namespace detail {

inline std::string short_enough(const std::string& text) { return text.size() <= 90 ? text : std::string(); }

template <class K>
polynomial<K> without_noise(const polynomial<K>& p, const K& noise) {
    std::vector<K> v;
    for (const K& a : p.coefficients()) v.push_back(a > noise || K(0) - a > noise ? a : K(0));
    return polynomial<K>(std::move(v));
}

/// Coefficients of P and Q up to one part in so many are zeros that rounding has moved: larger ones are seen in a picture.
inline constexpr int parts_of_moved_zero = 100'000'000;

template <class K>
subject subject_of(std::string name, const stability_function<K>& exact, const K& noise = K(0)) {
    const K moved = std::min(noise, K(tableaux::rational(1, parts_of_moved_zero)));
    const stability_function<K> r{without_noise(exact.numerator, moved),
                                  without_noise(exact.denominator, moved)};
    subject m{std::move(name), in_doubles(r), {}, {}, short_enough("R(z) = " + r.text()), {}, {}};
    try {
        m.order_star = star_of(r, noise);
    } catch (const std::invalid_argument&) {  // rounding hides the difference to the exponential
    }
    const auto e = without_noise(e_polynomial(r), noise);
    for (const K& a : e.coefficients()) m.e_polynomial.push_back(to_double(a));
    m.e_text = short_enough("E(y) = " + to_string(e, "y"));
    return m;
}

STAGECRAFT_INLINE std::string six_digits(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", x);
    return text;
}

/// An entry as a picture shows it: its own text with a root sign where that is short, six digits otherwise.
STAGECRAFT_INLINE std::string shown(const tableaux::entry& e) {
    if (e.text.size() > 20) return six_digits(to_double(e.enclosure.middle()));
    std::string text;
    for (std::size_t k = 0; k < e.text.size(); ++k) {
        if (e.text.compare(k, 5, "sqrt(") == 0) {
            const auto close = e.text.find(')', k);
            const std::string radicand = e.text.substr(k + 5, close - k - 5);
            if (close != std::string::npos && radicand.find_first_not_of("0123456789") == std::string::npos) {
                text += "\u221a" + radicand;
                k = close;
                continue;
            }
        }
        if (e.text[k] != '*' && e.text[k] != ' ') text += e.text[k];
    }
    return text;
}

inline tableaux::quadratic exact_value(const tableaux::entry& e) { return *e.exact; }
inline tableaux::rational middle_value(const tableaux::entry& e) { return e.enclosure.middle(); }

/// R exactly, or over the middles of the entries with what their rounding makes of zeros left out; `tableau_in(convert)` is the
/// tableau that has R, over the numbers that `convert` makes of entries.
template <class File, class Make>
subject subject_of_entries(const File& file, std::initializer_list<const tableaux::tableau_file*> tableaux_of,
                           Make tableau_in) {
    using tableaux::number_kind, tableaux::rational;
    if (file.kind() == number_kind::quadratic)
        return subject_of(file.name, stability_function_of(tableau_in(exact_value)));
    rational noise = 0;
    if (file.kind() > number_kind::quadratic)
        for (const auto* t : tableaux_of)
            t->for_each_entry([&](const tableaux::entry& e) {
                noise = std::max(noise, rational(1000) * e.enclosure.width());
            });
    return subject_of(file.name, stability_function_of(tableau_in(middle_value)), noise);
}

}  // namespace detail

STAGECRAFT_INLINE subject subject_of_family(tableaux::family f, int s) {
    using tableaux::rational;
    const legendre_model<rational> model(f, s);
    tableaux::dense<rational> A(s, s);
    tableaux::column<rational> unit(s);
    for (int i = 0; i < s; ++i) {
        unit[i] = rational(i == 0 ? 1 : 0);
        for (int j = 0; j < s; ++j) A(i, j) = model.A()(i, j);
    }
    subject m = detail::subject_of(std::string(tableaux::name(f)) + ", s = " + std::to_string(s),
                                   stability_function_of<rational>(A, unit, unit));
    const auto t = tableaux::rounded<double>(f, s);
    for (int i = 0; i < s; ++i) {
        m.tableau.c.push_back(detail::six_digits(t.c(i)));
        m.tableau.b.push_back(detail::six_digits(t.b(i)));
        m.tableau.A.emplace_back();
        m.tableau.values.emplace_back();
        for (int j = 0; j < s; ++j) {
            m.tableau.A.back().push_back(detail::six_digits(t.A(i, j)));
            m.tableau.values.back().push_back(t.A(i, j));
        }
    }
    return m;
}

STAGECRAFT_INLINE subject subject_of_file(const tableaux::partitioned_file& file) {
    require_rosenbrock(file);
    const auto &values = file.partners[0], &matrix = file.partners[1];
    return detail::subject_of_entries(
        file, {&values, &matrix}, [&]<class K>(K (*in)(const tableaux::entry&)) {
            return linear_part(rosenbrock_of(file, tableaux::to_tableau<K>(values, in),
                                             tableaux::to_tableau<K>(matrix, in)));
        });
}

STAGECRAFT_INLINE subject subject_of_file(const tableaux::tableau_file& file) {
    const auto middle = detail::middle_value;
    subject m = detail::subject_of_entries(file, {&file}, [&]<class K>(K (*in)(const tableaux::entry&)) {
        return tableaux::to_tableau<K>(file, in);
    });
    for (const auto& row : file.A) {
        m.tableau.A.emplace_back();
        m.tableau.values.emplace_back();
        for (const auto& e : row) {
            m.tableau.A.back().push_back(detail::shown(e));
            m.tableau.values.back().push_back(to_double(middle(e)));
        }
    }
    for (const auto& e : file.b) m.tableau.b.push_back(detail::shown(e));
    for (const auto& e : file.b_embedded) m.tableau.b_embedded.push_back(detail::shown(e));
    for (const auto& e : file.c) m.tableau.c.push_back(detail::shown(e));
    if (file.c.empty())
        for (const auto& row : m.tableau.values) {
            double sum = 0;
            for (const double a : row) sum += a;
            m.tableau.c.push_back(detail::six_digits(sum));
        }
    return m;
}

}  // namespace stagecraft::theory::plot
