// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <type_traits>

#include <stagecraft/judge/evidence.hpp>
#include <stagecraft/judge/guards/growth_watch.hpp>
#include <stagecraft/linear/dense_blocks.hpp>

namespace stagecraft {

namespace detail {

/// True if stages of such a system are solved by dense blocks of run-time size.
template <class System>
inline constexpr bool in_dense_blocks = [] {
    if constexpr (requires { typename System::blocks; }) {
        using blocks = typename System::blocks;
        using usual = dense_blocks<typename System::scalar, System::size_at_compile_time>;
        constexpr int n = System::size_at_compile_time;
        return !System::structured && usual::built_in && (n < 0 || n > 16) &&
               (std::is_base_of_v<usual, blocks> || requires { typename blocks::whole; });
    } else {
        return false;
    }
}();

/// What solves the systems of the search for growth: where there are such blocks, one of them.
template <class Scalar, class System>
struct search_block {
    using type = split_lu<Scalar, -1>;
};
template <class Scalar, class System>
requires in_dense_blocks<System>
struct search_block<Scalar, System> {
    using type = typename System::blocks::real;
};

}  // namespace detail

/// Solutions that grow from less than the tolerance (an ignition, a flow that leaves an unstable rest): a step that would
/// pass over the growth is not tried but shortened to a quarter. Of 600 logistic ignitions from 1e-7 to 1e-12 it takes
/// those that stay at rest from 372 to 0. What is looked at, and what is not seen: growth_watch.hpp.
///
/// Cost: a comparison of signs for each factorisation, and a product J f where the step grows by half; a search where
/// nothing moves by more than the tolerance. 16 kB of machine code for a dense problem, which without<guards::growth>
/// (run/guarded.hpp) leaves out.
template <class System>
class growth_guard : public guard_defaults {
    using scalar = typename System::scalar;

  public:
    void linearised() { watch_.jacobian_changes(); }

    template <class Factored>
    bool forbids(const Factored& step) {
        return watch_.sees(step.system, step.stages, step.slope) ||
               (step.longer && watch_.sees_in(step.system, step.slope, step.norm.weights(), step.h));
    }
    template <class Bag>
    void carry(Bag& bag) {
        bag(watch_);
    }

  private:
    growth_watch<scalar, typename detail::search_block<scalar, System>::type> watch_;
};

}  // namespace stagecraft
