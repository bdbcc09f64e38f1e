// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include <stagecraft/judge/guards/growth_bound.hpp>
#include <stagecraft/linear/combinations.hpp>
#include <stagecraft/linear/dense_blocks.hpp>
#include <stagecraft/linear/mass.hpp>
#include <stagecraft/linear/norms.hpp>
#include <stagecraft/linear/split_lu.hpp>

namespace stagecraft {

/// What is asked of the stages of a method: det(shift M - J) of the real system that was factored last, by its
/// sign, 0 where there is none, and its shift.
template <class Stages>
concept tells_growth = requires(Stages& stages) {
    requires Stages::knows_determinant;
    { stages.determinant_sign() } -> std::same_as<int>;
    stages.growth_shift();
};

/// Detects growth that a step would pass over. Let gamma be the real pole of R(z), or the real part of its
/// poles nearest the real axis. A mode y' = lambda y with h lambda > gamma is damped by the method although
/// the solution grows by e^gamma and more in this step, and no error estimate shows it while the mode is
/// smaller than the tolerance. But then a real eigenvalue of the pencil (J, M) lies beyond gamma/h, and each
/// such eigenvalue changes the sign of det(gamma/h M - J) relative to det M. The factorisation of a real
/// block gives the sign; without a real block (even s) a factorisation is made for it. With a singular M (and a
/// real block) the determinant at a shift beyond all such eigenvalues takes the place of det M: its sign is that
/// of det(g_z) with index 1, of det(g_y f_z) with index 2, and does not change while these are regular.
///
/// An even number of such eigenvalues, or complex ones, leave the sign as it is. They are looked for where M is
/// regular and a step would change nothing by more than the tolerance, in what still moves: f is multiplied
/// by powers of (a M - J)^-1 (a M + J), which has the eigenvalue (a + lambda)/(a - lambda) for each lambda of
/// the pencil and so amplifies what grows. Not detected: growth that moves less than something else does, with
/// a singular M what the sign does not show, and anything with banded or sparse matrices, with a linear solver
/// of the problem's own, or where parts of the state are on other processes.
///
/// Block solves the systems of that search: a real block of the stages where n is large, else any.
template <class Scalar, class Block = split_lu<Scalar, -1>>
class growth_watch {
  public:
    /// True if the stages, which have just been factored, show such growth beyond what rounding can explain, and it
    /// has something to begin with: slope() is f at the left end, asked for where there is a growing mode.
    template <class System, class Stages, class Slope>
    bool sees(const System& system, Stages& stages, Slope&& slope) {
        if constexpr (!System::structured && System::sums_type::complete && tells_growth<Stages>) {
            const Scalar shift = stages.growth_shift();
            if (shift == Scalar(0) || !has_growing_mode(system, shift, stages.determinant_sign(), {}))
                return false;
            const components resting = at_rest(system, slope());
            return resting.empty() || has_growing_mode(system, shift, unknown, resting);
        } else {
            return false;
        }
    }

    /// True if what moves at the left end, as f and `weights` (the inverses of the tolerances) show it, is nearer to
    /// rest than the tolerance and grows notably in a step h. Costs a product J f; where it is so near, the cost of
    /// proving that nothing grows (growth_bound), and where there is no proof up to three factorisations and 180 solves,
    /// a third where a step has been searched with the same Jacobian.
    template <class System, class Slope, class Vector>
    bool sees_in(const System& system, Slope&& slope, const Vector& weights, const Scalar& h) {
        if constexpr (!System::structured && System::sums_type::complete) {
            using std::abs;
            const int n = system.size();
            if (n > largest_size || mass_sign(system) == 0) return false;
            const Vector& f = slope();
            const Scalar size = size_of(f.data(), weights, n);
            if (!work_) work_ = std::make_unique<workplace>(n);
            if (!(size > Scalar(0)) || !is_near_rest(system, size, f.data(), weights, h)) return false;
            if (cannot_grow(system, h)) return false;
            Scalar a = Scalar(12) / h;  // shows h |lambda| from one to a hundred; then the next decades
            for (int k = 0; k < 3 && !(abs(a) >= searched_); ++k, a *= Scalar(25)) {
                if (!is_quiet(system, f, size, weights, h, a)) return false;
                if ((n > small || has_growth(system, a)) && amplifies(system, weights, a)) return true;
            }
            if (Scalar(12) / abs(h) < searched_) searched_ = Scalar(12) / abs(h);
            return false;
        } else {
            return false;
        }
    }

    /// What has been searched is of no use any more.
    void jacobian_changes() { searched_ = std::numeric_limits<Scalar>::max(); }
    /// What the next step depends on (checkpoint.hpp).
    template <class Bag>
    void carry(Bag& bag) {
        bag(searched_);
    }

  private:
    /// |J w| / |w| is the rate at which w changes, and |f| by that rate how far y is from where f = 0: less than the
    /// tolerance, and it changes within the step. (Asked of regular M other than the identity always.)
    template <class System, class Vector>
    [[gnu::cold]] bool is_near_rest(const System& system, const Scalar& size_of_f, const Scalar* w,
                                    const Vector& weights, const Scalar& h) {
        using std::abs;
        if constexpr (System::mass_type::identity) {
            const int n = system.size();
            Scalar* const change = work_->product.data();
            combine<false, -1>(n, n, w, system.jacobian().data(), change);
            const Scalar size = size_of(w, weights, n), changed = size_of(change, weights, n);
            return abs(h) * changed > size && changed > size * size_of_f;
        } else {
            return true;
        }
    }
    /// It is proved that nothing grows by more than e^{1/4} in a step h, where the search begins.
    template <class System>
    [[gnu::cold]] bool cannot_grow(const System& system, const Scalar& h) {
        using std::abs;
        if constexpr (System::mass_type::identity)
            return work_->bound.holds(system.jacobian().data(), system.size(), Scalar(h < Scalar(0) ? -1 : 1),
                                      Scalar(1) / (4 * abs(h)));
        else
            return false;
    }
    template <class Weights>
    static Scalar size_of(const Scalar* x, const Weights& weights, int n) {
        return weighted_norm(Eigen::Map<const Weights>(x, n), weights, n);
    }

    /// Leaves w := (a M - J)^-1 f in the workplace, and the factors: f / a with the fast components damped, which only reflect
    /// errors below the tolerance. So along a solution that moves
    /// w exceeds the tolerance, however small f over the rate of its fast components is: then nothing is looked for.
    template <class System, class Vector>
    [[gnu::cold]] bool is_quiet(const System& system, const Vector& f, const Scalar& size_of_f,
                                const Vector& weights, const Scalar& h, const Scalar& a) {
        const int n = system.size();
        Block& lu = work_->search_block(n);
        if (!factor_shifted(lu, system.mass(), system.jacobian(), a)) return false;
        Scalar* const w = work_->w.data();
        for (int i = 0; i < n; ++i) w[i] = f[i];
        lu.solve(w);
        return size_of(w, weights, n) <= Scalar(1) && is_near_rest(system, size_of_f, w, weights, h);
    }

    /// False if the matrix itself, raised to the power 2^10 by squaring, shows that nothing grows as much as `amplifies`
    /// asks, which is most often so: then its norm stays below any power of 5/2 that matters, also if it is far
    /// from normal, and often falls below 1.
    template <class System>
    [[gnu::cold]] bool has_growth(const System& system, const Scalar& a) {
        using std::abs;
        const int n = system.size();
        auto& power = work_->power;
        auto& square = work_->square;
        power.assign(static_cast<std::size_t>(n * n), Scalar(0));
        square.assign(power.size(), Scalar(0));
        for (int j = 0; j < n; ++j) {
            square[j] = Scalar(1);
            add_mass_times(system.mass(), Scalar(2 * a), square.data(), power.data() + j * n, n);
            square[j] = Scalar(0);
            work_->search_block(n).solve(power.data() + j * n);
            power[j + j * n] -= Scalar(1);
        }
        for (int k = 0; k < 10; ++k) {
            for (int j = 0; j < n; ++j)
                combine<false, -1>(n, n, power.data() + j * n, power.data(), square.data() + j * n);
            std::swap(power, square);
            Scalar norm{0};
            for (const Scalar& entry : power) norm += abs(entry);
            if (norm < Scalar(1)) return false;
            if (!(norm < Scalar(1e15))) return true;
        }
        return false;
    }

    /// Of 60 powers the last twenty amplify by more than they could without growth: an ellipse that is passed
    /// slowly by 3/2, a double zero as well. |(a + lambda)/(a - lambda)| is above (5/2)^(1/20) for real lambda
    /// between a/44 and 44 a, for lambda = |lambda| e^(i phi) with cos phi = 1/4 between |a|/11 and 11 |a|.
    template <class System, class Vector>
    [[gnu::cold]] bool amplifies(const System& system, const Vector& weights, const Scalar& a) {
        using std::log;
        const int n = system.size();
        Block& lu = work_->search_block(n);
        Scalar *const w = work_->w.data(), *const product = work_->product.data();
        Scalar level{0}, before{0}, highest = -std::numeric_limits<Scalar>::max();  // logarithms of sizes
        for (int power = 1; power <= 60; ++power) {
            for (int i = 0; i < n; ++i) product[i] = Scalar(0);
            add_mass_times(system.mass(), Scalar(2 * a), w, product, n);
            lu.solve(product);
            for (int i = 0; i < n; ++i) w[i] = product[i] - w[i];
            const Scalar size = size_of(w, weights, n);
            if (!(size > Scalar(0))) return false;
            for (int i = 0; i < n; ++i) w[i] /= size;
            level += log(size);
            if (level > highest) highest = level;
            if (power == 20 || power == 40) before = std::exchange(highest, level);
        }
        return highest > before + log(Scalar(5) / 2);
    }

    /// Empty, or for each component whether it is at rest for ever: f is zero there, and neither f nor M leads from the others
    /// to them (a species that is absent, say). What would grow in them alone has nothing to grow from.
    using components = std::vector<bool>;
    template <class System, class Vector>
    [[gnu::cold]] static components at_rest(const System& system, const Vector& f) {
        if constexpr (!has_entries<typename System::mass_type>) return {};
        const int n = system.size();
        components rest(static_cast<std::size_t>(n));
        for (int i = 0; i < n; ++i) rest[i] = f[i] == Scalar(0);
        bool changes = true;
        const auto leads = [&](int from, int to) {
            if (rest[to] && !rest[from]) rest[to] = false, changes = true;
        };
        while (changes) {
            changes = false;
            for (int from = 0; from < n; ++from)
                for (int to = 0; to < n; ++to)
                    if (!(system.jacobian().data()[to + from * n] == Scalar(0))) leads(from, to);
            if constexpr (!System::mass_type::identity && has_entries<typename System::mass_type>)
                for (const auto& e : system.mass().entries()) leads(e.column, e.row);
        }
        for (int i = 0; i < n; ++i)
            if (rest[i]) return rest;
        return {};
    }

    /// The sign of det(shift M - J) without what rests is not the one that it has without growing modes; `now`, that of
    /// the stages, or unknown, may say so at once. With a singular M that one, beyond all eigenvalues, is found once, and again where it disagrees: constraints may be
    /// switched.
    template <class System>
    bool has_growing_mode(const System& system, const Scalar& shift, int now, const components& resting) {
        if (mass_sign(system) != 0) {
            int expected = resting.empty() ? mass_sign_ : sign_of(system, Scalar(1), false, resting);
            if (shift < Scalar(0))
                for (int i = 0; i < system.size(); ++i)
                    if (resting.empty() || !resting[i]) expected = -expected;
            return now != expected && sign_of(system, shift, true, resting) == -expected;
        }
        if (now == 0 || (now == far_sign_ && resting.empty()) || shift < Scalar(0)) return false;
        const int beyond = sign_of(system, shift * far, true, resting);
        if (resting.empty()) far_sign_ = beyond;
        return beyond != 0 && now != beyond && sign_of(system, shift, true, resting) == -beyond;
    }

    /// The sign of det M, found once.
    template <class System>
    int mass_sign(const System& system) {
        if (mass_sign_ == unknown) mass_sign_ = sign_of(system, Scalar(1), false, {});
        return mass_sign_;
    }

    /// The sign of det(shift M - J), or of det(shift M) without J; 0 if a pivot is as small as what rounding
    /// makes of the column it stands in. Without the components that rest.
    template <class System>
    int sign_of(const System& system, const Scalar& shift, bool with_jacobian, const components& resting) {
        using std::abs;
        const int n = system.size();
        if constexpr (System::mass_type::identity)
            if (!with_jacobian) return 1;
        if (!work_) work_ = std::make_unique<workplace>(n);
        auto& lu = work_->matrix(n);
        Scalar* const largest = work_->largest.data();
        Scalar* a = lu.entries();
        for (int i = 0; i < n * n; ++i)
            a[i] = with_jacobian ? Scalar(-system.jacobian().data()[i]) : Scalar(0);
        add_mass(system.mass(), shift, a, n);
        for (int k = 0; k < n && !resting.empty(); ++k) {
            if (!resting[k]) continue;
            for (int i = 0; i < n; ++i) a[i + k * n] = a[k + i * n] = Scalar(i == k ? 1 : 0);
        }
        for (int j = 0; j < n; ++j) {
            largest[j] = Scalar(0);
            for (int i = 0; i < n; ++i)
                if (abs(a[i + j * n]) > largest[j]) largest[j] = abs(a[i + j * n]);
        }
        if (!lu.factor()) return 0;
        for (int k = 0; k < n; ++k)
            if (!(lu.pivot(k) > 1000 * std::numeric_limits<Scalar>::epsilon() * largest[k])) return 0;
        return lu.negative_determinant() ? -1 : 1;
    }

    struct workplace {
        std::vector<Scalar> w, product, largest;   // largest: entry of each column
        std::vector<Scalar> power, square;         // of matrices that are small
        std::unique_ptr<split_lu<Scalar, -1>> lu;  // which most runs do not need, and so is this:
        std::unique_ptr<Block> search;
        growth_bound<Scalar> bound;
        explicit workplace(int n)
            : w(static_cast<std::size_t>(n)),
              product(static_cast<std::size_t>(n)),
              largest(static_cast<std::size_t>(n)) {}
        split_lu<Scalar, -1>& matrix(int n) {
            if (!lu) lu = std::make_unique<split_lu<Scalar, -1>>(n);
            return *lu;
        }
        Block& search_block(int n) {
            if (!search) search = std::make_unique<Block>(n);
            return *search;
        }
    };
    static constexpr int unknown = 2;
    static constexpr int largest_size = 200;  // of systems in which powers cost less than a few steps
    static constexpr int small = 16;          // squares of matrices cost less than powers times a vector
    static constexpr int far = 1000;          // times the shift: of growth beyond that nothing is left to see
    int mass_sign_ = unknown, far_sign_ = unknown;
    Scalar searched_ =
        std::numeric_limits<Scalar>::max();  // from where on the Jacobian shows no growth in what moved
    std::unique_ptr<workplace> work_;        // made when it is needed first
};

}  // namespace stagecraft
