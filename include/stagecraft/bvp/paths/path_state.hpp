// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/bvp/continuation_options.hpp>
#include <stagecraft/bvp/paths/multipliers.hpp>
#include <stagecraft/bvp/paths/traces.hpp>
#include <stagecraft/bvp/solve/search.hpp>

namespace stagecraft::detail {

/// What is demanded beside the conditions of a problem with one unknown too many: that (y(a), y(b), p) lies `step` further
/// along a direction. With replaced >= 0 that condition of the problem gives way to another of this kind (branch_point.hpp).
template <class Scalar>
struct path_demand {
    using column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    column from, along;
    Scalar step{0};
    int replaced = -1;
    column kernel{};  ///< a direction, along which (y(a), y(b), p) lies `amount` away
    Scalar amount{0};
};

/// The conditions of the problem together with that.
template <class Conditions, class Scalar>
struct path_conditions {
    using column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    Conditions r;
    path_demand<Scalar> more;

    template <class Y, class P, class R>
    requires(std::is_invocable_v<Conditions&, const Y&, const Y&, const P&, R&>) void operator()(
        const Y& left, const Y& right, const P& p, R& out) {
        r(left, right, p, out);
        auto& last = out[left.size() + p.size() - 1];
        if (last == last) throw bad_problem("continuation: the conditions must write n numbers, not more");
        last = distance(more.along, left, right, p) - more.step;
        if (more.replaced >= 0) out[more.replaced] = distance(more.kernel, left, right, p) - more.amount;
    }

  private:
    template <class Y, class P>
    typename Y::Scalar distance(const column& d, const Y& left, const Y& right, const P& p) const {
        const Eigen::Index n = left.size();
        const column& from = more.from;
        typename Y::Scalar sum = left[0] * Scalar(0);
        for (Eigen::Index i = 0; i < n; ++i)
            sum = sum + d[i] * (left[i] - from[i]) + d[n + i] * (right[i] - from[n + i]);
        for (Eigen::Index i = 0; i < p.size(); ++i) sum = sum + d[2 * n + i] * (p[i] - from[2 * n + i]);
        return sum;
    }
};

/// The line through two solutions.
template <class Vector>
struct extrapolated {
    using scalar = typename Vector::Scalar;
    const solution<Vector>&now, &before;
    scalar factor;
    Vector operator()(const scalar& t) const { return now(t) + factor * (now(t) - before(t)); }
    Vector derivative(const scalar& t) const {
        return now.derivative(t) + factor * (now.derivative(t) - before.derivative(t));
    }
};

/// A point of a path as the follower sees it. x = (y(a), y(b), p).
template <class Vector, class Parameters>
struct path_state {
    using scalar = typename Vector::Scalar;
    using column = Eigen::Matrix<scalar, Eigen::Dynamic, 1>;
    bvp_status status = bvp_status::newton_failed;
    std::string message;  ///< of the last point
    point_kind kind = point_kind::regular;
    Parameters p = Parameters::Zero();
    solution<Vector> y;
    std::vector<scalar> mesh;
    scalar error{0};  ///< estimated, of y and p on this mesh
    scalar arclength{0};
    column x, tangent;
    solution_traces<scalar> traces;
    std::vector<floquet_multiplier<scalar>> multipliers;  ///< of periodic orbits
    int newton_steps = 0;
    /// Of branch points: a point of the crossing path close by.
    Parameters other_p = Parameters::Zero();
    solution<Vector> other_y;

    /// The mesh to begin the next point on: without every second interval's end while the error of a coarser mesh,
    /// 2^(s + 3) times as large with s stages, is still within the tolerance.
    std::vector<scalar> coarser(int s, const scalar& tolerance, int least) const {
        using std::ldexp;
        std::vector<scalar> t = mesh;
        for (scalar next = ldexp(error, s + 3); next<tolerance&& static_cast<int>(t.size())> 2 * least;
             next = ldexp(next, s + 3)) {
            std::vector<scalar> wide;
            for (std::size_t i = 0; i < t.size(); i += 2) wide.push_back(t[i]);
            if (wide.back() != t.back()) wide.push_back(t.back());
            t = std::move(wide);
        }
        return t;
    }
    /// The slope along the path of the parameter that is followed, the last one.
    scalar slope() const { return tangent[tangent.size() - 1]; }
    void turn() {
        tangent = -tangent;
        traces.turn();
    }
};

}  // namespace stagecraft::detail
