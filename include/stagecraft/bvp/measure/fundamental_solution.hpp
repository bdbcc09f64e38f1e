// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/bvp/equations/lifting_elimination.hpp>
#include <stagecraft/bvp/equations/lifting_rule.hpp>
#include <stagecraft/bvp/judge/kernel_judge.hpp>
#include <stagecraft/bvp/measure/conditioning.hpp>
#include <stagecraft/bvp/measure/missed_phase.hpp>
#include <stagecraft/bvp/measure/modes.hpp>

namespace stagecraft::detail {

/// The fundamental solution u of the linearised problem that answers most to a condition, and how errors change it: numbers
/// by which judge/regularity_judge.hpp says whether M is regular. All are relative to the sizes of the components, whatever
/// their units are.
template <class Equations>
class fundamental_solution {
  public:
    using iterate = typename Equations::iterate;
    using scalar = std::decay_t<decltype(iterate{}.t[0])>;
    using wide = typename Equations::wide;
    using column = typename Equations::column;
    using parameters = typename Equations::parameters;
    using rule = typename Equations::rule;
    static constexpr int N = wide::RowsAtCompileTime;
    /// Local errors that change u by less than this part are small.
    static constexpr double small_part = 0.1;

    /// Values below `threshold` count as if they were of that size.
    fundamental_solution(Equations& equations, conditioning_of<Equations>& conditioning, const iterate& x,
                         lifting_elimination<Equations>& elimination, const scalar& threshold)
        : equations_(equations),
          conditioning_(conditioning),
          x_(x),
          elimination_(elimination),
          rule_(elimination.lifting()),
          threshold_(threshold) {}

    /// Its size where the terms of its condition are 1: about 1/|M|.
    scalar answer() {
        choose();
        return answer_;
    }
    /// The relative change of u if y and p change by `error`, with a sign of its own in each eighth of the interval.
    scalar change(const scalar& error) {
        choose();
        return of_other(error);
    }
    /// A bound of mesh_error(), at the cost of no solve; infinity where h f_y changes much in an interval.
    scalar error_bound() { return answer() * local_bound(); }

    /// The relative change of u by its local errors; 1 if these are not small (not resolved).
    struct part {
        scalar size;
        bool resolved;
    };
    part mesh_error() {
        choose();
        iterate e;
        const bool resolved = answer_to_mesh(e);
        return {resolved ? share(e.y, e.p) : scalar(1), resolved};
    }
    /// The spectral radius of |E| for the modes that answer much, E being the answers of the modes to the errors of this mesh,
    /// in units of their conditions: 1 + E is regular if it is below one. The error of a large mode in one that answers little is large in
    /// these units, and none the less takes nothing to zero. Infinity where one that turns is not resolved.
    scalar kernel_radius(bool turns) {
        choose();
        const modes_of<Equations> modes(equations_, conditioning_, x_, scale_, threshold_);
        const kernel_judge<scalar> judge{scalar(0), modes.largest(), true, turns};
        std::vector<int> taken;
        std::vector<typename modes_of<Equations>::column> made;
        scalar radius(0);
        for (int k = 0; k < modes.count(); ++k) {
            iterate e;
            if (!judge.may_vanish(modes.size(k))) continue;
            take(modes, k);
            if (answer_to_mesh(e))
                taken.push_back(k), made.push_back(modes.conditions(e.y, e.p).cwiseAbs());
            else if (turns)
                radius = std::numeric_limits<scalar>::infinity();  // whatever the others say
        }
        chosen_ = false;
        return radius > scalar(0) || taken.empty() ? radius : spectral_radius(taken, made);
    }
    /// How many modes M may take to zero, for all that the mesh shows.
    kernel_found kernel(bool linear) {
        choose();
        const scalar phase = missed_phase(equations_, x_, rule_.order);
        const modes_of<Equations> modes(equations_, conditioning_, x_, scale_, threshold_);
        const kernel_judge<scalar> judge{std::numeric_limits<scalar>::epsilon(), modes.largest(), linear,
                                         phase > scalar(regularity_judge<scalar>::visible_phase)};
        kernel_found found{0, !judge.turns};
        for (int k = 0; k < modes.count(); ++k) {
            if (!judge.may_vanish(modes.size(k))) continue;
            take(modes, k);
            parameters shift(equations_.np());
            const wide e = answer_to_rounding(u_.cwiseAbs(), p_.cwiseAbs(), shift);
            iterate of_mesh;
            const bool lost = judge.lost(modes.size(k), modes.conditions(e, shift).norm());
            judge.count(lost || !answer_to_mesh(of_mesh)
                            ? scalar(1)
                            : scalar(modes.conditions(of_mesh.y, of_mesh.p).norm()),
                        found);
        }
        chosen_ = false;
        return found;
    }

    /// The relative change of u by one rounding error in every entry.
    scalar rounding() {
        choose();
        parameters shift(equations_.np());
        const wide e = answer_to_rounding(u_.cwiseAbs(), p_.cwiseAbs(), shift);
        return share(e, shift);
    }

    /// The least size of u at a mesh point over the largest: tiny where it grows from one end to the other. 1 where u is most of
    /// all a change of p: where nothing fixes an unknown parameter, y may say nothing of it.
    scalar contrast() {
        using std::abs;
        choose();
        scalar most(0), least = std::numeric_limits<scalar>::infinity();
        for (int i = 0; i <= x_.intervals(); ++i) {
            scalar size(0);
            for (int c = 0; c < equations_.n(); ++c) size = std::max(size, scalar(abs(u_(c, i)) / scale_[c]));
            most = std::max(most, size), least = std::min(least, size);
        }
        for (Eigen::Index k = 0; k < p_.size(); ++k)
            if (abs(p_[k]) > (threshold_ + abs(x_.p[k])) * most) return scalar(1);
        return least / most;
    }

    /// The change of y by one rounding error in every entry, relative to threshold + |y|. Values far below that count as if they
    /// were as large as they are elsewhere, at most that: that they are small may be a rounding error itself.
    scalar rounding_of_y() {
        using std::abs;
        wide size = x_.y.cwiseAbs();
        for (int c = 0; c < equations_.n(); ++c) {
            const scalar least = std::min(scalar(size.row(c).maxCoeff()), threshold_);
            for (int i = 0; i <= x_.intervals(); ++i) size(c, i) = std::max(size(c, i), least);
        }
        parameters shift(equations_.np());
        const wide e = answer_to_rounding(size, x_.p.cwiseAbs(), shift);
        scalar worst(0);
        for (int i = 0; i <= x_.intervals(); ++i)
            for (int c = 0; c < equations_.n(); ++c)
                worst = std::max(worst, scalar(abs(e(c, i)) / (threshold_ + abs(x_.y(c, i)))));
        return worst;
    }

    /// Do f or r depend on y or p nonlinearly? `size` is that of y.
    bool nonlinear(const scalar& size) {
        iterate other = x_;
        for (Eigen::Index i = 0; i < other.y.cols(); ++i)
            for (Eigen::Index c = 0; c < other.y.rows(); ++c)
                other.y(c, i) += size * scalar(static_cast<int>(1 + (7 * i + 3 * c) % 5)) / 100;
        for (Eigen::Index k = 0; k < other.p.size(); ++k)
            other.p[k] += (1 + other.p[k]) / scalar(static_cast<int>(50 + k));
        return equations_.jacobians_differ(other);
    }

    /// One full step of Newton's iteration, without a test of whether it contracts: corrections in the kernel of M are
    /// rounding errors over epsilon. True where `full` then solves the equations.
    bool full_step(const scalar& size, iterate& full) {
        using std::sqrt;
        iterate d;
        full = x_;
        if (!equations_.residual(x_)) return false;
        equations_.solve(x_, d);
        full.y += d.y, full.Z += d.Z, full.p += d.p;
        return equations_.residual(full) &&
               equations_.residual_size() <
                   sqrt(std::numeric_limits<scalar>::epsilon()) * (size + full.y.cwiseAbs().maxCoeff());
    }

    /// The factors or x are others from now on.
    void forget() { chosen_ = false; }

  private:
    scalar of_other(const scalar& error) {
        using std::abs;
        const int n = equations_.n(), np = equations_.np(), L = x_.intervals();
        iterate other = x_, e;
        for (Eigen::Index i = 0; i <= L; ++i)
            for (int c = 0; c < n; ++c)
                other.y(c, i) += error * scale_[c] * sign(static_cast<int>(8 * i / (L + 1)) * n + c);
        for (int k = 0; k < np; ++k) other.p[k] += error * (1 + abs(other.p[k])) * sign(k);
        wide local = wide::Zero(n, L);
        for (int i = 0; i < L; ++i) {
            const auto change = equations_.change_of_jacobian(other, i);
            for (int c = 0; c < n; ++c) {
                for (int d = 0; d < n; ++d) local(c, i) += change(c, d) * (u_(d, i) + u_(d, i + 1)) / 2;
                for (int k = 0; k < np; ++k) local(c, i) += change(c, n + k) * p_[k];
                local(c, i) *= x_.h(i);
            }
        }
        column conditions = column::Zero(n + np);
        const auto change = equations_.change_of_conditions(other);
        for (int r = 0; r < n + np; ++r) {
            for (int c = 0; c < n; ++c)
                conditions[r] += change(r, c) * u_(c, 0) + change(r, n + c) * u_(c, L);
            for (int k = 0; k < np; ++k) conditions[r] += change(r, 2 * n + k) * p_[k];
        }
        equations_.solve_mesh_values(local, conditions, e);
        return share(e.y, e.p);
    }

    /// u := mode k.
    void take(const modes_of<Equations>& modes, int k) {
        modes.get(k, u_, p_);
        size_ = u_.cwiseAbs().rowwise().maxCoeff();
    }
    /// e: the answer of the problem to the local errors of u; false where these are large.
    bool answer_to_mesh(iterate& e) {
        wide local(equations_.n(), x_.intervals());
        elimination_.begin(x_);
        const bool usual = elimination_.usual();
        for (int i = 0; i < x_.intervals(); ++i)
            usual ? local_error<usual_nodes>(i, local) : local_error<0>(i, local);
        if (!(share(local) < scalar(small_part))) return false;
        equations_.solve_mesh_values(local, column::Zero(local.rows() + p_.rows()), e);
        return true;
    }

    /// u: the answer to the condition that moves it most, as its terms and the components of y are large; of equal ones, as
    /// symmetric problems have them, the last, whatever rounding makes of them.
    void choose() {
        using std::abs;
        using std::sqrt;
        if (std::exchange(chosen_, true)) return;
        conditioning_.fundamental();
        const int n = equations_.n(), m = n + equations_.np();
        const auto& B = equations_.conditions();
        const auto& shifts = conditioning_.parameters();
        scale_.resize(n);
        for (int c = 0; c < n; ++c) {
            scale_[c] = scalar(0);
            for (int i = 0; i <= x_.intervals(); ++i)
                scale_[c] = std::max(scale_[c], scalar(abs(x_.y(c, i))));
            scale_[c] += threshold_;
        }
        int best = 0;
        answer_ = scalar(0);
        const scalar noise = sqrt(std::numeric_limits<scalar>::epsilon());
        for (int k = 0; k < m; ++k) {
            const wide& phi = conditioning_.response(k);
            scalar terms(0), most(0);
            for (int c = 0; c < n; ++c) {
                terms += (abs(B(k, c)) + abs(B(k, n + c))) * scale_[c];
                scalar largest(0);
                for (int i = 0; i <= x_.intervals(); ++i) largest = std::max(largest, scalar(abs(phi(c, i))));
                most = std::max(most, scalar(largest / scale_[c]));
            }
            for (int j = 0; j < m - n; ++j) {
                const scalar size = threshold_ + abs(x_.p[j]);
                terms += abs(B(k, 2 * n + j)) * size;
                most = std::max(most, scalar(abs(shifts(j, k)) / size));
            }
            most *= terms;
            if (most > answer_ * (1 - noise)) answer_ = std::max(most, answer_), best = k;
        }
        u_ = conditioning_.response(best);
        p_ = shifts.col(best);
        size_ = u_.cwiseAbs().rowwise().maxCoeff();
    }

    /// Bounds the sum of local errors beside u by the size of h f_y where that changes little (else infinity): those of Gauss
    /// methods are (k!)^2/((2 k)! (2 k + 1)!) z^(2 k + 1) for y' = z y.
    scalar local_bound() const {
        using std::pow;
        const int n = equations_.n(), s = equations_.s(), width = n + equations_.np(), order = rule_.order;
        scalar sum(0);
        for (int i = 0; i < x_.intervals(); ++i) {
            const auto all = equations_.jacobians(i);
            const auto J = middle_jacobian(equations_, x_, i);
            const scalar most = J.cwiseAbs().maxCoeff();
            for (int j = 0; j < s; ++j)
                if ((x_.h(i) * all.middleCols(j * width, n) - J).cwiseAbs().maxCoeff() > most / 2)
                    return std::numeric_limits<scalar>::infinity();
            sum += pow(largest_rate(J), scalar(order + 1));
        }
        return gauss_error_constant<scalar>(order) * sum;
    }

    /// u at the end of interval i by the collocation that lifts, with the Jacobians between the nodes by interpolation, less
    /// what it is there. Nodes is the number of nodes where it is known at compile time, or 0.
    template <int Nodes>
    void local_error(int i, wide& local) {
        const int n = equations_.n(), np = equations_.np(), s = equations_.s(), width = n + np;
        const int m = Nodes > 0 ? Nodes : rule_.nodes();
        const scalar h = x_.h(i), *hJ = elimination_.template jacobians<Nodes>(i, h), *u = &u_(0, i);
        J_.resize(n, np), d_.resize(n, m), g_.resize(n, m);
        for (int k = 0; k < m; ++k) {
            scalar* d = &d_(0, k);
            combine<N, N>(u, n, hJ + k * n * n, n, d, n);
            if (np == 0) continue;
            combine<NP, S>(rule_.lagrange.data() + k * s, s, equations_.jacobians(i).data() + n * n,
                           width * n, J_.data(), np * n);
            for (int j = 0; j < np; ++j)
                for (int c = 0; c < n; ++c) d[c] += h * J_(c, j) * p_[j];
        }
        elimination_.template solve<Nodes>(i, h, d_, g_);
        combine<N, Nodes>(rule_.gauss.b.data(), m, g_.data(), n, &local(0, i), n);
        local.col(i) += u_.col(i) - u_.col(i + 1);
    }

    /// How large e is beside u, their components beside those of y and p.
    scalar share(const wide& e) const {
        scalar most(0), whole(0);
        compare(e, most, whole);
        return whole > scalar(0) ? scalar(most / whole) : scalar(0);
    }
    scalar share(const wide& e, const parameters& p) const {
        using std::abs;
        scalar most(0), whole(0);
        compare(e, most, whole);
        for (Eigen::Index j = 0; j < p.size(); ++j) {
            const scalar size = threshold_ + abs(x_.p[j]);
            most = std::max(most, scalar(abs(p[j]) / size));
            whole = std::max(whole, scalar(abs(p_[j]) / size));
        }
        return whole > scalar(0) ? scalar(most / whole) : scalar(0);
    }
    void compare(const wide& e, scalar& most, scalar& whole) const {
        for (Eigen::Index c = 0; c < e.rows(); ++c) {
            const scalar largest = e.row(c).cwiseAbs().maxCoeff() / scale_[c];
            if (!(largest <= most)) most = largest;
            whole = std::max(whole, scalar(size_[c] / scale_[c]));
        }
    }
    /// The answer of the linearised problem to one rounding error in every entry, y and p being of these sizes.
    wide answer_to_rounding(const wide& size, const parameters& p, parameters& shift) {
        using std::abs;
        const int n = equations_.n(), np = equations_.np(), L = x_.intervals();
        const scalar eps = std::numeric_limits<scalar>::epsilon();
        wide local(n, L), e(n, L + 1);
        for (int i = 0; i < L; ++i) {
            const auto E = equations_.left_block(i), F = equations_.right_block(i);
            for (int c = 0; c < n; ++c) {
                scalar sum(0);
                for (int d = 0; d < n; ++d) sum += abs(E(c, d)) * size(d, i) + abs(F(c, d)) * size(d, i + 1);
                local(c, i) = sign(i) * eps * sum;
            }
        }
        const auto& B = equations_.conditions();
        column conditions(n + np);
        for (int k = 0; k < n + np; ++k) {
            scalar sum(0);
            for (int d = 0; d < n; ++d) sum += abs(B(k, d)) * size(d, 0) + abs(B(k, n + d)) * size(d, L);
            for (int j = 0; j < np; ++j) sum += abs(B(k, 2 * n + j)) * p[j];
            conditions[k] = sign(k) * eps * sum;
        }
        equations_.factors().solve(local, conditions, e, shift);
        return e;
    }
    /// A sign for rounding error number i, without a pattern.
    static scalar sign(int i) {
        return (static_cast<unsigned>(i + 1) * 2654435761u) >> 31 ? scalar(1) : scalar(-1);
    }

    Equations& equations_;
    conditioning_of<Equations>& conditioning_;
    const iterate& x_;
    lifting_elimination<Equations>& elimination_;
    const rule& rule_;
    static constexpr int S = Equations::stages > 0 ? Equations::stages : 0,
                         P = Equations::parameters::RowsAtCompileTime,
                         NP = N > 0 && P > 0 ? N *P : Eigen::Dynamic,
                         usual_nodes = lifting_elimination<Equations>::usual_nodes;

    wide u_, d_, g_;
    Eigen::Matrix<scalar, N, P> J_;
    parameters p_;
    typename Equations::state size_, scale_;
    scalar answer_{0}, threshold_;
    bool chosen_ = false;
};

}  // namespace stagecraft::detail
