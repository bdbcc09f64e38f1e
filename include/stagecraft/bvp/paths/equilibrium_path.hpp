// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <stagecraft/bvp/continuation_options.hpp>
#include <stagecraft/bvp/paths/branch_point.hpp>
#include <stagecraft/bvp/paths/spectrum.hpp>
#include <stagecraft/bvp/status.hpp>

namespace stagecraft::detail {

/// f(y, p) = 0 as its path sees it: writes f and its derivatives, n x (n + 1), at x = (y, p).
template <class Scalar>
struct rest_equations {
    using column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    using dense = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    std::function<void(const column& x, column& f, dense& J)> evaluate;
    Scalar relative;  ///< how well J is known
};

/// A point of a path of equilibria.
template <class Scalar>
struct rest_state {
    using column = typename rest_equations<Scalar>::column;
    using dense = typename rest_equations<Scalar>::dense;
    column x, tangent;
    dense J;
    known_spectrum<Scalar> spectrum;
    Scalar orientation{0};  ///< the determinant of J over the tangent, rows of norm 1
    Scalar arclength{0};
    int iterations = 0;
    point_kind kind = point_kind::regular;
    bvp_status status = bvp_status::success;
    std::string message;
    column crossing;    ///< branch points: x on the other path
    Scalar turning{0};  ///< Hopf points: omega
    column cosine, sine;

    Scalar slope() const { return tangent[tangent.size() - 1]; }
};

/// One path of equilibria, by pseudo-arclength (Allgower-Georg): any f, whose types are erased.
template <class Scalar>
class rest_follower {
  public:
    using state = rest_state<Scalar>;
    using column = typename state::column;
    using dense = typename state::dense;

    rest_follower(rest_equations<Scalar> f, const continuation_options<Scalar>& o)
        : f_(std::move(f)), o_(o) {}

    std::vector<state> run(const column& y) {
        n_ = y.size();
        state now;
        now.x.resize(n_ + 1);
        now.x << y, o_.from;
        now.tangent = column::Unit(n_ + 1, n_);
        if (!solve(now.tangent, Scalar(o_.from), now) || !look(now)) return {failed(now)};
        if ((now.slope() < Scalar(0)) == (o_.to > o_.from)) now.tangent = -now.tangent, look(now);
        std::vector<state> path{now};
        Scalar step = o_.step;
        const Scalar least = o_.step / 10000000;  // steps are cheap
        while (static_cast<int>(path.size()) < o_.max_points) {
            state next;
            std::vector<state> special;
            while (!advance(now, step, next) || !specials(now, next, step, step < 2 * least, special)) {
                step *= Scalar(0.45);  // not a half, which might lead to the same point once more
                if (step < least) {
                    path.push_back(failed(next));
                    return path;
                }
            }
            for (state& s : special) path.push_back(std::move(s));
            path.push_back(next);
            now = std::move(next);
            if (now.iterations < 5) step = std::min(Scalar(step * Scalar(1.5)), o_.largest_step);
            if (const char* end = end_of_path(o_, now.x[n_])) {
                if (*end) path.back().message = end;
                return path;
            }
        }
        path.back().message = too_many_points;
        return path;
    }

  private:
    static state failed(state s) {
        s.status = bvp_status::newton_failed;
        s.message = "Newton's iteration finds no equilibrium, whatever the step";
        return s;
    }
    dense square(const state& s, const column& last) const {
        dense M(n_ + 1, n_ + 1);
        M << s.J, last.transpose();
        return M;
    }
    bool evaluate(state& s, column& f) {
        f.resize(n_), s.J.resize(n_, n_ + 1);
        f_.evaluate(s.x, f, s.J);
        return f.allFinite() && s.J.allFinite();
    }
    /// Newton's iteration from s.x for f = 0 with along' x = value, until rounding errors end it. replaced >= 0: that
    /// component of f gives way to across' x = other, and its value is returned in `left`.
    bool solve(const column& along, const Scalar& value, state& s, int replaced = -1,
               const column& across = {}, const Scalar& other = Scalar(0), Scalar* left = nullptr) {
        column f, r(n_ + 1);
        Scalar last = std::numeric_limits<Scalar>::infinity();
        for (s.iterations = 1; s.iterations <= 20; ++s.iterations) {
            if (!evaluate(s, f)) return false;
            dense M = square(s, along);
            r << f, along.dot(s.x) - value;
            if (replaced >= 0) {
                if (left) *left = f[replaced];
                M.row(replaced) = across.transpose(), r[replaced] = across.dot(s.x) - other;
            }
            const column change = M.partialPivLu().solve(r);
            const Scalar size = change.norm(), whole = 1 + s.x.norm();
            if (!(size < 10 * whole)) return false;
            s.x -= change;
            const bool small = size <= o_.rtol * whole;
            if (size <= 2 * std::numeric_limits<Scalar>::epsilon() * whole || (small && size >= last / 4))
                return evaluate(s, f);
            last = size;
        }
        return last <= o_.rtol * (1 + s.x.norm()) && evaluate(s, f);
    }
    /// Tangent and spectrum where s.x and s.J are, the tangent on the side of the one that s has.
    bool look(state& s) {
        const column before = s.tangent;
        const dense M = square(s, before);
        s.tangent = M.partialPivLu().solve(column::Unit(n_ + 1, n_));
        if (!s.tangent.allFinite()) return false;
        s.tangent.normalize();
        dense N = square(s, s.tangent);
        N.rowwise().normalize();
        s.orientation = N.partialPivLu().determinant();
        s.spectrum = known_spectrum<Scalar>(s.J.leftCols(n_), f_.relative);
        return !s.spectrum.values.empty();
    }
    bool advance(const state& now, const Scalar& step, state& out) {
        out = state();
        out.x = now.x + step * now.tangent, out.tangent = now.tangent;
        out.arclength = now.arclength + step;
        if (!solve(now.tangent, Scalar(now.tangent.dot(now.x) + step), out) || !look(out)) return false;
        const column chord = (out.x - now.x).normalized();
        return now.tangent.dot(out.tangent) > Scalar(0.8) && now.tangent.dot(chord) > Scalar(0.95);
    }

    /// Is every test known better than to its distance from zero?
    bool decides(const state& s) const {
        using std::abs;
        const Scalar rounding = 1000 * f_.relative;
        return abs(s.slope()) > rounding && abs(s.orientation) > rounding && s.spectrum.decides_pairs();
    }
    /// Finds what lies between two points; false where smaller steps are to tell. `least`: they no longer do.
    bool specials(const state& now, const state& next, const Scalar& step, bool least,
                  std::vector<state>& found) {
        using std::abs;
        found.clear();
        // A point on which a test vanishes decides nothing, on either side; unless it vanishes all along the path.
        if (state beside;
            !least && decides(now) && !decides(next) && advance(now, step / 2, beside) && decides(beside))
            return false;
        const Scalar rounding = 1000 * f_.relative;
        const auto changes = [&](const auto& test) { return test(now) * test(next) < Scalar(0); };
        const auto fold = [](const state& s) { return s.slope(); };
        if (changes(fold) && abs(fold(now)) > rounding && abs(fold(next)) > rounding)
            found.push_back(locate(now, step, next, fold, point_kind::fold));
        const auto crossing = [](const state& s) { return s.orientation; };
        if (changes(crossing)) {
            state near = locate(now, step, next, crossing, point_kind::branch_point);
            if (!cross(now, step, near) && !least) return false;
            found.push_back(std::move(near));
        }
        // Two pairs that pass at once leave the sign as it is.
        if (abs(now.spectrum.unstable() - next.spectrum.unstable()) > 2 && !least) return false;
        const auto pairs = [](const state& s) { return s.spectrum.pair_test(); };
        if (changes(pairs) && now.spectrum.decides_pairs() && next.spectrum.decides_pairs()) {
            state near = locate(now, step, next, pairs, point_kind::hopf);
            if (turns(now, near)) found.push_back(std::move(near));
        }
        std::stable_sort(found.begin(), found.end(),
                         [](const state& a, const state& b) { return a.arclength < b.arclength; });
        return true;
    }

    /// Where `test` vanishes between now and next, by false position (Illinois), to rounding errors.
    template <class Test>
    state locate(const state& now, const Scalar& step, const state& next, const Test& test, point_kind kind) {
        using std::abs;
        Scalar low(0), high = step, at_low = test(now), at_high = test(next), width = step;
        state middle = next, trial;
        for (int k = 0; k < 100; ++k) {
            const Scalar s = (low * at_high - high * at_low) / (at_high - at_low);
            if (!advance(now, s, trial)) {
                middle.status = bvp_status::tolerance_not_met;
                break;
            }
            middle = trial;
            const Scalar value = test(middle);
            width = abs(s - high);
            if (value == Scalar(0) || width <= 4 * std::numeric_limits<Scalar>::epsilon() * step) break;
            if (value * at_high < Scalar(0)) {
                low = high, at_low = at_high;
            } else {
                at_low /= 2;
            }
            high = s, at_high = value;
            if (kind == point_kind::branch_point && width < step / 100000) break;  // cross() does the rest
        }
        middle.kind = kind;
        return middle;
    }

    /// From a point near a crossing to the crossing (branch_point.hpp), with a point of the other path.
    bool cross(const state& now, const Scalar& step, state& near) {
        const column along = near.tangent, origin = near.x;
        const Eigen::JacobiSVD<dense> svd(square(near, along), Eigen::ComputeFullU | Eigen::ComputeFullV);
        const column kernel = (svd.matrixV().col(n_) - along.dot(svd.matrixV().col(n_)) * along).normalized();
        Eigen::Index replaced = 0;
        svd.matrixU().col(n_).head(n_).cwiseAbs().maxCoeff(&replaced);
        state here = near;
        Scalar left(0);
        using pair = typename saddle_search<Scalar>::pair;
        dense directions;
        const auto move = [&](const pair& at) {
            here.x = origin + at[0] * along + at[1] * kernel;
            if (!solve(along, Scalar(along.dot(origin) + at[0]), here, static_cast<int>(replaced), kernel,
                       Scalar(kernel.dot(origin) + at[1]), &left))
                return false;
            dense M = square(here, along);
            M.row(replaced) = kernel.transpose();
            dense sides = dense::Zero(n_ + 1, 2);
            sides(n_, 0) = Scalar(1), sides(replaced, 1) = Scalar(1);
            directions = M.partialPivLu().solve(sides);
            return directions.allFinite();
        };
        saddle_search<Scalar> saddle;
        const auto gradient = [&](const pair& at, pair& g) {
            if (!move(at)) return false;
            g = (here.J.row(replaced) * directions).transpose();
            return true;
        };
        near.status = bvp_status::tolerance_not_met;
        if (!saddle.run(gradient, step) || !move(saddle.at)) return false;
        const Scalar size = here.J.row(replaced).norm() * (1 + here.x.norm());
        if (!(std::abs(left) <= std::max(o_.rtol, 100 * f_.relative) * size)) return false;
        here.tangent = now.tangent;
        here.kind = point_kind::branch_point, here.status = bvp_status::success;
        here.arclength = near.arclength + saddle.at[0];
        here.spectrum = known_spectrum<Scalar>(here.J.leftCols(n_), f_.relative);
        const column at = here.x, direction = (directions * saddle.other).normalized();
        state other = here;
        other.x = at + step / 4 * direction;
        if (solve(direction, Scalar(direction.dot(at) + step / 4), other)) here.crossing = other.x;
        near = std::move(here);
        return true;
    }

    /// A Hopf point is one if the pair is complex, to more than its error; p is as good as the real part, over its slope.
    bool turns(const state& now, state& near) {
        using std::abs;
        const auto least = near.spectrum.least_pair();
        const auto value = near.spectrum.values[least.first];
        if (!(abs(value.imag()) > 100 * least.error) ||
            near.spectrum.values[least.second] != std::conj(value))
            return false;
        const Scalar along = near.arclength - now.arclength, off = along / 1000;
        state beside;
        Scalar slope(0);
        if (advance(now, Scalar(along - off), beside))
            slope = (beside.spectrum.least_pair().sum.real() - least.sum.real()) / off;
        const Scalar error = (least.error + abs(least.sum.real())) * abs(near.slope() / slope);
        if (!(error <= o_.rtol * (1 + abs(near.x[n_])))) {
            near.status = bvp_status::tolerance_not_met;
            near.message = "p is not known to the tolerance where the eigenvalues pass the imaginary axis";
        }
        near.turning = abs(value.imag());
        // Of all phases of the eigenvector the one in which the real part is largest.
        auto q = near.spectrum.vectors.col(static_cast<Eigen::Index>(least.first)).eval();
        const std::complex<Scalar> square_of = (q.transpose() * q)(0, 0);
        q *= std::exp(std::complex<Scalar>(0, -std::arg(square_of) / 2));
        q /= q.real().norm();
        near.cosine = q.real();
        near.sine = value.imag() > Scalar(0) ? column(-q.imag()) : column(q.imag());
        return true;
    }

    rest_equations<Scalar> f_;
    continuation_options<Scalar> o_;
    Eigen::Index n_ = 0;
};

}  // namespace stagecraft::detail
