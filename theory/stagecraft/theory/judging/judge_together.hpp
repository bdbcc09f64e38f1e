// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <stagecraft/theory/judging/judge_coupling.hpp>
#include <stagecraft/theory/judging/stability_report.hpp>
#include <stagecraft/theory/stability/algebraic_stability.hpp>
#include <stagecraft/theory/stability/nystrom_stability.hpp>
#include <stagecraft/theory/stability/ssp.hpp>
#include <string>
#include <vector>

/// What several tableaux are together besides their order: symmetric, algebraically stable, SSP, stable on oscillations.

namespace stagecraft::theory {

namespace detail {

/// The stages that some weight or some stage uses, of a tableau's columns.
template <class K>
std::vector<int> used_columns(const tableau<K>& t) {
    std::vector<int> used;
    for (int j = 0; j < t.stages(); ++j) {
        bool any = certainly_nonzero(t.b(j));
        for (int i = 0; i < t.stages(); ++i) any = any || certainly_nonzero(t.A(i, j));
        if (any) used.push_back(j);
    }
    return used;
}

/// A conjunction of equations between entries.
template <class K>
class mirrored {
  public:
    void add(const K& left, const K& right, const std::string& what) {
        const auto size = std::max({size_of(left), size_of(right), tableaux::bound(1e-3L)});
        verdict_ = both(verdict_, vanishes(K(left - right), size, what, data_reason));
    }
    const theory::verdict& verdict() const { return verdict_; }

  private:
    theory::verdict verdict_ =
        theory::verdict::proved("reversed in time, the stages are the same in reverse order");
};

inline std::string at(const char* name, int i, int j) {
    return name + ("[" + std::to_string(i + 1) + "]") + "[" + std::to_string(j + 1) + "]";
}

/// a_(s+1-i)(s+1-j) + a_ij = b_j over the rows and columns that count.
template <class K>
void add_mirror(const tableau<K>& t, const std::vector<int>& rows, const std::vector<int>& columns,
                const char* name, mirrored<K>& all) {
    const std::size_t m = rows.size(), n = columns.size();
    for (std::size_t i = 0; i < m; ++i)
        for (std::size_t j = 0; j < n; ++j)
            all.add(K(t.A(rows[i], columns[j]) + t.A(rows[m - 1 - i], columns[n - 1 - j])), t.b(columns[j]),
                    at(name, rows[i], columns[j]) + " and its mirror image sum to b");
    for (std::size_t j = 0; j < n; ++j)
        all.add(t.b(columns[j]), t.b(columns[n - 1 - j]), "the weights are a palindrome");
}

/// For y'' = f: the adjoint method (Hairer-Lubich-Wanner, section V.1) has the stages of this one in reverse order.
template <class K>
void add_nystrom_mirror(const coupled_subject<K>& s, mirrored<K>& all) {
    const auto &t = s.partners[0].t, &u = s.partners[1].t;
    const int n = s.stages();
    for (int i = 0; i < n; ++i) {
        const int k = n - 1 - i;
        all.add(K(t.c(i) + t.c(k)), K(1), "c is a palindrome");
        all.add(K(t.b(i) + t.b(k)), u.b(i), "b_bar and its mirror image sum to b");
        all.add(u.b(i), u.b(k), "b is a palindrome");
        for (int j = 0; j < n; ++j) {
            all.add(t.A(k, n - 1 - j), K(u.b(j) - t.b(j) - t.c(i) * u.b(j) + t.A(i, j)),
                    at("A_bar", i, j) + " and its mirror image");
            if (s.file->uses_velocity)
                all.add(K(u.A(k, n - 1 - j) + u.A(i, j)), u.b(j), at("A", i, j) + " and its mirror image");
        }
    }
}

}  // namespace detail

/// Symmetric (time-reversible), by the stages in reverse order; of separable methods those that count of either kind
/// (Hairer-Lubich-Wanner, section V.2). A symmetric method has an even order, so an odd one refutes; otherwise stages that
/// are no mirror images in this order leave it open. For separable, partitioned and Nystrom methods.
template <class K>
verdict symmetric_together(const coupled_subject<K>& s, std::optional<int> order) {
    if (order && *order % 2 != 0)
        return verdict::refuted("symmetric methods have an even order, and this one has " +
                                std::to_string(*order));
    detail::mirrored<K> all;
    if (s.nystrom()) {
        detail::add_nystrom_mirror(s, all);
    } else {
        const auto &t = s.partners[0].t, &u = s.partners[1].t;
        const bool separable = s.file->coupling == tableaux::coupling::separable;
        std::vector<int> stages;
        for (int i = 0; i < s.stages(); ++i) stages.push_back(i);
        const auto first = separable ? detail::used_columns(t) : stages,
                   second = separable ? detail::used_columns(u) : stages;
        detail::add_mirror(t, separable ? second : stages, first, "A", all);
        detail::add_mirror(u, separable ? first : stages, second, "A_hat", all);
    }
    if (all.verdict().is_refuted())
        return verdict::undecided("in reverse order the stages are no mirror images (" +
                                  all.verdict().reason() + "); in another one they may be");
    return all.verdict();
}

/// b >= 0 and the matrix of blocks b^m_i a^n_ij + b^n_j a^m_ji - b^m_i b^n_j positive semidefinite (Sandu-Gunther 2015):
/// contractive for every split of a problem into contractive parts. A tableau that is not so by itself refutes it.
template <class K>
verdict algebraically_stable_together(const coupled_subject<K>& s) {
    const auto n = s.stages(), parts = static_cast<int>(s.partners.size());
    tableaux::dense<K> m(n * parts, n * parts);
    for (int p = 0; p < parts; ++p)
        for (int i = 0; i < n; ++i) {
            const auto& t = s.partners[static_cast<std::size_t>(p)].t;
            if (certainly_negative(t.b(i)))
                return verdict::refuted(tableaux::partner_name(*s.file, static_cast<std::size_t>(p)) +
                                        ": b[" + std::to_string(i + 1) + "] < 0");
            for (int q = 0; q < parts; ++q)
                for (int j = 0; j < n; ++j) {
                    const auto& u = s.partners[static_cast<std::size_t>(q)].t;
                    m(p * n + i, q * n + j) = t.b(i) * u.A(i, j) + u.b(j) * t.A(j, i) - t.b(i) * u.b(j);
                }
            if (certainly_negative(m(p * n + i, p * n + i)))
                return verdict::refuted(tableaux::partner_name(*s.file, static_cast<std::size_t>(p)) + ": " +
                                        detail::at("M", i, i) + " = " + in_words(m(p * n + i, p * n + i)));
        }
    if constexpr (exact_scalar<K>) {
        const auto d = tableaux::diagonalise<K>(m);
        if (d.negative_direction())
            return verdict::refuted("M of all tableaux together has a negative direction");
        const auto signs = d.inertia();
        return verdict::proved("b >= 0, M of all together has " + std::to_string(signs.positive) +
                               " positive and " + std::to_string(signs.zero) + " zero pivots");
    }
    return verdict::undecided("the matrix of all tableaux is looked at over exact entries only");
}

/// The largest r for which the method is a convex combination of steps of Euler's method of length h/r with each part
/// (Higueras 2006): the radius of absolute monotonicity where it is the same for all parts.
template <class K>
claim common_ssp_radius(const coupled_subject<K>& s) {
    if constexpr (exact_scalar<K>) {
        std::vector<tableaux::dense<K>> all;
        for (const auto& p : s.partners) all.push_back(bordered(p.t));
        return detail::interval_claim("", common_ssp_radius(all));
    } else {
        return {"", verdict::undecided("looked at over exact entries only")};
    }
}

/// How long a step on y'' = -omega^2 y may be: (h omega)^2 up to which |trace| < 2 (periodicity, where area is kept), or both
/// eigenvalues lie in the unit disc.
template <class K>
finding oscillation_finding(const coupled_subject<K>& s) {
    finding f;
    f.name = "stability_interval";
    if constexpr (exact_scalar<K>) {
        const auto m = oscillation_matrix_of(s.partners[0].t, s.partners[1].t.b);
        if (m.keeps_area()) f.name = "periodicity_interval";
        const auto interval = oscillation_interval(m);
        const auto c = detail::interval_claim("(h omega)^2 up to", interval);
        f.truth = !interval.infinite && interval.high == K(0)
                      ? verdict::refuted("oscillations grow however short the step is")
                      : verdict::proved(c.statement + ", " + c.verdict.reason());
    } else {
        f.truth = verdict::undecided("looked at over exact entries only");
    }
    return f;
}

/// Judges all of it, and the claims on it, behind the orders.
template <class K>
void judge_together(const coupled_subject<K>& s, file_certificate& certificate) {
    const auto& claims = s.file->claims;
    const auto add = [&](const char* name, const std::optional<bool>& claimed, auto decide) {
        finding f;
        f.name = name;
        f.truth = detail::in_its_time(0.3, decide);
        if (claimed) {
            f.claimed = *claimed ? "true" : "false";
            f.judgement = *claimed ? *f.truth : negation(*f.truth);
        }
        certificate.findings.push_back(std::move(f));
    };
    if (s.file->coupling == tableaux::coupling::additive) {
        add("algebraically_stable", claims.algebraically_stable,
            [&] { return algebraically_stable_together(s); });
        if (s.stages() <= 16)
            add("ssp_coefficient", std::nullopt, [&] {
                const auto c = common_ssp_radius(s);
                return c.verdict.is_proved()
                           ? verdict::proved("common to all parts:" + c.statement + ", " + c.verdict.reason())
                           : c.verdict;
            });
        return;
    }
    std::optional<int> order;  // exactly that
    if constexpr (exact_scalar<K>)
        if (const auto* f = certificate.find("order"); f && !certificate.failures.empty()) order = f->value;
    add("symmetric", claims.symmetric, [&] { return symmetric_together(s, order); });
    if (s.nystrom())
        certificate.findings.push_back(detail::within_its_time(
            0.3, [&] { return oscillation_finding(s); },
            finding{"stability_interval", {}, {}, verdict::undecided(detail::out_of_its_time), {}, {}, {}}));
}

}  // namespace stagecraft::theory
