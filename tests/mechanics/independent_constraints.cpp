// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE independent_constraints
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <exception>
#include <functional>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/holonomic.hpp>
#include <stagecraft/mechanics/independent_constraints.hpp>
#include <stagecraft/mechanics/rows_chosen_anew.hpp>
#include <stdexcept>
#include <string>
#include <utility>

using namespace stagecraft;

namespace {

void check_named(const std::function<void()>& call, const std::string& what) {
    BOOST_CHECK_EXCEPTION(call(), std::domain_error, [&](const std::domain_error& e) {
        BOOST_TEST_MESSAGE(e.what());
        return std::string(e.what()).find(what) != std::string::npos;
    });
}

// A heavy symmetric top: centre of mass (q0, q1, q2) at the distance `length` from its tip, which stays at the origin,
// attitude the quaternion (q3 ... q6) of length 1. That the centre stays at that distance says the tip's three
// constraints once more.
constexpr double mass = 0.5, length = 0.4, gravity = 9.81, across = 0.02, along = 0.05;

template <class Q>
auto axis(const Q& q) {
    using S = std::decay_t<decltype(q[0] + 0.0)>;
    Eigen::Matrix<S, 3, 1> e;
    e[0] = 2 * (q[4] * q[6] + q[3] * q[5]);
    e[1] = 2 * (q[5] * q[6] - q[3] * q[4]);
    e[2] = q[3] * q[3] - q[4] * q[4] - q[5] * q[5] + q[6] * q[6];
    return e;
}

const auto top_constraint = [](const auto& q) {
    const auto e = axis(q);
    using S = std::decay_t<decltype(e[0] + 0.0)>;
    Eigen::Matrix<S, 5, 1> g;
    for (int i = 0; i < 3; ++i) g[i] = q[i] - length * e[i];
    g[3] = (q.template tail<4>().squaredNorm() - 1) / 2;
    const S n = q.template tail<4>().squaredNorm();
    g[4] = (q.template head<3>().squaredNorm() - length * length * n * n) / 2;
    return g;
};

// Kinetic energy of the centre and of the turning about it in the body's axes; the last term gives the length of the
// quaternion, which is constant, an inertia.
const auto top_energy = [](const auto& q, const auto& v) {
    const auto turning = [&](int a, int b, int c) {  // 2 (q3 v_a - q_a v3 - (q_b v_c - q_c v_b))
        return 2 * (q[3] * v[a] - q[a] * v[3] - q[b] * v[c] + q[c] * v[b]);
    };
    const auto x = turning(4, 5, 6), y = turning(5, 6, 4), z = turning(6, 4, 5);
    const auto stretching = q.template tail<4>().dot(v.template tail<4>());
    return 0.5 * (mass * v.template head<3>().squaredNorm() + across * (x * x + y * y) + along * z * z +
                  stretching * stretching);
};
const auto top_weight = [](const auto& q) { return mass * gravity * q[2]; };

using vector7 = Eigen::Matrix<double, 7, 1>;

}  // namespace

// Leaning by theta it precesses steadily at the rate p of (A - C) p^2 cos(theta) - C p spin + m g l = 0, where spin is the
// turning about its own axis beside the precession, A = across + m l^2 and C = along (Landau-Lifshitz, Mechanics, section 35).
BOOST_AUTO_TEST_CASE(a_top_with_a_redundant_constraint_precesses_as_the_textbook_has_it) {
    const double theta = 0.6, spin = 60, a = across + mass * length * length;
    // A p^2 cos = C p (spin + p cos) - m g l, the slow solution.
    const double k = (a - along) * std::cos(theta),
                 p = (along * spin -
                      std::sqrt(along * along * spin * spin - 4 * k * mass * gravity * length)) /
                     (2 * k);
    vector7 q = vector7::Zero(), v = vector7::Zero();
    q[3] = std::cos(theta / 2), q[4] = std::sin(theta / 2);
    q.head<3>() = length * axis(q);
    // The quaternion's rate: half the turning times it, the precession about the vertical, the spin about its own axis.
    const Eigen::Vector4d vertical(-q[6], -q[5], q[4], q[3]), own(-q[6], q[5], -q[4], q[3]);
    v.tail<4>() = (p * vertical + spin * own) / 2;
    v.head<3>() = p * length * std::sin(theta) * Eigen::Vector3d(1, 0, 0);
    const auto turned = [&](double t) {
        return Eigen::Vector3d(std::sin(theta) * std::sin(p * t), -std::sin(theta) * std::cos(p * t),
                               std::cos(theta));
    };
    BOOST_TEST((axis(q) - turned(0)).norm() < 1e-15);

    const auto all = lagrangian<7, 5>(top_energy, top_weight, top_constraint);
    check_named([&] { index_2(all).initial_state(q, v); }, "G has rank 4 of 5 here");
    check_named([&] { independent_constraints<3>(all, q); }, "independent_constraints<3>: G has rank 4 of 5");
    const auto model = independent_constraints<4>(all, q);
    const auto top = stabilised_index_2(model);
    const auto r =
        integrate(radau_iia<5>(), top, top.initial_state(q, v), 0.0, 1.0, {.rtol = 1e-10, .atol = 1e-10});
    BOOST_TEST(r.ok());
    const vector7 end = r.y.head<7>();
    BOOST_TEST((axis(end) - turned(1)).norm() < 1e-7);
    BOOST_TEST(top_constraint(end).norm() < 1e-9);  // the one that was left out as well
    // The same without redundancy from the start, by the constraint itself.
    const auto written =
        lagrangian<7, 4>(top_energy, top_weight, independent_constraints<4>(top_constraint, q));
    BOOST_TEST((index_2(written).initial_state(q, v) - index_2(model).initial_state(q, v)).norm() < 1e-12);
}

namespace {

// A bar of length 2 on three parallel cranks of length 1: as many constraints as coordinates, and yet it moves.
const auto three_cranks = [](const auto& q) {
    using S = std::decay_t<decltype(q[0] + 0.0)>;
    const S x = (q[0] + q[2]) / 2 - 1, y = (q[1] + q[3]) / 2, dx = q[2] - q[0], dy = q[3] - q[1],
            right = q[2] - 2;
    return Eigen::Matrix<S, 4, 1>(q[0] * q[0] + q[1] * q[1] - 1, right * right + q[3] * q[3] - 1,
                                  dx * dx + dy * dy - 4, x * x + y * y - 1);
};

// Two rows of affine constraints and a third that is their sum.
struct driven {
    static constexpr int coordinates = 4, constraints = 3;
    template <class S>
    using vector = Eigen::Matrix<S, 4, 1>;
    template <class S>
    Eigen::Matrix<S, 4, 4> M(const vector<S>&) const {
        return Eigen::Matrix<S, 4, 4>::Identity();
    }
    template <class S>
    vector<S> F(const vector<S>& q, const vector<S>&) const {
        return -q;
    }
    template <class S>
    Eigen::Matrix<S, 3, 4> G(const vector<S>& q) const {
        Eigen::Matrix<S, 3, 4> G = Eigen::Matrix<S, 3, 4>::Constant(S(0));
        G(0, 0) = G(2, 0) = q[1], G(0, 2) = G(2, 2) = S(1), G(1, 3) = G(2, 3) = q[0];
        return G;
    }
    template <class S>
    Eigen::Matrix<S, 3, 4> G_rate(const vector<S>&, const vector<S>& v) const {
        Eigen::Matrix<S, 3, 4> G = Eigen::Matrix<S, 3, 4>::Constant(S(0));
        G(0, 0) = G(2, 0) = v[1], G(1, 3) = G(2, 3) = v[0];
        return G;
    }
    template <class S>
    Eigen::Matrix<S, 3, 1> b(const vector<S>& q, const S& t) const {
        return Eigen::Matrix<S, 3, 1>(t, q[1], t + q[1]);
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_mechanism_with_as_many_constraints_as_coordinates_moves) {
    const Eigen::Vector4d q(0.6, -0.8, 2.6, -0.8), v(0, 0, 0, 0);
    const auto T = [](const auto&, const auto& w) { return 0.5 * w.squaredNorm(); };
    const auto V = [](const auto& x) { return 9.81 * (x[1] + x[3]); };
    const auto bar = index_reduced(lagrangian<4, 3>(T, V, independent_constraints<3>(three_cranks, q)));
    const auto r =
        integrate(radau_iia<3>(), bar, bar.initial_state(q, v), 0.0, 0.5, {.rtol = 1e-10, .atol = 1e-10});
    BOOST_TEST(r.ok());
    BOOST_TEST(three_cranks(Eigen::Vector4d(r.y.head<4>())).norm() < 1e-8);
    // A mathematical pendulum: energy at the angle where it is.
    BOOST_TEST(std::abs(r.y.tail<4>().squaredNorm() / 2 + 9.81 * (r.y[1] + r.y[3] + 1.6)) < 1e-7);
    BOOST_TEST(r.y.segment<2>(4).norm() > 1);
    // Lying flat the cranks and the bar are in line, and G has rank 2 there.
    const Eigen::Vector4d flat(1, 0, 3, 0);
    check_named([&] { independent_constraints<3>(three_cranks, flat); }, "G has rank 2 of 4");
}

BOOST_AUTO_TEST_CASE(a_run_that_ends_where_constraints_come_to_depend_on_each_other_names_them) {
    // The same mechanism, swung up to where it is in line, beyond which it has two ways to go.
    const Eigen::Vector4d q(0.6, -0.8, 2.6, -0.8), v(4, 3, 4, 3), flat(1, 0, 3, 0);
    const auto T = [](const auto&, const auto& w) { return 0.5 * w.squaredNorm(); };
    const auto V = [](const auto& x) { return 9.81 * (x[1] + x[3]); };
    const auto bar = stabilised_index_2(lagrangian<4, 3>(T, V, independent_constraints<3>(three_cranks, q)));
    const auto r =
        integrate(radau_iia<3>(), bar, bar.initial_state(q, v), 0.0, 0.5, {.rtol = 1e-10, .atol = 1e-10});
    BOOST_TEST(r.status == status::constraints_dependent);
    BOOST_TEST((r.y.head<4>() - flat).norm() < 1e-2);
    BOOST_TEST(std::abs(r.y.segment<2>(4).norm() - std::sqrt(25 - 2 * 9.81 * 0.8)) < 0.1);  // by its energy
    BOOST_REQUIRE(r.exception);
    check_named([&] { std::rethrow_exception(r.exception); }, "G has rank 2 of 3");
    BOOST_TEST(bar.dependent_constraints(r.t, bar.initial_state(q, v)).empty());
}

namespace {

using vector6 = Eigen::Matrix<double, 6, 1>;

// Two mechanisms of three points in a plane, with a constraint more than they need, and M and weights of each.
struct mechanism {
    bool sliding;
    Eigen::Matrix<double, 6, 6> M;
    vector6 weight;

    template <class Q>
    auto operator()(const Q& q) const {
        auto g = (0 * q).eval();
        const auto apart = [&](int i, int k, double length) {
            return (q[i] - q[k]) * (q[i] - q[k]) + (q[i + 1] - q[k + 1]) * (q[i + 1] - q[k + 1]) -
                   length * length;
        };
        if (sliding) {
            g[0] = q[0], g[1] = q[3], g[2] = apart(0, 2, 2);
            g[3] = q[4] - .5 * (q[0] + q[2]), g[4] = q[5] - .5 * (q[1] + q[3]);
            g[5] = q[4] * q[4] + q[5] * q[5] - 1.;
        } else {
            for (int k = 0; k < 3; ++k)
                g[k] = (q[2 * k] - k) * (q[2 * k] - k) + q[2 * k + 1] * q[2 * k + 1] - 1.;
            g[3] = apart(0, 2, 1), g[4] = apart(2, 4, 1), g[5] = apart(0, 4, 2);
        }
        return g;
    }
};

// Scott and Russell's: a bar of length 2 whose ends slide on x = 0 and on y = 0, and its middle, which a crank of length 1 holds
// as well. Its angle to the vertical is that of theta'' = 3/5 g sin(theta) for three masses of 1.
mechanism scott_russell() {
    return {true, Eigen::Matrix<double, 6, 6>::Identity(), (vector6() << 0, 1, 0, 1, 0, 1).finished()};
}
vector6 leaning(double theta) {
    const double x = std::sin(theta), y = std::cos(theta);
    return (vector6() << 0, 2 * y, 2 * x, 0, x, y).finished();
}

// Two four-bar linkages side by side (Gonzalez 2006, benchmark A02 with N = 2): five bars of 1 m and 1 kg.
mechanism four_bars() {
    mechanism m{false, Eigen::Matrix<double, 6, 6>::Identity() * (2. / 3),
                (vector6() << 0, 1, 0, 1.5, 0, 1).finished()};
    for (int i = 0; i < 6; ++i) {
        if (i == 2 || i == 3) m.M(i, i) = 1;
        if (i < 4) m.M(i, i + 2) = m.M(i + 2, i) = 1. / 6;
    }
    return m;
}

auto formulated(const mechanism& m, const vector6& q) {
    const auto kept = independent_constraints<5>(m, q);
    const auto T = [M = m.M](const auto&, const auto& v) {
        auto sum = 0. * v[0];
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < 6; ++j) sum += M(i, j) / 2 * v[i] * v[j];
        return sum;
    };
    const auto V = [w = m.weight](const auto& at) {
        auto sum = 0. * at[0];
        for (int i = 0; i < 6; ++i) sum += 9.81 * w[i] * at[i];
        return sum;
    };
    return std::pair(kept, stabilised_index_2(lagrangian<6, 5>(T, V, kept)));
}

// With rows chosen anew where others are better.
template <class Kept, class System>
auto run(const Kept& kept, const System& system, const vector6& q, const vector6& v, double t1, double rtol) {
    auto choice = events<typename System::state>(rows_chosen_anew(kept, system));
    const auto r = integrate(radau_iia<3>(), system, system.initial_state(q, v), 0.0, t1,
                             {.rtol = rtol, .atol = rtol}, choice);
    return std::pair(r, choice.found());
}

}  // namespace

BOOST_AUTO_TEST_CASE(rows_are_chosen_anew_where_those_kept_come_to_depend_on_each_other) {
    const auto [kept, bar] = formulated(scott_russell(), leaning(1));
    BOOST_TEST((*kept.rows == std::array{0, 1, 2, 4, 5}));  // which have rank 4 at theta = pi
    const auto margin = [&, &of = kept](double theta) {
        return detail::kept_row_margin(of.gradient_of_all(leaning(theta), 0), *of.rows);
    };
    BOOST_TEST(margin(1) > 0.1);
    BOOST_TEST(margin(3) < 0);
    BOOST_TEST(margin(M_PI) < -0.01);

    const auto [r, chosen] = run(kept, bar, leaning(1), vector6::Zero(), 1.1, 1e-9);
    BOOST_TEST_REQUIRE(r.ok());
    BOOST_TEST_REQUIRE(chosen.size() > 0u);
    BOOST_TEST(std::abs(chosen[0].t - 0.87) < 0.03);  // theta = pi at t = 0.9049
    const auto swing = [](double, const Eigen::Vector2d& y, Eigen::Vector2d& f) {
        f << y[1], 0.6 * 9.81 * std::sin(y[0]);
    };
    const auto exact =
        integrate(radau_iia<5>(), swing, Eigen::Vector2d(1, 0), 0.0, 1.1, {.rtol = 1e-12, .atol = 1e-12});
    const vector6 end = r.y.template head<6>();
    BOOST_TEST((end - leaning(exact.y[0])).norm() < 1e-7);
    BOOST_TEST(scott_russell()(end).norm() < 1e-8);
}

BOOST_AUTO_TEST_CASE(a_dead_point_where_all_rows_lose_rank_ends_a_run_with_it) {
    // Upright with 1 m/s; the angle to the vertical has theta'^2 = 1 + 7/3 g (1 - cos theta). At 0.7143 s all bars are level.
    const vector6 q = (vector6() << 0, 1, 1, 1, 2, 1).finished(),
                  v = (vector6() << 1, 0, 1, 0, 1, 0).finished();
    const auto [kept, bars] = formulated(four_bars(), q);
    const auto [r, chosen] = run(kept, bars, q, v, 2, 1e-6);
    BOOST_TEST(r.status == status::constraints_dependent);
    BOOST_TEST(std::abs(r.t - 0.7143) < 2e-3);
    BOOST_TEST(std::abs(r.y[1]) < 0.01);
    const double speed = std::hypot(r.y[6], r.y[7]);
    BOOST_TEST(std::abs(speed * speed - 1 - 7. / 3 * 9.81 * (1 - r.y[1])) < 1e-4);
    BOOST_REQUIRE(r.exception);
    check_named([&, &why = r.exception] { std::rethrow_exception(why); }, "G has rank 3 of 5");
}

BOOST_AUTO_TEST_CASE(everything_that_a_model_says_of_its_constraints_is_kept_of_those_that_are_kept) {
    const driven all;
    const Eigen::Vector4d q(1, 2, 3, 4), v(5, 6, -10, -2);
    const auto model = independent_constraints<2>(all, q);
    const auto row = [&](const auto& kept, const auto& of, int k) {
        for (int i = 0; i < 3; ++i)
            if (kept.row(k) == of.row(i)) return i;
        return -1;
    };
    for (int k = 0; k < 2; ++k) {
        const int i = row(model.G<double>(q, 0.5), all.G<double>(q), k);
        BOOST_TEST(i >= 0);
        BOOST_TEST(row(model.G_rate<double>(q, v), all.G_rate<double>(q, v), k) == i);
        BOOST_TEST(row(model.b<double>(q, 0.5), all.b<double>(q, 0.5), k) == i);
    }
    check_named([&] { consistent_multiplier(all, q, v); }, "G has rank 2 of 3");
    BOOST_TEST(consistent_multiplier(model, q, v).size() == 2);
}
