// SPDX-License-Identifier: BSL-1.0
#pragma once

// What refusals are made of.

namespace stagecraft {
template <class Scalar, int Stages>
struct tableau;
template <class Scalar, int Stages>
struct transformed_tableau;
}  // namespace stagecraft

namespace stagecraft::detail {

/// False: for a static_assert in a template that refuses whatever it is instantiated with.
template <class>
inline constexpr bool never = false;

/// In place of the type of a state that has not been written: the observers of it say what to write.
struct unstated {};

/// Taken for an argument by overloads that refuse a call, so that any other overload comes first.
struct anything {
    template <class T>
    anything(const T&) {}
};
/// A value of any type, of an option.
struct any_value {
    any_value() = default;
    template <class T>
    any_value(const T&) {}
};
/// What options are taken for by overloads that refuse them: with the names of all options, of events as well, and usual
/// names of none, each with a value of any type. (Names unknown here as well are refused in more lines, as nothing can
/// be made of their braces.)
struct misnamed_options {
    any_value start{}, from{}, end{}, to{}, tol{}, tolerance{}, eps{}, reltol{}, rel_tol{}, rtol{}, abstol{},
        abs_tol{}, atol{}, atol_components{}, fixed_step{}, dt{}, h{}, step{}, step_size{}, h0{},
        initial_step{}, hmin{}, min_step{}, hmax{}, max_step{}, largest_step{}, control{}, continuous{},
        jumps{}, max_steps{}, max_iter{}, max_iterations{}, n{}, nodes{}, points{}, intervals{}, mesh{},
        fixed_points{}, max_intervals{}, max_points{}, growth{}, phase_component{}, phase_value{}, adapt{},
        newton_iterations{}, newton_factor{}, break_points{}, consistent_start{}, conditioning{}, dir{},
        direction{}, stop{}, terminal{}, at_start{};
};
/// The same for the overload of last resort, which ends in "..." and so takes options with unknown names too.
/// Sentence::say<T>() refuses in a static_assert: it stands in the exception specification, which compilers look at once
/// they have chosen this overload, before the arguments that follow, and not before they have. The name of a family
/// alone is taken for its overload that refuses a number of stages in parentheses, which then says what to write.
template <class Sentence>
struct refused_call {
    template <class T>
    refused_call(const T&) noexcept(Sentence::template say<T>());
    refused_call(tableau<double, -1> (*)(...));
    refused_call(transformed_tableau<double, -1> (*)(...));
};

}  // namespace stagecraft::detail
