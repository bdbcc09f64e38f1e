// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE continuous_order
#include "catalogue.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <map>
#include <stagecraft/coefficients/dense.hpp>
#include <stagecraft/coefficients/explicit.hpp>
#include <stagecraft/dense_method.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/method/continuous_weights.hpp>
#include <stagecraft/method/structure.hpp>
#include <stagecraft/observe/solution.hpp>
#include <stagecraft/problem/with.hpp>
#include <stagecraft/tableaux/read_method.hpp>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "../message.hpp"

// What lies between the ends of the steps of methods given by a tableau.

namespace sc = stagecraft;
using namespace catalogue_runs;

namespace {

struct one_step {
    fifty between = 0;                      // largest error at h/10, 2h/10, ...
    fifty left = 0, right = 0;              // |u(t0) - y0|, |u(t1) - y1|
    fifty left_slope = 0, right_slope = 0;  // |u'(t0) - f(t0, y0)|, |u'(t1) - f(t1, y1)|
};

one_step step(const sc::tableau<fifty>& m, const fifty& h) {
    const fifty tiny("1e-40");
    const vector y0(fifty(1), fifty(1));
    one_step seen;
    const auto look = [&](const fifty& t, const vector& y, const fifty&, const auto& u) {
        for (int i = 1; i < 10; ++i) {
            const fifty r = 1 / (1 + h * i / 10), e = (u(h * i / 10) - vector(r, r * r)).norm();
            if (e > seen.between) seen.between = e;
        }
        vector f;
        hyperbola{}(fifty(0), y0, f);
        seen.left = (u(fifty(0)) - y0).norm();
        seen.left_slope = (u.derivative(fifty(0)) - f).norm();
        hyperbola{}(t, y, f);
        seen.right = (u(t) - y).norm();
        seen.right_slope = (u.derivative(t) - f).norm();
    };
    const auto r =
        sc::integrate(m, hyperbola{}, y0, fifty(0), h, {.rtol = tiny, .atol = tiny, .fixed_step = h}, look);
    BOOST_TEST(r.ok());
    BOOST_TEST(r.report.steps == 1);
    return seen;
}

// The error of one step is O(h^{q+1}) between its ends.
double order(const sc::tableau<fifty>& m, int steps) {
    const fifty coarse = step(m, fifty(1) / steps).between, fine = step(m, fifty(1) / (2 * steps)).between;
    return std::log2(static_cast<double>(coarse / fine)) - 1;
}

bool is_explicit(const sc::tableau<double>& m) {
    return m.A.isZero(0) || m.A.triangularView<Eigen::Upper>().toDenseMatrix().isZero(0);
}

sc::tableau<double> with_right_end(const sc::tableau<double>& m) {
    const auto s = m.b.size();
    sc::tableau<double> r;
    r.A = Eigen::MatrixXd::Zero(s + 1, s + 1);
    r.A.topLeftCorner(s, s) = m.A;
    r.A.row(s).head(s) = m.b;
    r.b = r.c = Eigen::VectorXd::Zero(s + 1);
    r.b.head(s) = m.b;
    r.c.head(s) = m.c;
    r.c[s] = 1;
    return r;
}

// Largest error of y' = y cos t, y = exp(sin t), at equidistant times over [0, 10], in units of the
// tolerance.
double error_at_given_times(const std::string& name, double tolerance) {
    using scalar_state = Eigen::Matrix<double, 1, 1>;
    const auto f = [](double t, const scalar_state& y, scalar_state& out) { out[0] = y[0] * std::cos(t); };
    sc::solution<scalar_state> y;
    const auto r = sc::integrate(sc::tableaux::rounded<double>(catalogue().at(name)), f, scalar_state::Ones(),
                                 0, 10, {.rtol = tolerance, .atol = tolerance}, y);
    BOOST_TEST(r.ok());
    double worst = 0;
    for (int k = 0; k <= 5000; ++k)
        worst = std::max(worst, std::abs(y(k / 500.)[0] - std::exp(std::sin(k / 500.))));
    return worst / tolerance;
}

}  // namespace

BOOST_AUTO_TEST_CASE(continuous_solutions_have_the_highest_order_their_stages_allow) {
    const std::map<std::string, int> expected{{"dormand_prince_5_4", 4},
                                              {"bogacki_shampine_5_4", 4},
                                              {"tsitouras_5_4", 4},
                                              {"verner_6_5", 4},
                                              {"prince_dormand_8_7", 5},
                                              {"verner_8_7_efficient", 5},
                                              {"bogacki_shampine_3_2", 3},
                                              {"cash_karp_5_4", 4},
                                              {"fehlberg_4_5", 4},
                                              {"dormand_prince_8_5_3", 6},
                                              {"verner_7_6_efficient", 5},
                                              {"heun_3", 3},
                                              {"classical_rk4", 3},
                                              {"sdirk_4_3", 3},
                                              {"kvaerno_4_3", 3},
                                              {"kvaerno_5_4", 4},
                                              {"tr_bdf2", 2},
                                              {"heun_2", 2},
                                              {"lobatto_iiib_3", 2},
                                              {"lobatto_iiib_2", 1},
                                              {"lobatto_iiic_4", 4},
                                              {"explicit_euler", 1}};
    for (const auto& [name, q] : expected) BOOST_TEST_CONTEXT(name) {
            const double seen = order(sc::tableaux::rounded<fifty>(catalogue().at(name)), 64);
            BOOST_TEST(std::abs(seen - q) < 0.1, "order " << seen);
        }
}

// What the tree conditions of the rounded coefficients say is what a step shows; the ends are those of the
// step, and the slopes are f where they are stages.
BOOST_AUTO_TEST_CASE(every_continuous_solution_of_the_catalogue_has_the_order_of_its_tree_conditions) {
    const fifty rounding("1e-46");
    int methods = 0, smooth = 0, of_order_four = 0;
    for (const auto& [name, file] : catalogue()) BOOST_TEST_CONTEXT(name) {
            const auto m = sc::tableaux::rounded<fifty>(file);
            Eigen::Matrix<fifty, Eigen::Dynamic, 1> carry;
            const auto is = sc::structure_of(m, carry);
            auto slopes = sc::tableaux::rounded<double>(file);
            const int p = sc::classical_order(slopes);
            const bool next_value = is.left_stage && !is.stiffly_accurate && is_explicit(slopes);
            if (next_value) slopes = with_right_end(slopes);
            const bool ends = is.first_same_as_last() || next_value;
            const int q = sc::find_continuous_weights(slopes, p, ends).order;
            if (is_explicit(slopes) && p <= 5) BOOST_TEST(q >= p - 1);
            ++methods;
            if (q >= 4) ++of_order_four;
            double seen = 0;
            const auto there = [&] { return std::abs(seen - q) < 0.1; };
            for (int steps = 64; !there() && steps <= 65536; steps *= 32) seen = order(m, steps);
            BOOST_TEST(there(), "order " << seen << " for " << q);
            const one_step s = step(m, fifty(1) / 16);
            BOOST_TEST(static_cast<double>(s.left) == 0);
            // as many digits as the coefficients have, for a collocation polynomial of decimals
            BOOST_TEST(s.right <= (name == "gauss_4" ? fifty("1e-30") : rounding));
            if (!ends) continue;
            ++smooth;
            BOOST_TEST(s.left_slope < rounding);
            BOOST_TEST(s.right_slope < fifty("1e-38"));  // what Newton's iteration leaves
        }
    BOOST_TEST(methods > 100);
    BOOST_TEST(smooth > 60);
    BOOST_TEST(of_order_four > 40);
}

// f at the end of a step is asked for once, by the next step too: one evaluation more in a whole run, and
// none where nobody asks for the continuous solution.
BOOST_AUTO_TEST_CASE(the_slope_at_the_right_end_costs_one_evaluation_a_run) {
    using scalar_state = Eigen::Matrix<double, 1, 1>;
    const auto f = [](double t, const scalar_state& y, scalar_state& out) { out[0] = y[0] * std::cos(t); };
    const auto rk4 = sc::tableaux::rounded<double>(catalogue().at("classical_rk4"));
    const sc::options<double> steps{.fixed_step = 0.125};
    double kink = 0, slope = 0;
    const auto look = [&](double t, const scalar_state&, double h, const auto& u) {
        if (t > h) kink = std::max(kink, std::abs(u.derivative(t - h)[0] - slope));
        slope = u.derivative(t)[0];
    };
    const auto plain = sc::integrate(rk4, f, scalar_state::Ones(), 0, 2, steps);
    const auto looked_at = sc::integrate(rk4, f, scalar_state::Ones(), 0, 2, steps, look);
    BOOST_TEST(plain.report.f == 4 * 16);
    BOOST_TEST(looked_at.report.f == 4 * 16 + 1);
    BOOST_TEST(plain.y[0] == looked_at.y[0]);
    BOOST_TEST(kink < 1e-14);
}

// A cubic is off by 1e4 and 2e5 tolerances there.
BOOST_AUTO_TEST_CASE(values_at_given_times_are_near_the_tolerance) {
    BOOST_TEST(error_at_given_times("dormand_prince_5_4", 1e-10) < 40);
    BOOST_TEST(error_at_given_times("prince_dormand_8_7", 1e-10) < 600);
}

// Published continuous solutions run: each file of tableaux/dense has at every theta the order that its certificate says.
BOOST_AUTO_TEST_CASE(published_continuous_solutions_have_their_certified_order_at_every_theta) {
    int files = 0;
    for (const auto& item : std::filesystem::directory_iterator(STAGECRAFT_SOURCE_DIR "/tableaux/dense"))
        BOOST_TEST_CONTEXT(item.path().stem().string()) {
            const auto file =
                std::get<sc::tableaux::tableau_file>(sc::tableaux::read_method_file(item.path().string()));
            const auto m = sc::tableaux::dense_method_of<fifty>(file);
            BOOST_TEST(m.dense_order == *file.claims.dense_order);
            const int steps = m.dense_order > 5 ? 64 : 512;  // as far as the digits of the file reach
            const fifty tiny("1e-40");
            std::vector<fifty> coarse;
            for (const fifty& h : {fifty(1) / steps, fifty(1) / (2 * steps)}) {
                std::vector<fifty> errors;
                const auto look = [&](const fifty&, const vector& y1, const fifty&, const auto& u) {
                    for (int i = 1; i < 10; ++i) {
                        const fifty r = 1 / (1 + h * i / 10);
                        errors.push_back((u(h * i / 10) - vector(r, r * r)).norm());
                    }
                    BOOST_TEST((u(h) - y1).norm() < fifty("1e-46"));
                };
                const auto r = sc::integrate(m, hyperbola{}, vector(fifty(1), fifty(1)), fifty(0), h,
                                             {.rtol = tiny, .atol = tiny, .fixed_step = h}, look);
                BOOST_TEST(r.ok());
                if (coarse.empty())
                    coarse = errors;
                else
                    for (std::size_t i = 0; i < errors.size(); ++i) {
                        const double seen = std::log2(static_cast<double>(coarse[i] / errors[i])) - 1;
                        BOOST_TEST(std::abs(seen - m.dense_order) < 0.1,
                                   "order " << seen << " at " << (i + 1) << "/10");
                    }
            }
            ++files;
        }
    BOOST_TEST(files == 9);
}

// Three evaluations more in an accepted step, where somebody looks; y is that of the tableau alone.
BOOST_AUTO_TEST_CASE(dop853_runs_with_its_own_continuous_solution) {
    using scalar_state = Eigen::Matrix<double, 1, 1>;
    const auto f = [](double t, const scalar_state& y, scalar_state& out) { out[0] = y[0] * std::cos(t); };
    const auto dense = sc::dormand_prince_8_5_3_dense();
    BOOST_TEST(dense.dense_order == 7);
    BOOST_TEST(dense.further_stages() == 4);
    const auto one = scalar_state::Ones();
    const sc::options<double> steps{.fixed_step = 0.5};
    sc::solution<scalar_state> y, own;
    const auto alone = sc::integrate(dense, f, one, 0, 10, steps);
    const auto looked_at = sc::integrate(dense, f, one, 0, 10, steps, y);
    const auto plain = sc::integrate(sc::dormand_prince_8_5_3(), f, one, 0, 10, steps, own);
    BOOST_TEST(alone.report.f == 12 * 20);
    BOOST_TEST(looked_at.report.f == 15 * 20 + 1);
    BOOST_TEST(looked_at.y[0] == plain.y[0]);
    BOOST_TEST(alone.y[0] == plain.y[0]);
    double worst = 0, worst_own = 0;
    for (int k = 0; k <= 1000; ++k) {
        const double t = k / 100., exact = std::exp(std::sin(t));
        worst = std::max(worst, std::abs(y(t)[0] - exact));
        worst_own = std::max(worst_own, std::abs(own(t)[0] - exact));
    }
    BOOST_TEST(worst < worst_own / 3, worst << " and " << worst_own);
    // Steps that are chosen, from the file as well, which is the header to the last bit.
    const std::string path = STAGECRAFT_SOURCE_DIR "/tableaux/dense/dormand_prince_8_5_3.json";
    const sc::options<double> o{.rtol = 1e-9, .atol = 1e-9};
    sc::solution<Eigen::VectorXd> of_header, of_file;
    const auto g = [](double t, const Eigen::VectorXd& x, Eigen::VectorXd& out) { out = x * std::cos(t); };
    const auto a = sc::integrate(dense, g, Eigen::VectorXd::Ones(1), 0, 10, o, of_header);
    const auto b =
        sc::integrate(sc::tableaux::read_method(path), g, Eigen::VectorXd::Ones(1), 0, 10, o, of_file);
    BOOST_TEST(a.report.steps == b.report.steps);
    for (const double t : {0.77, 4.1, 9.3}) {
        BOOST_TEST(std::abs(of_header(t)[0] - std::exp(std::sin(t))) < 1e-8);
        BOOST_TEST(std::abs(of_header(t)[0] - of_file(t)[0]) < 1e-13);
    }
}

// With a singular M there are no slopes: the tableau's own continuous solution takes its place.
BOOST_AUTO_TEST_CASE(published_continuous_solutions_give_way_and_wrong_ones_are_refused) {
    const auto m = sc::tableaux::dense_method_of(std::get<sc::tableaux::tableau_file>(
        sc::tableaux::read_method_file(STAGECRAFT_SOURCE_DIR "/tableaux/dense/kennedy_carpenter_ark4.json")));
    using pair = Eigen::Vector2d;
    const auto dae = [](double, const pair& y, pair& f) { f << -y[1], y[1] - y[0]; };
    const Eigen::Matrix2d M{{1, 0}, {0, 0}};
    double worst = 0;
    const auto look = [&](double t, const pair&, double h, const auto& u) {
        worst = std::max(worst, std::abs(u(t - h / 2)[0] - std::exp(-(t - h / 2))));
    };
    BOOST_TEST(
        sc::integrate(m, sc::with_mass(dae, M), pair(1, 1), 0, 1, {.rtol = 1e-6, .atol = 1e-6}, look).ok());
    BOOST_TEST(worst < 1e-3);
    auto wrong = m;
    wrong.b_theta.conservativeResize(5, 3);
    BOOST_TEST(message([&] {
                   sc::integrate(
                       wrong, [](double, const pair& y, pair& f) { f = -y; }, pair(1, 1), 0, 1);
               }).find("b_theta must have a row") != std::string::npos);
    BOOST_CHECK_THROW(sc::tableaux::dense_method_of(catalogue().at("kutta_3")), std::invalid_argument);
}
