// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>

#include <stagecraft/jacobian/automatic.hpp>
#include <stagecraft/problem/unwritten.hpp>
#include <stagecraft/refuse/problem/checked_capabilities.hpp>

namespace stagecraft {

/// The sizes of the two parts of a state (a; b), both known at compile time or both at run time (-1).
template <int First, int Second>
struct part_sizes {
    static constexpr int first = First, second = Second;
    static constexpr bool fixed = First >= 0 && Second >= 0;
    static constexpr int size = fixed ? First + Second : Eigen::Dynamic;
    static_assert(fixed || (First == Eigen::Dynamic && Second == Eigen::Dynamic),
                  "the sizes of both parts must be known at compile time, or neither");
};

namespace detail {

/// Copies of the two parts of a state and of what a callable writes, in one scalar type.
template <class S, class Sizes>
struct part_copies {
    Eigen::Matrix<S, Sizes::first, 1> a, f;
    Eigen::Matrix<S, Sizes::second, 1> b, g;
    part_copies(int first, int second) : a(first), f(first), b(second), g(second) {}
};

/// Where the copies are kept. Fixed sizes: on the stack. Else in the problem, so that evaluating a problem
/// that is not const allocates nothing, with plain and with dual numbers.
template <class Sizes>
class part_storage {
  public:
    /// Throws std::invalid_argument for a negative size; the message begins with `what`.
    part_storage(int first, int second, const char* what)
        : first_(checked(first, what)), second_(checked(second, what)), kept_(make(first, second)) {}
    int first() const { return Sizes::fixed ? Sizes::first : first_; }
    int second() const { return Sizes::fixed ? Sizes::second : second_; }
    int size() const { return first() + second(); }

    template <class S>
    decltype(auto) get() {
        if constexpr (!Sizes::fixed && (std::is_same_v<S, double> || std::is_same_v<S, dual_number>))
            return (std::get<part_copies<S, Sizes>>(kept_));
        else
            return part_copies<S, Sizes>(first(), second());
    }
    template <class S>
    part_copies<S, Sizes> get() const {
        return part_copies<S, Sizes>(first(), second());
    }

  private:
    static int checked(int size, const char* what) {
        if (size < 0) throw std::invalid_argument(std::string(what) + ": sizes must not be negative");
        return size;
    }
    using dual_number = dual<double, Eigen::Dynamic>;
    using kept = std::conditional_t<Sizes::fixed, std::tuple<>,
                                    std::tuple<part_copies<double, Sizes>, part_copies<dual_number, Sizes>>>;
    static kept make(int first, int second) {
        if constexpr (Sizes::fixed)
            return {};
        else
            return kept(part_copies<double, Sizes>(first, second),
                        part_copies<dual_number, Sizes>(first, second));
    }
    int first_, second_;
    [[no_unique_address]] kept kept_;
};

/// A member jacobian(t, x, J) for a Problem that can write one (then write_jacobian(t, x, J) does), and none
/// for others, so that a jacobian is found by its name only where there is one.
template <class Problem, bool Exists>
struct optional_jacobian {};
template <class Problem>
struct optional_jacobian<Problem, true> {
    template <class S, class State, class Matrix>
    void jacobian(const S& t, const State& x, Matrix& J) const {
        static_cast<const Problem&>(*this).write_jacobian(t, x, J);
    }
};

/// The same of domain(t, x), which is within(t, x), and of break_points(), which are jumps().
template <class Problem, bool Exists>
struct optional_domain {};
template <class Problem>
struct optional_domain<Problem, true> {
    template <class T, class State>
    bool domain(const T& t, const State& x) const {
        return static_cast<const Problem&>(*this).within(t, x);
    }
};
template <class Problem, bool Exists>
struct optional_break_points {};
template <class Problem>
struct optional_break_points<Problem, true> {
    auto break_points() const { return static_cast<const Problem&>(*this).jumps(); }
};

template <class Dual, class S>
Dual constant_dual(const S& x) {
    Dual result;
    result.value() = x;
    result.derivatives().setZero();
    return result;
}

/// Writes the derivative of call(a, b) with respect to (a; b), taken at x in dual numbers, into the rows of
/// `result`.
template <class Sizes, class S, class Call, class State, class Rows>
void differentiate_parts(int first, int second, const State& x, int rows, Call&& call, Rows&& result) {
    using number = dual<S, Sizes::size>;
    constexpr int width = dual_width<Sizes::size>;
    const int all = first + second;
    Eigen::Matrix<number, Sizes::first, 1> a(first);
    Eigen::Matrix<number, Sizes::second, 1> b(second);
    for (int start = 0; start < all; start += width) {
        for (int i = 0; i < all; ++i) {
            number& part = i < first ? a[i] : b[i - first];
            part.value() = x[i];
            part.derivatives().setZero();
            if (i >= start && i < start + width) part.derivatives()[i - start] = S(1);
        }
        const auto out = call(a, b);
        for (int j = start; j < all && j < start + width; ++j)
            for (int i = 0; i < rows; ++i) result(i, j) = out[i].derivatives()[j - start];
    }
}

}  // namespace detail

}  // namespace stagecraft
