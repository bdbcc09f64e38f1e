// SPDX-License-Identifier: BSL-1.0
#include <stagecraft/problem/regularised.hpp>

#include "../rolling_disc/disc.hpp"
#include "solve.hpp"

namespace thesis {

namespace {

using rolling_disc::disc;
using vector5 = Eigen::Matrix<double, 5, 1>;

const vector5 q0 = rolling_disc::initial_position(), v0 = rolling_disc::initial_velocity();

template <class Problem>
setup wrapped(const Problem& problem, const Eigen::Vector2d& offset) {
    const Eigen::Vector2d lambda = stagecraft::consistent_multiplier(disc<>(), q0, v0) + offset;
    return {erased(problem), problem.initial_state(q0, v0, lambda),
            [problem](const vector& y) -> Eigen::Vector2d { return problem.multiplier(y); }};
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

setup disc_dae() {
    const auto dae = stagecraft::index_2(disc<>());
    return {erased(dae), dae.initial_state(q0, v0),
            [](const vector& y) -> Eigen::Vector2d { return y.tail<2>(); }};
}

setup disc_reduced() {
    const auto ode = stagecraft::index_reduced(disc<>());
    vector y0(10);
    y0 << q0, v0;
    return {erased(ode), y0, [ode](const vector& y) -> Eigen::Vector2d {
                return ode.multiplier<double>(y.head<5>(), y.tail<5>(), 0.0);
            }};
}

setup disc_regularised(form f, double eps, double kappa, const Eigen::Vector2d& offset) {
    const disc<> body;
    switch (f) {
        case form::multiplier:
            return wrapped(stagecraft::regularised_multiplier_form(body, eps, kappa, 2.0, 2.0), offset);
        case form::creep:
            return wrapped(stagecraft::regularised_creep_form(body, eps, kappa, 2.0, 2.0), offset);
        case form::transformed:
            return wrapped(stagecraft::principal_damping_transformed(body, eps, 2.0, 2.0), offset);
        case form::mass_matrix:
            break;
    }
    return wrapped(stagecraft::regularised(body, eps, kappa, 2.0, 2.0), offset);
}

double disc_energy(const vector& y) {
    return stagecraft::total_energy<double>(disc<>(), y.head<5>(), y.segment<5>(5));
}

double disc_kinetic_energy(const vector& y) {
    return stagecraft::kinetic_energy<double>(disc<>(), y.head<5>(), y.segment<5>(5));
}

Eigen::Vector2d disc_constraint(const vector& y) {
    const vector5 q = y.head<5>(), v = y.segment<5>(5);
    return disc<>().G(q) * v;
}

}  // namespace thesis
