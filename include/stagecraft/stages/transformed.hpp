// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <stagecraft/dense_output.hpp>
#include <stagecraft/linear/block_work.hpp>
#include <stagecraft/linear/combinations.hpp>
#include <stagecraft/linear/norms.hpp>
#include <stagecraft/stages/lane_blocks.hpp>
#include <stagecraft/stages/newton.hpp>
#include <stagecraft/stages/separate_blocks.hpp>
#include <stagecraft/tableau.hpp>
#include <stagecraft/work.hpp>

namespace stagecraft {

/// The stage equations sum_j (A^-1)_ij M z_j = h f(t + c_i h, y + z_i) of a method with regular A, solved by
/// simplified Newton in the variables W = (T^-1 (x) I) Z, where they fall into one real system per real
/// eigenvalue of A^-1 and one complex system per pair (Hairer-Wanner II.IV.8). Each block is factored once
/// per (J, h). All storage is taken in the constructor.
template <class Vector, int Stages, class Blocks>
class transformed_stages {
    using Scalar = typename Vector::Scalar;
    static constexpr int N = Vector::RowsAtCompileTime;
    static constexpr int positions = positions_of<Blocks>;
    // Dense problems of small fixed size, unless the problem brings a solver of its own.
    static constexpr bool dense = std::is_base_of_v<dense_blocks<Scalar, N>, Blocks>;
    static constexpr bool in_lanes =
        dense && dense_blocks<Scalar, N>::built_in && Stages > 1 && N >= 1 && N <= 16;
    using blocks_type = std::conditional_t<
        in_lanes,
        detail::lane_blocks<Scalar, in_lanes ? N : 1, in_lanes ? Stages : 1, in_lanes ? positions : 0>,
        separate_blocks<Scalar, Blocks>>;

  public:
    using vector = Vector;
    using tableau_type = transformed_tableau<Scalar, Stages>;
    /// solve() goes on from whatever is in Z: an iteration may be led from outside.
    static constexpr bool iterates_on_increments = true;

    [[gnu::cold]] transformed_stages(const tableau_type& method, int n)
        : method_(method),
          n_(n),
          W_(n, method.stages()),
          D_(n, method.stages()),
          F_(n, method.stages()),
          yi_(n),
          fi_(n),
          blocks_(n, static_cast<int>(method.gamma.size()), static_cast<int>(method.alpha.size())) {
        const int s = method.stages(), real = static_cast<int>(method.gamma.size());
        if (real + 2 * static_cast<int>(method.alpha.size()) != s ||
            method.beta.size() != method.alpha.size())
            throw std::invalid_argument("integrate: method must bring the s eigenvalues of A^-1");
        if (Stages > 0 && real != s % 2)
            throw std::invalid_argument(
                "integrate: method has several real eigenvalues; use run-time stages");
        T_ = make_workspace<Scalar, squared<Stages>>(s * s);
        T_inverse_ = T_;
        if (untransformed()) A_inverse_.resize(s * s);
        shift_ = make_workspace<Scalar, Stages>(s);
        if constexpr (blocks_type::inexact) {
            sizes_.of_block.resize(blocks_.count());
            sizes_.squares.resize(s + 1);
        }
        for (int i = 0; i < s; ++i)
            for (int j = 0; j < s; ++j) {
                T_[i * s + j] = method.T(i, j);
                T_inverse_[i * s + j] = method.T_inverse(i, j);
                if (untransformed()) A_inverse_[i * s + j] = method.A_inverse(i, j);
            }
    }

    const tableau_type& method() const { return method_; }
    int stages() const {
        if constexpr (Stages > 0)
            return Stages;
        else
            return method_.stages();
    }
    bool has_real_block() const { return method_.gamma.size() > 0; }

    /// Factors gamma_k/h M - J and (alpha_k - i beta_k)/h M - J; false if one of them is singular or not
    /// finite.
    template <class System>
    bool factor(const System& system, const Scalar& h) {
        set_shifts(h);
        return system.measure(work::factorisation, [&] { return blocks_.factor(system, shift_.data()); });
    }

    static constexpr bool knows_determinant = blocks_type::knows_determinant;
    /// Sign of det(gamma_1/h M - J) as last factored, 0 where A^-1 has no real eigenvalue.
    int determinant_sign() requires knows_determinant { return blocks_.determinant_sign(); }
    /// gamma_1/h, or alpha_1/h.
    Scalar growth_shift() const { return shift_[0]; }

    /// What a step and an iteration cost beyond what is the same for every method, without the linear systems; the constants
    /// here and below were fitted to measured times at n = 2, 3, 8 and 12, s = 3, 5 and 7.
    block_work<Scalar> work(int size) const {
        const Scalar s = Scalar(stages()), n = Scalar(size);
        return {20 + s * (10 + 2 * n), 20 + s * (15 + 3 * n) + s * s * n * 3 / 10};
    }
    /// What the linear systems cost: by their factors where these tell, else by size and structure. The blocks of small dense
    /// problems are solved side by side, so that their number hardly matters.
    template <class System>
    step_work<Scalar> linear_work(const System& system) const {
        if constexpr (in_lanes) {
            const Scalar m = Scalar(system.total_size()) - Scalar(positions);
            return {{m * m * m * 6 / 5, m * m * 4}, {}};
        } else if constexpr (requires { Blocks::work(1); }) {
            return {{}, Blocks::work(system.total_size())};
        } else {
            if constexpr (tells_work<blocks_type>) {
                const step_work<Scalar> known = blocks_.work();
                if (known.per_stage.iteration > Scalar(0)) return known;
            }
            return {{}, work_of<typename System::matrix>::template estimate<Scalar>(system.jacobian())};
        }
    }

    /// What factoring costs, in iterations, where the blocks know it since they were factored; else 0.
    template <class System>
    Scalar factorisation_cost(const System& system) const {
        if constexpr (tells_work<blocks_type>) {
            const block_work<Scalar> one = blocks_.work().per_stage;
            return one.step / (Scalar(15) + 3 * Scalar(system.total_size()) + one.iteration);
        } else {
            return Scalar(0);
        }
    }

    /// Solves for Z (in: first guess) with the current factors, which may be those of a step of nearly h.
    template <class System, class Norm, class StageMatrix>
    newton_outcome<Scalar> solve(System& system, const Scalar& t, const vector& y, const Scalar& h,
                                 const Norm& norm, const newton_limits<Scalar>& limits, StageMatrix& Z,
                                 long& solves) {
        const int s = stages();
        std::conditional_t<blocks_type::inexact, inexact_newton_monitor<Scalar>, newton_monitor<Scalar>>
            monitor(limits);
        set_shifts(h);
        if (!untransformed()) mix(T_inverse_.data(), Z.data(), W_.data());
        while (monitor.may_go_on()) {
            for (int i = 0; i < s; ++i) {
                yi_ = y + Z.col(i);
                system(t + method_.c[i] * h, yi_, fi_);
                D_.col(i) = fi_;
            }
            residual(system.mass(), Z, h);
            solve_blocks(system, norm, monitor);
            ++solves;
            if (monitor.over(add_increment(Z, norm.weights(), norm.sums()))) break;
        }
        return monitor.outcome();
    }

    /// x := (gamma_1/h M - J)^-1 x, or with the first complex block its modulus, component by component.
    template <class System>
    void filter(const System& system, vector& x, vector& scratch) {
        blocks_.filter(system, x, scratch);
    }

    /// re + i im := (gamma_1/h M - J)^-1 (re + i im), or with the first complex block; im stays zero of a real one.
    template <class System>
    void solve_first(const System& system, vector& re, vector& im) {
        system.measure(work::solve, [&] { blocks_.solve_first(system, re, im); });
    }

    /// x := x - (gamma/h M - J)^-1 gamma/h M x = -(gamma/h M - J)^-1 J x, the real part of it where gamma is
    /// complex: the part of x in stiff components. In a mode of eigenvalue lambda the factor is z / (z -
    /// gamma), z = h lambda: nearly one where z is large, O(h) where it is small.
    template <class System>
    void stiff_part(const System& system, vector& x, vector& re, vector& im) {
        re.setZero();
        im.setZero();
        add_mass_times(system.mass(), shift_[0], x.data(), re.data(), size());
        if (real_blocks() == 0) add_mass_times(system.mass(), shift_[1], x.data(), im.data(), size());
        solve_first(system, re, im);
        x -= re;
    }

  private:
    using matrix = Eigen::Matrix<Scalar, N, Stages>;
    // Sums over the stages are made in one pass each. (From ten stages on: see untransformed().)
    static constexpr bool fused = built_in<Scalar> && Stages > 0 && Stages <= 9;

    int size() const {
        if constexpr (N >= 0)
            return N;
        else
            return n_;
    }

    void set_shifts(const Scalar& h) {
        const Scalar inverse = Scalar(1) / h;
        const int real = real_blocks();
        for (int k = 0; k < real; ++k) shift_[k] = method_.gamma[k] * inverse;
        for (int k = 0; 2 * k < stages() - real; ++k) {
            shift_[real + 2 * k] = method_.alpha[k] * inverse;
            shift_[real + 2 * k + 1] = -method_.beta[k] * inverse;
        }
    }

    int real_blocks() const {
        if constexpr (Stages > 0)
            return Stages % 2;
        else
            return static_cast<int>(method_.gamma.size());
    }

    /// Column k of out := sum_j C_kj column j of in, C row by row.
    void mix(const Scalar* C, const Scalar* in, Scalar* out) const {
        const int n = size(), s = stages();
        for (int k = 0; k < s; ++k, C += s, out += n) combine<false, Stages>(n, s, C, in, out);
    }

    /// Solves in F; where that is by iteration, as exactly as the monitor asks for.
    template <class System, class Norm, class Monitor>
    void solve_blocks(const System& system, const Norm& norm, Monitor& monitor) {
        if constexpr (blocks_type::inexact) {
            if (blocks_.iterates()) {
                const Scalar residual = size_of_blocks(norm.weights(), norm.sums());
                const Scalar part = monitor.may_leave(residual);
                system.measure(work::solve,
                               [&] { blocks_.solve_leaving(system, F_.data(), part, sizes_.of_block); });
                blocks_.left().tell(monitor, part, residual, shift_[0]);
                return;
            }
        }
        system.measure(work::solve, [&] { blocks_.solve(system, F_.data()); });
    }

    /// W += F and Z += T F; returns the norm of what is added to Z. Where it is not finite, neither is Z.
    template <class StageMatrix, class Sums>
    Scalar add_increment(StageMatrix& Z, const vector& weights, const Sums& sums) {
        if constexpr (fused) {
            const Scalar sum =
                add_products<N, Stages>(size(), T_.data(), F_.data(), weights.data(), W_.data(), Z.data());
            if (Sums::complete && sum - sum == Scalar(0) && size() > 0)
                return std::sqrt(sum / (Scalar(size()) * Scalar(Stages)));
            mix(T_.data(), F_.data(), D_.data());
        } else {
            W_ += F_;
            mix(T_.data(), F_.data(), D_.data());
            for (int i = 0; i < stages(); ++i) Z.col(i) += D_.col(i);
        }
        return norm(D_, weights, sums);
    }

    /// From ten stages on T is so ill-conditioned (twenty: no digit of double is left in T^-1 T) that W and Z
    /// would drift apart and the iteration converge to a wrong solution. The residual is then taken of Z
    /// itself, and T only has to be good enough for contraction.
    bool untransformed() const { return stages() > 9; }

    /// F := T^-1 (f(Y) - (A^-1/h) M Z), with f(Y) in D; A^-1 Z = T Lambda W.
    template <class Mass, class StageMatrix>
    void residual(const Mass& mass, const StageMatrix& Z, const Scalar& h) {
        if constexpr (Stages < 0 || Stages > 9) {
            if (untransformed()) {
                const int n = size(), s = stages();
                mix(A_inverse_.data(), Z.data(), W_.data());
                for (int i = 0; i < s; ++i)
                    add_mass_times(mass, Scalar(Scalar(-1) / h), W_.data() + i * n, D_.data() + i * n, n);
                mix(T_inverse_.data(), D_.data(), F_.data());
                return;
            }
        }
        const int n = size();
        const int real = real_blocks();
        if constexpr (fused && Mass::identity) {
            for (int k = 0; k < real; ++k) residual_of<1>(k, k, {-shift_[k]});
            for (int k = real; k < Stages; k += 2) {
                const Scalar a = -shift_[k], b = shift_[k + 1];
                residual_of<2>(k, k, {a, b});
                residual_of<2>(k + 1, k, {-b, a});
            }
            return;
        }
        mix(T_inverse_.data(), D_.data(), F_.data());
        for (int k = 0; k < real; ++k)
            add_mass_times(mass, Scalar(-shift_[k]), W_.data() + k * n, F_.data() + k * n, n);
        for (int k = real; k < stages(); k += 2) {
            const Scalar a = -shift_[k], b = shift_[k + 1];
            const Scalar *w = W_.data() + k * n, *v = w + n;
            Scalar *f = F_.data() + k * n, *g = f + n;
            add_mass_times(mass, a, w, f, n);
            add_mass_times(mass, b, v, f, n);
            add_mass_times(mass, Scalar(-b), w, g, n);
            add_mass_times(mass, a, v, g, n);
        }
    }

    /// Column k of F, M being the identity: of T^-1 f(Y), and of W the columns from `first` with these factors.
    template <std::size_t Terms>
    void residual_of(int k, int first, const std::array<Scalar, Terms>& factors) {
        constexpr int all = Stages + static_cast<int>(Terms);
        const int n = size();
        std::array<Scalar, all> c;
        std::copy_n(T_inverse_.data() + k * Stages, Stages, c.data());
        std::copy_n(factors.data(), Terms, c.data() + Stages);
        const auto from = [&](int j) {
            return j < Stages ? D_.data() + j * n : W_.data() + (first + j - Stages) * n;
        };
        combine_from<N>(n, c.data(), from, F_.data() + k * n, std::make_integer_sequence<int, all>());
    }

    template <class Sums>
    Scalar norm(const matrix& x, const vector& weights, const Sums& sums) const {
        using std::sqrt;
        const int s = stages();
        Scalar n = Scalar(size()), sum = weighted_squares<Stages>(size(), s, x.data(), weights.data());
        if constexpr (!Sums::complete) {
            Scalar part[2] = {sum, n};
            sums(part, 2);
            sum = part[0];
            n = part[1];
        }
        if (!(sum - sum == Scalar(0))) {  // the squares may have overflowed where the products have not
            Scalar largest = Scalar(0);
            for (int j = 0; j < s; ++j) {
                const Scalar one = weighted_norm(x.col(j), weights, size(), sums);
                if (!(one <= largest)) largest = one;
            }
            return largest;
        }
        return n == Scalar(0) ? Scalar(0) : Scalar(sqrt(sum / (n * Scalar(s))));
    }

    /// How large the right-hand side of each block in F is, by what T makes of it, into sizes_; returns the norm of F.
    template <class Sums>
    Scalar size_of_blocks(const vector& weights, const Sums& sums) {
        using std::sqrt;
        const int s = stages(), real = real_blocks();
        auto& [of_block, squares] = sizes_;
        Scalar whole(0);
        for (int k = 0; k < s; ++k)
            squares[k] = weighted_squares<1>(size(), 1, F_.data() + k * size(), weights.data());
        squares[s] = Scalar(size());
        sums(squares.data(), s + 1);
        for (auto& size : of_block) size = Scalar(0);
        for (int k = 0; k < s; ++k) {
            Scalar of_T(0);
            for (int i = 0; i < s; ++i) of_T += T_[i * s + k] * T_[i * s + k];
            whole += squares[k];
            of_block[k < real ? k : real + (k - real) / 2] += of_T * squares[k];
        }
        for (auto& size : of_block) size = sqrt(size);
        return sqrt(whole / (squares[s] * Scalar(s)));
    }

    tableau_type method_;
    workspace<Scalar, squared<Stages>> T_, T_inverse_;  // row by row
    std::vector<Scalar> A_inverse_;                     // likewise, where it is used
    workspace<Scalar, Stages> shift_;                   // gamma/h, then alpha/h and -beta/h pair by pair
    int n_;
    matrix W_, D_, F_;
    vector yi_, fi_;
    blocks_type blocks_;
    struct no_sizes {};
    struct right_hand_sides {
        std::vector<Scalar> of_block, squares;  // the latter of the columns of F
    };
    [[no_unique_address]] std::conditional_t<blocks_type::inexact, right_hand_sides, no_sizes> sizes_;
};

}  // namespace stagecraft
