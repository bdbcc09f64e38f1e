// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE distributed
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/families.hpp>
#include <stagecraft/integrate.hpp>
#include <stdexcept>
#include <string>

#include "methods.hpp"
#include "two_parts.hpp"

// A state spread over processes (problem.add_up), here two threads.
namespace sc = stagecraft;
using namespace two_parts;

BOOST_AUTO_TEST_CASE(radau_iia_of_three_five_and_seven_stages_takes_the_steps_of_the_whole_problem) {
    for (int s : {3, 5, 7}) {
        const auto method = sc::radau_iia(s);
        same_steps<part_of>(method, brusselator{}, 5, 6, usual);
        same_steps<part_with_mass>(method, algebraic{{}, 1}, 40, 2, {.rtol = 1e-6, .atol = 1e-10});
        same_steps<part_with_mass>(method, algebraic{{}, 2}, 3, 4, usual);
        same_steps<part_with_mass>(method, algebraic{{}, 2}, 3, 1,
                                   {.rtol = 1e-6, .atol = 1e-8, .continuous = true});
    }
}

BOOST_AUTO_TEST_CASE(a_part_of_no_components_takes_part) {
    same_steps<part_of>(sc::radau_iia(3), brusselator{}, 5, 0, usual);
}

namespace {

// How the two parts of a run end, by status; both within the time that in_two_threads gives them.
template <class Change>
std::array<sc::result<VectorXd>, 2> ends(const brusselator& problem, const sc::options<double>& o,
                                         Change change) {
    meeting with;
    return in_two_threads<part_of>(
        problem, problem.start(), 6,
        [&](const auto& part, VectorXd y) {
            change(part.rank, y);
            const auto watch = [&](double t, const VectorXd& now) {
                (void)now;
                return !(t > 2 && part.rank == 1);
            };
            return sc::integrate(sc::radau_iia(3), part, y, 0.0, 5.0, o, watch);
        },
        with);
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_throws_on_one_process_ends_the_run_on_both) {
    for (const double from : {-1.0, 1e-9, 0.7}) {
        brusselator problem;
        problem.from = from;
        const auto end = ends(problem, usual, [](int, VectorXd&) {});
        BOOST_TEST(int(end[0].status) == int(sc::status::non_finite));
        BOOST_TEST(int(end[1].status) == int(sc::status::function_threw));
        BOOST_CHECK_THROW(std::rethrow_exception(end[1].exception), std::runtime_error);
        BOOST_TEST(end[0].t == end[1].t);
        BOOST_TEST(end[0].t <= std::max(from, 0.0));
        BOOST_TEST(end[0].y.allFinite());
    }
}

BOOST_AUTO_TEST_CASE(an_observer_that_stops_on_one_process_stops_both) {
    const auto end = ends({}, usual, [](int, VectorXd&) {});
    for (const auto& r : end) BOOST_TEST(int(r.status) == int(sc::status::stopped));
    BOOST_TEST(end[0].t == end[1].t);
    BOOST_TEST(end[0].t > 2);
}

BOOST_AUTO_TEST_CASE(an_argument_refused_on_one_process_is_refused_on_both) {
    const brusselator problem;
    meeting with;
    const auto said = in_two_threads<part_of>(
        problem, problem.start(), 6,
        [](const auto& part, VectorXd y) {
            if (part.rank == 1) y[3] = NAN;
            try {
                sc::integrate(sc::radau_iia(3), part, y, 0.0, 5.0);
            } catch (const std::invalid_argument& e) {
                return std::string(e.what());
            }
            return std::string();
        },
        with);
    BOOST_TEST(said[0] == "integrate: an argument has been refused on another process");
    BOOST_TEST(said[1] == "integrate: y0 must be finite");
}

BOOST_AUTO_TEST_CASE(processes_with_other_options_are_refused_on_both) {
    const brusselator problem;
    const auto differing = [&](auto change) {
        meeting with;
        return in_two_threads<part_of>(
            problem, problem.start(), 6,
            [&](const auto& part, const VectorXd& y) {
                sc::options<double> o = usual;
                double t1 = 1;
                if (part.rank == 1) change(o, t1);
                try {
                    sc::integrate(sc::radau_iia(3), part, y, 0.0, t1, o);
                } catch (const std::invalid_argument& e) {
                    return std::string(e.what());
                }
                return std::string();
            },
            with);
    };
    const std::string message =
        "integrate: the method, t0, t1 and the options must be the same on all processes";
    for (const auto& said :
         {differing([](auto&o, double&) { o.rtol = 2e-6; }), differing([](auto&, double&t1) { t1 = 1.5; }),
          differing([](auto&o, double&) { o.max_steps = 7; })})
        for (const auto& one : said) BOOST_TEST(one == message);
    // Those of the components may differ.
    for (const auto& said :
         differing([](auto&o, double&) { o.atol_components = VectorXd::Constant(10, 1e-9); }))
        BOOST_TEST(said == "");
}

namespace {

// What goes wrong with the linear systems of part 1, in and after the fifth factorisation.
enum class wrong { singular, throws, solve_throws, solve_is_nan };
struct failing_blocks : gathered_blocks {
    inline static wrong how;

    template <class Solver>
    class failing : public Solver {
      public:
        using Solver::Solver;
        template <class Mass, class... Shift>
        bool factor_shifted(const Mass& mass, const shared_matrix& J, const Shift&... shift) {
            now_ = J.rank == 1 && ++count_ > 4;
            const bool done = Solver::factor_shifted(mass, J, shift...);
            if (now_ && how == wrong::throws) throw std::runtime_error("a factorisation");
            return done && !(now_ && how == wrong::singular);
        }
        template <class... Rest>
        void solve(double* x, Rest... y) {
            Solver::solve(x, y...);
            if (now_ && how == wrong::solve_throws) throw std::runtime_error("a solve");
            if (now_ && how == wrong::solve_is_nan) x[0] = NAN;
        }

      private:
        int count_ = 0;
        bool now_ = false;
    };
    using real = failing<gathered_blocks::real>;
    using complex = failing<gathered_blocks::complex>;
};
template <class Whole>
struct part_that_fails : part_of<Whole> {
    using linear_solver = failing_blocks;
};

}  // namespace

BOOST_AUTO_TEST_CASE(linear_systems_that_fail_on_one_process_end_the_run_on_both) {
    const brusselator problem;
    const auto run = [&](const auto& method, wrong how) {
        failing_blocks::how = how;
        meeting with;
        const auto end = in_two_threads<part_that_fails>(
            problem, problem.start(), 6,
            [&](const auto& part, const VectorXd& y) {
                return sc::integrate(method, part, y, 0.0, 5.0, usual);
            },
            with);
        const bool threw = how == wrong::throws || how == wrong::solve_throws;
        BOOST_TEST(int(end[1].status) == int(threw ? sc::status::function_threw : end[0].status));
        BOOST_TEST(int(end[0].status) ==
                   int(how == wrong::singular ? sc::status::singular_matrix : sc::status::non_finite));
        BOOST_TEST(bool(end[1].exception) == threw);
        BOOST_TEST(end[0].t == end[1].t);
        BOOST_TEST(end[0].t < 5);
        for (const auto& r : end) BOOST_TEST(r.y.allFinite());
    };
    for (const wrong how : {wrong::singular, wrong::throws, wrong::solve_throws, wrong::solve_is_nan}) {
        run(sc::radau_iia(3), how);
        run(sc::radau_iia(5), how);
        run(methods::tr_bdf2(), how);
    }
}

BOOST_AUTO_TEST_CASE(an_observer_that_cannot_start_on_one_process_ends_the_run_on_both) {
    struct unwilling {
        int rank;
        void start(double, const VectorXd&, double) const {
            if (rank == 1) throw std::runtime_error("no file");
        }
        bool operator()(double, const VectorXd&) const { return true; }
    };
    const brusselator problem;
    meeting with;
    const auto said = in_two_threads<part_of>(
        problem, problem.start(), 6,
        [](const auto& part, const VectorXd& y) {
            try {
                const auto r =
                    sc::integrate(sc::radau_iia(3), part, y, 0.0, 5.0, usual, unwilling{part.rank});
                return std::string(name(r.status));
            } catch (const std::runtime_error& e) {
                return std::string(e.what());
            }
        },
        with);
    BOOST_TEST(said[1] == "no file");
    BOOST_TEST(said[0] == name(sc::status::non_finite));
}

namespace {

struct doubled {  // as if another process had the same components
    static constexpr bool complete = false;
    void operator()(double* x, int k) const {
        for (int i = 0; i < k; ++i) x[i] *= 2;
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(norms_over_processes_are_finite_where_the_products_are) {
    const doubled sums;
    const VectorXd ones = VectorXd::Ones(3), large = 1e300 * ones, small = VectorXd{{3, 4, 0}};
    BOOST_TEST(sc::weighted_norm(small, ones, 3, sums) == std::sqrt(25.0 / 3),
               boost::test_tools::tolerance(1e-15));
    BOOST_TEST(sc::weighted_norm(large, ones, 3, sums) == 1e300, boost::test_tools::tolerance(1e-14));
    BOOST_TEST(!std::isfinite(sc::weighted_norm(large, large, 3, sums)));
    BOOST_TEST(std::isnan(sc::weighted_norm(VectorXd(NAN * ones), ones, 3, sums)));
    BOOST_TEST(sc::weighted_norm(VectorXd(), VectorXd(), 0, sums) == 0.0);
}
