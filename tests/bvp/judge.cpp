// SPDX-License-Identifier: BSL-1.0
// What decides boundary value problems, on plain numbers: no problem is solved here.
#define BOOST_TEST_MODULE bvp_judge
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stagecraft/bvp/judge/growing_period.hpp>
#include <stagecraft/bvp/judge/kernel_judge.hpp>
#include <stagecraft/bvp/judge/lifting_pass.hpp>
#include <stagecraft/bvp/judge/mesh_judge.hpp>
#include <stagecraft/bvp/judge/mesh_refinement.hpp>
#include <stagecraft/bvp/judge/multiplier_judge.hpp>
#include <stagecraft/bvp/judge/newton_damping.hpp>
#include <utility>
#include <vector>

using namespace stagecraft::detail;
using stagecraft::bvp_status;
using stagecraft::damped_newton_end;
using enum quantity;
using enum mesh_act;
using evidence = mesh_evidence<double>;
using history = mesh_history<double>;
using reader = evidence_reader<double>;
using numbers = std::vector<std::pair<quantity, double>>;

namespace {

constexpr double none = std::numeric_limits<double>::infinity();
const mesh_limits<double> limits{1e-6, std::numeric_limits<double>::epsilon(), 100, true};
const mesh_judge<double> judge(limits);

evidence with(evidence e, const numbers& changes) {
    for (const auto& [q, value] : changes) e.set(q, value);
    return e;
}

// A well-posed problem, solved within the tolerance on ten intervals, with every number that anybody may ask for.
evidence good(const numbers& changes = {}) {
    evidence e;
    e.intervals = 10, e.linear = true, e.from_guess = false;
    const numbers all{{unresolved, 1e-5},
                      {evaluable, 1},
                      {error, 1e-7},
                      {jumps, 0},
                      {size, 1},
                      {missed_phase, 0},
                      {answer, 2},
                      {change, 0},
                      {translation, 0},
                      {error_bound, 0},
                      {mesh_error, 0},
                      {resolved, 1},
                      {kernel_radius, 0},
                      {singular_end, 0},
                      {kappa, 2},
                      {halved_kappa, 2},
                      {norm, 0},
                      {dependent, -1},
                      {residual, 1e-16},
                      {nonlinear, 0},
                      {contrast, 1},
                      {full_size, none},
                      {full_norm, -1},
                      {rounding, 1e-15},
                      {rounding_of_u, 1e-15},
                      {rounding_of_y, 1e-15},
                      {range, 1},
                      {next_intervals, 20}};
    return with(with(e, all), changes);
}
evidence nonlinear_problem(const numbers& changes = {}) {
    evidence e = good(changes);
    e.linear = false, e.set(nonlinear, 1);
    return e;
}
// After Newton's iteration has failed.
evidence failed(evidence e) {
    e.newton = damped_newton_end::failed, e.converged = false, e.remainder = 1;
    return e;
}

auto decided(const evidence& e, double error = 0) {
    const reader r(e);
    const auto found = regularity_judge<double>(r).decide(error);
    BOOST_TEST(!r.missing());
    return found;
}

// Acts and adds to the history, as the solver does; the last act.
mesh_act follow(history& h, const evidence& e, int times = 1) {
    mesh_act last = finish;
    for (int k = 0; k < times; ++k) {
        const auto v = judge(e, h);
        last = v.act, h.add(e, v, limits.rtol);
    }
    return last;
}

}  // namespace

BOOST_AUTO_TEST_CASE(evidence_reader_names_the_first_number_that_is_missing_and_a_judge_asks_for_no_other) {
    evidence e;
    e.set(error, 3);
    const reader r(e);
    BOOST_TEST(r(error) == 3);
    BOOST_TEST(!r.missing());
    BOOST_TEST(r(kappa) == 0);
    BOOST_TEST(r(norm) == 0);
    BOOST_CHECK(r.missing() == kappa);

    // A whole run of questions: each answer leads to the next one, and a verdict on a good mesh needs no others.
    evidence asked;
    asked.linear = true;
    const evidence all = good();
    std::vector<quantity> order;
    auto v = judge(asked, history{});
    for (; v.act == measure; v = judge(asked, history{})) {
        order.push_back(v.missing);
        asked.set(v.missing, all[v.missing]);
    }
    const std::vector<quantity> expected{evaluable, error,    kappa,         missed_phase, answer,
                                         norm,      rounding, rounding_of_y, range};
    BOOST_CHECK(order == expected);
    BOOST_CHECK(v.act == finish && v.status == bvp_status::success);
}

BOOST_AUTO_TEST_CASE(mesh_judge_does_not_depend_on_what_else_is_known) {
    for (const double e : {1e-7, 1e-3, 1.0}) {
        const evidence all = good({{error, e}});
        evidence asked;
        asked.intervals = 10, asked.linear = true, asked.from_guess = false;
        auto v = judge(asked, history{});
        for (; v.act == measure; v = judge(asked, history{})) asked.set(v.missing, all[v.missing]);
        const auto at_once = judge(all, history{});
        BOOST_CHECK(v.act == at_once.act);
        BOOST_CHECK(v.status == at_once.status);
    }
}

BOOST_AUTO_TEST_CASE(mesh_judge_follows_errors_and_spreads_where_the_first_digit_is_wrong) {
    BOOST_CHECK(judge(good(), history{}).status == bvp_status::success);
    BOOST_CHECK(judge(good({{error, 1e-3}}), history{}).act == refine);
    BOOST_CHECK(judge(good({{error, 0.2}}), history{}).act == mesh_act::spread);
    BOOST_CHECK(judge(good({{error, std::numeric_limits<double>::quiet_NaN()}}), history{}).act ==
                mesh_act::spread);
    // Where spreading has not helped twice, errors decide; meshes that do not halve the error are doubled.
    history h;
    follow(h, good({{error, 0.5}}), 3);
    BOOST_TEST(h.idle == 2);
    const auto v = judge(good({{error, 0.5}}), h);
    BOOST_CHECK(v.act == refine && v.doubled);
    // More intervals than are allowed.
    const auto many = judge(good({{error, 1e-3}, {next_intervals, 101}}), history{});
    BOOST_CHECK(many.status == bvp_status::too_many_intervals);
}

BOOST_AUTO_TEST_CASE(mesh_history_ends_a_search_that_gets_nowhere) {
    history h;
    int meshes = 0;
    for (double e = 1e-2; follow(h, good({{error, e}})) == refine; e *= 0.999) ++meshes;
    BOOST_TEST(meshes == mesh_judge<double>::most_stuck + 1);
    // An error that halves with every mesh goes on.
    history better;
    for (double e = 1e-2; e > 2e-6; e /= 2.1) BOOST_CHECK(follow(better, good({{error, e}})) == refine);
    // A jump of f counts from the third mesh in a row on.
    history jumped;
    const evidence jump = good({{error, 1e-3}, {jumps, 1}});
    for (const bool divided : {false, false, true}) {
        BOOST_TEST(judge(jump, jumped).divide == divided);
        follow(jumped, jump);
    }
    follow(jumped, good({{error, 1e-3}}));
    BOOST_TEST(!judge(jump, jumped).divide);
    // A new beginning from the guess forgets the errors before it, not the failures.
    h.error = 1;
    BOOST_CHECK(follow(h, failed(nonlinear_problem())) == finer_guess);
    BOOST_TEST(h.least == none);
    BOOST_TEST(h.failures == 1);
}

BOOST_AUTO_TEST_CASE(mesh_judge_refuses_nothing_on_trial) {
    evidence trial = good();
    trial.trial = true;
    BOOST_CHECK(judge(trial, history{}).status == bvp_status::success);
    for (const auto& [q, value] :
         numbers{{unresolved, 1e-2}, {evaluable, 0}, {rounding_of_y, 1}, {range, 1e20}}) {
        const auto v = judge(with(trial, {{q, value}}), history{});
        BOOST_CHECK(v.act == usual_mesh);
    }
    BOOST_CHECK(judge(failed(trial), history{}).act == usual_mesh);
    BOOST_CHECK(judge(with(trial, {{error, 1e-3}}), history{}).act == refine);
    history h;  // nor is its condition number remembered
    follow(h, with(trial, {{range, 1e20}}));
    BOOST_TEST(h.kappa < 0);
}

BOOST_AUTO_TEST_CASE(mesh_judge_begins_again_where_newtons_iteration_fails_and_says_so_in_the_end) {
    const evidence e = failed(nonlinear_problem());
    BOOST_CHECK(judge(e, history{}).act == finer_guess);
    history solved;
    follow(solved, good({{error, 1e-3}}));
    BOOST_CHECK(judge(e, solved).act == halve_last);
    history h;
    for (int k = 0; k < mesh_judge<double>::most_failures; ++k) {
        BOOST_TEST(judge.bold(h) == (k % 2 == 1));
        BOOST_CHECK(follow(h, e) == finer_guess);
    }
    const auto v = judge(e, h);
    BOOST_CHECK(v.act == finish && v.status == bvp_status::newton_failed);
    BOOST_TEST(words_of(v) == "Newton's iteration found no decrease");
    // With M of the iterate singular the message says so, and of which condition.
    const auto singular = judge(with(e, {{norm, 1e20}, {dependent, 2}}), h);
    BOOST_CHECK(singular.status == bvp_status::newton_failed);
    BOOST_TEST(words_of(singular) ==
               "Newton's iteration found no decrease; at its last iterate condition r[2] "
               "depends on those before it");
    // Twice as many intervals would be too many.
    evidence large = e;
    large.intervals = 51;
    BOOST_CHECK(judge(large, history{}).status == bvp_status::newton_failed);
    // f not finite at the guess, or between mesh points.
    evidence nan = e;
    nan.newton = damped_newton_end::non_finite, nan.from_guess = true;
    BOOST_CHECK(judge(nan, history{}).status == bvp_status::non_finite);
    nan.from_guess = false;
    BOOST_CHECK(judge(nan, history{}).act == finer_guess);
    BOOST_CHECK(judge(good({{evaluable, 0}}), history{}).act == straight);
    BOOST_CHECK(judge(good({{evaluable, 0}}), h).status == bvp_status::non_finite);
}

BOOST_AUTO_TEST_CASE(mesh_judge_leaves_a_guess_for_others_after_three_failures_or_too_much_work) {
    evidence e = failed(nonlinear_problem());
    e.other_guesses = 2;
    history h;
    for (int k = 0; k < mesh_judge<double>::failures_of_guess; ++k) BOOST_CHECK(follow(h, e) == finer_guess);
    BOOST_CHECK(follow(h, e) == other_guess);
    e.other_guesses = 0;
    BOOST_CHECK(follow(h, e) == finer_guess);
    e.dear = true;
    BOOST_CHECK(judge(e, h).status == bvp_status::newton_failed);
    e.other_guesses = 2;
    BOOST_CHECK(judge(e, history{}).act == other_guess);
    // From a solution that is good to a digit the mesh is halved, whatever f has cost.
    history solved;
    follow(solved, good({{error, 1e-3}}));
    BOOST_CHECK(judge(e, solved).act == halve_last);
}

BOOST_AUTO_TEST_CASE(mesh_judge_keeps_max_intervals_whatever_mesh_comes_next) {
    const int most = limits.max_intervals;
    const double more = most + 1;
    // From the values at mesh points, to a mesh that follows them.
    BOOST_CHECK(judge(good({{evaluable, 0}, {next_intervals, 1. * most}}), history{}).act == straight);
    BOOST_CHECK(judge(good({{evaluable, 0}, {next_intervals, more}}), history{}).status ==
                bvp_status::non_finite);
    // From the guess, whose mesh may be finer than that on which the iteration has failed.
    evidence e = failed(nonlinear_problem());
    e.guess_intervals = most / 2;
    BOOST_CHECK(judge(e, history{}).act == finer_guess);
    e.guess_intervals = most / 2 + 1;
    BOOST_CHECK(judge(e, history{}).status == bvp_status::newton_failed);
}

BOOST_AUTO_TEST_CASE(singularity_judge_calls_no_iterate_singular_whose_jacobians_change) {
    // A change of f too small beside the largest entry to be seen there; a step has seen it.
    evidence e = failed(good({{answer, 1e5}, {error_bound, 1}, {mesh_error, 1}, {nonlinear, 0}}));
    e.linear = false;
    BOOST_CHECK(judge(e, history{}).status == bvp_status::singular);
    e.changes = true;
    BOOST_CHECK(judge(e, history{}).act == finer_guess);
}

BOOST_AUTO_TEST_CASE(mesh_judge_halves_the_mesh_until_the_condition_number_stays) {
    // kappa rtol > 1/100, M unknown to five digits and not on the mesh halved: one more mesh.
    const numbers open{{answer, 1e5}, {error_bound, 0.1}, {mesh_error, 1e-2}, {halved_kappa, none}};
    const auto seen = [&](double k) {
        numbers n = open;
        n.push_back({kappa, k});
        return good(n);
    };
    history h;
    BOOST_CHECK(follow(h, seen(1e5)) == resolve);
    BOOST_TEST(h.kappa == 1e5);
    BOOST_TEST(h.unsettled == 1);
    BOOST_CHECK(judge(seen(1.9e5), h).status == bvp_status::success);  // it stays within a factor of two
    BOOST_CHECK(judge(seen(3e5), h).act == resolve);
    // At a singular end it may double with every mesh.
    BOOST_CHECK(judge(with(seen(3e5), {{singular_end, 1}}), h).status == bvp_status::success);
    // The mesh halved, five digits of M, or a harmless condition number say as much.
    BOOST_CHECK(judge(with(seen(3e5), {{halved_kappa, 4e5}}), h).status == bvp_status::success);
    BOOST_CHECK(judge(with(seen(3e5), {{mesh_error, 1e-6}}), h).status == bvp_status::success);
    BOOST_CHECK(judge(seen(9e3), h).status == bvp_status::success);
    // One that grows without end is that of a family, after six more looks; without adaptation nothing is asked.
    history grown;
    double k = 1e5;
    for (; judge(seen(k), grown).act == resolve; k *= 10) follow(grown, seen(k));
    BOOST_CHECK(judge(seen(k), grown).status == bvp_status::not_isolated);
    BOOST_TEST(grown.unsettled == mesh_judge<double>::most_looks);
    mesh_limits<double> fixed = limits;
    fixed.adapt = false;
    BOOST_CHECK(mesh_judge<double>(fixed)(seen(1e5), history{}).status == bvp_status::success);
    BOOST_TEST(
        (mesh_judge<double>(fixed)(good({{error, 1}}), history{}).status == bvp_status::tolerance_not_met));
}

// It has grown to what the error of x makes of it.
BOOST_AUTO_TEST_CASE(mesh_judge_takes_no_condition_number_that_stays_by_chance) {
    history h;
    h.kappa = 1e7, h.first_kappa = 1e4;
    BOOST_CHECK(judge(nonlinear_problem({{kappa, 1.1e7}, {error, 2e-7}}), h).act == resolve);
    BOOST_CHECK(judge(nonlinear_problem({{kappa, 1.1e7}, {error, 2e-8}}), h).status == bvp_status::success);
    h.first_kappa = 2e6;  // it always was as large
    BOOST_CHECK(judge(nonlinear_problem({{kappa, 1.1e7}, {error, 2e-7}}), h).status == bvp_status::success);
}

BOOST_AUTO_TEST_CASE(mesh_judge_asks_less_of_newtons_iteration_where_the_mesh_will_be_refined) {
    history h;
    BOOST_TEST(judge.newton_target(h) == 1e-4);
    h.least = 1e-3;
    BOOST_TEST(judge.newton_target(h) == 1e-5);
    h.least = 1e-7;
    BOOST_TEST(judge.newton_target(h) == 1e-6 / 50);
}

BOOST_AUTO_TEST_CASE(regularity_judge_knows_m_where_errors_of_u_are_a_small_part_of_it) {
    BOOST_TEST(!decided(good()).undecided);  // a small answer
    BOOST_TEST(!decided(good({{answer, 1e6}, {error_bound, 0.04}, {mesh_error, 1}})).undecided);
    const numbers large{{answer, 1e6}, {error_bound, 1}};
    BOOST_TEST(!decided(with(good(large), {{mesh_error, 0.2}})).undecided);
    BOOST_TEST(decided(with(good(large), {{mesh_error, 0.3}})).undecided);
    BOOST_TEST(decided(with(good(large), {{mesh_error, 0.2}, {kernel_radius, 0.3}})).undecided);
    // Layers that this mesh does not resolve are no doubt: they have answers of their own.
    const auto layer = decided(with(good(large), {{mesh_error, 1}, {resolved, 0}}));
    BOOST_TEST(!layer.undecided);
    BOOST_TEST(!layer.resolved);
    // Modes that turn unseen are, with any answer.
    BOOST_TEST(
        decided(good({{missed_phase, 0.01}, {error_bound, 1}, {mesh_error, 1}, {resolved, 0}})).undecided);
    // One unknown has one mode.
    evidence one = with(good(large), {{mesh_error, 0.2}, {kernel_radius, 0.3}});
    one.unknowns = 1;
    BOOST_TEST(!decided(one).undecided);
    // The bound says nothing of the modes of a mass matrix.
    evidence mass = good({{answer, 1e6}, {error_bound, 0.04}, {mesh_error, 1}});
    mass.no_mass = false;
    BOOST_TEST(decided(mass).undecided);
}

BOOST_AUTO_TEST_CASE(regularity_judge_counts_the_error_of_x_where_m_depends_on_it) {
    const evidence e = good({{answer, 1e4}, {error_bound, 0.01}, {change, 0.5}});
    BOOST_TEST(!decided(e, 0).undecided);
    BOOST_TEST(decided(e, 1e-5).undecided);
    BOOST_TEST(!decided(e, 1e-7).undecided);  // answer times error is less than 1/100
    BOOST_TEST(!decided(with(e, {{change, 1e-3}}), 1e-5).undecided);
    BOOST_TEST(decided(good({{translation, 0.5}}), 1e-7).undecided);  // held in place by the mesh
}

BOOST_AUTO_TEST_CASE(singularity_judge_tells_families_from_no_solution_and_from_large_units) {
    const auto singular = [](const evidence& e) {
        const reader r(e);
        const auto end = singularity_judge<double>(r, limits).singular();
        return end ? end->status : bvp_status::success;
    };
    const numbers lost{{norm, 1e20}, {kappa, 1e20}, {residual, 1}, {rounding_of_u, 1}};
    BOOST_CHECK(singular(good()) == bvp_status::success);
    const auto dependent_conditions = judge(with(good(lost), {{dependent, 1}}), history{});
    BOOST_TEST(words_of(dependent_conditions) == "condition r[1] depends on those before it");
    BOOST_TEST(words_of(judge(failed(good(lost)), history{})) == "M is singular to rounding");
    BOOST_CHECK(singular(good(lost)) == bvp_status::not_isolated);
    BOOST_CHECK(singular(with(good(lost), {{size, 1e15}})) == bvp_status::singular);
    // Components of size 1e14: the norm is large, the relative condition is not, and answers solve their equations.
    const numbers units{{norm, 1e20}, {kappa, 10}, {residual, 1e-15}};
    BOOST_CHECK(singular(good(units)) == bvp_status::success);
    BOOST_CHECK(singular(with(good(units), {{residual, 1}})) == bvp_status::not_isolated);
    // Solutions that grow along the interval, unless conditions depend on each other.
    const numbers grows{{norm, 1e20}, {kappa, 1e20}, {contrast, 1e-20}};
    BOOST_CHECK(singular(good(grows)) == bvp_status::ill_conditioned);
    BOOST_CHECK(singular(with(good(grows), {{dependent, 1}})) == bvp_status::not_isolated);
    // M of an iterate says nothing of a nonlinear problem, unless a full step solves it.
    BOOST_CHECK(singular(failed(nonlinear_problem(lost))) == bvp_status::success);
    BOOST_TEST(
        (singular(with(failed(nonlinear_problem(lost)), {{full_size, 1}})) == bvp_status::not_isolated));
    BOOST_CHECK(singular(failed(good(lost))) == bvp_status::singular);
}

BOOST_AUTO_TEST_CASE(singularity_judge_calls_an_error_that_stays_rounding_where_it_is) {
    const auto hopeless = [](const evidence& e, double error) {
        const reader r(e);
        const auto end = singularity_judge<double>(r, limits).hopeless(error);
        return end ? end->status : bvp_status::success;
    };
    BOOST_CHECK(hopeless(good(), 1e-3) == bvp_status::success);
    BOOST_CHECK(hopeless(good({{rounding, 1e-4}}), 1e-3) == bvp_status::ill_conditioned);
    BOOST_CHECK(hopeless(good({{rounding_of_y, 1e-2}}), 1e-3) == bvp_status::ill_conditioned);
    // Nothing is known of M: no rounding error says anything. Of a linear problem without a solution no mesh will.
    const numbers open{{answer, 1e6}, {error_bound, 1}, {mesh_error, 1}, {rounding, 1}};
    BOOST_CHECK(hopeless(good(open), 1e-3) == bvp_status::success);
    BOOST_CHECK(hopeless(failed(good(open)), 1e-3) == bvp_status::singular);
    // Near a family M is as singular as the iterate is close to it: the next one has another condition.
    const evidence near = failed(nonlinear_problem({{rounding, 1e-4}, {norm, 1e9}, {full_size, 1}}));
    BOOST_CHECK(hopeless(near, 1e-3) == bvp_status::success);
    BOOST_CHECK(hopeless(with(near, {{full_norm, 1e12}}), 1e-3) == bvp_status::not_isolated);
    BOOST_CHECK(hopeless(with(near, {{full_norm, 1e9}}), 1e-3) == bvp_status::ill_conditioned);
}

BOOST_AUTO_TEST_CASE(mesh_judge_accepts_nothing_that_rounding_spoils) {
    for (const numbers& n :
         {numbers{{rounding, 1e-5}, {norm, 1e11}}, numbers{{rounding_of_y, 2e-5}}, numbers{{range, 1e14}}})
        BOOST_CHECK(judge(good(n), history{}).status == bvp_status::ill_conditioned);
    BOOST_CHECK(judge(good({{rounding, 1e-5}}), history{}).status == bvp_status::success);
    // M may be no more than the errors of differences.
    evidence e = nonlinear_problem({{answer, 1e6}, {rounding_of_u, 1e-8}});
    BOOST_CHECK(judge(e, history{}).status == bvp_status::success);
    e.differences = true;
    BOOST_CHECK(judge(e, history{}).status == bvp_status::ill_conditioned);
    e.set(nonlinear, 0);
    BOOST_CHECK(judge(e, history{}).status == bvp_status::success);
}

BOOST_AUTO_TEST_CASE(kernel_judge_counts_modes_that_no_mesh_shows_to_be_regular) {
    const kernel_judge<double> of{2e-16, 1e12, true, false};
    BOOST_TEST(!of.may_vanish(20));            // answers little
    BOOST_TEST(!of.may_vanish(1e12 * 1e-13));  // rounding errors of the largest
    BOOST_TEST(of.may_vanish(100));
    BOOST_CHECK((kernel_judge<double>{2e-16, 1e12, true, true}.may_vanish(20)));  // but turns
    BOOST_TEST(of.lost(1e6, 0.1));
    BOOST_TEST(!of.lost(1e11, 1e-3));
    BOOST_TEST(
        (kernel_judge<double>{2e-16, 1e12, false, false}.lost(1e11, 1e-3)));  // x is only near the family
    kernel_found found{0, true};
    of.count(0.01, found);
    BOOST_CHECK(found.dimension == 0 && found.certain);
    of.count(1.1, found);
    BOOST_CHECK(found.dimension == 1 && found.certain);
    of.count(0.1, found);
    BOOST_CHECK(found.dimension == 1 && !found.certain);
    of.count(3, found);
    BOOST_TEST(found.dimension == 2);
}

BOOST_AUTO_TEST_CASE(newton_damping_takes_steps_that_the_next_correction_confirms) {
    using damping = newton_damping<double>;
    damping d(1, false);
    BOOST_TEST(d.full());
    BOOST_TEST(d.accepts(0.75));
    BOOST_TEST(!d.accepts(0.76));
    BOOST_TEST(!d.accepts(std::numeric_limits<double>::quiet_NaN()));
    BOOST_TEST(damping::keeps_factors(1, 0.25));
    BOOST_TEST(!damping::keeps_factors(1, 0.26));
    d.refused(2);  // 1/(2 * 2)
    BOOST_TEST(d.lambda() == 0.25);
    d.refused(0.01);  // a prediction that would be longer: half
    BOOST_TEST(d.lambda() == 0.125);
    d.refused(100);  // and one that would be next to nothing: a tenth
    BOOST_TEST(d.lambda() == 0.0125);
    d.not_finite();
    BOOST_TEST(d.lambda() == 0.003125);
    BOOST_TEST(!d.accepts(0.9999));
    BOOST_TEST(d.accepts(0.999));
    for (int k = 0; k < 2; ++k) d.refused(1e9);
    BOOST_TEST(d.gives_up());
    // A bold one ends at 1/16 and takes it.
    damping bold(1, true);
    bold.refused(1e9);
    BOOST_TEST(bold.lambda() == 0.1);
    BOOST_TEST(!bold.accepts(2));
    bold.refused(1e9);
    BOOST_TEST(bold.lambda() == 0.0625);
    BOOST_TEST(bold.accepts(2));
}

namespace {

std::vector<double> even_mesh(int intervals) {
    std::vector<double> t;
    for (int i = 0; i <= intervals; ++i) t.push_back(static_cast<double>(i) / intervals);
    return t;
}
int inside(const std::vector<double>& t, double a, double b) {
    return static_cast<int>(
        std::count_if(t.begin(), t.end(), [&](double x) { return x > a - 1e-12 && x < b + 1e-12; }));
}

}  // namespace

BOOST_AUTO_TEST_CASE(refined_mesh_is_fine_where_errors_are_and_as_large_as_they_ask_for) {
    const std::vector<double> none_fixed, fixed{0.35}, t = even_mesh(10);
    interval_errors<double> e(10);
    for (int i = 0; i < 10; ++i) e.local[i] = e.removed[i] = 1;
    BOOST_TEST(e.worst() == 9);  // the last of equals
    const auto by = [&](double error, bool doubled = false, bool divide = false) {
        return refinement<double>{2, 4, error, 1e-6, doubled, divide, none_fixed};
    };
    // The same everywhere: the mesh keeps its shape. A quarter of the tolerance asks for 10 (4 error/rtol)^(1/4) intervals.
    const auto same = refined_mesh(t, e, by(3.9e-6));
    BOOST_TEST(same.size() == 21u);
    for (std::size_t i = 0; i < same.size(); ++i) BOOST_TEST(std::abs(same[i] - i / 20.0) < 1e-12);
    BOOST_TEST(refined_mesh(t, e, by(1e-7)).size() == 12u);        // one interval more, where all are alike
    BOOST_TEST(refined_mesh(t, e, by(1e-7, true)).size() == 21u);  // doubled
    BOOST_TEST(refined_mesh(t, e, by(1)).size() == 41u);           // at most four times as many
    // One interval has it all.
    interval_errors<double> one(10);
    one.local[3] = one.removed[3] = 1e3;
    BOOST_TEST(one.worst() == 3);
    const auto there = refined_mesh(t, one, by(1e-3));
    BOOST_TEST(inside(there, 0.3, 0.4) > inside(there, 0.6, 0.7) + 3);
    BOOST_TEST(std::is_sorted(there.begin(), there.end()));
    BOOST_CHECK(there.front() == 0 && there.back() == 1);
    // Points that are fixed stay.
    std::vector<double> with_fixed = t;
    with_fixed.insert(with_fixed.begin() + 4, 0.35);
    interval_errors<double> more(11);
    for (int i = 0; i < 11; ++i) more.local[i] = 1;
    refinement<double> keep{2, 4, 1e-5, 1e-6, false, false, fixed};
    const auto kept = refined_mesh(with_fixed, more, keep);
    BOOST_TEST(std::count(kept.begin(), kept.end(), 0.35) == 1);
    // Superconvergence: lifting has removed much more than what is left.
    more.removed[0] = 11;
    BOOST_TEST(more.superconvergent(0));
    BOOST_TEST(!more.superconvergent(1));
}

// f jumps in one interval, which is divided; the others keep their steps.
BOOST_AUTO_TEST_CASE(refined_mesh_divides_intervals_with_jumps_for_themselves) {
    const std::vector<double> none_fixed, t = even_mesh(20);
    interval_errors<double> e(20);
    for (int i = 0; i < 20; ++i) e.local[i] = e.removed[i] = 1e-3;
    e.local[8] = 100, e.jumps[8] = 1;
    const auto mesh = [&](bool divide, double error = 1e-4) {
        return refined_mesh(t, e, refinement<double>{3, 6, error, 1e-6, true, divide, none_fixed});
    };
    const auto divided = mesh(true), refined = mesh(false);
    BOOST_TEST(inside(divided, 0.4, 0.45) == 9);  // eight parts
    BOOST_TEST(divided.size() < refined.size());
    BOOST_TEST(inside(mesh(true, 1.5e-6), 0.4, 0.45) == 4);  // no more than it takes
    for (int i = 0; i < 6; ++i) e.jumps[i] = 1;              // in a quarter of all they are no exception
    BOOST_TEST(mesh(true).size() == refined.size());
}

BOOST_AUTO_TEST_CASE(mesh_points_are_graded_towards_a_layer_from_both_sides) {
    const auto fine = graded(even_mesh(4), 0.5, 1e-3);
    for (std::size_t i = 1; i < fine.size(); ++i) {
        const double step = fine[i] - fine[i - 1],
                     distance = std::min(std::abs(fine[i] - 0.5), std::abs(fine[i - 1] - 0.5));
        BOOST_TEST(step > 0);
        BOOST_TEST(step <= std::max(2.1 * distance, 1e-3));
    }
    BOOST_TEST(halved(even_mesh(3)).size() == 7u);
}

BOOST_AUTO_TEST_CASE(error_estimate_lifts_again_where_the_error_left_between_mesh_points_counts) {
    BOOST_TEST(lifts_again(1e-3, 1e-3, 1.0, 1e-8));
    BOOST_TEST(!lifts_again(1e-9, 1e-9, 1.0, 1e-8));  // beside the tolerance
    BOOST_TEST(!lifts_again(1e-3, 1e-1, 1.0, 1e-8));  // beside the error at the mesh point
    BOOST_TEST(!lifts_again(1e-3, 1e-3, 1e6, 1e-8));  // of a large y
}

BOOST_AUTO_TEST_CASE(multiplier_judge_decides_by_what_is_known_better_than_its_distance) {
    using of = multiplier_judge<double>;
    BOOST_TEST(of::known(0.5, 0.4));
    BOOST_TEST(!of::known(0.5, 0.6));
    BOOST_TEST(of::known(1e-9, 1e-7));  // near the circle, on whichever side
    BOOST_TEST(!of::known(1, none));
    BOOST_TEST(!of::known(1, std::nan("")));
    BOOST_TEST(!of::lost(0.05));
    BOOST_TEST(of::lost(1.0068));
    BOOST_TEST(of::lost(std::nan("")));
}

BOOST_AUTO_TEST_CASE(growing_period_is_unbounded_where_orbits_keep_the_law_of_a_saddle) {
    // T = -(1/in + 1/out) ln(distance), p = 2 + distance^2.
    const auto orbits = [](double steps, double in, double out, double at) {
        growing_period<double> periods;
        for (const double T : {at - 2 * steps, at - steps, at}) {
            const double distance = std::exp(-T / (1 / in + 1 / out));
            periods.add({T, 2 + distance * distance, distance, in, out});
        }
        return periods;
    };
    BOOST_TEST(orbits(1, 3, 7, 10).unbounded(1e-6));
    BOOST_TEST(orbits(5, 0.3, 7, 50).unbounded(1e-6));
    BOOST_TEST(!orbits(1, 3, 7, 4).unbounded(1e-6));     // p still moves
    BOOST_TEST(!orbits(0.1, 3, 7, 10).unbounded(1e-6));  // the orbits hardly come closer, so far
    BOOST_TEST(!orbits(-1, 3, 7, 10).unbounded(1e-6));   // they go away
    BOOST_TEST(!growing_period<double>().unbounded(1));
    // In a canard explosion p stays and T grows, but there is no saddle, or orbits come no closer to it by the law.
    const auto canard = [](double in, bool closer) {
        growing_period<double> periods;
        for (int k = 0; k < 3; ++k) periods.add({3.0 + k, 1, closer ? 1e-4 * std::exp(-k) : 1e-4, in, 2});
        return periods.unbounded(1e-6);
    };
    BOOST_TEST(canard(2, true));
    BOOST_TEST(!canard(2, false));
    BOOST_TEST(!canard(0, true));
    BOOST_TEST(!canard(0.1, true));  // T grows ten times as slowly
}
