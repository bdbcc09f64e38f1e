// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

#include <stagecraft/jacobian/dual_number.hpp>

namespace stagecraft {

/// The operations of one evaluation in reverse_numbers, in their order, with their slopes, for derivatives in the reverse
/// mode (Griewank and Walther, Evaluating Derivatives, chapter 3): x^T df/dz for all z at the cost of a few evaluations of
/// f, however many z there are. Memory: 24 bytes an operation.
template <class S>
class tape {
  public:
    /// Begins anew with so many variables, which are the first entries.
    void start(int variables) {
        variables_ = variables;
        entries_.assign(static_cast<std::size_t>(variables), {});
    }
    /// A result of one operation with these slopes by its operands; `second` may be none (negative). Returns its number.
    int record(int first, const S& by_first, int second, const S& by_second) {
        entries_.push_back({first, second, by_first, by_second});
        return static_cast<int>(entries_.size()) - 1;
    }

    /// Sets all adjoints to zero, seeds those of results, and carries them to the variables, of which adjoint(k) is that of
    /// number k then.
    void clear_adjoints() { adjoints_.assign(entries_.size(), S(0)); }
    void seed(int result, const S& adjoint) {
        if (result >= 0) adjoints_[static_cast<std::size_t>(result)] += adjoint;
    }
    void sweep() {
        for (std::size_t k = entries_.size(); k-- > static_cast<std::size_t>(variables_);) {
            const S a = adjoints_[k];
            if (a == S(0)) continue;  // what nothing depends on may have slopes that are not finite
            const entry& e = entries_[k];
            if (e.first >= 0) adjoints_[static_cast<std::size_t>(e.first)] += a * e.by_first;
            if (e.second >= 0) adjoints_[static_cast<std::size_t>(e.second)] += a * e.by_second;
        }
    }
    const S& adjoint(int variable) const { return adjoints_[static_cast<std::size_t>(variable)]; }

    /// The other way: where the variables move as set by tangent(k), after clear_adjoints(), a result moves by what push()
    /// leaves in tangent(result).
    S& tangent(int variable) { return adjoints_[static_cast<std::size_t>(variable)]; }
    void push() {
        for (std::size_t k = static_cast<std::size_t>(variables_); k < entries_.size(); ++k) {
            const entry& e = entries_[k];
            const auto moves = [&](int operand, const S& slope) {
                const S d = operand < 0 ? S(0) : adjoints_[static_cast<std::size_t>(operand)];
                return d == S(0) ? d : S(d * slope);  // the slope by what stands still may not be finite
            };
            adjoints_[k] = moves(e.first, e.by_first) + moves(e.second, e.by_second);
        }
    }

  private:
    struct entry {
        int first = -1, second = -1;
        S by_first{0}, by_second{0};
    };
    std::vector<entry> entries_;
    std::vector<S> adjoints_;
    int variables_ = 0;
};

/// A number that records what is done with it on a tape. As with dual_number, every operation returns a number and never an
/// expression, and plain numbers convert: to constants, which are on no tape. jacobian/reverse_functions.hpp has the
/// functions of <cmath>.
template <class S>
class reverse_number {
  public:
    using scalar = S;

    /// Constants.
    reverse_number() : value_(0) {}
    reverse_number(const S& value) : value_(value) {}
    template <class T>
    requires(std::is_arithmetic_v<T> && !std::is_same_v<T, S>) reverse_number(T value) : value_(S(value)) {}
    /// Variable or result `number` of a tape.
    reverse_number(const S& value, tape<S>* on, int number) : value_(value), on_(on), number_(number) {}

    /// The result of an operation with this value and these slopes by a and b.
    static reverse_number result(const S& value, const reverse_number& a, const S& by_a,
                                 const reverse_number& b, const S& by_b) {
        tape<S>* const on = a.on_ ? a.on_ : b.on_;
        return on ? reverse_number(value, on, on->record(a.number_, by_a, b.number_, by_b))
                  : reverse_number(value);
    }
    static reverse_number result(const S& value, const reverse_number& a, const S& by_a) {
        return result(value, a, by_a, reverse_number(), S(0));
    }

    const S& value() const { return value_; }
    /// Its place on the tape, negative where it is a constant.
    int number() const { return number_; }

    /// To an integer or a bool, which are constant between their jumps.
    template <class T>
    requires std::is_integral_v<T>
    explicit operator T() const { return static_cast<T>(value_); }

    reverse_number& operator+=(const reverse_number& b) { return *this = *this + b; }
    reverse_number& operator-=(const reverse_number& b) { return *this = *this - b; }
    reverse_number& operator*=(const reverse_number& b) { return *this = *this * b; }
    reverse_number& operator/=(const reverse_number& b) { return *this = *this / b; }

    friend reverse_number operator+(const reverse_number& a) { return a; }
    friend reverse_number operator-(const reverse_number& a) { return result(-a.value_, a, S(-1)); }
    friend reverse_number operator+(const reverse_number& a, const reverse_number& b) {
        return result(a.value_ + b.value_, a, S(1), b, S(1));
    }
    friend reverse_number operator-(const reverse_number& a, const reverse_number& b) {
        return result(a.value_ - b.value_, a, S(1), b, S(-1));
    }
    friend reverse_number operator*(const reverse_number& a, const reverse_number& b) {
        return result(a.value_ * b.value_, a, b.value_, b, a.value_);
    }
    friend reverse_number operator/(const reverse_number& a, const reverse_number& b) {
        const S value = a.value_ / b.value_;
        return result(value, a, S(1) / b.value_, b, -value / b.value_);
    }

    friend bool operator==(const reverse_number& a, const reverse_number& b) { return a.value_ == b.value_; }
    friend bool operator!=(const reverse_number& a, const reverse_number& b) { return a.value_ != b.value_; }
    friend bool operator<(const reverse_number& a, const reverse_number& b) { return a.value_ < b.value_; }
    friend bool operator>(const reverse_number& a, const reverse_number& b) { return a.value_ > b.value_; }
    friend bool operator<=(const reverse_number& a, const reverse_number& b) { return a.value_ <= b.value_; }
    friend bool operator>=(const reverse_number& a, const reverse_number& b) { return a.value_ >= b.value_; }

  private:
    S value_;
    tape<S>* on_ = nullptr;
    int number_ = -1;
};

/// A vector of them must arrive as what it is (unconverted.hpp), as one of dual numbers.
template <class S>
inline constexpr bool detail::is_dual<reverse_number<S>> = true;

}  // namespace stagecraft

/// That of the values.
template <class S>
struct std::numeric_limits<stagecraft::reverse_number<S>> : std::numeric_limits<S> {};

namespace Eigen {

template <class S>
struct NumTraits<stagecraft::reverse_number<S>> : NumTraits<typename NumTraits<S>::Real> {
    using Real = stagecraft::reverse_number<S>;
    using NonInteger = Real;
    using Nested = Real;
    using Literal = Real;
    enum { RequireInitialization = 1, ReadCost = 1, AddCost = 4, MulCost = 4 };
};
template <class S, class BinaryOp>
struct ScalarBinaryOpTraits<stagecraft::reverse_number<S>, S, BinaryOp> {
    using ReturnType = stagecraft::reverse_number<S>;
};
template <class S, class BinaryOp>
struct ScalarBinaryOpTraits<S, stagecraft::reverse_number<S>, BinaryOp> {
    using ReturnType = stagecraft::reverse_number<S>;
};
template <class S, class T, class BinaryOp>
requires(std::is_arithmetic_v<T> &&
         !std::is_same_v<S, T>) struct ScalarBinaryOpTraits<stagecraft::reverse_number<S>, T, BinaryOp> {
    using ReturnType = stagecraft::reverse_number<S>;
};
template <class S, class T, class BinaryOp>
requires(std::is_arithmetic_v<T> &&
         !std::is_same_v<S, T>) struct ScalarBinaryOpTraits<T, stagecraft::reverse_number<S>, BinaryOp> {
    using ReturnType = stagecraft::reverse_number<S>;
};

}  // namespace Eigen
