// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <span>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include <stagecraft/dense_output.hpp>
#include <stagecraft/refuse/detect/refused_call.hpp>
#include <stagecraft/tableau.hpp>

namespace stagecraft {

/// An observer that keeps the continuous solution of a whole run:
///
///     solution<Vector3d> y;
///     integrate(method, problem, y0, t0, t1, options, y);        // then y(t), y.derivative(t)
///
/// It is continuous, also in algebraic components, and of the order given in dense_output.hpp; where the run has changed y
/// (observe/at.hpp) it is continuous from the right, y.before(t) from the left. Where two
/// steps meet otherwise, the polynomial of the earlier one is evaluated; it satisfies the equation there if the method
/// is stiffly accurate. Storage: n (d + 1) + 2 numbers per step, d being the degree of its polynomial. Cost
/// of one value: O(log steps) for the search by bisection and O(n d).
template <class Vector>
class solution {
  public:
    using scalar = typename Vector::Scalar;

    /// The interval that the run has covered.
    const scalar& t0() const { return t0_; }
    const scalar& t1() const { return t1_; }
    int steps() const { return static_cast<int>(pieces_.size()); }
    /// The times at which the steps ended, in the order of the run.
    std::vector<scalar> ends_of_steps() const {
        std::vector<scalar> times;
        for (const piece& p : pieces_) times.push_back(p.t1);
        return times;
    }

    /// y(t). Throws std::out_of_range naming t if it is not between t0() and t1() or no run was made.
    Vector operator()(const scalar& t) const {
        demand_inside(t);
        for (const jump& c : changes_at(t)) return c.y;
        return t == t0_ ? y0_ : value(t);
    }
    /// The same before a change of y at t; otherwise y(t).
    Vector before(const scalar& t) const {
        demand_inside(t);
        return t == t0_ ? y0_ : value(t);
    }

    /// y'(t), of one order less than y(t). Throws std::out_of_range like operator(), and where the run has
    /// made no step.
    Vector derivative(const scalar& t) const {
        demand_inside(t);
        if (pieces_.empty()) throw std::out_of_range("solution: a run without a step has no derivative");
        const piece& p = find(t);
        const auto& nodes = nodes_[p.nodes];
        const auto values = numbers(p, nodes.size);
        basis_values<scalar, dynamic> l(nodes.size);
        nodes.basis_derivative((t - p.t0) / p.h, l.data());
        Vector slope = Vector::Zero(y0_.size());
        for (int j = 0; j < nodes.size; ++j) slope += (l[j] / p.h) * values.col(j + 1);
        return slope;
    }

    void start(const scalar& t0, const Vector& y0, const scalar& t1) {
        pieces_.clear();
        numbers_.clear();
        nodes_.clear();
        changes_.clear();
        t0_ = t1_ = t0;
        y0_ = y0;
        backwards_ = t1 < t0;
        started_ = true;
    }

    void changed(const scalar& t, const Vector& y) {
        if (!changes_.empty() && changes_.back().t == t) changes_.pop_back();
        changes_.push_back({t, y});
    }
    template <class State, class Output>
    requires(State::SizeAtCompileTime == Vector::SizeAtCompileTime ||
             State::SizeAtCompileTime == Eigen::Dynamic || Vector::SizeAtCompileTime == Eigen::Dynamic) void
    operator()(const scalar& t, const State&, const scalar&, const Output& output) {
        const auto& nodes = output.nodes();
        scalar* numbers = add(output.t0(), output.step(), t, nodes);
        const auto append = [&](const auto& x) { numbers = std::copy_n(x.data(), x.size(), numbers); };
        append(output.y0());
        append(output.increments().middleCols(nodes.first_column, nodes.size));
    }

    /// One piece more, from t0 to t1; the n (1 + nodes.size) numbers of its polynomial, y(t0) and the increments at the
    /// nodes, are to be written where the pointer that is returned leads.
    template <class Nodes>
    scalar* add(const scalar& t0, const scalar& h, const scalar& t1, const Nodes& nodes) {
        const std::size_t first = numbers_.size();
        pieces_.push_back({t0, h, t1, first, nodes_of(nodes)});
        numbers_.resize(first + static_cast<std::size_t>(y0_.size() * (1 + nodes.size)));
        t1_ = t1;
        return numbers_.data() + first;
    }
    /// Takes room for so many pieces with so many nodes each.
    void reserve(int pieces, int nodes) {
        pieces_.reserve(static_cast<std::size_t>(pieces));
        numbers_.reserve(static_cast<std::size_t>(pieces * y0_.size() * (1 + nodes)));
    }

    /// A run that an event has ended earlier covers less.
    template <class Result>
    void conclude(const Result& r) {
        if (after(t1_, r.t)) t1_ = r.t;
        while (!pieces_.empty() && !after(t1_, pieces_.back().t0)) pieces_.pop_back();
        if (!pieces_.empty() && after(pieces_.back().t1, t1_)) pieces_.back().t1 = t1_;
        while (!changes_.empty() && after(changes_.back().t, t1_)) changes_.pop_back();
    }

  private:
    struct piece {
        scalar t0, h, t1;
        std::size_t first;  ///< where its numbers begin
        std::size_t nodes;
    };

    struct jump {
        scalar t;
        Vector y;  ///< behind it
    };
    /// The change at t, if there is one.
    auto changes_at(const scalar& t) const {
        const auto at = std::lower_bound(changes_.begin(), changes_.end(), t,
                                         [this](const jump& c, const scalar& u) { return after(u, c.t); });
        const bool there = at != changes_.end() && at->t == t;
        return std::span<const jump>(changes_.data() + (at - changes_.begin()), there ? 1 : 0);
    }

    bool after(const scalar& t, const scalar& u) const { return backwards_ ? t < u : t > u; }

    /// The place of these nodes in nodes_: a run uses those of few methods, mostly the same again.
    template <class Nodes>
    std::size_t nodes_of(const Nodes& nodes) {
        for (std::size_t k = nodes_.size(); k-- > 0;)
            if (nodes_[k].size == nodes.size &&
                std::equal(nodes_[k].c.begin(), nodes_[k].c.begin() + nodes.size, nodes.c.begin()))
                return k;
        interpolation_nodes<scalar, dynamic> copy(nodes.size);
        copy.size = nodes.size;
        std::copy_n(nodes.c.begin(), nodes.size, copy.c.begin());
        std::copy_n(nodes.omega.begin(), nodes.size, copy.omega.begin());
        nodes_.push_back(std::move(copy));
        return nodes_.size() - 1;
    }

    Vector value(const scalar& t) const {
        const piece& p = find(t);
        Vector y = y0_;
        const auto& nodes = nodes_[p.nodes];
        const auto values = numbers(p, nodes.size);
        basis_values<scalar, dynamic> l(nodes.size);
        nodes.basis((t - p.t0) / p.h, l.data());
        y = values.col(0);
        for (int j = 0; j < nodes.size; ++j) y += l[j] * values.col(j + 1);
        return y;
    }

    auto numbers(const piece& p, int degree) const {
        using matrix = Eigen::Matrix<scalar, Vector::RowsAtCompileTime, Eigen::Dynamic>;
        return Eigen::Map<const matrix>(numbers_.data() + p.first, y0_.size(), degree + 1);
    }

    /// The step with t in (its t0, its t1], or the first one.
    const piece& find(const scalar& t) const {
        return *std::lower_bound(pieces_.begin(), pieces_.end(), t,
                                 [this](const piece& p, const scalar& u) { return after(u, p.t1); });
    }

    void demand_inside(const scalar& t) const {
        if (started_ && !after(t0_, t) && !after(t, t1_) && t == t) return;
        std::ostringstream message;
        message.precision(std::numeric_limits<scalar>::max_digits10);
        message << "solution: t = " << t;
        if (started_)
            message << " is not between " << t0_ << " and " << t1_;
        else
            message << " asked for before a run was made";
        throw std::out_of_range(message.str());
    }

    std::vector<piece> pieces_;
    std::vector<jump> changes_;
    std::vector<scalar> numbers_;
    std::vector<interpolation_nodes<scalar, dynamic>> nodes_;
    scalar t0_{0}, t1_{0};
    Vector y0_;
    bool backwards_ = false, started_ = false;
};

/// Not of states: of numbers, or of none.
template <class Vector>
requires(!requires { typename Vector::Scalar; }) class solution<Vector> final {
  public:
    template <class... Arguments>
    Eigen::VectorXd operator()(const Arguments&...) const;
    static_assert(detail::never<Vector>, "write solution<Eigen::Vector3d> y, with the type of the state");
};
solution()->solution<detail::unstated>;

}  // namespace stagecraft
