// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <stagecraft/tableaux/read_partitioned.hpp>
#include <stagecraft/theory/judging/judge_claims.hpp>
#include <stagecraft/theory/judging/judge_coupling.hpp>
#include <stagecraft/theory/stability/rosenbrock_function.hpp>
#include <stagecraft/theory/trees/rosenbrock_trees.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Rosenbrock and W methods: the orders by their trees, and what R of beta = alpha + Gamma decides.

namespace stagecraft::theory {

namespace detail {

/// The inverse of a lower triangular matrix; empty where a diagonal entry may be 0.
template <class K>
typename rosenbrock_method<K>::matrix lower_inverse(const typename rosenbrock_method<K>::matrix& M) {
    const auto s = M.rows();
    typename rosenbrock_method<K>::matrix inverse(s, s);
    for (Eigen::Index i = 0; i < s; ++i) {
        if (!certainly_nonzero(M(i, i))) return {};
        for (Eigen::Index j = 0; j < s; ++j) {
            K sum(i == j ? 1 : 0);
            for (Eigen::Index k = j; k < i; ++k) sum = sum - M(i, k) * inverse(k, j);
            inverse(i, j) = j > i ? K(0) : K(sum / M(i, i));
        }
    }
    return inverse;
}

template <class K>
rosenbrock_method<K> rosenbrock_of(const coupled_subject<K>& s) {
    return theory::rosenbrock_of(*s.file, s.partners[0].t, s.partners[1].t);
}

/// alpha or Gamma as a tableau whose c, where they are given, are to be the row sums.
template <class K>
subject<K> with_row_sums(const coupled_subject<K>& s, const rosenbrock_method<K>& m, std::size_t k) {
    subject<K> one = s.partners[k];
    one.t.A = k == 0 ? m.alpha : m.Gamma;
    return one;
}

/// The linear part as a tableau on trial.
template <class K>
subject<K> linear_subject(const rosenbrock_method<K>& m) {
    subject<K> s{linear_part(m), false, true, true};
    for (Eigen::Index i = 0; i < m.stages(); ++i)
        s.strictly_lower = s.strictly_lower && !certainly_nonzero(m.beta(i, i));
    return s;
}

template <class K, class Weights>
search_for_order<coloured_residual<K>> find_rosenbrock_order(const rosenbrock_method<K>& m, const Weights& b,
                                                             const rosenbrock_trees& trees) {
    search_for_order<coloured_residual<K>> found;
    condition_sizes size;
    int n = 1;
    bool go_on = true;
    visit_rosenbrock_trees(m, b, trees, [&](std::uint32_t row, const K& weight) {
        const rosenbrock_tree& t = trees.rows()[row];
        if (t.level > n) {
            go_on = found.conclude(n, size);
            n = t.level;
        }
        if (!go_on) return false;
        const K gamma(t.density);
        const K defect = gamma * weight - K(trees.is_zero(t) ? 0 : 1);
        const bool earlier = !found.failing.empty() && trees.rows()[found.failing.front().row].level < n;
        if (certainly_nonzero(defect) && !earlier) found.failing.push_back({row, defect / gamma});
        size.take(defect, static_cast<tableaux::bound>(t.density));
        return true;
    });
    if (go_on) found.conclude(n, size);
    return found;
}

/// What is looked at: a name in the file, its claim, and how far.
struct rosenbrock_question {
    const char* name;
    rosenbrock_conditions which;
    std::optional<int> claimed;
    int most;
    bool embedded = false;
};

/// The questions about a file that have an answer: those on embedded weights where there are some.
std::vector<rosenbrock_question> questions_of(const tableaux::partitioned_file& file);

/// The finding, and the conditions that fail where the orders of a Rosenbrock method or a claim are concerned.
template <class K>
finding judge_rosenbrock_order(const rosenbrock_method<K>& m, const rosenbrock_question& q,
                               std::vector<failure>& failures) {
    const rosenbrock_trees trees(q.which, q.most);
    const auto found = find_rosenbrock_order(m, q.embedded ? m.b_embedded : m.b, trees);
    std::vector<failure> these;
    for (const auto& f : found.failing) {
        std::string condition = trees.condition(f.row);
        if (q.embedded) condition.insert(condition.find(','), "_embedded");
        these.push_back(
            {std::move(condition), trees.bracket(f.row), shown(f.residual), in_words(f.residual)});
    }
    order_facts facts;
    facts.value = exact_scalar<K> ? found.order : std::min(found.order, found.tested);
    facts.refuted_from = found.failing.empty() ? q.most + 1 : found.order + 1;
    auto f = order_verdict(q.name, q.claimed, found, facts, exact_scalar<K>,
                           these.empty() ? nullptr : these.data());
    if (q.claimed || q.which == rosenbrock_conditions::jacobian)
        failures.insert(failures.end(), these.begin(), these.end());
    return f;
}

/// R(infinity) = 1 - b^T omega 1; needs omega.
template <class K>
K limit_of(const rosenbrock_method<K>& m) {
    const auto v = product_of<K>(m.omega, ones<K>(m.stages()));
    K limit(1);
    for (Eigen::Index i = 0; i < m.stages(); ++i) limit = limit - m.b[i] * v[i];
    return limit;
}

/// Why no order of index 1 is known for convergence, which needs a regular beta and |R(infinity)| < 1: refuted, undecided, or nothing.
template <class K>
std::optional<verdict> no_index_1(const rosenbrock_method<K>& m) {
    if (m.omega.size() == 0) return verdict::refuted("Gamma is not certainly regular");
    const K limit = limit_of(m), excess = limit * limit - K(1);
    if (certainly_negative(excess)) return std::nullopt;
    const std::string what = "|R(infinity)| < 1 is needed; R(infinity) = " + in_words(limit);
    if (certainly_nonzero(excess) || exact_scalar<K>) return verdict::refuted(what);
    return verdict::undecided(what);
}

template <class K>
finding judge_index_1(const rosenbrock_method<K>& m, const rosenbrock_question& q,
                      std::vector<failure>& failures) {
    const auto open = no_index_1(m);
    if (!open) return judge_rosenbrock_order(m, q, failures);
    finding f;
    f.name = q.name;
    (q.claimed ? f.judgement : f.truth) = *open;
    if (q.claimed) f.claimed = std::to_string(*q.claimed);
    return f;
}

/// c = A*1 and d = Gamma*1 where the file gives them: what a non-autonomous problem sees.
template <class K>
void judge_times(const coupled_subject<K>& s, const rosenbrock_method<K>& m, file_certificate& certificate) {
    std::optional<finding> all;
    for (std::size_t k = 0; k < 2; ++k) {
        if (!s.partners[k].nodes_given) continue;
        const std::size_t first = certificate.failures.size();
        finding f = judge_row_sums(with_row_sums(s, m, k), {}, certificate.failures);
        for (std::size_t i = first; k == 1 && i < certificate.failures.size(); ++i) {
            std::string& text = certificate.failures[i].condition;
            text.replace(text.find("A["), 1, "Gamma");
            text.replace(text.find("c["), 1, "d");
        }
        if (all) f.truth = f.judgement = both(*all->judgement, *f.judgement);
        all = std::move(f);
    }
    if (all) certificate.findings.push_back(std::move(*all));
}

/// A_stable and L_stable by R; stiffly accurate: the last row of beta is b, and the last stage stands at the end of the step
/// (Hairer-Wanner II.IV.7).
template <class K>
verdict rosenbrock_property(const rosenbrock_method<K>& m, std::string_view property) {
    const auto linear = linear_subject(m);
    const verdict v = property_of(linear, property);
    if (property != "stiffly_accurate") return v;
    if (v.is_refuted() && v.reason().starts_with("A["))
        return verdict::refuted("beta" + v.reason().substr(1));
    const K end = product_of<K>(m.alpha, ones<K>(m.stages()))[m.stages() - 1];
    return both(v, vanishes(K(end - K(1)), 1, "the last row of A sums to 1", data_reason));
}

inline constexpr std::array<std::string_view, 3> rosenbrock_properties{"A_stable", "L_stable",
                                                                       "stiffly_accurate"};

inline std::optional<bool> claimed_property(const tableaux::claims& claims, std::string_view property) {
    for (const auto& [name, member] : tableaux::yes_no_claims)
        if (name == property) return claims.*member;
    return std::nullopt;
}

/// Whether a claim certainly fails.
template <class K>
bool refutes_a_rosenbrock_claim(const coupled_subject<K>& s) {
    const auto& file = *s.file;
    auto m = rosenbrock_of(s);
    for (std::size_t k = 0; k < 2; ++k)
        if (s.partners[k].nodes_given)
            for (const K& defect : row_sum_defects(with_row_sums(s, m, k)))
                if (certainly_nonzero(defect)) return true;
    if (file.claims.index_1_order) m.omega = lower_inverse<K>(m.beta);
    for (const auto& q : questions_of(file)) {
        const bool weights_alone = !q.claimed && !q.embedded && q.which == rosenbrock_conditions::jacobian;
        const int wanted = weights_alone ? 1 : q.claimed.value_or(0);
        if (wanted < 1) continue;
        if (q.which == rosenbrock_conditions::index_1)
            if (const auto open = no_index_1(m)) {
                if (open->is_refuted()) return true;
                continue;
            }
        const rosenbrock_trees trees(q.which, wanted);
        if (find_rosenbrock_order(m, q.embedded ? m.b_embedded : m.b, trees).order < wanted) return true;
    }
    if constexpr (requires { certainly_negative(m.b[0]); })
        for (const auto property : rosenbrock_properties)
            if (const auto claimed = claimed_property(file.claims, property)) {
                const verdict v = rosenbrock_property(m, property);
                if (*claimed ? v.is_refuted() : v.is_proved()) return true;
            }
    return false;
}

}  // namespace detail

/// Judges a Rosenbrock or W method: row sums where c or d are given; the order, that of the embedded weights, that with an arbitrary
/// matrix, that of index 1; A- and L-stability and stiff accuracy.
template <class K>
void judge_rosenbrock(const coupled_subject<K>& s, file_certificate& certificate) {
    const auto& file = *s.file;
    auto m = detail::rosenbrock_of(s);
    m.omega = detail::lower_inverse<K>(m.beta);
    detail::judge_times(s, m, certificate);
    for (const auto& q : detail::questions_of(file))
        certificate.findings.push_back(detail::found_in_its_time(q.name, q.claimed, 0.3, [&] {
            return q.which == rosenbrock_conditions::index_1
                       ? detail::judge_index_1(m, q, certificate.failures)
                       : detail::judge_rosenbrock_order(m, q, certificate.failures);
        }));
    for (const auto property : detail::rosenbrock_properties) {
        finding f;
        f.name = property;
        f.truth = detail::in_its_time(0.3, [&] { return detail::rosenbrock_property(m, property); });
        if (const auto claimed = detail::claimed_property(file.claims, property)) {
            f.claimed = *claimed ? "true" : "false";
            f.judgement = *claimed ? *f.truth : negation(*f.truth);
        }
        certificate.findings.push_back(std::move(f));
    }
    if (m.omega.size() > 0) certificate.notes.push_back("R(infinity) = " + in_words(detail::limit_of(m)));
}

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/judge_rosenbrock-inl.hpp"
#endif
