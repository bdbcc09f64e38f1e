// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <type_traits>

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
    static type all(const Scalar& x) { return Eigen::internal::pset1<type>(x); }
    static void store(Scalar* x, const type& v) { Eigen::internal::pstoreu(x, v); }
    static Scalar sum(const type& v) { return Eigen::internal::predux(v); }
    static type one_if_zero(const type& v) {
        return Eigen::internal::pand(Eigen::internal::pcmp_eq(v, all(Scalar(0))), all(Scalar(1)));
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

}  // namespace stagecraft
