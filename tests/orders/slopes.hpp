// SPDX-License-Identifier: BSL-1.0
// Problems with known solutions at 50 digits, and what halving the step does to the error of a method.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/integrate.hpp>
#include <stagecraft/tableaux/exact_tableau.hpp>
#include <stagecraft/tableaux/rounded.hpp>
#include <vector>

namespace sc = stagecraft;
using sc::tableaux::family;
using enum sc::tableaux::family;
using fifty =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using vector = Eigen::Matrix<fifty, Eigen::Dynamic, 1>;

namespace {

enum class kind { ordinary, index_1, index_2, index_3, pendulum, perturbed };

// The pendulum of length 1 under gravity 1 at time t, released at rest from (1, 0): phi'' = -sin phi for the
// angle from the lowest point, by Taylor series with s = sin phi and c = cos phi.
inline vector swinging(const fifty& t) {
    constexpr int terms = 60;
    fifty phi = 2 * atan(fifty(1)), w = 0;
    const int steps = 8;
    for (int k = 0; k < steps; ++k) {
        std::vector<fifty> p(terms + 1), q(terms + 1), s(terms + 1), c(terms + 1);
        p[0] = phi, q[0] = w, s[0] = sin(phi), c[0] = cos(phi);
        for (int i = 0; i < terms; ++i) {
            p[i + 1] = q[i] / (i + 1);
            q[i + 1] = -s[i] / (i + 1);
            for (int j = 1; j <= i + 1; ++j) {
                s[i + 1] += j * p[j] * c[i + 1 - j] / (i + 1);
                c[i + 1] -= j * p[j] * s[i + 1 - j] / (i + 1);
            }
        }
        phi = w = 0;
        for (int i = terms; i >= 0; --i) {
            phi = phi * (t / steps) + p[i];
            w = w * (t / steps) + q[i];
        }
    }
    vector y(5);
    y << sin(phi), -cos(phi), w * cos(phi), w * sin(phi), w * w + cos(phi);
    return y;
}

// One type for all problems, so that the stepper is compiled once.
struct problem {
    kind which;
    fifty eps = 0;

    bool of_index_3() const { return which == kind::index_3 || which == kind::pendulum; }
    int size() const { return of_index_3() ? 5 : which == kind::index_2 ? 3 : 2; }
    int algebraic() const { return which == kind::ordinary || which == kind::perturbed ? 0 : 1; }

    void operator()(const fifty&, const vector& y, vector& f) const {
        if (which == kind::ordinary) {  // 1/(1+t), 1/(1+t)^2
            const fifty d = y[0] * y[0] - y[1];
            f[0] = -y[1] + d * (1 + y[0]);
            f[1] = -2 * y[0] * y[1] - d * y[1];
        } else if (which == kind::index_1 || which == kind::perturbed) {  // (1+2t)^{-1/2}, 1/(1+2t)
            const fifty d = y[0] * y[0] - y[1];
            f[0] = -y[0] * y[1] + d * (2 + y[0]);
            f[1] = d * (1 + y[1] * y[0]);
            if (which == kind::perturbed) f[1] = f[1] / eps - 2 * y[0] * y[0] * y[0] * y[0];
        } else if (which == kind::index_2) {  // exp t, exp -2t, exp 2t
            f[0] = y[0] * y[1] * y[1] * y[2] * y[2];
            f[1] = y[0] * y[0] * y[1] * y[1] - 3 * y[1] * y[1] * y[2];
            f[2] = y[0] * y[0] * y[1] - 1;
        } else if (which == kind::pendulum) {  // position, velocity, tension
            f[0] = y[2];
            f[1] = y[3];
            f[2] = -y[0] * y[4];
            f[3] = -y[1] * y[4] - 1;
            f[4] = (y[0] * y[0] + y[1] * y[1] - 1) / 2;
        } else {  // y1 = z1 = exp 2t, y2 = z2 = exp -t, u = exp t
            f[0] = 2 * y[0] * y[1] * y[2] * y[3];
            f[1] = -y[0] * y[1] * y[3] * y[3];
            f[2] = (y[0] * y[1] + y[2] * y[3]) * y[4];
            f[3] = -y[0] * y[1] * y[1] * y[3] * y[3] * y[4];
            f[4] = y[0] * y[1] * y[1] - 1;
        }
    }
    Eigen::DiagonalMatrix<fifty, Eigen::Dynamic> mass() const {
        Eigen::DiagonalMatrix<fifty, Eigen::Dynamic> m(size());
        for (int i = 0; i < size(); ++i) m.diagonal()[i] = i < size() - algebraic() ? 1 : 0;
        return m;
    }
    std::vector<int> index() const {
        if (which == kind::index_2) return {1, 1, 2};
        if (of_index_3()) return {1, 1, 2, 2, 3};
        return {1, 1};
    }
    vector exact(const fifty& t) const {
        vector y(size());
        if (which == kind::pendulum) return swinging(t + fifty(1) / 4);
        const fifty e = exp(t), r = 1 / (1 + t), z = 1 / (1 + 2 * t);
        if (which == kind::index_2)
            y << e, 1 / (e * e), e * e;
        else if (which == kind::index_3)
            y << e * e, 1 / e, e * e, 1 / e, e;
        else if (which == kind::ordinary)
            y << r, r * r;
        else
            y << sqrt(z), z;
        return y;
    }
};

// Error of every component after `steps` steps to t = 1/2.
template <class Method>
vector error(const Method& m, const problem& p, int steps) {
    const fifty tiny("1e-42"), end = fifty(1) / 2;
    const auto r =
        sc::integrate(m, p, p.exact(0), 0, end, {.rtol = tiny, .atol = tiny, .fixed_step = end / steps});
    BOOST_TEST(sc::name(r.status) == "success");
    return r.y - p.exact(end);
}

// log2 of the quotients, component by component.
std::vector<double> logarithms(const vector& coarse, const vector& fine) {
    std::vector<double> all;
    for (Eigen::Index i = 0; i < coarse.size(); ++i)
        all.push_back(static_cast<double>(fifty(log(abs(fifty(coarse[i] / fine[i]))) / log(fifty(2)))));
    return all;
}
template <class Method>
std::vector<double> slopes(const Method& m, const problem& p, int steps) {
    return logarithms(error(m, p, steps), error(m, p, 2 * steps));
}

struct member {
    family f;
    int s;
};

auto exact(const member& m) { return sc::tableaux::exact_tableau(m.f, m.s).value(); }
auto method(const member& m) { return sc::tableaux::transformed<fifty>(m.f, m.s); }

void is(double slope, int order) { BOOST_TEST(std::abs(slope - order) < 0.05, slope << " is not " << order); }

}  // namespace
