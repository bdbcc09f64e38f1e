// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/existence/existence_attempt.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/correct_rounding.hpp"
#include "stagecraft/tableaux/reading.hpp"
#include "stagecraft/tableaux/tableau_json.hpp"
#include "stagecraft/tableaux/time_share.hpp"
#include "stagecraft/theory/trees/coloured_trees.hpp"

namespace stagecraft::theory::detail {

/// Quotients of many digits and computed doubles as what they round.
STAGECRAFT_INLINE tableaux::tableau_file as_rounded(const tableaux::tableau_file& file) {
    constexpr int units = 4;  // as far as `certify` goes
    auto read = tableaux::has_rounded_fractions(file) ? tableaux::rounded_quotients(file) : file;
    return tableaux::has_computed_doubles(file) ? tableaux::computed(std::move(read), units) : read;
}

STAGECRAFT_INLINE existence_subject subject_of(const tableaux::method_file& file) {
    existence_subject s;
    if (const auto* alone = std::get_if<tableaux::tableau_file>(&file)) {
        s.partners = {*alone};
        s.claims = alone->claims;
    } else {
        const auto& several = std::get<tableaux::partitioned_file>(file);
        if (several.coupling == tableaux::coupling::nystrom)
            throw tableaux::unusable_input("exists: not of Nystrom methods");
        if (several.coupling == tableaux::coupling::rosenbrock)
            throw tableaux::unusable_input("exists: not of Rosenbrock methods");
        s.partners = several.partners;
        s.claims = several.claims;
        s.coupling = several.coupling;
        s.alone = false;
    }
    for (auto& p : s.partners) {
        if (p.form) throw tableaux::unusable_input("exists: not of forms of low storage; give A and b");
        p = as_rounded(p);
    }
    return s;
}

/// How many conditions the orders are.
STAGECRAFT_INLINE std::size_t number_of_conditions(const tree_view& trees, const std::vector<int>& orders) {
    std::size_t count = 0;
    for (const tree_row& t : trees.rows)
        for (const int p : orders) count += t.order <= p ? 1 : 0;
    return count;
}

STAGECRAFT_INLINE existence_attempt best_attempt(const existence_subject& s, const std::vector<int>& orders,
                                                 int digits, std::string& trouble) {
    const int most = *std::max_element(orders.begin(), orders.end());
    const tree_table trees = coupled_trees(s.coupling, false, static_cast<int>(s.partners.size()), most);
    std::optional<existence_attempt> best;
    constexpr std::array<alike, 3> sharing{alike::anywhere, alike::in_a_column, alike::nowhere};
    for (const int most_stages : {64, 4, 3}) {
        if (most_stages < 64 && most <= most_stages) continue;
        std::size_t numbers = 0;
        for (const alike same : sharing) {
            sought_method method = sought(s.partners, same);
            if (std::exchange(numbers, method.numbers.size()) == method.numbers.size()) continue;
            try {
                const tableaux::time_share share(tableaux::time_share::left() / 2);
                const order_system system(method, trees.view(), {orders, most_stages});
                existence_attempt now{std::move(method), find_nearby(system, digits), system.gap(), orders,
                                      number_of_conditions(trees.view(), orders)};
                if (trouble.empty()) trouble = now.found.why_not;
                if (!best || best->rank() < now.rank()) best = std::move(now);
                if (best->found.all_equations) return *std::move(best);
            } catch (const tableaux::undecided& e) {
                if (trouble.empty()) trouble = e.what();
            }
        }
    }
    return best ? *std::move(best) : existence_attempt{};
}

STAGECRAFT_INLINE moved_entries moved(const existence_attempt& a) {
    moved_entries out;
    for (std::size_t i = 0; i < a.method.numbers.size(); ++i) {
        const sought_number& x = a.method.numbers[i];
        if (x.known || x.surd) continue;
        const auto by =
            tableaux::ball(a.found.numbers[i] - tableaux::ball(x.value, a.found.numbers[i].bits()))
                .upper_magnitude();
        if (by > out.most) {
            out.most = by;
            out.farthest = x.name;
        }
        const auto rounding = x.radius.to<tableaux::bound>();
        if (x.is_quotient && by > 0) ++out.quotients;
        if (rounding > 0 && by / rounding > out.in_roundings) {
            out.in_roundings = by / rounding;
            out.worst = x.name;
        }
    }
    return out;
}

/// Orders that are proved; what else was claimed is not.
STAGECRAFT_INLINE void claim_what_is_proved(tableaux::claims& claims, const existence_attempt& a) {
    tableaux::claims proved;
    if (claims.order) proved.order = std::min(*claims.order, a.orders[0]);
    if (claims.embedded_order && a.orders.size() > 1)
        proved.embedded_order = std::min(*claims.embedded_order, a.orders[1]);
    claims = proved;
}

STAGECRAFT_INLINE nlohmann::ordered_json polished_json(const tableaux::method_file& file,
                                                       const existence_attempt& a, int digits) {
    bool decided = true;
    const auto put = [&](tableaux::entry& e, std::size_t number) {
        const auto& x = a.method.numbers[number];
        const tableaux::ball& value = a.found.numbers[number];
        const bool decimal = e.text.find_first_of(".eE") != std::string::npos;
        if (x.known || x.surd) {
            if (decimal && x.known) e.text = x.value.str();
        } else if (const auto text = tableaux::decimal_text(value, digits)) {
            e.text = *text;
        } else {
            decided = false;
        }
    };
    const auto polish = [&](tableaux::tableau_file& t, std::size_t n) {
        const auto list = [&](std::vector<tableaux::entry>& entries, const sought_method::row& numbers) {
            for (std::size_t i = 0; i < entries.size(); ++i) put(entries[i], numbers[i]);
        };
        for (std::size_t i = 0; i < t.A.size(); ++i) list(t.A[i], a.method.A[n][i]);
        list(t.b, a.method.weights[n]);
        list(t.c, a.method.nodes[a.method.node_of[n]]);
        if (!t.b_embedded.empty() && a.method.weights.size() > a.method.partners())
            list(t.b_embedded, a.method.weights[a.method.partners() + n]);
        t.b_theta.clear();
        const bool last_row_is_b =
            t.claims.stiffly_accurate == true && a.method.A[n].back() == a.method.weights[n];
        claim_what_is_proved(t.claims, a);
        if (last_row_is_b) t.claims.stiffly_accurate = true;
    };
    auto copy = file;
    nlohmann::ordered_json json;
    if (auto* alone = std::get_if<tableaux::tableau_file>(&copy)) {
        polish(*alone, 0);
        json = tableaux::to_json(*alone);
    } else {
        auto& several = std::get<tableaux::partitioned_file>(copy);
        for (std::size_t n = 0; n < several.partners.size(); ++n) polish(several.partners[n], n);
        claim_what_is_proved(several.claims, a);
        json = tableaux::to_json(several);
    }
    return decided ? json : nlohmann::ordered_json();
}

}  // namespace stagecraft::theory::detail
