// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <vector>

#include <stagecraft/tableau.hpp>

namespace stagecraft {

/// c^{k-1}, entry by entry, for k = 1, 2, ...: what Butcher's simplifying assumptions are written in.
template <class Scalar>
class node_power {
  public:
    explicit node_power(int stages) : values_(static_cast<std::size_t>(stages), Scalar(1)) {}
    int k() const { return k_; }
    const Scalar& operator[](int i) const { return values_[static_cast<std::size_t>(i)]; }
    /// To the next k; O(s).
    template <class Nodes>
    void advance(const Nodes& c) {
        ++k_;
        for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = values_[i] * c[static_cast<int>(i)];
    }

  private:
    std::vector<Scalar> values_;
    int k_ = 1;
};

// B(k), C(k) and D(k) of Hairer-Wanner II, section IV.5. `equal(left, right)` decides whether both sides of
// one equation agree: to rounding, exactly, or by enclosures; it may as well keep what it is shown, so every
// row is asked even after one has failed.

/// B(k): k sum_i b_i c_i^{k-1} = 1.
template <class Scalar, int Stages, class Equal>
bool satisfies_quadrature(const tableau<Scalar, Stages>& m, const node_power<Scalar>& power, Equal&& equal) {
    Scalar sum = Scalar(0);
    for (int i = 0; i < m.stages(); ++i) sum = sum + m.b[i] * power[i];
    return equal(Scalar(sum * Scalar(power.k())), Scalar(1));
}

/// C(k): k sum_j a_ij c_j^{k-1} = c_i^k for every i. O(s^2).
template <class Scalar, int Stages, class Equal>
bool satisfies_stages(const tableau<Scalar, Stages>& m, const node_power<Scalar>& power, Equal&& equal) {
    bool all = true;
    for (int i = 0; i < m.stages(); ++i) {
        Scalar sum = Scalar(0);
        for (int j = 0; j < m.stages(); ++j) sum = sum + m.A(i, j) * power[j];
        all = equal(Scalar(sum * Scalar(power.k())), Scalar(power[i] * m.c[i])) && all;
    }
    return all;
}

/// D(k): k sum_i b_i c_i^{k-1} a_ij = b_j (1 - c_j^k) for every j. O(s^2).
template <class Scalar, int Stages, class Equal>
bool satisfies_adjoint(const tableau<Scalar, Stages>& m, const node_power<Scalar>& power, Equal&& equal) {
    bool all = true;
    for (int j = 0; j < m.stages(); ++j) {
        Scalar sum = Scalar(0);
        for (int i = 0; i < m.stages(); ++i) sum = sum + m.b[i] * power[i] * m.A(i, j);
        const Scalar right = m.b[j] * (Scalar(1) - power[j] * m.c[j]);
        all = equal(Scalar(sum * Scalar(power.k())), right) && all;
    }
    return all;
}

/// The largest B(p), C(q), D(r) that hold (Butcher 1964; Hairer-Wanner II, section IV.5), each up to the
/// number searched for: for s = 1 and c = 1, say, D(r) holds for every r.
struct simplifying_orders {
    int B = 0;
    int C = 0;
    int D = 0;

    /// Butcher's bound of the order, min(B, C + D + 1, 2 C + 2) (Hairer-Wanner II, Theorem IV.5.1). Needs
    /// C >= 1: where row sums differ from c only B(1) counts.
    int order() const { return C == 0 ? std::min(B, 1) : std::min({B, C + D + 1, 2 * C + 2}); }
    friend bool operator==(const simplifying_orders&, const simplifying_orders&) = default;
};

/// The largest B, C and D, each at most 2 s + 1. At most O(s^3): B <= 2 s, and C <= s for distinct nodes.
template <class Scalar, int Stages, class Equal>
simplifying_orders simplifying_orders_of(const tableau<Scalar, Stages>& m, Equal equal) {
    const int limit = 2 * m.stages() + 1;
    simplifying_orders found{limit, limit, limit};
    node_power<Scalar> power(m.stages());
    for (int k = 1; k <= limit; ++k, power.advance(m.c)) {
        if (found.B == limit && !satisfies_quadrature(m, power, equal)) found.B = k - 1;
        if (found.C == limit && !satisfies_stages(m, power, equal)) found.C = k - 1;
        if (found.D == limit && !satisfies_adjoint(m, power, equal)) found.D = k - 1;
        if (std::max({found.B, found.C, found.D}) < limit) break;
    }
    return found;
}

}  // namespace stagecraft
