// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stdexcept>
#include <string>

#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/lobatto_iiia.hpp>
#include <stagecraft/coefficients/lobatto_iiib.hpp>
#include <stagecraft/coefficients/lobatto_iiic.hpp>
#include <stagecraft/coefficients/radau_ia.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>

namespace stagecraft {

namespace detail {

template <int Stages>
tableau<double> run_time_stages(const tableau<double, Stages>& m) {
    tableau<double> r;
    r.A = m.A;
    r.b = m.b;
    r.c = m.c;
    r.facts = m.facts;
    return r;
}
template <int Stages>
transformed_tableau<double> run_time_stages(const transformed_tableau<double, Stages>& m) {
    transformed_tableau<double> r;
    static_cast<tableau<double>&>(r) = run_time_stages(static_cast<const tableau<double, Stages>&>(m));
    r.A_inverse = m.A_inverse;
    r.gamma = m.gamma;
    r.alpha = m.alpha;
    r.beta = m.beta;
    r.T = m.T;
    r.T_inverse = m.T_inverse;
    return r;
}

/// make<S>() for S = stages, of the sizes First, First + 1, ... as long as Data<S> has been generated.
template <template <int> class Data, int First, class Make>
auto by_stages(const char* family, int stages, Make make, int least = First) {
    if (stages == First) return run_time_stages(make.template operator()<First>());
    if constexpr (requires { sizeof(Data<First + 1>); })
        return by_stages<Data, First + 1>(family, stages, make, least);
    else
        throw std::invalid_argument(std::string(family) + ": stages must be between " +
                                    std::to_string(least) + " and " + std::to_string(First) +
                                    "; stagecraft/tableaux/rounded.hpp makes methods of more");
}

}  // namespace detail

/// The Radau IIA method of a number of stages that is known at run time, with the coefficients of radau_iia<S>(). Throws
/// std::invalid_argument that names the sizes there are. Where the number is known at compile time the template
/// is faster, as its steps are unrolled. The other five families likewise:
inline transformed_tableau<double> radau_iia(int stages) {
    return detail::by_stages<coefficients::radau_iia, 1>("radau_iia", stages,
                                                         []<int S>() { return radau_iia<S>(); });
}
/// Radau IA, one stage or more.
inline transformed_tableau<double> radau_ia(int stages) {
    return detail::by_stages<coefficients::radau_ia, 1>("radau_ia", stages,
                                                        []<int S>() { return radau_ia<S>(); });
}
/// Gauss, one stage or more.
inline transformed_tableau<double> gauss(int stages) {
    return detail::by_stages<coefficients::gauss, 1>("gauss", stages, []<int S>() { return gauss<S>(); });
}
/// Lobatto IIIC, two stages or more.
inline transformed_tableau<double> lobatto_iiic(int stages) {
    return detail::by_stages<coefficients::lobatto_iiic, 2>("lobatto_iiic", stages,
                                                            []<int S>() { return lobatto_iiic<S>(); });
}
/// Lobatto IIIA, two stages or more; A is singular and has no transformed form.
inline tableau<double> lobatto_iiia(int stages) {
    return detail::by_stages<coefficients::lobatto_iiia, 2>("lobatto_iiia", stages,
                                                            []<int S>() { return lobatto_iiia<S>(); });
}
/// Lobatto IIIB, likewise.
inline tableau<double> lobatto_iiib(int stages) {
    return detail::by_stages<coefficients::lobatto_iiib, 2>("lobatto_iiib", stages,
                                                            []<int S>() { return lobatto_iiib<S>(); });
}

}  // namespace stagecraft
