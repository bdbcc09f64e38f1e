// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <exception>
#include <stdexcept>
#include <utility>

#include <stagecraft/linear/norms.hpp>
#include <stagecraft/problem/capabilities.hpp>

// A state spread over processes (problem.add_up): how sums are made of it, and how all learn what happens on one.
// Everything here is empty for other problems.

namespace stagecraft {

/// The sums of a problem with add_up().
template <class Problem>
struct added_sums {
    static constexpr bool complete = false;
    Problem* problem;
    template <class Scalar>
    void operator()(Scalar* x, int k) const {
        problem->add_up(x, k);
    }
};

/// sums_over<scalar>(problem): what norms take for the states of a problem.
template <class Scalar, class Problem>
auto sums_over([[maybe_unused]] Problem& problem) {
    if constexpr (has_add_up<Problem, Scalar>)
        return added_sums<Problem>{&problem};
    else
        return complete_sums{};
}

/// What a process does of its own accord, between two sums, must not end its run alone: the others would wait for
/// it. An exception is kept until all processes ask for one another.
template <class Scalar, class Sums>
class shared_failure {
  public:
    /// Calls f() and keeps what it throws; the first of it, if there is more. (In other runs it passes through.)
    template <class F>
    void keep(F&& f) {
        try {
            f();
        } catch (...) {
            if (!thrown_) thrown_ = std::current_exception();
        }
    }
    /// True if something has been thrown here.
    bool here() const { return thrown_ != nullptr; }
    /// True if something has been thrown on another process. What has been thrown here leaves, once. To be called
    /// by all processes together; costs one sum.
    bool anywhere(const Sums& sums) {
        Scalar failed(here() ? 1 : 0);
        sums(&failed, 1);
        if (here()) std::rethrow_exception(std::exchange(thrown_, nullptr));
        return failed > Scalar(0);
    }

  private:
    std::exception_ptr thrown_;
};
template <class Scalar>
class shared_failure<Scalar, complete_sums> {
  public:
    template <class F>
    void keep(F&& f) {
        f();
    }
    static constexpr bool here() { return false; }
    static constexpr bool anywhere(const complete_sums&) { return false; }
};

/// What all processes together know of the state.
struct joint_state {
    int largest_index;  ///< of the flags 1, 2, 3
    int size;           ///< number of components
};

/// Stands at the beginning of what all processes construct together and each may find fault with for itself. If
/// it is destroyed before agree() has been called, then because an exception leaves: the others learn it.
template <class Scalar, class Sums>
class joint_start {
  public:
    explicit joint_start(const Sums& sums) : sums_(sums) {}
    joint_start(const joint_start&) = delete;
    joint_start& operator=(const joint_start&) = delete;
    ~joint_start() {
        if (!agreed_) add(Scalar(1), {});
    }
    /// From what is known here; std::invalid_argument where another process has left, or where `same`, of which
    /// fingerprint(same...) makes thirty-two bits, is not the same on all.
    template <class... Same>
    joint_state agree(const joint_state& here, const Same&... same) {
        const std::uint32_t bits = fingerprint(same...);
        agreed_ = true;
        return add(Scalar(0), here, bits);
    }

  private:
    static constexpr int bits_begin = 5, bits_end = bits_begin + 32;

    joint_state add(const Scalar& failed, const joint_state& here, std::uint32_t bits = 0) {
        Scalar part[bits_end] = {failed, Scalar(1), Scalar(here.largest_index == 2 ? 1 : 0),
                                 Scalar(here.largest_index == 3 ? 1 : 0), Scalar(here.size)};
        for (int k = bits_begin; k < bits_end; ++k) part[k] = Scalar((bits >> (k - bits_begin)) & 1U ? 1 : 0);
        sums_(part, bits_end);
        if (!agreed_) return here;
        if (part[0] > Scalar(0))
            throw std::invalid_argument("integrate: an argument has been refused on another process");
        for (int k = bits_begin; k < bits_end; ++k)
            if (part[k] > Scalar(0) && part[k] < part[1])
                throw std::invalid_argument(
                    "integrate: the method, t0, t1 and the options must be the same on all processes");
        return {part[3] > Scalar(0) ? 3 : part[2] > Scalar(0) ? 2 : 1, static_cast<int>(part[4])};
    }
    Sums sums_;
    bool agreed_ = false;
};
template <class Scalar>
class joint_start<Scalar, complete_sums> {
  public:
    explicit joint_start(const complete_sums&) {}
    template <class... Same>
    static constexpr joint_state agree(const joint_state& here, const Same&...) {
        return here;
    }
};

/// What all processes of a run say together.
enum class consent { go_on, stop, thrown };

/// Calls watch() on every process: stop where it returns false on one, thrown where it has thrown on another. What it
/// throws here leaves. Two sums.
template <class Scalar, class Sums, class F>
consent consent_of_all(const Sums& sums, F&& watch) {
    shared_failure<Scalar, Sums> failure;
    Scalar stops(0);
    failure.keep([&] { stops = Scalar(watch() ? 0 : 1); });
    if (failure.anywhere(sums)) return consent::thrown;
    sums(&stops, 1);
    return stops > Scalar(0) ? consent::stop : consent::go_on;
}

}  // namespace stagecraft
