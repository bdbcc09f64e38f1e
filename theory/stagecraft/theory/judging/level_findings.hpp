// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stagecraft/method/simplifying_assumptions.hpp>
#include <stagecraft/tableaux/claims.hpp>
#include <stagecraft/theory/judging/file_certificate.hpp>
#include <stagecraft/theory/judging/finding_in_its_time.hpp>
#include <stagecraft/theory/judging/order_finding.hpp>
#include <stagecraft/theory/judging/rounded_properties.hpp>
#include <stagecraft/theory/judging/subject.hpp>
#include <stagecraft/theory/trees/effective_order.hpp>
#include <stagecraft/theory/trees/modified_equation.hpp>
#include <string>
#include <string_view>
#include <vector>

/// Numbers that count how far conditions hold level by level: B(p), C(q), D(r), the order for linear problems, the weak stage
/// order, the effective order and that of the energy. Each is found, and may be claimed.

namespace stagecraft::theory {

/// The largest level up to which no condition certainly fails, and the first that does.
template <class K>
struct level_finding {
    int value = 0;
    int tested = 0;  ///< as far as every bound is small enough to refute
    std::optional<K> residual;
    std::string condition;                                    ///< that fails
    tableaux::bound left = 0, bound = 0, relative_bound = 0;  ///< of those that hold
};

namespace detail {

/// levels(k, take) calls take(defect, size of the quantities compared, name) for each condition of level k = 1, 2, ... in turn.
template <class K, class Levels>
level_finding<K> find_level(int most, Levels levels) {
    level_finding<K> found;
    for (int k = 1; k <= most && !found.residual; ++k) {
        levels(k, [&](const K& defect, tableaux::bound size, const auto& name) {
            if (found.residual) return;
            if (certainly_nonzero(defect)) {
                found.residual = defect;
                found.condition = name();
                return;
            }
            found.left = std::max(found.left, size_of(defect));
            found.bound = std::max(found.bound, uncertainty_of(defect));
            if (size > 0)
                found.relative_bound = std::max(found.relative_bound, uncertainty_of(defect) / size);
        });
        if (found.residual) break;
        found.value = k;
        if (found.tested == k - 1 && !says_nothing(found.relative_bound, 1)) found.tested = k;
    }
    return found;
}

inline std::string named(const char* what, int k) {
    return std::string(what) + "(" + std::to_string(k) + ")";
}

/// B(k), C(k) or D(k): `which` is satisfies_quadrature and so on.
template <class K, class Which>
level_finding<K> find_simplifying(const subject<K>& s, const char* name, int most, Which which) {
    tableaux::bound largest = 0;
    for (int i = 0; i < s.stages(); ++i) largest = std::max(largest, size_of(K(s.t.c(i))));
    node_power<K> power(s.stages());
    return find_level<K>(most, [&](int k, const auto& take) {
        const auto size = std::max<tableaux::bound>(1, std::pow(largest, k));
        int row = 0;
        which(s.t, power, [&](const K& left, const K& right) {
            ++row;
            take(K(left - right), size,
                 [&] { return named(name, k) + (*name == 'B' ? "" : ", equation " + std::to_string(row)); });
            return true;
        });
        power.advance(s.t.c);
    });
}

/// k! b^T A^(k-1) 1 = 1: R(z) = e^z + O(z^(k+1)).
template <class K>
level_finding<K> find_linear_order(const subject<K>& s, int most) {
    typename matrix_model<K>::element v(static_cast<std::size_t>(s.stages()), K(1));
    const matrix_model<K> model(s.t);
    return find_level<K>(most, [&](int k, const auto& take) {
        take(K(model.dot_b(v) * K(k) - K(1)), 1,
             [&] { return std::to_string(k) + "! b^T A^" + std::to_string(k - 1) + " 1 = 1"; });
        v = model.apply(v);
        for (K& x : v) x = x * K(k);
    });
}

/// b^T A^j (k A c^(k-1) - c^k) = 0 for j = 0, ..., s - 1, which by Cayley and Hamilton are all
/// (Ketcheson-Seibold-Shirokoff-Zhou 2020, Biswas-Ketcheson-Seibold-Shirokoff 2023).
template <class K>
level_finding<K> find_weak_stage_order(const subject<K>& s, int most) {
    const matrix_model<K> model(s.t);
    std::vector<typename matrix_model<K>::element> rows{model.weights()};
    while (static_cast<int>(rows.size()) < s.stages()) rows.push_back(model.apply_transposed(rows.back()));
    node_power<K> power(s.stages());
    return find_level<K>(most, [&](int k, const auto& take) {
        typename matrix_model<K>::element tau;
        tableaux::bound size = 0;
        satisfies_stages(s.t, power, [&](const K& left, const K& right) {
            tau.push_back(left - right);
            size = std::max({size, size_of(left), size_of(right)});
            return true;
        });
        for (std::size_t j = 0; j < rows.size(); ++j) {
            tableaux::bound weight = 0;
            for (const K& x : rows[j]) weight += size_of(x);
            take(model.pair(rows[j], tau), weight * size,
                 [&] { return "b^T A^" + std::to_string(j) + " tau^(" + std::to_string(k) + ") = 0"; });
        }
        power.advance(s.t.c);
    });
}

template <class K>
level_finding<K> find_effective_order(const subject<K>& s, int most) {
    effective_order_walk<K> walk(s.t);
    return find_level<K>(std::min(most, largest_effective_order), [&](int n, const auto& take) {
        for (const K& condition : walk.advance())
            take(condition, tableaux::bound(1) / 10,
                 [&] { return "a condition on the effective order " + std::to_string(n); });
    });
}

/// The energy of every Hamiltonian system changes by O(h^(n + 1)) in a step: the energy conditions of the modified equation.
template <class K>
level_finding<K> find_energy_order(const subject<K>& s, int most) {
    modified_equation_walk<K> walk(s.t);
    return find_level<K>(std::min(most, largest_modified_order), [&](int n, const auto& take) {
        const auto b = walk.advance();
        if (n == 1) take(K(b.front() - K(1)), 1, [] { return std::string("dot(b, one) == 1"); });
        for (const K& condition : walk.energy_conditions(b))
            take(condition, tableaux::bound(1) / 10,
                 [&] { return "a condition on the energy of order " + std::to_string(n); });
    });
}

}  // namespace detail

/// Names of what is found level by level, as claims have them.
inline constexpr std::array<std::string_view, 7> level_names{
    "B", "C", "D", "linear_order", "weak_stage_order", "effective_order", "energy_order"};

/// How far the conditions of that name hold, looked for up to `most`, which the barriers 2 s + 1 of B, C, D and the weak stage
/// order, 2 s and s of the linear order and largest_effective_order may make less. O(s^3) operations for each level; for the
/// effective order O(s^2) for each tree.
template <class K>
level_finding<K> find_levels(const subject<K>& s, std::string_view name, int most) {
    const int limit = std::min(most, 2 * s.stages() + 1);
    const auto simplifying = [&](const char* which, auto satisfies) {
        return detail::find_simplifying(s, which, limit, satisfies);
    };
    if (name == "B") return simplifying("B", [](const auto&... x) { return satisfies_quadrature(x...); });
    if (name == "C") return simplifying("C", [](const auto&... x) { return satisfies_stages(x...); });
    if (name == "D") return simplifying("D", [](const auto&... x) { return satisfies_adjoint(x...); });
    if (name == "linear_order") return detail::find_linear_order(s, std::min(most, order_barrier(s) + 1));
    if (name == "weak_stage_order") return detail::find_weak_stage_order(s, limit);
    if (name == "energy_order") return detail::find_energy_order(s, most);
    return detail::find_effective_order(s, most);
}

/// How far the conditions of that name are looked at where there are more and more trees.
inline int most_looked_at(std::string_view name) {
    return name == "effective_order" ? largest_effective_order
           : name == "energy_order"  ? largest_modified_order
                                     : 2 * tableaux::most_stages + 1;
}

/// The finding, and the verdict on a claim. An effective order and one of the energy are at least the order.
template <class K>
finding judge_level(const subject<K>& s, std::string_view name, std::optional<int> claimed, int order) {
    finding f;
    f.name = name;
    const int reach = most_looked_at(name);
    if (!claimed && order >= reach) {
        f.value = order;
        return f;
    }
    const auto found = find_levels(s, name, reach);
    const bool by_order = reach < tableaux::most_stages && order > found.value;
    f.value = by_order ? order : claimed ? found.value : found.tested;
    if (!claimed) return f;
    f.claimed = std::to_string(*claimed);
    if (by_order && order >= *claimed && exact_scalar<K>)
        f.judgement = verdict::proved("the order is " + std::to_string(order));
    else if (*claimed > reach)
        f.judgement = verdict::undecided("it is looked at to " + std::to_string(reach));
    else if (found.value < *claimed)
        f.judgement =
            verdict::refuted(found.residual ? found.condition + " leaves " + in_words(*found.residual)
                                            : "it is " + std::to_string(found.value));
    else if constexpr (exact_scalar<K>)
        f.judgement = verdict::proved("every condition up to " + *f.claimed + " holds");
    else {
        f.relative_bound = brief(found.relative_bound);
        f.judgement = says_nothing(found.relative_bound, 1)
                          ? verdict::inconclusive(brief(found.left), brief(found.bound), "too few digits")
                          : verdict::consistent(brief(found.left), brief(found.bound), data_reason);
    }
    return f;
}

namespace detail {

/// The judgement on a stage order that enclosures do not refute.
void set_open_stage_order(finding& f, tableaux::bound residual, tableaux::bound bound,
                          tableaux::bound relative_bound);

template <class K>
finding judge_stage_order(const subject<K>& s, std::optional<int> claimed, std::vector<failure>& failures) {
    finding f;
    f.name = "stage_order";
    const auto found = find_stage_order(s, std::max(claimed.value_or(0), 2 * s.stages()));
    f.value = claimed ? found.stage_order : found.tested;
    if (!claimed) return f;
    f.claimed = std::to_string(*claimed);
    if (found.stage_order < *claimed) {
        for (const auto& x : found.failing) {
            const std::string k = std::to_string(x.k), i = std::to_string(x.row + 1);
            const std::string power = x.k == 1   ? "one"
                                      : x.k == 2 ? "c"
                                                 : "pow<" + std::to_string(x.k - 1) + ">(c)";
            failures.push_back({x.which == 'B'
                                    ? "B(" + k + "): dot(b, " + power + ") == 1/" + k
                                    : "C(" + k + ") in row " + i + ": A*" + power + " == c^" + k + "/" + k,
                                "", shown(x.residual), in_words(x.residual)});
        }
        f.judgement = verdict::refuted(failures.back().condition + " leaves " + failures.back().in_words);
    } else if constexpr (exact_scalar<K>) {
        f.judgement = verdict::proved("B(" + *f.claimed + ") and C(" + *f.claimed + ") hold");
    } else {
        set_open_stage_order(f, found.residual, found.bound, found.relative_bound);
    }
    return f;
}

/// The claim on a level, where there is one.
inline std::optional<int> claimed_level(const tableaux::claims& claims, std::string_view name) {
    for (const auto& [key, member] : tableaux::counted_claims)
        if (key == name) return claims.*member;
    return std::nullopt;
}

template <class K>
void judge_levels(const subject<K>& s, const tableaux::claims& claims, file_certificate& certificate) {
    const int order = certificate.find("order")->value.value_or(0);  // (findings move as more are added)
    for (const auto name : level_names) {
        const auto claimed = claimed_level(claims, name);
        if (!claimed && s.stages() > 16) continue;
        certificate.findings.push_back(found_in_its_time(std::string(name), claimed, 0.2, [&, key = name] {
            return judge_level(s, key, claimed, order);
        }));
    }
}

}  // namespace detail

}  // namespace stagecraft::theory
