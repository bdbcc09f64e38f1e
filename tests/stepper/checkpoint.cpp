// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE checkpoint
#include <boost/test/unit_test.hpp>
#include <sstream>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/radau_ia.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/observe/save_every.hpp>
#include <stagecraft/steps.hpp>
#include <stdexcept>
#include <string>
#include <utility>

#include "../message.hpp"
#include "interrupt.hpp"
#include "methods.hpp"

namespace sc = stagecraft;
using Eigen::Vector2d;

namespace {

bool contains(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

// Van der Pol's equation with a jump of f at t = 0.7, so that all that a run remembers is in use.
struct relaxation {
    double mu = 1000;
    void operator()(double t, const Vector2d& y, Vector2d& f) const {
        f[0] = y[1];
        f[1] = mu * ((1 - y[0] * y[0]) * y[1] - y[0]) + (t > 0.7 ? 40 : 0);
    }
};
const Vector2d start(2, 0);

sc::checkpoint<Vector2d> halfway(const sc::options<double>& o) {
    sc::checkpoint<Vector2d> last;
    auto keep = sc::save_every(10, [&](auto point) {
        if (point.t < 0.5) last = std::move(point);
    });
    BOOST_TEST(sc::integrate(sc::radau_iia<3>(), relaxation{10}, start, 0, 1, o, keep).ok());
    return last;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_run_continued_is_the_run_uninterrupted) {
    interrupted::at_five_places(sc::radau_iia<3>(), relaxation{10}, start, 2, {.rtol = 1e-7});
    interrupted::at_five_places(sc::radau_iia<3>(), relaxation{10}, start, 2, {.fixed_step = 0.01});
}

BOOST_AUTO_TEST_CASE(also_by_explicit_and_diagonally_implicit_methods) {
    for (const auto& method : {methods::dormand_prince(), methods::tr_bdf2(), methods::sdirk_4_3()})
        interrupted::at_five_places(method, relaxation{10}, start, 2, {.rtol = 1e-7});
}

BOOST_AUTO_TEST_CASE(a_checkpoint_of_something_else_is_refused) {
    const sc::options<double> free{}, equal{.fixed_step = 0.01};
    const auto point = halfway(free), of_equal = halfway(equal);
    const auto go_on = [](const auto& method, const auto& from, double t1, const sc::options<double>& o) {
        return message([&] { sc::integrate(method, relaxation{10}, from, t1, o); });
    };
    BOOST_TEST(go_on(sc::radau_iia<3>(), point, 2, free) == "no exception");
    BOOST_TEST(contains(go_on(methods::dormand_prince(), point, 1, free), "another method"));
    const auto also_three_stages = methods::tr_bdf2();
    BOOST_TEST(contains(go_on(also_three_stages, point, 1, free), "another method"));
    BOOST_TEST(contains(go_on(sc::gauss<3>(), point, 1, free),
                        "another method: of 3 stages and order 5, and not of 3 and 6"));
    BOOST_TEST(contains(go_on(sc::radau_iia<5>(), point, 1, free), "order 5, and not of 5 and 9"));
    BOOST_TEST(contains(go_on(sc::radau_ia<3>(), point, 1, free), "another method: of as many stages"));
    auto other_weights = methods::dormand_prince(), pair = other_weights;
    other_weights.b_embedded = (pair.b + pair.b_embedded) / 2;
    sc::checkpoint<Vector2d> explicit_point;
    auto keep = sc::save_every(10, [&](auto p) { explicit_point = std::move(p); });
    BOOST_TEST(sc::integrate(pair, relaxation{10}, start, 0, 1, free, keep).ok());
    BOOST_TEST(go_on(pair, explicit_point, 2, free) == "no exception");
    BOOST_TEST(contains(go_on(other_weights, explicit_point, 2, free), "of other coefficients"));
    auto several = point;  // as of a method of several, the first of them with three stages
    several.counts.insert(several.counts.begin(), point.counts.begin(), point.counts.begin() + 4);
    several.numbers.insert(several.numbers.begin(), point.numbers.front());
    BOOST_TEST(contains(go_on(sc::radau_iia<3>(), several, 1, free), "another method"));
    BOOST_TEST(contains(go_on(sc::radau_iia<3>(), point, 1, equal), "fixed_step"));
    BOOST_TEST(contains(go_on(sc::radau_iia<3>(), of_equal, 2, equal), "another t1"));
    auto longer = point;
    longer.numbers.push_back(1);
    BOOST_TEST(contains(go_on(sc::radau_iia<3>(), longer, 1, free), "another method or problem"));
    for (const char* text : {"", "stagecraft checkpoint 0\n", "stagecraft checkpoint 3\nt 1\n3ff\n"}) {
        std::istringstream file(text);
        sc::checkpoint<Vector2d> read;
        BOOST_CHECK_THROW(file >> read, std::invalid_argument);
    }
    std::ostringstream text;
    text << sc::checkpoint<Vector2d>{1.5, Vector2d(1, -2), {}, {7}, {}};
    BOOST_TEST(
        text.str() ==
        "stagecraft checkpoint 3\nt 1\n3ff8000000000000\ny 2\n3ff0000000000000\nc000000000000000\n"
        "numbers 0\ncounts 1\n7\noptions 0\nchoices 0\natol_components 0\nchecksum 5612763885660055494\n");
    // One bit that is not as it was written.
    const std::string written = text.str();
    for (std::size_t i = 0; i < written.size(); ++i)
        for (int bit = 0; bit < 8; ++bit) {
            std::string flipped = written;
            flipped[i] = static_cast<char>(flipped[i] ^ (1 << bit));
            std::istringstream file(flipped);
            sc::checkpoint<Vector2d> read;
            BOOST_CHECK_THROW(file >> read, std::invalid_argument);
        }
    std::istringstream file(written);
    sc::checkpoint<Vector2d> read;
    file >> read;
    BOOST_TEST(read.y == Vector2d(1, -2));
}

BOOST_AUTO_TEST_CASE(a_run_goes_on_with_its_own_options_unless_others_are_given) {
    const sc::options<double> all{.rtol = 3e-9,
                                  .atol_components = {1e-9, 2e-7},
                                  .initial_step = 1e-4,
                                  .min_step = 1e-12,
                                  .max_step = 0.05,
                                  .control = sc::step_control::proportional_integral,
                                  .continuous = true,
                                  .jumps = false,
                                  .max_steps = 5000,
                                  .newton_iterations = 9,
                                  .newton_factor = 0.01};
    const auto method = sc::radau_iia<3>();
    const relaxation problem{10};
    for (const auto& o : {all, sc::options<double>{.rtol = 1e-9, .atol = 1e-12}}) {
        const auto whole = sc::integrate(method, problem, start, 0, 1, o);
        std::stringstream file;
        file << halfway(o);
        sc::checkpoint<Vector2d> point;
        file >> point;
        long seen = 0;
        const auto count = [&](double, const Vector2d&) { ++seen; };
        auto loop = sc::steps(method, problem, point, 1);
        for (const auto& step : loop) static_cast<void>(step);
        const auto rest = sc::integrate(method, problem, point, 1);
        const auto watched = sc::integrate(method, problem, point, 1, {}, count);
        BOOST_TEST((rest.y == whole.y));
        BOOST_TEST((watched.y == whole.y));
        BOOST_TEST((loop.y() == whole.y));
        BOOST_TEST(interrupted::same(rest.report, whole.report));
        BOOST_TEST(seen > 0);
        BOOST_TEST((sc::integrate(method, problem, point, 1, sc::options<double>{}).y != whole.y));
        BOOST_TEST((sc::integrate(method, problem, point, 1, {.rtol = 1e-5}, count).y != whole.y));
    }
    const auto equal = halfway({.fixed_step = 0.01});
    BOOST_TEST((sc::integrate(method, problem, equal, 1).y ==
                sc::integrate(method, problem, start, 0, 1, {.fixed_step = 0.01}).y));
}

BOOST_AUTO_TEST_CASE(a_file_of_version_2_is_read_and_needs_options) {
    std::istringstream file(
        "stagecraft checkpoint 2\nt 1\n3ff8000000000000\ny 2\n3ff0000000000000\nc000000000000000\n"
        "numbers 0\ncounts 1\n7\nchecksum 12061889195501014478\n");
    sc::checkpoint<Vector2d> read;
    file >> read;
    BOOST_TEST(read.t == 1.5);
    BOOST_TEST(read.counts.size() == 1u);
    BOOST_TEST(!read.options.has_value());
    auto point = halfway({.rtol = 1e-8});
    point.options.reset();
    const auto go_on = [&] { sc::integrate(sc::radau_iia<3>(), relaxation{10}, point, 1); };
    BOOST_TEST(contains(message(go_on), "the checkpoint is without the options of its run: give them"));
    BOOST_TEST((sc::integrate(sc::radau_iia<3>(), relaxation{10}, point, 1, {.rtol = 1e-8}).y ==
                sc::integrate(sc::radau_iia<3>(), relaxation{10}, start, 0, 1, {.rtol = 1e-8}).y));
}
