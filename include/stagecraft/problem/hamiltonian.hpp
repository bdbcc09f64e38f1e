// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include <stagecraft/jacobian/dual_functions.hpp>
#include <stagecraft/jacobian/dual_number.hpp>
#include <stagecraft/jacobian/unconverted.hpp>
#include <stagecraft/owned_value.hpp>
#include <stagecraft/problem/partition.hpp>
#include <stagecraft/refuse/detect/refused_call.hpp>

namespace stagecraft {

namespace detail {

/// An energy of these vectors, with t before them or without.
template <class Energy, class T, class... Parts>
constexpr bool takes_vectors() {
    if constexpr (std::is_invocable_v<const Energy&, const Parts&...>)
        return !converts_duals<const Energy, const Parts&...>();
    else if constexpr (std::is_invocable_v<const Energy&, const T&, const Parts&...>)
        return !converts_duals<const Energy, const T&, const Parts&...>();
    else
        return false;
}
template <class Energy, class T, class... Parts>
inline constexpr bool is_energy_of = takes_vectors<Energy, T, Parts...>();

template <class Energy, class T, class... Parts>
auto energy_value(const Energy& energy, [[maybe_unused]] const T& t, const Parts&... parts) {
    if constexpr (std::is_invocable_v<const Energy&, const Parts&...>)
        return energy(parts...);
    else
        return energy(t, parts...);
}

/// The numbers in which an energy of n coordinates is differentiated: all directions at once where they are few.
template <class S, int N>
using energy_dual = dual_number<S, (N <= 16 ? N : 8)>;
template <class S, int N>
using energy_vector = Eigen::Matrix<energy_dual<S, N>, N, 1>;

/// Calls take(i, dE/dx_i) for the N components of x, E = energy(x in duals). ceil(N / 8) evaluations above 16.
template <int N, class S, class Energy, class Take>
void differentiate(const Energy& energy, const Eigen::Matrix<S, N, 1>& x, Take&& take) {
    constexpr int width = N <= 16 ? N : 8;
    energy_vector<S, N> moving;
    for (int i = 0; i < N; ++i) moving[i] = energy_dual<S, N>(x[i]);
    for (int first = 0; first < N; first += width) {
        for (int k = 0; k < width && first + k < N; ++k) moving[first + k].derivatives()[k] = S(1);
        const energy_dual<S, N> value(energy(moving));
        for (int k = 0; k < width && first + k < N; ++k) {
            take(first + k, value.derivatives()[k]);
            moving[first + k].derivatives()[k] = S(0);
        }
    }
}

template <int N, class Vector>
void demand_size(const Vector& x, int size) {
    if (x.size() != size)
        throw bad_problem("hamiltonian<" + std::to_string(N) + ">: the state (q, p) must have " +
                          std::to_string(2 * N) + " components, and there are " +
                          std::to_string(size == N ? 2 * x.size() : x.size()));
}

template <int N, class Vector>
inline constexpr bool fits_half = int(Vector::RowsAtCompileTime) == Eigen::Dynamic ||
                                  int(Vector::RowsAtCompileTime) == N;

}  // namespace detail

/// q' = dH/dp, p' = -dH/dq for H(q, p) or H(t, q, p). Made by hamiltonian<N>(H).
template <int N, class Energy>
class hamiltonian_problem {
  public:
    explicit hamiltonian_problem(Energy H) : H_(std::move(H)) {}

    template <class>
    static constexpr bool separable = false;

    template <class T, class Y, class Out>
    void operator()(const T& t, const Y& y, Out& out) const {
        using S = typename Y::Scalar;
        constexpr bool size = detail::fits_half<2 * N, Y>;
        static_assert(size || detail::is_dual<S>, "hamiltonian<n>: y0 = (q, p) must have 2 n components");
        if constexpr (size) {
            detail::demand_size<N>(y, 2 * N);
            const Eigen::Matrix<S, 2 * N, 1> x = y;
            const auto energy = [&](const auto& both) {
                using D = typename std::remove_cvref_t<decltype(both)>::Scalar;
                const Eigen::Matrix<D, N, 1> q = both.template head<N>(), p = both.template tail<N>();
                return detail::energy_value(H_, t, q, p);
            };
            detail::differentiate<2 * N, S>(energy, x, [&](int i, const S& slope) {
                if (i < N)
                    out[N + i] = -slope;
                else
                    out[i - N] = slope;
            });
        }
    }

    /// H at (t, y).
    template <class Y>
    auto energy(const typename Y::Scalar& t, const Y& y) const {
        detail::demand_size<N>(y, 2 * N);
        using part = Eigen::Matrix<typename Y::Scalar, N, 1>;
        return detail::energy_value(H_, t, part(y.head(N)), part(y.tail(N)));
    }

  private:
    Energy H_;
};

/// q' = dT/dp, p' = -dV/dq for T(p) and V(q), or T(t, p) and V(t, q). Made by hamiltonian<N>(T, V).
template <int N, class Kinetic, class Potential>
class separable_hamiltonian_problem {
  public:
    separable_hamiltonian_problem(Kinetic T, Potential V) : T_(std::move(T)), V_(std::move(V)) {}

    template <class>
    static constexpr bool separable = true;

    template <class T, class Part>
    void q_rate(const T& t, const Part& p, Part& out) const {
        gradient(T_, t, p, out, [](const auto& slope) { return slope; });
    }
    template <class T, class Part>
    void p_rate(const T& t, const Part& q, Part& out) const {
        gradient(V_, t, q, out, [](const auto& slope) { return -slope; });
    }
    template <class T, class Y, class Out>
    void operator()(const T& t, const Y& y, Out& out) const {
        using S = typename Y::Scalar;
        using part = Eigen::Matrix<S, N, 1>;
        constexpr bool size = detail::fits_half<2 * N, Y>;
        static_assert(size || detail::is_dual<S>, "hamiltonian<n>: y0 = (q, p) must have 2 n components");
        if constexpr (size) {
            detail::demand_size<N>(y, 2 * N);
            const part q = y.head(N), p = y.tail(N);
            part rate;
            q_rate(t, p, rate);
            out.head(N) = rate;
            p_rate(t, q, rate);
            out.tail(N) = rate;
        }
    }

    /// T + V at (t, y).
    template <class Y>
    auto energy(const typename Y::Scalar& t, const Y& y) const {
        detail::demand_size<N>(y, 2 * N);
        using part = Eigen::Matrix<typename Y::Scalar, N, 1>;
        return detail::energy_value(T_, t, part(y.tail(N))) + detail::energy_value(V_, t, part(y.head(N)));
    }

  private:
    template <class Energy, class T, class Part, class Sign>
    static void gradient(const Energy& energy, const T& t, const Part& x, Part& out, const Sign& sign) {
        using S = typename Part::Scalar;
        static_assert(detail::fits_half<N, Part>, "hamiltonian<n>: y0 = (q, p) must have 2 n components");
        detail::demand_size<N>(x, N);
        const Eigen::Matrix<S, N, 1> at = x;
        detail::differentiate<N, S>(
            [&](const auto& moving) { return detail::energy_value(energy, t, moving); }, at,
            [&](int i, const S& slope) { out[i] = sign(slope); });
    }
    Kinetic T_;
    Potential V_;
};

namespace detail {

/// What hamiltonian<N>() was given; `usable` where all is as it says.
template <int N, class... Energies>
struct given_energies_of_pair {
    static constexpr bool callable = false, number = true;
};
template <class Energy, class... Parts>
constexpr bool is_of_number() {
    if constexpr (is_energy_of<Energy, double, Parts...>)
        return owned_number<decltype(energy_value(std::declval<const Energy&>(), 0.0,
                                                  std::declval<const Parts&>()...))>;
    else
        return true;
}
template <int N, class H>
requires(N > 0) struct given_energies_of_pair<N, H> {
    using part = Eigen::Matrix<energy_dual<double, 2 * N>, N, 1>;
    static constexpr bool callable = is_energy_of<H, double, part, part>,
                          number = is_of_number<H, part, part>();
};
template <int N, class T, class V>
requires(N > 0) struct given_energies_of_pair<N, T, V> {
    using part = energy_vector<double, N>;
    static constexpr bool callable = is_energy_of<T, double, part> && is_energy_of<V, double, part>,
                          number = is_of_number<T, part>() && is_of_number<V, part>();
};
template <int N, class... Energies>
inline constexpr bool usable_energies =
    N > 0 &&
    given_energies_of_pair<N, Energies...>::callable&& given_energies_of_pair<N, Energies...>::number;

}  // namespace detail

/// The problem q' = dH/dp, p' = -dH/dq of N coordinates q and momenta p from the energy alone, H(q, p) or H(t, q, p), a
/// generic callable on Eigen vectors of N components that returns a number:
///
///     hamiltonian<2>([](const auto& q, const auto& p) { return p.squaredNorm() / 2 - 1 / q.norm(); })
///
/// Gradients are taken by automatic differentiation, exact to rounding: one evaluation of H in dual numbers of 2 N
/// directions (beyond 16, eight at a time). The state is y = (q, p) of 2 N components, of fixed size or not; another size is
/// bad_problem (std::invalid_argument). `energy(t, y)` is H.
template <int N, class Energy>
requires(detail::usable_energies<N, Energy>) hamiltonian_problem<N, Energy> hamiltonian(Energy H) {
    return hamiltonian_problem<N, Energy>(std::move(H));
}
/// The same for a separable energy T(p) + V(q), or T(t, p) + V(t, q): explicit with the pairs that split it
/// (Stoermer-Verlet, symplectic Euler, Ruth, Forest-Ruth). A force costs one evaluation of V in N directions.
template <int N, class Kinetic, class Potential>
requires(detail::usable_energies<N, Kinetic, Potential>)
    separable_hamiltonian_problem<N, Kinetic, Potential> hamiltonian(Kinetic T, Potential V) {
    return {std::move(T), std::move(V)};
}

/// Of energies that cannot be used.
template <int N, class First, class... Second>
requires(!detail::usable_energies<N, First, Second...>)
    partition_problem<First, First> hamiltonian(const First& first, const Second&...) {
    using given = detail::given_energies_of_pair<N, First, Second...>;
    static_assert(N > 0, "hamiltonian<n>: n, the number of coordinates, must be positive");
    static_assert(
        N <= 0 || given::callable,
        "hamiltonian<n>: write hamiltonian<n>(H) with H(q, p) or H(t, q, p), or hamiltonian<n>(T, V) with "
        "T(p) "
        "and V(q), or with t before them, all callable with vectors of n numbers of any type, as they are "
        "differentiated automatically: [](const auto& q, const auto& p) { ... }");
    static_assert(N <= 0 || !given::callable || given::number,
                  "hamiltonian<n>: an energy must return a number, not a matrix or product of Eigen's: write "
                  "p.dot(M * p) / 2");
    return {first, first};
}
/// The number is missing.
template <class First, class... Second>
partition_problem<First, First> hamiltonian(const First& first, const Second&...) {
    static_assert(detail::never<First>,
                  "hamiltonian<n>(H) or hamiltonian<n>(T, V): give n, the number of coordinates");
    return {first, first};
}

}  // namespace stagecraft
