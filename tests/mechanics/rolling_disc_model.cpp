// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE rolling_disc_model
#include <Eigen/Cholesky>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <stagecraft/mechanics/formulations.hpp>
#include <string>

#include <problems/rolling_disc/disc.hpp>

using namespace stagecraft;
using rolling_disc::disc;
using vector5 = Eigen::Matrix<double, 5, 1>;
using wide =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<40>, boost::multiprecision::et_off>;

namespace {

vector5 random_vector(std::mt19937& engine) {
    std::uniform_real_distribution<double> uniform(-1.2, 1.2);
    vector5 v;
    for (int i = 0; i < 5; ++i) v[i] = uniform(engine);
    return v;
}

// A velocity that obeys the constraint: x' and y' follow from the other three.
vector5 rolling_velocity(const vector5& q, vector5 v, double R) {
    v[0] = R * v[4] + q[1] * v[2];
    v[1] = -q[0] * v[2];
    return v;
}

// The disc without its closed forms: M is factored, G differentiated.
struct plain_disc {
    static constexpr int coordinates = 5, constraints = 2;
    disc<> body;
    template <class S>
    auto M(const Eigen::Matrix<S, 5, 1>& q) const {
        return body.M(q);
    }
    template <class S>
    auto F(const Eigen::Matrix<S, 5, 1>& q, const Eigen::Matrix<S, 5, 1>& v) const {
        return body.F(q, v);
    }
    template <class S>
    auto G(const Eigen::Matrix<S, 5, 1>& q) const {
        return body.G(q);
    }
};

// Counts how often M is asked for.
struct counting : plain_disc {
    int* count = nullptr;
    template <class S>
    auto M(const Eigen::Matrix<S, 5, 1>& q) const {
        ++*count;
        return body.M(q);
    }
};

// Power v^T M' v/2 + v^T M a + dV/dt by central differences of the energy along the index-reduced field.
double power(const disc<>& body, const vector5& q, const vector5& v) {
    Eigen::Matrix<double, 10, 1> y, f;
    y << q, v;
    index_reduced(body)(0.0, y, f);
    const double h = 1e-5;
    const auto at = [&](double step) {
        const vector5 moved_q = q + step * f.head<5>(), moved_v = v + step * f.tail<5>();
        return total_energy(body, moved_q, moved_v);
    };
    return (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_consistent_multiplier_has_the_reference_digits) {
    const disc<wide> body;
    const auto q = rolling_disc::initial_position<wide>(), v = rolling_disc::initial_velocity<wide>(body);
    const auto lambda = consistent_multiplier(body, q, v);
    const wide expected("0.681395449165034688894136043442791"), energy("1.05128903183617255682266388732596");
    BOOST_TEST(lambda[0] == wide(0));
    BOOST_TEST(abs(lambda[1] - expected) < wide(1e-32));
    BOOST_TEST(abs(total_energy(body, q, v) - energy) < wide(1e-31));
    BOOST_TEST(constraint_violation(body, q, v) == wide(0));

    const auto y =
        index_2(disc<>()).initial_state(rolling_disc::initial_position(), rolling_disc::initial_velocity());
    BOOST_TEST(y[10] == 0.0);
    BOOST_TEST(std::abs(y[11] - 0.681395449165034688894) < 1e-15);
}

BOOST_AUTO_TEST_CASE(inconsistent_velocities_are_refused) {
    vector5 v = rolling_disc::initial_velocity();
    v[1] += 1e-9;
    BOOST_CHECK_THROW(index_2(disc<>()).initial_state(rolling_disc::initial_position(), v),
                      std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(the_closed_form_inverts_the_mass_matrix) {
    const disc<> body;
    std::mt19937 engine(1);
    for (int trial = 0; trial < 50; ++trial) {
        const vector5 q = random_vector(engine), r = random_vector(engine);
        const vector5 a = body.solve_mass(q, r);
        const vector5 dense = body.M(q).ldlt().solve(r);
        BOOST_TEST((a - dense).norm() <= 1e-11 * dense.norm());
        BOOST_TEST((body.M(q) - body.M(q).transpose()).norm() == 0.0);
        BOOST_TEST(body.M(q).llt().info() == Eigen::Success);
        const vector5 own = small_ldlt<double, 5>(body.M(q)).solve(r);
        BOOST_TEST((own - dense).norm() <= 1e-11 * dense.norm());
    }
}

BOOST_AUTO_TEST_CASE(the_constraint_inertia_is_the_diagonal_of_the_thesis) {
    const disc<> body;
    std::mt19937 engine(2);
    for (int trial = 0; trial < 50; ++trial) {
        const vector5 q = random_vector(engine);
        const Eigen::Matrix2d S = constraint_inertia(body, q),
                              factored = constraint_inertia(plain_disc{body}, q);
        Eigen::Matrix2d expected = Eigen::Matrix2d::Zero();
        expected(0, 0) = 3;
        expected(1, 1) = 5 / (5 - 4 * std::pow(std::cos(q[3]), 2));
        BOOST_TEST((S - expected).norm() < 1e-11);
        BOOST_TEST((factored - expected).norm() < 1e-11);
    }
}

BOOST_AUTO_TEST_CASE(energy_is_constant_with_the_corrected_force_only) {
    disc<> corrected, printed;
    printed.printed_force = true;
    std::mt19937 engine(3);
    double largest = 0;
    for (int trial = 0; trial < 50; ++trial) {
        const vector5 q = random_vector(engine);
        const vector5 v = rolling_velocity(q, random_vector(engine), corrected.R);
        BOOST_TEST(std::abs(power(corrected, q, v)) < 1e-8);
        largest = std::max(largest, std::abs(power(printed, q, v)));
    }
    BOOST_TEST(largest > 1e-2);
}

BOOST_AUTO_TEST_CASE(the_flat_disc_is_named_as_singular) {
    const disc<> body;
    vector5 q = rolling_disc::initial_position();
    BOOST_TEST(singular_position(body, q) == "");
    for (const double beta : {std::numbers::pi / 2, -std::numbers::pi / 2, 3 * std::numbers::pi / 2}) {
        q[3] = beta;
        BOOST_TEST(singular_position(body, q) == "beta = +-pi/2: the disc lies flat");
        BOOST_CHECK_EXCEPTION(consistent_multiplier(body, q, vector5(vector5::Zero())), std::domain_error,
                              [](const std::domain_error& e) {
                                  return std::string(e.what()).find("beta = +-pi/2") != std::string::npos;
                              });
        BOOST_TEST(body.M(q).ldlt().vectorD().minCoeff() < 1e-16);
    }
    q[3] = std::numbers::pi / 2 - 1e-3;
    BOOST_TEST(singular_position(body, q) == "");
}

BOOST_AUTO_TEST_CASE(the_leading_minors_of_m_are_positive_but_for_the_fifth_where_cos_beta_is_0) {
    // Model assumption 2. The thesis leaves the powers of the mass out of minors 2 to 5.
    disc<wide> body;
    body.m = wide(3);
    for (const wide& beta : {wide(4) / 5, wide(0), wide(-3) / 2}) {
        Eigen::Matrix<wide, 5, 1> q;
        q << wide(1) / 7, wide(-2) / 9, wide(3), beta, wide(-1);
        const wide c = cos(beta), a = 2 - c * c, b = 5 - 4 * c * c, R2 = body.R * body.R, m = body.m;
        const wide expected[5] = {m, pow(m, 2), pow(m, 3) * R2 * a / 4, pow(m, 4) * R2 * R2 * a * b / 16,
                                  pow(m, 5) * R2 * R2 * R2 * c * c * b / 32};
        wide minor = 1;
        const small_ldlt<wide, 5> factors(body.M(q));
        for (int i = 0; i < 5; ++i) {
            minor *= factors.pivot(i);
            BOOST_TEST(abs(minor - expected[i]) < wide(1e-35) * expected[i]);
            BOOST_TEST(minor > 0);
        }
    }
}

BOOST_AUTO_TEST_CASE(the_jacobian_is_the_derivative_of_the_index_2_system) {
    // Against central differences in 40 digits: truncation 1e-20, so every entry must agree to double
    // rounding.
    const auto dae = index_2(disc<>());
    const auto factored = index_2(plain_disc{});
    const auto wide_dae = index_2<wide>(disc<wide>());
    std::mt19937 engine(4);
    for (int trial = 0; trial < 5; ++trial) {
        Eigen::Matrix<double, 12, 1> y;
        y << random_vector(engine), random_vector(engine), random_vector(engine).head<2>();
        Eigen::Matrix<double, 12, 12> J, plain_J;
        dae.jacobian(0.0, y, J);
        factored.jacobian(0.0, y, plain_J);
        const wide h(1e-10);
        Eigen::Matrix<wide, 12, 1> up, down, f_up, f_down;
        for (int j = 0; j < 12; ++j) {
            for (int i = 0; i < 12; ++i) up[i] = down[i] = wide(y[i]);
            up[j] += h;
            down[j] -= h;
            wide_dae(wide(0), up, f_up);
            wide_dae(wide(0), down, f_down);
            for (int i = 0; i < 12; ++i) {
                const double expected = static_cast<double>((f_up[i] - f_down[i]) / (2 * h));
                BOOST_TEST(std::abs(J(i, j) - expected) <= 1e-10 * (1 + std::abs(expected)));
                BOOST_TEST(std::abs(plain_J(i, j) - expected) <= 1e-10 * (1 + std::abs(expected)));
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(index_flags_and_mass_matrix_mark_the_multiplier) {
    const auto dae = index_2(disc<>());
    for (int i = 0; i < 12; ++i) {
        BOOST_TEST(dae.index()[i] == (i < 10 ? 1 : 2));
        BOOST_TEST(dae.mass()(i, i) == (i < 10 ? 1.0 : 0.0));
    }
}

BOOST_AUTO_TEST_CASE(the_index_reduced_field_keeps_the_constraint_tangent) {
    const disc<> body;
    const auto ode = index_reduced(body);
    std::mt19937 engine(5);
    for (int trial = 0; trial < 20; ++trial) {
        const vector5 q = random_vector(engine), v = rolling_velocity(q, random_vector(engine), body.R);
        Eigen::Matrix<double, 10, 1> y, f, damped;
        y << q, v;
        ode(0.0, y, f);
        const vector5 a = f.tail<5>();
        const Eigen::Vector2d tangent = body.G(q) * a + constraint_curvature(body, q, v);
        BOOST_TEST(tangent.norm() < 1e-10 * (1 + a.norm()));
        // Off the constraint, r makes the violation u decay as u' = -r u.
        y[5] += 1e-3;
        index_reduced(body, 2.0)(0.0, y, damped);
        const vector5 off = y.tail<5>(), b = damped.tail<5>();
        const Eigen::Vector2d u = body.G(q) * off;
        const Eigen::Vector2d decay = body.G(q) * b + constraint_curvature(body, q, off) + 2 * u;
        BOOST_TEST(decay.norm() < 1e-10 * (1 + b.norm()));
    }
    BOOST_CHECK_THROW(index_reduced(body, -1.0), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(the_mass_matrix_is_factored_once_per_evaluation_of_the_field) {
    int count = 0;
    counting model;
    model.count = &count;
    Eigen::Matrix<double, 12, 1> y, f;
    y << rolling_disc::initial_position(), rolling_disc::initial_velocity(), 0, 0.7;
    const Eigen::Matrix<double, 10, 1> z = y.head<10>();
    Eigen::Matrix<double, 10, 1> g, closed;
    const index_2_dae<counting> dae(model);
    dae(0.0, y, f);
    BOOST_TEST(count == 1);
    const index_reduced_ode<counting> reduced(model, 0.0);
    reduced(0.0, z, g);
    BOOST_TEST(count == 2);
    index_reduced(disc<>())(0.0, z, closed);  // the closed form needs no M at all and gives the same
    BOOST_TEST((closed - g).norm() < 1e-11 * g.norm());
}
