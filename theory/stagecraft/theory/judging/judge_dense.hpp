// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <optional>
#include <stagecraft/method/order_conditions.hpp>
#include <stagecraft/tableaux/tableau_file.hpp>
#include <stagecraft/theory/judging/file_certificate.hpp>
#include <stagecraft/theory/judging/judge_claims.hpp>
#include <stagecraft/theory/judging/order_finding.hpp>
#include <stagecraft/theory/judging/subject.hpp>
#include <string>
#include <utility>
#include <vector>

/// Dense output y(t + theta h) = y + h sum_i b_i(theta) k_i with polynomials b_i: order at every theta,
/// continuity with the steps before and after (Hairer-Norsett-Wanner I.II.6).

namespace stagecraft::theory {

/// The coefficients of theta, theta^2, ... of each b_i, by columns, next to the method.
template <class K>
struct dense_subject {
    subject<K> method;
    Eigen::Matrix<K, Eigen::Dynamic, Eigen::Dynamic> b;

    int degree() const { return static_cast<int>(b.cols()); }
};

template <class K, class Convert>
dense_subject<K> make_dense_subject(subject<K> method, const tableaux::tableau_file& file, Convert convert) {
    dense_subject<K> d{std::move(method), {}};
    std::size_t degree = 0;
    for (const auto& row : file.b_theta) degree = std::max(degree, row.size());
    d.b.resize(file.stages(), static_cast<Eigen::Index>(degree));
    const tableaux::entry zero = tableaux::read_entry("0");
    for (std::size_t i = 0; i < file.b_theta.size(); ++i)
        for (std::size_t k = 0; k < degree; ++k)
            d.b(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) =
                convert(k < file.b_theta[i].size() ? file.b_theta[i][k] : zero);
    return d;
}

/// A condition on the coefficient of theta^power that fails.
template <class K>
struct dense_residual {
    rooted_tree tree;
    int power;
    K residual;
};

namespace detail {

/// The conditions sum_i b_i(theta) phi_i(tau) = theta^n/gamma(tau) for every tree of order n, as identities of
/// polynomials in theta (Hairer-Norsett-Wanner I.II.6, Theorem 6.1), up to order `most`.
template <class K>
search_for_order<dense_residual<K>> find_dense_order(const dense_subject<K>& d, int most) {
    search_for_order<dense_residual<K>> found;
    condition_sizes size;
    tableau<K> t = d.method.t;  // the conditions are those of autonomous systems: c = A*1
    for (int i = 0; i < t.stages(); ++i) t.c(i) = t.A.row(i).sum();
    const tree_table trees(most);
    std::uint32_t row = 0;
    int order = 1;
    bool go_on = true;
    const auto same = [](const K&, const K&) { return true; };
    visit_trees(t, most, same, [&](const auto& phi, const K& gamma, int n) {
        if (n > order) {
            go_on = found.conclude(order, size);
            order = n;
        }
        if (!go_on) return false;
        const bool earlier = found.order < n - 1;
        for (int k = 1; k <= std::max(d.degree(), n); ++k) {
            K weight(0);
            if (k <= d.degree())
                for (int i = 0; i < t.stages(); ++i) weight = weight + d.b(i, k - 1) * phi[i];
            const K defect = gamma * weight - K(k == n ? 1 : 0);
            if (certainly_nonzero(defect) && !earlier)
                found.failing.push_back({trees.view().tree(row), k, defect / gamma});
            size.take(defect, static_cast<tableaux::bound>(trees.view().rows[row].density));
        }
        ++row;
        return true;
    });
    if (go_on) found.conclude(order, size);
    return found;
}

template <class K>
finding judge_dense_order(const dense_subject<K>& d, std::optional<int> claimed, int order_of_step,
                          std::vector<failure>& failures) {
    const int most =
        std::min(std::max(claimed.value_or(0), order_of_step) + 1, tableaux::largest_dense_order);
    const auto found = find_dense_order(d, most);
    const std::size_t first = failures.size();
    for (const auto& f : found.failing) {
        const int n = order(f.tree);
        std::string condition = "dot(b(theta)" + condition_text(f.tree).substr(5);
        condition = condition.substr(0, condition.find(" ==")) + " == theta" +
                    (n > 1 ? "^" + std::to_string(n) + "/" + std::to_string(density(f.tree)) : "") +
                    ", coefficient of theta^" + std::to_string(f.power);
        failures.push_back({std::move(condition), bracket(f.tree), shown(f.residual), in_words(f.residual)});
    }
    order_facts facts;
    facts.value = exact_scalar<K> ? found.order : std::min(found.order, found.tested);
    facts.refuted_from = found.order + 1;
    return order_verdict("dense_order", claimed, found, facts, exact_scalar<K>,
                         found.failing.empty() ? nullptr : &failures[first]);
}

/// The stage that is f at the beginning of the step, and that at its end: rows of A that are 0, and b.
template <class K>
std::pair<int, int> first_and_last_stage(const subject<K>& s) {
    std::pair<int, int> found{-1, -1};
    for (int i = s.stages() - 1; i >= 0; --i) {
        bool zero = true, same = true;
        for (int j = 0; j < s.stages(); ++j) {
            zero = zero && !certainly_nonzero(K(s.t.A(i, j)));
            same = same && !certainly_nonzero(K(s.t.A(i, j) - s.t.b(j)));
        }
        if (zero) found.first = i;
        if (same) found.second = i;
    }
    return found;
}

/// 0: b_i(1) = b_i, the next step begins where the dense output ends. 1: besides, b_i'(0) is 1 for the first
/// stage and b_i'(1) for the one that is first in the next step, 0 for all others.
template <class K>
finding judge_smoothness(const dense_subject<K>& d, std::optional<int> claimed) {
    const auto& t = d.method.t;
    const auto at = [](int i) { return "b[" + std::to_string(i + 1) + "]"; };
    const auto [first, last] = first_and_last_stage(d.method);
    verdict continuous = verdict::proved("b(1) = b");
    verdict smooth = first < 0 || last < 0
                         ? verdict::refuted("no stage is the derivative at " +
                                            std::string(first < 0 ? "the beginning" : "the end"))
                         : verdict::proved("b(1) = b, and b'(0), b'(1) are the derivatives at both ends");
    for (int i = 0; i < t.stages(); ++i) {
        K value(0), slope(0);
        tableaux::bound scale = 1;
        for (int k = 1; k <= d.degree(); ++k) {
            value = value + d.b(i, k - 1);
            slope = slope + K(k) * d.b(i, k - 1);
            scale = std::max(scale, size_of(K(d.b(i, k - 1))));
        }
        continuous =
            both(continuous, vanishes(K(value - t.b(i)), scale, at(i) + "(1) = " + at(i), data_reason));
        if (smooth.is_refuted()) continue;
        smooth =
            both(smooth, vanishes(K(d.b(i, 0) - K(i == first ? 1 : 0)), scale, at(i) + "'(0)", data_reason));
        smooth = both(smooth, vanishes(K(slope - K(i == last ? 1 : 0)), scale, at(i) + "'(1)", data_reason));
    }
    smooth = both(continuous, smooth);
    finding f;
    f.name = "dense_smoothness";
    if (!continuous.is_refuted()) f.value = smooth.is_refuted() ? 0 : 1;
    if (claimed) {
        f.claimed = std::to_string(*claimed);
        f.judgement = *claimed == 0 ? continuous : smooth;
    } else {
        f.truth = continuous.is_refuted() || smooth.is_refuted() ? continuous : smooth;
    }
    return f;
}

/// Whether order and smoothness claimed are not refuted.
template <class K>
bool keeps_dense_claims(const dense_subject<K>& d, const tableaux::claims& claims) {
    if (const int p = claims.dense_order.value_or(0); p > 0 && find_dense_order(d, p).order < p) return false;
    return !claims.dense_smoothness || !judge_smoothness(d, claims.dense_smoothness).judgement->is_refuted();
}

/// Single coefficients of b(theta) whose change restores what is claimed of it. The sum of the coefficients
/// of one power, dot(b(theta), one) == theta, fixes the change where it fails; where it holds no single
/// coefficient is wrong.
template <class K>
void find_dense_suspects(const dense_subject<K>& d, const tableaux::tableau_file& file,
                         file_certificate& certificate) {
    for (int k = 0; k < d.degree(); ++k) {
        K defect(k == 0 ? -1 : 0);
        for (int i = 0; i < d.method.stages(); ++i) defect = defect + d.b(i, k);
        if (!certainly_nonzero(defect)) continue;
        for (int i = 0; i < d.method.stages(); ++i) {
            const auto& row = file.b_theta[static_cast<std::size_t>(i)];
            if (k >= static_cast<int>(row.size())) continue;
            dense_subject<K> repaired = d;
            repaired.b(i, k) = d.b(i, k) - defect;
            if (!keeps_dense_claims(repaired, file.claims)) continue;
            certificate.suspects.push_back(
                {"b_theta[" + std::to_string(i + 1) + "][" + std::to_string(k + 1) + "]",
                 row[static_cast<std::size_t>(k)].text, shown(K(repaired.b(i, k)))});
        }
    }
}

}  // namespace detail

/// Judges the dense output of a file that has one: order at every theta (that of the derivative is one less),
/// continuity. Names suspects where nothing else is refuted.
template <class K>
void judge_dense(const dense_subject<K>& d, const tableaux::tableau_file& file,
                 file_certificate& certificate) {
    const bool sound = certificate.overall() != standing::refuted;
    const finding* order = certificate.find("order");
    certificate.findings.push_back(detail::judge_dense_order(
        d, file.claims.dense_order, order && order->value ? *order->value : 0, certificate.failures));
    certificate.findings.push_back(detail::judge_smoothness(d, file.claims.dense_smoothness));
    if (!sound || certificate.overall() != standing::refuted) return;
    detail::find_dense_suspects(d, file, certificate);
    if (certificate.suspects.empty())
        certificate.suspects_note = "no change of a single coefficient of b_theta restores every claim";
}

}  // namespace stagecraft::theory
