// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <stagecraft/bvp/equations/collocation_blocks.hpp>
#include <stagecraft/bvp/equations/lifting_rule.hpp>
#include <stagecraft/linear/norms.hpp>
#include <stagecraft/linear/optional_mass.hpp>
#include <stagecraft/linear/two_point_matrix.hpp>
#include <stagecraft/problem/two_point_functions.hpp>

namespace stagecraft {

namespace detail {
/// Thrown where the first components of f are not those of y that follow, for which they were taken.
struct not_of_second_order {};
}  // namespace detail

/// An iterate of Newton's iteration: the mesh, y at its points, the scaled slopes Z = h y' at the s nodes of
/// every interval (n x s each, side by side) and the parameters. Corrections have the same form.
template <class Scalar, int N, int P>
struct bvp_iterate {
    std::vector<Scalar> t;
    Eigen::Matrix<Scalar, N, Eigen::Dynamic> y, Z;
    Eigen::Matrix<Scalar, P, 1> p;

    int intervals() const { return static_cast<int>(t.size()) - 1; }
    Scalar h(int i) const { return t[i + 1] - t[i]; }
};

/// The collocation equations of a two-point problem on a mesh: residuals, their linearisation (condensed
/// interval by interval to an n x 2n relation) and solutions with its factors. System is two_point_functions, S the number
/// of stages; the first `positions` equations are q' = v.
template <class System, int S>
class collocation_equations {
    using Scalar = typename System::scalar;
    using Mass = optional_mass<Scalar>;
    static constexpr int N = System::N, P = System::P;

  public:
    using iterate = bvp_iterate<Scalar, N, P>;
    using wide = Eigen::Matrix<Scalar, N, Eigen::Dynamic>;
    using state = Eigen::Matrix<Scalar, N, 1>;
    using parameters = Eigen::Matrix<Scalar, P, 1>;
    using matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    using column =
        Eigen::Matrix<Scalar, (N > 0 && P >= 0 ? N + P : Eigen::Dynamic), 1>;  ///< of the conditions
    using square = Eigen::Matrix<Scalar, N, N>;
    using rule = detail::lifting_rule<Scalar, S>;
    static constexpr int stages = S;

    collocation_equations(const tableau<Scalar, S>& method, System& system, const Mass& mass,
                          int positions = 0)
        : method_(method),
          system_(system),
          mass_(mass),
          blocks_(method, system.size(), system.parameters(), positions),
          conditions_(system.size() + system.parameters(), 2 * system.size() + system.parameters()),
          stages_(s(), system.size()),
          stage_(system.size()) {}

    const tableau<Scalar, S>& method() const { return method_; }
    System& system() { return system_; }
    const Mass& mass() const { return mass_; }
    int n() const { return N > 0 ? N : system_.size(); }
    int np() const { return P >= 0 ? P : system_.parameters(); }
    int s() const { return S > 0 ? S : method_.stages(); }
    int positions() const { return blocks_.positions(); }
    /// Takes the first m components for positions: the largest m <= n / 2 for which f is the next m of y there, at a point
    /// where all of them differ.
    void look_for_second_order(const Scalar& t, state y, const parameters& p) {
        int m = n() / 2;
        if (m == 0) return;
        const Scalar size = y.cwiseAbs().maxCoeff(), apart = (size > Scalar(0) ? size : Scalar(1)) / 1000000;
        for (int c = 0; c < n(); ++c) y[c] += (c + 1) * apart;
        const auto& f = system_.f(t, y, p);
        const auto holds = [&] {
            for (int c = 0; c < m; ++c)
                if (!(f[c] == y[c + m])) return false;
            return true;
        };
        while (!holds()) --m;
        blocks_ = {method_, n(), np(), m};
    }
    /// Throws not_of_second_order where f, evaluated at y, is not q' = v in its first components.
    template <class F, class Y>
    void demand_second_order(const F& f, const Y& y) const {
        for (int c = 0; c < positions(); ++c)
            if (!(f[c] == y[c + positions()])) throw detail::not_of_second_order();
    }

    /// Where f or r was not finite: a time, or an end's conditions.
    const Scalar& place() const { return place_; }
    bool conditions_at_fault() const { return at_conditions_; }

    /// Takes room for a mesh.
    void resize(const iterate& x) {
        const int L = x.intervals();
        blocks_.resize(L);
        rho_.resize(n(), s() * L);
        gamma_.resize(n(), L);
        beta_.resize(n() + np());
        J_.resize(n(), (n() + np()) * s() * L);
        work_.resize(blocks_.work(), L);
        g_.resize(n(), L);
        ++version_;
    }

    /// The negative residuals at x; false where f or r is not finite.
    bool residual(const iterate& x) { return evaluate(x, false); }

    /// The same together with the Jacobians, and all factored.
    bool linearise(const iterate& x) {
        ++version_;
        if (!evaluate(x, true)) return false;
        const auto& B = system_.conditions_jacobian();
        conditions_ = B.topRows(n() + np());
        if (!(conditions_.sum() - conditions_.sum() == Scalar(0))) {
            at_conditions_ = true;
            return false;
        }
        matrix_.start(n(), x.intervals(), conditions_);
        for (int i = 0; i < x.intervals(); ++i)
            matrix_.set(i, blocks_.factor(i, x.h(i), jacobians(i).data(), mass_));
        matrix_.factor();
        return true;
    }

    /// Are the Jacobians at x others than those of the factors? Looked at in one node of every interval; false for
    /// linear problems, whose factors hold everywhere.
    bool jacobians_differ(const iterate& x) {
        using std::sqrt;
        const Scalar same =
            sqrt(sqrt(std::numeric_limits<Scalar>::epsilon()));  // differences of f leave less
        const auto differ = [&](const auto& now, const auto& before) {
            return !((now - before).cwiseAbs().maxCoeff() <= same * before.cwiseAbs().maxCoeff());
        };
        for (int i = 0; i < x.intervals(); ++i) {
            const int j = i % s();
            if (differ(jacobian_at(x, i, j).topRows(n()), factored_jacobian(i, j))) return true;
        }
        return differ(conditions_jacobian_at(x).topRows(n() + np()), conditions_);
    }

    /// f at one point.
    template <class Y>
    auto slope(const Scalar& t, const Y& y, const parameters& p) {
        stage_ = y;
        return system_.f(t, stage_, p).head(n()).eval();
    }

    /// The Jacobian in the middle node of interval i at x, less that of the factors; the same of the conditions.
    auto change_of_jacobian(const iterate& x, int i) {
        const int j = s() / 2;
        return (jacobian_at(x, i, j).topRows(n()) - factored_jacobian(i, j)).eval();
    }
    auto change_of_conditions(const iterate& x) {
        return (conditions_jacobian_at(x).topRows(n() + np()) - conditions_).eval();
    }

    /// The correction that removes the residuals last evaluated, with the factors last computed.
    void solve(const iterate& x, iterate& d) { solve(x, rho_.data(), gamma_, beta_, d); }

    /// The answer to other residuals, of continuity and of the conditions.
    void solve(const iterate& x, const wide& gamma, const column& beta, iterate& d) {
        solve(x, nullptr, gamma, beta, d);
    }
    /// Its values at the mesh points and its parameters alone, which cost half of it.
    void solve_mesh_values(const wide& gamma, const column& beta, iterate& d) {
        solve_mesh_values(nullptr, gamma, beta, d);
    }

    /// The derivative of x with respect to the value of a condition.
    iterate response(const iterate& x, int condition) {
        column unit = column::Zero(n() + np());
        unit[condition] = Scalar(1);
        iterate d;
        solve(x, wide::Zero(n(), x.intervals()), unit, d);
        return d;
    }

    auto jacobians(int i) const { return J_.middleCols(i * s() * (n() + np()), s() * (n() + np())); }
    two_point_matrix<Scalar, N>& factors() { return matrix_; }
    /// The block F of interval i in E y_i + F y_{i+1} + P p = g.
    auto right_block(int i) { return blocks_.condensed(i).middleCols(n(), n()); }
    /// The block E.
    auto left_block(int i) { return blocks_.condensed(i).leftCols(n()); }
    /// The block P.
    auto parameter_block(int i) { return blocks_.condensed(i).rightCols(np()); }
    const matrix& conditions() const { return conditions_; }
    const column& boundary_residual() const { return beta_; }
    /// The largest residual last evaluated, of slopes, continuity and conditions.
    Scalar residual_size() const {
        return std::max({Scalar(rho_.cwiseAbs().maxCoeff()), Scalar(gamma_.cwiseAbs().maxCoeff()),
                         Scalar(beta_.cwiseAbs().maxCoeff())});
    }
    /// Another number whenever the Jacobians and factors are others.
    long version() const { return version_; }

  private:
    /// The right-hand sides of the condensed equations, from residuals of the slopes (nullptr where these are zero) and of
    /// continuity.
    void condense(const Scalar* rho, const wide& gamma) {
        for (int i = 0; i < gamma.cols(); ++i) {
            Scalar* work = &work_(0, i);
            blocks_.apply(i, rho ? rho + i * s() * n() : nullptr, &gamma(0, i), work);
            for (int c = 0; c < n(); ++c) g_(c, i) = work[blocks_.slopes() + c];
        }
    }
    void solve(const iterate& x, const Scalar* rho, const wide& gamma, const column& beta, iterate& d) {
        solve_mesh_values(rho, gamma, beta, d);
        d.Z.resize(n(), s() * x.intervals());
        for (int i = 0; i < x.intervals(); ++i)
            blocks_.recover(i, x.h(i), &work_(0, i), &d.y(0, i), &d.y(0, i + 1), d.p.data(),
                            rho ? rho + i * s() * n() : nullptr, &d.Z(0, i * s()));
    }
    void solve_mesh_values(const Scalar* rho, const wide& gamma, const column& beta, iterate& d) {
        condense(rho, gamma);
        d.y.resize(n(), gamma.cols() + 1);
        d.p.resize(np());
        matrix_.solve(g_, beta, d.y, d.p);
    }

    /// The Jacobian at x in node j of interval i, that of the factors there, and at x that of the conditions.
    const auto& jacobian_at(const iterate& x, int i, int j) {
        set_stages(x, i), set_stage(j);
        const Scalar t = time(x, i, j);
        system_.f(t, stage_, x.p);
        return system_.jacobian(t);
    }
    auto factored_jacobian(int i, int j) const {
        const int width = n() + np();
        return J_.middleCols((i * s() + j) * width, width);
    }
    const auto& conditions_jacobian_at(const iterate& x) {
        system_.conditions(x.y.col(0), x.y.col(x.intervals()), x.p);
        return system_.conditions_jacobian();
    }
    /// Node j of interval i; one at a mesh point inside [a, b] lies on the interval's own side of it, where f may jump.
    Scalar time(const iterate& x, int i, int j) const {
        using std::abs;
        const Scalar &c = method_.c[j], h = x.h(i), rounding = 2 * std::numeric_limits<Scalar>::epsilon();
        if (c == Scalar(0) && i > 0) return x.t[i] + std::max(h, abs(x.t[i])) * rounding;
        if (c == Scalar(1) && i + 1 < x.intervals())
            return x.t[i + 1] - std::max(h, abs(x.t[i + 1])) * rounding;
        return x.t[i] + c * h;
    }
    /// y at the nodes of interval i, one component behind the other.
    void set_stages(const iterate& x, int i) {
        constexpr int known = S > 0 ? S : 0;
        const int size = n(), count = s();
        const Scalar *Z = &x.Z(0, i * count), *y = &x.y(0, i), h = x.h(i);
        for (int c = 0; c < size; ++c) {
            Scalar* at_nodes = &stages_(0, c);
            const bool twice = c < positions();
            detail::transform<known, known>(count, count, twice ? blocks_.twice().data() : method_.A.data(),
                                            Z + c + (twice ? positions() : 0), size, at_nodes);
            for (int j = 0; j < count; ++j)
                at_nodes[j] = y[c] + (twice ? Scalar(h * (method_.c[j] * y[c + positions()] + at_nodes[j]))
                                            : at_nodes[j]);
        }
    }
    void set_stage(int j) {
        for (int c = 0; c < n(); ++c) stage_[c] = stages_(j, c);
    }
    bool evaluate(const iterate& x, bool derivatives) {
        const int size = n(), width = size + np(), count = s(), m = positions();
        for (int i = 0; i < x.intervals(); ++i) {
            const Scalar h = x.h(i), *Z = &x.Z(0, i * count);
            set_stages(x, i);
            for (int j = 0; j < count; ++j) {
                const Scalar t = time(x, i, j);
                set_stage(j);
                const auto& f = system_.f(t, stage_, x.p);
                if (!all_finite(f, size)) return fail_at(t);
                Scalar* rho = &rho_(0, i * count + j);
                for (int c = 0; c < size; ++c) rho[c] = h * f[c];
                demand_second_order(f, stage_);
                add_mass_times(mass_, Scalar(-1), Z + j * size, rho, size);
                if (derivatives && !take_jacobian(t, &J_(0, (i * count + j) * width))) return fail_at(t);
            }
            Scalar* gamma = &gamma_(0, i);
            for (int c = 0; c < size; ++c) gamma[c] = x.y(c, i) - x.y(c, i + 1);
            for (int c = 0; c < m; ++c) {
                Scalar sum = x.y(c + m, i);
                for (int k = 0; k < count; ++k) sum += blocks_.twice_to_end()[k] * Z[k * size + c + m];
                gamma[c] += h * sum;
            }
            for (int k = 0; k < count; ++k)
                for (int c = m; c < size; ++c) gamma[c] += method_.b[k] * Z[k * size + c];
        }
        const auto& r = system_.conditions(x.y.col(0), x.y.col(x.intervals()), x.p);
        for (int k = 0; k < width; ++k) beta_[k] = -r[k];
        at_conditions_ = !all_finite(beta_, width);
        return !at_conditions_;
    }
    /// The Jacobian where f was evaluated last, without the rows of the parameters; false if it is not finite.
    bool take_jacobian(const Scalar& t, Scalar* out) {
        const auto& J = system_.jacobian(t);
        const int size = n(), width = size + np();
        Scalar left(0);
        for (int d = 0; d < width; ++d)
            for (int c = 0; c < size; ++c) {
                out[d * size + c] = J(c, d);
                left += J(c, d) - J(c, d);
            }
        return left == Scalar(0);
    }
    bool fail_at(const Scalar& t) {
        place_ = t;
        at_conditions_ = false;
        return false;
    }

    tableau<Scalar, S> method_;
    System& system_;
    const Mass& mass_;
    detail::collocation_blocks<Scalar, N, P, S> blocks_;
    two_point_matrix<Scalar, N> matrix_;
    wide rho_, gamma_, g_, J_;
    column beta_;
    matrix work_, conditions_;
    Eigen::Matrix<Scalar, S, N, (S == 1 && N != 1 ? Eigen::RowMajor : Eigen::ColMajor)> stages_;
    state stage_;
    Scalar place_{0};
    bool at_conditions_ = false;
    long version_ = 0;
};

}  // namespace stagecraft
