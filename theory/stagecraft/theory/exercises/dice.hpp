// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "stagecraft/tableaux/rational.hpp"

namespace stagecraft::theory {

using tableaux::rational;

/// Random choices that are the same on every machine for the same seed: the engine's output is fixed by the standard,
/// those of the standard's distributions are not.
class dice {
  public:
    explicit dice(std::uint64_t seed) : engine_(seed) {}

    /// low, ..., high, each as likely as the others to 2^-60.
    int between(int low, int high) {
        return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
    }
    bool coin() { return between(0, 1) == 1; }
    template <class T>
    const T& pick(const std::vector<T>& from) {
        return from[static_cast<std::size_t>(between(0, static_cast<int>(from.size()) - 1))];
    }
    /// A number from -most to most, not 0.
    int not_zero(int most) { return between(1, most) * (coin() ? 1 : -1); }
    /// A node in (0, 1] as textbooks like them.
    rational node() {
        static const std::vector<rational> all{{1, 4}, {1, 3}, {2, 5}, {1, 2}, {3, 5}, {2, 3}, {3, 4}, 1};
        return pick(all);
    }

  private:
    std::mt19937_64 engine_;
};

}  // namespace stagecraft::theory
