// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <initializer_list>
#include <stdexcept>
#include <utility>
#include <vector>

namespace stagecraft {

/// What nonnegative() may be told.
struct nonnegative_options {
    struct {
    } named{};  // so that {1} is a list of components
    bool clip =
        false;  ///< a component that ends a step below zero by less than its atol is set to zero; report.clipped counts
};

namespace detail {

template <class Rhs, class Predicate>
struct rhs_with_domain : Rhs {
    Predicate inside;
    rhs_with_domain(Rhs r, Predicate p) : Rhs(std::move(r)), inside(std::move(p)) {}
    using Rhs::operator();
    template <class T, class Y>
    bool domain(const T& t, const Y& y) const {
        if constexpr (requires(const Rhs& rhs) { rhs.domain(t, y); })
            if (!Rhs::domain(t, y)) return false;
        return static_cast<bool>(inside(t, y));
    }
};

template <class Rhs>
struct nonnegative_rhs : Rhs {
    std::vector<int> components;  // none: all
    bool clips;
    nonnegative_rhs(Rhs r, std::vector<int> c, bool clip)
        : Rhs(std::move(r)), components(std::move(c)), clips(clip) {
        for (const int i : components)
            if (i < 0) throw std::invalid_argument("nonnegative: components must not be negative");
    }
    using Rhs::operator();
    template <class T, class Y>
    bool domain(const T& t, const Y& y) const {
        if constexpr (requires(const Rhs& rhs) { rhs.domain(t, y); })
            if (!Rhs::domain(t, y)) return false;
        bool none_below = true;
        each(y.size(), [&](Eigen::Index i) { none_below = none_below && y[i] >= typename Y::Scalar(0); });
        return none_below;
    }
    /// Sets components in (-atol(i), 0) to zero; how many.
    template <class Y, class Tolerance>
    long clip(Y& y, const Tolerance& atol) const {
        long count = 0;
        if (!clips) return count;
        each(y.size(), [&](Eigen::Index i) {
            if (y[i] < typename Y::Scalar(0) && y[i] > -atol(i)) y[i] = typename Y::Scalar(0), ++count;
        });
        return count;
    }

  private:
    template <class Visit>
    void each(Eigen::Index n, const Visit& visit) const {
        if (components.empty())
            for (Eigen::Index i = 0; i < n; ++i) visit(i);
        for (const int i : components) {
            if (i >= n) throw std::out_of_range("nonnegative: components holds one that y has not");
            visit(i);
        }
    }
};

}  // namespace detail

/// A problem with the domain of its solution: inside(t, y) is true where (t, y) lies within. No accepted state lies outside;
/// a step that would end there is tried again with a half, and what is met at the stages on the way is not looked at. Where
/// no step that t resolves ends inside the run ends in status::outside_domain. A member `bool domain(t, y) const` of a problem
/// of your own does the same.
///
///     integrate(method, with_domain(f, [](double, const auto& y) { return y[0] < 1; }), y0, t0, t1)
///
/// y0 outside is std::invalid_argument, and a change (observe/at.hpp) that leads out ends the run in status::function_threw
/// before it. A domain restrains what a tolerance leaves open, it does not make a right-hand side right: where the solution
/// itself leaves the domain the run ends. Costs a call per step; no evaluation of f.
template <class Rhs, class Predicate>
auto with_domain(Rhs rhs, Predicate inside) {
    return detail::rhs_with_domain<Rhs, Predicate>(std::move(rhs), std::move(inside));
}

/// A problem no component of whose accepted states is negative: concentrations, populations, levels.
template <class Rhs>
auto nonnegative(Rhs rhs, nonnegative_options o = {}) {
    return detail::nonnegative_rhs<Rhs>(std::move(rhs), {}, o.clip);
}
/// The same of some components: nonnegative(f, {0, 2}), or a std::vector of them.
template <class Rhs>
auto nonnegative(Rhs rhs, std::initializer_list<int> components, nonnegative_options o = {}) {
    return detail::nonnegative_rhs<Rhs>(std::move(rhs), components, o.clip);
}
template <class Rhs, class Components>
requires requires(const Components& c) { c.begin() == c.end(); }
auto nonnegative(Rhs rhs, const Components& components, nonnegative_options o = {}) {
    return detail::nonnegative_rhs<Rhs>(std::move(rhs), {components.begin(), components.end()}, o.clip);
}

}  // namespace stagecraft
