// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/existence/sought_method.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

namespace detail {

/// Whether a text is more than one decimal or quotient: numbers are added, multiplied or have a root taken.
STAGECRAFT_INLINE bool is_expression(const std::string& text) {
    for (std::size_t i = 1; i < text.size(); ++i)
        if (text[i] == '*' || text[i] == '(' ||
            ((text[i] == '+' || text[i] == '-') && text[i - 1] != 'e' && text[i - 1] != 'E'))
            return true;
    return false;
}

/// Gives entries their numbers.
class number_keeper {
  public:
    number_keeper(std::vector<sought_number>& numbers, alike same) : numbers_(numbers), same_(same) {
        known(tableaux::rational(0), "0");
    }
    std::size_t known(const tableaux::rational& value, const std::string& name) {
        const auto [place, is_new] = known_.try_emplace(value.str(), numbers_.size());
        if (is_new) numbers_.push_back({value, 0, true, {}, name});
        return place->second;
    }
    std::size_t unknown(const tableaux::rational& value, const tableaux::rational& radius,
                        const std::string& name) {
        numbers_.push_back({value, radius, false, {}, name});
        return numbers_.size() - 1;
    }
    /// The number of an entry of a column; a diagonal entry of A may be that of others on the diagonal besides.
    std::size_t of(const tableaux::entry& e, const std::string& name, std::string column,
                   bool on_diagonal = false) {
        if (e.exact && e.exact->is_rational()) return known(e.exact->rational_part(), name);
        const auto add = [&] {
            const auto number =
                unknown(e.enclosure.middle(), e.enclosure.width() / tableaux::rational(2), name);
            numbers_[number].computed = is_expression(e.text);
            numbers_[number].is_quotient =
                !numbers_[number].computed && e.text.find('/') != std::string::npos;
            return number;
        };
        if (e.exact) {
            const auto [place, is_new] = surds_.try_emplace(e.exact->str(), numbers_.size());
            if (is_new) numbers_.push_back({e.enclosure.middle(), 0, false, e.exact, name});
            return place->second;
        }
        if (same_ == alike::nowhere) return add();
        if (e.rounded && e.digits < digits_that_tell && e.text.find('/') == std::string::npos) return add();
        std::vector<std::string> keys{e.text + (same_ == alike::anywhere ? "" : " in " + column)};
        if (on_diagonal) keys.push_back(e.text + " on the diagonal");
        std::optional<std::size_t> number;
        for (const auto& key : keys)
            if (const auto found = alike_.find(key); found != alike_.end()) number = found->second;
        if (!number) number = add();
        for (const auto& key : keys) alike_.emplace(key, *number);
        return *number;
    }

  private:
    static constexpr int digits_that_tell = 8;
    std::vector<sought_number>& numbers_;
    alike same_;
    std::map<std::string, std::size_t> known_, surds_, alike_;
};

STAGECRAFT_INLINE std::string place_name(const std::string& of, const char* part, std::size_t i) {
    return of + part + "[" + std::to_string(i + 1) + "]";
}

/// The nodes of one tableau, as written or as sums of the rows of its A.
STAGECRAFT_INLINE sought_method::row nodes_of(const tableaux::tableau_file& file, const std::string& of,
                                              const std::vector<sought_method::row>& A, number_keeper& keep,
                                              const std::vector<sought_number>& numbers) {
    sought_method::row c;
    for (std::size_t i = 0; i < A.size(); ++i) {
        const std::string name = place_name(of, "c", i);
        if (!file.c.empty()) {
            c.push_back(keep.of(file.c[i], name, "c" + std::to_string(i)));
            continue;
        }
        sought_number sum;
        for (const std::size_t a : A[i]) {
            sum.value += numbers[a].value;
            sum.radius += numbers[a].radius;
            sum.known = sum.known && numbers[a].known;
        }
        c.push_back(sum.known ? keep.known(sum.value, name) : keep.unknown(sum.value, sum.radius, name));
    }
    return c;
}

/// Expressions in rounded numbers, 1 - p/q - ..., are as uncertain as these are; a number that is written as it is has the
/// rounding of its own digits, however coarse others are.
STAGECRAFT_INLINE void spread_rounding(std::vector<sought_number>& numbers) {
    tableaux::rational most(0);
    for (const auto& x : numbers) most = std::max(most, x.radius);
    const tableaux::rational little = most / tableaux::rational(1000000);
    for (auto& x : numbers)
        if (x.computed && !x.known && !x.surd && x.radius < little) x.radius = most;
}

/// Whether two nodes may be the same number.
STAGECRAFT_INLINE bool may_agree(const sought_number& x, const sought_number& y) {
    return abs(x.value - y.value) <= x.radius + y.radius;
}

}  // namespace detail

STAGECRAFT_INLINE sought_method sought(const std::vector<tableaux::tableau_file>& partners, alike same) {
    sought_method m;
    m.stages = partners.front().stages();
    detail::number_keeper keep(m.numbers, same);
    std::vector<sought_method::row> embedded;
    for (std::size_t n = 0; n < partners.size(); ++n) {
        const auto& file = partners[n];
        const std::string of =
            partners.size() == 1 ? "" : (file.name.empty() ? std::to_string(n + 1) : file.name) + ": ";
        auto& A = m.A.emplace_back();
        for (std::size_t i = 0; i < file.A.size(); ++i) {
            auto& row = A.emplace_back();
            for (std::size_t j = 0; j < file.A[i].size(); ++j)
                row.push_back(keep.of(file.A[i][j], detail::place_name(detail::place_name(of, "A", i), "", j),
                                      std::to_string(j), i == j));
        }
        const auto list = [&](const std::vector<tableaux::entry>& entries, const char* part) {
            sought_method::row row;
            for (std::size_t i = 0; i < entries.size(); ++i)
                row.push_back(keep.of(entries[i], detail::place_name(of, part, i), std::to_string(i)));
            return row;
        };
        m.weights.push_back(list(file.b, "b"));
        if (!file.b_embedded.empty()) embedded.push_back(list(file.b_embedded, "b_embedded"));
        auto c = detail::nodes_of(file, of, A, keep, m.numbers);
        std::size_t as = 0;
        for (; as < m.nodes.size(); ++as) {
            bool agree = true;
            for (std::size_t i = 0; i < c.size(); ++i)
                agree = agree && detail::may_agree(m.numbers[m.nodes[as][i]], m.numbers[c[i]]);
            if (!agree) continue;
            for (std::size_t i = 0; i < c.size(); ++i)  // what one of them knows exactly is known
                if (m.numbers[c[i]].known) m.nodes[as][i] = c[i];
            break;
        }
        if (as == m.nodes.size()) m.nodes.push_back(std::move(c));
        m.node_of.push_back(as);
    }
    detail::spread_rounding(m.numbers);
    if (embedded.size() == partners.size())
        m.weights.insert(m.weights.end(), embedded.begin(), embedded.end());
    return m;
}

}  // namespace stagecraft::theory
