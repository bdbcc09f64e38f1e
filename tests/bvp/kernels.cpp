// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE bvp_kernels
#include <Eigen/QR>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/lobatto_iiia.hpp>
#include <stagecraft/gauss_variable.hpp>
#include <string>

namespace sc = stagecraft;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double pi = 3.14159265358979323846;

enum class ends { periodic, values, slopes };

// q'' = -K q on [0, 1].
struct strings {
    MatrixXd K;
    template <class Y>
    void operator()(double, const Y& y, Y& f) const {
        const Eigen::Index n = K.rows();
        for (Eigen::Index i = 0; i < n; ++i) {
            f[i] = y[n + i];
            f[n + i] = y[0] * 0;
            for (Eigen::Index j = 0; j < n; ++j) f[n + i] = f[n + i] - K(i, j) * y[j];
        }
    }
};

template <class Method>
auto solve(const Method& method, const MatrixXd& K, ends kind, double tolerance, double size) {
    const Eigen::Index n = K.rows();
    const auto r = [=](const auto& a, const auto& b, auto& out) {
        for (Eigen::Index i = 0; i < n; ++i) {
            const Eigen::Index k = kind == ends::slopes ? n + i : i;
            out[i] = kind == ends::periodic ? a[i] - b[i] - size : a[k] - size;
            out[n + i] = kind == ends::periodic ? a[n + i] - b[n + i] : b[k] + size;
        }
    };
    return sc::solve_bvp(method, sc::two_point(strings{K}, r), 0.0, 1.0, VectorXd(VectorXd::Zero(2 * n)),
                         {.rtol = tolerance});
}

// Modes of which `resonant` fit the conditions, the others miss that by a part of half a wave, turned against each other.
struct family {
    MatrixXd K;
    ends kind;
    int kernel;
    family(std::mt19937& random, double nearest) : kind(static_cast<ends>(random() % 3)), kernel(0) {
        std::uniform_real_distribution<double> part(0, 1);
        const int n = 1 + static_cast<int>(random() % 3), resonant = static_cast<int>(random() % (n + 1));
        const double wave = kind == ends::periodic ? 2 * pi : pi;
        VectorXd squares(n);
        for (int i = 0; i < n; ++i) {
            const double off = i < resonant ? 0 : nearest + (0.5 - nearest) * part(random);
            squares[i] = std::pow(wave * (1 + static_cast<int>(random() % 3) + off), 2);
            if (i < resonant) kernel += kind == ends::periodic ? 2 : 1;
        }
        const MatrixXd any = MatrixXd::NullaryExpr(n, n, [&] { return part(random) - 0.5; });
        const MatrixXd Q = Eigen::HouseholderQR<MatrixXd>(any).householderQ();
        K = Q * squares.asDiagonal() * Q.transpose();
    }
};

template <class Method>
void count_kernels(const Method& method) {
    std::mt19937 random(5);
    int wrong = 0, singular = 0;
    for (int k = 0; k < 40; ++k) {
        const family f(random, k % 4 == 0 ? 0.003 : 0.2);
        const double tolerance = std::pow(10.0, -3 - k % 7);
        const auto r = solve(method, f.K, f.kind, tolerance, f.kernel > 0 ? 0 : 1);
        const bool right =
            f.kernel > 0 ? r.status == sc::bvp_status::not_isolated && r.kernel == f.kernel : r.ok();
        wrong += !right, singular += f.kernel > 1;
    }
    BOOST_TEST(wrong == 0);
    BOOST_TEST(singular > 10);
}

}  // namespace

// In directions of M that differ in what the errors of the mesh make of them.
BOOST_AUTO_TEST_CASE(the_dimension_of_the_kernel_counts_every_direction) {
    count_kernels(sc::gauss<3>());
    count_kernels(sc::gauss<5>());
    count_kernels(sc::lobatto_iiia<5>());
}

// A slow mode that nearly fits the conditions answers more to them than a fast one does that fits, as long as the mesh leaves
// of the fast one's phase what it likes.
BOOST_AUTO_TEST_CASE(a_mode_that_answers_more_hides_no_kernel) {
    for (const int waves : {3, 4, 6})
        for (const double near : {1e-3, 1e-4}) {
            const MatrixXd K =
                Eigen::Vector2d(std::pow(2 * pi * (1 + near), 2), std::pow(2 * pi * waves, 2)).asDiagonal();
            const auto r = solve(sc::gauss<3>(), K, ends::periodic, 1e-6, 0);
            BOOST_TEST(sc::name(r.status) == std::string("not_isolated"));
            BOOST_TEST(r.kernel == 2);
        }
}

// Cash's third problem, solution cos(pi t): where epsilon is small the layer's answer is of size 1/epsilon, and what a coarse
// mesh makes of it in the slow mode takes M nowhere near a singular one. Nothing is to be resolved there: ten intervals do, if
// those halved have the same condition number.
BOOST_AUTO_TEST_CASE(the_error_of_a_mode_that_answers_much_takes_the_others_to_no_kernel) {
    const auto ends = [](const auto& a, const auto& b, auto& r) { r[0] = a[0] + 1, r[1] = b[0] + 1; };
    struct run {
        double epsilon, tolerance;
        int intervals;
    };
    for (const run& of : {run{1e-4, 1e-7, 10}, run{1e-6, 1e-3, 10}, run{1e-6, 1e-5, 10}, run{1e-7, 1e-5, 10},
                          run{1e-8, 1e-4, 70}, run{1e-8, 1e-10, 100}}) {
        const auto f = [=](const auto& t, const auto& y, auto& out) {
            using std::cos;
            using std::sin;
            const auto slope = 2 + cos(pi * t);
            out[0] = y[1];
            out[1] =
                (y[0] - slope * y[1] - (1 + of.epsilon * pi * pi) * cos(pi * t) - slope * pi * sin(pi * t)) /
                of.epsilon;
        };
        const auto r = sc::solve_bvp(sc::gauss_variable(), sc::two_point(f, ends), -1.0, 1.0,
                                     Eigen::Vector2d(0, 0), {.rtol = of.tolerance});
        BOOST_TEST(sc::name(r.status) == std::string(of.tolerance < 1e-9 ? "ill_conditioned" : "success"));
        BOOST_TEST(r.report.intervals <= of.intervals);
        double worst = 0;
        for (int i = 0; i <= 200; ++i)
            worst = std::max(worst, std::abs(r.y(-1 + i / 100.0)[0] - std::cos(pi * (-1 + i / 100.0))));
        BOOST_TEST(worst < of.tolerance);
    }
}

// A pn junction in equilibrium: n and p are small beside 1 / lambda^2, and f is
// nonlinear in them alone. No iterate on the first mesh is taken for the solution of a singular problem, and however
// little a guess leads to, no mesh has more than max_intervals.
BOOST_AUTO_TEST_CASE(no_kernel_is_seen_before_a_mesh_resolves_the_iterate_and_max_intervals_is_kept) {
    const double ni = 1e-5, big = (1 + std::sqrt(1 + 4 * ni * ni)) / 2, small = ni * ni / big,
                 volts = std::log(big / ni);
    const auto contacts = [=](const auto& a, const auto& b, auto& r) {
        r[0] = a[2] - small, r[1] = a[3] - big, r[2] = a[0] + volts;
        r[3] = b[2] - big, r[4] = b[3] - small, r[5] = b[0] - volts;
    };
    const auto guess = [=](double t) {
        VectorXd y(6);
        y << volts * std::tanh(10 * t), 0, t > 0 ? 1 : 1e-10, t > 0 ? 1e-10 : 1, 0, 0;
        return y;
    };
    const auto solve = [&](double lambda2, int most) {
        const auto f = [=](const auto& t, const auto& y, auto& d) {
            using std::exp;
            const auto doping = 1 - 2 / (1 + exp(200 * t));
            d[0] = y[1], d[1] = (y[2] - y[3] - doping) / lambda2;
            d[2] = y[2] * y[1] + y[4], d[3] = -y[3] * y[1] - y[5];
            d[4] = 0 * y[4], d[5] = 0 * y[5];
        };
        return sc::solve_bvp(sc::gauss<5>(), sc::two_point(f, contacts), -1.0, 1.0, guess,
                             {.rtol = 1e-4, .max_intervals = most});
    };
    const auto r = solve(1e-4, 10000);
    BOOST_TEST(sc::name(r.status) == std::string("success"));
    BOOST_TEST(std::abs(r.y(0.0)[0]) < 1e-3);  // odd in t, and no current flows
    BOOST_TEST(r.y(0.3).tail(2).norm() < 1e-3);
    for (const int most : {20, 150, 1000}) {
        const auto rough = solve(1e-6, most);
        BOOST_TEST(rough.report.intervals <= most);
        BOOST_TEST(sc::name(rough.status) != std::string("singular"));
    }
}
