// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <stagecraft/linear/dense_blocks.hpp>
#include <stagecraft/linear/mass.hpp>

namespace stagecraft {

/// Solves M x = r for a regular mass matrix, which explicit stages need. The identity costs nothing, a
/// diagonal M one product per component; any other M is factored once per run, in the structure of the
/// Jacobian.
template <class Scalar, class Blocks>
class mass_solver {
  public:
    /// False if M is singular, or so nearly singular that solutions would be dominated by rounding. Where its
    /// entries, those of J or parts of the state are not here, that cannot be decided, and no M but the identity is
    /// taken to be regular.
    template <class System>
    bool prepare(const System& system) {
        if constexpr (!System::mass_type::identity && (!has_entries<typename System::mass_type> ||
                                                       System::opaque || !System::sums_type::complete)) {
            return false;
        } else if constexpr (!System::mass_type::identity) {
            const int n = system.size();
            bool diagonal = true;
            for (const auto& e : system.mass().entries()) diagonal = diagonal && e.row == e.column;
            if (diagonal) {
                reciprocal_.assign(static_cast<std::size_t>(n), Scalar(0));
                for (const auto& e : system.mass().entries()) reciprocal_[e.row] = Scalar(1) / e.value;
                return static_cast<int>(system.mass().entries().size()) == n;
            }
            size_ = n;
            block_.emplace(n);
            if constexpr (iterates) mass_.emplace(system.mass());
            return factor_shifted(*block_, system.mass(), system.zeros(), Scalar(1)) &&
                   well_conditioned(system);
        }
        return true;
    }

    /// x := M^-1 x, on n contiguous numbers.
    void solve(Scalar* x) {
        if constexpr (iterates) {
            if (block_) solve_again(x);
        } else if (block_) {
            block_->solve(x);
        }
        for (std::size_t i = 0; i < reciprocal_.size(); ++i) x[i] *= reciprocal_[i];
    }

  private:
    using block = typename unstructured<Blocks>::type::real;
    static constexpr bool iterates = inexact_blocks<typename unstructured<Blocks>::type, Scalar>;

    /// A block that iterates leaves a part of r, which no Newton iteration sees here: until only rounding is left, NaN where
    /// that does not come.
    void solve_again(Scalar* x) {
        using vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
        Eigen::Map<vector> sum(x, size_);
        vector rest = sum, part(size_);
        const Scalar whole = rest.norm();
        sum.setZero();
        Scalar left = whole, before = 4 * whole;
        while (2 * left <= before && left > std::numeric_limits<Scalar>::epsilon() * whole) {
            part = rest;
            block_->solve(part.data());
            sum += part;
            add_mass_times(*mass_, Scalar(-1), part.data(), rest.data(), size_);
            before = left;
            left = rest.norm();
        }
        if (!(left <= 1000 * std::numeric_limits<Scalar>::epsilon() * whole))
            sum.setConstant(std::numeric_limits<Scalar>::quiet_NaN());
    }

    /// What M^-1 makes of a vector without special direction, compared with what M makes of it at most.
    template <class System>
    bool well_conditioned(const System& system) {
        using std::abs;
        const int n = system.size();
        std::vector<Scalar> x(static_cast<std::size_t>(n)), rows(static_cast<std::size_t>(n), Scalar(0));
        for (int i = 0; i < n; ++i) x[i] = (i % 2 == 0 ? Scalar(1) : Scalar(-1)) + Scalar(i) / Scalar(2 * n);
        solve(x.data());
        Scalar largest(0), norm(0);
        for (const auto& e : system.mass().entries()) rows[e.row] += abs(e.value);
        for (int i = 0; i < n; ++i) {
            if (!(abs(x[i]) <= largest)) largest = abs(x[i]);
            if (rows[i] > norm) norm = rows[i];
        }
        return largest * norm * Scalar(n) * std::numeric_limits<Scalar>::epsilon() < Scalar(1);
    }

    std::vector<Scalar> reciprocal_;
    std::optional<block> block_;
    std::optional<entry_mass<Scalar>> mass_;  // where the block iterates
    int size_ = 0;
};

}  // namespace stagecraft
