// SPDX-License-Identifier: BSL-1.0
#undef NDEBUG  // Eigen's assertions
#define BOOST_TEST_MODULE blind_spots
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/integrate.hpp>
#include <stagecraft/method/blind_spots.hpp>
#include <stagecraft/method/step_doubling.hpp>

#include "../catalogue.hpp"

// Jumps of f that an embedded estimate does not see, for every pair of the catalogue.

namespace sc = stagecraft;
using read_once::catalogue, read_once::rounded;
using V = Eigen::VectorXd;
using method = sc::tableau<double>;

namespace {

struct found {
    sc::blind_spots<double> spots;
    sc::tableau_structure is;
};
found spots_of(const method& m) {
    Eigen::VectorXd carry;
    const auto is = sc::structure_of(m, carry);
    return {sc::find_blind_spots(m, is, V(m.b - m.b_embedded), sc::classical_order(m)), is};
}

/// What the embedded weights, and what the best combination of a spot make of a jump at theta.
double shown(const method& m, double theta, const V& weights) {
    double sum = 0;
    for (int i = 0; i < m.stages(); ++i)
        if (m.c[i] > theta) sum += weights[i];
    return sum;
}
double seen(const method& m, double theta, const sc::blind_spots<double>& spots) {
    double most = 0;
    for (int k = 0; k < spots.count(); ++k)
        most = std::max(most, std::abs(shown(m, theta, V(spots.weights.col(k).segment(1, m.stages()))) +
                                       spots.weights(m.stages() + 1, k)));
    return most;
}

/// y0' = 1, then -2 from `jump` on; y1 changes its sign of growth where y0 passes 1.5, at t = 1.5 and at
/// back(); beside them an oscillation.
struct sawtooth {
    double jump, frequency;
    double back() const { return jump + (jump - 1.5) / 2; }
    double end() const { return 1.5 * jump; }
    void operator()(double t, const V& y, V& f) const {
        f[0] = t < jump ? 1 : -2;
        f[1] = y[0] > 1.5 ? -y[1] : y[1];
        f[2] = frequency * y[3];
        f[3] = -frequency * y[2];
    }
    double error(const V& y) const {
        const double y1 = std::exp(1.5 - (back() - 1.5) + (end() - back()));
        return std::max(std::abs(y[0]), std::abs(y[1] / y1 - 1));
    }
};

/// The same without jumps: each piece is a run of its own.
double error_in_pieces(const method& m, const sawtooth& f, const sc::options<double>& o) {
    double slope = 1, growth = 1;
    const auto piece = [&](double, const V& y, V& d) {
        d[0] = slope;
        d[1] = growth * y[1];
        d[2] = f.frequency * y[3];
        d[3] = -f.frequency * y[2];
    };
    V y = Eigen::Vector4d(0, 1, 1, 0);
    double t = 0;
    const auto go = [&](double to, double s, double g) {
        slope = s;
        growth = g;
        y = sc::integrate(m, piece, y, t, to, o).y;
        t = to;
    };
    go(1.5, 1, 1);
    go(f.jump, 1, -1);
    go(f.back(), -2, -1);
    go(f.end(), -2, 1);
    return f.error(y);
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_the_estimate_does_not_see_is_found_from_the_weights) {
    // Every stage of SDIRK 4(3) lies behind a jump before c_1 = 1/4, and the last two nodes of
    // Bogacki-Shampine 5(4), both at 1, have opposite weights.
    const auto sdirk = rounded("sdirk_4_3"), bogacki = rounded("bogacki_shampine_5_4"),
               dormand = rounded("dormand_prince_5_4");
    for (const auto& [m, theta] : {std::pair{sdirk, 0.2}, std::pair{bogacki, 0.9}}) {
        BOOST_TEST(std::abs(shown(m, theta, V(m.b - m.b_embedded))) < 1e-15);
        BOOST_TEST(spots_of(m).spots.count() == 1);
        BOOST_TEST(seen(m, theta, spots_of(m).spots) > 0.1);
    }
    BOOST_TEST(spots_of(sdirk).spots.need_left_slope);
    BOOST_TEST(!spots_of(bogacki).spots.need_left_slope);
    const auto none = spots_of(dormand).spots;
    BOOST_TEST(none.count() == 0);
    BOOST_TEST(!none.need_left_slope);
    BOOST_TEST(!none.need_right_slope);
    // Between c_2 = 1/5 and c_3 = 3/10 the estimate shows 71/57600 of a jump, and y1 errs by up to 401/1920.
    BOOST_TEST(none.largest_ratio == (401.0 / 1920) / (71.0 / 57600), boost::test_tools::tolerance(1e-10));
    // Two steps of the implicit midpoint rule are blind at both ends.
    const auto doubled = sc::step_doubling(rounded("implicit_midpoint"));
    const auto both = spots_of(doubled).spots;
    BOOST_TEST(both.need_left_slope);
    BOOST_TEST(both.need_right_slope);
}

BOOST_AUTO_TEST_CASE(the_combinations_show_nothing_of_what_is_smooth) {
    int blind = 0;
    for (const auto& [name, file] : catalogue()) {
        const auto m = rounded(name);
        if (m.b_embedded.size() == 0) continue;
        const V d = m.b - m.b_embedded;
        if (sc::blind_to_quadrature(m, d)) continue;
        const auto [spots, is] = spots_of(m);
        blind += spots.count() > 0;
        BOOST_TEST_CONTEXT(name) {
            // Smooth: the slopes of y' = f(t) with a polynomial of degree power - 2.
            for (int k = 0; k < spots.count(); ++k) {
                double scale = 0;
                for (int q = 0; q + 1 < spots.power; ++q) {
                    double sum = q == 0 ? spots.weights(0, k) : 0;
                    for (int i = 0; i < m.stages(); ++i) sum += spots.weights(i + 1, k) * std::pow(m.c[i], q);
                    sum += spots.weights(m.stages() + 1, k);
                    scale = std::max(scale, std::abs(sum));
                }
                BOOST_TEST(scale < 1e-12);
            }
        }
    }
    BOOST_TEST(blind >= 6);
}

// Error of the run across jumps against that of the same run in pieces without. The estimate may show 1/200
// of a jump, in a norm that halves what is in one of four components; what is in y1 grows threefold on the
// way: 200 * 2 * 3 tolerances.
BOOST_AUTO_TEST_CASE(every_pair_solves_across_jumps_to_the_tolerance) {
    for (const auto& [name, file] : catalogue()) {
        const auto m = rounded(name);
        if (m.b_embedded.size() == 0 || sc::blind_to_quadrature(m, V(m.b - m.b_embedded))) continue;
        const int order = sc::classical_order(m);
        if (order < 2) continue;
        for (const double tol : {1e-4, 1e-6, 1e-8}) {
            if (order < 4 && tol < 1e-6) continue;
            for (const double frequency : {0.0, 20.0})
                for (const double shift : {0.0, 0.013, 0.1, 0.237}) {
                    const sawtooth f{2 + shift, frequency};
                    const auto r = sc::integrate(m, f, V(Eigen::Vector4d(0, 1, 1, 0)), 0, f.end(),
                                                 {.rtol = tol, .atol = tol});
                    BOOST_TEST_CONTEXT(name << " tol " << tol << " frequency " << frequency << " shift "
                                            << shift << " steps " << r.report.steps) {
                        BOOST_TEST(sc::name(r.status) == "success");
                        BOOST_TEST(f.error(r.y) <
                                   1200 * tol + 3 * error_in_pieces(m, f, {.rtol = tol, .atol = tol}));
                    }
                }
        }
    }
}

// Every place of a jump in the first step, of which nothing is known yet. Tolerances are asked of the estimate, which may
// show 1/200 of a jump.
BOOST_AUTO_TEST_CASE(a_jump_in_the_first_step_is_seen_by_every_pair) {
    for (const auto& [name, file] : catalogue()) {
        const auto m = rounded(name);
        if (m.b_embedded.size() == 0 || sc::blind_to_quadrature(m, V(m.b - m.b_embedded))) continue;
        if (sc::classical_order(m) < 2) continue;
        for (const double first : {0.0, 0.1, 1.0})
            for (int k = 1; k < 20; ++k) {
                const double jump = (k / 20.0 - 0.013) * (first == 0 ? 0.01 : first);
                const auto kink = [jump](double t, const V&, V& f) { f[0] = t < jump ? 1 : -2; };
                const auto r = sc::integrate(m, kink, V(V::Ones(1)), 0, 2,
                                             {.rtol = 1e-6, .atol = 1e-6, .initial_step = first});
                BOOST_TEST(r.ok());
                BOOST_TEST(std::abs(r.y[0] - (1 + jump - 2 * (2 - jump))) < 200 * (1e-6 + 1e-6 * (1 + jump)),
                           name << " first " << first << " jump " << jump << ": " << r.y[0]);
            }
    }
}

// Halving the step may move a jump from one blind spot into another.
BOOST_AUTO_TEST_CASE(a_jump_that_stays_unseen_when_the_step_is_halved_is_a_jump) {
    const double jump = 2.6301136871041262;
    const auto kink = [jump](double t, const V&, V& f) { f[0] = t < jump ? 1 : -2; };
    const auto doubled = sc::step_doubling(rounded("pareschi_russo_2"));
    const auto r = sc::integrate(doubled, kink, V(V::Zero(1)), 0, 4, {.rtol = 1e-6, .atol = 1e-6});
    BOOST_TEST(r.ok());
    BOOST_TEST(std::abs(r.y[0] - (jump - 2 * (4 - jump))) < 1e-4);
}

// Neither smooth stiff components nor jumps in them may be taken for what the watch looks for: they cost what
// they cost without it (f = 1583, 1320), and do not end in too small a step.
BOOST_AUTO_TEST_CASE(stiff_components_raise_no_suspicion) {
    for (const auto& name : {"norsett_thomsen_2_3", "billington_2_3"})
        for (const double lambda : {1e4, 1e6, 1e8, 1e10}) {
            const auto smooth = [lambda](double t, const V& y, V& f) {
                f[0] = -lambda * (y[0] - std::sin(t)) + std::cos(t);
            };
            const auto r =
                sc::integrate(rounded(name), smooth, V(V::Zero(1)), 0, 5, {.rtol = 1e-4, .atol = 1e-4});
            BOOST_TEST(r.ok(), name << " lambda " << lambda << " " << sc::name(r.status));
            BOOST_TEST(std::abs(r.y[0] - std::sin(5.0)) < 1e-3);
            BOOST_TEST(r.report.f < 2000);
        }
    for (const auto& name : {"kvaerno_4_3", "kvaerno_5_4", "kennedy_carpenter_esdirk_4_3",
                             "kennedy_carpenter_esdirk_5_4", "cash_4_3"})
        for (const double jump : {1.0, 1.3, 1.7}) {
            const auto kick = [jump](double t, const V& y, V& f) {
                f[0] = -1e6 * (y[0] - std::sin(t) - (t < jump ? 0 : 1));
                f[1] = y[0];
            };
            const auto r =
                sc::integrate(rounded(name), kick, V(V::Zero(2)), 0, 3, {.rtol = 1e-6, .atol = 1e-6});
            BOOST_TEST(r.ok(), name << " jump " << jump << " " << sc::name(r.status));
            BOOST_TEST(std::abs(r.y[1] - (1 - std::cos(3.0) + 3 - jump)) < 2e-4);
        }
}

// f(t1, y1) need not exist where it is asked for besides the stages.
BOOST_AUTO_TEST_CASE(an_infinite_value_at_the_end_of_the_run_is_left_out) {
    const auto logarithm = [](double t, const V&, V& f) { f[0] = std::log(1 - t); };
    const auto nothing = [](double, const V&, double, const auto&) {};
    for (const auto& m :
         {sc::step_doubling(rounded("explicit_midpoint")), sc::step_doubling(rounded("gauss_2"))}) {
        const auto r =
            sc::integrate(m, logarithm, V(V::Zero(1)), 0, 1, {.rtol = 1e-5, .atol = 1e-5}, nothing);
        BOOST_TEST(r.ok());
        BOOST_TEST(std::abs(r.y[0] + 1) < 1e-3);
    }
}

// With a singular mass matrix the slopes at the ends are not known, or only those of stages.
BOOST_AUTO_TEST_CASE(a_singular_mass_matrix_is_served_as_far_as_slopes_are_known) {
    struct problem {
        double jump;
        void operator()(double t, const V& y, V& f) const {
            f[0] = (t < jump ? 1 : -2) + y[1] - y[0];
            f[1] = y[0] - y[1];
        }
        Eigen::MatrixXd mass() const { return Eigen::Vector2d(1, 0).asDiagonal(); }
    };
    for (const auto& name :
         {"tr_bdf2", "sdirk_4_3", "kennedy_carpenter_esdirk_4_3", "norsett_thomsen_2_3", "billington_2_3"})
        for (const double jump : {2.0, 2.013, 2.1, 2.237}) {
            const auto r = sc::integrate(rounded(name), problem{jump}, V(V::Zero(2)), 0, 1.5 * jump,
                                         {.rtol = 1e-6, .atol = 1e-6});
            BOOST_TEST_CONTEXT(name << " jump " << jump) {
                BOOST_TEST(r.ok());
                BOOST_TEST(std::abs(r.y[0]) < 2e-4);
                BOOST_TEST(std::abs(r.y[1]) < 2e-4);
            }
        }
}

// A jump in the very last step, behind every node, is seen only by f(t1, y1).
BOOST_AUTO_TEST_CASE(a_jump_behind_the_last_node_of_the_last_step_is_seen) {
    const auto doubled = sc::step_doubling(rounded("implicit_midpoint"));
    for (const auto& m : {doubled, rounded("norsett_thomsen_2_3")}) {
        const auto kink = [](double t, const V&, V& f) { f[0] = t < 0.95 ? 1 : -2; };
        const auto r =
            sc::integrate(m, kink, V(V::Zero(1)), 0, 1, {.rtol = 1e-6, .atol = 1e-6, .initial_step = 0.5});
        BOOST_TEST(r.ok());
        BOOST_TEST(std::abs(r.y[0] - 0.85) < 1e-4);
        BOOST_TEST(r.report.rejected_error > 0);
    }
}

// At the border of its stability an explicit method raises suspicion again and again; it must not pay for it:
// 9010 evaluations without the watch.
BOOST_AUTO_TEST_CASE(mild_stiffness_costs_few_repeated_steps) {
    const auto van_der_pol = [](double, const V& y, V& f) {
        f[0] = y[1];
        f[1] = 30 * (1 - y[0] * y[0]) * y[1] - y[0];
    };
    const auto r = sc::integrate(rounded("bogacki_shampine_5_4"), van_der_pol, V(Eigen::Vector2d(2, 0)), 0,
                                 60, {.rtol = 1e-7, .atol = 1e-7});
    BOOST_TEST(r.ok());
    BOOST_TEST(r.report.f < 9900);
}
