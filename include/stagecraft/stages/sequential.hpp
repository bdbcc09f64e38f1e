// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/linear/combinations.hpp>
#include <stagecraft/linear/dense_blocks.hpp>
#include <stagecraft/linear/lanes.hpp>
#include <stagecraft/linear/norms.hpp>
#include <stagecraft/stages/newton.hpp>
#include <stagecraft/stages/stage_slopes.hpp>
#include <stagecraft/stages/together.hpp>
#include <stagecraft/work.hpp>

namespace stagecraft {

/// What the stages of a method by itself have besides: nothing. (Of additive methods, slopes of another part of f:
/// stages/explicit_partner.hpp.)
struct no_partner {
    static constexpr bool exists = false;
    template <class Vector, class Scalar>
    static void add_known(int, const Scalar&, Vector&) {}
    static constexpr bool needs_slope(int) { return true; }
    template <class System, class Scalar, class Vector>
    static bool follow(System&, const Scalar&, const Scalar&, int, const Vector&) {
        return true;
    }
};

/// The stages of an explicit or diagonally implicit method, one after the other. A stage with a_ii = 0 costs
/// one evaluation of f (and a solve with M), an implicit one a simplified Newton iteration on z_i = Y_i - y
/// with the matrix M/(h a_ii) - J, which is factored once per distinct diagonal entry and (J, h): once for
/// SDIRK and ESDIRK methods. All storage is taken in the constructor.
template <class Vector, int Stages, class Blocks>
class sequential_stages {
    using Scalar = typename Vector::Scalar;
    static constexpr int N = Vector::RowsAtCompileTime;
    static constexpr bool unrolled = built_in<Scalar> && fits_lanes<N> && 0 < Stages && Stages <= 16;

  public:
    using slopes = stage_slopes<Vector, Stages, Blocks>;
    using vector = Vector;

    /// With `unused` true no block is made and no other member may be called.
    sequential_stages(const tableau<Scalar, Stages>& m, int n, bool unused)
        : n_(n), r_(n), z_(n), d_(n), yi_(n), fi_(n), last_(n) {
        if (unused) return;
        block_.reserve(static_cast<std::size_t>(m.stages()));
        for (int i = 0; i < m.stages(); ++i) {
            const Scalar a = m.A(i, i);
            int k = -1;
            if (!(a == Scalar(0))) {
                for (k = 0; k < static_cast<int>(diagonal_.size()) && !(diagonal_[k] == a);) ++k;
                if (k == static_cast<int>(diagonal_.size())) {
                    diagonal_.push_back(a);
                    blocks_.emplace_back(n);
                }
            }
            block_.push_back(k);
        }
        shift_.resize(diagonal_.size());
        if (!implicit()) {
            terms_.reserve(static_cast<std::size_t>(m.stages()) * static_cast<std::size_t>(m.stages()) / 2);
            row_ends_.reserve(static_cast<std::size_t>(m.stages()));
            for (int i = 0; i < m.stages(); ++i) {
                for (int j = 0; j < i; ++j)
                    if (!(m.A(i, j) == Scalar(0)))
                        terms_.push_back({m.A(i, j), static_cast<std::ptrdiff_t>(j) * n});
                row_ends_.push_back(terms_.size());
            }
        }
    }

    bool implicit() const { return !diagonal_.empty(); }
    /// Y_s of the last solve.
    const vector& last_stage() const { return implicit() ? last_ : yi_; }

    /// Factors M/(h a) - J for every distinct diagonal entry a; false if one is singular or not finite.
    template <class System>
    bool factor(const System& system, const Scalar& h) {
        return system.measure(work::factorisation, [&] {
            set_shifts(h);
            for (std::size_t k = 0; k < blocks_.size(); ++k) {
                if (!factor_together(system, blocks_[k], shift_[k])) return false;
            }
            return true;
        });
    }

    static constexpr bool knows_determinant = tells_determinant<typename Blocks::real>;
    /// Sign of det(M/(h a) - J) as last factored, a being the first non-zero diagonal entry.
    int determinant_sign() requires knows_determinant {
        return blocks_.front().negative_determinant() ? -1 : 1;
    }
    /// 1/(h a).
    Scalar growth_shift() const { return shift_.front(); }

    /// Computes the slopes with the current factors, which may be those of a step of nearly h; Z brings first
    /// guesses of z_i in its columns (if v.guessed) and takes the z_i of
    /// implicit stages. The outcome is that of the stage with the slowest iteration. `partner` adds what it knows to every
    /// stage, and takes the stage when it is known.
    template <class System, class Norm, class StageMatrix, class Partner = no_partner>
    newton_outcome<Scalar> solve(System& system, const Scalar& t, const vector& y, const Scalar& h,
                                 const Norm& norm, const newton_limits<Scalar>& limits, slopes& v,
                                 StageMatrix& Z, long& solves, Partner&& partner = {}) {
        const auto& m = v.method;
        const int s = m.stages();
        newton_outcome<Scalar> slowest{newton_end::converged, 1};
        if constexpr (built_in<Scalar> && !std::remove_cvref_t<Partner>::exists)
            if (!implicit() && !v.by_value) {
                if (!evaluate(system, t, y, h, norm.sums(), v)) slowest.end = newton_end::non_finite;
                return slowest;
            }
        set_shifts(h);
        for (int i = v.left_stage ? 1 : 0; i < s; ++i) {
            v.combine([&](int j) { return m.A(i, j); }, i, h, r_);
            partner.add_known(i, h, r_);
            if (block_[i] < 0) {
                yi_ = y + r_;
                if (partner.needs_slope(i)) {
                    system(t + m.c[i] * h, yi_, fi_);
                    v.mass.solve(fi_.data());
                    v.k.col(i) = fi_;
                }
                if (implicit()) Z.col(i) = r_;
                if ((partner.needs_slope(i) && !all_finite(fi_, n_, norm.sums())) ||
                    !partner.follow(system, t, h, i, yi_)) {
                    slowest.end = newton_end::non_finite;
                    return slowest;
                }
                if (i == s - 1) last_ = yi_;
                continue;
            }
            if (v.guessed) {
                z_ = Z.col(i);
            } else if (i > 0 && block_[i - 1] >= 0) {
                z_ = r_ + (h * m.A(i, i)) * v.k.col(i - 1);
            } else {
                z_.setZero();
            }
            const newton_outcome<Scalar> outcome =
                iterate(system, t, y, h, norm, limits, v, i, solves, partner);
            if (outcome.iterations > slowest.iterations) slowest.iterations = outcome.iterations;
            if (outcome.theta > slowest.theta) slowest.theta = outcome.theta;
            if (outcome.end != newton_end::converged) {
                slowest.end = outcome.end;
                return slowest;
            }
            Z.col(i) = z_;
            v.k.col(i) = shift_[block_[i]] * (z_ - r_);
            if constexpr (std::remove_cvref_t<Partner>::exists) {
                yi_ = y + z_;
                if (!partner.follow(system, t, h, i, yi_)) {
                    slowest.end = newton_end::non_finite;
                    return slowest;
                }
            }
            if (i == s - 1) last_ = y + z_;
        }
        return slowest;
    }

    /// x := (M/(h a) - J)^-1 x, a the first non-zero diagonal entry.
    template <class System>
    void solve_first(const System& system, vector& x) {
        system.measure(work::solve,
                       [&] { solve_together(system, blocks_[0], [&] { blocks_[0].solve(x.data()); }); });
    }
    /// x := (M - h a J)^-1 (M x + factor value): the filter of an embedded estimate. It leaves the estimate
    /// unchanged where h J is small and keeps it bounded where h J is large.
    template <class System>
    void filter(const System& system, vector& x, const vector& value, const Scalar& factor) {
        r_ = (shift_[0] * factor) * value;
        filter_with(system, x);
    }
    /// x := (M - h a J)^-1 M x.
    template <class System>
    void filter(const System& system, vector& x) {
        r_.setZero();
        filter_with(system, x);
    }
    /// x := x - (M - h a J)^-1 M x: the part of x in stiff components (small where h J is small).
    template <class System>
    void stiff_part(const System& system, vector& x) {
        d_ = x;
        filter(system, x);
        x = d_ - x;
    }

  private:
    void set_shifts(const Scalar& h) {
        for (std::size_t k = 0; k < diagonal_.size(); ++k) shift_[k] = Scalar(1) / (h * diagonal_[k]);
    }

    template <class System>
    void filter_with(const System& system, vector& x) {
        add_mass_times(system.mass(), shift_[0], x.data(), r_.data(), n_);
        solve_first(system, r_);
        x = r_;
    }

    /// The slopes of an explicit method. False if one is not finite.
    template <class System, class Sums>
    [[gnu::noinline]] bool evaluate(System& system, const Scalar& t, const vector& y, const Scalar& h,
                                    const Sums& sums, slopes& v) {
        const int n = N >= 0 ? N : n_, first = v.left_stage ? 1 : 0;
        if constexpr (unrolled && Sums::complete) {
            std::array<lanes<Scalar, N>, Stages> k;
            if (v.left_stage) k[0] = lanes<Scalar, N>::load(v.k.data());
            return [&]<int... i>(std::integer_sequence<int, i...>) {
                return (((i == 0 && v.left_stage) || this->template evaluate<i>(system, t, y, h, v, k)) &&
                        ...);
            }
            (std::make_integer_sequence<int, Stages>());
        } else {
            for (int i = first; i < v.method.stages(); ++i) {
                combine_onto(n, row(i), h, v.k.data(), y.data(), yi_.data());
                call(system, t + v.method.c[i] * h, yi_, fi_, v);
                Scalar* const k = v.k.data() + static_cast<std::ptrdiff_t>(i) * n;
                if (!copy_finite(fi_.data(), n, k, sums)) return false;
            }
        }
        return true;
    }
    /// Slope number i of few unknowns, k and all terms of its row in registers.
    template <int i, class System, class Slopes>
    [[gnu::always_inline]] bool evaluate(System& system, const Scalar& t, const vector& y, const Scalar& h,
                                         slopes& v, Slopes& k) {
        vector yi, fi;  // of their own: where f is inlined they stay in registers too
        sum_row<i>(y, h, v, k, std::make_integer_sequence<int, i>()).store(yi.data());
        call(system, t + v.method.c[i] * h, yi, fi, v);
        k[i] = k[i].load_written(fi.data());
        k[i].store(v.k.data() + i * N);
        if constexpr (i + 1 == Stages) yi_ = yi;
        return k[i].finite();
    }
    /// y + h sum_j a_ij k_j. To look for zeros would take as long as to add three numbers.
    template <int i, class Slopes, int... j>
    [[gnu::always_inline]] static auto sum_row(const vector& y, const Scalar& h, const slopes& v,
                                               const Slopes& k, std::integer_sequence<int, j...>) {
        auto sum = k[i].load(y.data());
        ((N < 4 || !(v.method.A(i, j) == Scalar(0)) ? sum.add(h * v.method.A(i, j), k[j]) : void()), ...);
        return sum;
    }
    /// f := M^-1 f(t, y).
    template <class System>
    [[gnu::always_inline]] static void call(System& system, const Scalar& t, const vector& y, vector& f,
                                            slopes& v) {
        system(t, y, f);
        if constexpr (!System::mass_type::identity) v.mass.solve(f.data());
    }
    /// The terms of row i of A, those that are not zero.
    std::span<const combination_term<Scalar>> row(int i) const {
        const std::size_t from = i > 0 ? row_ends_[i - 1] : 0;
        return {terms_.data() + from, row_ends_[i] - from};
    }
    template <class System, class Norm, class Partner>
    newton_outcome<Scalar> iterate(System& system, const Scalar& t, const vector& y, const Scalar& h,
                                   const Norm& norm, const newton_limits<Scalar>& limits, const slopes& v,
                                   int i, long& solves, [[maybe_unused]] const Partner& partner) {
        const int b = block_[i];
        newton_monitor<Scalar> monitor(limits);
        while (monitor.may_go_on()) {
            yi_ = y + z_;
            system(t + v.method.c[i] * h, yi_, fi_);
            d_ = r_ - z_;
            add_mass_times(system.mass(), shift_[b], d_.data(), fi_.data(), n_);
            if constexpr (std::remove_cvref_t<Partner>::exists)
                partner.take_carried(fi_);
            else if (v.by_value)
                fi_ -= v.carry[i] * v.left;
            Scalar residual(0);
            if constexpr (inexact_blocks<Blocks, Scalar>) residual = norm(fi_);
            system.measure(work::solve, [&] {
                solve_together(system, blocks_[b], [&] { blocks_[b].solve(fi_.data()); });
            });
            if constexpr (inexact_blocks<Blocks, Scalar>) {
                left_by_solvers<Scalar> left;
                left.add(blocks_[b]);
                left.tell(monitor, Scalar(0), residual, shift_[b]);
            }
            ++solves;
            z_ += fi_;
            if (monitor.over(norm(fi_))) break;
        }
        return monitor.outcome();
    }

    int n_;
    std::vector<combination_term<Scalar>> terms_;  // of the rows of an explicit A
    std::vector<std::size_t> row_ends_;            // where those of a row end
    std::vector<Scalar> diagonal_, shift_;         // distinct non-zero a_ii and 1/(h a_ii)
    std::vector<int> block_;                       // of each stage, -1 for an explicit one
    std::vector<typename Blocks::real> blocks_;
    vector r_, z_, d_, yi_, fi_, last_;
};

}  // namespace stagecraft
