// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include <stagecraft/linear/mass.hpp>
#include <stagecraft/linear/mass_kernel.hpp>
#include <stagecraft/stages/newton.hpp>
#include <stagecraft/stages/together.hpp>
#include <stagecraft/work.hpp>

namespace stagecraft {

/// The end of a step that is no stage, for a singular M: M y1 is given, and the equations without a derivative hold at y1.
/// Solved for by Newton's iteration with M/h_0 - J, h_0 being so small (h/2^30) that the components stay which have a
/// derivative. One factorisation more than the stages take.
template <class Vector, class Blocks>
class constrained_end {
    using Scalar = typename Vector::Scalar;

  public:
    explicit constrained_end(int n) : f_(n), moved_(n), state_(n), constraints_(identity_mass{}) {}

    /// Finds the equations without a derivative, where M shows its entries; `solves`: there is an end to solve for.
    template <class System>
    void prepare(const System& system, bool solves) {
        if constexpr (has_entries<typename System::mass_type> && System::sums_type::complete)
            constraints_ = mass_kernel<Scalar>(system.mass().transposed(), system.size());
        if (solves && block_.empty()) block_.emplace_back(system.size());
    }
    const mass_kernel<Scalar>& constraints() const { return constraints_; }
    /// True if there is an end to solve for.
    bool exists() const { return !block_.empty(); }
    /// y1 of the last solve.
    const Vector& state() const { return state_; }

    template <class System>
    bool factor(const System& system, const Scalar& h) {
        for (auto& block : block_)
            if (!system.measure(work::factorisation,
                                [&] { return factor_together(system, block, shift(h)); }))
                return false;
        return true;
    }

    /// state() := y1 with M y1 = M `last` + `moved`, f(t1, y1) being zero in the equations without a derivative.
    template <class System, class Norm>
    newton_outcome<Scalar> solve(System& system, const Scalar& t1, const Scalar& h, const Vector& last,
                                 const Vector& moved, const Norm& norm, const newton_limits<Scalar>& limits,
                                 long& solves) {
        state_ = last;
        newton_monitor<Scalar> monitor(limits);
        while (monitor.may_go_on()) {
            system(t1, state_, f_);
            constraints_.project(f_);
            f_ += shift(h) * moved;
            moved_ = last - state_;
            add_mass_times(system.mass(), shift(h), moved_.data(), f_.data(), system.size());
            solve_block(system, f_);
            ++solves;
            state_ += f_;
            if (monitor.over(norm(f_))) break;
        }
        return monitor.outcome();
    }
    /// x := what an end moves by whose M y1 moves by x.
    template <class System>
    void follow(const System& system, const Scalar& h, Vector& x) {
        x *= shift(h);
        solve_block(system, x);
    }

  private:
    static Scalar shift(const Scalar& h) { return Scalar(1 << 30) / h; }
    template <class System>
    void solve_block(const System& system, Vector& x) {
        auto& block = block_.front();
        system.measure(work::solve, [&] { solve_together(system, block, [&] { block.solve(x.data()); }); });
    }

    Vector f_, moved_, state_;
    mass_kernel<Scalar> constraints_;
    std::vector<typename Blocks::real> block_;  // none, or one
};

}  // namespace stagecraft
