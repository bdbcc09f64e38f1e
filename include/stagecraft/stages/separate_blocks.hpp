// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

#include <stagecraft/linear/dense_blocks.hpp>
#include <stagecraft/stages/sparse_pairs.hpp>
#include <stagecraft/stages/together.hpp>

namespace stagecraft {

/// The real and complex systems of a step, each with a solver of its own, in the order of the shifts: gamma/h
/// for each real one, then alpha/h and -beta/h for each complex one.
template <class Scalar, class Blocks>
class separate_blocks {
  public:
    separate_blocks(int n, int real, int complex) : n_(n), pairs_(real, complex) {
        real_.reserve(static_cast<std::size_t>(real));
        complex_.reserve(static_cast<std::size_t>(complex));
        for (int k = 0; k < real; ++k) real_.emplace_back(n);
        for (int k = 0; k < complex; ++k) complex_.emplace_back(n);
    }

    /// Factors shift M - J for every shift; false if one is singular or not finite.
    template <class System>
    bool factor(const System& system, const Scalar* shift) {
        if constexpr (may_be_sparse && System::mass_type::identity) {
            if (pairs_.factor(system.jacobian(), shift)) return true;
            for (auto& block : real_) block.ignore_zeros();
            for (auto& block : complex_) block.ignore_zeros();
        }
        if constexpr (factors_all<Blocks, typename System::mass_type, typename System::matrix, Scalar>)
            return Blocks::factor_all(real_, complex_, system.mass(), system.jacobian(), shift);
        else
            return factor_each(system, shift);
    }

    int count() const { return static_cast<int>(real_.size() + complex_.size()); }
    static constexpr bool inexact = inexact_blocks<Blocks, Scalar>;
    /// Solvers that may iterate say whether they do, as long as the factors are the same.
    bool iterates() const {
        if constexpr (may_iterate<typename Blocks::complex>)
            return std::any_of(complex_.begin(), complex_.end(), [](const auto& b) { return b.iterates(); });
        else
            return inexact;
    }
    /// What their last solves have left.
    left_by_solvers<Scalar> left() const {
        left_by_solvers<Scalar> all;
        for (const auto& block : real_) all.add(block);
        for (const auto& block : complex_) all.add(block);
        return all;
    }
    /// Solves in place; the right-hand sides follow each other as the shifts do, n numbers each.
    template <class System>
    void solve(const System& system, Scalar* x) {
        if constexpr (may_be_sparse)
            if (pairs_.factored()) return pairs_.solve(x);
        if constexpr (solves_all<Blocks, Scalar>) return Blocks::solve_all(real_, complex_, x, n_);
        each(system, x, [](auto& block, auto*... parts) { block.solve(parts...); });
    }
    /// The same, where the largest right-hand side may be solved up to `part` of it (0: as usual), and each other one up
    /// to as much, a quarter of its own at most; sizes[k] is what that of block k counts for. As usual: a tenth at most.
    /// Small right-hand sides get the tight bound too: otherwise their residuals dominate the next iteration.
    template <class System>
    void solve_leaving(const System& system, Scalar* x, const Scalar& part,
                       const std::vector<Scalar>& sizes) requires inexact {
        const Scalar largest = *std::max_element(sizes.begin(), sizes.end()),
                     most = Scalar(1) / (part == Scalar(0) ? 10 : 4);
        auto size = sizes.begin();
        each(system, x, [&](auto& block, auto*... parts) {
            Scalar own = part;
            if constexpr (tells_usual_part<std::remove_reference_t<decltype(block)>>)
                if (part == Scalar(0)) own = Scalar(block.usual_part());
            own *= largest / *size++;
            block.solve_leaving(own < most ? own : most, parts...);
        });
    }

    /// Solves with the first block alone: the real one (y is not touched), else the first complex one for x
    /// + i y.
    template <class System, class Vector>
    void solve_first(const System& system, Vector& x, Vector& y) {
        if constexpr (may_be_sparse)
            if (pairs_.factored()) return pairs_.solve_first(x.data(), y.data());
        if (!real_.empty())
            solve_together(system, real_.front(), [&] { real_.front().solve(x.data()); });
        else
            solve_together(system, complex_.front(), [&] { complex_.front().solve(x.data(), y.data()); });
    }

    /// x := (gamma_1/h M - J)^-1 x, or with the first complex block its modulus, component by component.
    template <class System, class Vector>
    void filter(const System& system, Vector& x, Vector& scratch) {
        scratch.setZero();
        solve_first(system, x, scratch);
        if (real_.empty()) {
            for (int i = 0; i < n_; ++i) x[i] = modulus(x[i], scratch[i]);
        }
    }

    /// What the systems of a step cost, as one of them knows since it was factored; zeros before.
    auto work() const requires tells_work<typename Blocks::complex> {
        return complex_.empty() ? real_.front().work() : complex_.front().work();
    }

    static constexpr bool knows_determinant = tells_determinant<typename Blocks::real>;
    /// Sign of det(gamma_1/h M - J), 0 where no eigenvalue of A^-1 is real.
    int determinant_sign() requires knows_determinant {
        if constexpr (may_be_sparse)
            if (pairs_.factored() && !real_.empty()) return pairs_.negative_determinant() ? -1 : 1;
        return real_.empty() ? 0 : real_.front().negative_determinant() ? -1 : 1;
    }

  private:
    template <class System>
    bool factor_each(const System& system, const Scalar* shift) {
        for (auto& block : real_)
            if (!factor_together(system, block, *shift++)) return false;
        for (auto& block : complex_) {
            if (!factor_together(system, block, shift[0], shift[1])) return false;
            shift += 2;
        }
        return true;
    }
    template <class System, class Solve>
    void each(const System& system, Scalar* x, Solve&& solve) {
        for (auto& block : real_) {
            solve_together(system, block, [&] { solve(block, x); });
            x += n_;
        }
        for (auto& block : complex_) {
            solve_together(system, block, [&] { solve(block, x, x + n_); });
            x += 2 * n_;
        }
    }

    // Dense blocks that look for zeros, as those of small fixed size do not.
    static constexpr bool may_be_sparse = std::is_same_v<typename Blocks::real, dense_lu<Scalar>>;

    int n_;
    std::vector<typename Blocks::real> real_;
    std::vector<typename Blocks::complex> complex_;
    [[no_unique_address]] std::conditional_t<may_be_sparse, sparse_pairs<Scalar>, no_sparse_pairs> pairs_;
};

}  // namespace stagecraft
