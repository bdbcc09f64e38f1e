// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE krylov
#include <Eigen/LU>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <problems/sparse_once.hpp>
#include <random>
#include <sstream>
#include <stagecraft/families.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/linear/krylov_blocks.hpp>
#include <stagecraft/linear/preconditioner_life.hpp>
#include <stagecraft/linear/sparse_blocks.hpp>
#include <stagecraft/problem/matrix_free.hpp>
#include <stagecraft/problem/with.hpp>
#include <stagecraft/report_text.hpp>
#include <type_traits>

namespace sc = stagecraft;
using Eigen::MatrixXd, Eigen::VectorXd;
using sparse = Eigen::SparseMatrix<double>;

namespace {

// The Brusselator with diffusion 1/10 on a periodic k x k grid (Hairer-Wanner II.IV.10).
struct brusselator {
    int k = 12;
    double diffusion() const { return 0.1 * k * k; }
    int at(int i, int j) const { return 2 * ((i + k) % k + k * ((j + k) % k)); }
    template <class Visit>
    void each(Visit visit) const {
        for (int j = 0; j < k; ++j)
            for (int i = 0; i < k; ++i)
                visit(at(i, j), std::array{at(i - 1, j), at(i + 1, j), at(i, j - 1), at(i, j + 1)});
    }
    void operator()(double, const VectorXd& y, VectorXd& f) const {
        each([&](int p, const auto& next) {
            const double u = y[p], v = y[p + 1];
            f[p] = 1 + u * u * v - 4.4 * u - 4 * diffusion() * u;
            f[p + 1] = 3.4 * u - u * u * v - 4 * diffusion() * v;
            for (const int q : next)
                for (int c = 0; c < 2; ++c) f[p + c] += diffusion() * y[q + c];
        });
    }
    template <class Add>
    void entries(const VectorXd& y, Add add) const {
        each([&](int p, const auto& next) {
            const double u = y[p], v = y[p + 1];
            add(p, p, 2 * u * v - 4.4 - 4 * diffusion());
            add(p, p + 1, u * u);
            add(p + 1, p, 3.4 - 2 * u * v);
            add(p + 1, p + 1, -u * u - 4 * diffusion());
            for (const int q : next)
                for (int c = 0; c < 2; ++c) add(p + c, q + c, diffusion());
        });
    }
    VectorXd start() const {
        VectorXd y(2 * k * k);
        for (int j = 0; j < k; ++j)
            for (int i = 0; i < k; ++i) {
                const double p = double(i) / k, q = double(j) / k;
                y[at(i, j)] = 22 * q * std::pow(1 - q, 1.5);
                y[at(i, j) + 1] = 27 * p * std::pow(1 - p, 1.5);
            }
        return y;
    }
};
struct sparse_brusselator : brusselator {
    sparse sparsity() const {
        std::vector<Eigen::Triplet<double>> places;
        entries(VectorXd::Zero(2 * k * k), [&](int i, int j, double) { places.emplace_back(i, j, 0.0); });
        sparse J(2 * k * k, 2 * k * k);
        J.setFromTriplets(places.begin(), places.end());
        return J;
    }
    void jacobian(double, const VectorXd& y, sparse& J) const {
        entries(y, [&](int i, int j, double value) { J.coeffRef(i, j) = value; });
    }
};

// J as a product, preconditioned by its diagonal.
struct product {
    const brusselator* of;
    VectorXd y, diagonal;
    Eigen::Index rows() const { return y.size(); }
    Eigen::Index cols() const { return y.size(); }
    void add_times(double factor, const double* x, double* r) const {
        of->entries(y, [&](int i, int j, double value) { r[i] += factor * value * x[j]; });
    }
    void precondition(double shift, double* x) const {
        for (Eigen::Index i = 0; i < y.size(); ++i) x[i] /= shift - diagonal[i];
    }
};
struct without_matrix : brusselator {
    using linear_solver = sc::krylov_blocks;
    product matrix() const { return {this, start(), start()}; }
    void jacobian(double, const VectorXd& y, product& J) const {
        J.y = y;
        entries(y, [&](int i, int j, double value) {
            if (i == j) J.diagonal[i] = value;
        });
    }
};

// Nothing but f and a preconditioner; Generic: f takes states of any scalar type.
template <bool Generic>
struct preconditioned_heat {
    int n;
    double rate() const { return 0.1 * (n + 1.0) * (n + 1.0); }
    template <class Vector>
    requires(Generic || std::is_same_v<Vector, VectorXd>) void operator()(double t, const Vector& u,
                                                                          Vector& f) const {
        for (int i = 0; i < n; ++i) {
            f[i] = -2 * rate() * u[i] - u[i] * u[i] * u[i] + std::cos(t);
            if (i > 0) f[i] += rate() * u[i - 1];
            if (i + 1 < n) f[i] += rate() * u[i + 1];
        }
    }
    // (shift + 2 rate) x_i - rate (x_i-1 + x_i+1) = r_i, by elimination (Thomas).
    void precondition(double shift, double* x) const {
        const double d = shift + 2 * rate();
        VectorXd left(n);
        for (int i = 0; i < n; ++i) {
            const double pivot = d - (i > 0 ? rate() * left[i - 1] : 0);
            left[i] = rate() / pivot;
            x[i] = (x[i] + (i > 0 ? rate() * x[i - 1] : 0)) / pivot;
        }
        for (int i = n - 2; i >= 0; --i) x[i] += left[i] * x[i + 1];
    }
    MatrixXd jacobian_at(const VectorXd& u) const {
        MatrixXd J = MatrixXd::Zero(n, n);
        for (int i = 0; i < n; ++i) {
            J(i, i) = -2 * rate() - 3 * u[i] * u[i];
            if (i > 0) J(i, i - 1) = J(i - 1, i) = rate();
        }
        return J;
    }
};
template <bool Generic>
struct with_matrix {
    preconditioned_heat<Generic> heat;
    void operator()(double t, const VectorXd& u, VectorXd& f) const { heat(t, u, f); }
    void jacobian(double, const VectorXd& u, MatrixXd& J) const { J = heat.jacobian_at(u); }
};

// The product of its J with a vector beside that of the matrix, and a run beside one with the matrix.
template <bool Generic>
void runs_without_a_matrix(double accuracy) {
    const int n = 40;
    const VectorXd u0 = (VectorXd::LinSpaced(n, 1, n) * (M_PI / (n + 1))).array().sin();
    const auto problem = sc::matrix_free(preconditioned_heat<Generic>{n}, n);
    auto J = problem.matrix();
    problem.jacobian(0.3, u0, J);
    const VectorXd v = VectorXd::LinSpaced(n, -1, 2), exact = problem.jacobian_at(u0) * v;
    VectorXd r = VectorXd::Ones(n);
    J.add_times(-2, v.data(), r.data());
    BOOST_TEST((r - VectorXd::Ones(n) + 2 * exact).norm() <= accuracy * exact.norm());
    for (const int s : {3, 5}) {
        const sc::options<double> o{.rtol = 1e-7, .atol = 1e-7};
        const auto free = sc::integrate(sc::radau_iia(s), problem, u0, 0.0, 2.0, o);
        const auto dense = sc::integrate(sc::radau_iia(s), with_matrix<Generic>{{n}}, u0, 0.0, 2.0, o);
        BOOST_TEST(free.ok());
        BOOST_TEST(double(free.report.steps) <= 1.1 * double(dense.report.steps) + 1);
        BOOST_TEST((free.y - dense.y).template lpNorm<Eigen::Infinity>() <= 3e-7);
    }
}

// Residuals of a real system and a pair, relative to their right-hand sides.
template <class Mass, class Matrix>
std::array<double, 2> residuals(const Mass& mass, const MatrixXd& M, const Matrix& J, const MatrixXd& whole,
                                double re, double im) {
    const int n = static_cast<int>(M.rows());
    sc::krylov_blocks::real real(n);
    sc::krylov_blocks::complex pair(n);
    BOOST_TEST(real.factor_shifted(mass, J, re));
    BOOST_TEST(pair.factor_shifted(mass, J, re, im));
    const VectorXd b = VectorXd::LinSpaced(n, -1, 2).array().sin(),
                   c = VectorXd::LinSpaced(n, 0, 40).array().cos();
    VectorXd x = b, u = b, v = c;
    real.solve(x.data());
    pair.solve(u.data(), v.data());
    const MatrixXd A = re * M - whole;
    return {(b - A * x).norm() / b.norm(),
            std::hypot((b - A * u + im * M * v).norm(), (c - A * v - im * M * u).norm()) /
                std::hypot(b.norm(), c.norm())};
}

}  // namespace

BOOST_AUTO_TEST_CASE(real_systems_and_pairs_are_solved_to_a_hundredth) {
    const sparse_brusselator problem{{6}};
    const int n = 72;
    sparse J = problem.sparsity();
    problem.jacobian(0, problem.start(), J);
    const MatrixXd identity = MatrixXd::Identity(n, n);
    MatrixXd M = 2 * identity;
    for (int i = 0; i + 1 < n; ++i) M(i, i + 1) = 0.3;
    const product by_product{&problem, problem.start(), MatrixXd(J).diagonal()};
    for (const double re : {1e4, 300.0, 40.0})
        for (const double im : {0.8 * re, -2 * re}) {
            for (const double r : residuals(sc::identity_mass(), identity, J, J, re, im))
                BOOST_TEST(r <= 0.0101);
            for (const double r : residuals(sc::entry_mass<double>(M), M, J, J, re, im))
                BOOST_TEST(r <= 0.0101);
            for (const double r : residuals(sc::identity_mass(), identity, by_product, J, re, im))
                BOOST_TEST(r <= 0.0101);
        }
    J.coeffRef(0, 0) = NAN;
    sc::krylov_blocks::real real(n);
    BOOST_TEST(!real.factor_shifted(sc::identity_mass(), J, 1.0));
}

BOOST_AUTO_TEST_CASE(runs_take_about_the_steps_of_direct_solvers) {
    const sparse_brusselator problem;
    const VectorXd y0 = problem.start();
    const sc::options<double> o{.rtol = 1e-6, .atol = 1e-6};
    for (const int s : {3, 5}) {
        const auto method = sc::radau_iia(s);
        const auto direct = sc::integrate(method, problem, y0, 0.0, 0.5, o);
        const auto krylov =
            sc::integrate(method, sc::with_linear_solver<sc::krylov_blocks>(problem), y0, 0.0, 0.5, o);
        const auto free = sc::integrate(method, without_matrix{}, y0, 0.0, 0.5, o);
        for (const auto& r : {krylov, free}) {
            BOOST_TEST(r.ok());
            BOOST_TEST(double(r.report.steps) <= 1.1 * double(direct.report.steps) + 1);
            BOOST_TEST(double(r.report.solves) <= 1.15 * double(direct.report.solves) + 1);
            BOOST_TEST((r.y - direct.y).lpNorm<Eigen::Infinity>() <= 3e-6);
        }
    }
}

// What solves leave grows when the polynomial of many stages is extrapolated: the next iteration does not begin there once
// it has failed.
BOOST_AUTO_TEST_CASE(many_stages_at_loose_tolerances_take_about_the_iterations_of_direct_solvers) {
    const sparse_brusselator problem;
    const auto iterated = sc::with_linear_solver<sc::krylov_blocks>(problem);
    const VectorXd y0 = problem.start();
    for (const int s : {7, 9})
        for (const double tolerance : {1e-2, 1e-3}) {
            const sc::options<double> o{.rtol = tolerance, .atol = tolerance};
            const auto direct = sc::integrate(sc::radau_iia(s), problem, y0, 0.0, 1.0, o);
            const auto krylov = sc::integrate(sc::radau_iia(s), iterated, y0, 0.0, 1.0, o);
            BOOST_TEST(krylov.ok());
            BOOST_TEST(double(krylov.report.solves) <= 1.5 * double(direct.report.solves));
        }
}

BOOST_AUTO_TEST_CASE(a_right_hand_side_and_a_preconditioner_suffice) {
    runs_without_a_matrix<true>(1e-14);
    runs_without_a_matrix<false>(1e-6);
    BOOST_CHECK_THROW(sc::matrix_free(preconditioned_heat<true>{3}, -1), std::invalid_argument);
}

namespace {

// krylov_blocks, and how many factorisations it makes for how many systems. With Lasting false every system has a solver of
// its own, which can keep nothing.
template <bool Lasting>
struct counting_blocks {
    inline static long setups, systems;

    template <class Solver>
    class counted {
      public:
        explicit counted(int n) : n_(n), solver_(n) {}
        template <class... Arguments>
        bool factor_shifted(const Arguments&... arguments) {
            if (!Lasting) solver_ = Solver(n_);
            const long before = solver_.setups();
            const bool done = solver_.factor_shifted(arguments...);
            setups += solver_.setups() - before;
            ++systems;
            return done;
        }
        template <class... Parts>
        void solve(Parts... x) {
            solver_.solve(x...);
        }

      private:
        int n_;
        Solver solver_;
    };
    using real = counted<sc::krylov_blocks::real>;
    using complex = counted<sc::krylov_blocks::complex>;
};

// A grid of k x k points with zeros around it: u_t = div((1 + u^2) grad u)/10 + 20 cos 5t, and a rotation around the centre
// with `speed` radians in a unit of time, upwind.
struct transported_heat {
    int k;
    double speed;
    double h() const { return 1.0 / (k + 1); }
    template <class Add>
    void neighbours(int i, int j, Add add) const {
        const double a = -speed * ((j + 1) * h() - 0.5), b = speed * ((i + 1) * h() - 0.5);
        const double along[] = {-a, a, -b, b};
        const int dx[] = {1, -1, 0, 0}, dy[] = {0, 0, 1, -1};
        for (int e = 0; e < 4; ++e) {
            const int x = i + dx[e], y = j + dy[e];
            add(std::min(x, y) < 0 || std::max(x, y) >= k ? -1 : x + k * y, std::max(along[e], 0.0) / h());
        }
    }
    template <class Visit>
    void each(Visit visit) const {
        for (int p = 0; p < k * k; ++p)
            neighbours(p % k, p / k, [&](int q, double inflow) { visit(p, q, inflow); });
    }
    void operator()(double t, const VectorXd& u, VectorXd& f) const {
        f.setConstant(20 * std::cos(5 * t));
        each([&](int p, int q, double inflow) {
            const double beside = q < 0 ? 0 : u[q], mean = (beside + u[p]) / 2;
            f[p] += (0.1 * (1 + mean * mean) / (h() * h()) + inflow) * (beside - u[p]);
        });
    }
    template <class Add>
    void entries(const VectorXd& u, Add add) const {
        each([&](int p, int q, double inflow) {
            const double beside = q < 0 ? 0 : u[q], mean = (beside + u[p]) / 2, d = 0.1 / (h() * h());
            const double there = d * (1 + mean * mean) + inflow, slope = d * mean * (beside - u[p]);
            add(p, p, slope - there);
            if (q >= 0) add(p, q, slope + there);
        });
    }
    sparse sparsity() const {
        std::vector<Eigen::Triplet<double>> places;
        entries(VectorXd::Zero(k * k), [&](int i, int j, double) { places.emplace_back(i, j, 0.0); });
        sparse J(k * k, k * k);
        J.setFromTriplets(places.begin(), places.end());
        return J;
    }
    void jacobian(double, const VectorXd& u, sparse& J) const {
        J.coeffs().setZero();
        entries(u, [&](int i, int j, double value) { J.coeffRef(i, j) += value; });
    }
    VectorXd start() const {
        VectorXd u(k * k);
        for (int p = 0; p < k * k; ++p)
            u[p] = std::sin(3 * M_PI * (p % k + 1) * h()) * std::sin(M_PI * (p / k + 1) * h());
        return u;
    }
};

// What runs with lasting factorisations take beside those with new ones for every system.
template <class Problem>
void factorisations_last(const Problem& problem, double tolerance) {
    using lasting = counting_blocks<true>;
    using always_new = counting_blocks<false>;
    const sc::options<double> o{.rtol = tolerance, .atol = tolerance};
    lasting::setups = lasting::systems = always_new::setups = always_new::systems = 0;
    const auto run = [&](const auto& p) {
        return sc::integrate(sc::radau_iia(3), p, p.start(), 0.0, 1.0, o);
    };
    const auto r = run(sc::with_linear_solver<lasting>(problem)),
               beside = run(sc::with_linear_solver<always_new>(problem));
    BOOST_TEST(r.ok());
    BOOST_TEST(always_new::setups == always_new::systems);
    BOOST_TEST(2 * lasting::setups <= always_new::setups);
    BOOST_TEST(double(r.report.solves) <= 1.05 * double(beside.report.solves) + 1);
    BOOST_TEST((r.y - beside.y).template lpNorm<Eigen::Infinity>() <= tolerance);
}

}  // namespace

BOOST_AUTO_TEST_CASE(at_most_half_of_the_factorisations_are_made) {
    factorisations_last(sparse_brusselator{{24}}, 1e-4);
    factorisations_last(sparse_brusselator{{24}}, 1e-7);
    for (const double speed : {0.0, 50.0}) factorisations_last(transported_heat{30, speed}, 1e-5);
}

BOOST_AUTO_TEST_CASE(a_preconditioner_serves_until_it_has_cost_as_much_as_a_new_one) {
    sc::preconditioner_life life;
    BOOST_TEST(!life.serves(1));
    life.made(100, 5);
    BOOST_TEST(!life.serves(100));  // it has not been tried
    life.used(3);
    for (const double shift : {51.0, 100.0, 199.0}) BOOST_TEST(life.serves(shift));
    for (const double shift : {50.0, 200.0, 1e6}) BOOST_TEST(!life.serves(shift));
    for (const double iterations : {3, 1, 5, 5}) life.used(iterations);
    BOOST_TEST(life.serves(100));
    life.used(4);
    BOOST_TEST(!life.serves(100));
    life.made(100, 5);
    life.used(40);
    BOOST_TEST(life.serves(100));
}

namespace {

enum class weak { nothing, diagonal, zeros, nan };

// u' = u_xx - c u_x with zeros at both ends, on n points, and a preconditioner that is none. Starts from an eigenvector.
struct transport {
    int n;
    double c;
    weak kind;
    VectorXd factors;
    inline static long calls;
    double up() const { return (n + 1.0) * (n + 1.0) + c * (n + 1) / 2; }
    double down() const { return (n + 1.0) * (n + 1.0) - c * (n + 1) / 2; }
    template <class Vector>
    void operator()(double, const Vector& u, Vector& f) const {
        ++calls;
        for (int i = 0; i < n; ++i) {
            f[i] = -(up() + down()) * u[i];
            if (i > 0) f[i] += up() * u[i - 1];
            if (i + 1 < n) f[i] += down() * u[i + 1];
        }
    }
    void precondition(double, double* x) const {
        for (int i = 0; i < n; ++i) {
            if (kind == weak::diagonal) x[i] *= factors[i];
            if (kind == weak::zeros) x[i] = 0;
            if (kind == weak::nan) x[i] = NAN;
        }
    }
    VectorXd start() const {
        VectorXd u(n);
        for (int i = 0; i < n; ++i)
            u[i] = std::pow(up() / down(), (i + 1 - n) / 2.0) * std::sin(M_PI * (i + 1) / (n + 1));
        return u;
    }
    VectorXd at(double t) const {
        const double rate = -up() - down() + 2 * std::sqrt(up() * down()) * std::cos(M_PI / (n + 1));
        return std::exp(rate * t) * start();
    }
};

// Heat on 2 k points whose neighbours 2 i and 2 i + 1 are held together by a multiplier, which stands before them: index 2.
struct saddle {
    int k;
    double rate = 1000;
    void operator()(double, const VectorXd& y, VectorXd& f) const {
        for (int i = 0; i < 2 * k; ++i) {
            const double left = i > 0 ? y[k + i - 1] : 0, right = i + 1 < 2 * k ? y[k + i + 1] : 0;
            f[k + i] = rate * (left - 2 * y[k + i] + right) + (i % 2 == 0 ? y[i / 2] : -y[i / 2]);
        }
        for (int i = 0; i < k; ++i) f[i] = y[k + 2 * i] - y[k + 2 * i + 1];
    }
    sparse sparsity() const {
        std::vector<Eigen::Triplet<double>> places;
        for (int i = 0; i < 2 * k; ++i) {
            for (int j = std::max(i - 1, 0); j < std::min(i + 2, 2 * k); ++j)
                places.emplace_back(k + i, k + j, 1.0);
            places.emplace_back(k + i, i / 2, 1.0);
            places.emplace_back(i / 2, k + i, 1.0);
        }
        sparse J(3 * k, 3 * k);
        J.setFromTriplets(places.begin(), places.end());
        return J;
    }
    Eigen::DiagonalMatrix<double, Eigen::Dynamic> mass() const {
        VectorXd d = VectorXd::Ones(3 * k);
        d.head(k).setZero();
        return Eigen::DiagonalMatrix<double, Eigen::Dynamic>(d);
    }
    std::vector<int> index() const {
        std::vector<int> flags(3 * k, 1);
        std::fill(flags.begin(), flags.begin() + k, 2);
        return flags;
    }
    // Pairs that are equal, and the multipliers that keep them so.
    VectorXd start() const {
        VectorXd y = VectorXd::Zero(3 * k), f(3 * k);
        for (int i = 0; i < 2 * k; ++i) y[k + i] = 0.3 * (i / 2 % 7) - i / 2 % 3;
        (*this)(0, y, f);
        for (int i = 0; i < k; ++i) y[i] = (f[k + 2 * i + 1] - f[k + 2 * i]) / 2;
        return y;
    }
};

template <class Result>
std::string text(const Result& r) {
    std::ostringstream out;
    print(out, r);
    return out.str();
}

}  // namespace

BOOST_AUTO_TEST_CASE(no_preconditioner_however_bad_gives_a_wrong_solution_with_success) {
    std::mt19937 random(40);
    std::uniform_real_distribution<double> exponent(-1, 1);
    int succeeded = 0, failures = 0;
    for (const int n : {20, 50})
        for (const double c : {0.0, 20.0})
            for (const weak kind : {weak::nothing, weak::diagonal})
                for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
                    VectorXd factors(n);
                    for (double& x : factors) x = std::pow(10, exponent(random));
                    const transport problem{n, c, kind, factors};
                    transport::calls = 0;
                    const auto r =
                        sc::integrate(sc::radau_iia(3), sc::matrix_free(problem, n), problem.start(), 0.0,
                                      0.05, {.rtol = tolerance, .atol = tolerance, .max_steps = 400});
                    BOOST_TEST(r.report.f + r.report.f_jacobian == transport::calls);
                    BOOST_TEST(r.report.linear_iterations > 0);
                    const VectorXd right = problem.at(r.t);
                    const double error =
                        ((r.y - right).array() / (tolerance + tolerance * right.array().abs()))
                            .abs()
                            .maxCoeff();
                    BOOST_TEST(error <= 10, n << " " << c << " " << int(kind) << " " << tolerance);
                    succeeded += r.ok();
                    failures += r.report.linear_failures > 0;
                    if (10 * r.report.linear_failures > r.report.steps + r.report.rejected())
                        BOOST_TEST(text(r).find("the preconditioner is too weak") != std::string::npos);
                }
    BOOST_TEST(succeeded >= 8);
    BOOST_TEST(failures >= 8);
}

BOOST_AUTO_TEST_CASE(a_preconditioner_that_gives_zeros_or_nan_is_named) {
    for (const weak kind : {weak::zeros, weak::nan}) {
        const transport problem{20, 0, kind, {}};
        for (const double step : {0.0, 0.01}) {
            const auto r = sc::integrate(sc::radau_iia(3), sc::matrix_free(problem, 20), problem.start(), 0.0,
                                         0.05, {.fixed_step = step});
            BOOST_TEST(sc::name(r.status) == "linear_solver_failed");
            BOOST_TEST(r.t == 0);
            BOOST_TEST(text(r).find("the preconditioner gave NaN, infinity or zeros") != std::string::npos);
        }
    }
}

// The incomplete factorisation is useless where constraints leave zeros on the diagonal; direct solvers are not.
BOOST_AUTO_TEST_CASE(zeros_on_the_diagonal_are_named_and_what_to_take) {
    const saddle problem{60};
    const auto direct = sc::integrate(sc::radau_iia(3), problem, problem.start(), 0.0, 1.0);
    BOOST_TEST(direct.ok());
    const auto r = sc::integrate(sc::radau_iia(3), sc::with_linear_solver<sc::krylov_blocks>(problem),
                                 problem.start(), 0.0, 1.0);
    BOOST_TEST(sc::name(r.status) == "linear_solver_failed");
    BOOST_TEST(text(r).find("zeros on the diagonal") != std::string::npos);
    BOOST_TEST(text(r).find("direct solver") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(an_iteration_that_does_not_converge_leaves_nan_and_says_why) {
    const int n = 200;
    sc::detail::restarted_gmres<double> gmres;
    const auto nothing = [](const auto& in, auto&& out) { out = in; };
    const auto shift = [](const auto& in, auto&& out) {  // GMRES gets nowhere before n iterations
        out.head(in.size() - 1) = in.tail(in.size() - 1);
        out[in.size() - 1] = in[0];
    };
    VectorXd x = VectorXd::Unit(n, 0);
    const auto slow = gmres.solve(shift, nothing, x, 1e-2, 100);
    BOOST_TEST((slow.end == sc::linear_end::unconverged && slow.failed() && slow.iterations == 100));
    BOOST_TEST(x.array().isNaN().all());
    for (const double bad : {0.0, double(NAN), double(INFINITY)}) {
        x = VectorXd::Unit(n, 0);
        const auto r = gmres.solve(
            nothing, [&](const auto& in, auto&& out) { out = in * 0 + VectorXd::Constant(n, bad); }, x, 1e-2,
            100);
        BOOST_TEST((r.end == sc::linear_end::bad_preconditioner));
        BOOST_TEST(x.array().isNaN().all());
    }
    // Not the solver's fault: the matrix, or the right-hand side.
    x = VectorXd::Unit(n, 0);
    const auto matrix =
        gmres.solve([](const auto& in, auto&& out) { out = in * NAN; }, nothing, x, 1e-2, 100);
    BOOST_TEST((matrix.end == sc::linear_end::not_finite && !matrix.failed()));
    x = VectorXd::Constant(n, NAN);
    BOOST_TEST((gmres.solve(nothing, nothing, x, 1e-2, 100).end == sc::linear_end::not_finite));
    x = VectorXd::Unit(n, 3);
    BOOST_TEST((gmres.solve(nothing, nothing, x, 1e-2, 100).end == sc::linear_end::solved));
    BOOST_TEST(x == VectorXd::Unit(n, 3));
}

namespace {

// M u' = -M u with the mass matrix of bilinear finite elements on k x k points.
struct finite_elements {
    sparse M;
    explicit finite_elements(int k) : M(k * k, k * k) {
        std::vector<Eigen::Triplet<double>> entries;
        for (int p = 0; p < k * k; ++p)
            for (int a = -1; a < 2; ++a)
                for (int b = -1; b < 2; ++b)
                    if (const int x = p % k + a, y = p / k + b; std::min(x, y) >= 0 && std::max(x, y) < k)
                        entries.emplace_back(p, x + k * y, (a == 0 ? 4.0 : 1.0) * (b == 0 ? 4.0 : 1.0) / 36);
        M.setFromTriplets(entries.begin(), entries.end());
    }
    void operator()(double, const VectorXd& u, VectorXd& f) const { f = -(M * u); }
    sparse sparsity() const { return M; }
    sparse mass() const { return M; }
};

}  // namespace

// Explicit stages have no Newton iteration to mend what a solve with M leaves: a hundredth made errors of 4e-4.
BOOST_AUTO_TEST_CASE(slopes_of_explicit_stages_are_solved_to_rounding) {
    sc::tableau<double, 4> classical;
    classical.A << 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1, 0;
    classical.b << 1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6;
    classical.c << 0, 0.5, 0.5, 1;
    const VectorXd u0 = VectorXd::LinSpaced(144, 1, 40).array().sin();
    const auto r = sc::integrate(classical, sc::with_linear_solver<sc::krylov_blocks>(finite_elements(12)),
                                 u0, 0.0, 5.0, {.fixed_step = 0.05});
    BOOST_TEST(r.ok());
    BOOST_TEST((r.y - std::exp(-5.0) * u0).lpNorm<Eigen::Infinity>() <= 1e-8);
}
