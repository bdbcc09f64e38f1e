// SPDX-License-Identifier: BSL-1.0
// Run alone and by two processes (tests/linear/CMakeLists.txt).
#define BOOST_TEST_MODULE petsc
#define BOOST_TEST_NO_MAIN
#include <boost/test/unit_test.hpp>
#include <brusselator_2d/brusselator_2d.hpp>
#include <cmath>
#include <incompressible_flow/incompressible_flow.hpp>
#include <random>
#include <stagecraft/families.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/tableaux/exact_tableau.hpp>
#include <stagecraft/tableaux/family.hpp>
#include <stagecraft/theory/dae/dae_order.hpp>
#include <stdexcept>

namespace sc = stagecraft;
using Eigen::VectorXd;

namespace {

using sc::petsc_check;

void set(const char* option, const char* value) { petsc_check(PetscOptionsSetValue(nullptr, option, value)); }
void reset(const char* option) { petsc_check(PetscOptionsClearValue(nullptr, option)); }

double norm(const brusselator_2d& problem, const VectorXd& x) {
    double sum = x.squaredNorm();
    problem.add_up(&sum, 1);
    return std::sqrt(sum);
}
VectorXd any(Eigen::Index n, unsigned seed) {
    std::mt19937 random(seed);
    VectorXd x(n);
    for (double& v : x) v = std::uniform_real_distribution(-1.0, 1.0)(random);
    return x;
}

// A regular M with the pattern of J: 2 on the diagonal, little beside it.
sc::petsc_matrix mass_like(const sc::petsc_matrix& J) {
    const auto M = sc::petsc_made<Mat>([&](Mat* A) { return MatDuplicate(J.get(), MAT_COPY_VALUES, A); });
    PetscReal size = 0;
    petsc_check(MatNorm(M.get(), NORM_INFINITY, &size));
    petsc_check(MatScale(M.get(), 0.5 / size));
    petsc_check(MatShift(M.get(), 2));
    return sc::petsc_matrix(M.get());
}

// The residuals of one real system and one pair, relative to their right-hand sides.
template <class Mass, class Times>
std::array<double, 2> residuals(const brusselator_2d& problem, const Mass& mass, Times&& times_mass) {
    const auto J = problem.matrix();
    const int n = static_cast<int>(J.rows());
    const double re = 500, im = -800;
    sc::petsc_blocks::real real(n);
    sc::petsc_blocks::complex pair(n);
    BOOST_TEST(real.factor_shifted(mass, J, re));
    BOOST_TEST(pair.factor_shifted(mass, J, re, im));
    const VectorXd b = any(n, 1), c = any(n, 2);
    VectorXd x = b;
    real.solve(x.data());
    VectorXd r = b - re * times_mass(x);
    J.add_times(1, x.data(), r.data());
    const double alone = norm(problem, r) / norm(problem, b);
    VectorXd u = b, v = c;  // not side by side
    pair.solve(u.data(), v.data());
    VectorXd p = b - re * times_mass(u) + im * times_mass(v), q = c - re * times_mass(v) - im * times_mass(u);
    J.add_times(1, u.data(), p.data());
    J.add_times(1, v.data(), q.data());
    BOOST_TEST(J.counts().real_solves == 1);
    BOOST_TEST(J.counts().pair_solves == 1);
    BOOST_TEST(J.counts().cycles >= J.counts().real_iterations + 2 * J.counts().pair_iterations);
    return {alone,
            std::hypot(norm(problem, p), norm(problem, q)) / std::hypot(norm(problem, b), norm(problem, c))};
}

}  // namespace

BOOST_AUTO_TEST_CASE(real_systems_and_pairs_are_solved_as_accurately_as_asked_for) {
    const brusselator_2d problem(16);
    const auto M = mass_like(problem.matrix());
    const auto times = [&](const VectorXd& x) {
        VectorXd r = VectorXd::Zero(x.size());
        M.add_times(1, x.data(), r.data());
        return r;
    };
    for (const char* scheme : {"presb", "triangular"})
        for (const char* bound : {"1e-2", "1e-10"}) {
            set("-stage_pair_scheme", scheme);
            set("-stage_real_ksp_rtol", bound);
            set("-stage_pair_ksp_rtol", bound);
            for (const double r :
                 residuals(problem, sc::identity_mass(), [](const VectorXd& x) { return x; }))
                BOOST_TEST(r <= 1.01 * std::stod(bound));
            for (const double r : residuals(problem, sc::mass_by_products<sc::petsc_matrix>(M), times))
                BOOST_TEST(r <= 1.01 * std::stod(bound));
        }
    reset("-stage_pair_scheme");
    reset("-stage_real_ksp_rtol");
    reset("-stage_pair_ksp_rtol");
}

BOOST_AUTO_TEST_CASE(few_iterations_suffice_whatever_the_step_and_the_number_of_stages) {
    set("-stage_real_ksp_rtol", "1e-4");
    set("-stage_pair_ksp_rtol", "1e-4");
    const brusselator_2d problem(64);
    const auto J = problem.matrix();
    problem.fill(problem.equilibrium().data(),
                 J.get());  // from the start J grows as fast as such a step is short
    const int n = static_cast<int>(J.rows());
    for (const double h : {1e-3, 1e-1})
        for (const int s : {3, 9}) {
            const auto method = sc::radau_iia(s);
            sc::petsc_blocks::real real(n);
            BOOST_TEST(real.factor_shifted(sc::identity_mass(), J, method.gamma[0] / h));
            VectorXd x = any(n, 3), y = any(n, 4);
            real.solve(x.data());
            for (int k = 0; k < method.alpha.size(); ++k) {
                sc::petsc_blocks::complex pair(n);
                BOOST_TEST(
                    pair.factor_shifted(sc::identity_mass(), J, method.alpha[k] / h, -method.beta[k] / h));
                x = any(n, 5);
                pair.solve(x.data(), y.data());
            }
        }
    BOOST_TEST(J.counts().most_real <= 2);
    // Eigenvalues in [1/2, 1]: 2 ((sqrt 2 - 1)/(sqrt 2 + 1))^6 < 1e-4, and these right-hand sides are random.
    BOOST_TEST(J.counts().most_pair <= 6);
    reset("-stage_real_ksp_rtol");
    reset("-stage_pair_ksp_rtol");
}

BOOST_AUTO_TEST_CASE(a_run_takes_the_same_steps_on_any_number_of_processes) {
    const counted_brusselator here(32), alone(32, PETSC_COMM_SELF);
    const sc::options<double> o{.rtol = 1e-4, .atol = 1e-4};
    const auto run = [&](const counted_brusselator& problem) {
        return sc::integrate(sc::radau_iia(3), problem, problem.start(), 0.0, 0.2, o);
    };
    const auto r = run(here), whole = run(alone);
    BOOST_TEST(r.ok());
    BOOST_TEST(r.report.steps == whole.report.steps);
    BOOST_TEST(r.report.solves == whole.report.solves);
    // Two systems a factorisation; a hierarchy serves until it has cost more than a new one does.
    BOOST_TEST(here.J.counts().setups <= r.report.factorisations);
    const long cycles = alone.J.counts().cycles;
    BOOST_TEST(std::abs(here.J.counts().cycles - cycles) <= cycles / 20);
    // States in another order: their means and their norms.
    const auto sums = [](const counted_brusselator& problem, const VectorXd& y) {
        std::array<double, 3> sum{0, y.squaredNorm(), static_cast<double>(y.size())};
        for (int i = 0; i < y.size(); i += 2) sum[0] += y[i];
        problem.add_up(sum.data(), 3);
        BOOST_TEST(sum[2] == 2048);
        return std::array{sum[0] / 1024, std::sqrt(sum[1] / sum[2])};
    };
    const auto a = sums(here, r.y), b = sums(alone, whole.y);
    for (int k = 0; k < 2; ++k) BOOST_TEST(std::abs(a[k] - b[k]) <= 0.1 * (o.atol + o.rtol * b[k]));
    // Solves to a hundredth cost no steps against a direct solver.
    set("-stage_pc_pc_type", "lu");
    const auto direct = run(alone);
    reset("-stage_pc_pc_type");
    BOOST_TEST(std::abs(direct.report.steps - whole.report.steps) <= 1 + direct.report.steps / 30);
    BOOST_TEST(whole.report.solves <= 1.1 * static_cast<double>(direct.report.solves));
}

// Incompressible flow on 8 x 8 cells, 192 unknowns, of index 2; PCFIELDSPLIT within PRESB.
BOOST_AUTO_TEST_CASE(velocity_and_pressure_show_the_orders_of_index_2_on_any_number_of_processes) {
    const auto added = split_fields();
    for (const int s : {2, 3}) {
        const auto predicted = sc::theory::predict_index2(
            sc::tableaux::exact_tableau(sc::tableaux::family::radau_iia, s).value());
        BOOST_TEST_REQUIRE(predicted.applies());
        std::array<double, 2> error[2];
        for (const int k : {0, 1}) {
            const counted_flow problem(8);
            const auto r = sc::integrate(sc::radau_iia(s), problem, problem.solution(0), 0.0, 0.4,
                                         {.rtol = 1e-10, .atol = 1e-10, .fixed_step = 0.4 / (8 << k)});
            BOOST_TEST(r.ok());
            BOOST_TEST(double(problem.J.counts().pair_iterations) <=
                       10 * double(problem.J.counts().pair_solves));
            error[k] = problem.errors(r.t, r.y);
        }
        BOOST_TEST(std::abs(std::log2(error[0][0] / error[1][0]) - *predicted.y) <= 0.15);
        BOOST_TEST(std::abs(std::log2(error[0][1] / error[1][1]) - *predicted.z) <= 0.15);
    }
    for (const auto& option : added) reset(option.c_str());
}

BOOST_AUTO_TEST_CASE(an_exception_on_one_process_ends_the_run_on_all) {
    struct failing : brusselator_2d {
        using brusselator_2d::brusselator_2d;
        int rank = 0;
        void operator()(double t, const VectorXd& y, VectorXd& f) const {
            brusselator_2d::operator()(t, y, f);
            if (rank == 0 && t > 0.01) throw std::domain_error("a failure");
        }
    };
    failing problem(16);
    MPI_Comm_rank(PETSC_COMM_WORLD, &problem.rank);
    const auto r = sc::integrate(sc::radau_iia(3), problem, problem.start(), 0.0, 0.5);
    BOOST_TEST(int(r.status) == int(problem.rank == 0 ? sc::status::function_threw : sc::status::non_finite));
    BOOST_TEST(r.t <= 0.01);
}

int main(int count, char** arguments) {
    if (PetscInitialize(nullptr, nullptr, nullptr, nullptr) != 0) return 1;
    const int failed = boost::unit_test::unit_test_main([] { return true; }, count, arguments);
    return PetscFinalize() != 0 ? 1 : failed;
}
