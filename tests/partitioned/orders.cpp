// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE partitioned_orders
// Every partitioned, separable and Nystrom method of tableaux/pairs runs at 50 digits with exactly the order that its
// certificate proves, on nonlinear problems that depend on time. Reference: Gauss methods of twelve stages.
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <functional>
#include <stagecraft/fixed_point.hpp>
#include <stagecraft/nystrom.hpp>
#include <stagecraft/partitioned.hpp>
#include <stagecraft/tableaux/read_method.hpp>
#include <stagecraft/tableaux/rounded.hpp>
#include <string>

using namespace stagecraft;
using fifty =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using state = Eigen::Matrix<fifty, 4, 1>;

namespace {

const std::string pairs = STAGECRAFT_SOURCE_DIR "/tableaux/pairs/";

template <class... X>
auto column(const X&... x) {
    using number = std::common_type_t<X...>;
    return Eigen::Matrix<number, sizeof...(X), 1>(x...);
}

const auto coupled = partition(
    [](const auto& t, const auto& q, const auto& p) {
        return column(p[0] * (1 + q[1] * q[1]) + t * q[0], p[1] + q[0] * p[0] * p[0]);
    },
    [](const auto& t, const auto& q, const auto& p) {
        return column(-q[0] * q[0] * p[1] - sin(t) * q[1], -q[1] + q[0] * p[0] * p[1]);
    });
const auto separated = partition(
    [](const auto& t, const auto& p) {
        return column(p[0] + p[1] * p[1] * p[1] + t * p[0], p[1] * (1 + p[0] * cos(t)));
    },
    [](const auto& t, const auto& q) {
        return column(-q[0] - q[0] * q[1] * q[1] + sin(t), -q[1] * (1 + t * q[0] * q[0]));
    });
const auto attracted = second_order([](const auto& t, const auto& q) {
    return column(-q[0] * (1 + q[1] * q[1]) + t * q[1], -q[1] * q[0] + cos(t));
});
const auto with_friction = second_order([](const auto& t, const auto& q, const auto& v) {
    return column(-q[0] * (1 + v[1] * v[1]) + t * q[1] - v[0], -q[1] * q[0] - v[1] * v[0] * q[0]);
});

const state start{fifty(7) / 10, fifty(-2) / 5, fifty(3) / 5, fifty(1) / 2};
const fifty end = fifty(1) / 2;

template <class Method, class Problem>
state run(const Method& m, const Problem& problem, int steps) {
    const fifty tiny("1e-45");
    const auto r =
        integrate(m, problem, start, 0, end, {.rtol = tiny, .atol = tiny, .fixed_step = end / steps});
    BOOST_TEST(name(r.status) == "success");
    return r.y;
}
// One type for all of them.
state reference(const std::function<void(const fifty&, const state&, state&)>& problem) {
    static const auto gauss = fixed_point(tableaux::rounded<fifty>(tableaux::family::gauss, 12));
    return run(gauss, problem, 40);
}

template <class Method, class Problem>
void has_order(const Method& m, const Problem& problem, int order, const std::string& what) {
    static const state exact = reference([&](const fifty& t, const state& y, state& f) { problem(t, y, f); });
    const state coarse = run(m, problem, 600) - exact, fine = run(m, problem, 1200) - exact;
    for (int i = 0; i < 4; ++i) {
        const double slope = static_cast<double>(fifty(log(abs(fifty(coarse[i] / fine[i]))) / log(fifty(2))));
        BOOST_TEST(std::abs(slope - order) < 0.05, what << ": component " << i << " has slope " << slope);
    }
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_file_runs_with_its_certified_order) {
    int partitioned = 0, separable = 0, nystrom = 0, embedded = 0;
    for (const auto& entry : std::filesystem::directory_iterator(pairs)) {
        const std::string path = entry.path().string(), what = entry.path().stem().string();
        const auto file = std::get<tableaux::partitioned_file>(tableaux::read_method_file(path));
        if (file.coupling == tableaux::coupling::additive) continue;
        const int order = file.claims.order.value();
        if (file.coupling == tableaux::coupling::nystrom) {
            ++nystrom;
            auto m = tableaux::read_nystrom<fifty>(path);
            if (file.uses_velocity) has_order(m, with_friction, order, what);
            has_order(m, attracted, order, what);
            if (!file.claims.embedded_order) continue;
            ++embedded;
            m.b_bar = m.b_bar_embedded, m.b = m.b_embedded;
            m.b_bar_embedded.resize(0), m.b_embedded.resize(0);
            has_order(m, attracted, *file.claims.embedded_order, what + ", embedded");
            continue;
        }
        const auto m = tableaux::read_partitioned<fifty>(path);
        has_order(m, separated, order, what);
        if (file.coupling == tableaux::coupling::partitioned) {
            ++partitioned;
            has_order(m, coupled, order, what);
        } else {
            ++separable;
        }
    }
    BOOST_TEST(partitioned == 4);
    BOOST_TEST(separable == 4);
    BOOST_TEST(nystrom == 7);
    BOOST_TEST(embedded == 4);
}
