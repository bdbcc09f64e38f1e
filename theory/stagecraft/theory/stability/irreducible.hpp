// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include "stagecraft/theory/stability/stability_function.hpp"
#include "stagecraft/theory/statements/verdict.hpp"

namespace stagecraft::theory {

/// The stages (0-based, increasing) that do not influence y_1: b_j = 0 and no stage that counts uses them
/// (DJ-reducibility after Dahlquist and Jeltsch; Hairer-Wanner II, section IV.12).
template <class K>
std::vector<int> idle_stages(const tableau<K>& t) {
    require_shape(t);
    const int s = t.stages();
    std::vector<bool> used(static_cast<std::size_t>(s));
    std::vector<int> queue;
    const auto use = [&](int j) {
        if (used[static_cast<std::size_t>(j)]) return;
        used[static_cast<std::size_t>(j)] = true;
        queue.push_back(j);
    };
    for (int j = 0; j < s; ++j) {
        if (!(t.b[j] == K(0))) use(j);
    }
    while (!queue.empty()) {
        const int i = queue.back();
        queue.pop_back();
        for (int j = 0; j < s; ++j) {
            if (!(t.A(i, j) == K(0))) use(j);
        }
    }
    std::vector<int> idle;
    for (int j = 0; j < s; ++j) {
        if (!used[static_cast<std::size_t>(j)]) idle.push_back(j);
    }
    return idle;
}

/// The coarsest partition of the stages into classes of equal nodes whose row sums over every class agree
/// (S-reducibility after Stetter and Hundsdorfer-Spijker; Hairer-Wanner II, section IV.12): stages of one
/// class always have the same value. class_of[i] counts from 0. Found by refinement, O(s^3).
template <class K>
std::vector<int> equal_stage_classes(const tableau<K>& t) {
    require_shape(t);
    const int s = t.stages();
    std::vector<int> class_of(static_cast<std::size_t>(s), 0);
    const auto refined = [&](auto same) {
        std::vector<int> next(static_cast<std::size_t>(s), -1);
        int count = 0;
        for (int i = 0; i < s; ++i) {
            for (int j = 0; j < i && next[static_cast<std::size_t>(i)] < 0; ++j) {
                if (same(i, j)) next[static_cast<std::size_t>(i)] = next[static_cast<std::size_t>(j)];
            }
            if (next[static_cast<std::size_t>(i)] < 0) next[static_cast<std::size_t>(i)] = count++;
        }
        return next;
    };
    class_of = refined([&](int i, int j) { return t.c[i] == t.c[j]; });
    for (;;) {
        const auto next = refined([&](int i, int j) {
            if (class_of[static_cast<std::size_t>(i)] != class_of[static_cast<std::size_t>(j)]) return false;
            for (int m = 0; m < s; ++m) {  // sums over the class whose first member is m
                K difference(0);
                for (int k = 0; k < s; ++k) {
                    if (class_of[static_cast<std::size_t>(k)] != m) continue;
                    difference = difference + t.A(i, k) - t.A(j, k);
                }
                if (!(difference == K(0))) return false;
            }
            return true;
        });
        if (next == class_of) return class_of;
        class_of = next;
    }
}

/// DJ-irreducible: every stage influences the result.
template <class K>
verdict dj_irreducible(const tableau<K>& t) {
    const auto idle = idle_stages(t);
    if (idle.empty()) return verdict::proved("every stage is reached from b");
    std::string list;
    for (const int j : idle) list += (list.empty() ? "" : ", ") + std::to_string(j + 1);
    return verdict::refuted("stages without influence: " + list);
}

/// S-irreducible: no two stages are equal for every problem.
template <class K>
verdict s_irreducible(const tableau<K>& t) {
    const auto classes = equal_stage_classes(t);
    for (std::size_t i = 0; i < classes.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (classes[i] != classes[j]) continue;
            return verdict::refuted("stages " + std::to_string(j + 1) + " and " + std::to_string(i + 1) +
                                    " are always equal");
        }
    }
    return verdict::proved("no two stages have equal class sums");
}

/// The equivalent method without idle stages and with equal stages merged (their weights added): it gives the
/// same y_1 for every problem. The embedded weights are dropped unless nothing had to be reduced.
template <class K>
tableau<K> reduced(tableau<K> t) {
    for (;;) {
        const auto idle = idle_stages(t);
        const auto classes = equal_stage_classes(t);
        const int s = t.stages();
        std::vector<std::vector<int>> groups;
        if (!idle.empty()) {
            for (int i = 0, k = 0; i < s; ++i) {
                if (k < static_cast<int>(idle.size()) && idle[static_cast<std::size_t>(k)] == i) {
                    ++k;
                } else {
                    groups.push_back({i});
                }
            }
        } else {
            for (int i = 0; i < s; ++i) {
                const auto g = static_cast<std::size_t>(classes[static_cast<std::size_t>(i)]);
                if (g >= groups.size()) groups.resize(g + 1);
                groups[g].push_back(i);
            }
        }
        const auto n = static_cast<Eigen::Index>(groups.size());
        if (n == s) return t;
        tableau<K> smaller;
        smaller.A.resize(n, n);
        smaller.b.resize(n);
        smaller.c.resize(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            const auto& group = groups[static_cast<std::size_t>(i)];
            smaller.c[i] = t.c[group.front()];
            smaller.b[i] = K(0);
            for (const int k : group) smaller.b[i] = smaller.b[i] + t.b[k];
            for (Eigen::Index j = 0; j < n; ++j) {
                smaller.A(i, j) = K(0);
                for (const int k : groups[static_cast<std::size_t>(j)]) {
                    smaller.A(i, j) = smaller.A(i, j) + t.A(group.front(), k);
                }
            }
        }
        if (n == 0) throw std::invalid_argument("tableau: b is zero");
        t = smaller;
    }
}

}  // namespace stagecraft::theory
