// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE states
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <sstream>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/observe/progress.hpp>
#include <stagecraft/observe/table.hpp>
#include <stagecraft/states.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace sc = stagecraft;
using std::complex;

namespace {

const sc::options<double> o{.rtol = 1e-9, .atol = 1e-9};
const auto method = sc::radau_iia<3>();

}  // namespace

BOOST_AUTO_TEST_CASE(a_number_is_a_state) {
    const auto returned =
        sc::integrate(method, [](double, double y) { return -y; }, 1.0, 0, 2, {.rtol = 1e-10, .atol = 1e-10});
    const auto written = sc::integrate(
        method, [](auto, const auto& y, auto& f) { f = -y; }, 1.0, 0, 2, o);
    BOOST_TEST(std::abs(returned.y - std::exp(-2.0)) < 1e-9);
    BOOST_TEST(std::abs(written.y - std::exp(-2.0)) < 1e-9);
    BOOST_TEST((returned.report.found.jacobian == sc::jacobian_source::differences));
    BOOST_TEST((written.report.found.jacobian == sc::jacobian_source::automatic_differentiation));
    struct with_jacobian {
        double operator()(double, double y) const { return -y; }
        void jacobian(double, double, double& J) const { J = -1; }
    };
    const auto given = sc::integrate(method, with_jacobian{}, 1.0, 0, 2, o);
    BOOST_TEST(std::abs(given.y - std::exp(-2.0)) < 1e-9);
    BOOST_TEST((given.report.found.jacobian == sc::jacobian_source::member));
}

BOOST_AUTO_TEST_CASE(arrays_and_vectors_of_the_standard_library_are_states) {
    using pair = std::array<double, 2>;
    const auto turn = [](auto, const auto& y, auto& f) { f[0] = y[1], f[1] = -y[0]; };
    struct turning {
        bool grows;
        void operator()(double, const std::vector<double>& y, std::vector<double>& f) const {
            if (grows)
                f.assign(y.size() + 1, 1);
            else
                f = {y[1], -y[0]};
        }
    };
    std::vector<pair> seen;
    double middle = 0;
    const auto watch = [&](double t, const pair& y, double h, const auto& output) {
        seen.push_back(y);
        if (t - h < 0.5 && 0.5 <= t) middle = output(0.5)[0];
    };
    const auto a = sc::integrate(method, turn, pair{0, 1}, 0, 1, o, watch);
    const auto b = sc::integrate(method, turning{false}, std::vector<double>{0, 1}, 0, 1, o);
    const auto c = sc::integrate(method, turning{true}, std::vector<double>{0, 1}, 0, 1, o);
    BOOST_TEST(std::abs(a.y[0] - std::sin(1.0)) < 1e-8);
    BOOST_TEST(std::abs(b.y[1] - std::cos(1.0)) < 1e-8);
    BOOST_TEST((c.status == sc::status::size_changed));
    BOOST_TEST((a.report.found.jacobian == sc::jacobian_source::automatic_differentiation));
    BOOST_TEST(static_cast<long>(seen.size()) == a.report.steps);
    BOOST_TEST((seen.back() == a.y));
    BOOST_TEST(std::abs(middle - std::sin(0.5)) < 1e-6);
    const auto stopped =
        sc::integrate(method, turn, pair{0, 1}, 0, 1, o, [](double t, const pair&) { return t < 0.5; });
    BOOST_TEST((stopped.status == sc::status::stopped));
    double part = 0;
    sc::integrate(method, turn, pair{0, 1}, 0, 1, o, sc::progress([&](double p) { part = p; }));
    BOOST_TEST(part == 1);
}

BOOST_AUTO_TEST_CASE(complex_states_are_pairs_of_real_ones) {
    using namespace std::complex_literals;
    struct rotation {
        complex<double> rate = {-0.5, 3};
        complex<double> operator()(double, complex<double> y) const { return rate * y; }
        void jacobian(double, complex<double>, complex<double>& J) const { J = rate; }
    };
    const auto r = sc::integrate(method, rotation{}, complex<double>(1, 1), 0, 1, o);
    const complex<double> exact = std::exp(rotation{}.rate) * complex<double>(1, 1);
    BOOST_TEST(std::abs(r.y - exact) < 1e-8);
    BOOST_TEST(r.report.factorisations < r.report.steps + 2);
    // i psi' = [[1, 1/2], [1/2, -1]] psi; H^2 = 5/4, so psi = (cos wt - i H sin(wt)/w) psi_0.
    struct two_level {
        void operator()(double, const Eigen::Vector2cd& y, Eigen::Vector2cd& f) const {
            f << -1i * (y[0] + 0.5 * y[1]), -1i * (0.5 * y[0] - y[1]);
        }
        void jacobian(double, const Eigen::Vector2cd&, Eigen::Matrix2cd& J) const {
            J << -1i, -0.5i, -0.5i, 1i;
        }
    };
    const double w = std::sqrt(1.25), c = std::cos(3 * w), s = std::sin(3 * w) / w;
    const auto psi = sc::integrate(method, two_level{}, Eigen::Vector2cd(1, 0), 0, 3, o).y;
    BOOST_TEST(std::abs(psi[0] - (c - 1i * s)) < 1e-7);
    BOOST_TEST(std::abs(psi[1] + 0.5i * s) < 1e-7);
    // Not differentiable as a complex function: y' = -conj(y) takes the real part down and the imaginary part up.
    const auto mirror = [](double, const std::vector<complex<double>>& y) {
        return std::vector<complex<double>>{-std::conj(y[0])};
    };
    const auto z = sc::integrate(method, mirror, std::vector<complex<double>>{{1, 1}}, 0, 1, o).y[0];
    BOOST_TEST(std::abs(z - complex<double>(std::exp(-1.0), std::exp(1.0))) < 1e-8);
}

BOOST_AUTO_TEST_CASE(a_state_of_any_kind_is_written_as_a_table) {
    const auto last_of = [](const std::ostringstream& table) {
        std::string text = table.str();
        text.pop_back();
        return text.substr(text.rfind('\n') + 1);
    };
    const auto head_of = [](const std::ostringstream& table) {
        return table.str().substr(0, table.str().find('\n'));
    };
    const sc::options<double> o{.fixed_step = 0.25};
    double t = 0, x = 0, y = 0;
    char comma;
    std::ostringstream number, turn, several, by_hand, objects;
    const auto decay = [](double, double y) { return -y; };
    const double end = sc::integrate(sc::radau_iia<3>(), decay, 1.0, 0, 1, o, sc::csv(number, {"a"})).y;
    BOOST_TEST(head_of(number) == "t,a");
    std::istringstream(last_of(number)) >> t >> comma >> x;
    BOOST_TEST((t == 1 && x == end));
    // z' = i z: the real part first.
    using complex = std::complex<double>;
    const auto rotation = [](double, const complex& z) { return complex(0, 1) * z; };
    const complex z =
        sc::integrate(sc::radau_iia<3>(), rotation, complex(1, 0), 0, 1, o, sc::csv(turn, {"re", "im"})).y;
    BOOST_TEST(head_of(turn) == "t,re,im");
    std::istringstream(last_of(turn)) >> t >> comma >> x >> comma >> y;
    BOOST_TEST((t == 1 && x == z.real() && y == z.imag()));
    BOOST_TEST(std::abs(x - std::cos(1.0)) < 1e-6);
    const auto swing = [](double, const std::array<double, 2>& y) {
        return std::array<double, 2>{y[1], -y[0]};
    };
    sc::integrate(sc::radau_iia<3>(), swing, std::array<double, 2>{0, 1}, 0, 1, o, sc::csv(several));
    BOOST_TEST(head_of(several) == "t,y0,y1");
    auto row = sc::csv(by_hand);
    row(1, std::array<complex, 2>{complex(0.1, 2), complex(3, -4)});  // a t without digits costs y none
    BOOST_TEST(by_hand.str() == "t,y0,y1,y2,y3\n1,0.10000000000000001,2,3,-4\n");
    auto one_name = sc::csv(by_hand, {"z"});
    BOOST_CHECK_THROW(one_name(0.5, complex(1, 2)), std::invalid_argument);
    auto object = sc::json_lines(objects);
    object(0.5, std::numeric_limits<double>::infinity());
    object(1.5, 2.5);
    BOOST_TEST(objects.str() == "{\"t\": 0.5, \"y0\": null}\n{\"t\": 1.5, \"y0\": 2.5}\n");
}
