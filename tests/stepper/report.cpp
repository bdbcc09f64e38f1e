// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE report
#include <array>
#include <boost/test/unit_test.hpp>
#include <chrono>
#include <sstream>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/problem/time_split.hpp>
#include <stagecraft/report_text.hpp>
#include <string>

#include "methods.hpp"

namespace sc = stagecraft;
using Eigen::Vector2d;

namespace {

// A second passes at every reading.
struct counting_clock {
    using duration = std::chrono::duration<double>;
    using time_point = std::chrono::time_point<counting_clock, duration>;
    inline static long readings = 0;
    static time_point now() { return time_point(duration(static_cast<double>(++readings))); }
};

struct van_der_pol {
    template <class S>
    void operator()(const S&, const Eigen::Matrix<S, 2, 1>& y, Eigen::Matrix<S, 2, 1>& f) const {
        f[0] = y[1];
        f[1] = ((1.0 - y[0] * y[0]) * y[1] - y[0]) / 1e-4;
    }
};
struct by_differences {
    void operator()(double t, const Vector2d& y, Vector2d& f) const { van_der_pol{}(t, y, f); }
};

template <class Problem, class Method = sc::transformed_tableau<double, 3>>
auto run(const Problem& problem, const Method& method = sc::radau_iia<3>()) {
    return sc::integrate(method, problem, Vector2d(2, -0.66), 0, 2, {.rtol = 1e-7, .atol = 1e-7});
}

template <class Problem, class Method = sc::transformed_tableau<double, 3>>
void check_split(const Problem& problem, const Method& method = sc::radau_iia<3>()) {
    const auto plain = run(problem, method);
    BOOST_TEST(plain.ok());
    counting_clock::readings = 0;
    sc::time_split split;
    const auto timed = run(sc::with_time_split<counting_clock>(problem, split), method);
    // The same run, with each piece of work between two readings of the clock, and the whole between two
    // more.
    BOOST_TEST((timed.y == plain.y));
    const auto& r = timed.report;
    BOOST_TEST(r.steps == plain.report.steps);
    BOOST_TEST(r.f == plain.report.f);
    BOOST_TEST(split.f == static_cast<double>(r.f));
    BOOST_TEST(split.jacobian == static_cast<double>(r.jacobians));
    BOOST_TEST(split.factorisation == static_cast<double>(r.factorisations));
    BOOST_TEST(split.solves == static_cast<double>(r.solves + r.error_solves));
    const long pieces = r.f + r.jacobians + r.factorisations + r.solves + r.error_solves;
    BOOST_TEST(counting_clock::readings == 2 * pieces + 2);
    BOOST_TEST(split.total == static_cast<double>(2 * pieces + 1));
    BOOST_TEST(split.rest() == static_cast<double>(pieces + 1));
    // A second run adds to the first.
    run(sc::with_time_split<counting_clock>(problem, split), method);
    BOOST_TEST(split.f == 2 * static_cast<double>(r.f));
    // Without it the clock stands still.
    counting_clock::readings = 0;
    run(problem, method);
    BOOST_TEST(counting_clock::readings == 0);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_time_split_measures_every_piece_of_work_and_only_when_asked) {
    check_split(van_der_pol{});
    check_split(by_differences{});
    check_split(van_der_pol{}, methods::sdirk_4_3());
}

BOOST_AUTO_TEST_CASE(a_run_without_a_time_split_holds_nothing_for_it) {
    using plain = sc::system<const van_der_pol, Vector2d>;
    using timed =
        sc::system<const decltype(sc::with_time_split(van_der_pol{}, std::declval<sc::time_split&>())),
                   Vector2d>;
    static_assert(!sc::has_stopwatch<const van_der_pol>);
    BOOST_TEST(sizeof(plain) < sizeof(timed));
}

BOOST_AUTO_TEST_CASE(the_steady_clock_gives_seconds_that_add_up) {
    sc::time_split split;
    run(sc::with_time_split(van_der_pol{}, split));
    BOOST_TEST(split.f > 0);
    BOOST_TEST(split.factorisation > 0);
    BOOST_TEST(split.rest() > 0);
    BOOST_TEST(split.total < 60);
}

BOOST_AUTO_TEST_CASE(a_report_is_printed_with_the_reason) {
    sc::report<double> r;
    r.steps = 12;
    r.rejected_error = 2;
    r.rejected_newton = 1;
    r.f = 345;
    r.f_jacobian = 20;
    r.jacobians = 10;
    r.factorisations = 11;
    r.solves = 110;
    r.error_solves = 14;
    r.smallest_step = 0.001;
    r.largest_step = 0.5;
    r.smallest_stages = 3;
    r.largest_stages = 5;
    std::ostringstream text;
    text.precision(17);
    sc::print(text, sc::result<Vector2d>{0.1, {1, 2}, sc::status::newton_failed, r, nullptr});
    BOOST_TEST(text.str() ==
               "newton_failed at t = 0.10000000000000001: the stage equations could not be solved with any "
               "admissible step\n"
               "steps                   12  from 0.001 to 0.5, 3 to 5 stages\n"
               "rejected                 3  2 by the error test, 1 by Newton\n"
               "f                      345  and 20 in Jacobians\n"
               "Jacobians               10\n"
               "factorisations          11\n"
               "solves                 110  and 14 error estimates\n");
    BOOST_TEST(text.precision() == 17);

    std::ostringstream seconds;
    sc::print(seconds, sc::time_split{0.5, 0.25, 0.125, 0.0625, 1});
    BOOST_TEST(seconds.str() ==
               "f                 5.00e-01 s   50.0 %\n"
               "Jacobian          2.50e-01 s   25.0 %\n"
               "factorisation     1.25e-01 s   12.5 %\n"
               "solves            6.25e-02 s    6.2 %\n"
               "rest              6.25e-02 s    6.2 %\n"
               "total             1.00e+00 s  100.0 %\n");
}

BOOST_AUTO_TEST_CASE(a_failure_with_a_mass_matrix_says_what_to_look_at) {
    sc::report<double> r;
    const auto says = [&](sc::status s, const std::string& what) {
        std::ostringstream text;
        sc::print(text, sc::result<Vector2d>{0, {1, 2}, s, r, nullptr});
        return text.str().find(what) != std::string::npos;
    };
    BOOST_TEST(!says(sc::status::step_underflow, "look at"));
    r.found.add(sc::capability::mass);
    BOOST_TEST(says(sc::status::step_underflow, "problem.index() has to name components of index 2 and 3"));
    BOOST_TEST(says(sc::status::singular_matrix, "look at the constraints"));
    BOOST_TEST(says(sc::status::singular_matrix, "there is no problem.index()"));
    BOOST_TEST(!says(sc::status::success, "look at"));
    r.found.add(sc::capability::index);
    BOOST_TEST(!says(sc::status::singular_matrix, "there is no problem.index()"));
    BOOST_TEST(says(sc::status::non_finite, "look at y0, which has to satisfy the constraints"));
    r.steps = 1;
    BOOST_TEST(!says(sc::status::non_finite, "look at"));
}

BOOST_AUTO_TEST_CASE(
    rejections_by_newton_cast_doubt_on_a_jacobian_and_tiny_steps_on_a_right_hand_side_that_switches) {
    const auto text = [](const auto& problem, const Vector2d& y0, const sc::options<double>& o,
                         const auto& method) {
        std::ostringstream out;
        sc::print(out, sc::integrate(method, problem, y0, 0, 2, o));
        return out.str();
    };
    const auto has = [](const std::string& s, const char* part) { return s.find(part) != std::string::npos; };
    struct with_jacobian : by_differences {
        double sign = 1;
        void jacobian(double, const Vector2d& y, Eigen::Matrix2d& J) const {
            J << 0, sign, sign * (-2 * y[0] * y[1] - 1) / 1e-4, sign * (1 - y[0] * y[0]) / 1e-4;
        }
    };
    struct relay {
        void operator()(double, const Vector2d& y, Vector2d& f) const {
            f << y[1], y[0] + y[1] > 0 ? -1.0 : 1.0;
        }
    };
    const auto wrong = text(with_jacobian{{}, -1}, {2, -0.66}, {}, sc::radau_iia<3>());
    BOOST_TEST(has(wrong, "look at problem.jacobian()"));
    BOOST_TEST(!has(wrong, "f may switch"));
    const auto right = text(with_jacobian{}, {2, -0.66}, {}, sc::radau_iia<3>());
    BOOST_TEST(has(right, "success"));
    BOOST_TEST(!has(right, "look at problem.jacobian()"));
    for (const auto& slides : {text(relay{}, {1, 0.5}, {.max_steps = 20000}, sc::radau_iia<3>()),
                               text(relay{}, {1, 0.5}, {.max_steps = 20000}, methods::sdirk_4_3())}) {
        BOOST_TEST(has(slides, "too_many_steps"));
        BOOST_TEST(has(slides, "f may switch in every step"));
    }
    const auto few = text(van_der_pol{}, {2, -0.66}, {.max_steps = 100}, sc::radau_iia<3>());
    BOOST_TEST(has(few, "too_many_steps"));
    BOOST_TEST(!has(few, "f may switch"));
}

BOOST_AUTO_TEST_CASE(a_report_names_the_members_that_were_found_and_the_tolerances) {
    struct problem : by_differences {
        std::array<int, 2> index() const { return {1, 1}; }
        Eigen::Matrix2d mas() const { return Eigen::Matrix2d::Identity(); }  // misspelt
    };
    const auto lines = [](const auto& p, const auto& method, const sc::options<double>& o) {
        std::ostringstream text;
        sc::print(text, sc::integrate(method, p, Vector2d(2, -0.66), 0, 1e-5, o).report);
        return text.str().substr(0, text.str().find("\nsteps") + 1);
    };
    BOOST_TEST(lines(problem{}, sc::radau_iia<3>(), {.rtol = 1e-9}) ==
               "problem         f, index; Jacobian by finite differences\n"
               "tolerances      rtol 1e-09, atol 1e-06 (the default: components smaller than that are "
               "not controlled, and it rules where |y| < 1e+03)\n");
    BOOST_TEST(lines(problem{}, sc::radau_iia<3>(), {}) ==
               "problem         f, index; Jacobian by finite differences\n"
               "tolerances      rtol 1e-06, atol 1e-06 (the default: components smaller than that are "
               "not controlled)\n");
    BOOST_TEST(lines(problem{}, sc::radau_iia<3>(), {.fixed_step = 1e-6}) ==
               "problem         f, index; Jacobian by finite differences\n"
               "tolerances      rtol 1e-06, atol 1e-06\n");
    BOOST_TEST(lines(van_der_pol{}, sc::radau_iia<3>(), {.rtol = 1e-7, .atol = 1e-7}) ==
               "problem         f; Jacobian by automatic differentiation\n"
               "tolerances      rtol 1e-07, atol 1e-07\n");
    BOOST_TEST(lines(van_der_pol{}, methods::sdirk_4_3(), {.atol_components = Vector2d(1e-3, 1e-6)}) ==
               "problem         f; Jacobian by automatic differentiation\n"
               "tolerances      rtol 1e-06, atol by component\n");
}

BOOST_AUTO_TEST_CASE(every_status_has_a_name_and_a_reason) {
    for (int k = 0; k <= static_cast<int>(sc::status::function_threw); ++k) {
        const auto s = static_cast<sc::status>(k);
        BOOST_TEST(std::string(sc::name(s)) != "unknown");
        BOOST_TEST(std::string(sc::reason(s)) != "unknown");
    }
    BOOST_TEST(sc::reason(static_cast<sc::status>(99)) == "unknown");
}
