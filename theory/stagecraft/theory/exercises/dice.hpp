// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "stagecraft/tableaux/rational.hpp"

namespace stagecraft::theory {

using tableaux::rational;

/// Random choices that are the same on every machine for the same seed: the engine's output is fixed by the standard,
/// those of the standard's distributions are not. Two choices are two statements: compilers differ in which argument
/// of a call comes first.
class dice {
  public:
    explicit dice(std::uint64_t seed) : engine_(seed) {}

    /// low, ..., high, each as likely as the others to 2^-60.
    int between(int low, int high);
    bool coin() { return between(0, 1) == 1; }
    template <class T>
    const T& pick(const std::vector<T>& from) {
        return from[static_cast<std::size_t>(between(0, static_cast<int>(from.size()) - 1))];
    }
    /// A number from -most to most, not 0.
    int not_zero(int most) {
        const int size = between(1, most);
        return coin() ? size : -size;
    }
    /// A node in (0, 1] as textbooks like them.
    rational node();

  private:
    std::mt19937_64 engine_;
};

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/exercises/dice-inl.hpp"
#endif
