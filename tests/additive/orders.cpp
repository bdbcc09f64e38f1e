// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE orders
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <map>
#include <stagecraft/additive.hpp>
#include <stagecraft/tableaux/read_method.hpp>
#include <string>

// Every additive method of tableaux/pairs at 50 digits, on split problems with known solutions.

namespace sc = stagecraft;
using fifty =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using vector = Eigen::Matrix<fifty, Eigen::Dynamic, 1>;
using matrix = Eigen::Matrix<fifty, Eigen::Dynamic, Eigen::Dynamic>;
using method = sc::additive_method<fifty>;

namespace {

struct entry {
    method runs;
    int order, embedded;  // as certified
    bool ten_digits;      // more are not published
};

const std::map<std::string, entry>& methods() {
    static const auto all = [] {
        std::map<std::string, entry> found;
        for (const auto& file :
             std::filesystem::directory_iterator(STAGECRAFT_SOURCE_DIR "/tableaux/pairs")) {
            const auto path = file.path().string();
            const auto read = sc::tableaux::read_method_file(path);
            const auto& data = std::get<sc::tableaux::partitioned_file>(read);
            if (data.coupling != sc::tableaux::coupling::additive) continue;
            found.emplace(file.path().stem().string(),
                          entry{sc::tableaux::read_additive<fifty>(path), data.claims.order.value(),
                                data.claims.embedded_order.value_or(0), file.path().stem() == "ars_3_4_3"});
        }
        return found;
    }();
    return all;
}

// y = (1/(1+t), 1/(1+t)^2), and z = y_1 + y_2 as a third component, with or without derivative; both parts depend on t.
struct explicit_half {
    bool singular;
    void operator()(const fifty& t, const vector& y, vector& f) const {
        const fifty a = y[0] * y[0] - y[1], b = y[0] - y[1] * (1 + t);
        f[0] = -y[1] + a * (1 + y[0] + t) + t * y[1];
        f[1] = -y[0] * y[1] * 3 + b * (y[0] - y[2]) - y[1] * t;
        f[2] = singular ? fifty(0) : fifty(-y[1] + y[0] * y[1]);
    }
};
struct implicit_half {
    bool singular;
    void operator()(const fifty& t, const vector& y, vector& f) const {
        const fifty a = y[0] * y[0] - y[1], c = y[2] - y[0] - y[1];
        f[0] = a * y[1] - t * y[1] + c * y[0];
        f[1] = y[0] * y[1] + a * (t + y[2]) + y[1] * t;
        f[2] = singular ? fifty(c * (1 + y[0]) + a * t) : fifty(-3 * y[0] * y[1] - c * (2 + y[0]));
    }
    void jacobian(const fifty& t, const vector& y, matrix& J) const {
        const fifty a = y[0] * y[0] - y[1], c = y[2] - y[0] - y[1];
        J(0, 0) = 2 * y[0] * y[1] - y[0] + c;
        J(0, 1) = -y[1] + a - t - y[0];
        J(0, 2) = y[0];
        J(1, 0) = y[1] + 2 * y[0] * (t + y[2]);
        J(1, 1) = y[0] - (t + y[2]) + t;
        J(1, 2) = a;
        if (singular) {
            J(2, 0) = c - (1 + y[0]) + 2 * y[0] * t;
            J(2, 1) = -(1 + y[0]) - t;
            J(2, 2) = 1 + y[0];
        } else {
            J(2, 0) = -3 * y[1] - c + (2 + y[0]);
            J(2, 1) = -3 * y[0] + (2 + y[0]);
            J(2, 2) = -(2 + y[0]);
        }
    }
    matrix mass() const {
        matrix M(3, 3);
        M << 2, 0, 0, 0, 1, 0, 0, 0, singular ? 0 : 1;
        return M;
    }
};
// f_1 is for M = diag(2, 1, .): twice what y_1' is.
struct doubled {
    explicit_half half;
    void operator()(const fifty& t, const vector& y, vector& f) const {
        half(t, y, f);
        f[0] *= 2;
    }
};
struct doubled_implicit : implicit_half {
    void operator()(const fifty& t, const vector& y, vector& f) const {
        implicit_half::operator()(t, y, f);
        f[0] *= 2;
    }
    void jacobian(const fifty& t, const vector& y, matrix& J) const {
        implicit_half::jacobian(t, y, J);
        J.row(0) *= 2;
    }
};

vector exact(const fifty& t) {
    const fifty r = 1 / (1 + t);
    vector y(3);
    y << r, r * r, r + r * r;
    return y;
}

fifty error(const method& m, bool singular, int steps) {
    const fifty tiny("1e-40"), end = fifty(1) / 2;
    const auto r = sc::integrate(m, sc::split(doubled{{singular}}, doubled_implicit{{singular}}), exact(0), 0,
                                 end, {.rtol = tiny, .atol = tiny, .fixed_step = end / steps});
    BOOST_TEST(sc::name(r.status) == "success");
    BOOST_TEST(r.report.f == r.report.f_explicit + r.report.f_implicit);
    return (r.y - exact(end)).norm();
}

/// log2 of the quotient of the errors of n and of 2 n steps.
double slope(const method& m, bool singular, int steps) {
    return std::log2(static_cast<double>(fifty(error(m, singular, steps) / error(m, singular, 2 * steps))));
}
void is_slope(const entry& e, bool singular, int order) {
    const method& m = e.runs;
    if (e.ten_digits) {  // they end where the asymptotic behaviour begins: no less than the order before
        BOOST_TEST(slope(m, singular, 64) > order - 0.25);
        return;
    }
    double seen = 0;
    for (int steps = 16; steps <= 1024 && !(std::abs(seen - order) < 0.05); steps *= 4)
        seen = slope(m, singular, steps);
    BOOST_TEST(std::abs(seen - order) < 0.05, seen << " is not " << order);
}

}  // namespace

BOOST_AUTO_TEST_CASE(there_are_twenty_files_and_their_orders_are_found_again) {
    BOOST_TEST(methods().size() == 20U);
    int embedded = 0;
    for (const auto& [name, m] : methods()) BOOST_TEST_CONTEXT(name) {
            BOOST_TEST(m.runs.order == m.order);
            BOOST_TEST(m.runs.embedded_order == m.embedded);
            if (m.embedded > 0) ++embedded;
        }
    BOOST_TEST(embedded == 6);
}

BOOST_AUTO_TEST_CASE(equal_steps_show_the_certified_order_of_every_method) {
    for (const auto& [name, m] : methods()) BOOST_TEST_CONTEXT(name) is_slope(m, false, m.order);
}

BOOST_AUTO_TEST_CASE(and_of_its_embedded_method) {
    for (const auto& [name, m] : methods())
        if (m.embedded > 0) BOOST_TEST_CONTEXT(name) {
                auto e = m.runs.explicit_part, i = m.runs.implicit_part;
                e.b = e.b_embedded, i.b = i.b_embedded;
                e.b_embedded.resize(0), i.b_embedded.resize(0);
                is_slope({sc::additive(e, i), m.embedded, 0, false}, false, m.embedded);
            }
}

BOOST_AUTO_TEST_CASE(algebraic_equations_in_the_implicit_part_cost_no_order) {
    int served = 0;
    for (const auto& [name, m] : methods()) BOOST_TEST_CONTEXT(name) {
            if (m.runs.implicit_part.stiffly_accurate()) {
                is_slope(m, true, m.order);
                ++served;
            } else {
                BOOST_CHECK_EXCEPTION(error(m.runs, true, 1), std::invalid_argument, [](const auto& e) {
                    return std::string(e.what()).find("a last row equal to b") != std::string::npos;
                });
            }
        }
    BOOST_TEST(served == 15);
}
