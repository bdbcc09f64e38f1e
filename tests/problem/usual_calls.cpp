// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE usual_calls
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <sstream>
#include <stagecraft/families.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/output_times.hpp>
#include <stagecraft/observe/progress.hpp>
#include <stagecraft/observe/table.hpp>
#include <stagecraft/problem/with.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "../message.hpp"

namespace sc = stagecraft;
using Eigen::Vector2d;

namespace {

Vector2d circle(double, const Vector2d& y) { return Vector2d(y[1], -y[0]); }

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

}  // namespace

BOOST_AUTO_TEST_CASE(a_right_hand_side_may_return_its_value) {
    sc::options o;  // double, as no other scalar is named
    o.rtol = o.atol = 1e-9;
    struct returning {
        Vector2d operator()(double t, const Vector2d& y) const { return circle(t, y); }
        void jacobian(double, const Vector2d&, Eigen::Matrix2d& J) const { J << 0, 1, -1, 0; }
    };
    const auto by_function = sc::integrate(sc::radau_iia<3>(), circle, Vector2d(0, 1), 0, 1, o);
    const auto by_object = sc::integrate(sc::radau_iia<3>(), returning{}, Vector2d(0, 1), 0, 1, o);
    BOOST_TEST(by_function.ok());
    BOOST_TEST((by_function.report.found.jacobian == sc::jacobian_source::differences));
    BOOST_TEST((by_object.report.found.jacobian == sc::jacobian_source::member));
    BOOST_TEST(std::abs(by_function.y[0] - std::sin(1.0)) < 1e-8);
    BOOST_TEST(std::abs(by_object.y[0] - std::sin(1.0)) < 1e-8);
}

BOOST_AUTO_TEST_CASE(a_mass_matrix_given_as_an_expression_is_kept) {
    // y0' = -y0, 0 = y0 - y1; what the diagonal refers to is gone when the run begins
    const auto f = [](double, const Vector2d& y) { return Vector2d(-y[0], y[0] - y[1]); };
    const auto problem = sc::with_index(sc::with_mass(f, Vector2d(1, 0).asDiagonal()),
                                        Eigen::Vector2i(0, 1) + Eigen::Vector2i(1, 0));
    const auto r =
        sc::integrate(sc::radau_iia<3>(), problem, Vector2d(1, 1), 0, 1, {.rtol = 1e-9, .atol = 1e-9});
    BOOST_TEST(r.ok());
    BOOST_TEST(std::abs(r.y[0] - std::exp(-1.0)) < 1e-8);
    BOOST_TEST(std::abs(r.y[1] - std::exp(-1.0)) < 1e-8);
}

BOOST_AUTO_TEST_CASE(tolerances_of_components_are_a_list_or_a_vector) {
    const sc::options<double> two{.atol_components = {1e-6, 1e-9}}, many{.atol_components = {1, 2, 3}};
    BOOST_TEST((two.atol_components == Vector2d(1e-6, 1e-9)));
    BOOST_TEST((many.atol_components == Eigen::Vector3d(1, 2, 3)));
    const auto f = [](double, const Vector2d& y) { return Vector2d(-50 * y[0], y[0] - y[1]); };
    const auto run = [&](const sc::options<double>& o) {
        return sc::integrate(sc::radau_iia<3>(), f, Vector2d(1, 1), 0, 1, o);
    };
    const auto listed = run(two), given = run({.atol_components = Vector2d(1e-6, 1e-9)});
    BOOST_TEST((listed.y == given.y));
    BOOST_TEST((listed.y != run({}).y));
    sc::options<double> later;
    later.atol_components = {1e-6, 1e-9};
    BOOST_TEST((run(later).y == given.y));
    later.atol_components = Vector2d(1e-6, 1e-9);
    BOOST_TEST((run(later).y == given.y));
}

BOOST_AUTO_TEST_CASE(methods_of_run_time_stages_are_those_of_the_templates) {
    const auto m = sc::radau_iia(5);
    const auto fixed = sc::radau_iia<5>();
    BOOST_TEST((m.A == fixed.A && m.b == fixed.b && m.c == fixed.c && m.T == fixed.T));
    BOOST_TEST((m.A_inverse == fixed.A_inverse && m.T_inverse == fixed.T_inverse && m.facts == fixed.facts));
    BOOST_TEST((m.gamma == fixed.gamma && m.alpha == fixed.alpha && m.beta == fixed.beta));
    BOOST_TEST((sc::lobatto_iiia(3).A == sc::lobatto_iiia<3>().A));
    BOOST_TEST(sc::gauss(9).stages() == 9);
    for (const int s : {0, 10, -1}) {
        const auto why = message([s] { sc::radau_iia(s); });
        BOOST_TEST(has(why, "stages must be between 1 and 9"));
    }
    BOOST_TEST(has(message([] { sc::lobatto_iiic(1); }), "between 2 and"));
}

BOOST_AUTO_TEST_CASE(progress_is_told_in_parts_and_may_cancel) {
    std::vector<double> told;
    const auto method = sc::radau_iia(3);
    const sc::options<double> o{.fixed_step = 0.01};
    BOOST_TEST(sc::integrate(method, circle, Vector2d(0, 1), 2, 1, o,
                             sc::progress([&](double p) { told.push_back(p); }, 0.25))
                   .ok());
    BOOST_REQUIRE(told.size() == 4u);
    for (int k = 0; k < 4; ++k)
        BOOST_TEST(std::abs(told[static_cast<std::size_t>(k)] - 0.25 * (k + 1)) < 0.011);
    BOOST_TEST(told.back() == 1);
    const auto cancelled = sc::integrate(method, circle, Vector2d(0, 1), 2, 1, o,
                                         sc::progress([](double p) { return p < 0.5; }, 0.1));
    BOOST_TEST((cancelled.status == sc::status::stopped));
    BOOST_TEST(std::abs(cancelled.t - 1.5) < 0.011);
    BOOST_CHECK_THROW(sc::progress([](double) {}, 0), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_run_is_written_as_a_table_that_reads_back_to_the_bit) {
    const sc::options<double> o{.fixed_step = 0.25};
    std::stringstream file;
    auto table = sc::csv(file, {"x", "y"});
    const auto r = sc::integrate(sc::radau_iia<3>(), circle, Vector2d(0, 1), 0, 1, o, table);
    std::string line, last;
    std::getline(file, line);
    BOOST_TEST(line == "t,x,y");
    std::getline(file, line);
    BOOST_TEST(line == "0,0,1");
    int rows = 1;
    for (; std::getline(file, line); ++rows) last = line;
    BOOST_TEST(rows == 5);
    double t = 0, x = 0, y = 0;
    char comma;
    std::istringstream(last) >> t >> comma >> x >> comma >> y;
    BOOST_TEST((t == 1 && x == r.y[0] && y == r.y[1]));
    std::ostringstream objects;
    auto row = sc::json_lines(objects);
    row(0.5, Vector2d(-1, 0.1));
    BOOST_TEST(objects.str() == "{\"t\": 0.5, \"y0\": -1, \"y1\": 0.10000000000000001}\n");
    BOOST_CHECK_THROW(sc::csv(file, {"a,b"}), std::invalid_argument);
    auto short_of_one = sc::csv(file, {"x"});
    BOOST_CHECK_THROW(short_of_one(0.5, Vector2d(0, 1)), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_method_without_embedded_weights_is_refused_with_what_helps) {
    const auto why = message([] { sc::integrate(sc::lobatto_iiia(3), circle, Vector2d(0, 1), 0, 1); });
    BOOST_TEST(has(why, "step_doubling(method)"));
}

BOOST_AUTO_TEST_CASE(a_status_is_printed_as_a_word) {
    std::ostringstream out;
    out << sc::integrate(sc::radau_iia<3>(), circle, Vector2d(0, 1), 0, 1).status << ", "
        << sc::status::stopped;
    BOOST_TEST(out.str() == "success, stopped");
}

BOOST_AUTO_TEST_CASE(a_generic_right_hand_side_may_fill_f_with_commas) {
    const auto commas = [](const auto&, const auto& y, auto& f) { f << y[1], -y[0]; };
    const auto r = sc::integrate(sc::radau_iia<3>(), commas, Vector2d(0, 1), 0, 1);
    BOOST_TEST(r.y[0] == std::sin(1.0), boost::test_tools::tolerance(1e-5));
}

// As it is written for doubles; the Jacobian is exact all the same.
BOOST_AUTO_TEST_CASE(a_generic_right_hand_side_may_call_the_functions_of_std) {
    const auto pendulum = [](const auto& t, const auto& y, auto& f) {
        f[0] = y[1];
        f[1] = -std::sin(y[0]) + std::pow(2.0, -t) * std::max(y[1], -0.5);
    };
    const auto by_hand = [](const auto& t, const auto& y, auto& f) {
        using std::sin, std::pow, std::max;
        f[0] = y[1];
        f[1] = -sin(y[0]) + pow(2.0, -t) * max(y[1], -0.5);
    };
    const auto r = sc::integrate(sc::radau_iia<3>(), pendulum, Vector2d(0, 1), 0, 1);
    const auto expected = sc::integrate(sc::radau_iia<3>(), by_hand, Vector2d(0, 1), 0, 1);
    BOOST_TEST((r.y == expected.y));
    BOOST_TEST((r.report.found.jacobian == expected.report.found.jacobian));
    BOOST_TEST(r.report.f == expected.report.f);
}

BOOST_AUTO_TEST_CASE(a_generic_right_hand_side_may_take_everything_by_reference) {
    const auto careless = [](auto&, auto& y, auto& f) { f[0] = y[1], f[1] = -y[0]; };
    const auto forwarding = [](auto&&, auto&& y, auto&& f) { f[0] = y[1], f[1] = -y[0]; };
    const auto expected = sc::integrate(sc::radau_iia<3>(), circle, Vector2d(0, 1), 0, 1).y;
    BOOST_TEST((sc::integrate(sc::radau_iia<3>(), careless, Vector2d(0, 1), 0, 1).y == expected));
    BOOST_TEST((sc::integrate(sc::radau_iia<3>(), forwarding, Vector2d(0, 1), 0, 1).y == expected));
}

BOOST_AUTO_TEST_CASE(output_times_are_given_as_a_list_or_as_a_vector) {
    sc::output_times<Vector2d> list({0, 0.5, 1}), vector(Eigen::VectorXd::LinSpaced(3, 0, 1));
    for (auto* table : {&list, &vector}) {
        sc::integrate(sc::radau_iia<3>(), circle, Vector2d(0, 1), 0, 1, {}, *table);
        BOOST_TEST((table->filled() == 3 && table->time(1) == 0.5));
        BOOST_TEST(table->y(1)[0] == std::sin(0.5), boost::test_tools::tolerance(1e-5));
    }
}

// Eigen compares sizes that the compiler does not know by assertions, which a release build leaves out.
BOOST_AUTO_TEST_CASE(a_returned_vector_of_another_size_ends_the_run) {
    const auto shorter = [](double, const Vector2d&) -> Eigen::VectorXd { return Eigen::VectorXd::Ones(1); };
    const auto longer = [](double, const Vector2d&) -> Eigen::VectorXd { return Eigen::VectorXd::Ones(5); };
    const auto square = [](double, const Eigen::VectorXd&) -> Eigen::MatrixXd {
        return Eigen::MatrixXd::Ones(2, 2);
    };
    const auto right = [](double, const Vector2d&) -> Eigen::VectorXd { return Eigen::VectorXd::Ones(2); };
    const auto status_of = [](const auto& f, const auto& y0) {
        return sc::name(sc::integrate(sc::radau_iia<3>(), f, y0, 0, 1).status);
    };
    BOOST_TEST(status_of(shorter, Vector2d(0, 0)) == "size_changed");
    BOOST_TEST(status_of(longer, Vector2d(0, 0)) == "size_changed");
    BOOST_TEST(status_of(square, Eigen::VectorXd(Vector2d(0, 0))) == "size_changed");
    BOOST_TEST(status_of(right, Vector2d(0, 0)) == "success");
}
