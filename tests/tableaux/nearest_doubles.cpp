// SPDX-License-Identifier: BSL-1.0
// Every double of a tableau against an independent computation in 512-bit floating point: nodes by Newton's
// method with deflation on powers of x, b and A from the order conditions by elimination, A^-1 by
// elimination, eigenvalues and eigenvectors by Rayleigh quotient iteration, T^-1 by elimination.
#define BOOST_TEST_MODULE nearest_doubles
#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdint>
#include <stagecraft/tableaux/emit.hpp>
#include <stagecraft/tableaux/rounded.hpp>
#include <string>
#include <utility>
#include <vector>

using namespace stagecraft::tableaux;

namespace {

using wide = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<512, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

struct wide_complex {
    wide re = 0, im = 0;
    wide_complex() = default;
    wide_complex(wide r, wide i = 0) : re(std::move(r)), im(std::move(i)) {}  // NOLINT
    friend wide_complex operator+(const wide_complex& a, const wide_complex& b) {
        return {a.re + b.re, a.im + b.im};
    }
    friend wide_complex operator-(const wide_complex& a, const wide_complex& b) {
        return {a.re - b.re, a.im - b.im};
    }
    friend wide_complex operator*(const wide_complex& a, const wide_complex& b) {
        return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
    }
    friend wide_complex operator/(const wide_complex& a, const wide_complex& b) {
        const wide n = b.re * b.re + b.im * b.im;
        return {(a.re * b.re + a.im * b.im) / n, (a.im * b.re - a.re * b.im) / n};
    }
};
wide size(const wide& x) { return x < 0 ? wide(-x) : x; }
wide size(const wide_complex& z) { return size(z.re) + size(z.im); }

template <class K>
using dense = std::vector<std::vector<K>>;  // rows

/// X with m X = right, by elimination with row pivots.
template <class K>
dense<K> solved(dense<K> m, dense<K> right) {
    const std::size_t n = m.size();
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k + 1; i < n; ++i)
            if (size(m[i][k]) > size(m[pivot][k])) pivot = i;
        std::swap(m[k], m[pivot]);
        std::swap(right[k], right[pivot]);
        for (std::size_t i = 0; i < n; ++i) {
            if (i == k) continue;
            const K f = m[i][k] / m[k][k];
            for (std::size_t j = k; j < n; ++j) m[i][j] = m[i][j] - f * m[k][j];
            for (K& x : right[i]) x = x - f * right[k][static_cast<std::size_t>(&x - right[i].data())];
        }
    }
    for (std::size_t i = 0; i < n; ++i)
        for (K& x : right[i]) x = x / m[i][i];
    return right;
}

template <class K>
dense<K> transposed(const dense<K>& m) {
    dense<K> t(m[0].size(), std::vector<K>(m.size()));
    for (std::size_t i = 0; i < m.size(); ++i)
        for (std::size_t j = 0; j < m[0].size(); ++j) t[j][i] = m[i][j];
    return t;
}

template <class K>
dense<K> identity(std::size_t n) {
    dense<K> e(n, std::vector<K>(n, K(wide(0))));
    for (std::size_t i = 0; i < n; ++i) e[i][i] = K(wide(1));
    return e;
}

/// Rodrigues: d^n/dx^n of x^(n-a) (x-1)^(n-b) has the nodes as roots, next to the fixed end points.
std::vector<wide> nodes_of(family f, int s) {
    const std::string id(name(f));
    const bool left = id == "radau_ia" || id.rfind("lobatto", 0) == 0;
    const bool right = id == "radau_iia" || id.rfind("lobatto", 0) == 0;
    const int inner = s - (left ? 1 : 0) - (right ? 1 : 0);
    // inner nodes are the zeros of the Jacobi polynomial of degree `inner` for the weight x^left (1-x)^right
    std::vector<wide> a(static_cast<std::size_t>(2 * inner + 3), wide(0));  // x^(inner+l) (x-1)^(inner+r)
    const int l = left ? 1 : 0, r = right ? 1 : 0;
    wide binomial = 1;
    for (int j = 0; j <= inner + r; ++j) {
        a[static_cast<std::size_t>(inner + l + j)] = (inner + r - j) % 2 == 0 ? binomial : wide(-binomial);
        binomial = binomial * (inner + r - j) / (j + 1);
    }
    for (int k = 0; k < inner; ++k) {
        for (std::size_t j = 0; j + 1 < a.size(); ++j) a[j] = a[j + 1] * static_cast<int>(j + 1);
        a.pop_back();
    }
    std::vector<wide> c;
    if (left) c.push_back(0);
    if (right) c.push_back(1);
    for (int k = 0; k < inner; ++k) {  // x^l (x-1)^r times the Jacobi polynomial; found zeros deflated
        wide x = wide(1) / 1000;
        for (int step = 0; step < 400; ++step) {
            wide p = 0, slope = 0;
            for (auto j = a.size(); j-- > 0;) {
                slope = slope * x + p;
                p = p * x + a[j];
            }
            wide quotient = slope / p;
            for (const wide& found : c) quotient -= 1 / (x - found);
            const wide correction = 1 / quotient;
            x -= correction;
            if (size(correction) < ldexp(wide(1), -480)) break;
        }
        c.push_back(x);
    }
    std::sort(c.begin(), c.end());
    return c;
}

struct reference {
    std::vector<wide> c, b;
    dense<wide> A, A_inverse, T, T_inverse;
    std::vector<wide> gamma, alpha, beta;
};

wide power(const wide& x, int k) { return k == 0 ? wide(1) : wide(pow(x, k)); }

/// b from B(s), A from C(s), D(s), or C(s-1) and its first column: linear systems with Vandermonde's matrix.
reference basic(family f, int s) {
    reference t;
    t.c = nodes_of(f, s);
    const auto n = static_cast<std::size_t>(s);
    dense<wide> vandermonde(n, std::vector<wide>(n)), moments(n, std::vector<wide>(1));
    for (int k = 0; k < s; ++k) {
        for (std::size_t j = 0; j < n; ++j) vandermonde[static_cast<std::size_t>(k)][j] = power(t.c[j], k);
        moments[static_cast<std::size_t>(k)][0] = wide(1) / (k + 1);
    }
    for (const auto& row : solved(vandermonde, moments)) t.b.push_back(row[0]);
    dense<wide> right(n, std::vector<wide>(n));
    const auto rule = construction_of(f);
    for (int k = 0; k < s; ++k)
        for (std::size_t i = 0; i < n; ++i) {
            auto& entry = right[static_cast<std::size_t>(k)][i];
            if (rule == construction::adjoint)
                entry = t.b[i] * (1 - power(t.c[i], k + 1)) / (k + 1);
            else
                entry = power(t.c[i], k + 1) / (k + 1);
        }
    if (rule == construction::adjoint) {  // sum over i of b_i c_i^k a_ij
        for (auto& row : vandermonde)
            for (std::size_t i = 0; i < n; ++i) row[i] *= t.b[i];
        t.A = solved(vandermonde, right);
    } else {
        if (rule == construction::lobatto_iiic) {  // the last condition is replaced by a_i1 = b_1
            vandermonde.back().assign(n, wide(0));
            vandermonde.back()[0] = 1;
            right.back().assign(n, t.b[0]);
        }
        t.A = transposed(solved(vandermonde, right));
    }
    return t;
}

/// The eigenpair of m near lambda: (m - lambda) v = v by turns with the quotient from v's last component.
std::pair<wide_complex, std::vector<wide_complex>> eigenpair(const dense<wide>& m, wide_complex lambda) {
    const std::size_t n = m.size();
    const wide_complex off = wide_complex(ldexp(wide(1), -505));  // an exact eigenvalue is no pivot 0
    dense<wide_complex> v(n, std::vector<wide_complex>(1, wide_complex(wide(1))));
    for (int turn = 0; turn < 30; ++turn) {
        dense<wide_complex> shifted(n, std::vector<wide_complex>(n));
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j)
                shifted[i][j] = i == j ? wide_complex(m[i][j]) - lambda - off : wide_complex(m[i][j]);
        const auto w = solved(shifted, v);
        const wide_complex growth = w[n - 1][0] / v[n - 1][0];
        const wide_complex last = w[n - 1][0];
        for (std::size_t i = 0; i < n; ++i) v[i][0] = w[i][0] / last;
        lambda = lambda + off + wide_complex(wide(1)) / growth;
        if (size(wide_complex(wide(1)) / growth) < ldexp(wide(1), -400)) break;
    }
    std::vector<wide_complex> vector;
    for (const auto& row : v) vector.push_back(row[0]);
    return {lambda, vector};
}

/// The starts are the doubles under test moved by a relative 1e-4: where an iteration ends is an eigenvalue
/// of A^-1 whatever they are, and s different ones are all of them.
reference complete(family f, int s, const stagecraft::transformed_tableau<double>& start) {
    reference t = basic(f, s);
    const auto n = static_cast<std::size_t>(s);
    t.A_inverse = solved(t.A, identity<wide>(n));
    std::vector<std::pair<wide_complex, std::vector<wide_complex>>> real, upper;
    const auto add = [&](double re, double im) {
        auto pair = eigenpair(t.A_inverse, {wide(re * 1.0001), wide(im * 1.0001)});
        (size(pair.first.im) < ldexp(wide(1), -300) ? real : upper).push_back(std::move(pair));
    };
    for (const double gamma : start.gamma) add(gamma, 0);
    for (Eigen::Index k = 0; k < start.beta.size(); ++k) add(start.alpha(k), start.beta(k));
    std::sort(real.begin(), real.end(), [](auto& a, auto& b) { return a.first.re < b.first.re; });
    std::sort(upper.begin(), upper.end(), [](auto& a, auto& b) { return a.first.im < b.first.im; });
    t.T.assign(n, {});
    for (const auto& [lambda, v] : real) {
        t.gamma.push_back(lambda.re);
        for (std::size_t i = 0; i < n; ++i) t.T[i].push_back(v[i].re);
    }
    for (const auto& [lambda, v] : upper) {
        t.alpha.push_back(lambda.re);
        t.beta.push_back(lambda.im);
        for (std::size_t i = 0; i < n; ++i) {
            t.T[i].push_back(v[i].re);
            t.T[i].push_back(v[i].im);
        }
    }
    BOOST_REQUIRE_EQUAL(t.T[0].size(), n);
    for (std::size_t k = 1; k < t.gamma.size(); ++k) BOOST_REQUIRE(t.gamma[k] - t.gamma[k - 1] > 0.1);
    for (std::size_t k = 1; k < t.beta.size(); ++k) BOOST_REQUIRE(t.beta[k] - t.beta[k - 1] > 0.1);
    t.T_inverse = solved(t.T, identity<wide>(n));
    return t;
}

/// The reference as a double; what is below 2^-300 stands for an exact zero.
double as_double(const wide& x) { return size(x) < ldexp(wide(1), -300) ? 0.0 : static_cast<double>(x); }

struct comparison {
    int entries = 0;
    int different = 0;
    std::string first;

    void same(double x, const wide& y, const std::string& where) {
        ++entries;
        if (std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(as_double(y))) return;
        if (different++ == 0) first = where + ": " + hexadecimal(x) + " and " + hexadecimal(as_double(y));
    }
    template <class Vector>
    void vector(const Vector& x, const std::vector<wide>& y, const std::string& where) {
        BOOST_REQUIRE_EQUAL(static_cast<std::size_t>(x.size()), y.size());
        for (std::size_t i = 0; i < y.size(); ++i)
            same(x(static_cast<Eigen::Index>(i)), y[i], where + " " + std::to_string(i + 1));
    }
    template <class Matrix>
    void matrix(const Matrix& x, const dense<wide>& y, const std::string& where) {
        for (std::size_t i = 0; i < y.size(); ++i) vector(x.row(static_cast<Eigen::Index>(i)), y[i], where);
    }
};

constexpr int stages[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 20};

comparison compared(family f) {
    comparison all;
    for (const int s : stages) {
        if (s < least_stages(f)) continue;
        const std::string where = std::string(name(f)) + " " + std::to_string(s) + " ";
        const auto basics = [&](const auto& t, const reference& r) {
            all.vector(t.c, r.c, where + "c");
            all.vector(t.b, r.b, where + "b");
            all.matrix(t.A, r.A, where + "A");
        };
        if (!has_regular_matrix(f)) {
            basics(rounded<double>(f, s), basic(f, s));
            continue;
        }
        const auto t = transformed<double>(f, s);
        const reference r = complete(f, s, t);
        basics(t, r);
        all.matrix(t.A_inverse, r.A_inverse, where + "A^-1");
        all.vector(t.gamma, r.gamma, where + "gamma");
        all.vector(t.alpha, r.alpha, where + "alpha");
        all.vector(t.beta, r.beta, where + "beta");
        all.matrix(t.T, r.T, where + "T");
        all.matrix(t.T_inverse, r.T_inverse, where + "T^-1");
    }
    return all;
}

// sums over s = 1, ..., 12 and 20 of s and s^2: 98 and 1050
void expect_identical(family f, int entries) {
    const comparison all = compared(f);
    BOOST_TEST(all.entries == entries);
    BOOST_TEST(all.different == 0, all.different << " differ, the first one is " << all.first);
}

}  // namespace

BOOST_AUTO_TEST_CASE(gauss_is_identical_in_every_bit) { expect_identical(family::gauss, 3 * 98 + 4 * 1050); }
BOOST_AUTO_TEST_CASE(radau_iia_is_identical_in_every_bit) {
    expect_identical(family::radau_iia, 3 * 98 + 4 * 1050);
}
BOOST_AUTO_TEST_CASE(radau_ia_is_identical_in_every_bit) {
    expect_identical(family::radau_ia, 3 * 98 + 4 * 1050);
}
BOOST_AUTO_TEST_CASE(lobatto_iiia_is_identical_in_every_bit) {
    expect_identical(family::lobatto_iiia, 2 * 97 + 1049);
}
BOOST_AUTO_TEST_CASE(lobatto_iiib_is_identical_in_every_bit) {
    expect_identical(family::lobatto_iiib, 2 * 97 + 1049);
}
BOOST_AUTO_TEST_CASE(lobatto_iiic_is_identical_in_every_bit) {
    expect_identical(family::lobatto_iiic, 3 * 97 + 4 * 1049);
}

BOOST_AUTO_TEST_CASE(a_wrong_last_bit_or_sign_is_noticed) {
    const reference r = basic(family::gauss, 3);
    auto t = rounded<double>(family::gauss, 3);
    t.A(2, 1) = std::nextafter(t.A(2, 1), 1.0);
    comparison all;
    all.matrix(t.A, r.A, "A");
    BOOST_TEST(all.different == 1);
    t.A(2, 1) = std::nextafter(t.A(2, 1), 0.0);
    t.A(0, 1) = -t.A(0, 1);
    comparison sign;
    sign.matrix(t.A, r.A, "A");
    BOOST_TEST(sign.different == 1);
}
