// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <type_traits>
#include <utility>

#include <stagecraft/break_points.hpp>
#include <stagecraft/problem/capabilities.hpp>
#include <stagecraft/refuse/problem/checked_call.hpp>

namespace stagecraft {

/// M y' = f_explicit(t, y) + f_implicit(t, y): what split() returns. As a problem it is f_implicit, with all its members; the
/// other part is explicit_part(t, y, f).
template <class Explicit, class Implicit>
struct problem_in_parts : Implicit {
    using explicit_function = Explicit;
    using implicit_function = Implicit;
    Explicit f_explicit;
    problem_in_parts(Explicit e, Implicit i) : Implicit(std::move(i)), f_explicit(std::move(e)) {}
    using Implicit::operator();
    template <class T, class Y, class F>
    void explicit_part(const T& t, const Y& y, F& f) {
        write(f_explicit, t, y, f);
    }
    template <class T, class Y, class F>
    void explicit_part(const T& t, const Y& y, F& f) const {
        write(f_explicit, t, y, f);
    }
    /// The same with make(part) in the place of each part.
    template <class Make>
    auto with_each(const Make& make) const {
        auto e = make(f_explicit);
        auto i = make(static_cast<const Implicit&>(*this));
        return problem_in_parts<decltype(e), decltype(i)>(std::move(e), std::move(i));
    }

  private:
    template <class E, class T, class Y, class F>
    static void write(E& e, const T& t, const Y& y, F& f) {
        if constexpr (detail::callable_right_hand_side<E, Y>)
            e(t, y, f);
        else
            f = detail::of_size(e(t, y), y.size());
    }
};

namespace detail {

/// A function, which has no class, as an object of one.
template <class Result, class... Arguments>
struct function_object {
    Result (*function)(Arguments...);
    Result operator()(Arguments... arguments) const {
        return function(std::forward<Arguments>(arguments)...);
    }
};
template <class F>
F object_of_function(F f) {
    return f;
}
template <class Result, class... Arguments>
function_object<Result, Arguments...> object_of_function(Result (*f)(Arguments...)) {
    return {f};
}

/// What only the implicit part is asked for is in the explicit one.
template <class Explicit, class Implicit>
inline constexpr bool has_lost_members = (has_mass<Explicit> && !has_mass<Implicit>) ||
                                         (has_index<Explicit> && !has_index<Implicit>) ||
                                         (has_break_points<Explicit> && !has_break_points<Implicit>) ||
                                         (has_member_named<Explicit, domain_member> &&
                                          !has_member_named<Implicit, domain_member>);

}  // namespace detail

/// The problem M y' = f_explicit(t, y) + f_implicit(t, y) for additive(): f_implicit holds what is stiff, and the equations
/// without a derivative where M is singular.
///
/// Both are called as f(t, y, f), which writes, or f(t, y), which returns. All optional members are those of f_implicit:
/// mass(), jacobian() (of f_implicit alone), bandwidth(), sparsity(), linear_solver, constant_jacobian(), domain() ...
/// (problem/capabilities.hpp); a jacobian() of f_explicit is not used. Copies of both are kept.
template <class Explicit, class Implicit>
auto split(Explicit f_explicit, Implicit f_implicit) {
    auto e = detail::object_of_function(std::move(f_explicit));
    auto i = detail::object_of_function(std::move(f_implicit));
    static_assert(!detail::has_lost_members<decltype(e), decltype(i)>,
                  "split(f_explicit, f_implicit): mass(), index(), domain() and break_points() are members "
                  "of f_implicit; in f_explicit they would be lost");
    return problem_in_parts<decltype(e), decltype(i)>(std::move(e), std::move(i));
}

}  // namespace stagecraft
