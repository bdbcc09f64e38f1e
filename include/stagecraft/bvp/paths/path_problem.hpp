// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <utility>

#include <stagecraft/bvp/paths/path_state.hpp>
#include <stagecraft/problem/two_point.hpp>

namespace stagecraft::detail {

/// A problem with one unknown too many, of whatever types f and r are, as path_follower sees it: what its conditions and one
/// demand more are together. Of periodic orbits, whose unknowns are (T, p), the phase condition moves on with the path.
template <class Vector, class Parameters>
class path_problem {
  public:
    using scalar = typename Vector::Scalar;
    using column = Eigen::Matrix<scalar, Eigen::Dynamic, 1>;
    using functions = two_point_functions<scalar, Vector::RowsAtCompileTime, Parameters::RowsAtCompileTime>;
    static constexpr bool orbits = Parameters::RowsAtCompileTime == 2;

    /// What is demanded of the first point instead of the value of the parameter; nothing where `along` has no entries.
    path_demand<scalar> start{};

    virtual ~path_problem() = default;
    /// f, and the conditions as they now are, with `more`, of n components and `parameters` parameters.
    virtual std::unique_ptr<functions> with(const path_demand<scalar>& more, int n, int parameters) const = 0;
    /// Moves the phase condition to the orbit y.
    virtual void follow(const solution<Vector>& /*y*/, const Parameters& /*q*/) {}
    /// A tangent less what is a shift in phase.
    virtual column in_plane(const column& tangent) const { return tangent; }
    /// Does f still cross the plane of the phase condition at y(0)?
    virtual bool crosses(const Vector& /*left*/, const Parameters& /*q*/) { return true; }
};

/// That of f and r of these types.
template <class Rhs, class Conditions, class Vector, class Parameters>
class path_problem_of final : public path_problem<Vector, Parameters> {
    using base = path_problem<Vector, Parameters>;
    using typename base::column, typename base::functions, typename base::scalar;

  public:
    explicit path_problem_of(two_point_problem<Rhs, Conditions> problem) : problem_(std::move(problem)) {}

    std::unique_ptr<functions> with(const path_demand<scalar>& more, int n, int parameters) const override {
        return std::make_unique<owner>(problem_, more, n, parameters);
    }
    void follow(const solution<Vector>& y, const Parameters& q) override {
        if constexpr (base::orbits) problem_.r.follow(y, q);
    }
    column in_plane(const column& tangent) const override {
        if constexpr (base::orbits)
            return problem_.r.in_plane(tangent);
        else
            return tangent;
    }
    bool crosses(const Vector& left, const Parameters& q) override {
        if constexpr (base::orbits)
            return problem_.r.crosses(left, q);
        else
            return true;
    }

  private:
    using conditions = path_conditions<Conditions, scalar>;
    using whole = two_point_problem<Rhs, conditions>;
    /// A copy of the problem, as its functions refer to one.
    struct copy {
        whole problem;
        report<scalar> counts{};
    };
    struct owner final : private copy, public two_point_system<whole, Vector, Parameters> {
        owner(const two_point_problem<Rhs, Conditions>& p, const path_demand<scalar>& more, int n,
              int parameters)
            : copy{{p.f, {p.r, more}}},
              two_point_system<whole, Vector, Parameters>(copy::problem.f, copy::problem.r, n, parameters,
                                                          copy::counts) {}
    };

    two_point_problem<Rhs, Conditions> problem_;
};

}  // namespace stagecraft::detail
