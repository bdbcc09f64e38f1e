// SPDX-License-Identifier: BSL-1.0
#include <stagecraft/mechanics/regularisation/regularisation_error.hpp>
#include <stagecraft/mechanics/regularisation/regularised.hpp>
#include <stdexcept>
#include <type_traits>

#include "../rolling_disc/disc.hpp"
#include "solve.hpp"

namespace thesis {

namespace {

using rolling_disc::disc;

template <class Scalar, class Problem>
setup_of<Scalar> wrapped(const Problem& problem, const Eigen::Matrix<Scalar, 2, 1>& offset) {
    const auto q = rolling_disc::initial_position<Scalar>();
    const auto v = rolling_disc::initial_velocity<Scalar>();
    const Eigen::Matrix<Scalar, 2, 1> lambda =
        stagecraft::consistent_multiplier<Scalar>(disc<Scalar>(), q, v) + offset;
    return {erased<Scalar>(problem), problem.initial_state(q, v, lambda),
            [problem](const vector_of<Scalar>& y) { return problem.multiplier(y); }};
}

}  // namespace

const char* name(form f) {
    switch (f) {
        case form::mass_matrix:
            return "mass-matrix form";
        case form::multiplier:
            return "(y, lambda)";
        case form::creep:
            return "(y, z)";
        case form::transformed:
            return "transformed (3.60)";
    }
    return "";
}

template <class Scalar>
setup_of<Scalar> disc_dae() {
    const auto dae = stagecraft::index_2<Scalar>(disc<Scalar>());
    return {
        erased<Scalar>(dae),
        dae.initial_state(rolling_disc::initial_position<Scalar>(), rolling_disc::initial_velocity<Scalar>()),
        [](const vector_of<Scalar>& y) { return Eigen::Matrix<Scalar, 2, 1>(y.template tail<2>()); }};
}
template setup_of<double> disc_dae();
template setup_of<long double> disc_dae();

setup disc_reduced() {
    const auto ode = stagecraft::index_reduced(disc<>());
    vector y0(10);
    y0 << rolling_disc::initial_position(), rolling_disc::initial_velocity();
    return {erased(ode), y0, [ode](const vector& y) -> Eigen::Vector2d {
                return ode.multiplier<double>(y.head<5>(), y.tail<5>(), 0.0);
            }};
}

template <class Scalar>
setup_of<Scalar> disc_regularised(form f, Scalar eps, Scalar kappa, const Eigen::Matrix<Scalar, 2, 1>& offset,
                                  Scalar c, Scalar d) {
    const disc<Scalar> body;
    if constexpr (std::is_same_v<Scalar, double>) {  // the other forms are compared in double only
        if (f == form::multiplier)
            return wrapped<Scalar>(stagecraft::regularised_multiplier_form(body, eps, kappa, c, d), offset);
        if (f == form::creep)
            return wrapped<Scalar>(stagecraft::regularised_creep_form(body, eps, kappa, c, d), offset);
        if (f == form::transformed)
            return wrapped<Scalar>(stagecraft::principal_damping_transformed(body, eps, c, d), offset);
    }
    if (f != form::mass_matrix) throw std::invalid_argument("disc_regularised: this form is for double");
    return wrapped<Scalar>(stagecraft::regularised(body, eps, kappa, c, d), offset);
}
template setup_of<double> disc_regularised(form, double, double, const Eigen::Matrix<double, 2, 1>&, double,
                                           double);
template setup_of<long double> disc_regularised(form, long double, long double,
                                                const Eigen::Matrix<long double, 2, 1>&, long double,
                                                long double);

std::vector<correction> disc_correction(double c, const std::vector<double>& times) {
    std::vector<correction> result;
    for (const auto& term : stagecraft::regularisation_error(disc<>(), rolling_disc::initial_position(),
                                                             rolling_disc::initial_velocity(), c, times))
        result.push_back({term.t, term.Y, term.Lambda});
    return result;
}

double disc_energy(const vector& y) {
    return stagecraft::total_energy<double>(disc<>(), y.head<5>(), y.segment<5>(5));
}

double disc_kinetic_energy(const vector& y) {
    return stagecraft::kinetic_energy<double>(disc<>(), y.head<5>(), y.segment<5>(5));
}

template <class Scalar>
Eigen::Matrix<Scalar, 2, 1> disc_constraint(const vector_of<Scalar>& y) {
    const Eigen::Matrix<Scalar, 5, 1> q = y.template head<5>(), v = y.template segment<5>(5);
    return disc<Scalar>().G(q) * v;
}
template Eigen::Vector2d disc_constraint(const vector&);
template Eigen::Matrix<long double, 2, 1> disc_constraint(const vector_of<long double>&);

}  // namespace thesis
