// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <type_traits>
#include <utility>

namespace stagecraft {

/// The scalars that the processor knows: their loops are written in packets and inlined to the last call. With
/// wide ones, where every operation is a function itself, that would only cost the compiler minutes.
template <class Scalar>
inline constexpr bool built_in = std::is_floating_point_v<Scalar>;

/// As many numbers as one instruction of the processor adds or multiplies. The hot loops are written in these
/// packets, so that they do not wait for a compiler to vectorise loops of run-time length, which g++ does at
/// -O3 only; Eigen knows them for every platform.
template <class Scalar>
struct packet {
    using type = typename Eigen::internal::packet_traits<Scalar>::type;
    static constexpr int size = Eigen::internal::unpacket_traits<type>::size;
    static type load(const Scalar* x) { return Eigen::internal::ploadu<type>(x); }
    /// The same of numbers that have just been written one by one, and are read so: a packet would wait until all its
    /// numbers have reached the cache.
    [[gnu::always_inline]] static type load_written(const Scalar* x) {
        return gather(x, std::make_integer_sequence<int, size>());
    }
    static type all(const Scalar& x) { return Eigen::internal::pset1<type>(x); }
    static void store(Scalar* x, const type& v) { Eigen::internal::pstoreu(x, v); }
    static Scalar sum(const type& v) { return Eigen::internal::predux(v); }
    static type one_if_zero(const type& v) {
        return Eigen::internal::pand(Eigen::internal::pcmp_eq(v, all(Scalar(0))), all(Scalar(1)));
    }

  private:
    static Scalar read(const Scalar& x) { return const_cast<const volatile Scalar&>(x); }
    template <int... q>
    static type gather(const Scalar* x, std::integer_sequence<int, q...>) {
        if constexpr (size == 1)
            return read(*x);
        else
            return type{read(x[q])...};
    }
};
/// A single number with the interface of a packet, for the remainder of a loop.
template <class Scalar>
struct single {
    using type = Scalar;
    static constexpr int size = 1;
    static type load(const Scalar* x) { return *x; }
    static type all(const Scalar& x) { return x; }
    static void store(Scalar* x, const type& v) { *x = v; }
    static Scalar sum(const type& v) { return v; }
    static type one_if_zero(const type& v) { return v == Scalar(0) ? Scalar(1) : Scalar(0); }
};

/// A number in each of a few lanes, worked on in packets as Eigen::Array<Scalar, Lanes, 1> is; its operations have no types
/// of their own, which take a program of ten lines a tenth of its compile time.
template <class Scalar, int Lanes>
class number_per_lane {
    using part = typename Eigen::internal::find_best_packet<Scalar, Lanes>::type;
    static constexpr int size = Eigen::internal::unpacket_traits<part>::size;

  public:
    static number_per_lane all(const Scalar& x) {
        number_per_lane r;
        for (int l = 0; l < Lanes; l += size) r.put(l, Eigen::internal::pset1<part>(x));
        return r;
    }
    Scalar& operator[](int l) { return x_[l]; }
    const Scalar& operator[](int l) const { return x_[l]; }

    friend number_per_lane operator+(const number_per_lane& a, const number_per_lane& b) {
        number_per_lane r;
        for (int l = 0; l < Lanes; l += size) r.put(l, Eigen::internal::padd(a.at(l), b.at(l)));
        return r;
    }
    friend number_per_lane operator-(const number_per_lane& a, const number_per_lane& b) {
        number_per_lane r;
        for (int l = 0; l < Lanes; l += size) r.put(l, Eigen::internal::psub(a.at(l), b.at(l)));
        return r;
    }
    friend number_per_lane operator*(const number_per_lane& a, const number_per_lane& b) {
        number_per_lane r;
        for (int l = 0; l < Lanes; l += size) r.put(l, Eigen::internal::pmul(a.at(l), b.at(l)));
        return r;
    }
    friend number_per_lane operator*(const Scalar& a, const number_per_lane& b) { return all(a) * b; }
    friend number_per_lane operator/(const number_per_lane& a, const number_per_lane& b) {
        number_per_lane r;
        for (int l = 0; l < Lanes; l += size) r.put(l, Eigen::internal::pdiv(a.at(l), b.at(l)));
        return r;
    }
    number_per_lane& operator+=(const number_per_lane& b) { return *this = *this + b; }
    number_per_lane& operator-=(const number_per_lane& b) { return *this = *this - b; }
    /// Becomes the larger one, in each lane.
    void raise(const number_per_lane& b) {
        for (int l = 0; l < Lanes; l += size) put(l, Eigen::internal::pmax(b.at(l), at(l)));
    }
    number_per_lane abs() const {
        number_per_lane r;
        for (int l = 0; l < Lanes; l += size) r.put(l, Eigen::internal::pabs(at(l)));
        return r;
    }

  private:
    part at(int l) const { return Eigen::internal::pload<part>(x_ + l); }
    void put(int l, const part& v) { Eigen::internal::pstore(x_ + l, v); }

    alignas(part) Scalar x_[Lanes];
};

}  // namespace stagecraft
