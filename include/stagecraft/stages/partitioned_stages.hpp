// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <vector>

#include <stagecraft/linear/dense_blocks.hpp>
#include <stagecraft/stages/coupled_systems.hpp>
#include <stagecraft/stages/newton.hpp>

namespace stagecraft {

/// One evaluation in a step of a separable system with explicit stages: of f(t, P_i) (`of_q`) or g(t, Q_i). Where
/// `from` >= 0 it is that of stage `from`, which has the same argument, and nothing is evaluated.
struct part_evaluation {
    bool of_q = false;
    int stage = 0, from = -1;
};

/// The order in which explicit stages of a separable system are evaluated, empty where they depend on each other in a
/// circle: k_j = f(t + c^_j h, p + h sum_m a^_jm l_m), l_i = g(t + c_i h, q + h sum_j a_ij k_j). Stages that nothing
/// uses are left out.
template <class Tableau>
std::vector<part_evaluation> explicit_order(const Tableau& first, const Tableau& second) {
    using scalar = typename Tableau::scalar;
    const int s = first.stages();
    const scalar zero(0);
    // Of q: k_i, made by the second tableau's row i, used in the first's column i.
    const auto row = [&](bool of_q, int i) -> auto{ return (of_q ? second : first).A.row(i); };
    const auto used = [&](bool of_q, int i) {
        const Tableau& in = of_q ? first : second;
        bool any = !(in.b[i] == zero) || (in.b_embedded.size() > 0 && !(in.b_embedded[i] == zero));
        for (int j = 0; j < s; ++j) any = any || !(in.A(j, i) == zero);
        return any;
    };
    std::vector<part_evaluation> order;
    std::vector<char> done[2] = {std::vector<char>(s), std::vector<char>(s)};  // by of_q
    for (int round = 0; round < 2 * s; ++round)
        for (const bool of_q : {true, false})
            for (int i = 0; i < s; ++i) {
                if (done[of_q][i] || !used(of_q, i)) continue;
                bool ready = true;
                for (int j = 0; j < s; ++j) ready = ready && (row(of_q, i)[j] == zero || done[!of_q][j]);
                if (!ready) continue;
                part_evaluation next{of_q, i, -1};
                for (const part_evaluation& before : order)
                    if (before.of_q == of_q && before.from < 0 && row(of_q, before.stage) == row(of_q, i))
                        next.from = before.stage;
                order.push_back(next);
                done[of_q][i] = 1;
            }
    for (const bool of_q : {true, false})
        for (int i = 0; i < s; ++i)
            if (used(of_q, i) && !done[of_q][i]) return {};
    return order;
}

/// Every stage uses slopes of stages before it alone.
template <class Tableau>
bool strictly_lower(const Tableau& m) {
    for (int i = 0; i < m.stages(); ++i)
        for (int j = i; j < m.stages(); ++j)
            if (!(m.A(i, j) == typename Tableau::scalar(0))) return false;
    return true;
}

/// The linear systems of the simplified Newton iteration for both parts of all stages: block (i, j) is
/// delta_ij I - h J diag(a_ij I, a^_ij I), of size n each, q in the first half. One dense LU of size n s.
template <class Scalar>
class partitioned_systems {
  public:
    partitioned_systems(int stages, int n) : n_(n), s_(stages), lu_(0) {}

    /// False if it is singular or not finite.
    template <class System, class Tableau>
    bool factor(const System& system, const Scalar& h, const Tableau& first, const Tableau& second) {
        const int m = s_ * n_;
        if (!taken_) lu_ = dense(m), taken_ = true;
        Scalar* e = lu_.entries();
        for (int i = 0; i < m * m; ++i) e[i] = Scalar(0);
        for (int j = 0; j < s_; ++j)
            for (int i = 0; i < s_; ++i)
                detail::for_each_entry(system.jacobian(), [&](int r, int c, const Scalar& value) {
                    e[i * n_ + r + (j * n_ + c) * m] -= h * (2 * c < n_ ? first : second).A(i, j) * value;
                });
        for (int i = 0; i < m; ++i) e[i * (m + 1)] += Scalar(1);
        return lu_.factor();
    }
    void solve(Scalar* x) { lu_.solve(x); }

  private:
    using dense = typename dense_blocks<Scalar, Eigen::Dynamic>::real;
    int n_, s_;
    bool taken_ = false;
    dense lu_;
};

/// Symplectic pairs keep invariants as well as their stage equations are solved: whatever the tolerance, the iteration of
/// equal steps ends where its increments are rounding (Hairer-Lubich-Wanner VIII.6.2).
template <class Scalar>
newton_limits<Scalar> down_to_rounding(newton_limits<Scalar> limits) {
    limits.factor = limits.floor;
    limits.affine = false;
    return limits;
}

}  // namespace stagecraft
