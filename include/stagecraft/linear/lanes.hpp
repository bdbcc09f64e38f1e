// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <utility>

#include <stagecraft/linear/packet.hpp>

namespace stagecraft {

/// So many numbers, or fewer, are kept in registers while several vectors of them are summed.
template <int N>
inline constexpr bool fits_lanes = 0 < N&& N <= 16;

/// N numbers in registers: as many packets as they fill, and the rest one by one; up to three all one by one, as f
/// takes them.
template <class Scalar, int N>
requires(built_in<Scalar>) class lanes {
    using P = packet<Scalar>;
    static constexpr int whole = N < 4 ? 0 : N / P::size, rest = N - whole * P::size;
    template <int... p>
    using packs = std::integer_sequence<int, p...>;
    static constexpr std::make_integer_sequence<int, whole> all_packets{};
    static constexpr std::make_integer_sequence<int, rest> all_numbers{};

  public:
    [[gnu::always_inline]] static lanes load(const Scalar* x) { return load(x, all_packets, all_numbers); }
    /// packet::load_written() of all.
    [[gnu::always_inline]] static lanes load_written(const Scalar* x) {
        return load_written(x, all_packets, all_numbers);
    }
    [[gnu::always_inline]] void store(Scalar* out) const { store(out, all_packets, all_numbers); }
    /// Adds c x.
    [[gnu::always_inline]] void add(const Scalar& c, const lanes& x) { add(c, x, all_packets, all_numbers); }
    [[gnu::always_inline]] void add(const Scalar& c, const Scalar* x) { add(c, load(x)); }
    [[gnu::always_inline]] bool finite() const { return finite(all_packets, all_numbers); }

  private:
    template <int... p, int... i>
    [[gnu::always_inline]] static lanes load(const Scalar* x, packs<p...>, packs<i...>) {
        lanes r;
        ((r.packets_[p] = P::load(x + p * P::size)), ...);
        ((r.numbers_[i] = x[N - rest + i]), ...);
        return r;
    }
    template <int... p, int... i>
    [[gnu::always_inline]] static lanes load_written(const Scalar* x, packs<p...>, packs<i...>) {
        lanes r;
        ((r.packets_[p] = P::load_written(x + p * P::size)), ...);
        ((r.numbers_[i] = x[N - rest + i]), ...);
        return r;
    }
    template <int... p, int... i>
    [[gnu::always_inline]] void store(Scalar* out, packs<p...>, packs<i...>) const {
        (P::store(out + p * P::size, packets_[p]), ...);
        ((out[N - rest + i] = numbers_[i]), ...);
    }
    template <int... p, int... i>
    [[gnu::always_inline]] void add(const Scalar& c, const lanes& x, packs<p...>, packs<i...>) {
        [[maybe_unused]] const auto by = P::all(c);
        ((packets_[p] = packets_[p] + x.packets_[p] * by), ...);
        ((numbers_[i] = numbers_[i] + x.numbers_[i] * c), ...);
    }
    template <int... p, int... i>
    [[gnu::always_inline]] bool finite(packs<p...>, packs<i...>) const {
        Scalar sum = (Scalar(0) + ... + numbers_[i]);
        if constexpr (whole > 0) sum += P::sum((... + packets_[p]));
        if (sum - sum == Scalar(0)) return true;  // else it may be no more than the sum that has overflowed
        sum = (Scalar(0) + ... + (numbers_[i] - numbers_[i]));
        if constexpr (whole > 0) sum += P::sum((... + (packets_[p] - packets_[p])));
        return sum == Scalar(0);
    }

    typename P::type packets_[whole > 0 ? whole : 1];
    Scalar numbers_[rest > 0 ? rest : 1];
};

}  // namespace stagecraft
