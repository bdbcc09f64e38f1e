// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE runs
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <stagecraft/checkpoint.hpp>
#include <stagecraft/coefficients/explicit.hpp>
#include <stagecraft/coefficients/low_storage.hpp>
#include <stagecraft/low_storage.hpp>
#include <stagecraft/observe/save_every.hpp>
#include <stagecraft/observe/solution.hpp>
#include <stagecraft/problem/with.hpp>
#include <stagecraft/stabilised.hpp>
#include <stagecraft/tableaux/read_method.hpp>
#include <stdexcept>
#include <string>
#include <variant>

#include "../allocations.hpp"
#include "../message.hpp"

// Methods that run in place. Stabilised ones: their order, a heat equation with a known solution, the spectral radius found and
// given, checkpoints. By registers: each file of tableaux/low_storage with its certified order, and as its tableau. The storage
// that both promise.

namespace sc = stagecraft;
using Eigen::VectorXd;

namespace {

const sc::stabilised_method<double> all[] = {sc::rkc1(), sc::rkc2(), sc::rkl1(),
                                             sc::rkl2(), sc::rkg1(), sc::rkg2()};

/// u_t = u_xx + g on n interior points, with g such that sin(pi x) cos(t) solves the discrete equations.
struct heat {
    int n;
    double fastest() const { return 4.0 * (n + 1) * (n + 1); }
    void operator()(double t, const VectorXd& u, VectorXd& f) const {
        const double d = (n + 1.0) * (n + 1.0), half = std::sin(M_PI / (2 * (n + 1.0))),
                     decay = 4 * d * half * half;
        for (int i = 0; i < n; ++i) {
            const double left = i > 0 ? u[i - 1] : 0, right = i + 1 < n ? u[i + 1] : 0;
            f[i] = d * (left - 2 * u[i] + right) + start(i) * (decay * std::cos(t) - std::sin(t));
        }
    }
    double start(int i) const { return std::sin(M_PI * (i + 1) / (n + 1.0)); }
    VectorXd at(double t) const {
        VectorXd u(n);
        for (int i = 0; i < n; ++i) u[i] = start(i) * std::cos(t);
        return u;
    }
};

using fifty =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using fifty_vector = Eigen::Matrix<fifty, Eigen::Dynamic, 1>;

// y = (1/(1+t), 1/(1+t)^2).
const auto hyperbola = [](const fifty& t, const fifty_vector& y, fifty_vector& f) {
    const fifty a = y[0] * y[0] - y[1], b = y[0] - y[1] * (1 + t);
    f[0] = -y[1] + a * (1 + y[0] + t) + b * y[1];
    f[1] = -2 * y[0] * y[1] + b * y[1] - a * t;
};

/// y' = -y, and what is said of its radius is no number from t = 0.3 on.
struct lost_radius {
    void operator()(double, const VectorXd& y, VectorXd& f) const { f = -y; }
    double spectral_radius(double t, const VectorXd&) const { return t < 0.3 ? 1 : std::nan(""); }
};

/// The files of tableaux/low_storage by their names.
std::map<std::string, std::string> stored_methods() {
    std::map<std::string, std::string> all;
    for (const auto& file :
         std::filesystem::directory_iterator(STAGECRAFT_SOURCE_DIR "/tableaux/low_storage"))
        all.emplace(file.path().stem().string(), file.path().string());
    return all;
}

/// y' = A y with |y| growing slowly, in n components.
const auto rotation = [](double, const VectorXd& y, VectorXd& f) {
    const Eigen::Index half = y.size() / 2;
    f.head(half) = -y.tail(half);
    f.tail(half) = y.head(half);
};

/// How many vectors of n doubles a run takes from the heap.
template <class Method>
double vectors(const Method& m, const sc::options<double>& o, int n = 4000) {
    const VectorXd y0 = VectorXd::Ones(n);
    large_bytes = 0;
    large = static_cast<std::size_t>(n) * sizeof(double);
    const auto r = sc::integrate(m, rotation, y0, 0, 1, o);
    large = ~std::size_t{0};
    BOOST_TEST(r.ok());
    return static_cast<double>(large_bytes) / static_cast<double>(n) / sizeof(double);
}

}  // namespace

BOOST_AUTO_TEST_CASE(equal_steps_converge_with_the_order) {
    // y = 1 / (1 - sin(t)/2).
    const auto f = [](double t, const VectorXd& y, VectorXd& out) {
        out[0] = y[0] * y[0] * std::cos(t) / 2;
        out[1] = t * y[0] - 3 * y[1];
    };
    for (const auto& m : all) {
        double before = 0;
        for (const int steps : {40, 80, 160}) {
            const auto r = sc::integrate(m, f, VectorXd{{1, 1}}, 0, 1, {.fixed_step = 1.0 / steps});
            BOOST_TEST(r.ok());
            const double error = std::abs(r.y[0] - 1 / (1 - std::sin(1.0) / 2));
            if (before > 0) BOOST_TEST(std::abs(std::log2(before / error) - m.order) < 0.07);
            before = error;
        }
    }
}

BOOST_AUTO_TEST_CASE(a_heat_equation_is_solved_to_its_tolerance_whoever_knows_the_radius) {
    const heat f{200};
    for (const auto& m : all)
        for (const double tol : {1e-2, 1e-3, 1e-4, 1e-5}) {
            const sc::options<double> o{.rtol = tol, .atol = tol};
            const auto found = sc::integrate(m, f, f.at(0), 0, 1, o);
            const auto given = sc::integrate(m, sc::with_spectral_radius(f, f.fastest()), f.at(0), 0, 1, o);
            BOOST_TEST((found.ok() && given.ok()));
            for (const auto& r : {found, given})
                BOOST_TEST((r.y - f.at(1)).cwiseAbs().maxCoeff() < (m.order == 2 ? 10 : 60) * tol);
            // The power method has found about the right number (half of the steps would need a fifth more stages).
            BOOST_TEST(found.report.f < 1.25 * given.report.f);
            BOOST_TEST(given.report.f < 1.25 * found.report.f);
            BOOST_TEST(found.report.steps < (m.order == 2 ? 60 : 300));
        }
    // Twice as fine a grid: four times the radius, twice the stages, as many steps.
    const heat fine{401};
    const sc::options<double> o{.rtol = 1e-4, .atol = 1e-4};
    const auto coarse = sc::integrate(sc::rkc2(), f, f.at(0), 0, 1, o);
    const auto finer = sc::integrate(sc::rkc2(), fine, fine.at(0), 0, 1, o);
    BOOST_TEST(std::abs(finer.report.steps - coarse.report.steps) <= 2);
    BOOST_TEST(finer.report.f < 2.2 * coarse.report.f);
}

BOOST_AUTO_TEST_CASE(between_the_steps_and_across_a_checkpoint) {
    const heat f{50};
    sc::solution<VectorXd> path;
    const sc::options<double> o{.rtol = 1e-4, .atol = 1e-4};
    const auto whole = sc::integrate(sc::rkl2(), f, f.at(0), 0, 1, o, path);
    for (const double t : {0.1, 0.37, 0.8}) BOOST_TEST((path(t) - f.at(t)).cwiseAbs().maxCoeff() < 1e-3);
    sc::checkpoint<VectorXd> last;
    sc::integrate(sc::rkl2(), f, f.at(0), 0, 1, o, sc::save_every(4, [&](auto point) {
                      if (last.y.size() == 0) last = std::move(point);
                  }));
    BOOST_TEST(last.y.size() == 50);
    const auto rest = sc::integrate(sc::rkl2(), f, last, 1);
    BOOST_TEST((rest.y - whole.y).norm() == 0);
    BOOST_TEST(rest.report.f == whole.report.f);
    BOOST_CHECK_THROW(sc::integrate(sc::rkc2(), f, last, 1), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(hundreds_of_stages_take_no_more_vectors_than_ten) {
    const auto taken = [](int stages) {
        const heat f{40};
        const VectorXd y0 = f.at(0);
        const double h = 0.3 * stages * stages / f.fastest();
        const long before = allocations;
        const auto r = sc::integrate(sc::rkc2(stages), sc::with_spectral_radius(f, f.fastest()), y0, 0,
                                     10 * h, {.fixed_step = h});
        const long after = allocations;
        BOOST_TEST(r.ok());
        BOOST_TEST(r.report.f >= 10 * stages);
        return after - before;
    };
    BOOST_TEST(taken(400) == taken(10));
}

BOOST_AUTO_TEST_CASE(bad_radii_and_problems_are_named) {
    const heat f{10};
    for (const double bad :
         {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        BOOST_TEST(message([&] {
                       sc::integrate(sc::rkc2(), sc::with_spectral_radius(f, bad), f.at(0), 0, 1);
                   }).find("spectral_radius") != std::string::npos);
    // Later such a radius ends the run where it is.
    const lost_radius later;
    const auto lost = sc::integrate(sc::rkc2(), later, VectorXd{{1, 2}}, 0, 1, {.rtol = 1e-7, .atol = 1e-7});
    BOOST_TEST(sc::name(lost.status) == "function_threw");
    BOOST_TEST((lost.t > 0.3 && lost.t < 1));
    BOOST_TEST(std::abs(lost.y[0] - std::exp(-lost.t)) < 1e-5);
    const Eigen::MatrixXd M = Eigen::MatrixXd::Identity(10, 10);
    BOOST_TEST(message([&] {
                   sc::integrate(sc::rkc2(), sc::with_mass(f, M), f.at(0), 0, 1);
               }).find("mass()") != std::string::npos);
    // A run at rest, and one whose f is not finite.
    const auto rest = [](double, const VectorXd&, VectorXd& out) { out.setZero(); };
    BOOST_TEST(sc::integrate(sc::rkc2(), rest, VectorXd{{1, 2}}, 0, 1).ok());
    const auto broken = [](double t, const VectorXd& y, VectorXd& out) { out = y * std::sqrt(0.5 - t); };
    const auto r = sc::integrate(sc::rkc2(), broken, VectorXd{{1, 2}}, 0, 1);
    BOOST_TEST(!r.ok());
    BOOST_TEST(r.t <= 0.5);
}

BOOST_AUTO_TEST_CASE(methods_by_their_registers_have_the_certified_order_and_are_their_tableau) {
    int files = 0, embedded = 0;
    for (const auto& [name, path] : stored_methods()) BOOST_TEST_CONTEXT(name) {
            const auto file = std::get<sc::tableaux::tableau_file>(sc::tableaux::read_method_file(path));
            const auto kept = sc::tableaux::read_low_storage<fifty>(path);
            const auto full = sc::tableaux::rounded<fifty>(
                file);  // computed from the coefficients as they stand in the file
            const bool digits_of_file = name == "ssp_5_4_shu_osher";
            fifty before = 0;
            double seen = 0;
            for (const int steps : {64, 128}) {
                const sc::options<fifty> o{.fixed_step = fifty(1) / steps};
                const auto y0 = fifty_vector::Ones(2);
                const auto a = sc::integrate(kept, hyperbola, y0, fifty(0), fifty(1), o);
                const auto b = sc::integrate(full, hyperbola, y0, fifty(0), fifty(1), o);
                BOOST_TEST((a.ok() && b.ok()));
                BOOST_TEST((a.y - b.y).norm() < (digits_of_file ? fifty("1e-12") : fifty("1e-33")));
                BOOST_TEST(a.report.f == steps * kept.stages());
                const fifty error = abs(a.y[0] - fifty(1) / 2);
                if (before > 0) seen = std::log2(static_cast<double>(before / error));
                before = error;
            }
            BOOST_TEST(std::abs(seen - *file.claims.order) < 0.15, "order " << seen);
            BOOST_TEST(kept.meaning.b_embedded.size() == static_cast<int>(file.b_embedded.size()));
            ++files;
            if (!file.claims.embedded_order) continue;
            ++embedded;
            auto estimate = full;
            estimate.b = full.b_embedded;
            estimate.b_embedded.resize(0);
            const fifty end = fifty(1) / 16;  // later the smallest error constants need thousands of steps
            const auto error = [&](int steps) {
                const auto r = sc::integrate(estimate, hyperbola, fifty_vector::Ones(2), fifty(0), end,
                                             {.fixed_step = end / steps});
                return abs(fifty(r.y[0] - 1 / (1 + end)));
            };
            seen = std::log2(static_cast<double>(fifty(error(32) / error(64))));
            BOOST_TEST(std::abs(seen - *file.claims.embedded_order) < 0.05, "embedded order " << seen);
        }
    BOOST_TEST(files == 7);
    BOOST_TEST(embedded == 2);
}

BOOST_AUTO_TEST_CASE(registers_in_doubles_make_the_steps_of_the_tableau) {
    const auto f = [](double t, const VectorXd& y, VectorXd& out) {  // y_1 = 1 / (1 - sin(t)/2)
        out[0] = y[0] * y[0] * std::cos(t) / 2;
        out[1] = t * y[0] - 3 * y[1];
    };
    for (const auto& [name, path] : stored_methods()) BOOST_TEST_CONTEXT(name) {
            const auto kept = sc::tableaux::read_low_storage(path);
            const auto full = sc::tableaux::rounded<double>(
                std::get<sc::tableaux::tableau_file>(sc::tableaux::read_method_file(path)));
            sc::options<double> o{.rtol = 1e-6, .atol = 1e-6};
            o.jumps = false;  // which the tableau looks for by its slopes
            if (full.b_embedded.size() == 0) o.fixed_step = 0.01;
            const auto a = sc::integrate(kept, f, VectorXd{{1, 1}}, 0, 1, o);
            const auto b = sc::integrate(full, f, VectorXd{{1, 1}}, 0, 1, o);
            BOOST_TEST((a.ok() && b.ok()));
            BOOST_TEST(a.report.steps == b.report.steps);
            BOOST_TEST((a.y - b.y).norm() < 1e-12);
            BOOST_TEST(std::abs(a.y[0] - 1 / (1 - std::sin(1.0) / 2)) < 1e-6);
            // A size that is known, and any method that a file may hold.
            const auto oscillator = [](double, const Eigen::Vector2d& y, Eigen::Vector2d& out) {
                out << -y[1], y[0];
            };
            const sc::options<double> steps{.fixed_step = 0.1};
            const Eigen::Vector2d start(1, 0), end(std::cos(1), std::sin(1));
            const auto known = sc::integrate(kept, oscillator, start, 0, 1, steps);
            const auto any = sc::integrate(sc::tableaux::read_method(path), oscillator, start, 0, 1, steps);
            BOOST_TEST((known.y - end).norm() < 1e-4);
            BOOST_TEST((any.y == known.y));
        }
}

BOOST_AUTO_TEST_CASE(registers_take_as_many_vectors_as_they_promise) {
    const sc::options<double> equal{.fixed_step = 0.01};
    const sc::options<double> chosen{.rtol = 1e-6, .atol = 1e-6};
    using space = sc::step_space<VectorXd, 3, void>;
    // The stage, and f of it. The second register, and the sum of an estimate, stand in the three columns of the continuous
    // solution, which every run has; the third of 3S* is the state at the start of the step.
    for (const auto& [name, path] : stored_methods()) BOOST_TEST_CONTEXT(name) {
            const auto m = sc::tableaux::read_low_storage(path);
            const int n = 4000;
            large_bytes = 0, large = n * sizeof(double);
            const sc::low_storage_step<space> step(m, n);
            large = ~std::size_t{0};
            BOOST_TEST(large_bytes == 2 * n * sizeof(double));
            BOOST_TEST(vectors(m, equal) == vectors(sc::williamson_2n_3(), equal));
        }
    BOOST_TEST(vectors(sc::ranocha_3s_4_3(), chosen) == vectors(sc::ranocha_3s_3_2(), chosen));
    BOOST_TEST(vectors(sc::williamson_2n_3(), equal) <= 18);
    // As a tableau it keeps a slope of each stage.
    const auto full = sc::ranocha_3s_4_3().meaning;
    BOOST_TEST(vectors(full, equal) >= 18 + full.stages());
}

BOOST_AUTO_TEST_CASE(generated_registers_are_those_of_the_files) {
    const auto same = [](const sc::low_storage_method<double>& m, const std::string& name) {
        const auto read = sc::tableaux::read_low_storage(stored_methods().at(name));
        BOOST_TEST_CONTEXT(name) {
            BOOST_TEST((m.form == read.form && m.rows == read.rows));
            BOOST_TEST(m.meaning.b_embedded.size() == read.meaning.b_embedded.size());
            if (m.meaning.b_embedded.size() > 0)
                BOOST_TEST((m.meaning.b_embedded == read.meaning.b_embedded));
            BOOST_TEST((m.meaning.A == read.meaning.A));
        }
    };
    same(sc::williamson_2n_3(), "williamson_2n_3");
    same(sc::carpenter_kennedy_2n_5_4(), "carpenter_kennedy_2n_5_4");
    same(sc::ssp_10_4_2s(), "ssp_10_4_2s");
    same(sc::ssp_3_3_shu_osher(), "ssp_3_3_shu_osher");
    same(sc::ssp_5_4_shu_osher(), "ssp_5_4_shu_osher");
    same(sc::ranocha_3s_3_2(), "ranocha_3s_3_2");
    same(sc::ranocha_3s_4_3(), "ranocha_3s_4_3");
}

BOOST_AUTO_TEST_CASE(registers_between_the_steps_and_what_they_refuse) {
    const heat f{10};
    const sc::options<double> o{.rtol = 1e-8, .atol = 1e-8};
    sc::solution<VectorXd> path;
    const auto whole = sc::integrate(sc::ranocha_3s_4_3(), f, f.at(0), 0, 1, o, path);
    for (const double t : {0.1, 0.37, 0.8}) BOOST_TEST((path(t) - f.at(t)).cwiseAbs().maxCoeff() < 1e-6);
    sc::checkpoint<VectorXd> last;
    sc::integrate(sc::ranocha_3s_4_3(), f, f.at(0), 0, 1, o, sc::save_every(4, [&](auto point) {
                      if (last.y.size() == 0) last = std::move(point);
                  }));
    BOOST_TEST((sc::integrate(sc::ranocha_3s_4_3(), f, last, 1).y - whole.y).norm() == 0);
    BOOST_CHECK_THROW(sc::integrate(sc::ranocha_3s_3_2(), f, last, 1), std::invalid_argument);

    const auto said = [](const std::string& text, const std::string& part) {
        BOOST_TEST(text.find(part) != std::string::npos, text);
    };
    said(message([&] { sc::integrate(sc::williamson_2n_3(), f, f.at(0), 0, 1); }), "use options.fixed_step");
    const Eigen::MatrixXd M = 2 * Eigen::MatrixXd::Identity(10, 10);
    said(message([&] { sc::integrate(sc::ranocha_3s_3_2(), sc::with_mass(f, M), f.at(0), 0, 1); }), "mass()");
    using form = sc::storage_form;
    said(message([] { sc::low_storage<double>(form::williamson, {{0, 1}}); }), "A and B (2N)");
    said(message([] { sc::low_storage<double>(form::williamson, {{0, 1}, {1}}); }), "the same length");
    said(message([] { sc::low_storage<double>(form::shu_osher, {{0.5}, {1}}); }), "once");
    said(message([] {
             sc::low_storage<double>(form::williamson, {{0}, {1}}, {1, 2});
         }),
         "one weight a stage");
    said(message([] {
             sc::tableaux::read_low_storage(STAGECRAFT_SOURCE_DIR "/tableaux/catalogue/kutta_3.json");
         }),
         "has not the form");
}
